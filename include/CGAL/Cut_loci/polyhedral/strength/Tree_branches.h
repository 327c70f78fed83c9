// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_TREE_BRANCHES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_TREE_BRANCHES_H

#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells how strong the branches of a graph are, so that they can be cut at any strength.
 *
 * Leaves fall off in the order of their strength. What does not fall off, the cycles and the ways between `terminals`,
 * is the core. The last node of a tree without terminals is its root. The strength of an edge is the largest on the
 * branch behind it, so that what is left at any threshold is connected.
 */
class Tree_branches
{
public:
  struct Edge
  {
    Index edge;         // of the graph
    Index outer, inner; // its nodes: the outer one is farther from the root
    float strength;     // infinite in the core
  };

  Tree_branches() = default;

  /// @param ends the two nodes of each edge
  /// @param strength of each edge
  /// @param first_terminals the nodes before it are terminals
  template <typename Ends, typename Strength>
  Tree_branches(Index number_of_nodes, Index number_of_edges, const Ends& ends, const Strength& strength,
                Index first_terminals, const Progress& progress = {})
  {
    peel(number_of_nodes, number_of_edges, ends, strength, first_terminals, progress);
  }

  /// the edges from the inside out, which is from strong to weak: the core first
  const std::vector<Edge>& edges() const { return edges_; }
  /// a node that is always left, or null if there is none
  Index root() const { return root_; }

private:
  template <typename Ends, typename Strength>
  void peel(Index n, Index m, const Ends& ends, const Strength& strength, Index terminals, const Progress& progress)
  {
    Edges_left left(n, m, ends, progress.part(0., 0.3));
    for(Index i = 0; i < terminals; ++i)
      left.keep(i);
    std::vector<float> fallen(n, 0.f); // the strength of the branches that have fallen off
    const Progress peeling = progress.part(0.3, 1.);
    using Leaf = std::pair<float, Index>;
    std::priority_queue<Leaf, std::vector<Leaf>, std::greater<Leaf>> leaves;
    const auto push = [&](Index i) {
      leaves.push({(std::max)(fallen[i], static_cast<float>(strength(left.last(i)))), i});
    };
    for(Index i = 0; i < n; ++i)
      if(left.is_leaf(i))
        push(i);
    std::vector<unsigned char> is_peeled(m, 0);
    while(!leaves.empty())
    {
      peeling(edges_.size(), m);
      const Leaf leaf = leaves.top();
      leaves.pop();
      const Index i = leaf.second;
      if(!left.is_leaf(i))
        continue;
      const Index e = left.last(i);
      const auto nodes = ends(e);
      const Index other = Edges_left::other(nodes, i);
      is_peeled[e] = 1;
      edges_.push_back({e, i, other, leaf.first});
      left.remove(e, nodes);
      fallen[other] = (std::max)(fallen[other], leaf.first);
      if(left.is_leaf(other))
        push(other);
    }
    if(!edges_.empty())
      root_ = edges_.back().inner;
    add_core(is_peeled, ends);
    std::reverse(edges_.begin(), edges_.end());
    if(terminals > 0)
      root_ = 0;
  }

  // what no leaf leads to: the cycles, and what joins them
  template <typename Ends>
  void add_core(const std::vector<unsigned char>& is_peeled, const Ends& ends)
  {
    constexpr float always = (std::numeric_limits<float>::infinity)();
    for(Index e = 0; e < is_peeled.size(); ++e)
      if(!is_peeled[e])
      {
        const auto nodes = ends(e);
        edges_.push_back({e, nodes[0], nodes[1], always});
        root_ = nodes[0];
      }
  }

  Index root_ = null_index;
  std::vector<Edge> edges_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_TREE_BRANCHES_H
