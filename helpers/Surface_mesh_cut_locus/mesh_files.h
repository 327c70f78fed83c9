// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_MESH_FILES_H
#define CGAL_CUT_LOCI_MESH_FILES_H

#include "test_meshes.h"

#include <string>

namespace test_meshes {

// The triangle mesh in a file of any format that CGAL reads; throws `std::runtime_error` if there is none.
Mesh_data read_mesh(const std::string& file);

// The same as a `CGAL::Surface_mesh`.
template <typename Mesh>
Mesh read_surface_mesh(const std::string& file)
{
  const Mesh_data data = read_mesh(file);
  using Size = typename Mesh::size_type;
  using Vertex = typename Mesh::Vertex_index;
  Mesh mesh;
  mesh.reserve(Size(data.points.size()), Size(3 * data.triangles.size() / 2), Size(data.triangles.size()));
  for(const Point& p : data.points)
    mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2]));
  for(const Triangle& t : data.triangles)
    mesh.add_face(Vertex(Size(t[0])), Vertex(Size(t[1])), Vertex(Size(t[2])));
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_MESH_FILES_H
