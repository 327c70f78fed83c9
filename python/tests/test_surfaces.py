"""Disks in the plane, unfoldings, refinement, files, and the functions for Voronoi diagrams and medial axes."""

import cut_locus
import meshes
import numpy as np
import pytest


def lengths_of_corners(unfolding):
    return np.linalg.norm(unfolding.corners, axis=1)


def signed_area(polygon):
    following = np.roll(polygon, -1, axis=0)
    return 0.5 * (polygon[:, 0] * following[:, 1] - polygon[:, 1] * following[:, 0]).sum()


def area(points, faces):
    p, q, r = (points[faces[:, i]] for i in range(3))
    return 0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1).sum()


def test_disks_are_laid_flat_and_measured():
    points, faces = meshes.torus(16, 8)
    disk = cut_locus.cut_open(points, faces, 0)
    assert cut_locus.layout_quality(*disk).is_injective  # the default
    uv = cut_locus.flatten_disk(disk.vertices, disk.faces)
    quality = cut_locus.layout_quality(disk.vertices, disk.faces, uv)
    assert quality.is_injective and quality.flipped_faces == quality.overlapping_faces == 0
    assert 1. < quality.area_distortion < quality.symmetric_dirichlet_energy < 3.
    turned = uv * [1., -1.]
    assert cut_locus.layout_quality(disk.vertices, disk.faces, turned).flipped_faces == len(disk.faces)
    with pytest.raises(cut_locus.InvalidInput, match="one row for each of the"):
        cut_locus.layout_quality(disk.vertices, disk.faces, uv[1:])
    with pytest.raises(cut_locus.InvalidInput):
        cut_locus.flatten_disk(points, faces)  # which is no disk


def test_what_is_flat_stays_as_it_is():
    x, y = np.meshgrid(np.arange(6.), np.arange(5.), indexing="ij")
    points = np.stack([x, y, 0.3 * x], axis=-1).reshape(-1, 3)
    faces = meshes.grid(6, 5, False, False)
    quality = cut_locus.layout_quality(points, faces, cut_locus.flatten_disk(points, faces))
    assert quality.symmetric_dirichlet_energy == pytest.approx(1., abs=1e-6)


def test_source_unfolding_of_a_cube():
    points, faces = meshes.cube()
    source = (0, (0.2, 0.3, 0.5))
    unfolding = cut_locus.source_unfolding(points, faces, source)
    assert signed_area(unfolding.corners) == pytest.approx(area(points, faces))
    # edges that are glued are equally long, and corners as far away as the points they are copies of
    sides = np.linalg.norm(np.roll(unfolding.corners, -1, axis=0) - unfolding.corners, axis=1)
    assert (unfolding.glued_to >= 0).all() and np.array_equal(unfolding.glued_to[unfolding.glued_to], np.arange(len(sides)))
    assert sides[unfolding.glued_to] == pytest.approx(sides)
    distance = cut_locus.exact_geodesic_distances(points, faces, source)
    at_vertex = [(i, v) for i, p in enumerate(unfolding.points) for v in np.flatnonzero((points == p).all(axis=1))]
    assert {v for _, v in at_vertex} == set(range(len(points)))
    assert [lengths_of_corners(unfolding)[i] for i, _ in at_vertex] == pytest.approx(
        [distance[v] for _, v in at_vertex], abs=1e-5)
    assert unfolding.fold_lines.shape[1:] == (2, 2)
    with pytest.raises(cut_locus.InvalidInput, match="one source"):
        cut_locus.source_unfolding(points, faces, [0, 1])
    with pytest.raises(cut_locus.InvalidInput, match=r"flattened by cut_open\(\)"):  # where paths bend
        cut_locus.source_unfolding(*meshes.torus(8, 6), 0)


def test_isolines_become_edges_and_sources():
    points, faces = meshes.bumpy_sphere(2)
    distance = cut_locus.exact_geodesic_distances(points, faces, 0)
    lines = cut_locus.isolines(points, faces, 0, [0.4 * distance.max()])
    refined = cut_locus.refine_along_polylines(points, faces, lines)
    assert area(refined.vertices, refined.faces) == pytest.approx(area(points, faces))
    old = refined.vertex_origin >= 0
    assert np.array_equal(refined.vertices[old], points[refined.vertex_origin[old]])
    sides = np.sort(refined.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert len(refined.curves) == len(lines)
    for curve in refined.curves:
        assert {tuple(edge) for edge in np.sort(curve, axis=1)} <= {tuple(side) for side in sides}
    to_curve = cut_locus.exact_geodesic_distances(refined.vertices, refined.faces, source_curves=refined.curves)
    of_vertex = to_curve[np.flatnonzero(refined.vertex_origin == 0)]
    assert of_vertex == pytest.approx(0.4 * distance.max(), rel=1e-3)
    path, = cut_locus.shortest_paths(points, faces, 0, int(distance.argmax()))
    assert len(cut_locus.refine_along_polylines(points, faces, [path, *lines]).curves) == 1  # they cross
    with pytest.raises(cut_locus.InvalidInput):
        cut_locus.refine_along_polylines(points, faces, [path._replace(faces=path.faces[::-1])])


@pytest.mark.parametrize("extension", [".polylines.txt", ".obj", ".ply", ".vtp"])
def test_results_are_written(tmp_path, extension):
    result = cut_locus.compute(*meshes.torus(12, 8), 0)
    file = tmp_path / ("curve" + extension)
    result.write(file)
    text = file.read_text()
    if extension == ".obj":
        vertices = [line.split()[1:4] for line in text.splitlines() if line.startswith("v ")]
        assert np.array_equal(np.array(vertices, float), result.points)
    assert len(text) > 20 * len(result.points)
    with pytest.raises(cut_locus.InvalidInput, match="must end with one of"):
        result.write(tmp_path / "curve.stl")
    with pytest.raises(OSError, match="cannot write"):
        result.write(tmp_path / "no folder" / ("curve" + extension))


def test_voronoi_and_medial_axis_are_cut_loci():
    points, faces = meshes.torus(16, 8)
    result = cut_locus.voronoi(points, faces, [0, 40, 90])
    expected = cut_locus.compute(points, faces, [0, 40, 90], voronoi=True)
    assert np.array_equal(result.points, expected.points) and len(result.points) > 0
    assert (result.edge_sources[:, 0] != result.edge_sources[:, 1]).all()
    assert result.cell_area.sum() == pytest.approx(area(points, faces))

    points, faces = meshes.cylinder(12, 6, 2.)
    axis = cut_locus.medial_axis(points, faces)
    assert np.array_equal(axis.points, cut_locus.compute(points, faces, source_border=True).points)
    assert axis.distance.max() == pytest.approx(1.)  # of the middle from both ends
    rims = [[6 * i + row for i in [*range(12), 0]] for row in (0, 5)]
    assert cut_locus.medial_axis(points, faces, rims).length == pytest.approx(axis.length)
