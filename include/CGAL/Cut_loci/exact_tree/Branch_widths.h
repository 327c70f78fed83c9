// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_BRANCH_WIDTHS_H
#define CGAL_CUT_LOCI_EXACT_TREE_BRANCH_WIDTHS_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/exact_tree/Tree_branches.h>
#include <CGAL/Cut_loci/internal/Progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * finds the widths of edges of a graph, up to a hundredth.
 *
 * Each width takes two paths to be followed to the source, and from one edge to the next it changes little. So, of edges
 * in a row of which each meets the next alone, some are measured, until neighbors among these hardly differ.
 */
template <typename Measure>
class Branch_widths
{
public:
  /// @param width of each edge; those in `edges` are set
  /// @param measure returns the width of an edge
  /// @param most edges are passed over at most: between two that are measured the width may be larger than at both
  Branch_widths(const std::vector<Tree_branches::Edge>& edges, Index number_of_nodes, std::size_t most,
                const Measure& measure, std::vector<float>& width, const Progress& progress = {})
    : edges_(edges), measure_(measure), width_(width), degree_(number_of_nodes, 0), exclusive_or_(number_of_nodes, 0),
      is_done_(edges.size(), 0)
  {
    // parts of rows: the two paths of each edge that is measured take a part of a millisecond
    constexpr std::size_t seldom = 8;
    std::size_t number = 0;
    for(Index e = 0; e < edges.size(); ++e)
      for(Index i : {edges[e].outer, edges[e].inner})
      {
        ++degree_[i];
        exclusive_or_[i] ^= e;
      }
    for(Index seed = 0; seed < edges.size(); ++seed)
    {
      if(is_done_[seed])
        continue;
      find_row(seed);
      at(row_.front()) = measure(edges[row_.front()].edge);
      for(std::size_t first = 0; first + 1 < row_.size(); first += most)
      {
        if(number++ % seldom == 0)
          progress(static_cast<double>(seed) / static_cast<double>(edges.size()));
        const std::size_t last = (std::min)(first + most, row_.size() - 1);
        at(row_[last]) = measure(edges[row_[last]].edge);
        fill_between(first, last);
      }
    }
  }

private:
  float& at(Index e) { return width_[edges_[e].edge]; }

  Index next(Index e, Index node) const { return degree_[node] == 2 ? exclusive_or_[node] ^ e : e; }
  Index other_end(Index e, Index node) const { return edges_[e].outer == node ? edges_[e].inner : edges_[e].outer; }

  void find_row(Index seed)
  {
    Index e = seed, from = edges_[seed].outer;
    for(Index k = next(e, from); k != e && k != seed; k = next(e, from))
    {
      e = k;
      from = other_end(e, from);
    }
    row_.clear();
    for(Index k = e; !is_done_[k]; k = next(e, from))
    {
      e = k;
      is_done_[e] = 1;
      row_.push_back(e);
      from = other_end(e, from);
    }
  }

  void fill_between(std::size_t first, std::size_t last)
  {
    if(last < first + 2)
      return;
    const float a = at(row_[first]), b = at(row_[last]);
    if(std::fabs(a - b) <= 0.01f * (std::max)(a, b))
    {
      for(std::size_t i = first + 1; i < last; ++i)
        at(row_[i]) = a + (b - a) * static_cast<float>(i - first) / static_cast<float>(last - first);
      return;
    }
    const std::size_t middle = (first + last) / 2;
    at(row_[middle]) = measure_(edges_[row_[middle]].edge);
    fill_between(first, middle);
    fill_between(middle, last);
  }

  const std::vector<Tree_branches::Edge>& edges_;
  const Measure& measure_;
  std::vector<float>& width_;
  std::vector<Index> degree_, exclusive_or_; // of nodes; with two edges, and one of them known, it tells the other
  std::vector<unsigned char> is_done_;
  std::vector<Index> row_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_BRANCH_WIDTHS_H
