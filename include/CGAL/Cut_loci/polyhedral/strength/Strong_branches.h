// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_STRONG_BRANCHES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_STRONG_BRANCHES_H

#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * finds what is left of a tree graph without its weak branches, from the leaves inward.
 *
 * A row of edges, from a leaf to the next node where others meet, is cut before its outermost strong edge, or goes as a
 * whole. As branches get stronger inward, it takes few edges to find that one; to miss none where they do not, some more
 * are tried than the innermost: as many as the row can be halved, and of those that enclose enough the innermost of all
 * that enclose the same. A row with two leaves is strongest anywhere: all of its edges are tried. So nothing strong is
 * lost for what is beside it, and no edge has to be known as the root.
 *
 * @tparam Can_be tells quickly whether an edge may be strong
 * @tparam Enclosed tells quickly how much it encloses: what is enough may be narrow
 * @tparam Is_wide tells whether it has a width
 */
template <typename Can_be, typename Enclosed, typename Is_wide>
class Strong_branches
{
public:
  Strong_branches(const Tree_graph& graph, Index number_of_loops, const Branch_strength& least, const Can_be& can_be,
                  const Enclosed& enclosed, const Is_wide& is_wide, const Progress& progress = {})
    : graph_(graph), least_(least), can_be_(can_be), enclosed_(enclosed), is_wide_(is_wide),
      left_(
        graph.nodes.size(), graph.edges.size(), [&](Index e) { return graph.edges[e].nodes; }, progress.part(0., 0.3)),
      is_kept_(graph.edges.size(), 1)
  {
    const Progress cutting = progress.part(0.3, 1.);
    for(Index i = 0; i < number_of_loops; ++i)
      left_.keep(i); // and no inner node of a row
    for(Index i = 0; i < graph.nodes.size(); ++i)
      if(left_.is_leaf(i))
        leaves_.push_back(i);
    constexpr std::size_t seldom = 64; // rows: their edges have widths to be measured
    for(std::size_t number = 0; !leaves_.empty(); ++number)
    {
      if(number % seldom == 0)
        cutting((std::min)(1., static_cast<double>(number) / static_cast<double>(graph.edges.size())));
      const Index leaf = leaves_.back();
      leaves_.pop_back();
      if(left_.is_leaf(leaf))
        cut_row(leaf);
    }
  }

  std::vector<Index> edges() const
  {
    std::vector<Index> result;
    for(Index e = 0; e < is_kept_.size(); ++e)
      if(is_kept_[e])
        result.push_back(e);
    return result;
  }

private:
  void cut_row(Index leaf)
  {
    const Index end = find_row(leaf);
    has_two_leaves_ = left_.is_leaf(end);
    const std::size_t first = outermost_strong();
    remove(leaf, first);
    if(first == row_.size())
    {
      if(left_.is_leaf(end))
        leaves_.push_back(end);
      return;
    }
    if(!has_two_leaves_)
      return;
    row_.erase(row_.begin(), row_.begin() + static_cast<std::ptrdiff_t>(first));
    std::reverse(row_.begin(), row_.end());
    remove(end, outermost_strong());
  }

  /// the edges from a leaf to the node at its end, which is returned
  Index find_row(Index leaf)
  {
    row_.clear();
    Index i = leaf, e = left_.last(leaf);
    for(;;)
    {
      row_.push_back(e);
      i = Edges_left::other(graph_.edges[e].nodes, i);
      if(left_.degree(i) != 2)
        return i;
      e = left_.next(i, e);
    }
  }

  /// takes the first edges of the row away, from a leaf on
  void remove(Index leaf, std::size_t number)
  {
    for(std::size_t k = 0; k < number; ++k)
    {
      const auto& nodes = graph_.edges[row_[k]].nodes;
      is_kept_[row_[k]] = 0;
      left_.remove(row_[k], nodes);
      leaf = Edges_left::other(nodes, leaf);
    }
  }

  /// its position in the row, or the size of that if there is none
  std::size_t outermost_strong()
  {
    known_.clear();
    enclosing_.clear();
    for(std::size_t i = 0; i < row_.size(); ++i)
      if(graph_.edges[row_[i]].piece != null_index && (!known_.empty() || can_be_(row_[i])))
      {
        known_.push_back(i);
        const double enclosed = enclosed_(row_[i]);
        if(enclosed >= least_.enclosed)
          enclosing_.push_back({i, enclosed});
      }
    const std::size_t enclosing = outermost_enclosing();
    known_.erase(std::lower_bound(known_.begin(), known_.end(), enclosing), known_.end());
    return (std::min)(enclosing, outermost_of_width(known_, least_.width));
  }

  /// the same for those that enclose enough
  std::size_t outermost_enclosing()
  {
    constexpr double rounding = 1e-6;
    for(std::size_t begin = 0, end = 0; begin < enclosing_.size(); begin = end)
    {
      positions_.clear();
      do
        positions_.push_back(enclosing_[end++].position);
      while(end < enclosing_.size() && std::fabs(enclosing_[end].enclosed - enclosing_[begin].enclosed) < rounding);
      if(is_wide_(row_[positions_.back()], least_.narrow))
        return outermost_of_width(positions_, least_.narrow);
    }
    return row_.size();
  }

  /// the same for positions in the row, of edges that have that width
  std::size_t outermost_of_width(const std::vector<std::size_t>& positions, double width) const
  {
    const auto is_wide = [&](std::size_t k) { return is_wide_(row_[positions[k]], width); };
    std::size_t tries = has_two_leaves_ ? positions.size() : 0;
    for(std::size_t n = positions.size(); n > 0 && !has_two_leaves_; n /= 2)
      ++tries;
    std::size_t begin = 0;
    for(std::size_t k = 1; k <= tries; ++k)
    {
      std::size_t last = positions.size() * k / tries - 1;
      if(!is_wide(last))
      {
        begin = last + 1;
        continue;
      }
      while(begin < last)
      {
        const std::size_t middle = (begin + last) / 2;
        if(is_wide(middle))
          last = middle;
        else
          begin = middle + 1;
      }
      return positions[last];
    }
    return row_.size();
  }

  const Tree_graph& graph_;
  const Branch_strength& least_;
  const Can_be& can_be_;
  const Enclosed& enclosed_;
  const Is_wide& is_wide_;
  Edges_left left_;
  std::vector<unsigned char> is_kept_; // by edge
  std::vector<Index> leaves_;
  bool has_two_leaves_ = false;
  std::vector<Index> row_; // in work: its edges, from the leaf on
  struct Enclosing
  {
    std::size_t position;
    double enclosed;
  };
  // positions in it, from the first that may be strong, of edges that are known, and of those that enclose enough
  std::vector<std::size_t> known_, positions_;
  std::vector<Enclosing> enclosing_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_STRONG_BRANCHES_H
