"""Exact geodesic distances, shortest paths, and the logarithmic map."""

from __future__ import annotations

import math
from typing import List, NamedTuple, Optional, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core
from ._input import (Curves, Numbers, Source, Sources, read_curves, read_excluded, read_indices, read_mesh,
                     read_sources)

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Value = TypeVar("Value", bound=np.generic)


class Path(NamedTuple):
    """A shortest path from a target to its source: where it starts, crosses edges, meets vertices, and ends."""

    points: Floats
    """(k, 3): the points in space; none if no path leads from the target to a source"""
    faces: Ints
    """(k,): a face of the mesh that each point is in"""
    barycentric: Floats
    """(k, 3): the barycentric coordinates of each point in its face"""

    @property
    def length(self) -> float:
        """The length of the path; inf if there is none."""
        if len(self.points) == 0:
            return math.inf
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())


class Isoline(NamedTuple):
    """A polyline of points at the same distance; what is nearer to the sources is on its left, seen from outside."""

    level: float
    """The distance."""
    is_closed: bool
    """Whether it ends where it begins; else it leads from border to border."""
    points: Floats
    """(k, 3): the points in space"""
    faces: Ints
    """(k,): a face of the mesh that each point is in"""
    barycentric: Floats
    """(k, 3): the barycentric coordinates of each point in its face"""


class Places(NamedTuple):
    """Points of the surface."""

    points: Floats
    """(k, 3): the points in space"""
    faces: Ints
    """(k,): a face of the mesh that each point is in"""
    barycentric: Floats
    """(k, 3): the barycentric coordinates of each point in its face"""


class Found(NamedTuple):
    """What is known of points of the surface."""

    distance: Floats
    """(k,): to the nearest source; inf if a point is not reached"""
    nearest_source: Ints
    """(k,): its number; -1 if a point is not reached"""
    log_map: Optional[Floats]
    """(k, 2): where each point is in the tangent plane of its nearest source, see `log_map()`; None if no `directions`
    have been asked for"""


class ExactGeodesics:
    """Exact geodesic distances and paths on a mesh, from one set of sources after another.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike.
    excluded_faces : (m,) bools or (k,) whole numbers, optional
        Faces that no path may cross, by a bool for each face or by their numbers. The rim of an excluded region becomes
        border, and two regions that touch at a vertex leave no way between them. Vertices of excluded faces alone are
        not reached; sources and targets may not be there.
    """

    def __init__(self, vertices: npt.ArrayLike, faces: npt.ArrayLike, *,
                 excluded_faces: Optional[npt.ArrayLike] = None) -> None:
        self._core = _core.Geodesics(read_mesh(vertices, faces), read_excluded(excluded_faces, len(np.asarray(faces))))
        self._targets: List[Numbers] = []

    def compute(self, sources: Optional[Sources] = None, *, source_curves: Optional[Curves] = None,
                source_border: bool = False, targets: Optional[Sources] = None, error: float = 0.,
                maximum_distance: float = math.inf, directions: bool = False, isolines: bool = False) -> None:
        """Computes the distances from the sources, for the properties and functions below.

        Parameters
        ----------
        sources : int, (int, (3,) floats), or a sequence of them
            Vertices, or faces with barycentric coordinates. With several, the distance is the one to the nearest. With
            curves or the border there need not be one.
        source_curves : sequence of (k,) or (k, 2) whole numbers, optional
            Curves along edges of the mesh, which are sources too, numbered behind the points: of each one the vertices
            along it, or the pairs of vertices that its edges join. Each is connected. With curves or the border, there
            are neither `directions` nor an `error`.
        source_border : bool
            Whether each border loop is a source, behind all others.
        targets : as `sources`, optional
            Points to which distances or paths are wanted: where there are many, this is faster than `find()` or `path()`
            afterwards.
        error : float
            Distances may be too long by this times their length: it takes nearly linear time, but there are no paths.
        maximum_distance : float
            What is further away is not reached.
        directions : bool
            Whether `log_map` is wanted; takes some 10 % more time, and no `error`.
        isolines : bool
            Whether `isolines()` are wanted; takes 48 bytes for each window, and no `error`.

        Ctrl-C takes effect when this returns.
        """
        if sources is None and source_curves is None and not source_border:
            raise TypeError("there must be sources, source_curves or the source_border")
        numbers, _ = read_sources([] if sources is None else sources)
        wanted = [] if targets is None else read_sources(targets)[0]
        self._targets = []
        self._core.compute(numbers, read_curves(source_curves), bool(source_border),
                           [t for t in wanted if not isinstance(t, int)], error, maximum_distance, directions,
                           isolines)
        self._targets = wanted

    @property
    def distance(self) -> Floats:
        """(n,): the distance of each vertex to the nearest source; inf if it is not reached. A new array each time."""
        return self._core.distances()

    @property
    def distance_error(self) -> Floats:
        """(n,): how much longer than the exact distance each may be; zero without `error`."""
        return self._core.errors()

    @property
    def nearest_source(self) -> Ints:
        """(n,): the number of the source nearest to each vertex; -1 if it is not reached."""
        return self._core.nearest_sources()

    @property
    def target_distance(self) -> Floats:
        """(number of targets,): the distance of each target to the nearest source."""
        return self._of_targets(self.distance, self._core.target_distances())

    @property
    def target_nearest_source(self) -> Ints:
        """(number of targets,): the number of the source nearest to each target; -1 if it is not reached."""
        return self._of_targets(self.nearest_source, self._core.target_nearest_sources())

    @property
    def log_map(self) -> Floats:
        """(n, 2): where each vertex is in the tangent plane of its nearest source; see `log_map()`."""
        return self._core.log_map()

    @property
    def target_log_map(self) -> Floats:
        """(number of targets, 2): the same for each target."""
        return self._of_targets(self.log_map, self._core.target_log_map())

    @property
    def source_axes(self) -> Ints:
        """(number of sources, 2): the vertices of an edge that the x-axis of `log_map` runs along, from the first to
        the second; y is to its left."""
        return self._core.source_axes()

    @property
    def arrival_direction(self) -> Floats:
        """(n, 3): the unit vector in which the shortest path to each vertex leads back to its source, along a face at the
        vertex; nan for sources and what is not reached. Not with an `error`."""
        return self._core.arrival_directions()

    def _of_targets(self, at_vertices: npt.NDArray[Value], at_locations: npt.NDArray[Value]) -> npt.NDArray[Value]:
        located = iter(at_locations)
        values = [at_vertices[t] if isinstance(t, int) else next(located) for t in self._targets]
        return np.array(values, at_vertices.dtype).reshape(-1, *at_vertices.shape[1:])

    def isolines(self, levels: npt.ArrayLike, *, maximum_deviation: Optional[float] = None) -> List[Isoline]:
        """The isolines of some distances, level by level; see `isolines()`."""
        numbers = np.asarray(levels, np.float64).ravel().tolist()
        return [Isoline(*line) for line in self._core.isolines(numbers, maximum_deviation)]

    def exp_map(self, places: npt.ArrayLike, source: int = 0) -> Places:
        """Where straight walks from a source end, whose directions and lengths are those of (k, 2) places in its tangent
        plane: the inverse of `log_map` as far as shortest paths go, and beyond. `directions` need not be asked for."""
        return Places(*self._core.exponential_map(np.asarray(places), source))

    def find(self, faces: npt.ArrayLike, barycentric: npt.ArrayLike) -> Found:
        """Distances, nearest sources and places of any points, which need not have been `targets`.

        For each, the shortest path is looked for by the distances of the vertices. Thousands of points are found faster as
        `targets`.

        Parameters
        ----------
        faces : (k,) whole numbers
            A face that each point is in.
        barycentric : (k, 3) real numbers
            Its barycentric coordinates there.
        """
        return Found(*self._core.find(read_indices(faces, "faces"), np.asarray(barycentric)))

    def path(self, target: Source) -> Path:
        """The shortest path to its source from a vertex, or from a face with barycentric coordinates, which need not have
        been a target."""
        numbers, are_many = read_sources(target)
        if are_many:
            raise TypeError(f"a path has one target, and not {target!r}")
        return Path(*self._core.path_from(numbers[0]))

    def paths(self) -> List[Path]:
        """The shortest path from each target to its source."""
        result = []
        located = 0
        for target in self._targets:
            if isinstance(target, int):
                result.append(self.path(target))
            else:
                result.append(Path(*self._core.path_from_target(located)))
                located += 1
        return result


def exact_geodesic_distances(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Optional[Sources] = None, *,
                             source_curves: Optional[Curves] = None, source_border: bool = False, error: float = 0.,
                             maximum_distance: float = math.inf,
                             excluded_faces: Optional[npt.ArrayLike] = None) -> Floats:
    """Computes the exact geodesic distance of each vertex to the nearest of the sources.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike.
    sources : int, (int, (3,) floats), or a sequence of them
        Vertices, or faces with barycentric coordinates.
    source_curves, source_border
        As in `ExactGeodesics.compute()`: sources that are curves along edges, and the border.
    error : float
        Distances may be too long by this times their length, which takes nearly linear time; 0: exact.
    maximum_distance : float
        What is further away is not reached.
    excluded_faces
        As in `ExactGeodesics`: faces that no path may cross.

    Returns
    -------
    (n,) float64
        In the unit of the points; inf for vertices that are not reached.
    """
    geodesics = ExactGeodesics(vertices, faces, excluded_faces=excluded_faces)
    geodesics.compute(sources, source_curves=source_curves, source_border=source_border, error=error,
                      maximum_distance=maximum_distance)
    return geodesics.distance


def log_map(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Sources, *,
            maximum_distance: float = math.inf, excluded_faces: Optional[npt.ArrayLike] = None) -> Floats:
    """Computes the logarithmic map: where each vertex is as seen from its source, exact on the polyhedron.

    That is the distance times the direction in which the shortest path leaves the source, in the tangent plane there.
    Around a source that is not on the border, angles are scaled to add up to 2 pi; on the border they are not scaled.
    The x-axis runs along an edge: for a source at a vertex the edge that leaves it in the first face that has it, or, on
    the border, the one with the border on its right; on an edge that edge; in a face from its first vertex to its
    second. `ExactGeodesics.source_axes` tells it, and `ExactGeodesics.nearest_source` which source of several it is.

    Parameters
    ----------
    vertices, faces, sources, maximum_distance, excluded_faces
        As in `exact_geodesic_distances()`.

    Returns
    -------
    (n, 2) float64
        In the unit of the points, counterclockwise seen from outside; zero for sources, nan for vertices that are not
        reached.
    """
    geodesics = ExactGeodesics(vertices, faces, excluded_faces=excluded_faces)
    geodesics.compute(sources, maximum_distance=maximum_distance, directions=True)
    return geodesics.log_map


def exp_map(vertices: npt.ArrayLike, faces: npt.ArrayLike, source: Sources, places: npt.ArrayLike, *,
            excluded_faces: Optional[npt.ArrayLike] = None) -> Places:
    """Computes the exponential map: where straight walks from a source end.

    It is the inverse of `log_map()`, with the same axes, where shortest paths do not bend; behind the cut locus it goes
    on. Walks end at the border.

    Parameters
    ----------
    vertices, faces, excluded_faces
        As in `exact_geodesic_distances()`.
    source : int, or (int, (3,) floats)
        A vertex, or a face with barycentric coordinates.
    places : (k, 2) real numbers
        The ends of the walks in the tangent plane of the source, in the unit of the points.

    Returns
    -------
    Places
        The points where the walks end, with the face of each and its barycentric coordinates there.
    """
    geodesics = ExactGeodesics(vertices, faces, excluded_faces=excluded_faces)
    geodesics.compute(source, maximum_distance=0.)
    return geodesics.exp_map(places)


def isolines(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Optional[Sources], levels: npt.ArrayLike, *,
             source_curves: Optional[Curves] = None, source_border: bool = False,
             maximum_deviation: Optional[float] = None,
             excluded_faces: Optional[npt.ArrayLike] = None) -> List[Isoline]:
    """Computes isolines of the exact distance, as polylines through the faces.

    Their points have the distance of their level exactly, up to rounding. Between them they are chords of circular arcs, or
    parallel to an edge of a curve. What is beyond the largest level is not
    computed.

    Parameters
    ----------
    vertices, faces, sources, source_curves, source_border, excluded_faces
        As in `exact_geodesic_distances()`.
    levels : (l,) real numbers
        The distances, positive.
    maximum_deviation : float, optional
        How far chords may be from their arcs, in the unit of the points. Default: a thousandth of the mean edge length.

    Returns
    -------
    list of Isoline
        Level by level. On a closed surface, all of them are closed.
    """
    geodesics = ExactGeodesics(vertices, faces, excluded_faces=excluded_faces)
    largest = np.max(np.asarray(levels, np.float64), initial=0.)
    geodesics.compute(sources, source_curves=source_curves, source_border=source_border, isolines=True,
                      maximum_distance=largest if largest >= 0. else math.inf)  # what is no number is refused below
    return geodesics.isolines(levels, maximum_deviation=maximum_deviation)


def shortest_paths(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Optional[Sources], targets: Sources, *,
                   source_curves: Optional[Curves] = None, source_border: bool = False,
                   maximum_distance: float = math.inf,
                   excluded_faces: Optional[npt.ArrayLike] = None) -> List[Path]:
    """Computes the shortest path from each target to the nearest of the sources.

    Parameters
    ----------
    vertices, faces, sources, source_curves, source_border, maximum_distance, excluded_faces
        As in `exact_geodesic_distances()`.
    targets : int, (int, (3,) floats), or a sequence of them
        Where the paths start.

    Returns
    -------
    list of Path
        One for each target, from it to its source.
    """
    geodesics = ExactGeodesics(vertices, faces, excluded_faces=excluded_faces)
    geodesics.compute(sources, source_curves=source_curves, source_border=source_border, targets=targets,
                      maximum_distance=maximum_distance)
    return geodesics.paths()
