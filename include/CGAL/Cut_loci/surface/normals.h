// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_NORMALS_H
#define CGAL_CUT_LOCI_SURFACE_NORMALS_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

namespace CGAL {
namespace Cut_loci {
namespace internal {

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

#endif // CGAL_CUT_LOCI_SURFACE_NORMALS_H
