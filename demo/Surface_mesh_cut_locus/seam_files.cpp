// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The seams of an atlas as edges of the file that was read.

#include "atlas.h"
#include "output_file.h"

#include <filesystem>
#include <ostream>

namespace {

using Polygon_edges = std::vector<std::pair<std::size_t, std::size_t>>;

// JSON, and Python
void write_pairs(std::ostream& os, const Polygon_edges& edges)
{
  os << '[';
  for(std::size_t i = 0; i < edges.size(); ++i)
    os << (i == 0 ? "" : i % 8 == 0 ? ",\n" : ", ") << '[' << edges[i].first << ", " << edges[i].second << ']';
  os << "]";
}

void write_lines(std::ostream& os, const Polygon_edges& edges, const Polygon_soup& soup)
{
  for(const Kernel::Point_3& p : soup.points)
    os << "v " << p << '\n';
  for(const auto& [a, b] : edges)
    os << "l " << a + 1 << ' ' << b + 1 << '\n';
}

void write_script(std::ostream& os, const Polygon_edges& edges)
{
  os << R"(# For Blender: marks the seams of the active object, which must have the vertices of the file in their order.
import bpy

SEAMS = )";
  write_pairs(os, edges);
  os << R"(

mode = bpy.context.object.mode
bpy.ops.object.mode_set(mode='OBJECT')
mesh = bpy.context.object.data
edges = {tuple(sorted(edge.vertices)): edge for edge in mesh.edges}
missing = [pair for pair in SEAMS if tuple(sorted(pair)) not in edges]
if missing:
    raise RuntimeError(f"{len(missing)} of {len(SEAMS)} seams are no edges of this mesh: it has other vertices")
for pair in SEAMS:
    edges[tuple(sorted(pair))].use_seam = True
mesh.update()
bpy.ops.object.mode_set(mode=mode)
print(f"{len(SEAMS)} edges marked")
)";
}

} // namespace

void write_seams(const std::string& filename, const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup)
{
  const Polygon_edges edges = seams_of_polygons(atlas, input, soup);
  const std::string extension = std::filesystem::path(filename).extension().string();
  write_file(filename,
             [&](std::ostream& os)
             {
    if(extension == ".obj")
      write_lines(os, edges, soup);
    else if(extension == ".py")
      write_script(os, edges);
    else
    {
      write_pairs(os, edges);
      os << '\n';
    }
  });
}
