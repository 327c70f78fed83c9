// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_BRANCH_WIDTHS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_BRANCH_WIDTHS_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * finds the widths of edges of a graph, up to a hundredth but for few.
 *
 * Each width takes two paths to be followed to the source, and from one edge to the next it changes little. So, of edges
 * in a row of which each meets the next alone, some are measured, until the width changes evenly between these.
 */
template <typename Measure, typename Length>
class Branch_widths
{
public:
  /// @param width of each edge; those in `edges` are set
  /// @param measure returns the width of an edge; called for several at once, if there are threads
  /// @param length returns the length of an edge
  /// @param most edges are passed over at most: between two that are measured the width may be larger than at both
  Branch_widths(const std::vector<Tree_branches::Edge>& edges, Index number_of_nodes, std::size_t most,
                const Measure& measure, const Length& length, std::vector<float>& width, const Threads& threads = {},
                const Progress& progress = {})
    : edges_(edges), measure_(measure), length_(length), width_(width),
      at_nodes_(number_of_nodes, edges.size(), Ends{edges}), is_done_(edges.size(), 0)
  {
    for(Index seed = 0; seed < edges.size(); ++seed)
      if(!is_done_[seed])
        add_row(seed, most);
    for_each(ends_.size(), threads, progress.part(0., 0.3),
             [&](std::size_t i) { at(row_[ends_[i]]) = measured(ends_[i]); });
    for_each(parts_.size(), threads, progress.part(0.3, 1.),
             [&](std::size_t i) { fill_between(parts_[i].first, parts_[i].last); });
  }

private:
  /// of a row, from one edge that is measured to the next
  struct Part
  {
    std::size_t first, last;
  };

  /// calls `function(i)` for all i below `number`: what they set is not what others need
  template <typename Function>
  static void for_each(std::size_t number, const Threads& threads, const Progress& progress, const Function& function)
  {
    constexpr std::size_t block = 8; // the two paths of each edge that is measured take a part of a millisecond
    const std::size_t at_once = block * threads.number_at_once();
    for(std::size_t first = 0; first < number; first += at_once)
    {
      progress(static_cast<double>(first) / static_cast<double>(number));
      const std::size_t end = (std::min)(first + at_once, number);
      threads.run((end - first + block - 1) / block,
                  [&](std::size_t task)
                  {
        const std::size_t begin = first + task * block;
        for(std::size_t i = begin; i < (std::min)(begin + block, end); ++i)
          function(i);
      });
    }
  }

  float& at(Index e) { return width_[edges_[e].edge]; }

  struct Ends
  {
    const std::vector<Tree_branches::Edge>& edges;
    Edges_left::Nodes operator()(Index e) const { return {{edges[e].outer, edges[e].inner}}; }
  };

  Index next(Index e, Index node) const { return at_nodes_.degree(node) == 2 ? at_nodes_.next(node, e) : e; }
  Index other_end(Index e, Index node) const { return edges_[e].outer == node ? edges_[e].inner : edges_[e].outer; }

  void add_row(Index seed, std::size_t most)
  {
    Index e = seed, from = edges_[seed].outer;
    for(Index k = next(e, from); k != e && k != seed; k = next(e, from))
    {
      e = k;
      from = other_end(e, from);
    }
    const std::size_t begin = row_.size();
    double place = 0.;
    for(Index k = e; !is_done_[k]; k = next(e, from))
    {
      e = k;
      is_done_[e] = 1;
      row_.push_back(e);
      place += length_(edges_[e].edge);
      place_.push_back(place);
      from = other_end(e, from);
    }
    ends_.push_back(begin);
    for(std::size_t first = begin; first + 1 < row_.size(); first += most)
    {
      parts_.push_back({first, (std::min)(first + most, row_.size() - 1)});
      ends_.push_back(parts_.back().last);
    }
  }

  /// Widths only grow along a branch: where they are the same at both ends, they are between.
  void fill_between(std::size_t first, std::size_t last)
  {
    if(last < first + 2)
      return;
    const std::size_t middle = halfway(first, last);
    if(is_same(at(row_[first]), at(row_[last])) || is_even(first, middle, last))
    {
      for(std::size_t i = first + 1; i < last; ++i)
        at(row_[i]) = between(first, i, last);
      return;
    }
    at(row_[middle]) = measured(middle);
    fill_between(first, middle);
    fill_between(middle, last);
  }

  /// by length, but never at an end
  std::size_t halfway(std::size_t first, std::size_t last) const
  {
    const auto begin = place_.begin() + static_cast<std::ptrdiff_t>(first),
               end = place_.begin() + static_cast<std::ptrdiff_t>(last);
    return static_cast<std::size_t>(std::lower_bound(begin + 1, end - 1, 0.5 * (*begin + *end)) - place_.begin());
  }

  /// whether the width is the one that is between those of the ends in the middle, and halfway from there to both ends
  bool is_even(std::size_t first, std::size_t middle, std::size_t last)
  {
    return has_width_between(first, middle, last) &&
           (middle < first + 2 || has_width_between(first, halfway(first, middle), last)) &&
           (last < middle + 2 || has_width_between(first, halfway(middle, last), last));
  }
  bool has_width_between(std::size_t first, std::size_t i, std::size_t last)
  {
    return is_same(measured(i), between(first, i, last));
  }

  float between(std::size_t first, std::size_t i, std::size_t last)
  {
    const double way = place_[last] - place_[first];
    const double share = way > 0. ? (place_[i] - place_[first]) / way : 0.;
    return static_cast<float>((1. - share) * at(row_[first]) + share * at(row_[last]));
  }

  float measured(std::size_t i) const { return measure_(edges_[row_[i]].edge); }

  static bool is_same(float a, float b) { return std::fabs(a - b) <= 0.01f * (std::max)(a, b); }

  const std::vector<Tree_branches::Edge>& edges_;
  const Measure& measure_;
  const Length& length_;
  std::vector<float>& width_;
  Edges_left at_nodes_;
  std::vector<unsigned char> is_done_;
  std::vector<Index> row_;        // one after the other
  std::vector<double> place_;     // of the end of each edge in its row
  std::vector<Part> parts_;       // of rows
  std::vector<std::size_t> ends_; // of them
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_BRANCH_WIDTHS_H
