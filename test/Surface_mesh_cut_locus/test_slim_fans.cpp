// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Fans of slim faces: shortest paths to different sides of a vertex cross the same long edges before they part, and on
// the edges of the mesh there is no room for all of them.

#include "built_mesh.h"
#include "detour.h"

#include <CGAL/Exact_geodesic_solver.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Method;
using test_meshes::Mesh_data;
namespace params = CGAL::parameters;

// A torus of eight rings, with so many vertices as given, one after the other.
Mesh_data torus_of_rings(const std::vector<std::size_t>& numbers)
{
  const double pi = std::acos(-1.);
  const std::size_t rings = 8;
  Mesh_data m;
  std::vector<std::size_t> first;
  for(std::size_t k = 0; k < rings; ++k)
  {
    const std::size_t n = numbers[k % numbers.size()];
    const double t = 2. * pi * double(k) / double(rings), r = 3. + 1.2 * std::cos(t);
    first.push_back(m.points.size());
    for(std::size_t i = 0; i < n; ++i)
    {
      const double u = 2. * pi * double(i) / double(n);
      m.points.push_back({{r * std::cos(u), r * std::sin(u), std::sin(t)}});
    }
  }
  for(std::size_t k = 0; k < rings; ++k)
  {
    const std::size_t next = (k + 1) % rings, a = numbers[k % numbers.size()], b = numbers[next % numbers.size()];
    for(std::size_t i = 0, j = 0; i < a || j < b;)
    {
      const std::size_t p = first[k] + i % a, q = first[next] + j % b;
      if(j >= b || (i < a && (i + 1) * b <= (j + 1) * a))
        m.triangles.push_back({{p, first[k] + ++i % a, q}});
      else
        m.triangles.push_back({{p, first[next] + ++j % b, q}});
    }
  }
  return m;
}

// A curve of mesh edges is accurate to about an edge.
TEST(Slim_fans, make_no_shortest_path_longer_by_an_edge)
{
  for(const std::vector<std::size_t>& numbers :
      {std::vector<std::size_t>{3, 40}, std::vector<std::size_t>{4, 40}, std::vector<std::size_t>{5, 61, 17}})
  {
    const Built_mesh<Mesh> built(torus_of_rings(numbers));
    CGAL::Surface_mesh_cut_locus<Mesh> solver(
      built.mesh, params::geodesic_solver(CGAL::Exact_geodesic_solver()).cut_locus_method(Method::LAPLACIAN));
    const std::size_t n = built.vertices.size(), sources = 6;
    for(std::size_t i = 0; i < sources; ++i)
    {
      const std::size_t source = (2 * i + 1) * n / (2 * sources);
      SCOPED_TRACE(std::to_string(numbers.back()) + " vertices, source " + std::to_string(source));
      solver.set_source(built.vertices[source]);
      for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
      {
        const curve_measures::Measures m = curve_measures::measure(
          built.mesh, solver.cut_locus(params::cut_locus_curve(curve).gradient_angle_threshold(0.3)));
        EXPECT_EQ(m.topology_fault, "");
        EXPECT_EQ(m.measuring_failed, "");
        EXPECT_LT(m.max, 1.) << "at vertex " << m.worst;
      }
    }
  }
}

} // namespace
