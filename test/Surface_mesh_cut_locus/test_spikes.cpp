// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Spikes, however long: straight lines wind around them, as often as they are longer than wide, but the work does not
// grow with that.

#include "surface_test.h"

#include <CGAL/Heat_method_geodesic_solver.h>

namespace test_spikes {

namespace {

using namespace surface_test;

Mesh_data sphere_with_outlier(double height)
{
  Mesh_data m = jittered_sphere(22, 0.2, 3);
  for(double& x : m.points[m.points.size() / 2])
    x *= height;
  return m;
}

std::size_t number_of_windows(const Mesh_data& data, std::size_t source)
{
  const Built built(data);
  Geodesics geodesics(built.mesh);
  geodesics.compute(built.vertices[source]);
  return geodesics.number_of_windows();
}

TEST(Spikes, of_an_octahedron_take_no_more_windows_the_longer_they_are)
{
  for(const std::size_t source : {0, 5})
  {
    const std::size_t clean = number_of_windows(octahedron(1.), source);
    for(int k = 1; k <= 12; ++k)
      EXPECT_LE(number_of_windows(octahedron(std::pow(10., k)), source), 5 * clean) << k;
  }
}

TEST(Spikes, at_one_vertex_of_a_fine_mesh_take_no_more_windows_the_longer_they_are)
{
  const std::size_t clean = number_of_windows(sphere_with_outlier(1.), 5);
  for(int k = 1; k <= 10; ++k)
    EXPECT_LE(number_of_windows(sphere_with_outlier(std::pow(10., k)), 5), 5 * clean / 4) << k;
}

// The shortest paths between other vertices do not go up there.
TEST(Spikes, have_the_right_distances)
{
  const Built blunt(octahedron(1.));
  Geodesics expected(blunt.mesh);
  expected.compute(blunt.vertices[5]);
  for(int k = 0; k <= 12; ++k)
  {
    const double height = std::pow(10., k);
    const Built built(octahedron(height));
    Geodesics geodesics(built.mesh);
    geodesics.compute(built.vertices[5]);
    for(const std::size_t v : {0, 1, 2, 3, 5})
      EXPECT_NEAR(geodesics.distance(built.vertices[v]), expected.distance(blunt.vertices[v]), 1e-14);
    // across the middle of an edge of the base: the heights of two faces
    EXPECT_NEAR(geodesics.distance(built.vertices[4]), std::sqrt(1.5) + std::hypot(height, std::sqrt(0.5)),
                1e-15 * height + 1e-14);
  }
}

TEST(Spikes, have_cut_loci)
{
  for(int k = 0; k <= 12; ++k)
    for(const std::size_t source : {0, 5})
    {
      const Built built(octahedron(std::pow(10., k)));
      const auto found = compute_cut_locus(built.mesh, built.vertices[source], mesh_edges);
      EXPECT_EQ(fault_of(built, found, source == 0 ? 0 : 4, {source}, Default_method()), "") << k;
      const auto full = compute_cut_locus(built.mesh, built.vertices[source], by(Polyhedral_method()));
      EXPECT_EQ(num_vertices(full.graph()), num_edges(full.graph()) + 1) << k;
    }
}

// Rounding makes both diagonals of the faces of this spike look wrong: the heat method would flip them for ever.
TEST(Spikes, for_which_the_heat_method_does_not_end_are_refused)
{
  Mesh_data m = cube(2);
  for(double& x : m.points[m.triangles[7][0]])
    x *= 1e8;
  const Built built(m);
  const auto heat = params::geodesic_solver(CGAL::Heat_method_geodesic_solver<>());
  expect_words([&] { compute_cut_locus(built.mesh, built.vertices[m.triangles[20][0]], heat); },
               {"Intrinsic_Delaunay does not end"});
}

} // namespace

} // namespace test_spikes
