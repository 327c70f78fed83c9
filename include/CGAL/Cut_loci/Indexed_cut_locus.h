// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INDEXED_CUT_LOCUS_H
#define CGAL_CUT_LOCI_INDEXED_CUT_LOCUS_H

#include <CGAL/Cut_loci/Branch_filter.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is a cut locus on an `Indexed_triangle_mesh`: a graph whose edges are edges of the mesh, or straight segments in
 * its faces.
 */
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
    Index origin = null_index;   ///< the edge of the graph of mesh edges that it replaces, or is
    float width = 0.f;           ///< the largest separation of the two shortest paths, a length; if the method knows it
  };

  std::vector<Node> nodes; ///< the root first
  std::vector<Edge> edges;
  Index number_of_narrow_corridors = 0; ///< see `Cut_locus::number_of_narrow_corridors()`
};

namespace internal {

inline Indexed_location location_of_vertex(const Mesh_connectivity& connectivity, Index v)
{
  const Index h = connectivity.ring_halfedge[connectivity.ring_begin[v]]; // outgoing
  Indexed_location result;
  result.face = h / 3;
  result.coordinates[h % 3] = 1.;
  return result;
}

// the graph of mesh edges that a filter has selected
inline Indexed_cut_locus mesh_edge_graph(const Mesh_connectivity& connectivity, const std::vector<double>& distance,
                                         const Branch_filter::Result& filtered)
{
  Indexed_cut_locus result;
  result.nodes.resize(filtered.vertices.size());
  // The vertices of the result are few: a search in a sorted copy costs no table over the mesh.
  std::vector<std::pair<Index, Index>> position(filtered.vertices.size());
  for(Index i = 0; i < filtered.vertices.size(); ++i)
  {
    const Index v = filtered.vertices[i];
    result.nodes[i] = {location_of_vertex(connectivity, v), v, distance[v]};
    position[i] = {v, i};
  }
  std::sort(position.begin(), position.end());
  const auto node = [&](Index v)
  { return std::lower_bound(position.begin(), position.end(), std::make_pair(v, Index(0)))->second; };
  result.edges.reserve(filtered.edges.size());
  for(const Branch_filter::Edge& e : filtered.edges)
    result.edges.push_back(
      {node(e.vertex), node(e.parent), e.halfedge, e.strength, static_cast<Index>(result.edges.size())});
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INDEXED_CUT_LOCUS_H
