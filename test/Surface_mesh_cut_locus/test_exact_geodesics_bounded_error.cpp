// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Geodesic distances with a maximum relative error, without directions and with them, against the exact ones.

#include "exact_geodesics_test_meshes.h"

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <gtest/gtest.h>

#include <limits>

namespace test_exact_geodesics_bounded_error {

namespace {

using namespace test_meshes;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;

void expect_bound(double distance, double error, double exact, double maximum_relative_error, double scale)
{
  if(exact == infinity)
  {
    EXPECT_EQ(distance, infinity);
    return;
  }
  EXPECT_GE(distance, exact * (1. - rounding) - 1e-15 * scale);
  EXPECT_LE(distance, exact * (1. + maximum_relative_error + rounding) + 1e-15 * scale);
  EXPECT_LE(distance - error, exact * (1. + rounding) + 1e-15 * scale);
}

/// expects the bounds at all vertices, at points in faces, on edges and at vertices, and at all centroids
void expect_bounds(const Mesh& mesh, std::size_t number_of_sources, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Indexed_location> sources;
  for(unsigned k = 0; k < number_of_sources; ++k)
    sources.push_back(random_location(mesh, random, seed + k));
  Options options;
  options.queries = centroids(mesh);
  for(unsigned k = 0; k < 30; ++k)
    options.queries.push_back(random_location(mesh, random, k));
  Geodesics geodesics(mesh), exact(mesh);
  exact.run(sources, options);
  double scale = 0.;
  for(double d : exact.distances())
    scale = d < infinity ? (std::max)(scale, d) : scale;
  for(const double error : {0.3, 0.01, 1e-4})
  {
    SCOPED_TRACE("maximum relative error " + std::to_string(error));
    options.maximum_relative_error = error;
    geodesics.run(sources, options);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      expect_bound(geodesics.distance(v), geodesics.distance_error(v), exact.distance(v), error, scale);
    for(std::size_t q = 0; q < exact.number_of_queries(); ++q)
      expect_bound(geodesics.query_distance(q), infinity, exact.query_distance(q), error, scale);
    for(std::size_t q = 0; q < options.queries.size(); ++q)
      expect_bound(Point_search(geodesics)(options.queries[q]).distance, infinity, exact.query_distance(q), error,
                   scale);
  }
}

TEST(Bounded_error, holds_on_random_meshes)
{
  for(unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_bounds(jittered_grid(4 + seed % 30, 6 + seed % 31, seed), 1 + seed % 2, seed);
    expect_bounds(needle_grid(6 + seed % 17, 6 + seed % 15, seed), 1, seed);
    expect_bounds(perforated_grid(9 + seed % 19, 8 + seed % 17, seed), 1 + seed % 3, seed);
    if(seed > 40)
      continue;
    expect_bounds(jittered_torus(12 + seed % 43, 6 + seed % 27, seed), 1 + seed % 2, seed);
    expect_bounds(welded_grids(6 + seed % 17, 6 + seed % 16, seed), 1 + seed % 3, seed);
    if(seed > 30)
      continue;
    expect_bounds(flat_grid(5 + seed % 20, 7 + seed % 13, seed, 0.3 * (seed % 2)), 1, seed);
    expect_bounds(subdivided(bumpy_grid(5 + seed % 9, 4 + seed % 7, 0.3 * (seed % 4), seed, 0.1)), 1, seed);
  }
}

/// That is the bound, in this direction: a distance is that to an image, which merging brings nearer.
void expect_bounds_with_directions(const Mesh& mesh, std::size_t number_of_sources, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Indexed_location> sources;
  for(unsigned k = 0; k < number_of_sources; ++k)
    sources.push_back(random_location(mesh, random, seed + k));
  Options options;
  options.directions = true;
  options.queries = centroids(mesh);
  Geodesics geodesics(mesh), exact(mesh);
  exact.run(sources, options);
  for(const double error : {0.1, 0.01, 1e-4})
    for(const double angle : {0.1, 0.001})
    {
      SCOPED_TRACE("maximum relative error " + std::to_string(error) + ", merging angle " + std::to_string(angle));
      options.maximum_relative_error = error;
      options.merging_angle = angle;
      geodesics.run(sources, options);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      {
        ASSERT_EQ(geodesics.is_reached(v), exact.is_reached(v));
        if(!exact.is_reached(v))
          continue;
        const double d = exact.distance(v), slack = rounding * (d + 1.);
        EXPECT_LE(geodesics.distance(v), d + slack);
        EXPECT_GE(geodesics.distance(v) + geodesics.distance_error(v), d - slack);
        EXPECT_LE(geodesics.distance_error(v), error * d + slack);
      }
      for(std::size_t q = 0; q < exact.number_of_queries(); ++q)
      {
        EXPECT_LE(geodesics.query_distance(q), exact.query_distance(q) * (1. + rounding) + rounding);
        EXPECT_GE(geodesics.query_distance(q), exact.query_distance(q) * (1. - error - rounding) - rounding);
      }
    }
}

TEST(Bounded_error_with_directions, distances_on_random_meshes)
{
  for(unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_bounds_with_directions(jittered_grid(4 + seed % 20, 6 + seed % 21, seed), 1 + seed % 2, seed);
    expect_bounds_with_directions(jittered_torus(12 + seed % 33, 6 + seed % 21, seed), 1 + seed % 2, seed);
    expect_bounds_with_directions(perforated_grid(9 + seed % 19, 8 + seed % 17, seed), 1 + seed % 3, seed);
    expect_bounds_with_directions(needle_grid(6 + seed % 17, 6 + seed % 15, seed), 1, seed);
  }
}

/// the share of the vertices whose direction at the source is off by more than an angle, far from the cut locus or not
double share_of_wrong_directions(const Mesh& mesh, double error, double angle)
{
  Options options;
  options.directions = true;
  Geodesics geodesics(mesh), exact(mesh);
  exact.run(Index(0), options);
  options.maximum_relative_error = error;
  options.merging_angle = 0.01;
  geodesics.run(Index(0), options);
  std::size_t wrong = 0;
  for(Index v = 1; v < mesh.number_of_vertices(); ++v)
  {
    const double difference = std::fabs(geodesics.direction_at_source(v) - exact.direction_at_source(v));
    wrong += (std::min)(difference, exact.source_angle() - difference) > angle;
  }
  return double(wrong) / double(mesh.number_of_vertices());
}

TEST(Bounded_error_with_directions, directions_become_accurate)
{
  for(unsigned seed = 1; seed <= 4; ++seed)
  {
    const Mesh mesh = test_meshes::torus(120, 60, 0.2, seed);
    EXPECT_LT(share_of_wrong_directions(mesh, 1e-3, 0.02), 0.02);
    EXPECT_LT(share_of_wrong_directions(mesh, 1e-5, 0.005), 0.02);
    EXPECT_LT(share_of_wrong_directions(mesh, 1e-5, 0.001), share_of_wrong_directions(mesh, 1e-3, 0.001));
  }
}

/// the number of windows for each halfedge of a torus with 4 n^2 faces
double windows_per_halfedge(Index n, double error)
{
  const Mesh mesh = torus(2 * n, n, 0.2, 1);
  Geodesics geodesics(mesh);
  Options options;
  options.maximum_relative_error = error;
  geodesics.run(Index(0), options);
  return double(geodesics.number_of_windows()) / mesh.number_of_halfedges();
}

TEST(Bounded_error, windows_per_halfedge_do_not_become_more)
{
  EXPECT_LT(windows_per_halfedge(120, 0.01), windows_per_halfedge(30, 0.01));
  EXPECT_GT(windows_per_halfedge(120, 0.), 2. * windows_per_halfedge(30, 0.));
}

TEST(Bounded_error, maximum_distance)
{
  const Mesh mesh = torus(60, 30, 0.2, 3);
  Geodesics exact(mesh), geodesics(mesh);
  Options options;
  exact.run(Index(0), options);
  options.maximum_distance = 0.8;
  options.maximum_relative_error = 0.05;
  geodesics.run(Index(0), options);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(exact.distance(v) <= options.maximum_distance)
    {
      EXPECT_TRUE(geodesics.is_reached(v));
    }
    if(geodesics.is_reached(v))
    {
      EXPECT_LE(exact.distance(v), geodesics.distance(v) * (1. + rounding));
      EXPECT_LE(geodesics.distance(v), exact.distance(v) * (1.05 + rounding));
    }
  }
}

TEST(Bounded_error, is_gone_in_the_next_run)
{
  const Mesh mesh = torus(40, 20, 0.2, 3);
  Geodesics exact(mesh), geodesics(mesh);
  Options options;
  exact.run(Index(0), options);
  options.maximum_relative_error = 0.1;
  geodesics.run(Index(0), options);
  EXPECT_NE(geodesics.distances(), exact.distances());
  geodesics.run(Index(0));
  EXPECT_EQ(geodesics.distances(), exact.distances());
  EXPECT_EQ(geodesics.distance_error(5), 0.);
}

TEST(Bounded_error, has_no_directions_and_paths)
{
  using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using CGAL::Cut_loci::Invalid_input;
  Surface_mesh mesh;
  for(const Point& p : {Point{{0., 0., 0.}}, Point{{1., 0., 0.}}, Point{{0., 1., 0.}}, Point{{0., 0., 1.}}})
    mesh.add_vertex({p[0], p[1], p[2]});
  using Vertex = Surface_mesh::Vertex_index;
  for(const std::array<Index, 3>& t : {std::array<Index, 3>{{0, 2, 1}}, std::array<Index, 3>{{0, 1, 3}},
                                       std::array<Index, 3>{{1, 2, 3}}, std::array<Index, 3>{{2, 0, 3}}})
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  CGAL::Surface_mesh_exact_geodesics<Surface_mesh> geodesics(mesh);
  for(double bad : {-1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(geodesics.set_maximum_distance(bad), Invalid_input);
  geodesics.set_maximum_relative_error(0.);
  geodesics.compute(*vertices(mesh).begin());
  const std::size_t exact = geodesics.number_of_windows();
  // however large the error, it ends, and takes no longer than without
  for(double error : {0.1, 1., 1e15, std::numeric_limits<double>::infinity()})
  {
    geodesics.set_maximum_relative_error(error);
    geodesics.compute(*vertices(mesh).begin());
    EXPECT_LE(geodesics.number_of_windows(), exact) << error;
  }
  EXPECT_THROW(geodesics.set_maximum_relative_error(-0.1), Invalid_input);
  EXPECT_THROW(geodesics.set_maximum_relative_error(std::numeric_limits<double>::quiet_NaN()), Invalid_input);
  geodesics.set_maximum_relative_error(0.1);
  geodesics.compute(Vertex(0));
  EXPECT_NEAR(geodesics.distance(Vertex(1)), 1., rounding);
  EXPECT_GE(geodesics.distance_error(Vertex(1)), 0.);
  std::vector<CGAL::Surface_mesh_exact_geodesics<Surface_mesh>::Face_location> path;
  EXPECT_THROW(geodesics.shortest_path(Vertex(1), std::back_inserter(path)), Invalid_input);
  EXPECT_THROW(geodesics.arrival_direction(Vertex(1)), Invalid_input);
  EXPECT_THROW(geodesics.direction_at_source(Vertex(1)), Invalid_input);
  geodesics.set_directions(true);
  EXPECT_THROW(geodesics.compute(Vertex(0)), Invalid_input);
  geodesics.set_maximum_relative_error(0.);
  geodesics.compute(Vertex(0));
  EXPECT_EQ(geodesics.distance(Vertex(1)), 1.);
  geodesics.shortest_path(Vertex(1), std::back_inserter(path));
  EXPECT_EQ(path.size(), 2u);
}

} // namespace

} // namespace test_exact_geodesics_bounded_error
