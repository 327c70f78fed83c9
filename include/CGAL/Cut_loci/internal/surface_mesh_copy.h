// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_SURFACE_MESH_COPY_H
#define CGAL_CUT_LOCI_INTERNAL_SURFACE_MESH_COPY_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Cut_loci {
namespace internal {

using Geodesic_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geodesic_mesh = CGAL::Surface_mesh<Geodesic_kernel::Point_3>;

// The mesh as CGAL's solvers take it, whatever the type it came from: with dense indices, one component, no garbage.
// Vertex `i` and face `i` keep their index, and halfedge(f) starts at the first vertex of the face.
inline Geodesic_mesh surface_mesh_copy(const Indexed_triangle_mesh& mesh)
{
  Geodesic_mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_halfedges() / 2, mesh.number_of_faces());
  for(const Indexed_triangle_mesh::Point& p : mesh.points)
    result.add_vertex(Geodesic_kernel::Point_3(p[0], p[1], p[2]));
  using Vertex = Geodesic_mesh::Vertex_index;
  for(const Indexed_triangle_mesh::Triangle& t : mesh.triangles)
  {
    const Geodesic_mesh::Face_index f = result.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    Geodesic_mesh::Halfedge_index h = result.halfedge(f);
    while(result.source(h) != Vertex(t[0]))
      h = result.next(h);
    result.set_halfedge(f, h);
  }
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_SURFACE_MESH_COPY_H
