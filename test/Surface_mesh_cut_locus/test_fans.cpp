// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Flat faces with many corners, as the ends of cylinders are, come as hundreds of slim triangles, each of which windows
// from all around the rim cross. How they are triangulated is nothing to the surface.

#include "surface_test.h"
#include "detour.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>

namespace test_fans {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::internal::Exact_tree_solver;

std::vector<std::unique_ptr<Built>> cylinders(std::size_t n)
{
  std::vector<std::unique_ptr<Built>> result;
  for(Flat_face caps : {Flat_face::STAR, Flat_face::FAN, Flat_face::ZIGZAG})
    result.emplace_back(new Built(test_meshes::closed_cylinder(n, 3., caps)));
  return result;
}

TEST(Fans, distances_do_not_depend_on_how_flat_faces_are_triangulated)
{
  const std::size_t n = 400;
  const auto built = cylinders(n);
  for(const std::size_t source : {std::size_t(0), std::size_t(7), n + n / 3})
  {
    CGAL::Surface_mesh_exact_geodesics<Mesh> expected(built[0]->mesh);
    expected.compute(built[0]->vertices[source]);
    for(std::size_t i : {1, 2})
    {
      CGAL::Surface_mesh_exact_geodesics<Mesh> found(built[i]->mesh);
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
      CGAL::Surface_mesh_cut_locus<Mesh> solver(built->mesh, params::cut_locus_method(method));
      solver.set_source(built->vertices[7]);
      const curve_measures::Measures measures = curve_measures::measure(
        built->mesh, solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES)));
      EXPECT_EQ(measures.topology_fault, "");
      EXPECT_LT(measures.max, 1e-9);
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
      const Indexed_triangle_mesh mesh = test_meshes::indexed(test_meshes::closed_cylinder(n, 3., caps));
      Exact_tree_solver all(mesh), run(mesh);
      Indexed_source source;
      source.vertex = v;
      source.location = CGAL::Cut_loci::internal::location_of_vertex(run.connectivity(), v);
      run.expect(run.default_thresholds());
      for(Exact_tree_solver* solver : {&all, &run})
      {
        solver->compute_distance(source);
        solver->compute_strengths();
        solver->grow_tree();
        solver->close_cycles();
      }
      const auto faces = CGAL::Cut_loci::Curve::THROUGH_FACES;
      const double expected = length(mesh, all.filter(run.default_thresholds(), faces)),
                   found = length(mesh, run.filter(run.default_thresholds(), faces));
      EXPECT_GT(found, 1.);
      EXPECT_NEAR(found, expected, 1e-4); // to see all of it, a symmetric source is moved
    }
}

} // namespace

} // namespace test_fans
