// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_REMESHED_SURFACE_H
#define CGAL_CUT_LOCI_BENCHMARK_REMESHED_SURFACE_H

#include "analytic_surfaces.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <stdexcept>

namespace analytic {

template <typename Surface>
void project(const Surface& surface, Mesh& mesh)
{
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = surface.project(mesh.point(v));
}

// An isotropic mesh of `surface` with edges of about `length`.
template <typename Surface>
Mesh remeshed(const Surface& surface, double length)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh = surface.grid(1.3 * length);
  for(int i = 0; i < 3; ++i)
  {
    PMP::isotropic_remeshing(faces(mesh), length, mesh, CGAL::parameters::number_of_iterations(3));
    project(surface, mesh);
  }
  mesh.collect_garbage();
  for(Mesh::Face_index f : mesh.faces())
  {
    const Vector n = PMP::compute_face_normal(f, mesh);
    if(n * surface.normal(mesh.point(mesh.source(mesh.halfedge(f)))) <= 0.5)
      throw std::runtime_error("remeshing folded a triangle");
  }
  return mesh;
}

// Moves the vertex nearest to `p` there, and returns it.
inline Mesh::Vertex_index snap_vertex(Mesh& mesh, const Point& p)
{
  Mesh::Vertex_index nearest = *mesh.vertices().begin();
  for(Mesh::Vertex_index v : mesh.vertices())
    if(CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(nearest), p))
      nearest = v;
  mesh.point(nearest) = p;
  return nearest;
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_REMESHED_SURFACE_H
