"""Exact geodesic distances, paths, and the logarithmic map."""

import itertools
import math

import cut_locus
import meshes
import numpy as np
import pytest


@pytest.fixture(scope="module")
def bumpy():
    return meshes.bumpy_sphere(3)


def test_plane():
    x, y = np.meshgrid(np.linspace(0., 3., 7), np.linspace(0., 2., 5), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), 0. * x.ravel()], axis=1)
    faces = meshes.grid(7, 5, False, False)
    inside = np.array([0.2, 0.5, 0.3]) @ points[faces[9]]
    distance = cut_locus.exact_geodesic_distances(points, faces, (9, (0.2, 0.5, 0.3)))
    assert distance.dtype == np.float64 and distance.shape == (35,)
    assert distance == pytest.approx(np.linalg.norm(points - inside, axis=1), abs=1e-12)


def test_paths(bumpy):
    points, faces = bumpy
    targets = [100, (500, (0.2, 0.3, 0.5)), 0, 7]
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(0, targets=targets)
    paths = geodesics.paths()
    assert geodesics.target_distance == pytest.approx([path.length for path in paths], abs=1e-12)
    assert geodesics.target_distance[[0, 2, 3]] == pytest.approx(geodesics.distance[[100, 0, 7]])
    for path, target in zip(paths, targets):
        located = np.einsum("ij,ijk->ik", path.barycentric, points[faces[path.faces]])
        assert located == pytest.approx(path.points, abs=1e-12)
        start = points[target] if isinstance(target, int) else np.array(target[1]) @ points[faces[target[0]]]
        assert path.points[0] == pytest.approx(start) and path.points[-1] == pytest.approx(points[0])
        # between two points, it stays in one face: both are on its vertices and edges, or in it
        for i in range(len(path.faces) - 1):
            used = [set(faces[f][b > 1e-12]) for f, b in zip(path.faces[i:i + 2], path.barycentric[i:i + 2])]
            assert any((used[0] | used[1]) <= set(face) for face in faces)
    assert paths[2].length == 0.
    again = cut_locus.shortest_paths(points, faces, 0, 100)
    assert len(again) == 1 and np.array_equal(again[0].points, paths[0].points)
    assert np.array_equal(geodesics.path(100).points, paths[0].points)


def test_points_named_afterwards(bumpy):
    points, faces = bumpy
    random = np.random.default_rng(1)
    at = random.integers(len(faces), size=40)
    barycentric = random.dirichlet([1., 1., 1.], 40)
    barycentric[::5, 0] = 0.  # on edges
    barycentric[7] = 0., 1., 0.
    barycentric /= barycentric.sum(axis=1)[:, None]
    targets = [(int(f), tuple(b)) for f, b in zip(at, barycentric)]
    sources = [0, (40, (0.1, 0.1, 0.8))]
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(sources, targets=targets, directions=True)
    found = geodesics.find(at, barycentric)
    assert found.distance == pytest.approx(geodesics.target_distance, rel=1e-12)
    assert np.array_equal(found.nearest_source, geodesics.target_nearest_source)
    assert found.log_map == pytest.approx(geodesics.target_log_map, abs=1e-10)
    for target, path, distance in zip(targets, geodesics.paths(), found.distance):
        same = geodesics.path(target)
        assert same.length == pytest.approx(distance, rel=1e-12)
        assert same.points[[0, -1]] == pytest.approx(path.points[[0, -1]], abs=1e-12)
    geodesics.compute(sources, maximum_distance=1.)
    found = geodesics.find(at, barycentric)
    near = geodesics.find(at, barycentric).distance < 1.
    assert found.log_map is None and 0 < near.sum() < 40
    assert np.isinf(found.distance[~near]).all() and np.all((found.nearest_source == -1) == ~near)
    geodesics.compute(source_curves=[faces[7][[0, 1, 2, 0]]], targets=targets)
    assert geodesics.find(at, barycentric).distance == pytest.approx(geodesics.target_distance, abs=1e-12)
    empty = geodesics.find([], np.empty((0, 3)))
    assert empty.distance.shape == (0,)
    with pytest.raises(cut_locus.InvalidInput, match="a face for each row"):
        geodesics.find([1, 2], [[1., 0., 0.]])
    with pytest.raises(cut_locus.InvalidInput, match="barycentric"):
        geodesics.find([1], [[1., 1., 0.]])
    with pytest.raises(cut_locus.InvalidInput, match="face"):
        geodesics.find([len(faces)], [[1., 0., 0.]])
    with pytest.raises(TypeError, match="faces must be whole numbers"):
        geodesics.find([1.5], [[1., 0., 0.]])
    with pytest.raises(TypeError, match="a path has one target"):
        geodesics.path([1, 2])


def test_no_path():
    points, faces = meshes.octahedron()
    both = np.concatenate([points, points + 5.]), np.concatenate([faces, faces + 6])
    path, = cut_locus.shortest_paths(*both, 0, 8)
    assert path.points.shape == (0, 3) and path.faces.shape == (0,) and path.length == np.inf
    geodesics = cut_locus.ExactGeodesics(*both)
    geodesics.compute(0)
    assert np.isinf(geodesics.distance[6:]).all() and np.all(geodesics.nearest_source == [0] * 6 + [-1] * 6)


def test_several_sources(bumpy):
    points, faces = bumpy
    sources = [3, (40, (0.1, 0.1, 0.8)), 200]
    geodesics = cut_locus.ExactGeodesics(points, faces)
    single = []
    for source in sources:
        geodesics.compute(source)
        single.append(geodesics.distance)
    geodesics.compute(sources)
    assert geodesics.distance == pytest.approx(np.min(single, axis=0), abs=1e-12)
    at_nearest = np.array(single)[geodesics.nearest_source, np.arange(len(points))]
    assert at_nearest == pytest.approx(geodesics.distance, abs=1e-12)
    assert set(geodesics.nearest_source) == {0, 1, 2}


def test_excluded_faces(bumpy):
    points, faces = bumpy
    middle = points[faces].mean(axis=1)
    excluded = (np.abs(middle[:, 2]) < 0.3) & (middle[:, 0] < 0.3)  # a belt with a gate
    source = int(np.argmax(points[:, 2]))
    distance = cut_locus.exact_geodesic_distances(points, faces, source, excluded_faces=excluded)
    left = np.unique(faces[~excluded])
    number = np.full(len(points), -1)
    number[left] = np.arange(len(left))
    expected = cut_locus.exact_geodesic_distances(points[left], number[faces[~excluded]], int(number[source]))
    assert np.array_equal(distance[left], expected) and np.isinf(np.delete(distance, left)).all()
    assert np.isfinite(expected).all() and len(left) < len(points)
    by_number = cut_locus.ExactGeodesics(points, faces, excluded_faces=np.flatnonzero(excluded))
    by_number.compute(source, directions=True, targets=[int(np.argmin(points[:, 2]))])
    assert np.array_equal(by_number.distance, distance)
    path, = by_number.paths()
    assert not excluded[path.faces].any() and path.points[:, 0].max() > 0.2
    assert np.array_equal(cut_locus.log_map(points, faces, source, excluded_faces=excluded), by_number.log_map,
                          equal_nan=True)
    assert np.array_equal(cut_locus.exact_geodesic_distances(points, faces, source, excluded_faces=[]),
                          cut_locus.exact_geodesic_distances(points, faces, source))
    place = [[0.5, 0.]]
    assert np.array_equal(cut_locus.exp_map(points, faces, source, place, excluded_faces=excluded).points,
                          by_number.exp_map(place).points)
    ends = cut_locus.shortest_paths(points, faces, source, int(np.argmin(points[:, 2])), excluded_faces=excluded)
    assert np.array_equal(ends[0].points, path.points)
    for line in cut_locus.isolines(points, faces, source, [2.], excluded_faces=excluded):
        assert not excluded[line.faces].any()
    inside = np.flatnonzero(excluded)[0]
    for bad in (int(np.flatnonzero(np.isinf(distance))[0]), (inside, (0.2, 0.3, 0.5))):
        with pytest.raises(cut_locus.InvalidInput, match="excluded"):
            by_number.compute(bad)
    with pytest.raises(cut_locus.InvalidInput, match="in an excluded face"):
        by_number.compute(source, targets=[(inside, (0.2, 0.3, 0.5))])
    for bad, message in ((excluded[1:], "one bool for each of the"), ([len(faces)], "numbers 0 to"),
                         ([-1], "numbers 0 to"), (np.full(len(faces), True), "all faces of the mesh are excluded")):
        with pytest.raises(cut_locus.InvalidInput, match=message):
            cut_locus.ExactGeodesics(points, faces, excluded_faces=bad)
    with pytest.raises(TypeError, match="excluded_faces must be"):
        cut_locus.ExactGeodesics(points, faces, excluded_faces=[0.5])


def test_border_as_source():
    x, y = np.meshgrid(np.linspace(0., 3., 7), np.linspace(0., 2., 5), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), 0. * x.ravel()], axis=1)
    faces = meshes.grid(7, 5, False, False)
    sides = np.minimum(np.minimum(x, 3. - x), np.minimum(y, 2. - y)).ravel()
    assert cut_locus.exact_geodesic_distances(points, faces, source_border=True) == pytest.approx(sides, abs=1e-12)
    targets = [17, (9, (0.2, 0.5, 0.3)), (2, (0.3, 0.4, 0.3))]
    paths = cut_locus.shortest_paths(points, faces, None, targets, source_border=True)
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(source_border=True, targets=targets)
    assert geodesics.target_distance == pytest.approx([path.length for path in paths], abs=1e-12)
    for path in paths:
        x, y, _ = path.points[-1]
        assert min(x, 3. - x, y, 2. - y) == pytest.approx(0., abs=1e-9)


def test_curves_as_sources(bumpy):
    points, faces = bumpy
    around = faces[7].tolist()
    curve = [*around, around[0]]
    # dense points on a curve are no nearer, and farther by half of their distance at most
    k = 40
    dense = [(7, tuple(np.roll([1. - t, t, 0.], i))) for i in range(3) for t in np.arange(k) / k]
    upper = cut_locus.exact_geodesic_distances(points, faces, dense)
    half = 0.5 / k * max(meshes.length_of(points, np.array([around, np.roll(around, 1)]).T))
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute([3, 500], source_curves=[curve], targets=[(7, (0.3, 0.3, 0.4)), 500, around[0]])
    from_points = cut_locus.exact_geodesic_distances(points, faces, [3, 500])
    alone = cut_locus.exact_geodesic_distances(points, faces, source_curves=[curve])
    assert np.all(alone <= upper + 1e-12) and np.all(alone >= upper - half)
    assert geodesics.distance == pytest.approx(np.minimum(alone, from_points), abs=1e-12)
    assert np.array_equal(geodesics.nearest_source == 2, alone < from_points)
    assert geodesics.target_nearest_source.tolist() == [2, 1, 2]


def test_curves_are_refused(bumpy):
    geodesics = cut_locus.ExactGeodesics(*bumpy)
    with pytest.raises(TypeError, match="there must be sources"):
        geodesics.compute()
    with pytest.raises(cut_locus.InvalidInput, match="no border"):
        geodesics.compute(source_border=True)
    curve = bumpy[1][0][:2]
    for options in ({"error": 0.01}, {"directions": True}):
        with pytest.raises(cut_locus.InvalidInput, match="leave out the curves"):
            geodesics.compute(source_curves=[curve], **options)


def test_bounded_error(bumpy):
    points, faces = bumpy
    exact = cut_locus.exact_geodesic_distances(points, faces, 0)
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(0, error=0.01)
    too_long = geodesics.distance - exact
    assert np.all(too_long > -1e-12) and np.all(too_long <= 0.01 * exact + 1e-12) and too_long.max() > 1e-9
    assert np.all(too_long <= geodesics.distance_error + 1e-12)
    with pytest.raises(cut_locus.InvalidInput, match="must be zero"):
        geodesics.path(5)
    geodesics.compute(0)
    assert np.array_equal(geodesics.distance, exact) and not geodesics.distance_error.any()


def test_maximum_distance(bumpy):
    exact = cut_locus.exact_geodesic_distances(*bumpy, 0)
    near = cut_locus.exact_geodesic_distances(*bumpy, 0, maximum_distance=1.)
    assert np.array_equal(near[exact <= 1.], exact[exact <= 1.])
    assert np.isinf(near[exact > 1.]).all() and (exact > 1.).any()


@pytest.mark.parametrize("sources", [17, 3, 0, (9, (0.2, 0.5, 0.3)), (9, (0.4, 0.6, 0.)), [17, (30, (0.2, 0.5, 0.3))]])
def test_log_map_of_plane(sources):
    x, y = np.meshgrid(np.linspace(0., 3., 7), np.linspace(0., 2., 5), indexing="ij")
    points = np.stack([x.ravel(), y.ravel()**1.2, 0. * x.ravel()], axis=1)
    faces = meshes.grid(7, 5, False, False)

    def position(source):
        return points[source] if isinstance(source, int) else np.array(source[1]) @ points[faces[source[0]]]

    targets = [4, (20, (0.1, 0.2, 0.7)), 17]
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(sources, targets=targets, directions=True)
    at = np.array([position(s) for s in (sources if isinstance(sources, list) else [sources])])[:, :2]
    axes = np.diff(points[geodesics.source_axes], axis=1)[:, 0, :2]
    axes /= np.linalg.norm(axes, axis=1)[:, None]

    def seen(p, nearest):
        d, a = p[:, :2] - at[nearest], axes[nearest]
        return np.stack([(a * d).sum(axis=1), a[:, 0] * d[:, 1] - a[:, 1] * d[:, 0]], axis=1)

    expected = seen(points, geodesics.nearest_source)
    assert geodesics.log_map.shape == (35, 2) and geodesics.log_map == pytest.approx(expected, abs=1e-9)
    assert cut_locus.log_map(points, faces, sources) == pytest.approx(expected, abs=1e-9)
    of_targets = np.array([position(t) for t in targets])
    nearest = np.linalg.norm(of_targets[:, None, :2] - at, axis=2).argmin(axis=1)
    assert geodesics.target_log_map == pytest.approx(seen(of_targets, nearest), abs=1e-9)


def test_log_map(bumpy):
    both = np.concatenate([bumpy[0], bumpy[0] + 5.]), np.concatenate([bumpy[1], bumpy[1] + len(bumpy[0])])
    distance = cut_locus.exact_geodesic_distances(*both, 3)
    place = cut_locus.log_map(*both, 3)
    reached = np.isfinite(distance)
    assert np.linalg.norm(place[reached], axis=1) == pytest.approx(distance[reached], abs=1e-12)
    assert np.isnan(place[~reached]).all() and np.array_equal(place[3], [0., 0.]) and not reached.all()
    # the first face has the axis; angles are scaled, so that the neighbors around are in order, once around
    geodesics = cut_locus.ExactGeodesics(*bumpy)
    geodesics.compute(3, directions=True)
    axis, = geodesics.source_axes
    first = bumpy[1][(bumpy[1] == 3).any(axis=1)][0].tolist()
    assert axis.tolist() == [3, first[(first.index(3) + 1) % 3]]
    x, y = geodesics.log_map[axis[1]]
    assert x > 0. and y == pytest.approx(0., abs=1e-12) and geodesics.target_log_map.shape == (0, 2)
    turned = geodesics.log_map @ [1., 1.j]
    around = [np.angle(turned[b] / turned[a]) for t in bumpy[1][(bumpy[1] == 3).any(axis=1)].tolist()
              for a, b in [[v for v in t[t.index(3):] + t[:t.index(3)] if v != 3]]]
    assert min(around) > 0. and sum(around) == pytest.approx(2. * np.pi)


def test_log_map_needs_directions(bumpy):
    geodesics = cut_locus.ExactGeodesics(*bumpy)
    geodesics.compute(3)
    with pytest.raises(cut_locus.InvalidInput, match="directions=True"):
        geodesics.log_map
    with pytest.raises(cut_locus.InvalidInput, match="must be zero"):
        geodesics.compute(3, error=0.1, directions=True)


def test_arrival_direction(bumpy):
    """It is the direction of the last piece of the path, from the vertex on."""
    points, faces = bumpy
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(3)
    direction = geodesics.arrival_direction
    assert np.isnan(direction[3]).all() and direction.shape == points.shape
    for v in range(4, len(points), 7):
        path = geodesics.path(v)
        step = path.points[1] - path.points[0]
        assert direction[v] == pytest.approx(step / np.linalg.norm(step), abs=1e-7)
    geodesics.compute(3, maximum_distance=0.5)
    assert (np.isnan(geodesics.arrival_direction[:, 0]) == ~((geodesics.distance > 0.) & (geodesics.distance < 1.))).all()
    far = int(np.argmax(cut_locus.exact_geodesic_distances(points, faces, 3)))
    assert cut_locus.shortest_paths(points, faces, 3, far, maximum_distance=0.5)[0].length == math.inf
    geodesics.compute(3, error=0.1)
    with pytest.raises(cut_locus.InvalidInput, match="need exact distances"):
        geodesics.arrival_direction  # noqa: B018


@pytest.mark.parametrize("source", [3, (40, (0.2, 0.3, 0.5))])
def test_exp_map_is_the_inverse_of_log_map(bumpy, source):
    points, faces = bumpy
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(source, directions=True)
    near = np.flatnonzero(geodesics.distance < 0.5)
    found = geodesics.exp_map(geodesics.log_map[near])
    assert len(near) > 20 and found.points == pytest.approx(points[near], abs=1e-9)
    located = np.einsum("ij,ijk->ik", found.barycentric, points[faces[found.faces]])
    assert located == pytest.approx(found.points, abs=1e-12)
    again = cut_locus.exp_map(points, faces, source, geodesics.log_map[near].tolist())
    assert again.points == pytest.approx(points[near], abs=1e-9)
    with pytest.raises(cut_locus.InvalidInput, match=r"places must be an array of the shape \(n, 2\)"):
        geodesics.exp_map([0., 1.])
    with pytest.raises(cut_locus.InvalidInput, match="no source 1"):
        geodesics.exp_map([[0., 1.]], source=1)


def test_isolines(bumpy):
    points, faces = bumpy
    levels = [0.3, 1., 1.5]
    lines = cut_locus.isolines(points, faces, 3, levels, maximum_deviation=1e-3)
    assert {line.level for line in lines} == set(levels) and all(line.is_closed for line in lines)
    targets = [(int(f), tuple(b)) for line in lines for f, b in zip(line.faces, line.barycentric)]
    expected = [line.level for line in lines for _ in line.faces]
    geodesics = cut_locus.ExactGeodesics(points, faces)
    geodesics.compute(3, targets=targets)
    assert geodesics.target_distance == pytest.approx(expected, abs=1e-9)
    for line in lines:
        assert np.array_equal(line.points[0], line.points[-1])
        located = np.einsum("ij,ijk->ik", line.barycentric, points[faces[line.faces]])
        assert located == pytest.approx(line.points, abs=1e-12)
    assert max(len(line.points) for line in cut_locus.isolines(points, faces, 3, 1.)) > 50
    # what is beyond the largest level is not computed, and changes nothing
    geodesics.compute(3, isolines=True)
    for line, other in itertools.zip_longest(lines, geodesics.isolines(levels, maximum_deviation=1e-3)):
        assert line.level == other.level and line.points == pytest.approx(other.points, abs=1e-9)
    assert cut_locus.isolines(points, faces, 3, []) == []


def test_isolines_of_plane():
    x, y = np.meshgrid(np.linspace(0., 3., 7), np.linspace(0., 2., 5), indexing="ij")
    plane = np.stack([x.ravel(), y.ravel(), 0. * x.ravel()], axis=1), meshes.grid(7, 5, False, False)
    circle, = cut_locus.isolines(*plane, (9, (0.2, 0.5, 0.3)), 0.15, maximum_deviation=1e-6)
    segments = np.diff(circle.points, axis=0)
    assert circle.is_closed and np.linalg.norm(segments, axis=1).sum() == pytest.approx(0.3 * np.pi, abs=1e-5)
    square, = cut_locus.isolines(*plane, None, 0.3, source_border=True)
    assert np.linalg.norm(np.diff(square.points, axis=0), axis=1).sum() == pytest.approx(10. - 2.4, abs=1e-4)


def test_isolines_are_refused(bumpy):
    geodesics = cut_locus.ExactGeodesics(*bumpy)
    geodesics.compute(0)
    with pytest.raises(cut_locus.InvalidInput, match="compute\\(\\) takes isolines=True"):
        geodesics.isolines([1.])
    geodesics.compute(0, isolines=True)
    for levels, deviation, text in (([0.], None, "no isoline"), ([np.nan], None, "no isoline"), ([1.], 0., "positive")):
        with pytest.raises(cut_locus.InvalidInput, match=text):
            geodesics.isolines(levels, maximum_deviation=deviation)
    for level in (0., -1., np.nan, np.inf):
        with pytest.raises(cut_locus.InvalidInput, match="no isoline"):
            cut_locus.isolines(*bumpy, 0, [1., level])
    with pytest.raises(cut_locus.InvalidInput, match="need exact distances"):
        geodesics.compute(0, isolines=True, error=0.1)


def test_same_as_cut_locus(bumpy):
    result = cut_locus.compute(*bumpy, (3, (0.3, 0.3, 0.4)))
    distance = cut_locus.exact_geodesic_distances(*bumpy, (3, (0.3, 0.3, 0.4)))
    assert result.vertex_distance == pytest.approx(distance, abs=1e-12)
