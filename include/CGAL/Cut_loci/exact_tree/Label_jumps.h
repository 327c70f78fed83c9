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
 * tells whether the cut locus crosses a halfedge with more than a least angle between the paths, from its windows alone.
 *
 * Two paths to a point that leave the source at a smaller angle may still be told apart here; the other way round, what
 * is not told apart has a smaller angle.
 */
class Label_jumps
{
public:
  Label_jumps(const Geodesic_results& geodesics, double least_angle)
    : geodesics_(geodesics), parting_angle_(geodesics), least_angle_(least_angle)
  {
  }

  bool finds_all() const { return least_angle_ == 0.; }

  /// whether two neighbors in the list differ
  bool between_windows(const Geodesic_window_list& list) const
  {
    const double *b = list.column(1), *x = list.column(2), *y = list.column(3), *turn = list.column(5),
                 *origin = list.column(6);
    const double bound = least_angle_ * least_angle_;
    // The image of a neighbor moves by more than the angle seen from the point between them: a sum without branches.
    int number_of_changes = 0;
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
    {
      const double ux = x[i] - b[i], dx = x[i + 1] - x[i], dy = y[i + 1] - y[i];
      const double uu = ux * ux + y[i] * y[i];
      number_of_changes += int(dx * dx + dy * dy > bound * uu) | int(std::fabs(turn[i] - turn[i + 1]) > least_angle_) |
                           int(origin[i] != origin[i + 1]);
    }
    if(number_of_changes == 0)
      return false;
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
      if(origin[i] == origin[i + 1] ? differ(x, y, turn, b[i], i) : meet(x, y, b[i], i))
        return true;
    return false;
  }

  /// whether a path that is in no window leads to an end, `a` or `b`, of the halfedge
  ///
  /// Where another label takes over before the end, the distance there is less than the last window says: by the
  /// distance to that point times the difference of two slopes, which the angle bounds.
  bool at_ends(const Geodesic_window& first, const Geodesic_window& last, double length, Index a, Index b) const
  {
    const double rounding = geodesic_cover * length;
    return first.distance(0.) - geodesics_.distance(a) > least_angle_ * first.a + rounding ||
           last.distance(length) - geodesics_.distance(b) > least_angle_ * (length - last.b) + rounding;
  }

  /// whether the path of a window to the end `v` of the halfedge is another one than that which is known
  bool leads_elsewhere(const Geodesic_window& w, double t, Index v) const
  {
    if(geodesics_.distance(v) == 0. || !geodesics_.is_reached(v))
      return !geodesics_.is_reached(v);
    const Path_label label{w.x, w.y, w.sigma, w.turn, static_cast<Index>(w.origin), false};
    const Geodesic_arrival& arrival = geodesics_.arrival(v);
    return parting_angle_(label.origin, label.direction(t), arrival.origin,
                          Geodesic_results::direction_at_origin(arrival, geodesics_.end_in_frame(arrival, v))) >
           least_angle_;
  }

private:
  bool differ(const double* x, const double* y, const double* turn, double t, std::size_t i) const
  {
    const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], ux = x[i] - t;
    return dx * dx + dy * dy > least_angle_ * least_angle_ * (ux * ux + y[i] * y[i]) ||
           std::fabs(turn[i] - turn[i + 1]) > least_angle_;
  }

  /// paths from different origins that meet at an angle; one that comes straight through the other is no other path
  bool meet(const double* x, const double* y, double t, std::size_t i) const
  {
    const double ux = x[i] - t, uy = y[i], vx = x[i + 1] - t, vy = y[i + 1];
    const double cross = ux * vy - uy * vx;
    return cross * cross > least_angle_ * least_angle_ * (ux * ux + uy * uy) * (vx * vx + vy * vy) ||
           ux * vx + uy * vy < 0.;
  }

  const Geodesic_results& geodesics_;
  Parting_angle parting_angle_;
  double least_angle_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_LABEL_JUMPS_H
