"""What can not be used is refused, with the cause, and leaves everything as it was."""

import cut_locus
import meshes
import numpy as np
import pytest

POINTS, FACES = meshes.octahedron()


def with_value(array, index, value):
    result = array.copy()
    result[index] = value
    return result


BAD_MESHES = {
    "not a number": (with_value(POINTS, (2, 1), np.nan), FACES, "vertex #2 has a coordinate that is not finite"),
    "infinite": (with_value(POINTS, (3, 0), np.inf), FACES, "vertex #3 has a coordinate that is not finite"),
    "overflow": (with_value(POINTS.astype(np.longdouble), (4, 0), np.longdouble("1e400")), FACES, "not finite"),
    "too large": (POINTS, with_value(FACES, (5, 1), 6), r"face #5 has the vertex #6: the mesh has 6 vertices"),
    "negative": (POINTS, with_value(FACES, (5, 1), -1), r"face #5 has the vertex #-1"),
    "huge": (POINTS, with_value(FACES.astype(np.uint64), (0, 0), 2**64 - 1), "face #0 has the vertex"),
    "two columns": (POINTS[:, :2], FACES, r"vertices must be an array of the shape \(n, 3\), and not \(6, 2\)"),
    "quads": (POINTS, np.zeros((2, 4), dtype=int), r"faces have the shape \(2, 4\): all must be triangles"),
    "flat": (POINTS.ravel(), FACES, r"not \(18,\)"),
    "scalar": (1., FACES, r"not \(\)"),
    "no vertices": (np.zeros((0, 3)), np.zeros((0, 3), dtype=int), "it has no vertices"),
    "no faces": (POINTS, np.zeros((0, 3), dtype=int), "no faces"),
    "empty lists": ([], [], r"not \(0,\)"),
    "vertex twice": (POINTS, with_value(FACES, 3, [3, 3, 4]), "face #3 has vertex #3 twice"),
    "face twice": (POINTS, np.concatenate([FACES, FACES[:1]]),
                   "face #0 and face #8 run along the edge from vertex #0 to vertex #2"),
    "not oriented": (POINTS, with_value(FACES, 4, FACES[4, ::-1]), "not oriented alike"),
    "three faces": (np.concatenate([POINTS, [[2., 2., 0.]]]), np.concatenate([FACES, [[0, 2, 6]]]), "same direction"),
    "two fans": (np.concatenate([POINTS, POINTS[1:] + [2., 0., 0.]]),
                 np.concatenate([FACES, np.where(FACES == 1, 0, FACES + 5 + (FACES == 0))]), "not manifold"),
    "no area": (POINTS * [1., 0., 0.], FACES, r"face #0 \(vertices 0 2 4\) has no area"),
}


@pytest.mark.filterwarnings("ignore:overflow encountered in cast")
@pytest.mark.parametrize("name", BAD_MESHES)
def test_meshes(name):
    points, faces, cause = BAD_MESHES[name]
    with pytest.raises(cut_locus.InvalidInput, match=cause):
        cut_locus.compute(points, faces, 1)
    with pytest.raises(ValueError):
        cut_locus.exact_geodesic_distances(points, faces, 1)


CAUSES = {
    "not a number": cut_locus.Cause.INVALID_COORDINATE,
    "vertex twice": cut_locus.Cause.NO_TRIANGLE,
    "face twice": cut_locus.Cause.NON_MANIFOLD,
    "no area": cut_locus.Cause.FACE_WITHOUT_AREA
}


@pytest.mark.parametrize("name", CAUSES)
def test_causes_for_programs(name):
    points, faces, _ = BAD_MESHES[name]
    with pytest.raises(cut_locus.InvalidInput) as error:
        cut_locus.compute(points, faces, 1)
    assert error.value.cause == CAUSES[name]


def test_causes_of_sources_and_parameters():
    with pytest.raises(cut_locus.InvalidInput) as error:
        cut_locus.compute(POINTS, FACES, 6)
    assert error.value.cause == cut_locus.Cause.INVALID_SOURCE
    with pytest.raises(cut_locus.InvalidInput) as error:
        cut_locus.compute(POINTS, FACES, 0, solver="no solver")
    assert error.value.cause == cut_locus.Cause.INVALID_PARAMETER


def test_faces_without_area():
    points = with_value(POINTS, 0, POINTS[2])
    # an edge without length gets a millionth of the longest edge beside it
    assert 0. <= cut_locus.exact_geodesic_distances(points, FACES, 2)[0] <= 1.001e-6 * np.sqrt(2.)
    assert len(cut_locus.compute(points, FACES, 1).points) > 0


def test_open_fans():
    points = np.array([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 1.], [0., 1., 2.]])
    faces = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 0, 4]]  # a strip that meets its start in a vertex
    with pytest.raises(cut_locus.InvalidInput, match="vertex #0 is not manifold"):
        cut_locus.compute(points, faces, 1)


@pytest.mark.parametrize("points, faces", [
    (POINTS.astype(complex), FACES),
    (POINTS.astype(str), FACES),
    (POINTS > 0., FACES),
    (POINTS, FACES.astype(np.float64)),
    (POINTS, FACES > 0),
    (POINTS.astype(object), FACES),
    (None, FACES),
])
def test_types(points, faces):
    with pytest.raises((TypeError, cut_locus.InvalidInput)) as error:
        cut_locus.compute(points, faces, 0)
    assert error.type is TypeError or points is None


@pytest.mark.parametrize("source, cause", [
    (6, "no vertex #6: the mesh has 6 vertices"),
    (-1, "no vertex #-1"),
    (2**40, "no vertex #1099511627776"),
    ((8, (1., 0., 0.)), "no face #8: the mesh has 8 faces"),
    ((-2, (1., 0., 0.)), "no face #-2"),
    ((0, (np.nan, 0., 1.)), "not finite"),
    ((0, (-0.5, 1., 0.5)), "negative"),
    ((0, (0., 0., 0.)), "sum up to zero"),
    ([], "range of sources is empty"),
    ([1, 1], "sources 0 and 1 are at the same point"),
    ([1, (0, (np.inf, 0., 0.))], "source 1: .*not finite"),
])
def test_sources(source, cause):
    with pytest.raises(cut_locus.InvalidInput, match=cause):
        cut_locus.compute(POINTS, FACES, source)


@pytest.mark.parametrize("source", [1.5, "0", None, True, {0}, [0.5], np.array([0.]), (0, (1., 0.)), [None], b"1"])
def test_types_of_sources(source):
    if source == {0}:
        assert cut_locus.compute(POINTS, FACES, source).vertex_distance[0] == 0.  # any range of indices
        return
    with pytest.raises(TypeError):
        cut_locus.compute(POINTS, FACES, source)


def test_sources_in_different_components():
    points, faces = np.concatenate([POINTS, POINTS + 5.]), np.concatenate([FACES, FACES + 6])
    with pytest.raises(cut_locus.InvalidInput, match="different components"):
        cut_locus.compute(points, faces, [0, 7])
    with pytest.raises(cut_locus.InvalidInput, match="isolated"):
        cut_locus.compute(points, FACES, 7)


@pytest.mark.parametrize("parameters, cause", [
    ({"solver": "fast"}, "solver must be one of 'exact'.* not 'fast'"),
    ({"method": "best"}, "method must be one of 'default'"),
    ({"curve": "straight"}, "curve must be one of 'edges'"),
    ({"filter_policy": "cut", "method": "laplacian"}, "filter_policy must be one of"),
    ({"laplacian_operator": "none", "method": "laplacian"}, "laplacian_operator must be one of 'quadratic-fit'"),
    ({"gradient_angle_threshold": 1.}, 'gradient_angle_threshold has no meaning for the method "default"'),
    ({"laplacian_threshold": 1.}, "laplacian_threshold has no meaning"),
    ({"filter_policy": "grow"}, "filter_policy has no meaning"),
    ({"number_of_iterations": 2}, "number_of_iterations has no meaning"),
    ({"laplacian_operator": "cotangent"}, "laplacian_operator has no meaning"),
    ({"method": "laplacian", "minimum_branch_width": 0.1}, 'no meaning for the method "laplacian"'),
    ({"method": "laplacian", "minimum_branch_gap": 0.1}, "minimum_branch_gap has no meaning"),
    ({"method": "laplacian", "voronoi": True, "medial": True}, "exclude each other"),
    ({"method": "laplacian", "curve": "edges", "number_of_iterations": 2}, "contradict each other"),
    ({"method": "laplacian", "number_of_iterations": -1}, "must not be negative"),
    ({"solver": "heat", "method": "default"}, "needs the paths"),
    ({"minimum_branch_width": -1.}, "width of a branch must be a number that is not negative"),
    ({"minimum_branch_gap": 4.}, "angle from 0 to pi"),
    ({"minimum_branch_curvature": 13.}, "angle from 0 to 4 pi"),
    ({"method": "laplacian", "minimum_branch_curvature": 1.}, "minimum_branch_curvature has no meaning"),
    ({"minimum_branch_edges": -1}, "must not be negative"),
    ({"minimum_branch_length": float("nan")}, "minimum length of a branch"),
    ({"distances": np.zeros(5)}, r"distances must be an array of the shape \(6,\), and not \(5,\)"),
    ({"distances": np.full(6, -1.)}, "distances hold a distance that is negative"),
    ({"distances": np.zeros(6), "method": "default"}, "needs the paths"),
])
def test_parameters(parameters, cause):
    with pytest.raises(cut_locus.InvalidInput, match=cause) as error:
        cut_locus.compute(POINTS, FACES, 0, **parameters)
    assert "::" not in str(error.value)  # in the words of Python


def test_unknown_parameters():
    with pytest.raises(TypeError):
        cut_locus.compute(POINTS, FACES, 0, minimum_branch_widht=1.)
    with pytest.raises(TypeError):
        cut_locus.compute(POINTS, FACES, 0, progress=3)


def test_order_of_calls():
    computation = cut_locus.CutLocus(POINTS, FACES)
    with pytest.raises(cut_locus.InvalidInput, match="no source"):
        computation.cut_locus()
    computation.set_source(0)
    with pytest.raises(cut_locus.InvalidInput):
        computation.set_source(6)
    assert computation.cut_locus().vertex_distance[0] == 0.  # the source is still the last good one
    with pytest.raises(RuntimeError, match="compute"):
        cut_locus.ExactGeodesics(POINTS, FACES).distance  # noqa: B018


@pytest.mark.parametrize("parameters, cause", [
    ({"error": -1.}, "error must not be negative"),
    ({"error": np.nan}, "error must not be negative"),
    ({"maximum_distance": -1.}, "maximum distance must not be negative"),
])
def test_parameters_of_geodesics(parameters, cause):
    with pytest.raises(cut_locus.InvalidInput, match=cause):
        cut_locus.exact_geodesic_distances(POINTS, FACES, 0, **parameters)
    with pytest.raises(cut_locus.InvalidInput, match="no vertex #6"):
        cut_locus.shortest_paths(POINTS, FACES, 0, 6)
    with pytest.raises(cut_locus.InvalidInput):
        cut_locus.exact_geodesic_distances(POINTS, FACES, [])


def test_parameters_of_disk():
    with pytest.raises(cut_locus.InvalidInput, match="parameterization must be one of 'injective', 'arap'"):
        cut_locus.cut_open(POINTS, FACES, 0, parameterization="flat")
    with pytest.raises(cut_locus.InvalidInput, match="several sources"):
        cut_locus.cut_open(POINTS, FACES, [0, 1])


def soup_of(points, faces):
    """Each face with vertices of its own."""
    return points[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)


def test_weld_joins_a_soup():
    points, faces = meshes.icosphere(2)
    soup = soup_of(points, faces)
    rounded = soup[0] + np.random.default_rng(1).uniform(-1e-9, 1e-9, soup[0].shape)
    turned = np.where(np.arange(len(faces))[:, None] % 3 == 0, soup[1][:, ::-1], soup[1])
    for given in (soup[0], soup[1]), (rounded, turned), (rounded.astype(np.float32), soup[1].astype(np.uint32)):
        V, F, number = cut_locus.weld(*given)
        assert V.shape == points.shape and F.shape == faces.shape and number.shape == (len(given[0]),)
        assert np.abs(V[number] - given[0]).max() < 1e-7
        result = cut_locus.compute(V, F, number[0], method="polyhedral")
        expected = cut_locus.compute(points, faces, faces[0, 0], method="polyhedral")
        assert abs(result.injectivity_radius - expected.injectivity_radius) < 1e-6
        assert np.abs(result.vertex_distance[number] - expected.vertex_distance[faces].ravel()).max() < 1e-6


def test_weld_leaves_what_is_a_mesh():
    for points, faces in (meshes.octahedron(), meshes.icosphere(1)):
        V, F, number = cut_locus.weld(points, faces)
        assert (V == points).all() and (np.sort(F, axis=1) == np.sort(faces, axis=1)).all()
        assert (number == np.arange(len(points))).all()
    V, F, number = cut_locus.weld(np.vstack([POINTS, [[5., 5., 5.]]]), FACES)
    assert len(V) == len(POINTS) and number[-1] == -1


def test_weld_of_nothing():
    for points, faces, cause in ((np.zeros((0, 3)), np.zeros((0, 3), dtype=int), "no vertices"),
                                 (POINTS, np.zeros((0, 3), dtype=int), "no faces"), (0. * POINTS, FACES, "area"),
                                 (with_value(POINTS, 0, np.nan), FACES, "not finite")):
        with pytest.raises(cut_locus.InvalidInput, match=cause):
            cut_locus.weld(points, faces)


def test_a_soup_is_warned_of():
    soup = soup_of(*meshes.icosphere(1))
    with pytest.warns(UserWarning, match="cut_locus.weld"):
        cut_locus.compute(*soup, 0)
    with pytest.warns(UserWarning, match="cut_locus.weld"):
        cut_locus.exact_geodesic_distances(*soup, 0)
    with pytest.raises(cut_locus.InvalidInput, match="cut_locus.weld"):
        cut_locus.compute(POINTS, with_value(FACES, 4, FACES[4, ::-1]), 1)
