// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_TREE_H
#define CGAL_CUT_LOCI_DIRECTION_TREE_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_jumps.h>
#include <CGAL/Cut_loci/internal/radix_sort.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is the graph of the faces across the edges that are not in a spanning tree of the vertices, with one more node for
 * each border loop, as if a disk closed it.
 *
 * The tree is contractible, so the complement of the graph is one open disk, and the graph has 2g independent cycles,
 * whatever the tree. The tree of least weight crosses the cut locus where it is weakest, so that the graph contains all
 * that is strong \cgalCite{cgal:ew-gohhb-05}.
 */
struct Direction_graph
{
  std::vector<Index> edges;  ///< of the mesh
  Index number_of_nodes = 0; ///< the faces, then the border loops
  Index number_of_faces = 0;

  /// the two nodes that edge `e` of the mesh joins
  std::array<Index, 2> nodes(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index e) const
  {
    const Index h = connectivity.halfedge_of_edge[e], o = mesh.opposite[h];
    return {{h / 3, o != null_index ? o / 3 : number_of_faces + connectivity.border_loop[mesh.source(h)]}};
  }
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * computes a spanning tree of least weight \cgalCite{cgal:k-sssg-56} and returns the graph that is complementary to it.
 * The edges at the source come first, so that the graph never surrounds it. Linear time, but for the inverse of
 * Ackermann's function.
 */
inline Direction_graph direction_graph(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                       const Direction_jumps& jumps, const Indexed_source& source)
{
  const Index ne = connectivity.number_of_edges();
  std::vector<Index> parent(mesh.number_of_vertices());
  for(Index v = 0; v < parent.size(); ++v)
    parent[v] = v;
  const auto find = [&](Index v)
  {
    while(parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<unsigned char> in_tree(ne, 0);
  const auto add = [&](Index e)
  {
    const Index h = connectivity.halfedge_of_edge[e];
    const Index a = find(mesh.source(h)), b = find(mesh.target(h));
    if(a == b)
      return;
    parent[(std::max)(a, b)] = (std::min)(a, b);
    in_tree[e] = 1;
  };
  for(Index h : internal::source_star(mesh, connectivity, source))
    add(connectivity.edge_of_halfedge[h]);

  std::vector<float> key(ne);
  for(Index e = 0; e < ne; ++e)
    key[e] = jumps.edges[e].weight;
  for(Index e : internal::radix_sorted(key))
    add(e);

  Direction_graph result;
  result.number_of_faces = mesh.number_of_faces();
  result.number_of_nodes = mesh.number_of_faces() + connectivity.number_of_border_loops;
  result.edges.reserve(ne - mesh.number_of_vertices() + 1);
  for(Index e = 0; e < ne; ++e)
    if(!in_tree[e])
      result.edges.push_back(e);
  return result;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_TREE_H
