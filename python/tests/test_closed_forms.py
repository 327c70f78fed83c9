"""Surfaces whose distances and cut loci are known."""

import cut_locus
import meshes
import numpy as np
import pytest


@pytest.mark.parametrize("source", [0, 7, (3, (0.2, 0.3, 0.5))])
def test_sphere(source):
    points, faces = meshes.icosphere(4)
    edge = meshes.length_of(points, faces[:, :2]).max()
    result = cut_locus.compute(points, faces, source)
    assert result.genus == 0 and result.border_loops == 0 and result.cycles == 0
    assert result.injectivity_radius == pytest.approx(np.pi, abs=edge)
    antipode = -result.source_points[0]
    assert np.linalg.norm(result.injectivity_point - antipode) < 1.5 * edge
    if isinstance(source, int):
        angle = np.arccos(np.clip(points @ points[source], -1., 1.))
        assert np.all(result.vertex_distance <= angle + 1e-12)  # the polyhedron is inside of the sphere
        assert np.abs(result.vertex_distance - angle).max() < edge**2


def test_sphere_converges():
    # along edges of the mesh, the curve is the vertex opposite to the source
    errors = [np.pi - cut_locus.compute(*meshes.icosphere(level), 0, curve="edges").injectivity_radius
              for level in (2, 3, 4)]
    assert 3.5 < errors[0] / errors[1] < 4.5 and 3.5 < errors[1] / errors[2] < 4.5  # the square of the edges


@pytest.mark.parametrize("method", ["default", "polyhedral"])
def test_flat_cylinder(method):
    columns, rows, height = 12, 9, 10.
    points, faces = meshes.cylinder(columns, rows, height)
    middle = rows // 2
    result = cut_locus.compute(points, faces, middle, method=method, curve="faces")
    around = np.minimum(np.arange(columns), columns - np.arange(columns))[:, None]
    along = np.linspace(0., height, rows)[None, :] - points[middle, 2]
    assert result.vertex_distance == pytest.approx(np.hypot(around, along).ravel(), abs=1e-12)
    # the line opposite to the source
    assert result.points[:, :2] == pytest.approx(np.tile(-points[middle, :2], (len(result.points), 1)), abs=1e-9)
    assert result.length == pytest.approx(height)
    assert result.injectivity_radius == pytest.approx(columns / 2)
    assert result.strength.max() == pytest.approx(np.pi)
    assert (result.border_loops, result.genus, result.leaves) == (2, 0, 2)


@pytest.mark.parametrize("method", ["default", "polyhedral"])
def test_cube(method):
    points, faces = meshes.cube()
    center = (0, (0.5, 0., 0.5))  # of the face z = 0: the diagonal of its two triangles
    result = cut_locus.compute(points, faces, center, method=method, curve="faces")
    assert result.source_points[0] == pytest.approx([0.5, 0.5, 0.])
    # four edges of the cube, and two diagonals of the opposite face
    assert result.length == pytest.approx(4. + 2. * 2.**0.5)
    assert result.injectivity_radius == pytest.approx(0.5**0.5)
    assert result.injectivity_lower_bound == pytest.approx(0.5**0.5, abs=2e-4)  # a symmetric source is moved
    assert (result.leaves, result.branchings, result.cycles) == (4, 1, 0)
    assert result.distance.max() == pytest.approx(2.)
    assert set(result.mesh_vertices) - {-1} == set(range(8))
    assert cut_locus.exact_geodesic_distances(points, faces, 0)[7] == pytest.approx(5.**0.5)


def test_torus():
    points, faces = meshes.torus(60, 30)
    edge = meshes.length_of(points, faces[:, :2]).max()
    result = cut_locus.compute(points, faces, 0, curve="faces")  # on the outer equator
    assert (result.genus, result.cycles, result.components) == (1, 2, 1)
    assert result.injectivity_radius == pytest.approx(np.pi, abs=edge)
    # the opposite meridian, the inner equator, and the outer one from the first conjugate points on
    x, y, z = result.points.T
    off_meridian = np.where(x < 0., np.abs(y), np.inf)
    off_inner, off_outer = (np.hypot(np.hypot(x, y) - radius, z) for radius in (1., 3.))
    assert np.min([off_meridian, off_inner, off_outer], axis=0).max() < edge
    assert result.distance[off_outer < 0.5 * edge].min() > np.pi * 3.**0.5 - edge
    for near in (off_meridian, off_inner, off_outer):
        assert (near < 0.1 * edge).sum() > 10


def test_several_sources():
    points, faces = meshes.octahedron()
    result = cut_locus.compute(points, faces, [4, 5], curve="faces", voronoi=True)
    assert result.length == pytest.approx(4. * 2.**0.5)  # the equator is half way between the poles
    assert np.all(np.abs(result.points[:, 2]) < 1e-12)
    assert np.all(result.edge_sources == [0, 1]) and result.strength == pytest.approx(2. * np.pi)
    assert result.cycles == 1
    assert result.nearest_source[4] == 0 and result.nearest_source[5] == 1
    whole = cut_locus.compute(points, faces, [4, 5], curve="faces", minimum_branch_width=0.)
    assert whole.cycles == 1 and whole.length >= result.length


def test_several_sources_on_a_torus():
    points, faces = meshes.torus(40, 20)
    result = cut_locus.compute(points, faces, [0, 311, (77, (0.2, 0.3, 0.5))])
    assert result.cycles == 2 * 1 - 1 + 3
    assert len(result.source_points) == 3
    assert set(result.nearest_source) == {0, 1, 2}
    single = [cut_locus.exact_geodesic_distances(points, faces, s) for s in (0, 311, (77, (0.2, 0.3, 0.5)))]
    assert result.vertex_distance == pytest.approx(np.min(single, axis=0), abs=1e-12)
    assert np.all(np.take_along_axis(np.array(single), result.nearest_source[None, :], axis=0)[0]
                  < result.vertex_distance + 1e-9)
