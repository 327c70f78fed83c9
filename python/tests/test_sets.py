"""Sets of sources, with curves and the border; many sources, one after another; and metrics given by lengths."""

import cut_locus
import meshes
import numpy as np
import pytest

WIDTH, HEIGHT = 2., 1.


def rectangle(columns=16, rows=8):
    x, y = np.meshgrid(np.linspace(0., WIDTH, columns + 1), np.linspace(0., HEIGHT, rows + 1), indexing="ij")
    points = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3)
    return points, meshes.grid(columns + 1, rows + 1, False, False)


def edges_of(faces):
    """The halfedges, from the first vertex of each face to its second, and so on: (m, 3, 2)."""
    return np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1)


def lengths_in_space(points, faces):
    ends = points[edges_of(faces)]
    return np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)


# -- sources that are curves


@pytest.mark.parametrize("method", ["default", "polyhedral"])
def test_medial_axis_of_a_rectangle(method):
    points, faces = rectangle()
    # by default a branch into a corner ends where it is as narrow as the mesh may cause
    gap = {"minimum_branch_gap": 0.5} if method == "default" else {}
    result = cut_locus.compute(points, faces, source_border=True, method=method, **gap)
    edge = WIDTH / 16
    assert result.length == pytest.approx(WIDTH - HEIGHT + 2. * 2.**0.5, abs=1e-3 * edge)
    assert result.leaves == 4 and result.cycles == 0
    x, y, _ = result.points.T
    to_sides = np.sort([x, WIDTH - x, y, HEIGHT - y], axis=0)
    assert to_sides[1] == pytest.approx(to_sides[0], abs=1e-3 * edge)
    assert result.distance.max() == pytest.approx(0.5 * HEIGHT, abs=1e-3 * edge)
    assert np.all(result.edge_sources == 0) and len(result.source_points) == 1


@pytest.mark.parametrize("solver", ["exact", "heat", "graph"])
def test_medial_axis_by_the_laplacian(solver):
    points, faces = rectangle()
    edge = WIDTH / 16
    for curve in ("faces", "edges"):
        result = cut_locus.compute(points, faces, source_border=True, method="laplacian", solver=solver, curve=curve)
        assert result.cycles == 0 and np.all(result.edge_sources == 0)
        x, y, _ = result.points.T
        to_sides = np.sort([x, WIDTH - x, y, HEIGHT - y], axis=0)
        assert np.all(to_sides[1] - to_sides[0] < 2.5 * edge)
        assert result.points[:, 0].max() - result.points[:, 0].min() > WIDTH - HEIGHT - 2. * edge


def test_curves_are_paths_or_edges():
    points, faces = meshes.cylinder(12, 9, 8.)
    first, last = (np.append(9 * np.arange(12) + row, row) for row in (0, 8))  # closed, as the first vertex comes again
    as_edges = np.stack([last[:-1], last[1:]], axis=1)[::-1]
    results = [cut_locus.compute(points, faces, source_curves=[first, last], curve="faces"),
               cut_locus.compute(points, faces, [], source_curves=[first.tolist(), as_edges]),
               cut_locus.compute(points, faces, source_border=True)]
    for result in results:
        assert result.points[:, 2] == pytest.approx(4., abs=1e-3)
        assert result.length == pytest.approx(12., abs=1e-2) and result.cycles == 1
        assert np.all(result.edge_sources == [0, 1])
        assert result.vertex_distance == pytest.approx(np.minimum(points[:, 2], 8. - points[:, 2]), abs=1e-3)
        below = points[:, 2] < 3.9
        assert np.all(result.nearest_source[below] == 0) and np.all(result.nearest_source[points[:, 2] > 4.1] == 1)


def test_points_come_before_curves_and_these_before_the_border():
    points, faces = rectangle()
    inside = 9 * 8 + 4  # the middle
    path = 9 * np.arange(2, 5) + 4
    result = cut_locus.compute(points, faces, [inside], source_curves=[path], source_border=True)
    assert len(result.source_points) == 3
    assert result.source_points[0] == pytest.approx(points[inside])
    assert np.any(np.all(np.isclose(points[path], result.source_points[1]), axis=1))
    assert result.nearest_source[inside] == 0 and np.all(result.nearest_source[path] == 1)
    assert result.nearest_source[0] == 2 and set(map(tuple, result.edge_sources)) >= {(0, 1), (0, 2), (1, 2)}
    assert result.vertex_distance[9 * 8 + 5] == pytest.approx(1. / 8.)


def test_parts_of_a_set():
    points, faces = meshes.torus(40, 20)
    computation = cut_locus.CutLocus(points, faces)
    computation.set_source([0, 311])
    whole, voronoi, medial = (computation.cut_locus(curve="faces", **part)
                              for part in ({}, {"voronoi": True}, {"medial": True}))
    assert len(voronoi.edges) > 0 and len(medial.edges) > 0
    assert voronoi.length + medial.length == pytest.approx(whole.length)
    assert np.all(voronoi.edge_sources == [0, 1])
    assert np.all(medial.edge_sources[:, 0] == medial.edge_sources[:, 1])
    with pytest.raises(cut_locus.InvalidInput, match="voronoi and medial exclude each other"):
        computation.cut_locus(voronoi=True, medial=True)


def test_a_curve_is_forgotten_by_the_next_source():
    points, faces = rectangle()
    computation = cut_locus.CutLocus(points, faces)
    computation.set_source(source_border=True)
    computation.cut_locus()
    computation.set_source(40)
    assert np.all(computation.cut_locus(curve="edges").mesh_vertices >= 0)


def test_edges_of_the_mesh_beside_the_border():
    result = cut_locus.compute(*rectangle(), source_border=True, curve="edges")
    assert np.all(result.mesh_vertices >= 0)


@pytest.mark.parametrize("arguments, cause", [
    ({"source_curves": [[0, 20]]}, r"source curve 0: the mesh has no edge from vertex #0 to vertex #20"),
    ({"source_curves": [[0, 9], [40, 999]]}, "there is no vertex #999"),
    ({"source_curves": [[]]}, "source curve 0: it has no edges"),
    ({"source_curves": [[0, 9], [9, 18]]}, "sources 0 and 1 have a vertex in common: together, they are one source"),
    ({"source_curves": [[[0, 9], [40, 49]]]}, "source curve 0: it is not connected"),
    ({"source_curves": [[0, 9], [18, 27]], "curve": "edges"}, r"sources 0 and 1 are one edge apart.*ask for curve=\"faces\""),
    ({"source_curves": [[9, 10, 19, 18]], "curve": "edges"}, "two ends of source 0 are one edge apart"),
    ({"source": 9, "source_curves": [[0, 9]]}, "sources 0 and 1 have a point in common"),
    ({"source_border": True, "minimum_branch_edges": 2}, "minimum_branch_edges is for a cut locus made of edges"),
    ({"source_border": True, "maximum_relative_error": 0.01}, "curves need exact distances"),
    ({"source_border": True, "distances": np.full(153, -1.)}, "distances hold a distance that is negative"),
    ({"source_border": True, "distances": np.zeros(152)}, "distances must be an array"),
    ({"source": [], "distances": np.zeros(153)}, "the range of sources is empty"),
    ({"source": [9, 40], "distances": np.zeros(153), "method": "default"}, "needs the paths"),
    ({"source_border": True, "distances": np.zeros(153), "maximum_relative_error": 0.01}, "taken as they are"),
    ({"source": 9, "maximum_relative_error": 0.2}, "from 0 to 0.1"),
    ({"source": []}, "the range of sources is empty"),
])
def test_sets_that_can_not_be_used(arguments, cause):
    with pytest.raises(cut_locus.InvalidInput, match=cause):
        cut_locus.compute(*rectangle(), **arguments)


def test_no_border():
    with pytest.raises(cut_locus.InvalidInput, match="the mesh has no border"):
        cut_locus.compute(*meshes.octahedron(), source_border=True)


@pytest.mark.parametrize("curves", [[0, 9, 18], [[0.5, 1.]], [[[0, 9, 18]]], ["path"]])
def test_curves_of_the_wrong_type(curves):
    with pytest.raises(TypeError, match="source curve 0 must be the vertices along a path"):
        cut_locus.compute(*rectangle(), source_curves=curves)


def test_there_must_be_a_source():
    with pytest.raises(TypeError, match="there must be a source"):
        cut_locus.compute(*rectangle())


def test_own_distances_to_the_nearest_of_several_points():
    points, faces = meshes.torus(60, 30)
    sources = [0, 777, 1333]
    distances = cut_locus.exact_geodesic_distances(points, faces, sources)
    result = cut_locus.compute(points, faces, sources, distances=distances)
    assert result.method == "laplacian" and np.array_equal(result.vertex_distance, distances)
    assert result.cycles == 4 and result.components == 1
    each = np.array([cut_locus.exact_geodesic_distances(points, faces, source) for source in sources])
    # but for what is about as far from two of them
    least = np.sort(each, axis=0)
    is_clear = least[1] - least[0] > 2. * meshes.length_of(points, faces[:, :2]).max()
    assert is_clear.mean() > 0.5
    assert np.array_equal(result.nearest_source[is_clear], each.argmin(axis=0)[is_clear])


def test_own_distances_to_the_border_and_a_point():
    points, faces = rectangle()
    x, y, _ = points.T
    middle = len(points) // 2
    assert (x[middle], y[middle]) == (WIDTH / 2., HEIGHT / 2.)
    to_border = np.min([x, WIDTH - x, y, HEIGHT - y], axis=0)
    to_point = np.hypot(x - x[middle], y - y[middle])
    computation = cut_locus.CutLocus(points, faces)
    for source, total in ((None, 1), (middle, 2)):
        distances = to_border if source is None else np.minimum(to_border, to_point)
        computation.set_source(source, source_border=True, distances=distances)
        result = computation.cut_locus()
        assert result.method == "laplacian" and result.vertex_distance == pytest.approx(distances, abs=1e-15)
        assert len(result.source_points) == total
        # around the point, a loop half-way to the border
        assert result.cycles == total - 1
        # later sources have no such distances
        computation.set_source([0, 9])
        assert computation.method == "default"


@pytest.mark.parametrize("curve", ["faces", "edges"])
def test_own_distances_to_curves(curve):
    points, faces = meshes.cylinder(12, 9, 8.)
    height = points[:, 2]
    first, last = (np.append(9 * np.arange(12) + row, row) for row in (0, 8))
    # waves of the first end may be slower, and those of the last one come farther
    for slowness, middle in ((1., 4.), (3., 2.)):
        distances = np.minimum(slowness * height, 8. - height)
        result = cut_locus.compute(points, faces, source_curves=[first, last], distances=distances, curve=curve)
        assert result.method == "laplacian" and np.array_equal(result.vertex_distance, distances)
        assert result.cycles == 1 and np.all(result.edge_sources == [0, 1])
        # edges have the length 1; through faces, nodes keep off vertices by a few millionths of that
        assert abs(np.median(result.points[:, 2]) - middle) <= 1e-5 and np.all(np.abs(result.points[:, 2] - middle) <= 1.)
        assert np.all(result.nearest_source[height < middle] == 0) and np.all(result.nearest_source[height > middle] == 1)
        assert abs(np.median(result.distance) - (8. - middle)) <= 1e-5


def test_distances_within_an_error():
    points, faces = meshes.torus(60, 30)
    exact = cut_locus.compute(points, faces, 0)
    nearly = cut_locus.compute(points, faces, 0, maximum_relative_error=0.01)
    assert np.all(nearly.vertex_distance <= 1.01 * exact.vertex_distance + 1e-12)
    assert np.all(nearly.vertex_distance >= exact.vertex_distance - 1e-12)
    assert not np.array_equal(nearly.vertex_distance, exact.vertex_distance)
    assert nearly.cycles == 2


# -- many sources, one after another


@pytest.mark.parametrize("threads", [0, 1, 2, 5])
def test_many_sources(threads):
    points, faces = meshes.bumpy_sphere(3)
    sources = [0, 7, (11, (0.2, 0.3, 0.5)), 300, 7, 20]
    results = list(cut_locus.compute_cut_loci(points, faces, sources, threads=threads, minimum_branch_width=0.05))
    assert len(results) == len(sources)
    for source, result in zip(sources, results):
        expected = cut_locus.compute(points, faces, source, minimum_branch_width=0.05)
        assert np.array_equal(result.points, expected.points) and np.array_equal(result.edges, expected.edges)
        assert np.array_equal(result.vertex_distance, expected.vertex_distance)


@pytest.mark.parametrize("threads", [1, 2])
def test_results_of_many_sources_are_computed_when_they_are_asked_for(threads):
    points, faces = meshes.bumpy_sphere(2)
    results = cut_locus.compute_cut_loci(points, faces, range(len(points)), threads=threads)
    assert next(results).vertex_distance[0] == 0. and next(results).vertex_distance[1] == 0.
    results.close()  # without those of the others
    assert list(cut_locus.compute_cut_loci(points, faces, [], threads=threads)) == []


@pytest.mark.parametrize("threads", [1, 2])
def test_many_sources_that_can_not_be_used(threads):
    points, faces = meshes.octahedron()
    for sources, arguments, error, cause in [
            ([0, 6], {}, cut_locus.InvalidInput, "there is no vertex #6"),
            ([0, 1], {"solver": "none"}, cut_locus.InvalidInput, "the solver must be one of"),
            ([0, 1], {"width": 1.}, TypeError, "unexpected keyword argument 'width'"),
            ([0, 1], {"threads": -1}, cut_locus.InvalidInput, "must not be negative")]:
        with pytest.raises(error, match=cause):
            cut_locus.compute_cut_loci(points, faces, sources, **{"threads": threads, **arguments})
    results = cut_locus.compute_cut_loci(points, faces, [0, 1], threads=threads, gradient_angle_threshold=1.)
    with pytest.raises(cut_locus.InvalidInput, match="gradient_angle_threshold has no meaning"):
        next(results)


def test_many_sources_in_several_components():
    points, faces = meshes.octahedron()
    both = np.concatenate([points, points + 5.]), np.concatenate([faces, faces + 6])
    results = list(cut_locus.compute_cut_loci(*both, [0, 6], threads=2, method="polyhedral"))
    assert [np.isinf(r.vertex_distance).tolist() for r in results] == [6 * [False] + 6 * [True],
                                                                       6 * [True] + 6 * [False]]


# -- lengths of edges


def test_lengths_of_a_mesh_in_space_give_its_distances():
    points, faces = meshes.bumpy_sphere(3)
    expected = cut_locus.compute(points, faces, 0, method="polyhedral", minimum_branch_gap=0.3)
    found = cut_locus.compute(np.full_like(points, 7.), faces, 0, method="polyhedral", minimum_branch_gap=0.3,
                              edge_lengths=lengths_in_space(points, faces))
    assert found.vertex_distance == pytest.approx(expected.vertex_distance, abs=1e-11)
    assert len(found.points) == len(expected.points) and found.leaves == expected.leaves


def test_flat_torus_of_a_hexagonal_lattice():
    """Its cut locus is the border of a hexagon of the lattice: three sides, and two corners in which they meet."""
    n = 8
    faces = meshes.grid(n, n, True, True)
    lattice = np.array([[1., 0.], [-0.5, 0.75**0.5]])
    steps = (edges_of(faces)[:, :, 1] // n - edges_of(faces)[:, :, 0] // n,
             edges_of(faces)[:, :, 1] % n - edges_of(faces)[:, :, 0] % n)
    steps = np.stack([(s + 1) % n - 1 for s in steps], axis=-1)  # those over the end of the lattice are short, too
    lengths = np.linalg.norm(steps @ lattice / n, axis=2)
    points = np.zeros((n * n, 3))
    result = cut_locus.compute(points, faces, 0, method="polyhedral", edge_lengths=lengths)
    assert (result.cycles, result.components, result.branchings, result.leaves) == (2, 1, 2, 0)
    assert result.injectivity_radius == pytest.approx(0.5, abs=1e-5)
    assert result.distance.max() == pytest.approx(1. / 3.**0.5, abs=1e-5)
    images = np.array([[i, j] for i in (-1, 0, 1, 2) for j in (-1, 0, 1, 2)]) @ lattice
    at = np.stack([np.arange(n * n) // n, np.arange(n * n) % n], axis=1) @ lattice / n
    to_images = np.linalg.norm(at[:, None] - images[None], axis=2)
    assert result.vertex_distance == pytest.approx(to_images.min(axis=1), abs=1e-12)


def test_surfaces_of_lengths_are_cut_open_but_not_flattened():
    points, faces = meshes.torus(12, 8)
    result = cut_locus.compute(points, faces, 0, curve="edges", edge_lengths=lengths_in_space(points, faces))
    assert len(result.cut_open(parameterization=None).faces) == len(faces)
    with pytest.raises(cut_locus.InvalidInput, match="flattened by their points"):
        result.cut_open()


def changed(lengths, face, side, value):
    result = lengths.copy()
    result[face, side] = value
    return result


LENGTHS = lengths_in_space(*meshes.octahedron())


@pytest.mark.parametrize("lengths, arguments, cause", [
    (LENGTHS[:, :2], {}, r"edge lengths must be an array of the shape \(8, 3\), and not \(8, 2\)"),
    (changed(LENGTHS, 0, 1, -1.), {}, "face #0 has an edge whose length is -1"),
    (changed(LENGTHS, 0, 1, np.nan), {}, "face #0 has an edge whose length is nan"),
    (changed(LENGTHS, 3, 0, 2.), {}, r"face #\d and face #\d have different lengths for their edge"),
    (LENGTHS, {"method": "laplacian"}, "edge_lengths"),
    (LENGTHS, {"solver": "heat"}, "edge_lengths"),
])
def test_lengths_that_can_not_be_used(lengths, arguments, cause):
    with pytest.raises(cut_locus.InvalidInput, match=cause):
        cut_locus.compute(*meshes.octahedron(), 0, edge_lengths=lengths, **arguments)
