// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_FACE_PLANE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_FACE_PLANE_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>

#include <array>
#include <cmath>

namespace CGAL::Cut_loci::internal {

// Points in the plane of a face, in the frame of its first halfedge.

using Face_corners = std::array<Plane_point, 3>;

inline Face_corners corners_of(const Geodesic_faces& faces, Index f)
{
  return {{{0., 0.}, {faces.length(3 * f), 0.}, faces.apex(3 * f)}};
}

/// barycentric coordinates, which may be negative
inline std::array<double, 3> coordinates_in(const Face_corners& corners, const Plane_point& p)
{
  const double third = p.y / corners[2].y, second = (p.x - third * corners[2].x) / corners[1].x;
  return {{1. - second - third, second, third}};
}

/// the point at a share of the way from one to another
inline Plane_point between(const Plane_point& p, const Plane_point& q, double share)
{
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}

/// the point of an edge at the length `t` of its halfedge, in the face on the other side
inline Plane_point across(const Geodesic_faces& faces, Index h, double t)
{
  const Index o = faces.opposite(h);
  const Face_corners corners = corners_of(faces, o / 3);
  return between(corners[o % 3], corners[(o + 1) % 3], 1. - t / faces.length(h));
}

/// twice the area of a triangle, negative if it is clockwise
inline double cross(const Plane_point& a, const Plane_point& b, const Plane_point& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline double squared_distance(const Plane_point& a, const Plane_point& b)
{
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}
inline double distance(const Plane_point& a, const Plane_point& b)
{
  return std::sqrt(squared_distance(a, b));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_FACE_PLANE_H
