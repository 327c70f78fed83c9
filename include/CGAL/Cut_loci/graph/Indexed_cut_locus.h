// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_INDEXED_CUT_LOCUS_H
#define CGAL_CUT_LOCI_GRAPH_INDEXED_CUT_LOCUS_H

#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <array>
#include <vector>

namespace CGAL::Cut_loci {

// is a cut locus on an `Indexed_triangle_mesh`: a graph whose edges are edges of the mesh, or straight segments in
// its faces.
struct Indexed_cut_locus
{
  struct Node
  {
    Indexed_location location;
    Index vertex = null_index; ///< the vertex of the mesh it is at, if any
    double distance = 0.;      ///< to the source
  };
  struct Edge
  {
    Index source, target;        ///< nodes
    Index halfedge = null_index; ///< the edge of the mesh it is, if any
    float strength = 0.f;        ///< of the branch, in the unit of the method
    Index origin = null_index;   ///< of a smoothed curve: the edge of the mesh that it replaces
    float width = 0.f;           ///< the largest separation of the two shortest paths, a length; if the method knows it
    std::array<Index, 2> sources = {{0, 0}}; ///< the numbers of the nearest sources on its two sides
    float curvature = 0.f;                   ///< that the two shortest paths enclose; if the method knows it
  };

  std::vector<Node> nodes; ///< the root first
  std::vector<Edge> edges;
  Index number_of_narrow_corridors = 0; ///< see `Cut_locus::number_of_narrow_corridors()`
  bool is_one_of_several = false;       ///< see `Cut_locus::is_one_of_several()`
};

namespace internal {

// The gap, at the source, that an edge between two sources has instead of none: more than that of any branch, unless the
// angle around a source is more than twice a full turn.
constexpr float gap_between_sources = 6.2831853f;

// the edges at each node
inline Compressed_rows<Index> incident_edges(const Indexed_cut_locus& graph)
{
  const auto enumerate = [&](const auto& add)
  {
    for(Index e = 0; e < graph.edges.size(); ++e)
    {
      add(graph.edges[e].source, e);
      add(graph.edges[e].target, e);
    }
  };
  return Compressed_rows<Index>(graph.nodes.size(), enumerate);
}

} // namespace internal
} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_GRAPH_INDEXED_CUT_LOCUS_H
