// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_THINNING_H
#define CGAL_CUT_LOCI_LAPLACIAN_THINNING_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/vertex_queue.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// Whether the way in `tree` between two vertices has at most `most` edges.
inline bool are_near_in_tree(const Spanning_tree& tree, Index v, Index w, Index most)
{
  for(Index up = 0; up <= most; ++up)
  {
    Index x = w;
    for(Index down = 0; up + down <= most; ++down)
    {
      if(x == v)
        return true;
      if(x == tree.root)
        break;
      x = tree.parent[x];
    }
    if(v == tree.root)
      return false;
    v = tree.parent[v];
  }
  return false;
}

} // namespace internal

/*
 * removes from the leaves of `tree`, those of highest `key` first, the vertices next to a stronger branch: those with a
 * neighbor of lower key in the tree that is neither their parent nor a child of their parent. Parallel branches that
 * flood a band of the surface shrink to one; the tree stays connected. O(n log n).
 *
 * With `reach` 2, a branch of lower key that is two edges away counts as well: that far are strengths seen to either
 * side. It is another one than the leaf's own if the way there in the tree is longer than twice as far.
 */
template <typename Key>
void thin(Spanning_tree& tree, const Mesh_connectivity& connectivity, const Key& key, Index reach = 1,
          const internal::Progress& progress = {})
{
  std::vector<Index> children(tree.parent.size(), 0);
  for(Index v : tree.order)
    if(v != tree.root)
      ++children[tree.parent[v]];

  internal::Vertex_queue leaves;
  for(Index v : tree.order)
    if(v != tree.root && children[v] == 0)
      leaves.push({-static_cast<double>(key[v]), v});

  std::vector<bool> removed(tree.parent.size(), false);
  for(std::size_t i = 0; !leaves.empty(); ++i)
  {
    progress(i, tree.order.size());
    const Index v = leaves.top().vertex, parent = tree.parent[v];
    leaves.pop();
    const auto begin = connectivity.ring_vertex.begin() + connectivity.ring_begin[v],
               end = connectivity.ring_vertex.begin() + connectivity.ring_begin[v + 1];
    const bool is_next_to_stronger_branch = std::any_of(begin, end,
                                                        [&](Index w) {
      return key[w] < key[v] && w != parent && tree.contains(w) && !removed[w] && tree.parent[w] != parent;
    });
    const auto is_other_branch = [&](Index w)
    { return key[w] < key[v] && tree.contains(w) && !removed[w] && !internal::are_near_in_tree(tree, v, w, 4); };
    const auto is_near_other_branch = [&](Index x)
    {
      return std::any_of(connectivity.ring_vertex.begin() + connectivity.ring_begin[x],
                         connectivity.ring_vertex.begin() + connectivity.ring_begin[x + 1], is_other_branch);
    };
    if(!is_next_to_stronger_branch && (reach == 1 || std::none_of(begin, end, is_near_other_branch)))
      continue;
    removed[v] = true;
    if(--children[parent] == 0 && parent != tree.root)
      leaves.push({-static_cast<double>(key[parent]), parent});
  }

  tree.order.erase(std::remove_if(tree.order.begin(), tree.order.end(), [&](Index v) { return removed[v]; }),
                   tree.order.end());
  for(Index v = 0; v < removed.size(); ++v)
    if(removed[v])
      tree.parent[v] = tree.parent_entry[v] = null_index;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_THINNING_H
