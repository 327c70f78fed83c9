"""Exact geodesic distances and paths."""

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


def test_same_as_cut_locus(bumpy):
    result = cut_locus.compute(*bumpy, (3, (0.3, 0.3, 0.4)))
    distance = cut_locus.exact_geodesic_distances(*bumpy, (3, (0.3, 0.3, 0.4)))
    assert result.vertex_distance == pytest.approx(distance, abs=1e-12)
