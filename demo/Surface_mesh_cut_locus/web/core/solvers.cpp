// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"

#include <CGAL/Graph_geodesic_solver.h>

#include <cmath>
#include <cstddef>
#include <limits>

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Filter_policy;
using CGAL::Cut_loci::Method;

namespace {

Cut_locus exact_cut_locus(const Solver& solver, const Thresholds& thresholds, Curve curve)
{
  const auto parameters = CGAL::parameters::cut_locus_curve(curve).kept_part(thresholds.keeps);
  if(std::isnan(thresholds.width))
    return solver.cut_locus(parameters);
  return solver.cut_locus(parameters.minimum_branch_width(thresholds.width));
}

Cut_locus laplacian_cut_locus(const Solver& solver, const Thresholds& thresholds, Curve curve)
{
  const auto given = [](double value, double otherwise) { return std::isnan(value) ? otherwise : value; };
  return solver.cut_locus(
    CGAL::parameters::gradient_angle_threshold(given(thresholds.angle, solver.default_gradient_angle_threshold()))
      .laplacian_threshold(given(thresholds.laplacian, -std::numeric_limits<double>::infinity()))
      .minimum_branch_edges(static_cast<std::size_t>(
        given(thresholds.minimum_edges, static_cast<double>(Solver::default_minimum_branch_edges()))))
      .minimum_branch_length(given(thresholds.minimum_length, 0.))
      .kept_part(thresholds.keeps)
      .filter_policy(thresholds.grows ? Filter_policy::GROWING : Filter_policy::PRUNING)
      .number_of_iterations(curve == Curve::MESH_EDGES ? std::size_t(0) : std::size_t(thresholds.smoothing)));
}

} // namespace

std::unique_ptr<Solver> make_exact_solver(const Mesh& mesh, Method method)
{
  return std::make_unique<Solver>(mesh, CGAL::parameters::cut_locus_method(method).visitor(Stage_reporter()));
}

std::unique_ptr<Solver> make_graph_solver(const Mesh& mesh)
{
  return std::make_unique<Solver>(mesh, CGAL::parameters::geodesic_solver(CGAL::Graph_geodesic_solver())
                                          .cut_locus_method(Method::LAPLACIAN)
                                          .visitor(Stage_reporter()));
}

void set_sources(Solver& solver, const std::vector<Location>& points, const std::vector<Edge_curve>& curves,
                 double relative_error)
{
  solver.set_sources(points, CGAL::parameters::source_curves(curves).maximum_relative_error(relative_error));
}

Cut_locus cut_locus(const Solver& solver, const Thresholds& thresholds, Curve curve)
{
  return solver.method() == Method::LAPLACIAN ? laplacian_cut_locus(solver, thresholds, curve)
                                              : exact_cut_locus(solver, thresholds, curve);
}
