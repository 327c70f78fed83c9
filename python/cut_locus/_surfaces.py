"""Surfaces that need no cut locus: disks in the plane, unfoldings, and refinement along polylines."""

from __future__ import annotations

from typing import List, NamedTuple, Protocol, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from ._input import Source, read_disk, read_mesh, read_sources

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


class LayoutQuality(NamedTuple):
    """How well a disk lies in the plane. Distortions are means over the area of the surface, with 1 as their least value."""

    flipped_faces: int
    """The faces that are upside down, or have no area."""
    is_injective: bool
    """Whether no face is flipped, and no two overlap."""
    overlapping_faces: int
    """The faces that have others over or under them."""
    overlap: float
    """The part of the covered plane that several faces cover."""
    area_distortion: float
    """Of (s + 1/s) / 2, where s is the ratio of the areas of a face in the plane and in space."""
    angle_distortion: float
    """The same of the ratio of the largest and the least stretch; infinite if a face has no area in the plane."""
    symmetric_dirichlet_energy: float
    """Of (s^2 + t^2 + 1/s^2 + 1/t^2) / 4, of both stretches; infinite if a face is flipped."""
    faces_without_shape: int
    """The faces that are too thin to say how they should lie."""


class Unfolding(NamedTuple):
    """The source unfolding of a polyhedron: a polygon, and how its edges are glued to get the polyhedron back."""

    corners: Floats
    """(k, 2): counterclockwise, with the source at the origin"""
    glued_to: Ints
    """(k,): the edge, by the corner it starts at, that the edge from each corner to the next is glued to; -1 on the border"""
    points: Floats
    """(k, 3): the point of the surface that each corner is a copy of"""
    fold_lines: Floats
    """(l, 2, 2): both ends of the edges of the mesh inside of the polygon, in parts"""
    is_source_moved: bool
    """Whether the source had to be moved a little."""


class Refined(NamedTuple):
    """A surface with faces split so that curves run along its edges."""

    vertices: Floats
    """(p, 3): the points"""
    faces: Ints
    """(q, 3): the vertices of each triangle"""
    curves: List[Ints]
    """(e, 2): the vertices that the edges of each curve join, as `source_curves` takes them; what is connected is one curve"""
    vertex_origin: Ints
    """(p,): the vertex of the mesh that each is; -1 if it was added"""
    face_origin: Ints
    """(q,): the face of the mesh that each is a part of"""


class Polyline(Protocol):
    """What has faces and barycentric coordinates, as `Path` and `Isoline`."""

    @property
    def faces(self) -> Ints: ...

    @property
    def barycentric(self) -> Floats: ...


def flatten_disk(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> Floats:
    """Lays a disk flat, as isometric as may be, with no flipped or overlapping faces.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle of a disk, as `Disk` has them.

    Returns
    -------
    (n, 2) float64
        The place of each vertex in the plane.
    """
    return _core.flatten_disk(read_disk(vertices, faces))


def layout_quality(vertices: npt.ArrayLike, faces: npt.ArrayLike, uv: npt.ArrayLike) -> LayoutQuality:
    """Measures how well a disk lies in the plane: flips and overlaps exactly, and distortions.

    Parameters
    ----------
    vertices, faces
        Those of a disk: `layout_quality(*cut_open(...))`.
    uv : (n, 2) real numbers
        The place of each vertex in the plane.
    """
    return LayoutQuality(*_core.layout_quality(read_disk(vertices, faces), np.asarray(uv)))


def source_unfolding(vertices: npt.ArrayLike, faces: npt.ArrayLike, source: Source) -> Unfolding:
    """Cuts a polyhedron along the cut locus of a source, and lays it flat around the source: a star-shaped polygon.

    Shortest paths must not bend: that is so on convex polyhedra, and on what is isometric to them.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike.
    source : int, or (int, (3,) floats)
        A vertex, or a face with barycentric coordinates.
    """
    numbers, is_sequence = read_sources(source)
    if is_sequence:
        raise _core.InvalidInput("a polyhedron is unfolded from one source, and not from a sequence of them")
    return Unfolding(*_core.source_unfolding(read_mesh(vertices, faces), numbers[0]))


def refine_along_polylines(vertices: npt.ArrayLike, faces: npt.ArrayLike, polylines: Sequence[Polyline]) -> Refined:
    """Splits the faces that polylines run through, so that these consist of edges, and can be `source_curves`.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike.
    polylines : sequence of `Path`, `Isoline`, or what has their attributes
        Two points that follow each other must have a face in common. Their barycentric coordinates are rounded to
        multiples of 1/256, so that no face is degenerate.
    """
    numbers = [[(int(f), (float(c[0]), float(c[1]), float(c[2]))) for f, c in zip(line.faces, line.barycentric)]
               for line in polylines]
    return Refined(*_core.refine_along_polylines(read_mesh(vertices, faces), numbers))
