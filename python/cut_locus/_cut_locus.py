"""The cut locus of a point, of several points, or of curves."""

from __future__ import annotations

from functools import cached_property
from os import PathLike, fspath
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._disk import Disk, disk_of
from ._input import Curves, Sources, method_of, read_curves, read_mesh, read_sources, value_of

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Bools = npt.NDArray[np.bool_]
Progress = Callable[[str, bool], Any]

_EXTENSIONS = (".polylines.txt", ".obj", ".ply", ".vtp")


class Cells(NamedTuple):
    """A surface divided into the cells of several sources."""

    vertices: Floats
    """(p, 3): the points"""
    faces: Ints
    """(q, 3): the vertices of each triangle"""
    source: Ints
    """(q,): the number of the source whose cell each face is in; -1 where no path leads from one"""
    vertex_origin: Ints
    """(p,): the vertex of the mesh that each is; -1 if it was added where the curve runs through faces"""
    face_origin: Ints
    """(q,): the face of the mesh that each is a part of"""


class Result:
    """The cut locus: a graph on the mesh, and the distances to the source, or to the nearest of several.

    Its n points and m edges are arrays, made when they are first asked for. It does not change, and it keeps the mesh.
    """

    def __init__(self, core: _core.Result, method: str, has_edge_lengths: bool) -> None:
        self._core = core
        self._method = method
        self._has_edge_lengths = has_edge_lengths

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_core": _Saved(self._core)}

    def __repr__(self) -> str:
        return (f"<cut_locus.Result: {len(self.points)} points, {len(self.edges)} edges, {self.cycles} cycles, "
                f"injectivity radius {self.injectivity_radius:.6g}>")

    @property
    def method(self) -> str:
        """The method in force: "default", "polyhedral" or "laplacian"."""
        return self._method

    # -- the points of the graph

    @cached_property
    def points(self) -> Floats:
        """(n, 3): the points in space."""
        return self._core.points()

    @cached_property
    def faces(self) -> Ints:
        """(n,): a face of the mesh that each point is in, or on the border of."""
        return self._core.faces()

    @cached_property
    def barycentric(self) -> Floats:
        """(n, 3): the barycentric coordinates of each point in its face, in the order of the face's vertices."""
        return self._core.barycentric()

    @cached_property
    def mesh_vertices(self) -> Ints:
        """(n,): the vertex of the mesh that each point is at, or -1."""
        return self._core.mesh_vertices()

    @cached_property
    def distance(self) -> Floats:
        """(n,): the distance of each point to the source, or to the nearest one."""
        return self._core.distances()

    # -- its edges

    @cached_property
    def edges(self) -> Ints:
        """(m, 2): the points that each edge joins."""
        return self._core.edges()

    @cached_property
    def strength(self) -> Floats:
        """(m,): the largest angle, in radians, on the branch from the edge to its tips.

        It is that between the two shortest paths to a point, at the source or where they part; with the method
        "laplacian" that between gradients of the distance. Between two sources it is 2 pi.
        """
        return self._core.strengths()

    @cached_property
    def width(self) -> Floats:
        """(m,): the largest separation, a length, of the two shortest paths to a point of the edge.

        Zero with the method "laplacian". Between two sources it is the way from one to the other through the edge.
        """
        return self._core.widths()

    @cached_property
    def edge_sources(self) -> Ints:
        """(m, 2): the numbers of the sources nearest to the two sides of each edge, the smaller one first."""
        return self._core.edge_sources()

    @cached_property
    def is_on_border(self) -> Bools:
        """(m,): whether each edge follows the border of the mesh."""
        return self._core.is_on_border().view(np.bool_)

    @cached_property
    def tips(self) -> Ints:
        """The points with one edge, at which branches end."""
        return np.flatnonzero(self._degrees == 1)

    @cached_property
    def branching_points(self) -> Ints:
        """The points with three edges or more."""
        return np.flatnonzero(self._degrees > 2)

    @cached_property
    def polylines(self) -> List[Ints]:
        """The points along each branch, between tips and branching points: `result.points[line]` are its places.

        A cycle without these ends with its first point; a cut locus that is one point is a line of that.
        """
        return self._core.polylines()

    @property
    def cell_neighbors(self) -> Ints:
        """(p, 2): the sources whose cells of the geodesic Voronoi diagram touch along a curve: the edges of the dual graph."""
        return self._cell_neighbors[0]

    @property
    def cell_boundary_length(self) -> Floats:
        """(p,): the length of the curve along which they touch."""
        return self._cell_neighbors[1]

    @cached_property
    def _cell_neighbors(self) -> Tuple[Ints, Floats]:
        return self._core.cell_neighbors()

    @property
    def cell_area(self) -> Floats:
        """(k,): the area of the cell of each source in the geodesic Voronoi diagram; together that of the surface."""
        self._require_mesh("cell_area")
        return self._core.cell_areas()

    def cells(self) -> Cells:
        """The surface with faces split along the cut locus, so that each is in the cell of one source."""
        self._require_mesh("cells()")
        return Cells(*self._core.cells())

    def _require_mesh(self, what: str) -> None:
        if self._has_edge_lengths:
            raise _core.InvalidInput(f"{what} takes the points, and not edge_lengths")

    @property
    def _degrees(self) -> Ints:
        return np.bincount(self.edges.ravel(), minlength=len(self.points))

    # -- the vertices of the mesh

    @cached_property
    def vertex_distance(self) -> Floats:
        """(number of vertices of the mesh,): their distances to the source, or the nearest one; inf if not reached."""
        return self._core.vertex_distances()

    @cached_property
    def nearest_source(self) -> Ints:
        """(number of vertices of the mesh,): the number of the source nearest to each; -1 if not reached."""
        return self._core.nearest_sources()

    @property
    def farthest_vertex(self) -> int:
        """The vertex of the mesh that is farthest from the source, or from the nearest one."""
        return self._core.farthest_vertex

    @property
    def farthest_node(self) -> int:
        """The node that is farthest from the source: on a closed surface no point is farther, but at branches left out."""
        return int(self.distance.argmax())

    # -- the k sources

    @cached_property
    def source_points(self) -> Floats:
        """(k, 3): the sources in space, in the order in which they were given, points first; of a curve a vertex."""
        return self._core.source_points()

    @cached_property
    def source_faces(self) -> Ints:
        """(k,): a face of the mesh that each source is in, or on the border of."""
        return self._core.source_faces()

    @cached_property
    def source_barycentric(self) -> Floats:
        """(k, 3): the barycentric coordinates of each source in its face."""
        return self._core.source_barycentric()

    # -- the whole

    @property
    def injectivity_radius(self) -> float:
        """The smallest distance on the cut locus, of the branches that are shown."""
        return self._nearest[0]

    @property
    def injectivity_lower_bound(self) -> float:
        """Within this distance shortest paths are unique, whatever the thresholds: weak branches begin no nearer.

        On a mesh of a smooth surface it is mostly the distance of the nearest vertex of positive curvature, at which the
        polyhedron has a branch. It is 0 beside a curve with corners, and with the method "laplacian", which does not
        know it.
        """
        return self._nearest[2]

    @property
    def injectivity_point(self) -> Floats:
        """(3,): where it is reached."""
        return self._nearest[1]

    def geodesic_loop(self) -> Floats:
        """(p, 3): the two shortest paths to the point where the injectivity radius is reached, from the source to the
        source; of one source. Inside a branch this is the shortest geodesic loop there, at its end both are one path."""
        self._require_mesh("geodesic_loop()")
        return self._core.geodesic_loop()

    @property
    def cycles(self) -> int:
        """The number of independent cycles: 2 g on a closed surface of genus g, and 2 g - 1 + k for k points."""
        return self._core.cycles

    @property
    def components(self) -> int:
        """The number of connected components of the graph."""
        return self._core.components

    @property
    def leaves(self) -> int:
        """The number of points with one edge."""
        return self._core.leaves

    @property
    def branchings(self) -> int:
        """The number of points with three edges or more."""
        return self._core.branchings

    @property
    def length(self) -> float:
        """The sum of the lengths of the edges."""
        return self._core.length

    @property
    def narrow_corridors(self) -> int:
        """How many corridors between branches a curve of mesh edges closes, since they are narrower than a face."""
        return self._core.narrow_corridors

    @property
    def one_of_several(self) -> bool:
        """Whether other curves are as right: the source is placed symmetrically, so that all points of some region have
        several shortest paths of the same length."""
        return self._core.one_of_several

    @property
    def genus(self) -> int:
        """The genus of the source's component of the mesh."""
        return self._core.genus

    @property
    def border_loops(self) -> int:
        """The number of border loops of the source's component of the mesh."""
        return self._core.border_loops

    @property
    def status(self) -> str:
        """"branches"; "one point", as on a sphere without bumps; or "only a border", as in a flat disk."""
        return self._core.status

    def write(self, filename: Union[str, PathLike[str]]) -> None:
        """Writes the graph to a file in the format that its extension names: .polylines.txt, .obj, .ply or .vtp.

        Raises InvalidInput if it names none of these, and OSError if the file cannot be written.
        """
        name = fspath(filename)
        if not name.endswith(_EXTENSIONS):
            raise _core.InvalidInput(f"{name} must end with one of {', '.join(_EXTENSIONS)}")
        if not self._core.write(name):
            raise OSError(f"cannot write {name}")

    def cut_open(self, *, parameterization: Optional[str] = "injective") -> Disk:
        """Cuts the surface open along the cut locus, to a disk, and flattens it. See `cut_locus.cut_open()`."""
        if self._has_edge_lengths and parameterization is not None:
            raise _core.InvalidInput("surfaces are flattened by their points, and not by edge_lengths: pass "
                                     "parameterization=None")
        return disk_of(self._core, parameterization)

    @cached_property
    def _nearest(self) -> Tuple[float, Floats, float]:
        return self._core.nearest()


class _Saved:
    """What a result tells, in place of its C++ part when it is pickled: all but the mesh, without which there is no
    `cut_open()`, nor cells."""

    _TAKE_MESH = {"cut_open": "cut_locus.cut_open() takes one", "cells": "compute it again",
                  "cell_areas": "compute it again", "geodesic_loop": "compute it again", "write": "compute it again"}

    def __init__(self, core: Any) -> None:
        if isinstance(core, _Saved):
            self._values = core._values
            return
        self._values: Dict[str, Tuple[bool, Any]] = {}
        for name in vars(_core.Result):
            if not name.startswith("_") and name not in self._TAKE_MESH:
                value = getattr(core, name)
                self._values[name] = (True, value()) if callable(value) else (False, value)

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        for _, value in self._values.values():
            for array in value if isinstance(value, (list, tuple)) else [value]:
                if isinstance(array, np.ndarray):
                    array.flags.writeable = False  # as the arrays of the C++ part

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._TAKE_MESH:
            raise _core.InvalidInput(f"a result that has been pickled has no mesh: {self._TAKE_MESH[name]}")
        is_function, value = self._values[name]
        return (lambda: value) if is_function else value


class CutLocus:
    """Cut loci on a mesh, at three levels of cost.

    The constructor does what depends on the mesh alone, `set_source()` what depends on the source, and `cut_locus()`
    applies thresholds in time proportional to the size of its result. Calls from several threads wait for each other:
    threads that are to run at once need an object each.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points. They are copied, since the mesh is kept; float64 and float32 are copied once, whatever the layout.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike. They are copied, too.
    solver : str
        Where distances come from: "exact" (default), "cgal-exact", "heat", "heat-direct" or "graph".
    method : str, optional
        How the cut locus is found: "default" (default with the solver "exact"; it needs no tuning), "polyhedral" (all
        branches of the polyhedron) or "laplacian" (default with other solvers, and with `distances`).
    laplacian_operator : str, optional
        "quadratic-fit" (default) or "cotangent"; for the method "laplacian".
    edge_lengths : (m, 3) real numbers, optional
        The lengths of the edges of each face, from that between its first two vertices on, in the order of its
        vertices: they are the metric then, and the points are for output only. For the solver "exact", and not for the
        method "laplacian". What is in diagonals of the bounding box is then in square roots of the area.
    progress : callable, optional
        Called as ``progress(stage, ends)`` when a stage starts and when it ends: "preprocessing", "distance",
        "strength", "tree", "homology" or "filter". What it raises ends the computation and comes out of it. Ctrl-C is
        looked for at the same places. It cannot use the object that calls it.

    Raises
    ------
    InvalidInput
        If the arrays are not those of an oriented manifold mesh of finite coordinates, or a parameter has no meaning
        for the method. It is a ValueError.
    TypeError
        If the arrays do not hold real numbers, or whole ones.
    """

    def __init__(self, vertices: npt.ArrayLike, faces: npt.ArrayLike, *, solver: str = "exact",
                 method: Optional[str] = None, laplacian_operator: Optional[str] = None,
                 edge_lengths: Optional[npt.ArrayLike] = None, progress: Optional[Progress] = None) -> None:
        if solver not in _core.solver_names:
            names = ", ".join(repr(name) for name in _core.solver_names)
            raise _core.InvalidInput(f"the solver must be one of {names}, and not {solver!r}")
        if progress is not None and not callable(progress):
            raise TypeError(f"progress must be a function, and not {progress!r}")
        self._core = _core.Computation(
            read_mesh(vertices, faces), solver, method_of(method),
            value_of(_core.LaplacianOperator, laplacian_operator, "laplacian_operator"),
            None if edge_lengths is None else np.asarray(edge_lengths), progress)
        self._has_edge_lengths = edge_lengths is not None

    def set_source(self, source: Optional[Sources] = None, *, source_curves: Optional[Curves] = None,
                   source_border: bool = False, distances: Optional[npt.ArrayLike] = None,
                   snapping_tolerance: float = 1e-10, maximum_relative_error: float = 0.) -> None:
        """Computes the distances to the source, and all that `cut_locus()` needs.

        Parameters
        ----------
        source : int, (int, (3,) floats), or a sequence of them
            A vertex; a face and barycentric coordinates in the order of its vertices; or several such points, whose cut
            locus is their geodesic Voronoi diagram together with the cut locus inside each cell. With curves or the
            border there need not be one.
        source_curves : sequence of (k,) or (k, 2) whole numbers, optional
            Curves along edges of the mesh, which are sources too, numbered behind the points: of each one the vertices
            along it, or the pairs of vertices that its edges join. Each is connected, and no two have a vertex in
            common. The method "laplacian" starts with edges of the mesh, and needs a vertex between sources.
        source_border : bool
            Whether each border loop is a source, behind all others: of a flat region, that gives its medial axis.
        distances : (n,) real numbers, optional
            The geodesic distance of each vertex to the source, of several sources, curves and the border to the nearest
            one, if it is known: then no solver runs, and the method is "laplacian" unless the constructor was given one.
            They are copied, since this runs without the GIL.
        snapping_tolerance : float
            A barycentric coordinate up to this value is taken for zero.
        maximum_relative_error : float
            By how much distances may be longer than the exact ones, as a share of their length, up to 0.1: faster on
            large meshes. For points, the solver "exact", and not for the method "polyhedral".
        """
        if source is None and source_curves is None and not source_border:
            raise TypeError("there must be a source, source_curves or the source_border")
        numbers, is_set = read_sources([] if source is None else source)
        curves = read_curves(source_curves)
        if distances is not None and maximum_relative_error != 0.:
            raise _core.InvalidInput("distances are taken as they are: leave maximum_relative_error away")
        self._core.set_sources(numbers, is_set, curves, bool(source_border), snapping_tolerance, maximum_relative_error,
                               None if distances is None else np.asarray(distances))

    def cut_locus(self, *, curve: Optional[str] = None, minimum_branch_width: Optional[float] = None,
                  minimum_branch_gap: Optional[float] = None, minimum_branch_curvature: Optional[float] = None,
                  gradient_angle_threshold: Optional[float] = None,
                  laplacian_threshold: Optional[float] = None, filter_policy: Optional[str] = None,
                  minimum_branch_edges: Optional[int] = None, minimum_branch_length: Optional[float] = None,
                  number_of_iterations: Optional[int] = None, voronoi: Optional[bool] = None,
                  medial: Optional[bool] = None) -> Result:
        """Returns the part of the cut locus that passes the thresholds. One of another method is refused.

        Parameters
        ----------
        curve : str, optional
            "faces": the result is made of segments through the faces of the mesh (default); or "edges": of its edges.
        minimum_branch_width : float, optional
            The least separation of the two shortest paths that a branch reaches, in diagonals of the bounding box of
            the source's component; not for "laplacian". Default: see the property of this name.
        minimum_branch_gap : float, optional
            The least angle at the source between them, in radians in [0, pi]; not for "laplacian".
        minimum_branch_curvature : float, optional
            The curvature that these paths have to enclose, on both sides, for the branch to be kept at a quarter
            of the width: in radians in [0, 4 pi]; not for "laplacian". Default: see the property of this name; if a
            width or a gap is given, the width alone counts.
        gradient_angle_threshold : float, optional
            The angle at which shortest paths must meet, in radians in [0, pi]; for "laplacian".
        laplacian_threshold : float, optional
            The least value of minus the Laplacian of the distance times the mean edge length; for "laplacian".
        filter_policy : str, optional
            "prune" weak branches from their tips (default), or "grow" the tree from its root; for "laplacian".
        minimum_branch_edges : int, optional
            Branches of fewer edges are removed: of `curve`, or with "laplacian" of the mesh. Of edges of the mesh, those
            count by which a branch leads away from the rest. Of sources that are curves for the curve "edges" or
            "laplacian" only. Default: 3 with "laplacian", else 0.
        minimum_branch_length : float, optional
            Shorter branches are removed, in diagonals of the bounding box; as `minimum_branch_edges`. Default: 0.
        number_of_iterations : int, optional
            Of the smoothing that makes the curve through the faces, for "laplacian": 4 by default. 0 leaves edges.
        voronoi : bool, optional
            Keep the edges between two sources alone.
        medial : bool, optional
            Keep those inside the cells alone.
        """
        core = self._core.cut_locus(
            minimum_branch_width=minimum_branch_width, minimum_branch_gap=minimum_branch_gap,
            minimum_branch_curvature=minimum_branch_curvature,
            gradient_angle_threshold=gradient_angle_threshold, laplacian_threshold=laplacian_threshold,
            filter_policy=value_of(_core.FilterPolicy, filter_policy, "filter_policy"),
            minimum_branch_edges=minimum_branch_edges, number_of_iterations=number_of_iterations,
            minimum_branch_length=minimum_branch_length, curve=value_of(_core.Curve, curve, "curve"), voronoi=voronoi,
            medial=medial)
        return Result(core, self.method, self._has_edge_lengths)

    def _copy(self) -> CutLocus:
        """For another thread: it shares what has been computed for the mesh alone, and has no source."""
        result = CutLocus.__new__(CutLocus)
        result._core = self._core.copy()
        result._has_edge_lengths = self._has_edge_lengths
        return result

    @property
    def method(self) -> str:
        """The method in force for the current source."""
        return self._core.method.name

    @property
    def minimum_branch_width(self) -> float:
        """The default of this threshold for the current source, in diagonals of the bounding box; 0 if it has none."""
        return self._core.minimum_branch_width

    @property
    def minimum_branch_curvature(self) -> float:
        """The default of this threshold for the current source, in radians; 0 if it has none."""
        return self._core.minimum_branch_curvature

    @property
    def gradient_angle_threshold(self) -> float:
        """The default of this threshold for the current source with the method "laplacian", in radians."""
        return self._core.gradient_angle_threshold


def compute(vertices: npt.ArrayLike, faces: npt.ArrayLike, source: Optional[Sources] = None, *,
            source_curves: Optional[Curves] = None, source_border: bool = False, solver: str = "exact",
            method: Optional[str] = None, curve: Optional[str] = None, laplacian_operator: Optional[str] = None,
            edge_lengths: Optional[npt.ArrayLike] = None, distances: Optional[npt.ArrayLike] = None,
            snapping_tolerance: float = 1e-10, maximum_relative_error: float = 0.,
            minimum_branch_width: Optional[float] = None, minimum_branch_gap: Optional[float] = None,
            minimum_branch_curvature: Optional[float] = None,
            gradient_angle_threshold: Optional[float] = None, laplacian_threshold: Optional[float] = None,
            filter_policy: Optional[str] = None, minimum_branch_edges: Optional[int] = None,
            minimum_branch_length: Optional[float] = None, number_of_iterations: Optional[int] = None,
            voronoi: Optional[bool] = None, medial: Optional[bool] = None,
            progress: Optional[Progress] = None) -> Result:
    """Computes the cut locus of a point, of several points, or of curves, on a triangle mesh.

    For one source after another on a mesh, or several thresholds for a source, `CutLocus` does what they share once.

    Parameters
    ----------
    vertices : (n, 3) real numbers
        The points.
    faces : (m, 3) whole numbers
        The vertices of each triangle, oriented alike.
    source : int, (int, (3,) floats), or a sequence of them
        A vertex; a face and barycentric coordinates in the order of its vertices; or several such points.
    solver, method, laplacian_operator, edge_lengths, progress
        As in `CutLocus`.
    source_curves, source_border, distances, snapping_tolerance, maximum_relative_error
        As in `CutLocus.set_source()`.
    curve, minimum_branch_width, minimum_branch_gap, minimum_branch_curvature, gradient_angle_threshold, laplacian_threshold, filter_policy, \
    minimum_branch_edges, minimum_branch_length, number_of_iterations, voronoi, medial
        As in `CutLocus.cut_locus()`.

    Returns
    -------
    Result
        The graph, its edges' strengths and widths, the distances, and what can be said of the whole.

    Raises
    ------
    InvalidInput
        Where the mesh, the source or a parameter cannot be used. It is a ValueError.
    TypeError
        If the arrays do not hold real numbers, or whole ones.
    """
    computation = CutLocus(vertices, faces, solver=solver, method=method, laplacian_operator=laplacian_operator,
                           edge_lengths=edge_lengths, progress=progress)
    computation.set_source(source, source_curves=source_curves, source_border=source_border, distances=distances,
                           snapping_tolerance=snapping_tolerance, maximum_relative_error=maximum_relative_error)
    return computation.cut_locus(
        curve=curve, minimum_branch_width=minimum_branch_width, minimum_branch_gap=minimum_branch_gap,
        minimum_branch_curvature=minimum_branch_curvature, gradient_angle_threshold=gradient_angle_threshold, laplacian_threshold=laplacian_threshold,
        filter_policy=filter_policy, minimum_branch_edges=minimum_branch_edges,
        minimum_branch_length=minimum_branch_length, number_of_iterations=number_of_iterations, voronoi=voronoi,
        medial=medial)


def voronoi(vertices: npt.ArrayLike, faces: npt.ArrayLike, sources: Sources, **parameters: Any) -> Result:
    """Computes the geodesic Voronoi diagram of several points: what of their cut locus is between two of them.

    `Result.cell_area` has the areas of the cells, `Result.cell_neighbors` the dual graph, with `cell_boundary_length`, and
    `Result.cells()` the surface divided into them.

    Parameters
    ----------
    vertices, faces, sources, **parameters
        As in `compute()`.
    """
    return compute(vertices, faces, sources, voronoi=True, **parameters)


def medial_axis(vertices: npt.ArrayLike, faces: npt.ArrayLike, source_curves: Optional[Curves] = None,
                **parameters: Any) -> Result:
    """Computes the medial axis of a surface with a border, or of what curves bound: their cut locus.

    Parameters
    ----------
    vertices, faces, **parameters
        As in `compute()`.
    source_curves : sequence of (k,) or (k, 2) whole numbers, optional
        The curves, as in `CutLocus.set_source()`. Default: the border.
    """
    return compute(vertices, faces, source_curves=source_curves, source_border=source_curves is None, **parameters)
