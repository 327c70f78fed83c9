// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_JUMPS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_JUMPS_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/Vertex_labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

/*!
 * tells whether the cut locus crosses a halfedge where it matters, from the windows alone: where the two paths part at
 * more than the angle that a least strength of branches needs, or meet at one that is not small.
 */
class Label_jumps
{
public:
  /// @param share of these angles
  Label_jumps(const Geodesic_results& geodesics, const Vertex_labels& at_vertices, const Branch_strength& least,
              double share)
    : geodesics_(geodesics), at_vertices_(at_vertices), parting_angle_(geodesics), least_(least), share_(share),
      steep_(share * steep)
  {
  }

  /// branches get weak on their way, and a smaller share would add many faces on rough surfaces
  static constexpr double linking_share = 0.5;

  /// whether no branch of the least strength, nor what links two of them, is where the paths to a point part and meet so
  static bool is_weak(const Branch_strength& least, const Parting_angle::Parting& parting, double meeting,
                      double distance)
  {
    return !least.is_none() && meeting <= linking_share * steep &&
           parting.angle <= linking_share * least.least_angle(distance - parting.distance);
  }

  /// prepares for the halfedge from `a` to `b`
  void start(Index a, Index b, double length)
  {
    a_ = a;
    b_ = b;
    length_ = length;
    distance_ = (std::min)(geodesics_.distance(a), geodesics_.distance(b)) + length;
    least_angle_ = share_ * least_.least_angle(distance_);
  }

  /// whether two neighbors in the list differ
  template <int columns>
  bool between_windows(const Geodesic_window_list& list) const
  {
    if(columns > 7)
      return between_merged_windows<columns>(list);
    const double *b = list.column(1), *x = list.column(2), *y = list.column(3), *turn = list.column(5),
                 *origin = list.column(6);
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
    {
      // The paths meet at the angle between the images; what is left of it at the source is as their frames are turned.
      const double ux = x[i] - b[i], vx = x[i + 1] - b[i], uu = ux * ux + y[i] * y[i];
      const double cross = ux * y[i + 1] - y[i] * vx;
      // both are evaluated, without a branch: it would be hard to predict
      const bool bends = (origin[i] != origin[i + 1]) &
                         (cross * cross > least_meeting * least_meeting * uu * (vx * vx + y[i + 1] * y[i + 1]));
      const bool parts =
        (origin[i] == origin[i + 1]) &
        ((std::fabs((turn[i + 1] - turn[i]) * uu + cross) > least_angle_ * uu) | (std::fabs(cross) > steep_ * uu));
      if((bends | parts) && differ(list.get<7>(i), list.get<7>(i + 1), b[i]))
        return true;
    }
    return false;
  }

  /// the same for windows whose directions do not turn as the rays do
  template <int columns>
  bool between_merged_windows(const Geodesic_window_list& list) const
  {
    for(std::size_t i = list.begin; i + 1 < list.end; ++i)
    {
      const Geodesic_window w = list.get<columns>(i);
      if(differ(w, list.get<columns>(i + 1), w.b))
        return true;
    }
    return false;
  }

  /// whether a path that is in no window leads to an end of the halfedge
  bool at_ends(const Geodesic_window& first, const Geodesic_window& last) const
  {
    return at_end(first, first.a, 0., a_) || at_end(last, last.b, length_, b_);
  }

  /// whether the paths of the windows to the ends of the halfedge are other ones than those that are known: two labels
  /// that mirror each other in the edge have the same distances on it
  bool is_mirrored(const Geodesic_window& first, const Geodesic_window& last) const
  {
    return leads_elsewhere(first, 0., a_) || leads_elsewhere(last, length_, b_);
  }

  /// by how much the distance has turned downward between the path to one end and the other end, as a share of the edge:
  /// at most about the angle between the two
  double bend(const Geodesic_window& first, const Geodesic_window& last) const
  {
    return (std::min)(tangent(first, first.a, length_) - geodesics_.distance(b_),
                      tangent(last, last.b, 0.) - geodesics_.distance(a_)) /
           length_;
  }

private:
  static constexpr double least_meeting = 1e-7; // of paths that do not come along one line
  // Beside a point where paths meet at less than that, the way to it is longer by less than that share of an edge.
  static constexpr double steep = 0.1;

  bool leads_elsewhere(const Geodesic_window& w, double t, Index v) const
  {
    const double d = geodesics_.distance(v);
    if(d == 0. || !geodesics_.is_reached(v))
      return d != 0.;
    const Index origin = static_cast<Index>(w.origin), known_origin = geodesics_.arrival(v).origin;
    const double direction = label(w).direction(t), known = at_vertices_.direction_at_origin(v);
    // At which angle the two meet is not known here. From a curve, where it would count, they do if they are not the same.
    const bool is_same =
      geodesics_.is_line(origin) && origin == known_origin && std::fabs(direction - known) < least_meeting;
    return part_enough(origin, direction, known_origin, known, is_same ? 0. : geodesic_pi);
  }

  static Path_label label(const Geodesic_window& w)
  {
    return {w.x, w.y, w.sigma, w.turn, static_cast<Index>(w.origin), false, w.rate};
  }

  bool differ(const Geodesic_window& u, const Geodesic_window& v, double t) const
  {
    const Path_label a = label(u), b = label(v);
    const double meeting = meeting_angle(a, b, t);
    if(geodesics_.is_seam(a.origin, b.origin, meeting))
      return false;
    return meeting > steep_ || part_enough(a.origin, a.direction(t), b.origin, b.direction(t), meeting);
  }

  /// Paths that go together up to a vertex nearby get no farther apart than they can from there on.
  bool part_enough(Index a, double a_direction, Index b, double b_direction, double meeting) const
  {
    const Parting_angle::Parting parting = parting_angle_.parting(a, a_direction, b, b_direction, meeting);
    return parting.angle > share_ * least_.least_angle(distance_ - parting.distance);
  }

  /// Along an edge, the distance by one path is convex, and where a shadow begins it goes on with the same slope. So it
  /// stays above its tangents up to where another path takes over. There it turns downward, by no more than the angle at
  /// which the two meet.
  bool at_end(const Geodesic_window& w, double from, double to, Index v) const
  {
    const double excess = tangent(w, from, to) - geodesics_.distance(v) - geodesic_cover * length_;
    return excess > 0. && (excess > steep_ * std::fabs(to - from) || leads_elsewhere(w, to, v));
  }

  static double tangent(const Geodesic_window& w, double from, double to)
  {
    const double r = w.distance(from) - w.sigma;
    return r > 0. ? w.distance(from) + (from - w.x) / r * (to - from) : w.distance(to);
  }

  const Geodesic_results& geodesics_;
  const Vertex_labels& at_vertices_;
  Parting_angle parting_angle_;
  Branch_strength least_;
  double share_, steep_;
  // of the halfedge in work
  Index a_ = 0, b_ = 0;
  double length_ = 0., distance_ = 0., least_angle_ = 0.; // the last for paths that part at the source
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_LABEL_JUMPS_H
