// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Polylines through the faces, which become edges of a mesh and so sources.

#include "surface_test.h"

#include <CGAL/refine_along_polylines.h>

namespace test_polylines_as_sources {

namespace {

using namespace surface_test;
using Polyline = std::vector<Location>;

// The straight line from one side of the flat square to the other, at the height y.
Polyline line_across(const Built& built, double y)
{
  std::vector<std::pair<double, Location>> crossings; // by x
  for(std::size_t f = 0; f < built.data.triangles.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t k = (i + 1) % 3;
      const Point &p = built.data.points[built.data.triangles[f][i]],
                  &q = built.data.points[built.data.triangles[f][k]];
      if((p[1] < y) == (q[1] < y))
        continue;
      const double t = (y - p[1]) / (q[1] - p[1]);
      std::array<double, 3> c = {{0., 0., 0.}};
      c[i] = 1. - t;
      c[k] = t;
      crossings.emplace_back(p[0] + t * (q[0] - p[0]), built.location<double>(f, c));
    }
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Polyline result;
  for(std::size_t i = 0; i < crossings.size(); ++i)
    if(i == 0 || crossings[i].first > crossings[i - 1].first + 1e-12) // inner edges come from both sides
      result.push_back(crossings[i].second);
  return result;
}

double length(const Mesh& mesh, const Edges& edges)
{
  double sum = 0.;
  for(const Mesh::Edge_index e : edges)
    sum += CGAL::Polygon_mesh_processing::edge_length(e, mesh);
  return sum;
}

TEST(Polylines_as_sources, become_edges_of_the_same_surface)
{
  const Built built(square(8, 0.2, 3));
  Mesh refined;
  auto origin = refined.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
  auto is_source = refined.add_property_map<Mesh::Edge_index, bool>("e:source", false).first;
  const std::vector<Edges> edges =
    CGAL::refine_along_polylines(built.mesh, std::vector<Polyline>{line_across(built, 0.3), line_across(built, 0.71)},
                                 refined, params::face_to_face_map(origin), params::edge_is_constrained_map(is_source));
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(refined) && CGAL::is_triangle_mesh(refined));
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(refined), 1., 1e-12);
  std::vector<double> area(built.mesh.number_of_faces(), 0.);
  for(const Mesh::Face_index f : refined.faces())
    area[origin[f]] += CGAL::Polygon_mesh_processing::face_area(f, refined);
  for(const Mesh::Face_index f : built.mesh.faces())
    EXPECT_NEAR(area[f], CGAL::Polygon_mesh_processing::face_area(f, built.mesh), 1e-12);
  const double tolerance = mean_edge_length(built.data) / 128.; // the grid, and the longest edges
  std::size_t number_of_marked = 0;
  for(std::size_t i = 0; i < 2; ++i)
    for(const Mesh::Edge_index e : edges[i])
    {
      EXPECT_TRUE(is_source[e]);
      for(unsigned int k = 0; k < 2; ++k)
        EXPECT_NEAR(refined.point(refined.vertex(e, k)).y(), i == 0 ? 0.3 : 0.71, tolerance);
    }
  for(const Mesh::Edge_index e : refined.edges())
    number_of_marked += is_source[e];
  EXPECT_EQ(number_of_marked, edges[0].size() + edges[1].size());
  EXPECT_NEAR(length(refined, edges[0]), 1., tolerance);
  EXPECT_NEAR(length(refined, edges[1]), 1., tolerance);
}

TEST(Polylines_as_sources, two_parallel_lines_have_the_line_between_them)
{
  for(const std::size_t n : {5, 10, 20})
  {
    const Built built(square(n, 0.2, 3));
    Mesh refined;
    const std::vector<Edges> edges = CGAL::refine_along_polylines(
      built.mesh, std::vector<Polyline>{line_across(built, 0.31), line_across(built, 0.73)}, refined);
    const auto result = compute_cut_locus(refined, Vertices(), params::source_curves(edges));
    const double tolerance = mean_edge_length(built.data) / 64.;
    for(const Mesh::Vertex_index v : refined.vertices())
    {
      const double y = refined.point(v).y();
      EXPECT_NEAR(result.distance(v), (std::min)(std::fabs(y - 0.31), std::fabs(y - 0.73)), tolerance);
    }
    std::size_t number = 0;
    const auto& graph = result.graph();
    for(const auto e : CGAL::make_range(boost::edges(graph)))
      if(graph[e].sources[0] != graph[e].sources[1])
      {
        ++number;
        EXPECT_NEAR(graph[source(e, graph)].point.y(), 0.52, tolerance);
      }
    EXPECT_GT(number, n);
  }
}

// The shortest path between two vertices is given by where it crosses edges.
TEST(Polylines_as_sources, a_shortest_path_has_the_distances_to_its_points)
{
  const Built built(torus(1., 0.4, 30, 16, 0.2, 3));
  Geodesics geodesics(built.mesh);
  geodesics.compute(built.vertices[0]);
  Polyline path;
  geodesics.shortest_path(built.vertices[165], std::back_inserter(path));
  ASSERT_GT(path.size(), 10u);
  Mesh refined;
  const std::vector<Edges> edges = CGAL::refine_along_polylines(built.mesh, std::vector<Polyline>{path}, refined,
                                                                params::snapping_tolerance(1. / 65536.));
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(length(refined, edges[0]), geodesics.distance(built.vertices[165]), 1e-4);
  const auto result = compute_cut_locus(refined, Vertices(), params::source_curves(edges));
  EXPECT_EQ(num_edges(result.graph()), num_vertices(result.graph()) + 1) << "an arc leaves the two cycles of the torus";
  geodesics.clear_sources();
  double longest = 0.; // distances to the points are too long by half of a segment at most
  for(std::size_t i = 0; i < path.size(); ++i)
    geodesics.add_source(path[i]);
  geodesics.compute();
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    longest = (std::max)(longest, distance(point(built.mesh, path[i]), point(built.mesh, path[i + 1])));
  for(std::size_t v = 0; v < built.vertices.size(); ++v) // the first vertices are those of the mesh
  {
    const double d = result.distance(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    EXPECT_LE(d, geodesics.distance(built.vertices[v]) + 1e-4);
    EXPECT_GE(d, geodesics.distance(built.vertices[v]) - 0.5 * longest - 1e-4);
  }
}

TEST(Polylines_as_sources, that_cross_are_one)
{
  const Built built(square(6, 0.2, 3));
  const Polyline one = line_across(built, 0.4);
  // along the column of edges from the side below to the one above
  Polyline other;
  for(std::size_t j = 0; j <= 6; ++j)
  {
    const auto v = built.vertices[7 * 3 + j];
    other.push_back(CGAL::Polygon_mesh_processing::locate_vertex<double>(v, built.mesh));
  }
  Mesh refined;
  const std::vector<Edges> edges = CGAL::refine_along_polylines(built.mesh, std::vector<Polyline>{one, other}, refined);
  ASSERT_EQ(edges.size(), 1u);
  const auto result = compute_cut_locus(refined, Vertices(), params::source_curves(edges));
  EXPECT_EQ(result.number_of_sources(), 1u);
}

TEST(Polylines_as_sources, that_can_not_be_used_are_refused_by_their_points)
{
  const Built built(square(6, 0.2, 3));
  Polyline line = line_across(built, 0.4);
  const auto message = [&](const std::vector<Polyline>& polylines)
  {
    Mesh output;
    return refusals::message_of([&] { CGAL::refine_along_polylines(built.mesh, polylines, output); });
  };
  EXPECT_EQ(message({line}), "nothing was thrown");
  expect_has(message({line, {line[0]}}), "polyline 1 has less than two points");
  expect_has(message({{line[0], line[0]}}), "polyline 0 is a point after rounding");
  Polyline gap = line;
  gap.erase(gap.begin() + 2);
  expect_has(message({line, gap}), "polyline 1: points 1 and 2 are in no common face");
  Polyline outside = line;
  outside[1].second = {{-0.5, 0.5, 1.}};
  expect_has(message({outside}), "polyline 0: point 1: a barycentric coordinate");
  outside[1].first = Mesh::Face_index(99999);
  expect_has(message({outside}), "its face is not a face of the mesh");
}

} // namespace

} // namespace test_polylines_as_sources
