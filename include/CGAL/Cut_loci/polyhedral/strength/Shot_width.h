// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/geodesics/Straight_walk.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/strength/Point_on_path.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

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
    const Face_corners corners = corners_of(faces_, f);
    const Vector end = position(mesh_, {f, coordinates_in(corners, p)});
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
    Straight_walk walk(geodesics_, leg.origin, direction);
    shot_.push_back({position(mesh_, walk.last_entry()), begin});
    // the separation of two paths changes slowly: points at every edge, or so, and not more than some hundred
    const double step = (std::max)(faces_.mean_edge_length(), 0.01 * length);
    double next = step;
    for(Index i = 0; i < faces_.number_of_faces() && walk.way() < length && !walk.is_over(); ++i)
    {
      const double way = walk.way();
      walk.leave_face();
      if(way < next)
        continue;
      shot_.push_back({position(mesh_, walk.last_entry()), begin + way});
      next = way + step;
    }
    shot_.push_back({position(mesh_, walk.at(length)), begin + (std::min)(walk.way(), length)});
    return aside(walk.last(), leg.end - shot_.back().point);
  }

  /// the part of a vector in space that is to the left of a shot in its face
  double aside(const Straight_walk::Line& shot, const Vector& v) const
  {
    const Vector &a = mesh_.points[faces_.source(shot.halfedge)], &b = mesh_.points[faces_.target(shot.halfedge)];
    const Vector& c = mesh_.points[faces_.source(Mesh::previous(shot.halfedge))];
    const Vector along = (1. / norm(b - a)) * (b - a), normal = cross(b - a, c - a);
    const Vector left = (1. / norm(normal)) * cross(normal, along);
    return dot(v, shot.dx * left - shot.dy * along);
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
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_SHOT_WIDTH_H
