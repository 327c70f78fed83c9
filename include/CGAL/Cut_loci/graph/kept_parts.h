// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_KEPT_PARTS_H
#define CGAL_CUT_LOCI_GRAPH_KEPT_PARTS_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Which parts of the cut locus of several sources are asked for.
struct Kept_parts
{
  bool is_voronoi = false; // all that is not between two sources is removed, or
  bool is_medial = false;  // all that is

  bool has_all_parts() const { return !is_voronoi && !is_medial; }
  // whether an edge is in none of the parts that are asked for
  bool excludes(const Indexed_cut_locus::Edge& e) const
  {
    return e.sources[0] == e.sources[1] ? is_voronoi : is_medial;
  }
};

// Removes what is not asked for.
inline void remove_other_parts(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                               const Kept_parts& parts, Indexed_cut_locus& graph)
{
  if(parts.has_all_parts())
    return;
  std::vector<unsigned char> is_removed;
  for(const Indexed_cut_locus::Edge& e : graph.edges)
    is_removed.push_back(parts.excludes(e));
  remove_edges(mesh, connectivity, graph, is_removed);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_KEPT_PARTS_H
