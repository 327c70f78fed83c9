"""Surfaces cut open along a cut locus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

from . import _core
from ._input import Sources

PARAMETERIZATIONS = ("injective", "arap", "lscm", "convex", "logmap")


@dataclass(frozen=True, eq=False)
class Disk:
    """A surface cut open to a disk with one border loop. ``V, F, UV = disk`` takes the first three arrays."""

    vertices: npt.NDArray[np.float64]
    """(p, 3): the points; those on a seam come several times"""
    faces: npt.NDArray[np.int64]
    """(q, 3): the vertices of each triangle"""
    uv: Optional[npt.NDArray[np.float64]]
    """(p, 2): where each vertex is in the plane, counterclockwise, and, but for "logmap", of the area of the surface; or None"""
    vertex_origin: npt.NDArray[np.int64]
    """(p,): the vertex of the mesh that each is a copy of; -1 if it was added where the curve runs through faces"""
    face_origin: npt.NDArray[np.int64]
    """(q,): the face of the mesh that each is a part of"""

    def __iter__(self) -> Iterator[Any]:
        return iter((self.vertices, self.faces, self.uv))

    @property
    def is_flipped(self) -> npt.NDArray[np.bool_]:
        """(q,): whether each face is upside down in the plane."""
        if self.uv is None:
            raise _core.InvalidInput("the disk is not flat: it was cut open with parameterization=None")
        return ~(_signed_areas(self.uv, self.faces) > 0.)


def cut_open(vertices: npt.ArrayLike, faces: npt.ArrayLike, source: Sources, *,
             parameterization: Optional[str] = "injective", **parameters: Any) -> Disk:
    """Cuts a surface open along the cut locus of a point, to a disk, and flattens it.

    The disk has the component of the source alone. By default it asks for the curve of edges of the mesh, so that faces
    stay whole; with ``curve="faces"`` seams are straight, and the faces that they run through are split.

    Parameters
    ----------
    vertices, faces, source, **parameters
        As in `compute()`. There must be one source.
    parameterization : str or None
        "injective": as isometric as may be without flipped or overlapping faces; "arap": as rigid as possible; "lscm":
        conformal; "convex": in a circle, which never flips either; "logmap": distances and directions from the source as
        they are, with ``curve="faces"`` by default; None: no `uv`.

    Returns
    -------
    Disk
        ``V, F, UV = cut_open(...)``; it also names the vertices and faces that those of the disk come from.

    Raises
    ------
    InvalidInput
        As `compute()`.
    RuntimeError
        If the surface cannot be flattened.
    """
    from ._cut_locus import compute

    _check(parameterization)  # before what takes long
    if not parameters.get("number_of_iterations"):  # which is a way to ask for the other curve
        parameters.setdefault("curve", "faces" if parameterization == "logmap" else "edges")
    return compute(vertices, faces, source, **parameters).cut_open(parameterization=parameterization)


def disk_of(core: _core.Result, parameterization: Optional[str]) -> Disk:
    _check(parameterization)
    points, faces, plane, vertex_origin, face_origin = core.cut_open(parameterization)
    uv = None
    if parameterization is not None:
        uv = plane.copy() if parameterization == "logmap" else _with_area_of_surface(points, faces, plane)
        uv.flags.writeable = False
    return Disk(points, faces, uv, vertex_origin, face_origin)


def _check(parameterization: Optional[str]) -> None:
    if parameterization is not None and parameterization not in PARAMETERIZATIONS:
        names = ", ".join(repr(name) for name in PARAMETERIZATIONS)
        raise _core.InvalidInput(f"the parameterization must be one of {names} or None, and not {parameterization!r}")


def _signed_areas(plane: npt.NDArray[np.float64], faces: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
    p, q, r = (plane[faces[:, i]] for i in range(3))
    u, v = q - p, r - p
    areas: npt.NDArray[np.float64] = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    return areas


def _with_area_of_surface(points: npt.NDArray[np.float64], faces: npt.NDArray[np.int64],
                          plane: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    p, q, r = (points[faces[:, i]] for i in range(3))
    area = 0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1).sum()
    area_in_plane = _signed_areas(plane, faces).sum()
    scale = np.sqrt(area / abs(area_in_plane))
    result: npt.NDArray[np.float64] = plane * np.array([scale, scale if area_in_plane > 0. else -scale])
    return result
