// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "thresholds.h"

#include <limits>
#include <string>

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Method;

namespace {

CGAL::Cut_loci::internal::Curve_parameters curve_parameters(const Options& options)
{
  return CGAL::Cut_loci::internal::curve_parameters(options.curve, options.smoothing);
}

// Gap or width replace the defaults of all three, the curvature its own.
template <typename NamedParameters>
Cut_locus apply_exact_thresholds(const Options& options, const Cut_locus_solver& solver, const NamedParameters& np)
{
  const auto with_curvature = [&](const auto& parameters)
  {
    return options.minimum_branch_curvature
             ? solver.cut_locus(parameters.minimum_branch_curvature(*options.minimum_branch_curvature))
             : solver.cut_locus(parameters);
  };
  return options.minimum_branch_gap || options.minimum_branch_width
           ? with_curvature(np.minimum_branch_gap(options.minimum_branch_gap.value_or(0.))
                              .minimum_branch_width(options.minimum_branch_width.value_or(0.)))
           : with_curvature(np);
}

} // namespace

Mesh::Vertex_index find_vertex(std::size_t number, const Input_mesh& input, const std::string& origin)
{
  if(number >= input.vertex.size())
    throw Usage_error(origin + " " + std::to_string(number) + " is out of range: the mesh has the vertices 0 to " +
                      std::to_string(input.vertex.size() - 1));
  const Mesh::Vertex_index v = input.vertex[number];
  if(v == Mesh::null_vertex())
    throw Usage_error(origin + " " + std::to_string(number) +
                      ": this vertex belongs to no face, and is not in the repaired mesh (" +
                      description(input.repairs) + "): another vertex, or --source-point, is needed");
  return v;
}

Options fill_in_defaults(Options options, const Cut_locus_solver& solver)
{
  const auto fill_in = [](auto& option, auto value)
  {
    if(!option)
      option = value;
  };
  const bool is_laplacian = options.method == Method::LAPLACIAN;
  if(is_laplacian)
  {
    fill_in(options.angle, solver.default_gradient_angle_threshold());
    fill_in(options.grow, false);
    fill_in(options.smoothing, curve_parameters(options).iterations);
  }
  else if(options.minimum_branch_gap || options.minimum_branch_width)
  {
    fill_in(options.minimum_branch_gap, 0.);
    fill_in(options.minimum_branch_width, 0.);
  }
  else
  {
    options.minimum_branch_gap = solver.minimum_branch_gap();
    options.minimum_branch_width = solver.minimum_branch_width();
    fill_in(options.minimum_branch_curvature, solver.minimum_branch_curvature());
  }
  fill_in(options.minimum_branch_edges, is_laplacian ? solver.default_minimum_branch_edges() : 0);
  fill_in(options.minimum_branch_length, 0.);
  return options;
}

Cut_locus apply_thresholds(const Options& options, const Cut_locus_solver& solver)
{
  using CGAL::Cut_loci::Filter_policy;
  const auto part =
    CGAL::parameters::kept_part(options.kept).minimum_branch_length(options.minimum_branch_length.value_or(0.));
  const auto curve = curve_parameters(options);
  if(options.method != Method::LAPLACIAN)
    return apply_exact_thresholds(
      options, solver,
      part.minimum_branch_edges(options.minimum_branch_edges.value_or(0)).cut_locus_curve(curve.curve));
  return solver.cut_locus(
    part.gradient_angle_threshold(options.angle.value_or(solver.default_gradient_angle_threshold()))
      .laplacian_threshold(options.laplacian.value_or(-std::numeric_limits<double>::infinity()))
      .filter_policy(options.grow.value_or(false) ? Filter_policy::GROWING : Filter_policy::PRUNING)
      .minimum_branch_edges(options.minimum_branch_edges.value_or(solver.default_minimum_branch_edges()))
      .number_of_iterations(curve.iterations));
}

Cut_locus voronoi_diagram(const Options& options, const Cut_locus_solver& solver)
{
  const auto curve = curve_parameters(options);
  const auto part = CGAL::parameters::kept_part(Kept_part::VORONOI);
  return options.method == Method::LAPLACIAN ? solver.cut_locus(part.number_of_iterations(curve.iterations))
                                             : solver.cut_locus(part.cut_locus_curve(curve.curve));
}

Curve curve_of(const Options& options)
{
  return curve_parameters(options).curve;
}
