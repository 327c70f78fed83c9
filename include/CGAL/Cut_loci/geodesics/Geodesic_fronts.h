// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_FRONTS_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_FRONTS_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

inline double cross(const Plane_point& p, const Plane_point& q)
{
  return p.x * q.y - p.y * q.x;
}
inline double dot(const Plane_point& p, const Plane_point& q)
{
  return p.x * q.x + p.y * q.y;
}
inline Plane_point minus(const Plane_point& p, const Plane_point& q)
{
  return {p.x - q.x, p.y - q.y};
}

inline Plane_point scaled(const Plane_point& p, double factor)
{
  return {factor * p.x, factor * p.y};
}

/// is what comes into a face from the image of one (pseudo-)source: in the sector that the image sees, distances are at most
/// `sigma` more than those from the image. All points are in the frame of the first halfedge of the face.
///
/// Where paths are parallel, the sector is a strip: the image is a point on its right side, and its angles are lengths across it.
struct Geodesic_front
{
  Plane_point image;
  double sigma;
  Plane_point right, left; // of the length 1, along the rays at which the sector begins and ends, counterclockwise
  double width;            // the angle of the sector, below pi if not all of the face is seen
  /// how far beyond its rays the image sees, so that there are no gaps between windows; in the face, if the image is, it sees
  /// everything
  double accuracy;
  bool is_parallel;

  /// with other lengths of the rays
  Geodesic_front(const Plane_point& at, double further, const Plane_point& to_right, const Plane_point& to_left,
                 double angle, double seen_beyond, bool is_strip = false)
    : image(at), sigma(further), right(scaled(to_right, 1. / std::hypot(to_right.x, to_right.y))),
      left(scaled(to_left, 1. / std::hypot(to_left.x, to_left.y))), width(angle), accuracy(seen_beyond),
      is_parallel(is_strip)
  {
  }
  static constexpr double sees_all = (std::numeric_limits<double>::infinity)();

  /// whether points of the front may be at this distance
  bool may_reach(double level) const { return is_parallel || sigma < level; }
  /// the angle of a point in the sector, from `right`, in [0, 2 pi)
  double angle(const Plane_point& p) const
  {
    const Plane_point way = minus(p, image);
    if(is_parallel)
      return cross(right, way);
    const double result = std::atan2(cross(right, way), dot(right, way));
    return result < 0. ? result + 2. * geodesic_pi : result;
  }
  Plane_point point(double angle, double radius) const
  {
    if(is_parallel)
      return {image.x + radius * right.x - angle * right.y, image.y + radius * right.y + angle * right.x};
    const double c = std::cos(angle), s = std::sin(angle);
    return {image.x + radius * (c * right.x - s * right.y), image.y + radius * (s * right.x + c * right.y)};
  }
  /// the bound for the distance of a point of the face, infinite if the image does not see it
  double distance(const Plane_point& p) const
  {
    const Plane_point way = minus(p, image);
    if(cross(right, way) < -accuracy || cross(left, way) > accuracy + (is_parallel ? width : 0.))
      return (std::numeric_limits<double>::infinity)();
    return sigma + (is_parallel ? dot(right, way) : std::hypot(way.x, way.y));
  }
  /// between its ends, at a distance from the image
  double length(double begin, double end, double radius) const { return (is_parallel ? 1. : radius) * (end - begin); }
  /// where the line from `p` along `along` is in the circle around the image, in units of `along`; begins behind its end if
  /// it is not
  std::array<double, 2> chord(const Plane_point& p, const Plane_point& along, double radius) const
  {
    const Plane_point way = minus(image, p);
    if(is_parallel)
    {
      constexpr double infinity = (std::numeric_limits<double>::infinity)();
      const double slope = dot(right, along), rest = radius + dot(right, way);
      if(slope == 0.)
        return rest > 0. ? std::array<double, 2>{{-infinity, infinity}} : std::array<double, 2>{{1., 0.}};
      return slope > 0. ? std::array<double, 2>{{-infinity, rest / slope}}
                        : std::array<double, 2>{{rest / slope, infinity}};
    }
    const double square = dot(along, along), foot = dot(way, along) / square,
                 height = cross(along, way) / std::sqrt(square), half = (radius - height) * (radius + height);
    if(half <= 0.)
      return {{1., 0.}};
    const double reach = std::sqrt(half / square);
    return {{foot - reach, foot + reach}};
  }
  /// the part of that which the image sees
  std::array<double, 2> seen_chord(const Plane_point& p, const Plane_point& along, double radius) const
  {
    std::array<double, 2> result = chord(p, along, radius);
    for(bool is_left : {false, true})
    {
      const Plane_point ray = is_left ? scaled(left, -1.) : right;
      const double slope = cross(ray, along),
                   outside = -accuracy - cross(ray, minus(p, image)) - (is_left && is_parallel ? width : 0.);
      if(slope != 0.)
        slope > 0. ? result[0] = (std::max)(result[0], outside / slope)
                   : result[1] = (std::min)(result[1], outside / slope);
      else if(outside > 0.)
        return {{1., 0.}};
    }
    return result;
  }
};

/*!
 * finds the fronts that come into a face: the distance of each of its points is the least that they have there.
 *
 * They are those of all windows that cross the face, of its vertices, and of sources in it. Neighboring windows overlap
 * behind the point at which they meet, so that no point is left out.
 */
class Geodesic_fronts
{
public:
  Geodesic_fronts(const Exact_geodesic_propagation& geodesics, const std::vector<Crossing_window>& windows)
    : geodesics_(geodesics), faces_(geodesics.faces()), all_windows_(windows), windows_(faces_.number_of_faces(),
                                                                                        [&](const auto& add)
                                                                                        {
    for(std::size_t i = 0; i < windows.size(); ++i)
      add(windows[i].halfedge / 3, i);
      }),
  sources_(faces_.number_of_faces(), [&](const auto& add) { enumerate_sources(add); })
  {
    double largest = 0.;
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
      if(geodesics_.is_reached(v))
        largest = (std::max)(largest, geodesics_.distance(v));
    constexpr double few_roundings = 64. * std::numeric_limits<double>::epsilon();
    rounding_ = few_roundings * (largest + faces_.mean_edge_length());
  }

  /// what rounding leaves unknown of the distances
  double rounding() const { return rounding_; }

  std::array<Plane_point, 3> corners(Index face) const
  {
    return {{{0., 0.}, {faces_.length(3 * face), 0.}, faces_.apex(3 * face)}};
  }

  /// in the order in which the first of several that are equally short counts
  std::vector<Geodesic_front> in_face(Index face) const
  {
    const std::array<Plane_point, 3> corner = corners(face);
    std::vector<Geodesic_front> result;
    for(const Crossing_window& w : windows_in(face))
      add_window(w, corner, result);
    Plane_point p;
    for(std::size_t i : sources_[face])
      if(geodesics_.source_in_frame(i, 3 * face, p))
        result.push_back({p, 0., {1., 0.}, {1., 0.}, 2. * geodesic_pi, Geodesic_front::sees_all});
    for(Index i = 0; i < 3; ++i)
      if(const Index v = faces_.face(face).vertex[i]; geodesics_.is_reached(v))
        result.push_back({corner[i], geodesics_.distance(v), minus(corner[(i + 1) % 3], corner[i]),
                          minus(corner[(i + 2) % 3], corner[i]), faces_.angle(3 * face + i), Geodesic_front::sees_all});
    return result;
  }

private:
  template <typename Add>
  void enumerate_sources(const Add& add) const
  {
    for(std::size_t i = 0; i < geodesics_.number_of_sources(); ++i)
    {
      if(geodesics_.source_vertex(i) != null_index || geodesics_.is_line(static_cast<Index>(i)))
        continue;
      add(geodesics_.source_location(i).face, i);
      const Index h = geodesics_.source_edge(i);
      if(h != null_index && faces_.opposite(h) != null_index)
        add(faces_.opposite(h) / 3, i);
    }
  }

  // Where a path passes a vertex, windows on both sides of it know the same distance up to the square of what parts them. So
  // rounding may leave a gap between them, which is as wide as its root: what both know alike, both see.
  std::vector<Crossing_window> windows_in(Index face) const
  {
    std::vector<Crossing_window> result;
    for(std::size_t i : windows_[face])
      result.push_back(all_windows_[i]);
    std::sort(result.begin(), result.end(),
              [](const Crossing_window& v, const Crossing_window& w)
              { return v.halfedge != w.halfedge ? v.halfedge < w.halfedge : v.a < w.a; });
    for(std::size_t i = 0; i + 1 < result.size(); ++i)
    {
      Crossing_window &left = result[i], &right = result[i + 1];
      const double from = left.b, to = right.a;
      if(left.halfedge == right.halfedge && from < to && is_alike(left, right, from) && is_alike(left, right, to))
      {
        left.b = to;
        right.a = from;
      }
    }
    return result;
  }

  bool is_alike(const Crossing_window& v, const Crossing_window& w, double x) const
  {
    return std::fabs(v.distance(x) - w.distance(x)) <= rounding_;
  }

  void add_window(const Crossing_window& w, const std::array<Plane_point, 3>& corner,
                  std::vector<Geodesic_front>& result) const
  {
    const Plane_point& from = corner[w.halfedge % 3];
    const Plane_point along = minus(corner[(w.halfedge + 1) % 3], from);
    const double length = std::hypot(along.x, along.y), c = along.x / length, s = along.y / length;
    const auto placed = [&](double x, double y) { return Plane_point{from.x + c * x - s * y, from.y + s * x + c * y}; };
    if(w.is_parallel)
    {
      const Plane_point right_side = placed(w.b, 0.), source = minus(placed(w.x, w.y), from);
      const double scale = -1. / std::hypot(source.x, source.y);
      const Plane_point ray = scaled(source, scale);
      if(const double width = cross(ray, minus(placed(w.a, 0.), right_side)); width > 0.)
        result.push_back({right_side, w.distance(w.b), ray, ray, width, geodesics_.seen_beyond(length, 0.), true});
      return;
    }
    const Plane_point image = placed(w.x, w.y), right = minus(placed(w.b, 0.), image),
                      left = minus(placed(w.a, 0.), image);
    double width = std::atan2(cross(right, left), dot(right, left));
    if(w.y >= 0.) // a source on the edge sees all of the face, or nothing
      width = w.a < w.x && w.x < w.b ? geodesic_pi : 0.;
    if(width > 0.)
      result.push_back({image, w.sigma, right, left, width, geodesics_.seen_beyond(length, w.sigma)});
  }

  const Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  const std::vector<Crossing_window>& all_windows_;
  Compressed_rows<std::size_t> windows_, sources_; // by face
  double rounding_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_FRONTS_H
