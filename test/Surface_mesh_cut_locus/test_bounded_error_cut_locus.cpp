// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Cut loci from distances with a maximum relative error.

#include "surface_test.h"
#include "default_results.h"

#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/property_map.h>

namespace test_bounded_error_cut_locus {

namespace {

using namespace surface_test;
using namespace default_test;

constexpr double rounding = 1e-12;

// -- cut loci ----------------------------------------------------------------------------------------------------------

void check_topology(const Mesh_data& data, const std::string& name)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  const Index f = mesh.number_of_faces() / 3;
  for(double error : {1e-5, 1e-3, 0.1})
  {
    const std::string what = name + ", error " + std::to_string(error);
    expect_invariants(mesh, at_vertex(mesh, 0), what + ", vertex", error);
    expect_invariants(mesh, at_vertex(mesh, mesh.number_of_vertices() / 2), what + ", another vertex", error);
    expect_invariants(mesh, in_face(f, 0.5, 0.3, 0.2), what + ", face", error);
    expect_invariants(mesh, in_face(f, 0.4, 0.6, 0.), what + ", edge", error);
  }
}

TEST(Bounded_error_cut_locus, topology)
{
  check_topology(cuboid({{3., 1., 0.4}}, 5, Diagonals::PARALLEL), "box");
  check_topology(plate_with_holes(3, 1, 2, Diagonals::PARALLEL), "plate with holes");
  check_topology(torus(1., 0.4, 60, 24), "torus");
  check_topology(sphere_of_squares(8), "sphere");
  Mesh_data needles = torus(1., 0.4, 60, 24);
  for(auto& p : needles.points)
    p[2] *= 30.;
  check_topology(needles, "needles");
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> random(-1., 1.);
  Mesh_data rough = torus(1., 0.4, 30, 12);
  for(auto& p : rough.points)
    for(double& x : p)
      x += 0.08 * random(generator);
  check_topology(rough, "saddles everywhere");
  check_topology(without_ball(torus(1., 0.4, 40, 16), {{1.4, 0., 0.}}, 0.3), "torus with a hole");
  check_topology(without_ball(without_ball(sphere_of_squares(8), {{0., 0., 1.}}, 0.4), {{1., 0., 0.}}, 0.3),
                 "with two borders");
}

// Branches that are about as wide as they have to be come and go; what is clearly wider is there, and nothing else.
TEST(Bounded_error_cut_locus, is_near_to_the_exact_one)
{
  const Indexed_triangle_mesh meshes[] = {
    indexed(torus(1., 0.4, 200, 80, 0.2, 5)),
    indexed(ellipsoid(1., 0.8, 0.6, 40, 0.2, 5)),
    indexed(bumpy_sphere(30, 0.3, 2)),
  };
  for(const Indexed_triangle_mesh& mesh : meshes)
    for(Index v : {Index(17), mesh.number_of_vertices() / 2, mesh.number_of_vertices() - 1})
    {
      SCOPED_TRACE("faces " + std::to_string(mesh.number_of_faces()) + ", source " + std::to_string(v));
      const auto source = at_vertex(mesh, v);
      const Solved exact(mesh, source), bounded(mesh, source, 1e-5);
      Solved::Thresholds narrower = exact.solver->default_thresholds(), wider = narrower;
      narrower.width *= 0.5;
      narrower.spur = 0.; // all that is as wide
      wider.width *= 1.5;
      const Indexed_cut_locus found = bounded.through_faces();
      const double h = exact.solver->connectivity().mean_edge_length;
      ASSERT_GT(found.edges.size(), 20u);
      EXPECT_LT(farthest(segments(mesh, exact.curve(wider, Curve::THROUGH_FACES)), segments(mesh, found)), 0.3 * h);
      EXPECT_LT(farthest(segments(mesh, found), segments(mesh, exact.curve(narrower, Curve::THROUGH_FACES))), 0.3 * h);
    }
}

// -- the class -----------------------------------------------------------------------------------------------------------

TEST(Bounded_error_cut_locus, parameter_of_each_source)
{
  const Built built(torus(1., 0.4, 80, 32, 0.2, 3));
  Solver solver(built.mesh), exact(built.mesh);
  exact.set_source(built.vertices[5]);
  for(Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
  {
    solver.set_source(built.vertices[5], params::maximum_relative_error(1e-3));
    const auto bounded = solver.cut_locus(params::cut_locus_curve(curve));
    const auto expected = exact.cut_locus(params::cut_locus_curve(curve));
    double largest = 0.;
    for(const auto v : built.vertices)
    {
      const double d = expected.distance(v), error = bounded.distance(v) - d;
      largest = (std::max)(largest, error);
      EXPECT_GE(error, -rounding);
      EXPECT_LE(error, 1e-3 * d + rounding);
    }
    EXPECT_GT(largest, 1e-9) << "windows have been merged";
    if(curve == Curve::MESH_EDGES)
    {
      EXPECT_EQ(fault_of(built, bounded, 0, {5}, Default_method()), "");
    }
    solver.set_source(built.vertices[5]);
    const auto again = solver.cut_locus(params::cut_locus_curve(curve));
    EXPECT_EQ(num_edges(again.graph()), num_edges(expected.graph())) << "the error is gone";
    EXPECT_EQ(again.distance(built.vertices[7]), expected.distance(built.vertices[7]));
  }
}

TEST(Bounded_error_cut_locus, laplacian)
{
  const Built built(torus(1., 0.4, 80, 32, 0.2, 3));
  Solver solver(built.mesh, by(Laplacian_method())), exact(built.mesh);
  exact.set_source(built.vertices[5]);
  const auto expected = exact.cut_locus();
  for(double error : {1e-4, 1e-2})
  {
    solver.set_source(built.vertices[5], params::maximum_relative_error(error));
    const auto result = solver.cut_locus(mesh_edges);
    EXPECT_EQ(fault_of(built, result, 0, {5}, Laplacian_method()), "");
    EXPECT_NE(result.distance(built.vertices[900]), expected.distance(built.vertices[900]));
    EXPECT_NEAR(result.distance(built.vertices[900]), expected.distance(built.vertices[900]),
                error * expected.distance(built.vertices[900]));
  }
}

TEST(Bounded_error_cut_locus, several_sources)
{
  const Built built(torus(1., 0.4, 80, 32, 0.2, 3));
  Solver solver(built.mesh);
  const std::vector<Built::vertex_descriptor> sources = {built.vertices[5], built.vertices[700], built.vertices[1500]};
  for(double error : {0., 1e-5, 1e-3})
  {
    solver.set_sources(sources, params::maximum_relative_error(error));
    const auto result = solver.cut_locus(through_faces);
    EXPECT_EQ(num_edges(result.graph()) + 1, num_vertices(result.graph()) + 2 - 1 + sources.size()) << error;
  }
}

TEST(Bounded_error_cut_locus, refusals)
{
  const Built built(torus(1., 0.4, 40, 16, 0.2, 3));
  const auto v = built.vertices[5];
  Solver solver(built.mesh);
  for(double bad : {-1e-9, 0.11, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(solver.set_source(v, params::maximum_relative_error(bad)), Invalid_input);
  EXPECT_THROW(solver.set_sources(std::vector<Built::vertex_descriptor>{v}, params::maximum_relative_error(-1.)),
               Invalid_input);

  Solver full(built.mesh, by(Polyhedral_method()));
  EXPECT_THROW(full.set_source(v, params::maximum_relative_error(1e-3)), Invalid_input);
  full.set_source(v);
  EXPECT_GT(num_edges(full.cut_locus().graph()), 0u);

  solver.set_source(v, params::maximum_relative_error(1e-3));
  EXPECT_THROW(solver.cut_locus(by(Default_method().minimum_branch_width(0.))), Invalid_input);
  EXPECT_EQ(fault_of(built, solver.cut_locus(mesh_edges), 0, {5}, Default_method()), "") << "nothing is lost by that";
  EXPECT_EQ(fault_of(built, solver.cut_locus(mesh_edges.cut_locus_method(Default_method().minimum_branch_width(1e-3))),
                     0, {5}, Default_method()),
            "");

  Solver heat(built.mesh, params::geodesic_solver(CGAL::Heat_method_geodesic_solver()));
  EXPECT_THROW(heat.set_source(v, params::maximum_relative_error(1e-3)), Invalid_input);
  heat.set_source(v, params::maximum_relative_error(0.));
  const CGAL::Constant_property_map<Built::vertex_descriptor, double> distances(1.);
  EXPECT_THROW(solver.set_source(v, params::maximum_relative_error(1e-3).vertex_distance_map(distances)),
               Invalid_input);
}

} // namespace

} // namespace test_bounded_error_cut_locus
