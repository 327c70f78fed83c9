// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H
#define CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

using Geodesic_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geodesic_mesh = CGAL::Surface_mesh<Geodesic_kernel::Point_3>;

// The mesh as CGAL's solvers take it, whatever the type it came from: with dense indices, one component, no garbage.
// Vertex `i` and face `i` keep their index, and halfedge(f) starts at the first vertex of the face.
// It is glued halfedge by halfedge: two edges may join the same two vertices, which Surface_mesh::add_face() refuses.
inline Geodesic_mesh surface_mesh_copy(const Indexed_triangle_mesh& mesh)
{
  using Vertex = Geodesic_mesh::Vertex_index;
  using Halfedge = Geodesic_mesh::Halfedge_index;
  Geodesic_mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_halfedges() / 2, mesh.number_of_faces());
  for(const Indexed_triangle_mesh::Point& p : mesh.points)
    result.add_vertex(Geodesic_kernel::Point_3(p[0], p[1], p[2]));

  const Index nh = mesh.number_of_halfedges();
  std::vector<Halfedge> copy(nh);
  for(Index h = 0; h < nh; ++h)
  {
    const bool is_new = mesh.is_border_edge(h) || h < mesh.opposite[h];
    copy[h] = is_new ? result.add_edge() : result.opposite(copy[mesh.opposite[h]]);
    result.set_target(copy[h], Vertex(mesh.target(h)));
    result.set_halfedge(Vertex(mesh.target(h)), copy[h]);
  }
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    const Geodesic_mesh::Face_index face = result.add_face();
    result.set_halfedge(face, copy[3 * f]);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      result.set_face(copy[h], face);
      result.set_next(copy[h], copy[mesh.next(h)]);
    }
  }
  for(Index h = 0; h < nh; ++h)
  {
    if(!mesh.is_border_edge(h))
      continue;
    const Halfedge border = result.opposite(copy[h]);
    result.set_target(border, Vertex(mesh.source(h)));
    result.set_halfedge(Vertex(mesh.source(h)), border);
    Index last = mesh.previous(h); // around the vertex to its other border edge
    while(!mesh.is_border_edge(last))
      last = mesh.previous(mesh.opposite[last]);
    result.set_next(border, result.opposite(copy[last]));
  }
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H
