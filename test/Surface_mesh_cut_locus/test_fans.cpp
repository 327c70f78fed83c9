// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Flat faces with many corners, as the ends of cylinders are, come as hundreds of slim triangles, each of which windows
// from all around the rim cross. How they are triangulated is nothing to the surface.

#include "surface_test.h"
#include "default_results.h"

namespace test_fans {

namespace {

using namespace surface_test;
using namespace default_test;

std::vector<std::unique_ptr<Built>> cylinders(std::size_t n)
{
  std::vector<std::unique_ptr<Built>> result;
  for(Flat_face caps : {Flat_face::STAR, Flat_face::FAN, Flat_face::ZIGZAG})
    result.emplace_back(new Built(closed_cylinder(n, 3., caps)));
  return result;
}

TEST(Fans, distances_do_not_depend_on_how_flat_faces_are_triangulated)
{
  const std::size_t n = 400;
  const auto built = cylinders(n);
  for(const std::size_t source : {std::size_t(0), std::size_t(7), n + n / 3})
  {
    Geodesics expected(built[0]->mesh);
    expected.compute(built[0]->vertices[source]);
    for(std::size_t i : {1, 2})
    {
      Geodesics found(built[i]->mesh);
      found.compute(built[i]->vertices[source]);
      for(std::size_t v = 0; v < 2 * n; ++v)
        EXPECT_NEAR(found.distance(built[i]->vertices[v]), expected.distance(built[0]->vertices[v]), 1e-10);
    }
  }
}

TEST(Fans, no_shortest_path_crosses_the_cut_locus)
{
  for(const auto& built : cylinders(150))
    for(Method method : {Method(Default_method()), Method(Polyhedral_method()), Method(Laplacian_method())})
    {
      Solver solver(built->mesh, by(method));
      solver.set_source(built->vertices[7]);
      EXPECT_LT(checked_curves::measured(built->mesh, solver.cut_locus(through_faces)).max, 1e-9);
    }
}

// By default weak cells are cut off in each face before anything is drawn.
TEST(Fans, the_default_is_what_is_strong_of_all_of_the_cut_locus)
{
  const std::size_t n = 90;
  for(Flat_face caps : {Flat_face::STAR, Flat_face::FAN, Flat_face::ZIGZAG})
    for(Index v : {Index(0), Index(7), Index(n + n / 3)})
    {
      SCOPED_TRACE(v);
      const Indexed_triangle_mesh mesh = indexed(closed_cylinder(n, 3., caps));
      const Solved all(mesh, at_vertex(mesh, v), Branch_strength()), run(mesh, at_vertex(mesh, v));
      const double expected = length(mesh, all.through_faces()), found = length(mesh, run.through_faces());
      EXPECT_GT(found, 1.);
      EXPECT_NEAR(found, expected, 1e-4); // to see all of it, a symmetric surface is perturbed
    }
}

} // namespace

} // namespace test_fans
