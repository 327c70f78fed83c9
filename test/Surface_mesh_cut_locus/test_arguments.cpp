// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What no call can mean is refused, and what means the same has the same result.

#include "surface_test.h"

namespace test_arguments {

namespace {

using namespace surface_test;

const double no_number = std::numeric_limits<double>::quiet_NaN();

TEST(Arguments, thresholds_beyond_all_branches_are_refused)
{
  const Built built(jittered_sphere(2, 0.2, 1));
  Solver laplacian(built.mesh, by(Laplacian_method())), direction(built.mesh);
  laplacian.set_source(built.vertices[0]);
  direction.set_source(built.vertices[0]);
  for(double angle : {9., 1e300, -1., no_number})
    expect_refused([&] { laplacian.cut_locus(by(Laplacian_method().gradient_angle_threshold(angle))); },
                   Cause::INVALID_PARAMETER);
  for(double width : {5., 1e300, -1., no_number})
    expect_refused([&] { direction.cut_locus(by(Default_method().minimum_branch_width(width))); },
                   Cause::INVALID_PARAMETER);
  for(double gap : {9., no_number})
    expect_refused([&] { direction.cut_locus(by(Default_method().minimum_branch_gap(gap))); },
                   Cause::INVALID_PARAMETER);
  const Solver::Face_location inside(*built.mesh.faces_begin(), {{0.2, 0.3, 0.5}});
  for(double tolerance : {-1., 1., no_number})
    expect_refused([&] { direction.set_source(inside, params::snapping_tolerance(tolerance)); },
                   Cause::INVALID_PARAMETER);
}

TEST(Arguments, the_default_width_can_be_asked_for)
{
  for(const Mesh_data& data : {jittered_sphere(2, 0.2, 1), jittered_sphere(1, 0.3, 1), jittered_sphere(3, 0.3, 2)})
  {
    const Built built(data);
    Solver solver(built.mesh);
    solver.set_source(built.vertices[0]);
    EXPECT_LE(solver.minimum_branch_width(), 1.);
    EXPECT_NO_THROW(solver.cut_locus(by(Default_method().minimum_branch_width(solver.minimum_branch_width()))));
  }
}

TEST(Arguments, barycentric_coordinates_need_not_sum_up_to_one)
{
  const Built built(jittered_sphere(3, 0.2, 1));
  const auto face = *(built.mesh.faces_begin() + 5);
  for(double scale : {1e-12, 1e12})
  {
    const auto radius = [&](double by)
    {
      Solver solver(built.mesh);
      solver.set_source(std::make_pair(face, std::array<double, 3>{{0.2 * by, 0.3 * by, 0.5 * by}}));
      return solver.cut_locus().distance(built.vertices[0]);
    };
    EXPECT_NEAR(radius(scale), radius(1.), 1e-12) << scale;
  }
}

TEST(Arguments, a_map_of_one_distance_is_refused)
{
  const Built built(jittered_sphere(2, 0.2, 1));
  for(double same : {0., 1.})
  {
    const CGAL::Constant_property_map<Mesh::Vertex_index, double> map(same);
    expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0], params::vertex_distance_map(map)); },
                   Cause::INVALID_DISTANCE);
  }
}

TEST(Arguments, exact_geodesics_have_no_answers_before_they_are_computed)
{
  const Built built(jittered_sphere(2, 0.2, 1));
  const auto face = *built.mesh.faces_begin();
  const Mesh::Vertex_index v = built.vertices[3];
  Geodesics geodesics(built.mesh);
  std::vector<Geodesics::Face_location> path;
  expect_refused([&] { geodesics.distance(v); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.distance_error(v); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.nearest_source(v); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.direction_at_source(v); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.arrival_direction(v); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.source_angle(); }, Cause::NO_SOURCE);
  expect_refused([&] { geodesics.shortest_path(v, std::back_inserter(path)); }, Cause::NO_SOURCE);
  geodesics.compute(built.vertices[0]);
  EXPECT_GT(geodesics.distance(v), 0.);
  const auto query = geodesics.add_query({face, {{0.2, 0.3, 0.5}}});
  expect_refused([&] { geodesics.distance(query); }, Cause::INVALID_PARAMETER);
  geodesics.compute(built.vertices[0]);
  EXPECT_GE(geodesics.distance(query), 0.);
}

} // namespace

} // namespace test_arguments
