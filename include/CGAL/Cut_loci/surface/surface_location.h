// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H
#define CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A barycentric coordinate up to this value is taken for zero. A millionth of a face is far below the accuracy of any
// stage, and far above rounding errors: points that are not the same differ by more than these.
constexpr double snapping_tolerance = 1e-6;

inline void snap(Indexed_location& location)
{
  double sum = 0.;
  for(double& c : location.coordinates)
  {
    if(!(c > snapping_tolerance))
      c = 0.;
    sum += c;
  }
  for(double& c : location.coordinates)
    c /= sum;
}

// the vertex that a snapped location is at, or `null_index`
inline Index vertex_of(const Indexed_triangle_mesh& mesh, const Indexed_location& location)
{
  for(Index i = 0; i < 3; ++i)
    if(location.coordinates[(i + 1) % 3] == 0. && location.coordinates[(i + 2) % 3] == 0.)
      return mesh.triangles[location.face][i];
  return null_index;
}

// the halfedge of its face whose interior a snapped location is on, or `null_index`
inline Index edge_of(const Indexed_location& location)
{
  for(Index i = 0; i < 3; ++i)
    if(location.coordinates[(i + 2) % 3] == 0. && location.coordinates[i] > 0. &&
       location.coordinates[(i + 1) % 3] > 0.)
      return 3 * location.face + i;
  return null_index;
}

// the same point of `h`, named by the face on the other side
inline Indexed_location across(const Indexed_triangle_mesh& mesh, Index h, const Indexed_location& location)
{
  const Index o = mesh.opposite[h];
  Indexed_location result;
  result.face = o / 3;
  result.coordinates[o % 3] = location.coordinates[(h % 3 + 1) % 3];
  result.coordinates[(o % 3 + 1) % 3] = location.coordinates[h % 3];
  return result;
}

inline Vector normal_of_face(const Indexed_triangle_mesh& mesh, Index f)
{
  const Indexed_triangle_mesh::Triangle& t = mesh.triangles[f];
  return cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
}

inline bool unit(const Vector& v, Vector& result)
{
  const double length = norm(v);
  if(!(length > 0.))
    return false;
  result = (1. / length) * v;
  return true;
}

// the part of `v` orthogonal to `normal`
inline Vector tangential(const Vector& v, const Vector& normal)
{
  return v - (dot(v, normal) / dot(normal, normal)) * normal;
}

// the sum of the normals around, weighted by area
inline Vector normal_of_vertex(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index v)
{
  Vector result = {{0., 0., 0.}};
  for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
    if(mesh.source(connectivity.ring_halfedge[entry]) == v)
      result = result + normal_of_face(mesh, connectivity.ring_halfedge[entry] / 3);
  return result;
}

// the normal of the face that a snapped location is in, or the sum of those it is on the border of, weighted by area
inline Vector normal_at(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                        const Indexed_location& location)
{
  const Index v = vertex_of(mesh, location);
  if(v != null_index)
    return normal_of_vertex(mesh, connectivity, v);
  const Index h = edge_of(location);
  Vector result = normal_of_face(mesh, location.face);
  if(h != null_index && !mesh.is_border_edge(h))
    result = result + normal_of_face(mesh, mesh.opposite[h] / 3);
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H
