// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Exact geodesics against CGAL's Surface_mesh_shortest_path, on random meshes on which both are exact.

#include "exact_geodesics_test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace test_exact_geodesics_fuzz {

namespace {

using namespace test_meshes;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface_mesh>>;

constexpr double relative = 1e-9;

/// expects of a point that has been looked for what is known of it since it was named before the run
void expect_found(const Geodesics& geodesics, const Mesh& mesh, std::size_t q, Path_tracing& tracing)
{
  const Indexed_location& named = geodesics.answer(q).location;
  const Found_point found = Point_search(geodesics)(named);
  const double d = geodesics.query_distance(q);
  EXPECT_LT(distance(point(mesh, found.location), point(mesh, named)), 1e-12);
  EXPECT_NEAR(found.distance, d, relative * d);
  EXPECT_EQ(geodesics.nearest_source(found), geodesics.nearest_source(geodesics.answer(q)));
  if(d == 0.)
    return;
  const double full = geodesics.source_angle(geodesics.nearest_source(found)),
               turn =
                 std::fabs(geodesics.direction_at_source(found) - geodesics.direction_at_source(geodesics.answer(q)));
  EXPECT_LT((std::min)(turn, full - turn), relative);
  EXPECT_EQ(defect_of_path(geodesics, mesh, tracing.path_from_query(found), point(mesh, named), d), "");
}

/// expects the distances of CGAL at all vertices and at some points in faces, and correct paths
void expect_agreement(const Mesh& mesh, std::size_t number_of_sources, unsigned seed)
{
  Surface_mesh surface;
  for(const Point& p : mesh.points)
    surface.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const Mesh::Triangle& t : mesh.triangles)
    ASSERT_NE(surface.add_face(Surface_mesh::Vertex_index(t[0]), Surface_mesh::Vertex_index(t[1]),
                               Surface_mesh::Vertex_index(t[2])),
              Surface_mesh::null_face());
  // barycentric coordinates in CGAL's order
  const auto to_cgal = [&](const Indexed_location& l)
  {
    const Surface_mesh::Face_index f(l.face);
    const Surface_mesh::Halfedge_index h = surface.halfedge(f);
    std::array<double, 3> sorted = {{0., 0., 0.}};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Surface_mesh::Vertex_index v(mesh.triangles[l.face][i]);
      if(v == surface.source(h))
        sorted[0] = l.coordinates[i];
      else if(v == surface.target(h))
        sorted[1] = l.coordinates[i];
      else
        sorted[2] = l.coordinates[i];
    }
    return Shortest_path::Face_location(f, {{sorted[0], sorted[1], sorted[2]}});
  };
  std::mt19937 random(seed);
  Options options;
  options.directions = true;
  for(unsigned k = 0; k < 20; ++k)
    options.queries.push_back(random_location(mesh, random, 0));
  std::vector<Indexed_location> sources;
  for(unsigned k = 0; k < number_of_sources; ++k)
    sources.push_back(random_location(mesh, random, (seed + k) % 2 ? 0 : 2));
  Geodesics geodesics(mesh);
  geodesics.run(sources, options);
  Path_tracing tracing(geodesics);
  // one source at a time: CGAL 5.5 overestimates distances from several points of one face, and from points on edges
  std::vector<std::unique_ptr<Shortest_path>> shortest_paths;
  for(const Indexed_location& source : sources)
  {
    shortest_paths.emplace_back(new Shortest_path(surface));
    shortest_paths.back()->add_source_point(to_cgal(source));
  }
  const auto cgal_distance = [&](const auto&... target)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for(const std::unique_ptr<Shortest_path>& shortest_path : shortest_paths)
    {
      const double d = shortest_path->shortest_distance_to_source_points(target...).first;
      nearest = d < 0. ? nearest : (std::min)(nearest, d);
    }
    return nearest;
  };
  double scale = 0.;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const double expected = cgal_distance(Surface_mesh::Vertex_index(v));
    if(expected == std::numeric_limits<double>::infinity())
    {
      EXPECT_FALSE(geodesics.is_reached(v)) << "vertex " << v;
      continue;
    }
    EXPECT_NEAR(geodesics.distance(v), expected, relative * expected + 1e-14) << "vertex " << v;
    scale = (std::max)(scale, expected);
    if(v % 7 == 0)
    {
      EXPECT_EQ(defect_of_path(geodesics, mesh, tracing.path_from_query(geodesics.at_vertex(v)), mesh.points[v],
                               geodesics.distance(v)),
                "")
        << "vertex " << v;
    }
  }
  for(std::size_t q = 0; q < options.queries.size(); ++q)
  {
    const Shortest_path::Face_location target = to_cgal(options.queries[q]);
    const double expected = cgal_distance(target.first, target.second);
    if(expected == std::numeric_limits<double>::infinity())
    {
      EXPECT_EQ(geodesics.query_distance(q), std::numeric_limits<double>::infinity());
      EXPECT_EQ(Point_search(geodesics)(options.queries[q]).distance, std::numeric_limits<double>::infinity());
    }
    else
    {
      EXPECT_NEAR(geodesics.query_distance(q), expected, relative * expected + 1e-14 * scale) << "query " << q;
      SCOPED_TRACE("query " + std::to_string(q));
      expect_found(geodesics, mesh, q, tracing);
    }
  }
}

TEST(Fuzz, tiny)
{
  for(unsigned seed = 1; seed <= 400; ++seed)
    for(const double height : {0.1, 1., 3.})
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + " height " + std::to_string(height));
      expect_agreement(bumpy_grid(1 + seed % 5, 1 + seed / 5 % 4, height, seed, 0.15), 1 + seed % 13 / 12, seed);
    }
}

TEST(Fuzz, random_meshes)
{
  for(unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_agreement(jittered_grid(8 + seed % 9, 6 + seed % 11, seed), 1 + seed % 3, seed);
    if(seed <= 50)
      expect_agreement(perforated_grid(9 + seed % 9, 8 + seed % 7, seed), 1 + seed % 2, seed);
    if(seed <= 40)
      expect_agreement(needle_grid(6 + seed % 7, 6 + seed % 5, seed), 1, seed);
    if(seed <= 40)
      expect_agreement(welded_grids(6 + seed % 7, 6 + seed % 6, seed), 1 + seed % 3, seed);
    if(seed <= 30)
      expect_agreement(jittered_torus(12 + seed % 13, 6 + seed % 7, seed), 1 + seed % 2, seed);
  }
}

TEST(Fuzz, larger_torus)
{
  expect_agreement(torus(70, 35, 0.25, 5), 1, 5);
  expect_agreement(torus(70, 35, 0., 6), 2, 6);
}

} // namespace

} // namespace test_exact_geodesics_fuzz
