// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_STRAIGHT_WALK_H
#define CGAL_CUT_LOCI_GEODESICS_STRAIGHT_WALK_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Cut_loci::internal {

/*!
 * walks straight, from face to face, as accurately as rounding allows: at a vertex it goes on as if it had passed on one
 * side. It is over at the border, along which it may run.
 */
class Straight_walk
{
public:
  static constexpr double rounding = 1e-12; // of directions

  /// is the line in a face: from a point in the frame of a halfedge of the face, which is the one through which it has
  /// entered, but for the first face, in a direction of length 1.
  struct Line
  {
    Index halfedge;
    Plane_point from;
    double dx, dy;
  };

  /// starts at an origin, in a direction as by `direction_at_source()`, or, at a pseudo-source, by `direction_at_origin()`,
  /// and walks to where it leaves the first face
  Straight_walk(const Geodesic_results& geodesics, Index origin, double direction)
    : faces_(geodesics.faces()), line_(start(geodesics, origin, direction))
  {
    leave_first_face();
  }

  bool is_over() const { return line_.halfedge == null_index; }
  /// how far it has come
  double way() const { return way_; }
  /// the line in the face that it has left last
  const Line& last() const { return last_; }

  /// where the last face was entered
  Indexed_location last_entry() const { return location(last_.halfedge, last_.from); }
  /// the point in the last face after a way that ends there, or farther away: then where that face was left
  Indexed_location at(double way) const
  {
    const double rest = (std::min)(way - way_, 0.) + step_;
    return location(last_.halfedge, {last_.from.x + rest * last_.dx, last_.from.y + rest * last_.dy});
  }

  /// goes to where it leaves the next face
  void leave_face()
  {
    last_ = line_;
    const Geodesic_face& face = faces_.face_of(line_.halfedge);
    const Index i = line_.halfedge % 3, j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    const Geodesic_face::Corner &a = face.corner[i], &b = face.corner[j];
    const double t = line_.from.x, dx = line_.dx, dy = line_.dy, left = face.corner[k].length;
    const double out_right = dx * b.sine + dy * b.cosine, out_left = dy * a.cosine - dx * a.sine;
    // of the line to the apex; where rounding leaves no way on there, at a vertex, it is the other side
    const bool is_right = dx * left * a.sine > dy * (left * a.cosine - t) ? leads_out(out_right, face.opposite[j])
                                                                          : !leads_out(out_left, face.opposite[k]);
    if(!((is_right ? out_right : out_left) > 0.))
      return stop();
    if(is_right)
    {
      step((a.length - t) * b.sine / out_right);
      enter(face.opposite[j], b.length - step_ * dy / b.sine, b.length, dx * b.cosine - dy * b.sine, out_right);
    }
    else
    {
      step(t * a.sine / out_left);
      enter(face.opposite[k], step_ * dy / a.sine, left, dx * a.cosine + dy * a.sine, out_left);
    }
  }

private:
  using Mesh = Indexed_triangle_mesh;

  /// the sine of the angle of a line with an edge; along the border, rounding leads it out
  static bool leads_out(double sine, Index opposite) { return sine > (opposite == null_index ? rounding : 0.); }

  Line start(const Geodesic_results& geodesics, Index origin, double direction) const
  {
    if(!geodesics.is_source(origin))
    {
      const Geodesic_direction back = geodesics.arrival_direction(geodesics.vertex_of_origin(origin));
      return start_at_vertex(back.halfedge, direction + back.angle);
    }
    const Index h = geodesics.source_halfedge(origin);
    if(geodesics.source_vertex(origin) != null_index)
      return start_at_vertex(h, direction);
    const std::array<double, 3>& c = geodesics.source_location(origin).coordinates;
    if(geodesics.source_edge(origin) == null_index)
      return {h, faces_.in_frame(h, c), std::cos(direction), std::sin(direction)};
    const double t = c[Mesh::next(h) % 3] * faces_.length(h), s = std::sin(direction);
    if(s >= 0. || faces_.opposite(h) == null_index)
      return {h, {t, 0.}, std::cos(direction), std::fabs(s)};
    return {faces_.opposite(h), {faces_.length(h) - t, 0.}, -std::cos(direction), -s};
  }

  /// at this angle from `h`, counterclockwise around its source
  Line start_at_vertex(Index h, double angle) const
  {
    const Geodesic_direction start = faces_.direction(h, angle);
    return {start.halfedge, {0., 0.}, std::cos(start.angle), std::sin(start.angle)};
  }

  void leave_first_face()
  {
    last_ = line_;
    const Index h = line_.halfedge;
    const std::array<Plane_point, 3> c = {{{0., 0.}, {faces_.length(h), 0.}, faces_.apex(h)}};
    double way = (std::numeric_limits<double>::infinity)();
    Index exit = null_index;
    const bool is_inside = line_.from.y > 0., is_at_vertex = !is_inside && line_.from.x == 0.;
    for(Index i = is_inside ? 0 : 1; i < (is_at_vertex ? 2 : 3); ++i) // not through edges on which it starts
    {
      const Plane_point &p = c[i], &q = c[(i + 1) % 3];
      const double side = (q.x - p.x) * line_.dy - (q.y - p.y) * line_.dx; // negative if it leads out
      const double s = ((q.x - p.x) * (line_.from.y - p.y) - (q.y - p.y) * (line_.from.x - p.x)) / -side;
      if(side < 0. && s < way)
      {
        way = s;
        exit = i;
      }
    }
    if(exit == null_index)
      return stop();
    step((std::max)(way, 0.));
    const Index g = 3 * (h / 3) + (h % 3 + exit) % 3;
    const Plane_point &p = c[exit], &q = c[(exit + 1) % 3];
    const double l = faces_.length(g), ux = (p.x - q.x) / l, uy = (p.y - q.y) / l; // along the opposite
    const double x = line_.from.x + step_ * line_.dx - q.x, y = line_.from.y + step_ * line_.dy - q.y;
    enter(faces_.opposite(g), x * ux + y * uy, l, line_.dx * ux + line_.dy * uy, line_.dy * ux - line_.dx * uy);
  }

  void step(double length)
  {
    step_ = length;
    way_ += length;
  }

  void enter(Index h, double t, double length, double dx, double dy)
  {
    line_ = {h, {(std::min)((std::max)(t, 0.), length), 0.}, dx, dy};
  }

  void stop()
  {
    line_.halfedge = null_index;
    step(0.);
  }

  /// a point in the frame of `h`
  Indexed_location location(Index h, const Plane_point& p) const
  {
    const Plane_point apex = faces_.apex(h);
    const double third = p.y / apex.y, second = (p.x - third * apex.x) / faces_.length(h);
    std::array<double, 3> c;
    c[h % 3] = 1. - second - third;
    c[Mesh::next(h) % 3] = second;
    c[Mesh::previous(h) % 3] = third;
    return {h / 3, c};
  }

  const Geodesic_faces& faces_;
  Line line_, last_{};
  double way_ = 0., step_ = 0.; // in all, and in the last face
};

/// the end of a straight walk from source number `i`, in a direction of its tangent plane in which angles are scaled, from
/// 0 to 2 pi. A source on the border stays where it is if the direction does not lead into the surface.
inline Indexed_location end_of_straight_walk(const Geodesic_results& geodesics, Index i, double angle, double length)
{
  constexpr double rounding = Straight_walk::rounding; // else directions along the border may be behind it
  double direction = angle / geodesics.angle_scale(i);
  if(geodesics.is_source_on_border(i) && direction > geodesics.source_angle(i) + rounding)
  {
    if(direction < 2. * geodesic_pi - rounding)
      return geodesics.source_location(i);
    direction -= 2. * geodesic_pi;
  }
  Straight_walk walk(geodesics, i, direction);
  while(walk.way() < length && !walk.is_over())
    walk.leave_face();
  Indexed_location end = walk.at(length);
  double sum = 0.;
  for(double& c : end.coordinates)
    sum += c = (std::max)(c, 0.);
  for(double& c : end.coordinates)
    c /= sum;
  return end;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_STRAIGHT_WALK_H
