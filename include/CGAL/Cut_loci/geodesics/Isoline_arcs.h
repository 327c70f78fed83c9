// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_ISOLINE_ARCS_H
#define CGAL_CUT_LOCI_GEODESICS_ISOLINE_ARCS_H

#include <CGAL/Cut_loci/geodesics/Geodesic_fronts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is a piece of an isoline in a face: a circular arc, counterclockwise around an image, which has what is nearer on its left;
/// or, of parallel paths, a segment.
struct Isoline_arc
{
  std::size_t front;
  double begin, end; // angles
};

/*!
 * finds the isoline of a level in a face.
 *
 * What is nearer than the level is a union of circular sectors, one for each front. The isoline is the part of their arcs
 * that no other sector covers. Arcs are divided where they meet edges of the face, other arcs and the rays that bound
 * sectors; what is between two such points is covered or not as a whole.
 */
class Isoline_arcs
{
public:
  Isoline_arcs(const std::vector<Geodesic_front>& fronts, const std::array<Plane_point, 3>& corners, double level,
               double rounding)
    : fronts_(fronts), corners_(corners), level_(level), rounding_(rounding)
  {
    for(std::size_t i = 0; i < fronts_.size(); ++i)
      if(fronts_[i].may_reach(level_))
        add_arcs(i);
  }

  const std::vector<Isoline_arc>& arcs() const { return arcs_; }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  double radius(std::size_t i) const { return level_ - fronts_[i].sigma; }

  void add_arcs(std::size_t i)
  {
    divisions_ = {0., fronts_[i].width};
    for(std::size_t k = 0; k < 3; ++k)
      divide_by_line(i, corners_[k], minus(corners_[(k + 1) % 3], corners_[k]));
    std::sort(divisions_.begin(), divisions_.end());
    if(!has_part_in_face(i))
      return;
    for(std::size_t j = 0; j < fronts_.size(); ++j)
      if(j != i && fronts_[j].may_reach(level_))
        divide_by_front(i, j);
    std::sort(divisions_.begin(), divisions_.end());
    for(std::size_t k = 0; k + 1 < divisions_.size(); ++k)
    {
      const double from = divisions_[k];
      if(!is_shown(i, probes(i, k)))
        continue;
      if(arcs_.empty() || arcs_.back().front != i || arcs_.back().end != from)
        arcs_.push_back({i, from, from});
      arcs_.back().end = divisions_[k + 1];
    }
  }

  /// two points between a division and the next: where circles and edges touch, the one that is farther from there tells the
  /// side
  std::array<Plane_point, 2> probes(std::size_t i, std::size_t k) const
  {
    const double from = divisions_[k], width = divisions_[k + 1] - from;
    return {{fronts_[i].point(from + 0.5 * width, radius(i)), fronts_[i].point(from + 0.38 * width, radius(i))}};
  }

  bool has_part_in_face(std::size_t i) const
  {
    for(std::size_t k = 0; k + 1 < divisions_.size(); ++k)
      if(is_in_face(i, probes(i, k)))
        return true;
    return false;
  }

  /// a segment along an edge is in the face that it comes from
  bool is_in_face(std::size_t i, std::array<Plane_point, 2> points) const
  {
    if(fronts_[i].is_parallel)
      for(Plane_point& p : points)
        p = minus(p, scaled(fronts_[i].right, rounding_));
    return larger(height(points[0]), height(points[1])) >= 0.;
  }

  /// of a point over the edge that it is least over
  double height(const Plane_point& p) const
  {
    double result = infinity;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Plane_point along = minus(corners_[(k + 1) % 3], corners_[k]);
      result = (std::min)(result, cross(along, minus(p, corners_[k])) / std::hypot(along.x, along.y));
    }
    return result;
  }

  static double larger(double a, double b) { return std::fabs(a) > std::fabs(b) ? a : b; }

  /// of several fronts that are equally near, up to rounding, the first one has the arc
  bool is_shown(std::size_t i, const std::array<Plane_point, 2>& points) const
  {
    if(!is_in_face(i, points))
      return false;
    for(std::size_t j = 0; j < fronts_.size(); ++j)
      if(j != i && larger(fronts_[j].distance(points[0]) - level_, fronts_[j].distance(points[1]) - level_) <
                     (j < i ? rounding_ : -rounding_))
        return false;
    return true;
  }

  void divide(std::size_t i, const Plane_point& p)
  {
    const double angle = fronts_[i].angle(p);
    if(angle > 0. && angle < fronts_[i].width)
      divisions_.push_back(angle);
  }

  /// where the line from `p` meets the circle of front `i`: in all of it, since a circle through a corner of the face may miss
  /// both of its edges by rounding
  void divide_by_line(std::size_t i, const Plane_point& p, const Plane_point& along)
  {
    const std::array<double, 2> chord = fronts_[i].chord(p, along, radius(i));
    for(double t : chord)
      if(chord[0] < chord[1])
        divide(i, {p.x + t * along.x, p.y + t * along.y});
  }

  void divide_by_front(std::size_t i, std::size_t j)
  {
    const Geodesic_front& other = fronts_[j];
    if(fronts_[i].is_parallel || other.is_parallel)
      divide_by_straight_front(i, j);
    else if(!divide_by_circle(i, j))
      return;
    if(other.accuracy < Geodesic_front::sees_all)
      for(double angle : {0., other.width})
        divide_by_line(i, other.point(angle, 0.), minus(other.point(angle, 1.), other.point(angle, 0.)));
  }

  /// where one of the two is straight
  void divide_by_straight_front(std::size_t i, std::size_t j)
  {
    const bool is_first = fronts_[i].is_parallel;
    const Geodesic_front &straight = fronts_[is_first ? i : j], &other = fronts_[is_first ? j : i];
    const Plane_point from = straight.point(0., radius(is_first ? i : j)), along{-straight.right.y, straight.right.x};
    for(double t : other.chord(from, along, radius(is_first ? j : i)))
      divide(i, {from.x + t * along.x, from.y + t * along.y});
  }

  /// whether the circles are not apart
  bool divide_by_circle(std::size_t i, std::size_t j)
  {
    const Geodesic_front& other = fronts_[j];
    const Plane_point way = minus(other.image, fronts_[i].image);
    const double r = radius(i), q = radius(j), d = std::hypot(way.x, way.y);
    if(d > r + q || d + q < r - rounding_)
      return false;
    if(d + r > q && d > 0.)
    {
      // from the image that is nearer, for the sake of rounding
      const bool is_nearer = r < q;
      const double small = is_nearer ? r : q, large = is_nearer ? q : r, sign = is_nearer ? 1. : -1.;
      const double along = 0.5 * (d - (large - small) * (large + small) / d),
                   aside = std::sqrt((std::max)((small - along) * (small + along), 0.));
      const Plane_point unit{sign * way.x / d, sign * way.y / d}, &c = is_nearer ? fronts_[i].image : other.image;
      for(double a : {aside, -aside})
        divide(i, {c.x + along * unit.x - a * unit.y, c.y + along * unit.y + a * unit.x});
    }
    return true;
  }

  const std::vector<Geodesic_front>& fronts_;
  const std::array<Plane_point, 3>& corners_;
  double level_, rounding_;
  std::vector<double> divisions_; // of the arc in work: angles
  std::vector<Isoline_arc> arcs_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_ISOLINE_ARCS_H
