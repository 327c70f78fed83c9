// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"

#include <CGAL/Graph_geodesic_solver.h>

#include <cmath>
#include <variant>

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Filter_policy;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;

namespace {

template <typename Path_method>
Method options_of(const Thresholds& thresholds, Path_method method)
{
  if(!std::isnan(thresholds.width))
    method.minimum_branch_width(thresholds.width);
  return method;
}

Method options_of(const Thresholds& thresholds, Laplacian_method method)
{
  const auto given = [](double value, double otherwise) { return std::isnan(value) ? otherwise : value; };
  if(thresholds.smoothing > 0)
    method.number_of_iterations(thresholds.smoothing);
  return method.gradient_angle_threshold(given(thresholds.angle, method.gradient_angle_threshold()))
    .laplacian_threshold(given(thresholds.laplacian, method.laplacian_threshold()))
    .minimum_branch_edges(
      static_cast<long>(given(thresholds.minimum_edges, static_cast<double>(method.minimum_branch_edges()))))
    .minimum_branch_length(given(thresholds.minimum_length, 0.))
    .filter_policy(thresholds.grows ? Filter_policy::GROWING : Filter_policy::PRUNING);
}

} // namespace

std::unique_ptr<Solver> make_exact_solver(const Mesh& mesh, const Method& method)
{
  return std::make_unique<Solver>(mesh, CGAL::parameters::cut_locus_method(method).visitor(Stage_reporter()));
}

std::unique_ptr<Solver> make_graph_solver(const Mesh& mesh)
{
  return std::make_unique<Solver>(
    mesh, CGAL::parameters::geodesic_solver(CGAL::Graph_geodesic_solver()).visitor(Stage_reporter()));
}

void set_sources(Solver& solver, const std::vector<Location>& points, const std::vector<Edge_curve>& curves,
                 double relative_error)
{
  solver.set_sources(points, CGAL::parameters::source_curves(curves).maximum_relative_error(relative_error));
}

Cut_locus cut_locus(const Solver& solver, const Thresholds& thresholds, Curve curve)
{
  const Method options = std::visit([&](const auto& m) { return options_of(thresholds, m); }, solver.method());
  const bool has_steps = !std::holds_alternative<Laplacian_method>(options) || thresholds.smoothing > 0;
  return solver.cut_locus(CGAL::parameters::cut_locus_method(options)
                            .cut_locus_curve(has_steps ? curve : Curve::MESH_EDGES)
                            .kept_part(thresholds.keeps));
}
