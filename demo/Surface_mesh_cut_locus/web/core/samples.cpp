// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "samples.h"

#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

// Each generator takes the number of edges along a line of its own, whose square is a multiple of the number of faces.
test_meshes::Mesh_data generate(const std::string& name, double number_of_faces)
{
  using namespace test_meshes;
  const auto size = [&](double faces_per_square)
  { return (std::max)(3, static_cast<int>(std::lround(std::sqrt(number_of_faces / faces_per_square)))); };
  if(name == "torus")
  {
    const int n = size(5.);
    return torus(1., 0.4, 5 * n / 2, n, 0.2, 1);
  }
  if(name == "bumpy-sphere")
    return bumpy_sphere(size(20.), 0.5, 1);
  if(name == "genus-3")
    return rounded_plate(3, 1, size(136.));
  if(name == "capsule")
  {
    const int n = size(8.);
    return capsule(1., 2 * n, 2 * n);
  }
  if(name == "sphere-with-bump")
    return sphere_with_bump(size(20.), {{1., 0., 0.}}, 0.15, 0.08);
  if(name == "open-square")
    return square(size(2.), 0.2, 1);
  throw std::invalid_argument("there is no sample of the name '" + name + "'");
}

} // namespace

Mesh make_sample(const std::string& name, double number_of_faces)
{
  const test_meshes::Mesh_data data = generate(name, number_of_faces);
  Mesh mesh;
  mesh.reserve(data.points.size(), 3 * data.triangles.size() / 2, data.triangles.size());
  for(const auto& p : data.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& t : data.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}
