// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/insert_vertex.h>
#include <CGAL/Graph_geodesic_solver.h>

namespace test_graph_geodesic_solver {

namespace {

using namespace surface_test;
using Mesh = Indexed_triangle_mesh;

template <typename Solver>
std::vector<double> distances(const Mesh& mesh, const Indexed_source& source)
{
  Solver solver;
  solver.set_mesh(mesh);
  std::vector<double> result;
  solver.compute_distances(source, result);
  return result;
}

std::vector<double> graph(const Mesh& mesh, const Indexed_source& s)
{
  return distances<CGAL::Graph_geodesic_solver>(mesh, s);
}

std::vector<double> exact(const Mesh& mesh, const Indexed_source& s)
{
  return distances<CGAL::Shortest_path_geodesic_solver>(mesh, s);
}

struct Error
{
  double lowest = 0., highest = 0., mean = 0.;
};

Error relative_error(const std::vector<double>& d, const std::vector<double>& reference)
{
  Error e;
  for(std::size_t v = 0; v < d.size(); ++v)
    if(reference[v] > 0.)
    {
      const double x = d[v] / reference[v] - 1.;
      e.lowest = (std::min)(e.lowest, x);
      e.highest = (std::max)(e.highest, x);
      e.mean += x / double(d.size());
    }
  return e;
}

// The same graph by other means: each pair of faces is laid out in space by turning one around the edge.
std::vector<double> brute_force(const Mesh& mesh, Index source)
{
  using namespace CGAL::Cut_loci::internal;
  struct Arc
  {
    Index v, w;
    double length;
  };
  std::vector<Arc> arcs;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const Vector p = mesh.points[mesh.source(h)], q = mesh.points[mesh.target(h)];
    arcs.push_back({mesh.source(h), mesh.target(h), norm(q - p)});
    const Index o = mesh.opposite[h];
    if(o == null_index)
      continue;
    const Index a = mesh.source(mesh.previous(h)), b = mesh.source(mesh.previous(o));
    const double e2 = dot(q - p, q - p);
    const double sa = dot(mesh.points[a] - p, q - p) / e2, sb = dot(mesh.points[b] - p, q - p) / e2;
    const double ha = norm(mesh.points[a] - (p + sa * (q - p))), hb = norm(mesh.points[b] - (p + sb * (q - p)));
    const double crossing = sa + (sb - sa) * ha / (ha + hb);
    if(crossing >= 0. && crossing <= 1.)
      arcs.push_back({a, b, std::sqrt((sa - sb) * (sa - sb) * e2 + (ha + hb) * (ha + hb))});
  }
  std::vector<double> d(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  d[source] = 0.;
  for(bool changed = true; changed;)
  {
    changed = false;
    for(const Arc& a : arcs)
    {
      if(d[a.v] + a.length < d[a.w])
      {
        d[a.w] = d[a.v] + a.length;
        changed = true;
      }
      if(d[a.w] + a.length < d[a.v])
      {
        d[a.v] = d[a.w] + a.length;
        changed = true;
      }
    }
  }
  return d;
}

constexpr double rounding = 1e-6; // the lengths of the arcs are in single precision

TEST(Graph_geodesic_solver, equals_brute_force_on_its_graph)
{
  for(const Mesh& mesh :
      {indexed(torus_with_shifted_rows(24, 13)), indexed(hilly_sphere(16)), indexed(needles(12)), indexed(grid(9, 7))})
    for(Index v : {Index(0), mesh.number_of_vertices() / 2})
    {
      const std::vector<double> d = graph(mesh, at_vertex(mesh, v)), reference = brute_force(mesh, v);
      for(Index w = 0; w < mesh.number_of_vertices(); ++w)
        ASSERT_NEAR(d[w], reference[w], rounding * reference[w]);
    }
}

TEST(Graph_geodesic_solver, is_an_upper_bound_with_a_small_error)
{
  for(const Mesh& mesh : {indexed(torus_with_shifted_rows(60, 25)), indexed(sphere_of_squares(24))})
  {
    const Indexed_source s = at_vertex(mesh, 7);
    const Error e = relative_error(graph(mesh, s), exact(mesh, s));
    EXPECT_GE(e.lowest, -rounding);
    // Right triangles in eight directions: the widest angle between them, 45 degrees, costs 1 / cos(22.5 degrees).
    EXPECT_LE(e.mean, 0.05);
    EXPECT_LE(e.highest, 0.09);
    RecordProperty("mean_relative_error", std::to_string(e.mean));
    RecordProperty("largest_relative_error", std::to_string(e.highest));
  }
  for(const Mesh& mesh : {indexed(hilly_sphere(16)), indexed(needles(12))})
  {
    const Indexed_source s = at_vertex(mesh, 3);
    EXPECT_GE(relative_error(graph(mesh, s), exact(mesh, s)).lowest, -rounding);
  }
}

TEST(Graph_geodesic_solver, is_exact_along_edges_and_dual_edges)
{
  const Mesh mesh = indexed(grid(11, 11)); // unit squares, each cut from its lowest to its highest corner
  const Index middle = 5 * 11 + 5;
  const std::vector<double> d = graph(mesh, at_vertex(mesh, middle));
  for(int y = -5; y <= 5; ++y)
    for(int x = -5; x <= 5; ++x)
    {
      const bool is_along_arcs = x == 0 || y == 0 || x == y || x == -y || x == 2 * y || y == 2 * x;
      const double error = d[Index((5 + y) * 11 + 5 + x)] - std::hypot(x, y);
      EXPECT_GE(error, -1e-5) << x << " " << y;
      EXPECT_TRUE(!is_along_arcs || error <= 1e-5) << x << " " << y;
    }
}

TEST(Graph_geodesic_solver, satisfies_the_triangle_inequality)
{
  const Mesh mesh = indexed(hilly_sphere(12));
  std::vector<std::vector<double>> d;
  for(Index v = 0; v < mesh.number_of_vertices(); v += 5)
    d.push_back(graph(mesh, at_vertex(mesh, v)));
  for(std::size_t i = 0; i < d.size(); ++i)
    for(std::size_t j = 0; j < d.size(); ++j)
    {
      EXPECT_NEAR(d[i][5 * j], d[j][5 * i], rounding * d[i][5 * j]);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        ASSERT_LE(d[i][v], d[i][5 * j] + d[j][v] + rounding);
    }
}

TEST(Graph_geodesic_solver, takes_sources_in_faces_and_on_edges)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for(const Mesh& mesh : {indexed(torus_with_shifted_rows(30, 13)), indexed(grid(9, 9))})
    for(int k = 0; k < 6; ++k)
    {
      const double a = uniform(random), b = uniform(random) * (1. - a);
      const Index f = static_cast<Index>(uniform(random) * mesh.number_of_faces());
      const Indexed_source s = k % 2 == 0 ? in_face(f, a, b, 1. - a - b) : in_face(f, a, 0., 1. - a);
      const std::vector<double> d = graph(mesh, s);
      Mesh refined = mesh;
      CGAL::Cut_loci::internal::insert_vertex_into(refined, s.location);
      std::vector<double> reference = exact(refined, at_vertex(refined, mesh.number_of_vertices()));
      reference.pop_back();
      const Error e = relative_error(d, reference);
      EXPECT_GE(e.lowest, -rounding);
      EXPECT_LE(e.mean, 0.06);
      EXPECT_LE(e.highest, 0.3);       // next to the source, where few arcs are to choose from
      for(Index v : mesh.triangles[f]) // straight in the face; around a convex edge may be no shorter
        EXPECT_NEAR(d[v], reference[v], 1e-6);
    }
  const Mesh flat = indexed(grid(3, 3)); // straight lines across one edge
  const std::vector<double> d = graph(flat, in_face(0, 0.4, 0.3, 0.3));
  const auto p = CGAL::Cut_loci::internal::position(flat, {0, {{0.4, 0.3, 0.3}}});
  for(Index v : {0, 1, 3, 4})
  {
    const Mesh::Point& q = flat.points[v];
    EXPECT_NEAR(d[v], std::hypot(q[0] - p[0], q[1] - p[1]), 1e-6);
  }
}

TEST(Graph_geodesic_solver, agrees_on_an_edge_whichever_face_names_it)
{
  const Mesh mesh = indexed(torus_with_shifted_rows(12, 7));
  for(Index h = 0; h < mesh.number_of_halfedges(); h += 5)
  {
    Indexed_source s, t;
    const Index o = mesh.opposite[h];
    s.location.face = h / 3;
    s.location.coordinates[h % 3] = 0.3;
    s.location.coordinates[(h + 1) % 3] = 0.7;
    t.location.face = o / 3;
    t.location.coordinates[o % 3] = 0.7;
    t.location.coordinates[(o + 1) % 3] = 0.3;
    const std::vector<double> d = graph(mesh, s), e = graph(mesh, t);
    for(std::size_t v = 0; v < d.size(); ++v)
      ASSERT_NEAR(d[v], e[v], 1e-9);
  }
}

TEST(Graph_geodesic_solver, scales_exactly_and_repeats)
{
  const Mesh mesh = indexed(hilly_sphere(14));
  const std::vector<double> d = graph(mesh, at_vertex(mesh, 5));
  EXPECT_EQ(d, graph(mesh, at_vertex(mesh, 5)));
  for(int exponent : {-170, 170}) // far outside of the range of single precision
  {
    Mesh scaled = mesh;
    for(auto& p : scaled.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    const std::vector<double> e = graph(scaled, at_vertex(mesh, 5));
    for(std::size_t v = 0; v < d.size(); ++v)
      ASSERT_EQ(e[v], std::ldexp(d[v], exponent));
  }
  CGAL::Graph_geodesic_solver solver;
  solver.set_mesh(mesh);
  CGAL::Graph_geodesic_solver copy = solver;
  std::vector<double> a, b;
  solver.compute_distances(at_vertex(mesh, 9), a);
  solver.compute_distances(at_vertex(mesh, 5), a);
  copy.compute_distances(at_vertex(mesh, 5), b);
  EXPECT_EQ(a, d);
  EXPECT_EQ(b, d);
}

TEST(Graph_geodesic_solver, leaves_other_components_at_infinity)
{
  const Mesh mesh = indexed(disjoint_union(grid(4, 4), grid(4, 4), {{0., 0., 0.}}));
  const std::vector<double> d = graph(mesh, at_vertex(mesh, 0));
  for(std::size_t v = 0; v < d.size(); ++v)
    EXPECT_EQ(std::isinf(d[v]), v >= d.size() / 2);
}

TEST(Graph_geodesic_solver, serves_the_cut_locus)
{
  const Built built(torus_with_shifted_rows(60, 25));
  EXPECT_EQ(number_of_cycles(
              compute_cut_locus(built.mesh, built.vertices[0], params::geodesic_solver(CGAL::Graph_geodesic_solver()))),
            2u);
}

} // namespace

} // namespace test_graph_geodesic_solver
