// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H
#define CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

namespace CGAL::Cut_loci::internal {

// A barycentric coordinate up to this value is taken for zero. A millionth of a face is far below the accuracy of any
// stage, and far above rounding errors: points that are not the same differ by more than these.
constexpr double snapping_tolerance = 1e-6;

// makes coordinates sum up to one, those that are no larger than `tolerance` with another value in their place
inline void normalize(std::array<double, 3>& coordinates, double tolerance = 0., double instead = 0.)
{
  for(double& c : coordinates)
    c = c > tolerance ? c : instead;
  const double sum = coordinates[0] + coordinates[1] + coordinates[2];
  for(double& c : coordinates)
    c /= sum;
}

inline void snap(Indexed_location& location, double tolerance = snapping_tolerance)
{
  normalize(location.coordinates, tolerance);
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

// the point at the share `t` of the halfedge `h`: its source, if that is 0
inline Indexed_location location_on(Index h, double t = 0.)
{
  Indexed_location result;
  result.face = h / 3;
  result.coordinates[h % 3] = 1. - t;
  result.coordinates[(h % 3 + 1) % 3] = t;
  return result;
}

inline Indexed_location location_of_vertex(const Mesh_connectivity& connectivity, Index v)
{
  return location_on(connectivity.ring_halfedge[connectivity.ring_begin[v]]); // outgoing
}

// the same point of `h`, named by the face of `opposite`
inline Indexed_location across(Index h, Index opposite, const Indexed_location& location)
{
  Indexed_location result;
  result.face = opposite / 3;
  result.coordinates[opposite % 3] = location.coordinates[(h % 3 + 1) % 3];
  result.coordinates[(opposite % 3 + 1) % 3] = location.coordinates[h % 3];
  return result;
}

inline Indexed_location across(const Indexed_triangle_mesh& mesh, Index h, const Indexed_location& location)
{
  return across(h, mesh.opposite[h], location);
}

// the same point, which is in `face`, in the coordinates of that face
inline Indexed_location in_face(const Indexed_triangle_mesh& mesh, const Indexed_location& location, Index face)
{
  if(location.face == face)
    return location;
  const Index v = vertex_of(mesh, location);
  if(v == null_index)
    return across(mesh, edge_of(location), location);
  Index h = 3 * face;
  while(mesh.source(h) != v)
    h = mesh.next(h);
  return location_on(h);
}

// Calls `f` with each face that a location is in, which has zeros where it is on an edge or a vertex.
template <typename Function>
void for_each_face_at(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                      const Indexed_location& location, const Function& f)
{
  const Index v = vertex_of(mesh, location), h = edge_of(location);
  if(v != null_index)
  {
    for(Index entry = connectivity.ring_begin[v]; entry < connectivity.ring_begin[v + 1]; ++entry)
      if(mesh.source(connectivity.ring_halfedge[entry]) == v)
        f(connectivity.ring_halfedge[entry] / 3);
    return;
  }
  f(location.face);
  if(h != null_index && !mesh.is_border_edge(h))
    f(mesh.opposite[h] / 3);
}

// Calls `f` with each face that two locations have in common.
template <typename Function>
void for_each_common_face(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                          const Indexed_location& a, const Indexed_location& b, const Function& f)
{
  for_each_face_at(mesh, connectivity, a,
                   [&](Index face)
                   {
    bool is_common = false;
    for_each_face_at(mesh, connectivity, b, [&](Index g) { is_common = is_common || g == face; });
    if(is_common)
      f(face);
  });
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_SURFACE_LOCATION_H
