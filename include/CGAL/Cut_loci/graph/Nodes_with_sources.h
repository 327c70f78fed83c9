// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_NODES_WITH_SOURCES_H
#define CGAL_CUT_LOCI_GRAPH_NODES_WITH_SOURCES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <array>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * numbers what counts as one node of a graph of mesh edges: each border loop that is not all source, each one that is,
 * and each vertex inside, in this order.
 *
 * An arc of a loop that is a source is a point on that node: edges that end there separate what is on their two sides, as
 * those to the rest of the loop do. At a loop that is a source, a single edge separates nothing.
 */
class Nodes_with_sources
{
public:
  Nodes_with_sources(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Source_parts& parts)
    : mesh_(mesh), connectivity_(connectivity), parts_(parts), has_rest_(parts.loops_with_rest(connectivity))
  {
  }

  Index number_of_loops() const { return connectivity_.number_of_border_loops; }
  Index size() const { return number_of_loops() + parts_.size() + mesh_.number_of_vertices(); }

  Index node(Index v) const
  {
    if(!connectivity_.is_border(v))
      return number_of_loops() + parts_.size() + v;
    const Index loop = connectivity_.border_loop[v];
    return has_rest_[loop] ? loop : number_of_loops() + parts_.part(v);
  }
  std::array<Index, 2> ends(Index halfedge) const
  {
    return {{node(mesh_.source(halfedge)), node(mesh_.target(halfedge))}};
  }
  /// whether an edge has an end at a source on the border
  bool is_at_source(Index halfedge) const
  {
    return parts_.is_at_source(mesh_.source(halfedge)) || parts_.is_at_source(mesh_.target(halfedge));
  }
  /// whether a node is a border loop that is a source
  bool is_source(Index node) const { return node >= number_of_loops() && node < number_of_loops() + parts_.size(); }
  /// whether a node is a border loop with a vertex to which a curve may go
  bool is_border(Index node) const { return node < number_of_loops() && has_rest_[node]; }
  /// the vertex of a node inside, or null
  Index vertex(Index node) const
  {
    const Index first = number_of_loops() + parts_.size();
    return node >= first ? node - first : null_index;
  }

private:
  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Source_parts& parts_;
  std::vector<unsigned char> has_rest_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_NODES_WITH_SOURCES_H
