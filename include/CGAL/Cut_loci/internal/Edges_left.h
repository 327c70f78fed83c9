// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_EDGES_LEFT_H
#define CGAL_CUT_LOCI_INTERNAL_EDGES_LEFT_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Progress.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * counts the edges of a graph that are left at each node while others are removed, and knows the last one of a leaf:
 * the exclusive or of their numbers, which takes no lists.
 */
class Edges_left
{
public:
  using Nodes = std::array<Index, 2>;

  Edges_left() = default;
  explicit Edges_left(std::size_t number_of_nodes) : at_(number_of_nodes) {}

  /// @param ends the nodes of each of the edges 0, ..., `number_of_edges` - 1
  template <typename Ends>
  Edges_left(std::size_t number_of_nodes, std::size_t number_of_edges, const Ends& ends, const Progress& progress = {})
    : at_(number_of_nodes)
  {
    for(Index e = 0; e < number_of_edges; ++e)
    {
      progress(e, number_of_edges);
      add(e, ends(e));
    }
  }

  void add(Index edge, const Nodes& nodes)
  {
    for(Index i : nodes)
    {
      ++at_[i].degree;
      at_[i].exclusive_or ^= edge;
    }
  }

  void remove(Index edge, const Nodes& nodes)
  {
    for(Index i : nodes)
    {
      --at_[i].degree;
      at_[i].exclusive_or ^= edge;
    }
  }

  /// makes a node one that is never a leaf
  void keep(Index node) { at_[node].degree += 2; }

  Index degree(Index node) const { return at_[node].degree; }
  bool is_leaf(Index node) const { return at_[node].degree == 1; }
  /// of a leaf
  Index last(Index leaf) const { return at_[leaf].exclusive_or; }
  /// the other one of two
  Index next(Index node, Index edge) const { return at_[node].exclusive_or ^ edge; }

  static Index other(const Nodes& nodes, Index node) { return nodes[0] == node ? nodes[1] : nodes[0]; }

  /// removes leaves with their edges, also those that become leaves on the way: each edge after those behind it
  ///
  /// @param falls tells of an edge and its leaf whether it goes, and may note that it does
  template <typename Ends, typename Falls>
  void peel(const Ends& ends, const Falls& falls, const Progress& progress = {})
  {
    for(Index seed = 0; seed < at_.size(); ++seed)
    {
      progress(seed, at_.size());
      for(Index leaf = seed; leaf <= seed && is_leaf(leaf) && falls(last(leaf), leaf);) // others come as seeds
        leaf = remove_leaf(leaf, ends);
    }
  }

  /// the same, but from one node only, up to the first at which others meet
  template <typename Ends, typename Falls>
  void peel_from(Index leaf, const Ends& ends, const Falls& falls)
  {
    while(is_leaf(leaf) && falls(last(leaf), leaf))
      leaf = remove_leaf(leaf, ends);
  }

private:
  struct Incidence
  {
    Index degree = 0, exclusive_or = 0;
  };

  /// returns the node that it hung on
  template <typename Ends>
  Index remove_leaf(Index leaf, const Ends& ends)
  {
    const Index edge = last(leaf);
    const Nodes nodes = ends(edge);
    remove(edge, nodes);
    return other(nodes, leaf);
  }

  std::vector<Incidence> at_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_EDGES_LEFT_H
