// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_REMESHED_H
#define CGAL_CUT_LOCI_REMESHED_H

#include "built_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

namespace test_meshes {

// The same surface with triangles that are nearly equilateral, with edges of about `length`.
inline Mesh_data remeshed(const Mesh_data& m, double length)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Built_mesh<Mesh> built(m);
  Mesh& mesh = built.mesh;
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh,
                                                     CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  Mesh_data result;
  for(Mesh::Vertex_index v : mesh.vertices())
    result.points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result.triangles.push_back(
      {{std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))}});
  }
  return result;
}

// with edges as long as before, on average
inline Mesh_data remeshed(const Mesh_data& m)
{
  return remeshed(m, mean_edge_length(m));
}

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_REMESHED_H
