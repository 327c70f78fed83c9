// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_MESH_DATA_OF_H
#define CGAL_CUT_LOCI_HELPERS_MESH_DATA_OF_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh.h>

#include <cstddef>

namespace test_meshes {

/// a triangle mesh of CGAL without garbage, as arrays
template <typename Point_3>
Mesh_data mesh_data_of(const CGAL::Surface_mesh<Point_3>& mesh)
{
  Mesh_data result;
  for(const auto v : mesh.vertices())
    result.points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.triangles.push_back(
      {{std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))}});
  }
  return result;
}

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_HELPERS_MESH_DATA_OF_H
