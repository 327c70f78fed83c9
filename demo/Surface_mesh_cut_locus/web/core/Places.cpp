// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Places.h"

#include <array>

void Places::append_vertex(Mesh::Vertex_index v)
{
  parents.insert(parents.end(), 3, static_cast<std::uint32_t>(v));
  weights.insert(weights.end(), {1.f, 0.f, 0.f});
}

void Places::append_point(const Mesh& mesh, Mesh::Face_index face, const Kernel::Point_3& point)
{
  const Mesh::Halfedge_index h = mesh.halfedge(face);
  const std::array<Mesh::Vertex_index, 3> corners = {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
  const auto vector = [&](std::size_t i) { return mesh.point(corners[i]) - mesh.point(corners[0]); };
  const Kernel::Vector_3 p = point - mesh.point(corners[0]), a = vector(1), b = vector(2);
  const Kernel::Vector_3 normal = CGAL::cross_product(a, b);
  const double area = normal.squared_length();
  const double first = area > 0. ? CGAL::cross_product(p, b) * normal / area : 0.;
  const double second = area > 0. ? CGAL::cross_product(a, p) * normal / area : 0.;
  for(const Mesh::Vertex_index corner : corners)
    parents.push_back(static_cast<std::uint32_t>(corner));
  for(const double weight : {1. - first - second, first, second})
    weights.push_back(static_cast<float>(weight));
}
