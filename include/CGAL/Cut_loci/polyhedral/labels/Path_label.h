// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_PATH_LABEL_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_PATH_LABEL_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Cut_loci::internal {

/// the angle of a vector with `y >= 0` from the x-axis, as `std::atan2` but faster
inline double upper_angle(double x, double y)
{
  const double r = std::sqrt(x * x + y * y);
  if(!(r > 0.))
    return 0.;
  return x >= 0. ? twice_arc_tangent(y, r + x) : geodesic_pi - twice_arc_tangent(y, r - x);
}

/*!
 * tells which shortest paths reach the points of a part of a halfedge: all those straight ones that come from one image
 * of a source, or of a vertex at which they bend, in the frame of the halfedge.
 */
struct Path_label
{
  double x, y;      // the image; y <= 0 if the paths come from behind the halfedge, and y >= 0 if from its face
  double sigma;     // the distance of the image from the source
  double turn;      // what turns directions of this frame into directions at the origin
  Index origin;     // as in `Geodesic_window`
  bool from_face;   // whether the paths come out of the face of the halfedge
  double rate = 1.; // as in `Geodesic_window`

  double distance(double t) const { return sigma + std::sqrt((t - x) * (t - x) + y * y); }

  /// the direction in which the path to the point `t` leaves its origin, see `Geodesic_results::direction_at_origin()`
  double direction(double t) const
  {
    const double angle = upper_angle(t - x, std::fabs(y));
    return from_face ? turn - rate * angle : turn + rate * angle;
  }

  /// the same in the frame of the opposite halfedge
  Path_label opposite(double length) const
  {
    return {length - x, -y, sigma, turn + (from_face ? -rate : rate) * geodesic_pi, origin, !from_face, rate};
  }
};

/// the angle at which two paths meet in a point, given the vectors from there to their images; zero where one of them bends
/// right there, up to rounding, as nothing tells its direction then
inline double angle_between(double ax, double ay, double bx, double by)
{
  constexpr double rounding = 1e-9;
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by;
  if((std::min)(aa, bb) <= rounding * rounding * (std::max)(aa, bb))
    return 0.;
  return upper_angle(ax * bx + ay * by, std::fabs(ax * by - ay * bx));
}

/// the angle at which the paths of two labels meet in the point `t`: zero if there is one path, in two pieces
inline double meeting_angle(const Path_label& a, const Path_label& b, double t)
{
  return angle_between(a.x - t, a.y, b.x - t, b.y);
}

/// whether the paths of two labels, of which `a` is before the point `t` and `b` behind it, get apart from each other there,
/// from the same side of the edge: no two paths that are shortest up to where they meet do so
inline bool get_apart(const Path_label& a, const Path_label& b, double t)
{
  const double cross = (t - a.x) * b.y - (t - b.x) * a.y;
  return a.from_face == b.from_face && (a.from_face ? cross < 0. : cross > 0.);
}

/*!
 * measures the angle at which two shortest paths to the same point part: at their source or, if they go together for a
 * while, at the vertex at which they bend apart.
 *
 * Paths from different sources part nowhere: the angle is infinite. Those from different points of a curve leave it at
 * right angles: by Gauss-Bonnet, what the two enclose, and the curve between them turns, is the angle at which they meet,
 * which stands for that at which they part.
 */
class Parting_angle
{
public:
  explicit Parting_angle(const Geodesic_results& geodesics) : geodesics_(geodesics) {}

  struct Parting
  {
    double angle;      // the smaller one of the two sectors between them
    double distance;   // of the point where they part, from the source
    double turn, rest; // the sector counterclockwise from the first path to the second one, and the other one: infinite
                       // if the border is in it
  };

  /// of the paths of two labels to the point `t`
  Parting parting(const Path_label& a, const Path_label& b, double t) const
  {
    return parting(a, b, t, meeting_angle(a, b, t));
  }
  /// the same if the angle at which they meet there is known
  Parting parting(const Path_label& a, const Path_label& b, double t, double meeting) const
  {
    return parting(a.origin, a.direction(t), b.origin, b.direction(t), meeting);
  }

  /// for paths that leave their origins in the given directions, and meet at some angle
  double operator()(Index a, double a_direction, Index b, double b_direction, double meeting) const
  {
    return parting(a, a_direction, b, b_direction, meeting).angle;
  }

  /// angles that are rounding: paths pass a vertex at `geodesic_cover` of an edge, and faces are not always well shaped
  static constexpr double least_angle = 1e-7;
  /// Rays that bound a shadow are that inaccurate, as a share of the edge.
  static constexpr double least_width = 10. * geodesic_cover;
  static bool is_same_path(double meeting, double parting) { return meeting < least_angle && parting < least_angle; }

  /// The same for paths of the length `distance` to a point, the later one of which comes straight from an origin at the
  /// distance `sigma`. Where the other one passes that origin, it is aside by the angle at which the later one bends there,
  /// times the harmonic mean of the ways before and behind, and it is shorter by half of that times the angle: the latter
  /// may be less than a rounding. The former may be less than rays are accurate, but where the bend is not small, either:
  /// such a path is as little aside only right at the vertex.
  /// @param length of the longest edge there
  static bool is_same_path(double meeting, const Parting& parting, double distance, double sigma, double length)
  {
    const double before = sigma - parting.distance, behind = distance - sigma, angle = meeting + parting.angle;
    if(is_same_path(meeting, parting.angle))
      return true;
    if(!(before > 0.))
      return false;
    const double aside = angle * before * behind / (before + behind);
    return (aside < least_width * length && angle * angle < least_width) || 0.5 * angle * aside < rounding * distance;
  }

  /// The same for the labels on both sides of a point on a halfedge.
  bool is_same_path(const Path_label& a, const Path_label& b, double t, Index h) const
  {
    const double meeting = meeting_angle(a, b, t);
    return is_same_path(meeting, parting(a, b, t, meeting), a.distance(t), (std::max)(a.sigma, b.sigma),
                        longest_edge_at(h));
  }

  /// of the faces beside a halfedge
  double longest_edge_at(Index h) const
  {
    const Geodesic_faces& faces = geodesics_.faces();
    double result = 0.;
    for(Index g : {h, faces.opposite(h)})
      if(g != null_index)
        for(int i = 0; i < 3; ++i, g = Indexed_triangle_mesh::next(g))
          result = (std::max)(result, faces.length(g));
    return result;
  }

  Parting parting(Index a, double a_direction, Index b, double b_direction, double meeting) const
  {
    if(geodesics_.is_seam(a, b, meeting))
      return alike(0.);
    while(a != b)
    {
      if(geodesics_.is_source(a) && geodesics_.is_source(b))
        return alike(geodesics_.owner(a) == geodesics_.owner(b) ? meeting : infinity);
      // the farther origin comes last on its path; a source is none that comes later, even beside a vertex that is so near
      // to a line that it is below it
      if(!geodesics_.is_source(a) && (geodesics_.is_source(b) || distance(a) >= distance(b)))
        a_direction = geodesics_.step_back(a);
      else
        b_direction = geodesics_.step_back(b);
    }
    if(geodesics_.is_line(a))
      return alike(meeting);
    return sectors(a, b_direction - a_direction);
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  static constexpr double rounding = 1e-14; // of distances, which are sums along a path of many pieces

  /// of paths that part nowhere
  static Parting alike(double angle) { return {angle, 0., angle, angle}; }

  /// between two paths from an origin, given by how much the direction of the second one is farther counterclockwise
  Parting sectors(Index origin, double turn) const
  {
    const bool is_source = geodesics_.is_source(origin);
    const double full =
      is_source ? geodesics_.source_angle(origin) : geodesics_.faces().total_angle(geodesics_.vertex_of_origin(origin));
    const bool is_on_border = is_source ? geodesics_.is_source_on_border(origin)
                                        : geodesics_.faces().is_border(geodesics_.vertex_of_origin(origin));
    if(is_source && !is_on_border)
      turn = std::fmod(turn, full);
    const double inner = std::fabs(turn), outer = is_on_border ? infinity : full - inner;
    const double angle = is_source ? (std::min)(inner, is_on_border ? full : outer) : inner;
    return {angle, is_source ? 0. : distance(origin), turn < 0. ? outer : inner, turn < 0. ? inner : outer};
  }

  double distance(Index origin) const
  {
    return geodesics_.is_source(origin) ? 0. : geodesics_.distance(geodesics_.vertex_of_origin(origin));
  }

  const Geodesic_results& geodesics_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_PATH_LABEL_H
