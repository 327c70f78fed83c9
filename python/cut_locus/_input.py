"""What users pass, in the form that the C++ part takes."""

from __future__ import annotations

import operator
import warnings
from typing import Any, Dict, List, Optional, Sequence, SupportsIndex, Tuple, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _core

Location = Tuple[SupportsIndex, Union[Sequence[float], npt.NDArray[Any]]]
Source = Union[SupportsIndex, Location]
Sources = Union[Source, Sequence[Source], npt.NDArray[np.integer[Any]]]

Path = Union[Sequence[SupportsIndex], npt.NDArray[np.integer[Any]]]
Edges = Union[Sequence[Sequence[SupportsIndex]], npt.NDArray[np.integer[Any]]]
Curves = Sequence[Union[Path, Edges]]

Numbers = Union[int, Tuple[int, Tuple[float, float, float]]]
Name = TypeVar("Name")


def weld(vertices: npt.ArrayLike, faces: npt.ArrayLike
         ) -> Tuple[npt.NDArray[np.float64], npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    """Make one surface of faces that belong together, as the program does with files.

    Files repeat vertices for each face, at hard edges and along the seams of textures. Border edges that lie on each
    other, up to 1e-7 of the diagonal, are joined; faces are turned so that neighbors agree; faces that are there twice,
    or have a vertex twice, and vertices without a face are left out.

    Returns the vertices, the faces, and for each vertex that was given its new number, or -1 if it has none: what is
    known of the welded vertices, as `result.vertex_distance`, is known of the given ones by `[number]`.
    """
    return _core.weld(*_arrays(vertices, faces))


def mesh_arrays(mesh: Any) -> Tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    """The vertices and the triangles of a mesh of another package: `cut_locus.compute(*cut_locus.mesh_arrays(mesh), 0)`.

    It takes what has `vertices` and `faces`, as trimesh's meshes, or `vertices` and `triangles`, as Open3D's; `points` and
    `cells_dict`, as meshio's; or `points` and `faces` in one array, each with the number of its vertices before it, as
    PyVista's. Faces that are no triangles are refused.
    """
    if hasattr(mesh, "vertices"):
        for name in ("faces", "triangles"):
            if hasattr(mesh, name):
                return np.asarray(mesh.vertices), np.asarray(getattr(mesh, name))
    if hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        if "triangle" not in mesh.cells_dict:
            kinds = ", ".join(mesh.cells_dict) or "none"
            raise _core.InvalidInput(f"the mesh has no triangles: its cells are {kinds}")
        return np.asarray(mesh.points), np.asarray(mesh.cells_dict["triangle"])
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):
        faces = np.asarray(mesh.faces)
        if faces.ndim == 1:
            if len(faces) % 4 != 0 or np.any(faces[::4] != 3):
                raise _core.InvalidInput("the mesh has faces that are no triangles: mesh.triangulate() divides them")
            faces = faces.reshape(-1, 4)[:, 1:]
        return np.asarray(mesh.points), faces
    raise TypeError("a mesh must have vertices and faces, vertices and triangles, points and cells_dict, or points and "
                    f"faces: {type(mesh).__name__} has none of these pairs")


def read_disk(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> _core.Mesh:
    """A surface that is meant to be cut open where vertices lie at the places of others."""
    return _core.Mesh(*_arrays(vertices, faces))


def read_mesh(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> _core.Mesh:
    mesh = read_disk(vertices, faces)
    count = mesh.number_of_weldable_vertices
    if count > 0:
        warnings.warn(f"{count} vertices on borders lie at the places of others: the surface is cut open there. "
                      "vertices, faces, number = cut_locus.weld(vertices, faces) joins them", stacklevel=4)
    return mesh


def _arrays(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> Tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    faces = np.asarray(faces)
    if faces.size == 0 and faces.dtype == np.float64:  # NumPy's type for an empty list
        faces = faces.astype(np.int64)
    return np.asarray(vertices), faces


def read_curves(curves: Optional[Curves]) -> List[List[Tuple[int, int]]]:
    """The pairs of vertices that the edges of each curve join."""
    return [_ends_of_edges(number, curve) for number, curve in enumerate([] if curves is None else curves)]


def _ends_of_edges(number: int, curve: Any) -> List[Tuple[int, int]]:
    array = np.asarray(curve)
    if array.dtype.kind in "iu":
        if array.ndim == 1:
            return [(int(v), int(w)) for v, w in zip(array[:-1], array[1:])]
        if array.ndim == 2 and array.shape[1] == 2:
            return [(int(v), int(w)) for v, w in array]
    elif array.size == 0:
        return []
    raise TypeError(f"source curve {number} must be the vertices along a path of edges, or the pairs of vertices that "
                    f"its edges join, and not {curve!r}")


def read_indices(numbers: npt.ArrayLike, name: str) -> List[int]:
    """A one-dimensional array of whole numbers."""
    array = np.asarray(numbers)
    if array.ndim != 1 or (array.dtype.kind not in "iu" and array.size > 0):
        raise TypeError(f"{name} must be whole numbers, and not {numbers!r}")
    return list(array.tolist())


def read_excluded(excluded_faces: Optional[npt.ArrayLike], number_of_faces: int) -> List[bool]:
    """Whether each face is excluded; nothing if none is named."""
    if excluded_faces is None:
        return []
    array = np.asarray(excluded_faces)
    excluded = np.zeros(number_of_faces, bool)
    if array.dtype.kind == "b":
        if array.shape != (number_of_faces,):
            raise _core.InvalidInput(f"excluded_faces must have one bool for each of the {number_of_faces} faces, and not "
                                     f"the shape {array.shape}")
        return list(array.tolist())
    if array.ndim != 1 or (array.dtype.kind not in "iu" and array.size > 0):
        raise TypeError("excluded_faces must be the numbers of faces, or one bool for each face, and not "
                        f"{excluded_faces!r}")
    outside = array[(array < 0) | (array >= number_of_faces)]
    if outside.size > 0:
        raise _core.InvalidInput(f"excluded_faces has the number {outside[0]}, but faces have the numbers 0 to "
                                 f"{number_of_faces - 1}")
    excluded[array.astype(np.int64)] = True
    return list(excluded.tolist())


def read_sources(sources: Sources) -> Tuple[List[Numbers], bool]:
    """The numbers of the sources, and whether they are a sequence."""
    source = _numbers_of_one(sources)
    if source is not None:
        return [source], False
    result = []
    for number, item in enumerate(_items_of(sources)):
        source = _numbers_of_one(item)
        if source is None:
            raise TypeError(f"source {number} must be a vertex index or a pair of a face index and three barycentric "
                            f"coordinates, and not {item!r}")
        result.append(source)
    return result, True


def method_of(name: Optional[str]) -> Any:
    """The method that has a name, which may be its old one."""
    if name == "direction":
        warnings.warn('the method "direction" is called "default" now', DeprecationWarning, stacklevel=3)
        name = "default"
    return value_of(_core.Method, name, "method")


def value_of(enum: Any, name: Optional[str], parameter: str) -> Any:
    """The value of an enumeration that has a name."""
    if name is None:
        return None
    members: Dict[str, Any] = enum.__members__
    if name not in members:
        names = ", ".join(repr(member) for member in members)
        raise _core.InvalidInput(f"the {parameter} must be one of {names}, and not {name!r}")
    return members[name]


def _numbers_of_one(source: Any) -> Optional[Numbers]:
    if _is_index(source):
        return operator.index(source)
    if not isinstance(source, (tuple, list)) or len(source) != 2 or not _is_index(source[0]):
        return None
    try:
        a, b, c = source[1]
        return operator.index(source[0]), (float(a), float(b), float(c))
    except (TypeError, ValueError):
        return None


def _is_index(source: Any) -> bool:
    if isinstance(source, (bool, np.bool_)):
        return False
    try:
        operator.index(source)
    except TypeError:
        return False
    return True


def _items_of(sources: Any) -> Sequence[Any]:
    if not isinstance(sources, (str, bytes, dict)):
        try:
            return list(sources)
        except TypeError:
            pass
    raise TypeError("the source must be a vertex index, a pair of a face index and three barycentric coordinates, or a "
                    f"sequence of them, and not {sources!r}")
