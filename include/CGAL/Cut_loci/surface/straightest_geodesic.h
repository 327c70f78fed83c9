// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_STRAIGHTEST_GEODESIC_H
#define CGAL_CUT_LOCI_SURFACE_STRAIGHTEST_GEODESIC_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/normals.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// Walks along a straightest geodesic, face by face.
class Geodesic_walk
{
public:
  Geodesic_walk(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
    : mesh_(mesh), connectivity_(connectivity)
  {
  }

  Indexed_location operator()(Indexed_location start, const Vector& direction, double length)
  {
    snap(start);
    location_ = start;
    if(!(length > 0.) || !enter(direction))
      return location_;
    // On its way a geodesic crosses an edge every so often: what takes more steps than the mesh has halfedges goes in
    // circles around needles shorter than the precision of its length.
    for(Index step = 0; step < mesh_.number_of_halfedges() && length > 0.; ++step)
      if(!cross_face(length))
        break;
    snap(location_);
    return location_;
  }

private:
  // The first face and the unit direction in it.
  bool enter(const Vector& direction)
  {
    const Index v = vertex_of(mesh_, location_);
    if(v != null_index)
    {
      const Index first = connectivity_.ring_halfedge[connectivity_.ring_begin[v]];
      const Vector normal = normal_at(mesh_, connectivity_, location_);
      const Vector x = tangential(mesh_.points[mesh_.target(first)] - mesh_.points[v], normal);
      double angle = std::atan2(dot(cross(x, direction), normal), dot(x, direction) * norm(normal));
      if(angle < 0.)
        angle += 2. * pi();
      // As in Tangent_directions, the angles around an interior vertex are scaled to sum up to 2 pi.
      const double total = total_angle(v);
      return leave_vertex(v, connectivity_.is_border(v) ? angle : angle * total / (2. * pi()));
    }

    const Index f = location_.face;
    const Vector normal = normal_at(mesh_, connectivity_, location_);
    Vector d = direction;
    if(!unit(tangential(d, normal), d))
      return false;
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * f + i;
      if(location_.coordinates[(i + 2) % 3] > 0.)
        continue;
      // On an edge: the side on which the direction lies, turned about the edge into the plane of that face.
      const Vector along = mesh_.points[mesh_.target(h)] - mesh_.points[mesh_.source(h)];
      const bool is_inside = dot(cross(along, d), normal) >= 0.;
      if(!is_inside && mesh_.is_border_edge(h))
        return false;
      const double c = dot(along, d) / norm(along), s = std::sqrt((std::max)(0., 1. - c * c));
      if(!is_inside)
        location_ = across(mesh_, h, location_);
      direction_ = in_face(is_inside ? h : mesh_.opposite[h], is_inside ? c : -c, s);
      return true;
    }
    const Vector face_normal = normal_of_face(mesh_, f);
    return unit(tangential(d, face_normal), direction_);
  }

  // The unit direction in the face of `h` with the given components along `h` and to its left.
  Vector in_face(Index h, double along, double left) const
  {
    Vector e = {{0., 0., 0.}}, m = e;
    unit(mesh_.points[mesh_.target(h)] - mesh_.points[mesh_.source(h)], e);
    unit(cross(normal_of_face(mesh_, h / 3), e), m);
    return along * e + left * m;
  }

  double corner_angle(Index h) const
  {
    const Vector& p = mesh_.points[mesh_.source(h)];
    const Vector a = mesh_.points[mesh_.target(h)] - p, b = mesh_.points[mesh_.source(mesh_.previous(h))] - p;
    return std::atan2(norm(cross(a, b)), dot(a, b));
  }

  double total_angle(Index v) const
  {
    double result = 0.;
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
      if(mesh_.source(connectivity_.ring_halfedge[entry]) == v)
        result += corner_angle(connectivity_.ring_halfedge[entry]);
    return result;
  }

  // Continues from vertex `v` at an angle from the first edge of its ring; outside of the fan of a border vertex, it
  // stops.
  bool leave_vertex(Index v, double angle)
  {
    Index h = null_index;
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      if(mesh_.source(connectivity_.ring_halfedge[entry]) != v)
        break;
      h = connectivity_.ring_halfedge[entry];
      const double corner = corner_angle(h);
      if(angle <= corner)
        break;
      angle -= corner;
      if(entry + 1 == connectivity_.ring_begin[v + 1] && !connectivity_.is_border(v))
        angle = corner; // rounding
      else
        h = null_index;
    }
    if(h == null_index)
      return false;
    location_ = location_on(h);
    direction_ = in_face(h, std::cos(angle), std::sin(angle));
    return true;
  }

  // Moves to the border of the face, or to the end; false if the walk ends.
  bool cross_face(double& length)
  {
    const Index f = location_.face;
    const Vector normal = normal_of_face(mesh_, f);
    const double twice_area_squared = dot(normal, normal);
    std::array<double, 3> speed;
    double time = length;
    Index exit = null_index; // the halfedge that is crossed
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * f + i, apex = (i + 2) % 3;
      const Vector e = mesh_.points[mesh_.target(h)] - mesh_.points[mesh_.source(h)];
      speed[apex] = dot(cross(normal, e), direction_) / twice_area_squared;
      if(speed[apex] >= 0.)
        continue;
      const double t = location_.coordinates[apex] / -speed[apex];
      if(t < time && location_.coordinates[apex] > 0.)
      {
        time = t;
        exit = h;
      }
      else if(location_.coordinates[apex] <= 0. && -speed[apex] * length > snapping_tolerance)
      {
        time = 0.; // pushed by rounding out of the edge it is on
        exit = h;
      }
    }
    for(Index i = 0; i < 3; ++i)
      location_.coordinates[i] += time * speed[i];
    length -= time;
    if(exit == null_index)
    {
      length = 0.;
      return false;
    }
    location_.coordinates[(exit % 3 + 2) % 3] = 0.;
    snap(location_);
    const Index v = vertex_of(mesh_, location_);
    if(v != null_index)
      return pass_vertex(v);
    if(mesh_.is_border_edge(exit))
      return false;
    const Vector e = mesh_.points[mesh_.target(exit)] - mesh_.points[mesh_.source(exit)];
    const double c = dot(e, direction_) / norm(e);
    location_ = across(mesh_, exit, location_);
    direction_ = in_face(mesh_.opposite[exit], -c, std::sqrt((std::max)(0., 1. - c * c)));
    return true;
  }

  // Straightest: equal angles on both sides.
  bool pass_vertex(Index v)
  {
    if(connectivity_.is_border(v))
      return false;
    double angle = 0.;
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
    {
      const Index h = connectivity_.ring_halfedge[entry];
      if(h / 3 == location_.face)
      {
        const Vector e = mesh_.points[mesh_.target(h)] - mesh_.points[v], back = -1. * direction_;
        angle += (std::min)(std::atan2(norm(cross(e, back)), dot(e, back)), corner_angle(h));
        break;
      }
      angle += corner_angle(h);
    }
    const double total = total_angle(v);
    angle += 0.5 * total;
    return leave_vertex(v, angle < total ? angle : angle - total);
  }

  static double pi() { return 3.14159265358979323846; }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  Indexed_location location_;
  Vector direction_ = {{0., 0., 0.}}; // of unit length, in the plane of the face
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * follows the straightest geodesic \cgalCite{cgal:ps-sgps-98} from `start` for a given length and returns where it
 * ends: straight across edges, and with equal angles on both sides through interior vertices. It stops at the border.
 *
 * @param direction a vector in space, of any length. Inside a face its part in the plane of the face counts; on an edge
 *        its part orthogonal to the mean normal of the faces there. At a vertex its angle to the first edge of the
 *        ring, seen along the normal of the vertex, counts, where the angles around an interior vertex are scaled to
 *        sum up to 2 pi, as in `Tangent_directions`.
 */
inline Indexed_location straightest_geodesic(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                             const Indexed_location& start, const std::array<double, 3>& direction,
                                             double length)
{
  return internal::Geodesic_walk(mesh, connectivity)(start, direction, length);
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_STRAIGHTEST_GEODESIC_H
