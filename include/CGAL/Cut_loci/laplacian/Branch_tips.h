// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_BRANCH_TIPS_H
#define CGAL_CUT_LOCI_LAPLACIAN_BRANCH_TIPS_H

#include <CGAL/Cut_loci/laplacian/Branch_filter.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Follows branches from where they are strong to their tips.
//
// The angle at which shortest paths meet falls to zero at a tip: where a branch must pass an angle, it ends before the
// tip by a length that belongs to the surface, not to the mesh. What tells the tip is the distance beyond it, where it
// is smooth. There the paths converge already: where its Laplacian is -1 / r, neighbors meet r farther from the source,
// but for what the curvature of the surface changes, which is of the third order in r. The first of these meetings is
// the tip. So a branch goes on to a vertex if paths that pass beyond it meet no farther from the source than it is.
// No angle and no length is asked for. Where errors have paths meet, they are not followed. So two things are subtracted
// first: by how much vertices differ from their neighbors, which is noise, and by how much the length of the gradient
// differs from 1, which it is for distances. Where an error of the distance grows by this share of the way, it can change
// the Laplacian by as much in a mean edge length.
class Branch_tips
{
public:
  // `laplacian` is that of `distance`, times the mean edge length, `noise` what `noise_of()` says of it, and `slope_error`
  // how far the length of the gradient is from 1.
  Branch_tips(const Mesh_connectivity& connectivity, const std::vector<double>& distance,
              const std::vector<float>& laplacian, float noise, const std::vector<float>& slope_error,
              const Branch_filter& filter)
    : connectivity_(connectivity), distance_(distance), laplacian_(laplacian), noise_(noise), slope_error_(slope_error),
      filter_(filter)
  {
  }

  // By how much a value may differ from the mean around it because of errors: two standard deviations, which are three
  // times the median if errors are normal. Most vertices are far from the cut locus. Where a source is, there is no value
  // to compare: those next to it do not count.
  static float noise_of(const Mesh_connectivity& connectivity, const std::vector<float>& laplacian)
  {
    const auto exists = [&](Index v) { return laplacian[v] < (std::numeric_limits<float>::max)(); };
    const auto first = connectivity.ring_vertex.begin();
    std::vector<float> difference;
    for(Index v = 0; v < laplacian.size(); ++v)
      if(exists(v) && std::all_of(first + connectivity.ring_begin[v], first + connectivity.ring_begin[v + 1], exists))
        difference.push_back(static_cast<float>(std::abs(laplacian[v] - mean_around(connectivity, laplacian, v))));
    if(difference.empty())
      return 0.f;
    const auto middle = difference.begin() + static_cast<std::ptrdiff_t>(difference.size() / 2);
    std::nth_element(difference.begin(), middle, difference.end());
    return 3.f * *middle;
  }

  // Adds what follows the leaves of a result of the filter. The root is none: where it has one branch, no other was strong.
  void operator()(Branch_filter::Result& result) const
  {
    std::vector<Index> ends; // of edges, but for the one from each vertex to its parent
    for(std::size_t i = 0; i < result.edges.size(); ++i)
    {
      ends.push_back(result.edges[i].parent);
      if(i + 1 >= result.vertices.size())
        ends.push_back(result.edges[i].vertex);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<Branch_filter::Edge> added;
    for(std::size_t i = 1; i < result.vertices.size(); ++i)
      if(!std::binary_search(ends.begin(), ends.end(), result.vertices[i]))
        follow(result.vertices[i], added);
    const auto end_of_tree = static_cast<std::ptrdiff_t>(result.vertices.size() - 1);
    for(const Branch_filter::Edge& e : added)
      result.vertices.push_back(e.vertex);
    result.edges.insert(result.edges.begin() + end_of_tree, added.begin(), added.end());
  }

private:
  void follow(Index leaf, std::vector<Branch_filter::Edge>& added) const
  {
    Branch_filter::Edge e;
    for(bool exists = next(leaf, e); exists && is_before_tip(e.vertex); exists = next(e.vertex, e))
      added.push_back(e);
  }

  bool next(Index v, Branch_filter::Edge& e) const
  {
    return !connectivity_.is_border(v) && filter_.strongest_child(v, e) && !connectivity_.is_border(e.vertex);
  }

  // Estimates from farther beyond the tip are worse, as the Laplacian is smaller there. So none is looked for beyond the
  // best one found by more than that is beyond the place where it has paths meet.
  bool is_before_tip(Index v) const
  {
    double least = (std::numeric_limits<double>::infinity)(), last = distance_[v];
    bool is_in_tree = true;
    for(Index w = v; w != null_index && distance_[w] >= last; w = beyond(w, is_in_tree))
    {
      const double convergence = convergence_around(w);
      if(!(convergence > 0.))
        continue;
      const double meeting = distance_[w] + 1. / convergence;
      if(meeting <= distance_[v])
        return true;
      if(meeting < least)
      {
        least = meeting;
        last = distance_[w] - 1. / convergence;
      }
    }
    return false;
  }

  // The next vertex of the tree, and from where that ends on, the neighbor that is nearest to the source.
  Index beyond(Index v, bool& is_in_tree) const
  {
    Branch_filter::Edge e;
    is_in_tree = is_in_tree && next(v, e);
    if(is_in_tree)
      return e.vertex;
    Index result = null_index;
    double least = distance_[v];
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
      if(const Index w = connectivity_.ring_vertex[entry]; distance_[w] < least)
      {
        least = distance_[w];
        result = w;
      }
    return result;
  }

  // How much paths converge for sure, from minus the Laplacian: its mean, as the branch passes between vertices.
  double convergence_around(Index v) const
  {
    return (-mean_around(connectivity_, laplacian_, v) - noise_ - mean_around(connectivity_, slope_error_, v)) /
           connectivity_.mean_edge_length;
  }

  // over a vertex and its neighbors
  static double mean_around(const Mesh_connectivity& connectivity, const std::vector<float>& values, Index v)
  {
    double sum = values[v];
    for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      sum += values[connectivity.ring_vertex[entry]];
    return sum / (1. + connectivity.valence(v));
  }

  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
  const std::vector<float>& laplacian_;
  float noise_;
  const std::vector<float>& slope_error_;
  const Branch_filter& filter_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_BRANCH_TIPS_H
