// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_BENCHMARK_JITTERED_TORUS_H
#define SURFACE_MESH_CUT_LOCUS_BENCHMARK_JITTERED_TORUS_H

#include <cmath>
#include <cstddef>
#include <random>

// A torus of radii 1 and 0.4, with `n` vertices the long way around and `m` the short one, each moved along the surface by
// up to a fifth of the spacing. `Mesh` is a `CGAL::Surface_mesh`.
template <typename Mesh>
Mesh jittered_torus(std::size_t n, std::size_t m)
{
  using Size = typename Mesh::size_type;
  const double pi = 3.14159265358979323846;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  Mesh mesh;
  mesh.reserve(Size(n * m), Size(3 * n * m), Size(2 * n * m));
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j)
    {
      const double u = 2. * pi * (double(i) + jitter(random)) / double(n);
      const double w = 2. * pi * (double(j) + jitter(random)) / double(m);
      const double r = 1. + 0.4 * std::cos(w);
      mesh.add_vertex(typename Mesh::Point(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(w)));
    }
  const auto vertex = [&](std::size_t i, std::size_t j)
  { return typename Mesh::Vertex_index(Size((i % n) * m + j % m)); };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

#endif // SURFACE_MESH_CUT_LOCUS_BENCHMARK_JITTERED_TORUS_H
