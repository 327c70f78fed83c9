// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The measures themselves, on curves whose detour is known.

#include "built_mesh.h"
#include "completeness.h"
#include "detour.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/exact_geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Cut_locus = CGAL::Cut_locus<Mesh, CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using CGAL::Cut_loci::Method;
using curve_measures::Measures;
namespace params = CGAL::parameters;

// unit squares, n in a row; vertex (n + 1) j + i at (i, j)
Mesh_data square(std::size_t n)
{
  Mesh_data m;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i)
      m.points.push_back({{double(i), double(j), 0.}});
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = (n + 1) * j + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      m.triangles.push_back({{a, b, c}});
      m.triangles.push_back({{a, c, d}});
    }
  return m;
}

// A curve along the points (x, j) of the square, j = first, ..., last.
Cut_locus wall(const Built_mesh<Mesh>& built, std::size_t n, double x, std::size_t first, std::size_t last,
               std::size_t source)
{
  const Mesh& mesh = built.mesh;
  const auto at_vertex = [&](std::size_t v)
  {
    Cut_locus::Vertex result;
    const auto h = halfedge(built.vertices[v], mesh); // its target is the vertex
    const auto face = mesh.is_border(h) ? mesh.face(mesh.opposite(h)) : mesh.face(h);
    result.location.first = face;
    auto k = mesh.halfedge(face);
    for(int i = 0; i < 3; ++i, k = mesh.next(k))
      result.location.second[i] = mesh.source(k) == built.vertices[v] ? 1. : 0.;
    result.mesh_vertex = built.vertices[v];
    result.point = mesh.point(built.vertices[v]);
    return result;
  };
  Cut_locus::Graph graph;
  const std::size_t column = static_cast<std::size_t>(x);
  for(std::size_t j = first; j <= last; ++j)
  {
    Cut_locus::Vertex node = at_vertex((n + 1) * j + column);
    if(x > double(column)) // on the horizontal edge, a side of the face above or, at the top, below
    {
      const std::size_t a = (n + 1) * j + column, f = j < n ? 2 * (n * j + column) : 2 * (n * (j - 1) + column) + 1;
      const double t = x - double(column);
      node.location = built.location<double>(f, j < n ? std::array<double, 3>{{1. - t, t, 0.}}
                                                      : std::array<double, 3>{{0., t, 1. - t}});
      node.mesh_vertex = Mesh::null_vertex();
      node.point = CGAL::ORIGIN + ((1. - t) * (mesh.point(built.vertices[a]) - CGAL::ORIGIN) +
                                   t * (mesh.point(built.vertices[a + 1]) - CGAL::ORIGIN));
    }
    // On the diagonal of the square below, before the next horizontal edge.
    if(x > double(column) && j > first)
    {
      const std::size_t f = 2 * (n * (j - 1) + column);
      const double t = x - double(column);
      Cut_locus::Vertex between = node;
      between.location = built.location<double>(f, {{1. - t, 0., t}});
      between.point = CGAL::Simple_cartesian<double>::Point_3(x, double(j - 1) + t, 0.);
      add_vertex(between, graph);
      add_edge(num_vertices(graph) - 2, num_vertices(graph) - 1, {}, graph);
    }
    add_vertex(node, graph);
    if(j > first)
    {
      Cut_locus::Edge edge;
      if(x == double(column))
        edge.mesh_halfedge = mesh.halfedge(graph[num_vertices(graph) - 2].mesh_vertex, node.mesh_vertex);
      add_edge(num_vertices(graph) - 2, num_vertices(graph) - 1, edge, graph);
    }
  }
  auto result = std::make_shared<CGAL::Cut_loci::internal::Source_result>();
  return Cut_locus(graph, at_vertex(source), built.vertices[0], result, [](Vertex) { return 0.; });
}

double mean_length(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

TEST(Detour, Around_the_end_of_a_wall)
{
  // The wall stands on the lower side up to (x, 5), the source is the lower left corner: the way to what it hides leads
  // over its end.
  const std::size_t n = 10;
  const Built_mesh<Mesh> built(square(n));
  for(double x : {5., 5.5, 5. + 1e-4, 5. + 1e-7, 6. - 1e-9})
  {
    SCOPED_TRACE(x);
    const Measures m = curve_measures::measure(built.mesh, wall(built, n, x, 0, 5, 0));
    EXPECT_EQ(m.topology_fault, "");
    EXPECT_EQ(m.measuring_failed, "");
    double longest = 0.;
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        if(double(i) > x + 1e-5 && double(j) * x < 5. * double(i)) // nearer vertices are on the wall, after rounding
          longest = (std::max)(longest, std::hypot(x, 5.) + std::hypot(double(i) - x, 5. - double(j)) -
                                          std::hypot(double(i), double(j)));
    EXPECT_NEAR(m.max * mean_length(built.mesh), longest, 1e-3);
    EXPECT_GT(m.mean, 0.);
    EXPECT_LE(m.p99, m.max);
  }
}

TEST(Detour, Wrong_topology_is_named)
{
  const std::size_t n = 10;
  const Built_mesh<Mesh> built(square(n));
  // apart from the border
  EXPECT_NE(curve_measures::measure(built.mesh, wall(built, n, 5., 2, 5, 0)).topology_fault.find("2 components"),
            std::string::npos);
  // from side to side: what it cuts off would have no distance
  for(double x : {5., 5.5})
  {
    const Measures m = curve_measures::measure(built.mesh, wall(built, n, x, 0, n, 0));
    EXPECT_NE(m.topology_fault.find("1 independent cycles"), std::string::npos) << m.topology_fault;
    EXPECT_EQ(m.measuring_failed, "");
    EXPECT_TRUE(std::isfinite(m.max));
  }
}

TEST(Detour, Vanishes_on_the_cut_locus_and_only_there)
{
  const Built_mesh<Mesh> built(torus(1., 0.4, 60, 24, 0.2, 3));
  const Mesh& mesh = built.mesh;
  const Vertex source = built.vertices[0], other = built.vertices[30 * 24 + 12];
  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(mesh);
  cut_loci.set_source(source);
  const auto right = cut_loci.cut_locus();
  const auto through_faces = cut_loci.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
  std::vector<double> exact;
  for(const auto* curve : {&right, &through_faces})
  {
    const Measures m = curve_measures::measure(mesh, *curve, exact);
    EXPECT_EQ(m.topology_fault, "");
    EXPECT_EQ(m.measuring_failed, "");
    EXPECT_LT(m.max, 1.);
    EXPECT_LT(m.mean, 0.01);
  }
  // the curve of another source, which its distances find
  Mesh copy = mesh;
  auto map = copy.add_property_map<Vertex, double>("v:distance", 0.).first;
  CGAL::exact_geodesic_distances(copy, other, map);
  CGAL::Surface_mesh_cut_locus<Mesh> misled(copy);
  misled.set_source(source, params::vertex_distance_map(map));
  const Measures m = curve_measures::measure(copy, misled.cut_locus());
  EXPECT_EQ(m.measuring_failed, "");
  EXPECT_GT(m.max, 5.);

  EXPECT_DOUBLE_EQ(curve_measures::completeness(right, 0., right, 0.1), 1.);
  EXPECT_LT(curve_measures::completeness(right, 0., misled.cut_locus(), 0.1), 0.5);
}

TEST(Detour, Source_in_a_face)
{
  const Built_mesh<Mesh> built(torus(1., 0.4, 40, 16, 0.2, 3));
  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(built.mesh);
  cut_loci.set_source(built.location<double>(100, {{0.2, 0.3, 0.5}}));
  for(const auto curve : {CGAL::Cut_loci::Curve::MESH_EDGES, CGAL::Cut_loci::Curve::THROUGH_FACES})
  {
    const Measures m = curve_measures::measure(built.mesh, cut_loci.cut_locus(params::cut_locus_curve(curve)));
    EXPECT_EQ(m.topology_fault, "");
    EXPECT_EQ(m.measuring_failed, "");
    EXPECT_LT(m.max, 1.5);
  }
}

} // namespace
