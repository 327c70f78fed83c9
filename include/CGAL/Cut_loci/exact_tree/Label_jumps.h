// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_LABEL_JUMPS_H
#define CGAL_CUT_LOCI_EXACT_TREE_LABEL_JUMPS_H

#include <CGAL/Cut_loci/exact_tree/Path_label.h>
#include <CGAL/Cut_loci/internal/Exact_geodesic_propagation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * tells whether the cut locus crosses a halfedge where it matters, from the windows alone: where the two paths part at
 * more than a least angle, or meet at one that is not small.
 */
class Label_jumps
{
public:
  Label_jumps(const Geodesic_results& geodesics, double least_angle)
    : geodesics_(geodesics), parting_angle_(geodesics), least_angle_(least_angle),
      steep_((std::max)(least_angle, 0.1))
  {
  }

  bool finds_all() const { return least_angle_ == 0.; }

  /// whether two neighbors in the list differ
  bool between_windows(const Geodesic_window_list& list) const
  {
    const double *b = list.column(1), *x = list.column(2), *y = list.column(3), *turn = list.column(5),
                 *origin = list.column(6);
    // The angle at which paths meet is the sine of it, over one square, and what is left of it at the source is as their
    // frames are turned: a sum without branches, which says no nearly always.
    int number = 0;
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
    {
      const double ux = x[i] - b[i], vx = x[i + 1] - b[i], uu = ux * ux + y[i] * y[i];
      const double cross = ux * y[i + 1] - y[i] * vx, gap = (turn[i + 1] - turn[i]) * uu + cross;
      number += int(std::fabs(gap) > least_angle_ * uu) | int(std::fabs(cross) > steep_ * uu) |
                int(origin[i] != origin[i + 1]);
    }
    if(number == 0)
      return false;
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
      if(differ(list.get<7>(i), list.get<7>(i + 1), b[i]))
        return true;
    return false;
  }

  /// whether a path that is in no window leads to an end, `a` or `b`, of the halfedge
  bool at_ends(const Geodesic_window& first, const Geodesic_window& last, double length, Index a, Index b) const
  {
    return at_end(first, 0., first.a, length, a) || at_end(last, length, length - last.b, length, b);
  }

  /// whether the path of a window to the end `v` of the halfedge is another one than that which is known
  bool leads_elsewhere(const Geodesic_window& w, double t, Index v) const
  {
    if(geodesics_.distance(v) == 0. || !geodesics_.is_reached(v))
      return !geodesics_.is_reached(v);
    const Geodesic_arrival& arrival = geodesics_.arrival(v);
    return parting_angle_(static_cast<Index>(w.origin), label(w).direction(t), arrival.origin,
                          Geodesic_results::direction_at_origin(arrival, geodesics_.end_in_frame(arrival, v))) >
           least_angle_;
  }

private:
  static Path_label label(const Geodesic_window& w)
  {
    return {w.x, w.y, w.sigma, w.turn, static_cast<Index>(w.origin), false};
  }

  bool differ(const Geodesic_window& u, const Geodesic_window& v, double t) const
  {
    const Path_label a = label(u), b = label(v);
    return meeting_angle(a, b, t) > steep_ || parting_angle_(a, b, t) > least_angle_;
  }

  /// Where another path takes over before the end, the distance there is less than the window says: by what is left times
  /// the difference of two slopes, which the angle at which they meet bounds.
  bool at_end(const Geodesic_window& w, double t, double rest, double length, Index v) const
  {
    const double excess = w.distance(t) - geodesics_.distance(v) - geodesic_cover * length;
    return excess > 0. && (excess > steep_ * rest || leads_elsewhere(w, t, v));
  }

  const Geodesic_results& geodesics_;
  Parting_angle parting_angle_;
  double least_angle_;
  double steep_; // beside a point where paths meet at less, the way to it is longer by less than that share of an edge
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_LABEL_JUMPS_H
