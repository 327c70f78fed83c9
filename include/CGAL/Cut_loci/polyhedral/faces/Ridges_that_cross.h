// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_THAT_CROSS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_THAT_CROSS_H

#include <CGAL/Cut_loci/polyhedral/faces/draw_by_labels.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// tells whether pieces in a face cross each other, so that the labels they come from do not fit.
class Ridges_that_cross
{
public:
  /// whether two of these pieces do that are on the cut locus
  bool operator()(const std::array<Plane_point, 3>& corners, const std::vector<Plane_point>& nodes,
                  const std::vector<Face_ridge>& ridges)
  {
    if(ridges.size() < 2)
      return false;
    // the intervals that they take along the longest edge, by their begins
    Index longest = 0;
    for(Index i = 1; i < 3; ++i)
      if(squared_distance(corners[i], corners[(i + 1) % 3]) >
         squared_distance(corners[longest], corners[(longest + 1) % 3]))
        longest = i;
    const Plane_point &a = corners[longest], &b = corners[(longest + 1) % 3];
    nodes_ = &nodes;
    rounding_ = 1e-8 * std::sqrt(squared_distance(a, b));
    intervals_.clear();
    for(Index i = 0; i < ridges.size(); ++i)
      if(!ridges[i].is_shadow)
      {
        const Plane_point &p = nodes[ridges[i].nodes[0]], &q = nodes[ridges[i].nodes[1]];
        const double s = p.x * (b.x - a.x) + p.y * (b.y - a.y), t = q.x * (b.x - a.x) + q.y * (b.y - a.y);
        intervals_.push_back({(std::min)(s, t), (std::max)(s, t), i});
      }
    std::sort(intervals_.begin(), intervals_.end(),
              [](const Interval& i, const Interval& j) { return i.begin < j.begin; });
    for(std::size_t i = 0; i < intervals_.size(); ++i)
      for(std::size_t j = i + 1; j < intervals_.size() && intervals_[j].begin < intervals_[i].end; ++j)
        if(cross_each_other(ridges[intervals_[i].ridge], ridges[intervals_[j].ridge]))
          return true;
    return false;
  }

private:
  bool cross_each_other(const Face_ridge& r, const Face_ridge& s) const
  {
    if(r.nodes[0] == s.nodes[0] || r.nodes[0] == s.nodes[1] || r.nodes[1] == s.nodes[0] || r.nodes[1] == s.nodes[1])
      return false;
    const Plane_point &a = (*nodes_)[r.nodes[0]], &b = (*nodes_)[r.nodes[1]];
    const Plane_point &c = (*nodes_)[s.nodes[0]], &d = (*nodes_)[s.nodes[1]];
    return are_apart(a, b, c, d) && are_apart(c, d, a, b);
  }

  /// whether `c` and `d` are on different sides of the line through `a` and `b`; where four pieces meet, there are two
  /// nodes in one point, and rounding alone puts one of them across
  bool are_apart(const Plane_point& a, const Plane_point& b, const Plane_point& c, const Plane_point& d) const
  {
    const double at_c = cross(a, b, c), at_d = cross(a, b, d), least = (std::min)(std::fabs(at_c), std::fabs(at_d));
    return at_c * at_d < 0. && least * least > rounding_ * rounding_ * squared_distance(a, b);
  }

  struct Interval
  {
    double begin, end;
    Index ridge;
  };

  const std::vector<Plane_point>* nodes_ = nullptr;
  double rounding_ = 0.;
  std::vector<Interval> intervals_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGES_THAT_CROSS_H
