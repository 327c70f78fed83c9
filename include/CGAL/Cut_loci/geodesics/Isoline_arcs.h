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

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// is a piece of an isoline in a face: a circular arc, counterclockwise around an image, which has what is nearer on its left.
struct Isoline_arc
{
  static constexpr int inside = 3; ///< in place of an edge

  std::size_t front;
  double begin, end;            // angles
  std::array<int, 2> edge;      // of the face that the arc begins and ends on, or `inside`
  std::array<Plane_point, 2> p; // where
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
      if(level_ > fronts_[i].sigma)
        add_arcs(i);
  }

  const std::vector<Isoline_arc>& arcs() const { return arcs_; }

private:
  struct Division
  {
    double angle;
    int edge;
  };

  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  double radius(std::size_t i) const { return level_ - fronts_[i].sigma; }

  void add_arcs(std::size_t i)
  {
    const Geodesic_front& front = fronts_[i];
    const bool is_at_corner = front.corner != null_index;
    const int first = is_at_corner ? static_cast<int>(front.corner) : Isoline_arc::inside,
              last = is_at_corner ? (first + 2) % 3 : Isoline_arc::inside;
    divisions_ = {{0., first}, {front.width, last}};
    for(int k = 0; k < 3; ++k)
      if(!is_at_corner || (k != first && k != last))
        divide_by_line(i, corners_[k], minus(corners_[(k + 1) % 3], corners_[k]), 1., k);
    sort();
    if(!has_part_in_face(i))
      return;
    for(std::size_t j = 0; j < fronts_.size(); ++j)
      if(j != i && level_ > fronts_[j].sigma)
        divide_by_front(i, j);
    sort();
    for(std::size_t k = 0; k + 1 < divisions_.size(); ++k)
    {
      const double from = divisions_[k].angle;
      if(!is_shown(i, probes(i, k)))
        continue;
      if(arcs_.empty() || arcs_.back().front != i || arcs_.back().end != from)
        arcs_.push_back({i, from, 0., {{edge_at(i, k), 0}}, {{front.point(from, radius(i)), {}}}});
      arcs_.back().end = divisions_[k + 1].angle;
      arcs_.back().edge[1] = edge_at(i, k + 1);
      arcs_.back().p[1] = front.point(divisions_[k + 1].angle, radius(i));
    }
  }

  /// the edge at division number `k` of front `i`: rays and other arcs may meet the arc where it crosses an edge
  int edge_at(std::size_t i, std::size_t k) const
  {
    if(divisions_[k].edge != Isoline_arc::inside)
      return divisions_[k].edge;
    const Plane_point p = fronts_[i].point(divisions_[k].angle, radius(i));
    int result = Isoline_arc::inside;
    double least = rounding_;
    for(int e = 0; e < 3; ++e)
    {
      const Plane_point along = minus(corners_[(e + 1) % 3], corners_[e]);
      const double height = cross(along, minus(p, corners_[e])) / std::hypot(along.x, along.y);
      if(height < least)
      {
        least = height;
        result = e;
      }
    }
    return result;
  }

  void sort()
  {
    std::sort(divisions_.begin(), divisions_.end(),
              [](const Division& a, const Division& b) { return a.angle < b.angle; });
  }

  /// two points between a division and the next: where circles and edges touch, the one that is farther from there tells the
  /// side
  std::array<Plane_point, 2> probes(std::size_t i, std::size_t k) const
  {
    const double from = divisions_[k].angle, width = divisions_[k + 1].angle - from;
    return {{fronts_[i].point(from + 0.5 * width, radius(i)), fronts_[i].point(from + 0.38 * width, radius(i))}};
  }

  bool has_part_in_face(std::size_t i) const
  {
    for(std::size_t k = 0; k + 1 < divisions_.size(); ++k)
      if(is_in_face(probes(i, k)))
        return true;
    return false;
  }

  bool is_in_face(const std::array<Plane_point, 2>& points) const
  {
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
    if(!is_in_face(points))
      return false;
    for(std::size_t j = 0; j < fronts_.size(); ++j)
      if(j != i && larger(fronts_[j].distance(points[0]) - level_, fronts_[j].distance(points[1]) - level_) <
                     (j < i ? rounding_ : -rounding_))
        return false;
    return true;
  }

  void divide(std::size_t i, const Plane_point& p, int edge)
  {
    const double angle = fronts_[i].angle(p);
    if(angle > 0. && angle < fronts_[i].width)
      divisions_.push_back({angle, edge});
  }

  /// where the line from `p`, up to `most` times `along`, meets the circle of front `i`
  void divide_by_line(std::size_t i, const Plane_point& p, const Plane_point& along, double most, int edge)
  {
    const Plane_point way = minus(fronts_[i].image, p);
    const double square = dot(along, along), r = radius(i), foot = dot(way, along) / square,
                 height = cross(along, way) / std::sqrt(square), half = (r - height) * (r + height);
    if(half <= 0.)
      return;
    const double reach = std::sqrt(half / square);
    for(double t : {foot - reach, foot + reach})
      if(t >= 0. && t <= most)
        divide(i, {p.x + t * along.x, p.y + t * along.y}, edge);
  }

  void divide_by_front(std::size_t i, std::size_t j)
  {
    const Geodesic_front& other = fronts_[j];
    const Plane_point way = minus(other.image, fronts_[i].image);
    const double r = radius(i), q = radius(j), d = std::hypot(way.x, way.y);
    if(d > r + q || d + q < r - rounding_)
      return;
    if(d + r > q && d > 0.)
    {
      // from the image that is nearer, for the sake of rounding
      const bool is_nearer = r < q;
      const double small = is_nearer ? r : q, large = is_nearer ? q : r, sign = is_nearer ? 1. : -1.;
      const double along = 0.5 * (d - (large - small) * (large + small) / d),
                   aside = std::sqrt((std::max)((small - along) * (small + along), 0.));
      const Plane_point unit{sign * way.x / d, sign * way.y / d}, &c = is_nearer ? fronts_[i].image : other.image;
      for(double a : {aside, -aside})
        divide(i, {c.x + along * unit.x - a * unit.y, c.y + along * unit.y + a * unit.x}, Isoline_arc::inside);
    }
    if(!other.is_in_face)
      for(double angle : {0., other.width})
        divide_by_line(i, other.image, minus(other.point(angle, q), other.image), infinity, Isoline_arc::inside);
  }

  const std::vector<Geodesic_front>& fronts_;
  const std::array<Plane_point, 3>& corners_;
  double level_, rounding_;
  std::vector<Division> divisions_; // of the arc in work
  std::vector<Isoline_arc> arcs_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_GEODESICS_ISOLINE_ARCS_H
