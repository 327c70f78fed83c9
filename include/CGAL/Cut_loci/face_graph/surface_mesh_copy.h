// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H
#define CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL::Cut_loci::internal {

using Geodesic_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geodesic_mesh = CGAL::Surface_mesh<Geodesic_kernel::Point_3>;

// The mesh as CGAL's solvers take it, whatever the type it came from: with dense indices, one component, no garbage.
// Vertex `i` and face `i` keep their index, and halfedge(f) starts at the first vertex of the face.
inline Geodesic_mesh surface_mesh_copy(const Indexed_triangle_mesh& mesh)
{
  Geodesic_mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_halfedges() / 2, mesh.number_of_faces());
  const auto built = build_face_graph(mesh, result);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    result.point(built.vertices[v]) = {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]};
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_SURFACE_MESH_COPY_H
