// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Cut_loci/laplacian/Branch_tips.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/exact_geodesic_distances.h>
#include <CGAL/property_map.h>

namespace test_branch_tips {

// Where the branches of the method of the Laplacian end.

namespace {

using namespace surface_test;
// A spheroid with equator 1 and poles at 0.5, and its vertex 0 at (1, 0, 0). The equator is a geodesic with the curvature
// 1 / 0.5^2 along it: its points conjugate to that vertex are at the angle 0.5 pi to either side, and the cut locus is the
// arc between them.
const double height = 0.5;

Mesh_data spheroid(std::size_t n, double noise)
{
  Mesh_data m = jittered_sphere(n, 0.15, 3);
  // turned by what takes vertex 0 to the equator
  const Point a = m.points[0], d = a - Point{{1., 0., 0.}};
  for(Point& p : m.points)
    p = p - (2. * dot(p, d) / dot(d, d)) * d;
  for(Triangle& t : m.triangles)
    std::swap(t[1], t[2]); // it was a reflection
  for(Point& p : m.points)
    p[2] *= height;
  std::mt19937 engine(5);
  const double amount = noise * mean_edge_length(m);
  for(std::size_t v = 1; v < m.points.size(); ++v)
    m.points[v] = m.points[v] + amount * random_unit(engine) * normalized(m.points[v]);
  return m;
}

std::vector<Point> true_tips()
{
  return {{{std::cos(height * pi), std::sin(height * pi), 0.}}, {{std::cos(height * pi), -std::sin(height * pi), 0.}}};
}

std::vector<Point> leaves(const Cut_locus& cut_locus)
{
  std::vector<Point> result;
  const auto& g = cut_locus.graph();
  for(auto v : CGAL::make_range(vertices(g)))
    if(degree(v, g) == 1)
      result.push_back({{g[v].point.x(), g[v].point.y(), g[v].point.z()}});
  return result;
}

// the largest distance of one of `from` to the nearest of `to`
double distance_to_nearest(const std::vector<Point>& from, const std::vector<Point>& to)
{
  double result = 0.;
  for(const Point& p : from)
  {
    double least = 1e300;
    for(const Point& q : to)
      least = (std::min)(least, norm(p - q));
    result = (std::max)(result, least);
  }
  return result;
}

std::set<std::pair<std::size_t, std::size_t>> edges_of(const Built& built, const Cut_locus& cut_locus)
{
  std::set<std::pair<std::size_t, std::size_t>> result;
  const auto& g = cut_locus.graph();
  for(auto e : CGAL::make_range(edges(g)))
    result.insert(std::minmax(built.index(g[source(e, g)].mesh_vertex), built.index(g[target(e, g)].mesh_vertex)));
  return result;
}

} // namespace

// Where the angle of 0.7 ends the branches, 6.0 h are missing at n = 40, and 12 h at 80.
template <typename Geodesic_solver>
void expect_conjugate_points(const Geodesic_solver& geodesics, double bound)
{
  for(std::size_t n : {20, 40, 80})
  {
    const Built built(spheroid(n, 0.));
    const double h = mean_edge_length(built.data);
    Solver solver(built.mesh, by(Laplacian_method()).geodesic_solver(geodesics));
    solver.set_source(built.vertices[0]);
    for(const auto curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      const std::vector<Point> found = leaves(solver.cut_locus(params::cut_locus_curve(curve)));
      EXPECT_EQ(found.size(), 2u) << n;
      EXPECT_LT(distance_to_nearest(true_tips(), found), bound * h) << n;
    }
  }
}

TEST(Branch_tips, are_the_conjugate_points_at_all_resolutions)
{
  expect_conjugate_points(CGAL::Exact_geodesic_solver(), 3.); // measured: 2.3 at most
}

// As ways tell the distances: by those of heat themselves, there are 4 leaves at n = 40.
TEST(Branch_tips, are_as_many_with_approximate_distances)
{
  expect_conjugate_points(CGAL::Heat_method_geodesic_solver<>(), 10.); // measured: 9.3 at most
  expect_conjugate_points(CGAL::Graph_geodesic_solver(), 10.);         // the same
}

// Noise has paths meet anywhere beyond the tips.
TEST(Branch_tips, are_not_passed_because_of_noise)
{
  for(double noise : {0.03, 0.1, 0.3})
    for(std::size_t n : {20, 40, 80})
    {
      const Built built(spheroid(n, noise));
      const double h = mean_edge_length(built.data);
      Solver solver(built.mesh, by(Laplacian_method()));
      solver.set_source(built.vertices[0]);
      for(const Point& p : leaves(solver.cut_locus(mesh_edges)))
        EXPECT_LT(p[0], 3. * h) << noise << ", " << n; // measured: -0.9 h at most
    }
}

// A double pyramid with the source at one apex: only the other one is no neighbor of it, and tells the noise.
TEST(Branch_tips, have_the_noise_of_what_is_no_neighbor_of_the_source)
{
  const Index n = 12;
  Mesh_data pyramids;
  pyramids.points = {{{0., 0., -1.}}, {{0., 0., 1.}}};
  for(Index i = 0; i < n; ++i)
  {
    pyramids.points.push_back({{std::cos(2. * pi * i / n), std::sin(2. * pi * i / n), 0.}});
    const Index here = 2 + i, next = 2 + (i + 1) % n;
    pyramids.triangles.push_back({{next, here, 0}});
    pyramids.triangles.push_back({{here, next, 1}});
  }
  const Mesh_connectivity connectivity(indexed(pyramids));
  std::vector<float> laplacian(n + 2, 0.1f);
  laplacian[0] = (std::numeric_limits<float>::max)();
  laplacian[1] = 0.3f;
  EXPECT_NEAR(CGAL::Cut_loci::internal::Branch_tips::noise_of(connectivity, laplacian), 3. * 0.2 * n / (n + 1), 1e-6);
  laplacian[1] = laplacian[0]; // two sources, and nothing that tells
  EXPECT_EQ(CGAL::Cut_loci::internal::Branch_tips::noise_of(connectivity, laplacian), 0.f);
}

// So do errors that vary slowly, as those of the heat method. If only noise is looked for, tips are passed by up to 18 h.
TEST(Branch_tips, are_not_passed_because_of_smooth_errors)
{
  const Built built(spheroid(80, 0.));
  const double h = mean_edge_length(built.data);
  std::vector<double> exact(built.data.points.size()), distance(exact.size());
  CGAL::exact_geodesic_distances(built.mesh, built.vertices[0], CGAL::make_property_map(exact));
  for(bool is_along_paths : {true, false})
    for(double frequency : {3., 6., 12.})
      for(double phase : {0., 1.6, 3.1})
      {
        for(std::size_t v = 0; v < exact.size(); ++v)
        {
          const double at = is_along_paths ? exact[v] : built.data.points[v][1];
          distance[v] = exact[v] * (1. + 0.05 * std::sin(frequency * at + phase));
        }
        Solver solver(built.mesh, by(Laplacian_method()));
        solver.set_source(built.vertices[0], params::vertex_distance_map(CGAL::make_property_map(distance)));
        for(const Point& p : leaves(solver.cut_locus(mesh_edges)))
          EXPECT_LT(p[0], 3. * h) << is_along_paths << ", " << frequency << ", " << phase; // measured: -1.0 h at most
      }
}

// The way from a strong place to a tip does not depend on how much stronger it is.
TEST(Branch_tips, of_a_higher_threshold_are_on_the_curve_of_a_lower_one)
{
  for(const Mesh_data& data :
      {rough(bumpy_sphere(20, 0.5, 1), 0.1, 1), torus(1., 0.4, 50, 20, 0.15, 7), spheroid(14, 0.1)})
  {
    const Built built(data);
    Solver solver(built.mesh, by(Laplacian_method()));
    solver.set_source(built.vertices[0]);
    std::set<std::pair<std::size_t, std::size_t>> lower;
    for(double angle : {0.1, 0.3, 0.5, 0.7, 1., 1.5, 2.})
    {
      const auto edges =
        edges_of(built, solver.cut_locus(mesh_edges.cut_locus_method(
                          Laplacian_method().gradient_angle_threshold(angle).minimum_branch_edges(0))));
      EXPECT_TRUE(angle == 0.1 || std::includes(lower.begin(), lower.end(), edges.begin(), edges.end())) << angle;
      lower = edges;
    }
  }
}

// Nor are they where more than the default is asked for.
TEST(Branch_tips, are_not_looked_for_when_growing)
{
  const Built built(spheroid(40, 0.));
  Solver solver(built.mesh, by(Laplacian_method()));
  solver.set_source(built.vertices[0]);
  const auto pruned = edges_of(built, solver.cut_locus(mesh_edges));
  for(const auto& less :
      {solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().filter_policy(Filter_policy::GROWING))),
       solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(0.71)))})
  {
    const auto edges = edges_of(built, less);
    EXPECT_LT(edges.size() + 4, pruned.size());
    EXPECT_TRUE(std::includes(pruned.begin(), pruned.end(), edges.begin(), edges.end()));
  }
}

} // namespace test_branch_tips
