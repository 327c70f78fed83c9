// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_TREE_BRANCHES_H
#define CGAL_CUT_LOCI_EXACT_TREE_TREE_BRANCHES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * orders the edges of a graph so that each branch can be cut at any strength in time proportional to what is left.
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
                Index first_terminals)
  {
    peel(number_of_nodes, number_of_edges, ends, strength, first_terminals);
    link(number_of_nodes);
  }

  /// the edges from the inside out: the core first, then each behind the one that its inner node belongs to
  const std::vector<Edge>& edges() const { return edges_; }
  std::size_t number_of_core_edges() const { return number_of_core_edges_; }
  /// a node that is always left, or null if there is none
  Index root() const { return root_; }

  /// the edges that are left, from the inside out; `is_kept(edge)` may say no only where it does so for all that is
  /// behind the edge, and is asked for few of them; one of which `has_strength(edge)` says no is kept as the one before
  template <typename Has_strength, typename Is_kept>
  std::vector<Edge> operator()(const Has_strength& has_strength, const Is_kept& is_kept) const
  {
    std::vector<Edge> result(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(number_of_core_edges_));
    std::vector<Index> begins = first_branches_, chain;
    for(std::size_t k = 0; k < begins.size(); ++k) // grows on the way
    {
      const std::size_t n = kept_part(begins[k], has_strength, is_kept, chain);
      for(std::size_t i = 0; i < n; ++i)
        result.push_back(edges_[chain[i]]);
      if(n == chain.size())
        begins.insert(begins.end(), children_.begin() + child_begin_[chain.back()],
                      children_.begin() + child_begin_[chain.back() + std::size_t(1)]);
    }
    return result;
  }

private:
  /// the edges from `first` up to the next fork, and how many of them are kept: a search in steps that double, as far as
  /// they are kept, and then halve
  template <typename Has_strength, typename Is_kept>
  std::size_t kept_part(Index first, const Has_strength& has_strength, const Is_kept& is_kept,
                        std::vector<Index>& chain) const
  {
    chain.assign(1, first);
    const auto is_in = [&](std::size_t i)
    {
      while(i > 0 && !has_strength(edges_[chain[i]]))
        --i;
      return !has_strength(edges_[chain[i]]) || is_kept(edges_[chain[i]]);
    };
    std::size_t kept = 0, dropped = 1;
    while(is_in(dropped - 1))
    {
      kept = dropped;
      while(chain.size() < 2 * kept + 1 && has_one_child(chain.back()))
        chain.push_back(children_[child_begin_[chain.back()]]);
      if(kept == chain.size())
        return kept;
      dropped = chain.size();
    }
    while(dropped - kept > 1)
    {
      const std::size_t middle = (kept + dropped) / 2;
      (is_in(middle - 1) ? kept : dropped) = middle;
    }
    return kept;
  }

  bool has_one_child(Index i) const { return child_begin_[i + std::size_t(1)] - child_begin_[i] == 1; }

  template <typename Ends, typename Strength>
  void peel(Index n, Index m, const Ends& ends, const Strength& strength, Index terminals)
  {
    struct Incidence
    {
      Index degree = 0, exclusive_or = 0;
      float strength = 0.f; // of the branches that have fallen off
    };
    std::vector<Incidence> incidence(n);
    for(Index e = 0; e < m; ++e)
      for(Index i : ends(e))
      {
        ++incidence[i].degree;
        incidence[i].exclusive_or ^= e; // with one edge left, this is the edge
      }
    for(Index i = 0; i < terminals; ++i)
      incidence[i].degree += 2;

    using Leaf = std::pair<float, Index>;
    std::priority_queue<Leaf, std::vector<Leaf>, std::greater<Leaf>> leaves;
    const auto push = [&](Index i)
    {
      const float s = (std::max)(incidence[i].strength, static_cast<float>(strength(incidence[i].exclusive_or)));
      leaves.push({s, i});
    };
    for(Index i = 0; i < n; ++i)
      if(incidence[i].degree == 1)
        push(i);
    std::vector<unsigned char> is_peeled(m, 0);
    while(!leaves.empty())
    {
      const Leaf leaf = leaves.top();
      leaves.pop();
      const Index i = leaf.second;
      if(incidence[i].degree != 1)
        continue;
      const Index e = incidence[i].exclusive_or;
      const auto nodes = ends(e);
      const Index other = nodes[0] == i ? nodes[1] : nodes[0];
      is_peeled[e] = 1;
      edges_.push_back({e, i, other, leaf.first});
      incidence[i].degree = 0;
      Incidence& next = incidence[other];
      next.strength = (std::max)(next.strength, leaf.first);
      next.exclusive_or ^= e;
      if(--next.degree == 1)
        push(other);
    }
    if(!edges_.empty())
      root_ = edges_.back().inner;
    constexpr float always = (std::numeric_limits<float>::infinity)();
    for(Index e = 0; e < m; ++e)
      if(!is_peeled[e])
      {
        const auto nodes = ends(e);
        edges_.push_back({e, nodes[0], nodes[1], always});
        ++number_of_core_edges_;
        root_ = nodes[0];
      }
    std::reverse(edges_.begin(), edges_.end());
    if(terminals > 0)
      root_ = 0;
  }

  void link(Index n)
  {
    std::vector<Index> position(n, null_index); // of the edge whose outer node it is
    for(std::size_t i = number_of_core_edges_; i < edges_.size(); ++i)
      position[edges_[i].outer] = static_cast<Index>(i);
    child_begin_.assign(edges_.size() + 1, 0);
    for(std::size_t i = number_of_core_edges_; i < edges_.size(); ++i)
    {
      const Index p = position[edges_[i].inner];
      if(p == null_index)
        first_branches_.push_back(static_cast<Index>(i));
      else
        ++child_begin_[p + std::size_t(1)];
    }
    for(std::size_t i = 0; i < edges_.size(); ++i)
      child_begin_[i + 1] += child_begin_[i];
    children_.resize(child_begin_.back());
    std::vector<Index> next(child_begin_.begin(), child_begin_.end() - 1);
    for(std::size_t i = number_of_core_edges_; i < edges_.size(); ++i)
    {
      const Index p = position[edges_[i].inner];
      if(p != null_index)
        children_[next[p]++] = static_cast<Index>(i);
    }
  }

  Index root_ = null_index;
  std::size_t number_of_core_edges_ = 0;
  std::vector<Edge> edges_;
  std::vector<Index> first_branches_; // those at the core, or at the root
  std::vector<Index> child_begin_, children_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_TREE_BRANCHES_H
