// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_SEGMENT_CROSSINGS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_SEGMENT_CROSSINGS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells whether segments in a face cross each other, elsewhere than at common ends.
 */
class Segment_crossings
{
public:
  void clear() { segments_.clear(); }

  void add(const Plane_point& p, const Plane_point& q) { segments_.push_back({p, q, 0., 0.}); }

  /// @param least by which the ends of one are on different sides of the other, but for the rounding of coordinates
  bool has_any(double least = 0.)
  {
    if(segments_.size() < 2)
      return false;
    sort();
    least_ = (std::max)(least, least_);
    for(std::size_t i = 0; i < segments_.size(); ++i)
      for(std::size_t j = i + 1; j < segments_.size() && segments_[j].begin < segments_[i].end; ++j)
        if(cross(segments_[i], segments_[j]))
          return true;
    return false;
  }

private:
  struct Segment
  {
    Plane_point p, q;
    double begin, end; // the interval that it takes along an axis
  };

  /// along the axis in which they extend farther
  void sort()
  {
    Plane_point low = segments_.front().p, high = low;
    for(const Segment& s : segments_)
      for(const Plane_point& p : {s.p, s.q})
      {
        low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
        high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
      }
    const bool is_wide = high.x - low.x >= high.y - low.y;
    for(Segment& s : segments_)
    {
      s.begin = is_wide ? (std::min)(s.p.x, s.q.x) : (std::min)(s.p.y, s.q.y);
      s.end = is_wide ? (std::max)(s.p.x, s.q.x) : (std::max)(s.p.y, s.q.y);
    }
    std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) { return a.begin < b.begin; });
    least_ = rounding * (high.x - low.x + high.y - low.y);
  }

  static bool is_same(const Plane_point& p, const Plane_point& q) { return p.x == q.x && p.y == q.y; }

  bool cross(const Segment& s, const Segment& t) const
  {
    if(is_same(s.p, t.p) || is_same(s.p, t.q) || is_same(s.q, t.p) || is_same(s.q, t.q))
      return false;
    return are_apart(s, t) && are_apart(t, s);
  }

  /// whether the ends of `t` are on different sides of the line of `s`, by more than rounding
  bool are_apart(const Segment& s, const Segment& t) const
  {
    const double ux = s.q.x - s.p.x, uy = s.q.y - s.p.y;
    const double a = ux * (t.p.y - s.p.y) - uy * (t.p.x - s.p.x), b = ux * (t.q.y - s.p.y) - uy * (t.q.x - s.p.x);
    return a * b < 0. && (std::min)(std::fabs(a), std::fabs(b)) > least_ * std::sqrt(ux * ux + uy * uy);
  }

  static constexpr double rounding = 1e-14; // of coordinates, as a share of the size

  std::vector<Segment> segments_;
  double least_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_SEGMENT_CROSSINGS_H
