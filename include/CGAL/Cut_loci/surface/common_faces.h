// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_COMMON_FACES_H
#define CGAL_CUT_LOCI_SURFACE_COMMON_FACES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

namespace CGAL::Cut_loci::internal {

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

#endif // CGAL_CUT_LOCI_SURFACE_COMMON_FACES_H
