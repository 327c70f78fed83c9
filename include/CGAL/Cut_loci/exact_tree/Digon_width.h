// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_DIGON_WIDTH_H
#define CGAL_CUT_LOCI_EXACT_TREE_DIGON_WIDTH_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/exact_tree/Image_bisector.h>
#include <CGAL/Cut_loci/internal/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/internal/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * measures how far two shortest paths to the same point get apart: the largest distance in space between points at the
 * same distance from the source.
 *
 * The paths are traced back, by unfolding one face after the other, in time proportional to the number of faces that
 * they cross.
 */
class Digon_width
{
public:
  Digon_width(const Indexed_triangle_mesh& mesh, const Geodesic_results& geodesics)
    : mesh_(mesh), geodesics_(geodesics), faces_(geodesics.faces())
  {
  }

  /// the two paths lead from the images to the point `p` of face `f`; all in the frame of its first halfedge
  double operator()(Index f, const Plane_point& p, const Image& a, const Image& b)
  {
    trace(f, p, a, first_);
    trace(f, p, b, second_);
    // as functions of the distance from the source both are linear in pieces: the largest distance is at an end of one
    double result = 0.;
    std::size_t i = 0, j = 0;
    while(i + 1 < first_.size() && j + 1 < second_.size())
    {
      const bool is_first = first_[i + 1].distance >= second_[j + 1].distance;
      const double d = is_first ? first_[++i].distance : second_[++j].distance;
      const Vector p1 = is_first ? first_[i].point : between(first_, i, d);
      const Vector p2 = is_first ? between(second_, j, d) : second_[j].point;
      result = (std::max)(result, norm(p1 - p2));
    }
    return result;
  }

private:
  using Mesh = Indexed_triangle_mesh;

  struct Point_on_path
  {
    Vector point;
    double distance; // from the source
  };
  using Path = std::vector<Point_on_path>;

  static Vector between(const Path& path, std::size_t i, double d)
  {
    if(i + 1 >= path.size())
      return path[i].point;
    const Point_on_path &a = path[i], &b = path[i + 1];
    const double l = a.distance - b.distance;
    const double s = l > 0. ? (std::min)((std::max)((a.distance - d) / l, 0.), 1.) : 0.;
    return a.point + s * (b.point - a.point);
  }

  /// from `p` back to the source
  void trace(Index f, const Plane_point& p, const Image& image, Path& path)
  {
    path.clear();
    const std::array<Plane_point, 3> c = {{{0., 0.}, {faces_.length(3 * f), 0.}, faces_.apex(3 * f)}};
    const double area = c[1].x * c[2].y;
    const double third = p.y / c[2].y, second = (p.x * c[2].y - p.y * c[2].x) / area;
    path.push_back({point(f, {{1. - second - third, second, third}}), image.distance(p)});
    Index origin = image.origin;
    Plane_point from = p, to{image.x, image.y};
    Index h = leave_face(f, origin, from, to);
    while(true)
    {
      if(h != null_index)
        follow(h, origin, from, to, image_sigma(origin), path);
      if(geodesics_.is_source(origin))
        break;
      const Index v = geodesics_.vertex_of_origin(origin);
      path.push_back({mesh_.points[v], geodesics_.distance(v)});
      if(path.size() > 4 * mesh_.triangles.size())
        return; // rounding has led astray
      const Geodesic_arrival& arrival = geodesics_.arrival(v);
      origin = arrival.origin;
      from = geodesics_.end_in_frame(arrival, v);
      to = {arrival.x, arrival.y};
      h = null_index;
      if(arrival.crosses_halfedge)
      {
        h = arrival.halfedge;
        const double t = from.x + (to.x - from.x) * from.y / (from.y - to.y);
        from = {t, 0.};
      }
    }
    const Indexed_location& source = geodesics_.source_location(origin);
    path.push_back({point(source.face, source.coordinates), 0.});
  }

  double image_sigma(Index origin) const
  {
    return geodesics_.is_source(origin) ? 0. : geodesics_.distance(geodesics_.vertex_of_origin(origin));
  }

  Vector point(Index f, const std::array<double, 3>& c) const
  {
    Vector result = {{0., 0., 0.}};
    for(std::size_t i = 0; i < 3; ++i)
      result = result + c[i] * mesh_.points[mesh_.triangles[f][i]];
    return result;
  }

  /// whether what a path starts from is in, or a corner of, the face
  bool starts_in(Index f, Index origin) const
  {
    if(!geodesics_.is_source(origin))
    {
      const Index v = geodesics_.vertex_of_origin(origin);
      const Mesh::Triangle& t = mesh_.triangles[f];
      return t[0] == v || t[1] == v || t[2] == v;
    }
    Plane_point p;
    return geodesics_.source_in_frame(origin, 3 * f, p);
  }

  /// the halfedge of face `f` through which the way to the image leaves it, or null if it ends there; `from` becomes
  /// the point on it, and both points are then in its frame
  Index leave_face(Index f, Index origin, Plane_point& from, Plane_point& to) const
  {
    if(starts_in(f, origin))
      return null_index;
    const std::array<Plane_point, 3> c = {{{0., 0.}, {faces_.length(3 * f), 0.}, faces_.apex(3 * f)}};
    const double dx = to.x - from.x, dy = to.y - from.y;
    Index best = null_index;
    double least = 0.;
    for(Index i = 0; i < 3; ++i)
    {
      // the image is on the far side of the edge, and the way crosses the edge first
      const Plane_point &a = c[i], &b = c[(i + 1) % 3];
      const double side = (b.x - a.x) * dy - (b.y - a.y) * dx;
      if(side >= 0.)
        continue;
      const double s = ((b.x - a.x) * (from.y - a.y) - (b.y - a.y) * (from.x - a.x)) / -side;
      if(best == null_index || s < least)
      {
        least = s;
        best = i;
      }
    }
    if(best == null_index)
      return null_index;
    const Plane_point on{from.x + least * dx, from.y + least * dy};
    const Index h = 3 * f + best;
    from = change_frame(on, c[best], c[(best + 1) % 3], faces_.length(h));
    to = change_frame(to, c[best], c[(best + 1) % 3], faces_.length(h));
    return h;
  }

  static Plane_point change_frame(const Plane_point& p, const Plane_point& from, const Plane_point& to, double length)
  {
    const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
    const double dx = p.x - from.x, dy = p.y - from.y;
    return {dx * ux + dy * uy, dy * ux - dx * uy};
  }

  /// goes through `h`, at the point `from` of it, and on to the face with the origin of the path
  void follow(Index h, Index origin, Plane_point from, Plane_point to, double sigma, Path& path) const
  {
    double t = from.x;
    const Index most = faces_.number_of_faces();
    for(Index step = 0; step < most; ++step)
    {
      const double length = faces_.length(h), s = (std::min)((std::max)(t / length, 0.), 1.);
      const Vector &a = mesh_.points[faces_.source(h)], &b = mesh_.points[faces_.target(h)];
      path.push_back({a + s * (b - a), sigma + std::hypot(t - to.x, to.y)});
      const Index g = faces_.opposite(h);
      if(g == null_index || starts_in(g / 3, origin))
        return;
      // the frame of `g`, with the image on the side of its face
      t = length - t;
      to = {length - to.x, -to.y};
      const Geodesic_face& face = faces_.face_of(g);
      const Index i = g % 3, j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
      const Geodesic_face::Corner &at_source = face.corner[i], &at_target = face.corner[j];
      const double reach = face.corner[k].length;
      const Plane_point apex{reach * at_source.cosine, reach * at_source.sine};
      const bool goes_right = (to.x - t) * apex.y > to.y * (apex.x - t);
      if(goes_right)
      {
        // through the edge from the target to the apex: its frame is turned by pi minus the corner
        const double c = -at_target.cosine, n = at_target.sine, x = to.x - length;
        const double p = t - length;
        const double px = c * p, py = -n * p;
        to = {c * x + n * to.y, -n * x + c * to.y};
        t = px + (to.x - px) * py / (py - to.y);
        h = 3 * (g / 3) + j;
      }
      else
      {
        // through the edge from the apex to the source
        const double c = -at_source.cosine, n = -at_source.sine, x = to.x - apex.x, y = to.y - apex.y;
        const double px = c * (t - apex.x) - n * apex.y, py = -n * (t - apex.x) - c * apex.y;
        to = {c * x + n * y, -n * x + c * y};
        t = px + (to.x - px) * py / (py - to.y);
        h = 3 * (g / 3) + k;
      }
      // The image is in the face, though what it is the image of is only near it: a label may hold a little beside its
      // own paths.
      if(to.y >= 0.)
        return;
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Geodesic_results& geodesics_;
  const Geodesic_faces& faces_;
  Path first_, second_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_DIGON_WIDTH_H
