// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The accuracy of the direction method, against closed forms on the torus and against geodesics that are shot on
// analytic surfaces.

#include "../../benchmark/Surface_mesh_cut_locus/accuracy_benchmark.h"
#include "../../benchmark/Surface_mesh_cut_locus/analytic_surfaces.h"
#include "../../benchmark/Surface_mesh_cut_locus/curve_distance.h"
#include "../../benchmark/Surface_mesh_cut_locus/remeshed_surface.h"
#include "../../benchmark/Surface_mesh_cut_locus/shot_cut_locus.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <gtest/gtest.h>

#include <random>

namespace test_default_accuracy {

namespace {

using namespace analytic;
namespace params = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Default_method;
using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;

struct Errors
{
  Deviation estimate, truth; // from the one to the other, in mean edge lengths
};

Errors torus_errors(Mesh mesh, const Point& source, const std::function<Polylines(double)>& truth, Curve curve)
{
  const Torus torus;
  const Mesh::Vertex_index v = snap_vertex(mesh, source);
  const double h = mean_edge_length(mesh);
  Solver solver(mesh, params::cut_locus_method(Default_method()));
  solver.set_source(v);
  const auto result = solver.cut_locus(params::cut_locus_curve(curve));
  Polylines estimate = segments_of(result);
  for(auto& s : estimate)
    for(Point& p : s)
      p = torus.project(p);
  Errors e;
  e.estimate = deviation(estimate, truth(h / 5.), h / 5.);
  e.truth = deviation(truth(h / 5.), estimate, h / 5.);
  for(Deviation* d : {&e.estimate, &e.truth})
  {
    d->mean /= h;
    d->max /= h;
  }
  return e;
}

TEST(Default_accuracy, torus)
{
  const Torus torus;
  for(double length : {0.08, 0.05})
  {
    const Mesh mesh = remeshed(torus, length);
    for(bool outer : {true, false})
    {
      const Point source = outer ? torus.point(0., 0.) : torus.point(1., pi);
      const auto truth = [&](double s)
      { return outer ? torus.cut_locus_of_outer_equator(0., s) : torus.cut_locus_of_inner_equator(1., s); };
      const Errors curve = torus_errors(mesh, source, truth, Curve::THROUGH_FACES);
      EXPECT_LT(curve.estimate.mean, 0.02);
      EXPECT_LT(curve.estimate.max, 1.);
      EXPECT_LT(curve.truth.max, 1.);
      const Errors edges = torus_errors(mesh, source, truth, Curve::MESH_EDGES);
      EXPECT_LT(edges.estimate.max, 1.);
      EXPECT_LT(edges.truth.max, 1.);
    }
  }
}

// The cut locus of a pole of an ellipsoid of revolution is the other pole; that of a point of the equator of an oblate
// one is an arc of the equator that ends at the first conjugate points, those at half the length b pi of a meridian.
TEST(Default_accuracy, ellipsoid_of_revolution)
{
  Ellipsoid oblate;
  oblate.a = oblate.b = 1.;
  oblate.c = 0.6;
  Mesh mesh = remeshed(oblate, 0.09);
  const double h = mean_edge_length(mesh);
  const Mesh::Vertex_index v = snap_vertex(mesh, Point(1., 0., 0.));
  Solver solver(mesh, params::cut_locus_method(Default_method()));
  solver.set_source(v);
  const auto result = solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
  Polylines estimate = segments_of(result), truth(1);
  // On the equator the curvature is 1 / c^2: conjugate at the arc length c pi.
  for(int i = 0; i <= 100; ++i)
  {
    const double u = 0.6 * pi + i / 100. * 2. * (pi - 0.6 * pi);
    truth[0].push_back(Point(std::cos(u), std::sin(u), 0.));
  }
  for(auto& s : estimate)
    for(Point& p : s)
      p = oblate.project(p);
  EXPECT_LT(deviation(estimate, truth, h / 5.).max, 1. * h);
  EXPECT_LT(deviation(truth, estimate, h / 5.).max, 1. * h);

  Mesh pole = remeshed(oblate, 0.09);
  const Mesh::Vertex_index p = snap_vertex(pole, Point(0., 0., 0.6));
  Solver pole_solver(pole, params::cut_locus_method(Default_method()));
  pole_solver.set_source(p);
  const auto point = pole_solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
  for(const auto& s : segments_of(point))
    for(const Point& q : s)
      EXPECT_LT(std::sqrt(CGAL::squared_distance(q, Point(0., 0., -0.6))), 3. * h);
}

// Against the cut locus that geodesics are shot for.
template <typename Surface>
void expect_near_shot(const Surface& surface, Mesh mesh, const Point& at)
{
  const Mesh::Vertex_index v = snap_vertex(mesh, at);
  const double h = mean_edge_length(mesh);
  const True_cut_locus truth = Shot_cut_locus<Surface>(surface, mesh.point(v), 5., 0.01)();
  Solver solver(mesh);
  solver.set_source(v);
  const auto result = solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
  Polylines estimate = segments_of(result);
  for(auto& s : estimate)
    for(Point& p : s)
      p = surface.project(p);
  const Deviation there = deviation(estimate, truth.curves, h / 5.), back = deviation(truth.curves, estimate, h / 5.);
  EXPECT_LT(there.mean, 0.03 * h);
  EXPECT_LT(there.max, 1. * h);
  EXPECT_LT(back.max, 1.5 * h); // at the tips
  EXPECT_EQ(CGAL::Cut_loci::compute_statistics(result).leaves, truth.tips.size());
}

TEST(Default_accuracy, general_sources)
{
  const Ellipsoid ellipsoid;
  const Torus torus;
  for(const Point& source : {Point(0.5, 0.4, 0.45), Point(0.2, -0.7, 0.1)})
    expect_near_shot(ellipsoid, remeshed(ellipsoid, 0.05), ellipsoid.project(source));
  expect_near_shot(torus, remeshed(torus, 0.07), torus.point(0.3, 0.9));
}

// A checker that accepts anything would be none.
TEST(Default_accuracy, shooting_rejects_wrong_points)
{
  const Torus torus;
  const Point source = torus.point(0., 0.);
  const Geodesic_shooting<Torus> shooting(torus, source, Vector(0., 1., 0.));
  // the point of the inner equator at a quarter of the way, moved off it
  const Point wrong = torus.point(pi, 0.5);
  const auto found = shooting.cut_point(torus.project(wrong + Vector(0., 0.05, 0.)), 0.3, pi - 0.3, 3.);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->point.y(), 0., 1e-6); // on the opposite meridian
  EXPECT_GT(std::fabs(found->point.y() - torus.project(wrong + Vector(0., 0.05, 0.)).y()), 0.04);
}

TEST(Default_accuracy, noise)
{
  const Torus torus;
  const Mesh smooth = remeshed(torus, 0.09);
  const double h = mean_edge_length(smooth);
  std::mt19937 generator(11);
  std::normal_distribution<double> normal(0., 1.);
  for(double amplitude : {0.03, 0.1, 0.2})
    for(bool outer : {true, false})
    {
      Mesh mesh = smooth;
      for(Mesh::Vertex_index v : mesh.vertices())
        mesh.point(v) = mesh.point(v) + amplitude * h * normal(generator) * torus.normal(mesh.point(v));
      const Point source = outer ? torus.point(0., 0.) : torus.point(1., pi);
      const Errors e = torus_errors(
        mesh, source,
        [&](double s)
        { return outer ? torus.cut_locus_of_outer_equator(0., s) : torus.cut_locus_of_inner_equator(1., s); },
        Curve::THROUGH_FACES);
      EXPECT_LT(e.estimate.max, 5.) << "a spurious branch, noise " << amplitude;
      EXPECT_LT(e.truth.max, 10.) << "a lost branch, noise " << amplitude;
    }
}

} // namespace

} // namespace test_default_accuracy
