#!/usr/bin/env python3
"""The cut locus of a point on a surface of genus 2, from Python, cell by cell as in a notebook.

    cut_locus_of_point.py [PICTURE.svg [MESH.off]]
"""

# %% A mesh is an array of points and one of faces, wherever they come from.
import pathlib
import sys

import cut_locus
import numpy as np

package = pathlib.Path(__file__).resolve().parents[2]
picture = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cut_locus_of_point.svg")
mesh = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else (
    package / "examples" / "Surface_mesh_cut_locus" / "data" / "double_torus.off")

numbers = iter(mesh.read_text().split()[1:])
n, m, _ = (int(next(numbers)) for _ in range(3))
V = np.array([[float(next(numbers)) for _ in range(3)] for _ in range(n)])
F = np.array([[int(next(numbers)) for _ in range(4)] for _ in range(m)])[:, 1:]
print(f"{mesh.name}: {len(V)} vertices, {len(F)} faces")

# %% One call computes the cut locus: here straight through the faces, of the vertex that is farthest to the front.
view = np.array([0.3, -0.6, 0.75])
source = int((V @ view).argmax())
result = cut_locus.compute(V, F, source)
print(result)
print(f"genus {result.genus}: {result.cycles} cycles; within {result.injectivity_radius:.3f} of the source, "
      "shortest paths are unique")

# %% For other thresholds and sources, an object keeps what they share.
computation = cut_locus.CutLocus(V, F)
computation.set_source(source)
for width in (0.02, 0.1, 0.3):
    simple = computation.cut_locus(minimum_branch_width=width)
    print(f"branches that go around {width} of the diagonal: {simple.leaves} tips, length {simple.length:.2f}")

# %% Exact distances and shortest paths need no cut locus.
distance = cut_locus.exact_geodesic_distances(V, F, source)
assert np.allclose(distance, result.vertex_distance)
path, = cut_locus.shortest_paths(V, F, source, int(distance.argmax()))
print(f"the farthest vertex is {distance.max():.3f} away, by a path across {len(path.points)} points")

# %% Cut open along the cut locus, the surface is a disk, which can be laid flat.
disk = cut_locus.cut_open(V, F, source, curve="faces")
print(f"the disk: {len(disk.vertices)} vertices, {int(disk.is_flipped.sum())} of {len(disk.faces)} faces flipped")

# %% A picture of both, as SVG: what is nearer hides what is behind it.
SIZE = 480.
NEAR, FAR = np.array([255., 240., 225.]), np.array([90., 160., 245.])


def shade(values, light):
    """The color of each distance, in bands, under a light."""
    bands = np.round(values / distance.max(), 1)[:, None]
    colors = ((1. - bands) * NEAR + bands * FAR) * light[:, None]
    return ["#%02x%02x%02x" % tuple(c) for c in colors.astype(int)]


def fit(points, low, high, offset):
    """Points of a plane in a square of the picture."""
    scaled = (points - 0.5 * (low + high)) / (high - low).max() * 0.94 * SIZE
    return scaled * [1., -1.] + [0.5 * SIZE + offset, 0.5 * SIZE]


def line(points, style):
    corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{corners}" fill="none" {style}/>'


def triangle(points, fill):
    corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polygon points="{corners}" fill="{fill}" stroke="{fill}" stroke-width="0.5"/>'


depth_axis = view / np.linalg.norm(view)
right = np.cross([0., 0., 1.], depth_axis)
right /= np.linalg.norm(right)
axes = np.stack([right, np.cross(depth_axis, right)], axis=1)
flat = V @ axes
low, high = flat.min(axis=0), flat.max(axis=0)
normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
normals /= np.linalg.norm(normals, axis=1)[:, None]
light = 0.6 + 0.4 * np.abs(normals @ (depth_axis + 0.5 * right)) / np.hypot(1., 0.5)
shapes = []
for corners, fill in zip(F, shade(distance[F].mean(axis=1), light)):
    shapes.append((V[corners].mean(axis=0) @ depth_axis, triangle(fit(flat[corners], low, high, 0.), fill)))
lift = 0.05 * (high - low).max()  # a line is in front of its faces
for ends in result.points[result.edges]:
    shapes.append((ends.mean(axis=0) @ depth_axis + lift,
                   line(fit(ends @ axes, low, high, 0.), 'stroke="#c00000" stroke-width="2.5"')))
for ends in np.stack([path.points[:-1], path.points[1:]], axis=1):
    shapes.append((ends.mean(axis=0) @ depth_axis + lift,
                   line(fit(ends @ axes, low, high, 0.), 'stroke="#0040a0" stroke-width="1.5"')))
x, y = fit(flat[source], low, high, 0.)
shapes.append((np.inf, f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#0040a0"/>'))
drawing = [shape for _, shape in sorted(shapes, key=lambda s: s[0])]

known = disk.vertex_origin >= 0  # vertices that were added have no distance of their own: they get that of the curve
of_vertices = np.where(known, distance[disk.vertex_origin], result.distance.mean())
low, high = disk.uv.min(axis=0), disk.uv.max(axis=0)
drawing += [triangle(fit(disk.uv[corners], low, high, SIZE), fill)
            for corners, fill in zip(disk.faces, shade(of_vertices[disk.faces].mean(axis=1), np.ones(len(disk.faces))))]
sides = disk.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
_, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
drawing += [line(fit(disk.uv[side], low, high, SIZE), 'stroke="#c00000" stroke-width="2"')
            for side in sides[first[count == 1]]]

picture.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * SIZE:g} {SIZE:g}" '
                   f'stroke-linecap="round" stroke-linejoin="round">\n' + "\n".join(drawing) + "\n</svg>\n")
print(f"the picture: {picture}")
