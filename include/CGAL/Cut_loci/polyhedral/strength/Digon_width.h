// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DIGON_WIDTH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DIGON_WIDTH_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/strength/Point_on_path.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Cut_loci::internal {

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
  double operator()(Index f, const Plane_point& p, const Image& a, const Image& b) const
  {
    Walk first, second;
    start(first, f, p, a);
    start(second, f, p, b);
    // as functions of the distance from the source both are linear in pieces: the largest distance is at an end of one
    double result = 0.;
    const Index most = 8 * faces_.number_of_faces(); // beyond, rounding has led astray
    for(Index step = 0; step < most && !first.is_done && !second.is_done; ++step)
    {
      if(is_narrower(first, second, result))
        break;
      Walk& next = first.next.distance >= second.next.distance ? first : second;
      const Walk& other = &next == &first ? second : first;
      result =
        (std::max)(result, squared_norm(next.next.point - point_between(other.last, other.next, next.next.distance)));
      advance(next);
    }
    return std::sqrt(result);
  }

private:
  using Mesh = Indexed_triangle_mesh;

  /// is on its way back to the source: at the end of a straight piece in one face.
  struct Walk
  {
    Point_on_path last, next; // the ends of the piece
    Index origin;             // of the straight path it is on
    double sigma;             // its distance
    Index halfedge;           // through which the path goes at `next`, or null if it starts there
    double t;                 // `next` on it, if any
    Plane_point to;           // the image of the origin, in the frame of the halfedge
    bool is_done;
  };

  static double squared_norm(const Vector& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

  /// Paths through the same edge to the same image cross the same faces from there on. In the plane of these they come
  /// closer, and in space they are no farther apart: whether that is less than a separation, given by its square.
  static bool is_narrower(const Walk& a, const Walk& b, double squared)
  {
    if(a.halfedge != b.halfedge || a.halfedge == null_index || a.origin != b.origin)
      return false;
    const double scale = std::fabs(a.to.x) + std::fabs(a.to.y) + std::fabs(a.t);
    if(std::fabs(a.to.x - b.to.x) + std::fabs(a.to.y - b.to.y) > 1e-9 * scale)
      return false;
    const double ra = a.next.distance - a.sigma, rb = b.next.distance - b.sigma;
    const double r = (std::min)(ra, rb) / ra, s = (std::min)(ra, rb) / rb;
    const double dx = r * (a.t - a.to.x) - s * (b.t - b.to.x), dy = r * a.to.y - s * b.to.y;
    return dx * dx + dy * dy <= squared;
  }

  /// at `p`
  void start(Walk& walk, Index f, const Plane_point& p, const Image& image) const
  {
    walk.last = {position(mesh_, {f, coordinates_in(corners_of(faces_, f), p)}), image.distance(p)};
    walk.origin = image.origin;
    walk.sigma = image_sigma(walk.origin);
    walk.is_done = false;
    walk.to = image.place();
    Plane_point from = p;
    walk.halfedge = leave_face(f, walk.origin, from, walk.to);
    walk.t = from.x;
    find_next_point(walk);
  }

  void advance(Walk& walk) const
  {
    walk.last = walk.next;
    if(walk.halfedge != null_index)
      cross_face(walk);
    else if(geodesics_.is_source(walk.origin))
      walk.is_done = true;
    else
      bend(walk);
    if(!walk.is_done)
      find_next_point(walk);
  }

  void find_next_point(Walk& walk) const
  {
    go_through_vertex(walk);
    if(walk.halfedge != null_index)
    {
      const Index h = walk.halfedge;
      const double s = (std::min)((std::max)(walk.t / faces_.length(h), 0.), 1.);
      const Vector &a = mesh_.points[faces_.source(h)], &b = mesh_.points[faces_.target(h)];
      const double x = walk.t - walk.to.x;
      walk.next = {a + s * (b - a), walk.sigma + std::sqrt(x * x + walk.to.y * walk.to.y)};
    }
    else if(geodesics_.is_source(walk.origin))
    {
      walk.next = {position(mesh_, geodesics_.source_location(walk.origin)), 0.};
    }
    else
      walk.next = {mesh_.points[geodesics_.vertex_of_origin(walk.origin)], walk.sigma};
  }

  /// Rounding would decide on which side a path goes that leads through a vertex. It goes on as the path to the vertex.
  void go_through_vertex(Walk& walk) const
  {
    if(walk.halfedge == null_index)
      return;
    const double length = faces_.length(walk.halfedge), tolerance = geodesic_cover * length;
    if(walk.t > tolerance && walk.t < length - tolerance)
      return;
    const Index v = walk.t > tolerance ? faces_.target(walk.halfedge) : faces_.source(walk.halfedge);
    walk.halfedge = null_index;
    walk.origin = geodesics_.origin_of_vertex(v);
    walk.sigma = geodesics_.distance(v);
  }

  /// from the vertex at which it starts to where that path starts
  void bend(Walk& walk) const
  {
    const Index v = geodesics_.vertex_of_origin(walk.origin);
    const Geodesic_arrival& arrival = geodesics_.arrival(v);
    walk.origin = arrival.origin;
    walk.sigma = image_sigma(walk.origin);
    walk.halfedge = null_index;
    if(!arrival.crosses_halfedge)
      return;
    const Plane_point from = geodesics_.end_in_frame(arrival, v);
    walk.halfedge = arrival.halfedge;
    walk.to = {arrival.x, arrival.y};
    walk.t = from.x + (walk.to.x - from.x) * from.y / (from.y - walk.to.y);
  }

  double image_sigma(Index origin) const { return geodesics_.sigma_of_origin(origin); }

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
    const Face_corners c = corners_of(faces_, f);
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

  /// through the face behind the halfedge
  void cross_face(Walk& walk) const
  {
    const Index g = faces_.opposite(walk.halfedge);
    const double length = faces_.length(walk.halfedge);
    walk.halfedge = null_index;
    walk.is_done = g == null_index && geodesics_.is_line(walk.origin); // there it starts
    if(g == null_index || starts_in(g / 3, walk.origin))
      return;
    // the frame of `g`, with the image on the side of its face
    const double t = length - walk.t;
    const Plane_point to{length - walk.to.x, -walk.to.y};
    const Geodesic_face& face = faces_.face_of(g);
    const Index i = g % 3, j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    const Geodesic_face::Corner &at_source = face.corner[i], &at_target = face.corner[j];
    const double reach = face.corner[k].length;
    const Plane_point apex{reach * at_source.cosine, reach * at_source.sine};
    // through the edge from the target to the apex, whose frame is turned by pi minus the corner, or from the apex to
    // the source
    const bool goes_right = (to.x - t) * apex.y > to.y * (apex.x - t);
    const Plane_point begin = goes_right ? Plane_point{length, 0.} : apex;
    const double c = goes_right ? -at_target.cosine : -at_source.cosine,
                 s = goes_right ? at_target.sine : -at_source.sine;
    const double px = c * (t - begin.x) - s * begin.y, py = -s * (t - begin.x) - c * begin.y;
    const double x = to.x - begin.x, y = to.y - begin.y;
    walk.to = {c * x + s * y, -s * x + c * y};
    walk.t = px + (walk.to.x - px) * py / (py - walk.to.y);
    // Or the image is in the face, though what it is the image of is only near it: a label may hold a little beside its
    // own paths.
    if(walk.to.y < 0.)
      walk.halfedge = g - i + (goes_right ? j : k);
    else
      walk.is_done = true;
  }

  const Indexed_triangle_mesh& mesh_;
  const Geodesic_results& geodesics_;
  const Geodesic_faces& faces_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DIGON_WIDTH_H
