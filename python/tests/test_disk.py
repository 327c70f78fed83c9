"""Surfaces cut open along cut loci."""

import cut_locus
import meshes
import numpy as np
import pytest


def assert_disk(disk):
    """A connected manifold with Euler's characteristic 1 and one border loop."""
    directed = {(a, b) for f in disk.faces.tolist() for a, b in zip(f, f[1:] + f[:1])}
    assert len(directed) == 3 * len(disk.faces)
    border = {a: b for a, b in directed if (b, a) not in directed}
    assert len(border) == sum((b, a) not in directed for a, b in directed)
    edges = (len(directed) + len(border)) // 2
    assert len(np.unique(disk.faces)) == len(disk.vertices)
    assert len(disk.vertices) - edges + len(disk.faces) == 1
    start = v = next(iter(border))
    steps = 0
    while steps == 0 or v != start:
        v = border[v]
        steps += 1
    assert steps == len(border)


def area(points, faces):
    p, q, r = (points[faces[:, i]] for i in range(3))
    return 0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1).sum()


@pytest.mark.parametrize("curve", ["edges", "faces"])
@pytest.mark.parametrize("parameterization", ["injective", "arap", "lscm", "convex", None])
def test_torus(curve, parameterization):
    points, faces = meshes.torus(24, 12)
    disk = cut_locus.cut_open(points, faces, 3, curve=curve, parameterization=parameterization)
    assert_disk(disk)
    vertices, disk_faces, uv = disk
    assert vertices is disk.vertices and disk_faces is disk.faces and uv is disk.uv
    old = disk.vertex_origin >= 0
    assert old.all() == (curve == "edges")
    assert np.array_equal(points[disk.vertex_origin[old]], vertices[old])
    assert set(disk.vertex_origin[old]) == set(range(len(points)))
    assert area(vertices, disk_faces) == pytest.approx(area(points, faces))
    if curve == "edges":
        assert np.array_equal(disk.vertex_origin[disk_faces], faces[disk.face_origin])  # the same corner comes first
    else:
        parts = np.bincount(disk.face_origin, weights=[area(vertices, f[None]) for f in disk_faces])
        assert parts == pytest.approx([area(points, f[None]) for f in faces])
    if parameterization is None:
        assert uv is None
        with pytest.raises(cut_locus.InvalidInput, match="not flat"):
            disk.is_flipped  # noqa: B018
        return
    flat = np.concatenate([uv, np.zeros((len(uv), 1))], axis=1)
    assert area(flat, disk_faces[~disk.is_flipped]) - area(flat, disk_faces[disk.is_flipped]) == pytest.approx(
        area(points, faces))
    if parameterization in ("injective", "convex"):
        assert not disk.is_flipped.any()
    if parameterization == "convex":
        directed = {(a, b) for f in disk_faces.tolist() for a, b in zip(f, f[1:] + f[:1])}
        border = uv[[a for a, b in directed if (b, a) not in directed]]
        system = np.concatenate([2. * border, np.ones((len(border), 1))], axis=1)
        center = np.linalg.lstsq(system, (border**2).sum(axis=1), rcond=None)[0][:2]  # of the circle through them
        radius = np.linalg.norm(border - center, axis=1)
        assert radius == pytest.approx(np.full(len(border), radius[0]))


def test_developable():
    """Cut along the line opposite to the source, a cylinder is a rectangle."""
    points, faces = meshes.cylinder(12, 9, 10.)
    vertices, disk_faces, uv = cut_locus.cut_open(points, faces, 4, curve="faces", parameterization="arap")
    for i in range(3):
        edges = disk_faces[:, [i, (i + 1) % 3]]
        assert meshes.length_of(uv, edges) == pytest.approx(meshes.length_of(vertices, edges), abs=1e-9)
    diameter = np.linalg.norm(uv[:, None] - uv[None], axis=2).max()
    assert diameter == pytest.approx(np.hypot(12., 10.), abs=1e-9)


@pytest.mark.parametrize("source", [4, (3, (0.2, 0.3, 0.5))])
def test_logarithmic_chart(source):
    """Distances from the source are as they are, on all sides of the seams; the chart of a cylinder is isometric."""
    points, faces = meshes.bumpy_sphere(3)
    disk = cut_locus.cut_open(points, faces, source, parameterization="logmap")
    assert_disk(disk)
    old = disk.vertex_origin >= 0
    distance = cut_locus.exact_geodesic_distances(points, faces, source)[disk.vertex_origin[old]]
    assert not old.all()
    off_seams = np.bincount(disk.vertex_origin[old], minlength=len(points))[disk.vertex_origin[old]] == 1
    assert np.linalg.norm(disk.uv[old], axis=1)[off_seams] == pytest.approx(distance[off_seams], abs=1e-6)
    vertices, disk_faces, uv = cut_locus.cut_open(*meshes.cylinder(12, 9, 10.), 4, parameterization="logmap")
    for i in range(3):
        edges = disk_faces[:, [i, (i + 1) % 3]]
        assert meshes.length_of(uv, edges) == pytest.approx(meshes.length_of(vertices, edges), abs=1e-9)


def test_component_of_source():
    points, faces = meshes.octahedron()
    both = np.concatenate([points, points + 5.]), np.concatenate([faces, faces + 6])
    disk = cut_locus.compute(*both, 8).cut_open(parameterization="convex")
    assert_disk(disk)
    assert set(disk.face_origin) == set(range(8, 16)) and disk.vertex_origin.min() == 6
