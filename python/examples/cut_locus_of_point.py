#!/usr/bin/env python3
"""The cut locus of a point on a surface of genus 2, from Python, cell by cell as in a notebook. The picture takes matplotlib.

    cut_locus_of_point.py [PICTURE [MESH.off]]
"""

# %% A mesh is an array of points and one of faces, wherever they come from.
import pathlib
import sys

import cut_locus
import matplotlib
import numpy as np
matplotlib.use("agg")
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection

package = pathlib.Path(__file__).resolve().parents[2]
picture = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cut_locus_of_point.png")
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

# %% Any other point is found afterwards, by a face and barycentric coordinates.
geodesics = cut_locus.ExactGeodesics(V, F)
geodesics.compute(source)
middles = geodesics.find(np.arange(len(F)), np.full((len(F), 3), 1. / 3.))
print(f"the middle of face {middles.distance.argmax()} is {middles.distance.max():.3f} away")

# %% Isolines are polylines through the faces. The two shortest paths to the nearest point of the cut locus are a loop.
isolines = cut_locus.isolines(V, F, source, np.arange(1, 10) / 10. * distance.max())
loop = result.geodesic_loop()
length = np.linalg.norm(np.diff(loop, axis=0), axis=1).sum()
print(f"{len(isolines)} isolines; a loop of the length {length:.3f}, twice the radius")

# %% Cut open along the cut locus, the surface is a disk, which can be laid flat.
disk = cut_locus.cut_open(V, F, source, curve="faces")
print(f"the disk: {len(disk.vertices)} vertices, {int(disk.is_flipped.sum())} of {len(disk.faces)} faces flipped")

# %% A picture of both: what is nearer is drawn later, and lines in front of the faces that they run in.
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5), layout="constrained")
depth_axis = view / np.linalg.norm(view)
horizontal = np.cross([0., 0., 1.], depth_axis)
horizontal /= np.linalg.norm(horizontal)
axes = np.stack([horizontal, np.cross(depth_axis, horizontal), depth_axis], axis=1)


def segments(points):
    return np.stack([points[:-1], points[1:]], axis=1)


lines = [(result.points[result.edges], "#c00000", 2.5), (segments(path.points), "#0040a0", 1.5),
         (segments(loop), "#e08000", 1.5), *((segments(line.points), "#ffffff", 0.7) for line in isolines)]


def shade(values, light=1.):
    """The color of each distance, in bands, under a light."""
    return plt.cm.YlGnBu(np.round(values / distance.max(), 1) * 0.6)[:, :3] * np.reshape(light, (-1, 1))


normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
normals /= np.linalg.norm(normals, axis=1)[:, None]
light = 0.6 + 0.4 * np.abs(normals @ (depth_axis + 0.5 * horizontal)) / np.hypot(1., 0.5)
shapes = [(triangle @ axes, color, 0.5) for triangle, color in zip(V[F], shade(distance[F].mean(axis=1), light))]
lift = [0., 0., 0.05 * np.ptp(V @ axes, axis=0).max()]
shapes += [(ends @ axes + lift, color, width) for pairs, color, width in lines for ends in pairs]
shapes.sort(key=lambda shape: shape[0][:, 2].mean())
left.add_collection(PolyCollection([shape[:, :2] for shape, _, _ in shapes], facecolors=[c for _, c, _ in shapes],
                                   edgecolors=[c for _, c, _ in shapes], linewidths=[w for _, _, w in shapes],
                                   closed=False, capstyle="round"))
left.plot(*(V[source] @ axes)[:2], "o", color="#0040a0")

known = disk.vertex_origin >= 0  # vertices that were added have no distance of their own: they get that of the curve
of_vertices = np.where(known, distance[disk.vertex_origin], result.distance.mean())
colors = shade(of_vertices[disk.faces].mean(axis=1))
right.add_collection(PolyCollection(disk.uv[disk.faces], facecolors=colors, edgecolors=colors, linewidths=0.5))
sides = disk.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
_, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
right.add_collection(LineCollection(disk.uv[sides[first[count == 1]]], colors="#c00000", linewidths=2, capstyle="round"))

for panel in left, right:
    panel.autoscale_view()
    panel.set_aspect("equal")
    panel.axis("off")
figure.savefig(picture)
print(f"the picture: {picture}")
