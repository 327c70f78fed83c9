// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_REGION_GROWING_TREE_H
#define CGAL_CUT_LOCI_LAPLACIAN_REGION_GROWING_TREE_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>

#include <vector>

namespace CGAL {
namespace Cut_loci {

/*
 * is a rooted tree on some or all vertices of a mesh.
 *
 * On a surface with boundary each border loop counts as one node, since the border bounds the complement of the cut
 * locus as well: the tree enters a loop once and reaches its other vertices along it.
 */
struct Spanning_tree
{
  Index root = null_index;
  std::vector<Index> parent;       ///< `null_index` for the root and for vertices outside the tree
  std::vector<Index> parent_entry; ///< the entry of the parent in the ring of the vertex
  std::vector<Index> order;        ///< the vertices of the tree, parents before children

  bool contains(Index v) const { return v == root || parent[v] != null_index; }
};

namespace internal {

// Adds to `tree` the vertex across `entry`, a ring entry of `v`, and calls `reached` for it, unless it is there
// already.
template <typename Function>
bool add_vertex(Spanning_tree& tree, const Mesh_connectivity& connectivity, Index entry, Index v,
                const Function& reached)
{
  const Index w = connectivity.ring_vertex[entry];
  if(tree.contains(w))
    return false;
  tree.parent[w] = v;
  tree.parent_entry[w] = connectivity.ring_reverse[entry];
  tree.order.push_back(w);
  reached(w);
  return true;
}

// Adds the border loop of `v`, both ways until the walks meet: rings of border vertices start and end on the border.
template <typename Function>
void add_border_loop(Spanning_tree& tree, const Mesh_connectivity& connectivity, Index v, const Function& reached)
{
  Index forward = v, backward = v;
  bool forward_moves = true, backward_moves = true;
  while(forward_moves || backward_moves)
  {
    const Index e = connectivity.ring_begin[forward];
    forward_moves = forward_moves && add_vertex(tree, connectivity, e, forward, reached);
    if(forward_moves)
      forward = connectivity.ring_vertex[e];
    const Index b = connectivity.ring_begin[backward + 1] - 1;
    backward_moves = backward_moves && add_vertex(tree, connectivity, b, backward, reached);
    if(backward_moves)
      backward = connectivity.ring_vertex[b];
  }
}

// Adds the vertex across `entry` and its border loop if it is on one.
template <typename Function>
void add_with_border_loop(Spanning_tree& tree, const Mesh_connectivity& connectivity, Index entry, Index v,
                          const Function& reached)
{
  const Index w = connectivity.ring_vertex[entry];
  if(add_vertex(tree, connectivity, entry, v, reached) && connectivity.is_border(w))
    add_border_loop(tree, connectivity, w, reached);
}

// Adds the source as a leaf, at the first neighbor in its ring, when all other vertices are in the tree.
inline void add_source(Spanning_tree& tree, const Mesh_connectivity& connectivity, const Source_element& source)
{
  if(source.vertex == null_index || tree.contains(source.vertex))
    return;
  const Index entry = connectivity.ring_begin[source.vertex];
  tree.parent[source.vertex] = connectivity.ring_vertex[entry];
  tree.parent_entry[source.vertex] = entry;
  tree.order.push_back(source.vertex);
}

inline Spanning_tree rooted_tree(const Mesh_connectivity& connectivity, Index root)
{
  const std::size_t nv = connectivity.ring_begin.size() - 1;
  Spanning_tree tree;
  tree.root = root;
  tree.parent.assign(nv, null_index);
  tree.parent_entry.assign(nv, null_index);
  tree.order.reserve(nv);
  tree.order.push_back(root);
  return tree;
}

} // namespace internal

/*
 * floods the mesh by ordered region growing: of all vertices next to the tree, the one of lowest `key` joins its
 * neighborhood first. With the Laplacian of the distance as key, the tree follows the valleys that mark the cut locus.
 * Ties are broken by index. The root is none of the sources. O(n log n).
 *
 * @param sources what is not on the cut locus, of each source
 * @param crossed the edges that are not taken, as `Way_forest` gives them; none if it is empty
 */
template <typename Key>
Spanning_tree region_growing_tree(const Mesh_connectivity& connectivity, const Key& key, Index root,
                                  const std::vector<Source_element>& sources = {},
                                  const std::vector<unsigned char>& crossed = {},
                                  const internal::Progress& progress = {})
{
  const std::vector<unsigned char> is_closed = internal::closed_edges(connectivity, crossed, sources);
  Spanning_tree tree = internal::rooted_tree(connectivity, root);
  internal::Vertex_queue queue;
  const auto push = [&](Index v) { queue.push({key[v], v}); };

  push(root);
  if(connectivity.is_border(root))
    internal::add_border_loop(tree, connectivity, root, push);
  for(std::size_t i = 0; !queue.empty(); ++i)
  {
    progress(i, tree.parent.size());
    const Index v = queue.top().vertex;
    queue.pop();
    for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      if(!is_closed[connectivity.ring_edge(entry)])
        internal::add_with_border_loop(tree, connectivity, entry, v, push);
  }
  for(const Source_element& source : sources)
    internal::add_source(tree, connectivity, source);
  return tree;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_REGION_GROWING_TREE_H
