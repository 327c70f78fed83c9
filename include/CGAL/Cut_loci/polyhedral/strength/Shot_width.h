// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/strength/Point_on_path.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * measures the same as `Digon_width` for distances with an error.
 *
 * The images of merged windows are not where their paths start, so that these cannot be traced back. They are shot from
 * their origins instead, straight in the directions that their labels say, and again in the directions that would not
 * have missed the end. So labels that differ by their error alone have the same path. What the last shot misses is made up
 * for along the way, in proportion to its length.
 */
class Shot_width
{
public:
  Shot_width(const Indexed_triangle_mesh& mesh, const Geodesic_results& geodesics)
    : mesh_(mesh), geodesics_(geodesics), faces_(geodesics.faces())
  {
  }

  /// the two paths lead from the images to the point `p` of face `f`; all in the frame of its first halfedge
  double operator()(Index f, const Plane_point& p, const Image& a, const Image& b)
  {
    const std::array<Plane_point, 3> corners = {{{0., 0.}, {faces_.length(3 * f), 0.}, faces_.apex(3 * f)}};
    const double third = p.y / corners[2].y, second = (p.x - third * corners[2].x) / corners[1].x;
    const Vector end = position(mesh_, {f, {{1. - second - third, second, third}}});
    Leg first{a.origin, a.direction_to(p, corners), a.distance(p), spread(a.distance(p) - a.sigma, a.rate), end};
    Leg other{b.origin, b.direction_to(p, corners), b.distance(p), spread(b.distance(p) - b.sigma, b.rate), end};
    for(Path* path : {&first_, &second_})
      path->clear();
    // back to where the two part, the farther origin first
    while(first.origin != other.origin)
    {
      const bool is_first = distance(first.origin) >= distance(other.origin);
      Leg& leg = is_first ? first : other;
      if(geodesics_.is_source(leg.origin))
        break; // paths from two sources
      add(leg, is_first ? first_ : second_);
    }
    shoot(first, first_);
    shoot(other, second_);
    return largest_separation();
  }

private:
  using Mesh = Indexed_triangle_mesh;

  /// is a straight piece of a path.
  struct Leg
  {
    Index origin;
    double direction; // in which it leaves the origin
    double distance;  // of its end, from the source
    double spread;    // by how much the end moves to the left with the direction
    Vector end;
  };

  using Path = std::vector<Point_on_path>; // backward

  double distance(Index origin) const
  {
    return geodesics_.is_source(origin) ? 0. : geodesics_.distance(geodesics_.vertex_of_origin(origin));
  }

  /// adds a leg to the path, and goes on to the one before it
  void add(Leg& leg, Path& path)
  {
    shoot(leg, path);
    const Index v = geodesics_.vertex_of_origin(leg.origin);
    leg.end = mesh_.points[v];
    leg.distance = geodesics_.distance(v);
    leg.direction = geodesics_.step_back(leg.origin);
    leg.spread = spread(geodesics_.distance(v) - geodesics_.arrival(v).sigma, geodesics_.arrival(v).rate);
  }

  /// by how much the end of a path moves, given the distance of its image; zero for paths that bend where windows have
  /// been merged
  static double spread(double distance, double rate) { return rate > 0. ? distance / rate : 0.; }

  /// is a straight line on its way: at the point `t` of the halfedge through which it enters a face, or at the point in
  /// the frame of the first halfedge of a face in which it starts.
  struct Shot
  {
    Index halfedge;
    Plane_point from;
    double dx, dy; // of length 1
  };

  void shoot(const Leg& leg, Path& path)
  {
    const double begin = distance(leg.origin), length = leg.distance - begin;
    aim(leg, begin, length);
    const Vector miss = leg.end - shot_.back().point;
    const double reached = shot_.back().distance - begin;
    for(std::size_t i = shot_.size(); i-- > 0;)
    {
      const double share = reached > 0. ? (shot_[i].distance - begin) / reached : 0.;
      path.push_back({shot_[i].point + share * miss, begin + share * length});
    }
  }

  /// leaves in `shot_` the nearest shot of a few, each in the direction that the one before asks for
  void aim(const Leg& leg, double begin, double length)
  {
    const double enough = 0.1 * faces_.mean_edge_length(); // widths of an edge or two matter
    double direction = leg.direction, spread = leg.spread, least = (std::numeric_limits<double>::infinity)();
    double last_direction = 0., last_aside = 0.;
    for(int i = 0; i < 5; ++i)
    {
      const double aside = shoot(leg, direction, begin, length), miss = std::fabs(aside);
      if(i > 0 && (aside - last_aside) * (direction - last_direction) < 0.)
        spread = (last_aside - aside) / (direction - last_direction);
      if(i == 0 || miss < least)
      {
        least = miss;
        best_.swap(shot_);
      }
      if(!(miss > enough) || !(spread > 0.))
        break;
      last_direction = direction;
      last_aside = aside;
      direction += aside / spread;
    }
    shot_.swap(best_);
  }

  /// shoots in a direction; returns how far to the left of its end that of the leg is
  double shoot(const Leg& leg, double direction, double begin, double length)
  {
    shot_.clear();
    Shot shot = start(leg.origin, direction);
    shot_.push_back({point_on(shot.halfedge, shot.from), begin});
    double way = leave_first_face(shot);
    // the separation of two paths changes slowly: points at every edge, or so, and not more than some hundred
    const double step = (std::max)(faces_.mean_edge_length(), 0.01 * length);
    double next = step;
    for(Index i = 0; i < faces_.number_of_faces() && way < length && shot.halfedge != null_index; ++i)
    {
      if(way >= next)
      {
        shot_.push_back({point_on(shot.halfedge, shot.from), begin + way});
        next = way + step;
      }
      way += leave_face(shot);
    }
    const double rest = (std::min)(way, length) - (way - last_step_);
    const Plane_point to{before_.from.x + rest * before_.dx, before_.from.y + rest * before_.dy};
    shot_.push_back({point_on(before_.halfedge, to), begin + (std::min)(way, length)});
    return aside(before_, leg.end - shot_.back().point);
  }

  /// the part of a vector in space that is to the left of a shot in its face
  double aside(const Shot& shot, const Vector& v) const
  {
    const Vector &a = mesh_.points[faces_.source(shot.halfedge)], &b = mesh_.points[faces_.target(shot.halfedge)];
    const Vector& c = mesh_.points[faces_.source(Mesh::previous(shot.halfedge))];
    const Vector along = (1. / norm(b - a)) * (b - a), normal = cross(b - a, c - a);
    const Vector left = (1. / norm(normal)) * cross(normal, along);
    return dot(v, shot.dx * left - shot.dy * along);
  }

  /// a point in the frame of `h`, in the plane of its face
  Vector point_on(Index h, const Plane_point& p) const
  {
    const Plane_point apex = faces_.apex(h);
    const double third = p.y / apex.y, second = (p.x - third * apex.x) / faces_.length(h);
    std::array<double, 3> c;
    c[h % 3] = 1. - second - third;
    c[Mesh::next(h) % 3] = second;
    c[Mesh::previous(h) % 3] = third;
    return position(mesh_, {h / 3, c});
  }

  Shot start(Index origin, double direction) const
  {
    if(!geodesics_.is_source(origin))
    {
      const Geodesic_arrival_direction back = geodesics_.arrival_direction(geodesics_.vertex_of_origin(origin));
      return start_at_vertex(back.halfedge, direction + back.angle);
    }
    const Index h = geodesics_.source_halfedge(origin);
    if(geodesics_.source_vertex(origin) != null_index)
      return start_at_vertex(h, direction);
    const std::array<double, 3>& c = geodesics_.source_location(origin).coordinates;
    if(geodesics_.source_edge(origin) == null_index)
      return {h, faces_.in_frame(h, c), std::cos(direction), std::sin(direction)};
    const double t = c[Mesh::next(h) % 3] * faces_.length(h), s = std::sin(direction);
    if(s >= 0. || faces_.opposite(h) == null_index)
      return {h, {t, 0.}, std::cos(direction), std::fabs(s)};
    return {faces_.opposite(h), {faces_.length(h) - t, 0.}, -std::cos(direction), -s};
  }

  /// at this angle from `h`, counterclockwise around its source
  Shot start_at_vertex(Index h, double angle) const
  {
    const Index first = h;
    const double full = faces_.total_angle(faces_.source(h));
    if(!faces_.is_border(faces_.source(h)))
      angle -= full * std::floor(angle / full);
    while(angle < 0. && faces_.previous_around_source(h) != null_index)
    {
      h = faces_.previous_around_source(h);
      angle += faces_.angle(h);
    }
    while(angle > faces_.angle(h))
    {
      const Index next = faces_.next_around_source(h);
      if(next == null_index || next == first)
        break;
      angle -= faces_.angle(h);
      h = next;
    }
    angle = (std::min)((std::max)(angle, 0.), faces_.angle(h));
    return {h, {0., 0.}, std::cos(angle), std::sin(angle)};
  }

  /// goes from the origin to where the shot leaves its face, into the next one or null; returns how far that is
  double leave_first_face(Shot& shot)
  {
    before_ = shot;
    const Index h = shot.halfedge;
    const std::array<Plane_point, 3> c = {{{0., 0.}, {faces_.length(h), 0.}, faces_.apex(h)}};
    last_step_ = (std::numeric_limits<double>::infinity)();
    Index exit = null_index;
    for(Index i = shot.from.y > 0. ? 0 : 1; i < 3; ++i) // not through the edge on which it starts
    {
      const Plane_point &p = c[i], &q = c[(i + 1) % 3];
      const double side = (q.x - p.x) * shot.dy - (q.y - p.y) * shot.dx; // negative if it leads out
      const double s = ((q.x - p.x) * (shot.from.y - p.y) - (q.y - p.y) * (shot.from.x - p.x)) / -side;
      if(side < 0. && s < last_step_)
      {
        last_step_ = s;
        exit = i;
      }
    }
    if(exit == null_index)
      return stop(shot);
    last_step_ = (std::max)(last_step_, 0.);
    const Index g = 3 * (h / 3) + (h % 3 + exit) % 3;
    const Plane_point &p = c[exit], &q = c[(exit + 1) % 3];
    const double l = faces_.length(g), ux = (p.x - q.x) / l, uy = (p.y - q.y) / l; // along the opposite
    const double x = shot.from.x + last_step_ * shot.dx - q.x, y = shot.from.y + last_step_ * shot.dy - q.y;
    enter(shot, faces_.opposite(g), x * ux + y * uy, l, shot.dx * ux + shot.dy * uy, shot.dy * ux - shot.dx * uy);
    return last_step_;
  }

  /// the same for a shot that has entered its face through an edge
  double leave_face(Shot& shot)
  {
    before_ = shot;
    const Geodesic_face& face = faces_.face_of(shot.halfedge);
    const Index i = shot.halfedge % 3, j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    const Geodesic_face::Corner &a = face.corner[i], &b = face.corner[j];
    const double t = shot.from.x, dx = shot.dx, dy = shot.dy, left = face.corner[k].length;
    if(dx * left * a.sine > dy * (left * a.cosine - t))
    {
      const double out = dx * b.sine + dy * b.cosine;
      if(!(out > 0.))
        return stop(shot);
      last_step_ = (a.length - t) * b.sine / out;
      enter(shot, face.opposite[j], b.length - last_step_ * dy / b.sine, b.length, dx * b.cosine - dy * b.sine, out);
    }
    else
    {
      const double out = dy * a.cosine - dx * a.sine;
      if(!(out > 0.))
        return stop(shot);
      last_step_ = t * a.sine / out;
      enter(shot, face.opposite[k], last_step_ * dy / a.sine, left, dx * a.cosine + dy * a.sine, out);
    }
    return last_step_;
  }

  /// where rounding leaves no way on, as at a vertex
  double stop(Shot& shot)
  {
    shot.halfedge = null_index;
    last_step_ = 0.;
    return 0.;
  }

  static void enter(Shot& shot, Index h, double t, double length, double dx, double dy)
  {
    shot = {h, {(std::min)((std::max)(t, 0.), length), 0.}, dx, dy};
  }

  double largest_separation() const
  {
    double result = 0.;
    std::size_t i = 0, j = 0;
    while(i + 1 < first_.size() && j + 1 < second_.size())
    {
      const bool is_first = first_[i + 1].distance >= second_[j + 1].distance;
      const Point_on_path& p = is_first ? first_[++i] : second_[++j];
      const Path& other = is_first ? second_ : first_;
      const std::size_t k = is_first ? j : i;
      const Vector d = p.point - point_between(other[k], other[k + 1], p.distance);
      result = (std::max)(result, dot(d, d));
    }
    return std::sqrt(result);
  }

  const Indexed_triangle_mesh& mesh_;
  const Geodesic_results& geodesics_;
  const Geodesic_faces& faces_;
  Path first_, second_, shot_, best_; // the last two forward
  Shot before_{};                     // as it was in the last face, and
  double last_step_ = 0.;             // how far it went there
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H
