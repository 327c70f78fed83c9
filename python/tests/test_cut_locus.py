"""The arrays that are taken and returned, and the three levels of cost."""

import copy
import functools
import pickle
import re

import cut_locus
import meshes
import numpy as np
import pytest


@pytest.fixture(scope="module")
def bumpy():
    return meshes.bumpy_sphere(3)


@pytest.fixture(scope="module")
def reference(bumpy):
    return cut_locus.compute(*bumpy, 0, minimum_branch_width=0.05)


def assert_same(result, reference):
    assert np.array_equal(result.edges, reference.edges)
    assert np.array_equal(result.points, reference.points)
    assert np.array_equal(result.vertex_distance, reference.vertex_distance)


@pytest.mark.parametrize("curve", ["edges", "faces"])
def test_arrays(bumpy, curve):
    points, faces = bumpy
    result = cut_locus.compute(points, faces, 0, curve=curve, minimum_branch_width=0.05)
    n, m = len(result.points), len(result.edges)
    assert m > 10
    shapes = {
        "points": (n, 3), "faces": (n,), "barycentric": (n, 3), "mesh_vertices": (n,), "distance": (n,),
        "edges": (m, 2), "strength": (m,), "width": (m,), "edge_sources": (m, 2), "is_on_border": (m,),
        "vertex_distance": (len(points),), "nearest_source": (len(points),), "source_points": (1, 3),
        "source_faces": (1,), "source_barycentric": (1, 3), "injectivity_point": (3,)
    }
    for name, shape in shapes.items():
        array = getattr(result, name)
        assert array.shape == shape, name
        assert array is getattr(result, name)  # made once
        kind = {"f": np.float64, "i": np.int64, "b": np.bool_}[array.dtype.kind]
        assert array.dtype == kind, name
        with pytest.raises(ValueError):
            array[...] = 0
    # the locations are those of the points
    assert np.einsum("ij,ijk->ik", result.barycentric, points[faces[result.faces]]) == pytest.approx(result.points)
    assert result.barycentric.sum(axis=1) == pytest.approx(np.ones(n))
    at_vertex = result.mesh_vertices >= 0
    assert np.array_equal(points[result.mesh_vertices[at_vertex]], result.points[at_vertex])
    assert result.vertex_distance[result.mesh_vertices[at_vertex]] == pytest.approx(result.distance[at_vertex])
    assert at_vertex.all() == (curve == "edges")
    # the statistics are those of the graph
    degree = np.bincount(result.edges.ravel(), minlength=n)
    assert (degree == 1).sum() == result.leaves and (degree > 2).sum() == result.branchings
    assert m - n + result.components == result.cycles == 0
    assert meshes.length_of(result.points, result.edges).sum() == pytest.approx(result.length)
    assert 0. < result.injectivity_lower_bound <= result.injectivity_radius <= result.distance.min()
    assert result.vertex_distance.argmax() == result.farthest_vertex
    assert result.distance[result.farthest_node] == result.distance.max()
    assert np.all(result.width > 0.) and np.all(result.strength > 0.)
    assert not result.is_on_border.any() and not result.edge_sources.any()
    assert result.status == "branches" and result.method == "default"
    assert "edges" in repr(result)


@pytest.mark.parametrize("convert", [
    np.asfortranarray,
    lambda a: a.astype(a.dtype.newbyteorder()),
    lambda a: np.repeat(a, 2, axis=0)[::2],
    lambda a: a[::-1][::-1],
    lambda a: a.tolist(),
    lambda a: np.frombuffer(b"\0" + a.tobytes(), dtype=np.uint8)[1:].view(a.dtype).reshape(a.shape),  # not aligned
])
def test_memory_layouts(bumpy, reference, convert):
    points, faces = bumpy
    assert_same(cut_locus.compute(convert(points), convert(faces), 0, minimum_branch_width=0.05), reference)


def test_read_only_arrays(bumpy, reference):
    points, faces = (a.copy() for a in bumpy)
    points.flags.writeable = False
    faces.flags.writeable = False
    assert_same(cut_locus.compute(points, faces, 0, minimum_branch_width=0.05), reference)


@pytest.mark.parametrize("dtype", ["int16", "int32", "int64", "uint16", "uint32", "uint64", ">i4"])
def test_types_of_faces(bumpy, reference, dtype):
    assert_same(cut_locus.compute(bumpy[0], bumpy[1].astype(dtype), 0, minimum_branch_width=0.05), reference)


@pytest.mark.parametrize("dtype", ["float16", "float32", "longdouble", ">f4"])
def test_types_of_points(bumpy, dtype):
    points = bumpy[0].astype(dtype)
    expected = cut_locus.compute(points.astype(np.float64), bumpy[1], 0, minimum_branch_width=0.05)
    assert_same(cut_locus.compute(points, bumpy[1], 0, minimum_branch_width=0.05), expected)


def test_input_is_copied(bumpy, reference):
    points, faces = (a.copy() for a in bumpy)
    computation = cut_locus.CutLocus(points, faces)
    points[...] = np.nan
    faces[...] = -1
    computation.set_source(0)
    assert_same(computation.cut_locus(minimum_branch_width=0.05), reference)


def test_result_outlives_all(bumpy):
    points, faces = (a.copy() for a in bumpy)
    result = cut_locus.compute(points, faces, 0, curve="edges", minimum_branch_width=0.05)
    edges = result.edges
    expected = edges.copy()
    disk = result.cut_open()
    del result, points, faces
    assert np.array_equal(edges, expected)
    assert len(disk.faces) == len(bumpy[1])


def test_sources(bumpy):
    points, faces = bumpy
    v = int(faces[11, 1])
    expected = cut_locus.compute(points, faces, v).vertex_distance
    for source in (np.int32(v), np.array(v), [v], np.array([v], dtype=np.uint8), (11, (0., 1., 0.)),
                   (11, np.array([0., 2., 0.])), [11, [0, 1, 0]], [(11, (0., 1., 0.))]):
        result = cut_locus.compute(points, faces, source)
        assert result.vertex_distance == pytest.approx(expected, abs=1e-12), source
        assert result.source_points == pytest.approx(points[None, v])
    inside = cut_locus.compute(points, faces, (11, (0.2, 0.3, 0.5)))
    assert inside.source_points[0] == pytest.approx(np.array([0.2, 0.3, 0.5]) @ points[faces[11]])
    assert inside.source_faces[0] == 11 and inside.source_barycentric[0] == pytest.approx([0.2, 0.3, 0.5])


def test_three_levels(bumpy):
    points, faces = bumpy
    stages = []
    computation = cut_locus.CutLocus(points, faces, progress=lambda stage, ends: stages.append(stage))
    assert set(stages) == {"preprocessing"}
    computation.set_source(0)
    assert stages[-1] == "homology"
    stages.clear()
    default = computation.minimum_branch_width
    assert default > 0. and computation.method == "default"
    results = [computation.cut_locus(minimum_branch_width=w) for w in (default, 2. * default, 4. * default)]
    assert set(stages) == {"filter"}  # nothing else is computed again
    lengths = [result.length for result in results]
    assert lengths[0] > lengths[1] > lengths[2]
    assert_same(results[0], computation.cut_locus())
    stages.clear()
    computation.set_source(5)
    assert set(stages) == {"distance", "strength", "tree", "homology"}
    assert_same(computation.cut_locus(), cut_locus.compute(points, faces, 5))
    assert results[0].vertex_distance[0] == 0.  # a result keeps the distances to its source


def test_the_old_name_of_the_default_method():
    points, faces = meshes.torus(24, 12)
    with pytest.warns(DeprecationWarning, match="default"):
        result = cut_locus.compute(points, faces, 3, method="direction")
    assert result.method == "default"


@pytest.mark.parametrize("solver", ["exact", "cgal-exact", "heat", "heat-direct", "graph"])
def test_solvers(solver):
    points, faces = meshes.torus(24, 12)
    exact = cut_locus.exact_geodesic_distances(points, faces, 3)
    result = cut_locus.compute(points, faces, 3, solver=solver)
    assert result.method == ("default" if solver == "exact" else "laplacian")
    assert result.cycles == 2 and result.components == 1
    error = np.abs(result.vertex_distance - exact).max()
    edge = meshes.length_of(points, faces[:, :2]).max()
    assert error < {"exact": 1e-12, "cgal-exact": 1e-9}.get(solver, edge)
    assert (error > 1e-6) == (solver in ("heat", "heat-direct", "graph"))  # it is the solver that was asked for


def test_own_distances(bumpy):
    points, faces = bumpy
    exact = cut_locus.exact_geodesic_distances(points, faces, 0)
    result = cut_locus.compute(points, faces, 0, distances=exact.astype(np.float32))
    assert result.method == "laplacian" and np.array_equal(result.vertex_distance, exact.astype(np.float32))


def test_parameters_of_laplacian(bumpy):
    points, faces = bumpy
    computation = cut_locus.CutLocus(points, faces, method="laplacian", laplacian_operator="cotangent")
    computation.set_source(0)
    default = computation.gradient_angle_threshold
    assert 0. < default < np.pi
    lengths = [computation.cut_locus(gradient_angle_threshold=a, minimum_branch_edges=0).length
               for a in (default / 4., default, 2. * default)]
    assert lengths[0] > lengths[1] > lengths[2]
    grown = computation.cut_locus(gradient_angle_threshold=default / 4., filter_policy="grow")
    pruned = computation.cut_locus(gradient_angle_threshold=default / 4., filter_policy="prune")
    assert grown.length <= pruned.length
    assert computation.cut_locus(laplacian_threshold=1e9).length == 0.
    smooth = computation.cut_locus(gradient_angle_threshold=default / 4., number_of_iterations=2)
    assert (smooth.mesh_vertices < 0).any()
    assert computation.cut_locus(minimum_branch_length=10.).length == 0.
    assert smooth.injectivity_lower_bound == 0. < smooth.injectivity_radius


@pytest.mark.parametrize("method", ["default", "polyhedral", "laplacian"])
@pytest.mark.parametrize("source", [3, [3, 50, 90]])
def test_the_curve_runs_through_the_faces_unless_edges_are_asked_for(method, source):
    computation = cut_locus.CutLocus(*meshes.torus(16, 8), method=method)
    computation.set_source(source)
    assert (computation.cut_locus().mesh_vertices < 0).any()
    assert np.array_equal(computation.cut_locus().points, computation.cut_locus(curve="faces").points)
    assert (computation.cut_locus(curve="edges").mesh_vertices >= 0).all()
    if method == "laplacian":
        assert (computation.cut_locus(number_of_iterations=0).mesh_vertices >= 0).all()
        assert (computation.cut_locus(number_of_iterations=2).mesh_vertices < 0).any()


def test_components_and_isolated_vertices():
    points, faces = meshes.octahedron()
    n = len(points)
    both = np.concatenate([points, points + 5., [[9., 9., 9.]]]), np.concatenate([faces, faces + n])
    result = cut_locus.compute(*both, n, method="polyhedral")
    assert np.isinf(result.vertex_distance[:n]).all() and np.isinf(result.vertex_distance[-1])
    assert np.all(result.nearest_source == [-1] * n + [0] * n + [-1])
    assert np.all(result.faces >= len(faces))


def test_polylines():
    result = cut_locus.compute(*meshes.torus(24, 12), 0)
    edges = {frozenset(edge) for edge in result.edges.tolist()}
    lines = [frozenset(pair) for line in result.polylines for pair in zip(line[:-1].tolist(), line[1:].tolist())]
    assert set(lines) == edges and len(lines) == len(edges)
    ends = {int(end) for line in result.polylines for end in (line[0], line[-1])}
    assert set(result.tips) | set(result.branching_points) <= ends
    assert len(result.tips) == result.leaves and len(result.branching_points) == result.branchings
    inner = {int(v) for line in result.polylines for v in line[1:-1]}
    assert not inner & (set(result.tips.tolist()) | set(result.branching_points.tolist()))
    point = cut_locus.compute(*meshes.octahedron(), 0)
    assert sum(len(line) - 1 for line in point.polylines) == len(point.edges)


def test_cell_neighbors():
    result = cut_locus.compute(*meshes.cube(), [0, 7])
    assert result.cell_neighbors.tolist() == [[0, 1]]
    between = result.edge_sources[:, 0] != result.edge_sources[:, 1]
    length = meshes.length_of(result.points, result.edges)[between].sum()
    assert result.cell_boundary_length == pytest.approx([length]) and length > 3.
    alone = cut_locus.compute(*meshes.cube(), 0)
    assert alone.cell_neighbors.shape == (0, 2) and alone.cell_boundary_length.shape == (0,)


def test_cells():
    points, faces = meshes.torus(24, 12)
    result = cut_locus.compute(points, faces, [0, 100, 200])
    cells = result.cells()
    p, q, r = (cells.vertices[cells.faces[:, i]] for i in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1)
    assert result.cell_area == pytest.approx(np.bincount(cells.source, weights=areas))
    p, q, r = (points[faces[:, i]] for i in range(3))
    assert result.cell_area.sum() == pytest.approx(0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1).sum())
    old = cells.vertex_origin >= 0
    assert np.array_equal(cells.vertices[old], points[cells.vertex_origin[old]])
    assert set(cells.face_origin) == set(range(len(faces))) and set(cells.source) == {0, 1, 2}
    for number, source in enumerate([0, 100, 200]):
        around = (cells.vertex_origin[cells.faces] == source).any(axis=1)
        assert around.any() and (cells.source[around] == number).all()
    again = pickle.loads(pickle.dumps(result))
    with pytest.raises(cut_locus.InvalidInput, match="has no mesh: compute it again"):
        again.cells()


def test_geodesic_loop():
    points, faces = meshes.torus(24, 12)
    result = cut_locus.compute(points, faces, 0)
    loop = result.geodesic_loop()
    assert loop[0] == pytest.approx(points[0]) and loop[-1] == pytest.approx(points[0])
    length = np.linalg.norm(np.diff(loop, axis=0), axis=1)
    assert length.sum() == pytest.approx(2. * result.injectivity_radius, abs=1e-3)
    assert np.linalg.norm(loop - result.injectivity_point, axis=1).min() < 1e-3
    with pytest.raises(cut_locus.InvalidInput, match="several sources"):
        cut_locus.compute(points, faces, [0, 50]).geodesic_loop()


def test_results_are_pickled():
    result = cut_locus.compute(*meshes.torus(24, 12), [0, 5])
    for again in (pickle.loads(pickle.dumps(result)), pickle.loads(pickle.dumps(copy.deepcopy(result)))):
        assert repr(again) == repr(result)
        for name, member in vars(cut_locus.Result).items():
            if name.startswith("_") or not isinstance(member, (property, functools.cached_property)) or name == "cell_area":
                continue
            value, expected = getattr(again, name), getattr(result, name)
            if isinstance(expected, list):
                assert all(np.array_equal(a, b) for a, b in zip(value, expected)) and len(value) == len(expected)
            else:
                assert np.array_equal(value, expected), name
        assert not again.edges.flags.writeable
        with pytest.raises(cut_locus.InvalidInput, match="pickled"):
            again.cut_open()


class Like:
    """A mesh of another package."""

    def __init__(self, **members):
        self.__dict__.update(members)


def test_meshes_of_other_packages():
    points, faces = meshes.torus(24, 12)
    flat = np.concatenate([np.full((len(faces), 1), 3), faces], axis=1).ravel()
    for mesh in (Like(vertices=points, faces=faces), Like(vertices=points.tolist(), triangles=faces),
                 Like(points=points, cells_dict={"line": faces[:, :2], "triangle": faces}),
                 Like(points=points, faces=flat), Like(points=points, faces=faces)):
        given = cut_locus.mesh_arrays(mesh)
        assert np.array_equal(given[0], points) and np.array_equal(given[1], faces)
    with pytest.raises(cut_locus.InvalidInput, match="its cells are quad"):
        cut_locus.mesh_arrays(Like(points=points, cells_dict={"quad": faces}))
    with pytest.raises(cut_locus.InvalidInput, match="triangulate"):
        cut_locus.mesh_arrays(Like(points=points, faces=np.array([4, 0, 1, 2, 3, 3, 0, 1])))
    with pytest.raises(TypeError, match="ndarray has none"):
        cut_locus.mesh_arrays(points)


def test_faces_that_are_no_triangles():
    points, _ = meshes.cube()
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    with pytest.raises(cut_locus.InvalidInput, match="all must be triangles") as refused:
        cut_locus.compute(points, quads, 0)
    names = {"np": np, "F": quads}
    exec(re.search(r"F = .*?\)\]\)", str(refused.value))[0], names)  # the remedy
    assert names["F"].shape == (12, 3) and cut_locus.compute(points, names["F"], 0).genus == 0
