// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "cell_surface.h"

#include "../../cells.h"

#include <unordered_map>

namespace {

std::uint32_t source_of(const Cells& cells, CGAL::Cut_loci::Index face)
{
  return cells.source[face] == CGAL::Cut_loci::no_source ? Cell_surface::none
                                                         : static_cast<std::uint32_t>(cells.source[face]);
}

} // namespace

Cell_surface make_cell_surface(const Mesh& mesh, const Cut_locus& between_sources)
{
  const Cells cells = make_cells(mesh, between_sources);
  Cell_surface result;
  std::unordered_map<std::uint64_t, std::uint32_t> copies; // by the source and the vertex
  result.triangles.reserve(3 * cells.mesh.number_of_faces());
  for(CGAL::Cut_loci::Index f = 0; f < cells.mesh.number_of_faces(); ++f)
    for(const CGAL::Cut_loci::Index v : cells.mesh.triangles[f])
    {
      const std::uint32_t source = source_of(cells, f);
      const std::uint32_t next = static_cast<std::uint32_t>(result.source.size());
      const auto [copy, is_new] = copies.emplace(std::uint64_t(source) << 32 | v, next);
      result.triangles.push_back(copy->second);
      if(!is_new)
        continue;
      result.source.push_back(source);
      const auto& x = cells.mesh.points[v];
      if(cells.vertices[v] != CGAL::Cut_loci::null_index)
        result.places.append_vertex(Mesh::Vertex_index(cells.vertices[v]));
      else
        result.places.append_point(mesh, Mesh::Face_index(cells.faces[f]), Kernel::Point_3(x[0], x[1], x[2]));
    }
  return result;
}
