"""Run by scripts/test_blender in Blender: a model, and the folder with what cut_locus has written for it."""
import json
import pathlib
import sys

import bpy
import numpy

numpy.bool = bool  # the glTF importer of Blender 3.4 is older than NumPy 1.24

model, folder = (pathlib.Path(argument) for argument in sys.argv[sys.argv.index("--") + 1:])


def opened(operator, path, **options):
    """the meshes of a file, in the order of their names"""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    operator(filepath=str(path), **options)
    return sorted((item for item in bpy.context.scene.objects if item.type == "MESH"), key=lambda item: item.name)


def only(items, path):
    assert len(items) == 1, f"{path.name} has {len(items)} objects: the script marks the seams of one"
    bpy.context.view_layer.objects.active = items[0]
    return items[0].data


def as_it_is(path):
    """one object, with the vertices of the file in their order"""
    if "use_split_objects" in bpy.ops.wm.obj_import.get_rna_type().properties:
        return opened(bpy.ops.wm.obj_import, path, use_split_objects=False, use_split_groups=False, forward_axis="Y", up_axis="Z")
    return opened(bpy.ops.import_scene.obj, path, split_mode="OFF", axis_forward="Y", axis_up="Z")  # before Blender 3.6


def shape(mesh):
    return [tuple(polygon.vertices) for polygon in mesh.polygons]


# the script marks the edges of the list
mesh = only(as_it_is(model), model)
polygons, vertices = shape(mesh), len(mesh.vertices)
exec(compile((folder / "seams.py").read_text(), "seams.py", "exec"))
mesh = bpy.context.object.data
wanted = {tuple(sorted(pair)) for pair in json.loads((folder / "seams.json").read_text())}
marked = {tuple(sorted(edge.vertices)) for edge in mesh.edges if edge.use_seam}
assert marked == wanted, f"{len(marked)} edges are marked, {len(wanted)} are seams"

# the file with texture coordinates is the same model; its islands meet at these seams
mesh = only(as_it_is(folder / "uv.obj"), folder / "uv.obj")
assert shape(mesh) == polygons and len(mesh.vertices) == vertices, "other polygons, or other vertices"
layer = mesh.uv_layers.active.data
at_edges = {}
for polygon in mesh.polygons:
    corners = list(polygon.loop_indices)
    for i, corner in enumerate(corners):
        other = corners[(i + 1) % len(corners)]
        ends = sorted((mesh.loops[c].vertex_index, tuple(round(x, 6) for x in layer[c].uv)) for c in (corner, other))
        at_edges.setdefault((ends[0][0], ends[1][0]), set()).add((ends[0][1], ends[1][1]))
apart = {edge for edge, places in at_edges.items() if len(places) > 1}
assert apart == wanted, f"texture coordinates are cut at {len(apart)} edges, {len(wanted)} are seams"
assert all(0 <= x <= 1 for corner in layer for x in corner.uv)

# glTF has the same surface, in triangles
scene = opened(bpy.ops.import_scene.gltf, folder / "uv.glb")
triangles = sum(len(item.data.polygons) for item in scene)
assert triangles == sum(len(polygon) - 2 for polygon in polygons), f"{triangles} triangles"
assert all(item.data.uv_layers for item in scene)
has_normals = all(item.data.has_custom_normals for item in scene)
print(f"blender: {model.name}: {len(polygons)} polygons, {len(wanted)} seams marked and cut, {triangles} triangles in glTF, "
      f"{'with' if has_normals else 'without'} normals of the file")
