// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "thresholds.h"

#include <string>
#include <variant>

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;

namespace {

template <typename Path_method>
Method options_of(const Options& options, Path_method method)
{
  method.minimum_branch_edges(static_cast<long>(options.minimum_branch_edges.value_or(0)))
    .minimum_branch_length(options.minimum_branch_length.value_or(0.));
  if(options.minimum_branch_gap)
    method.minimum_branch_gap(*options.minimum_branch_gap);
  if(options.minimum_branch_width)
    method.minimum_branch_width(*options.minimum_branch_width);
  if(options.minimum_branch_curvature)
    method.minimum_branch_curvature(*options.minimum_branch_curvature);
  return method;
}

Method options_of(const Options& options, Laplacian_method method)
{
  using CGAL::Cut_loci::Filter_policy;
  method.filter_policy(options.grow.value_or(false) ? Filter_policy::GROWING : Filter_policy::PRUNING)
    .minimum_branch_length(options.minimum_branch_length.value_or(0.));
  if(options.angle)
    method.gradient_angle_threshold(*options.angle);
  if(options.laplacian)
    method.laplacian_threshold(*options.laplacian);
  if(options.minimum_branch_edges)
    method.minimum_branch_edges(static_cast<long>(*options.minimum_branch_edges));
  if(options.smoothing.value_or(0) > 0)
    method.number_of_iterations(static_cast<long>(*options.smoothing));
  return method;
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
  const bool is_laplacian = std::holds_alternative<Laplacian_method>(options.method);
  if(is_laplacian)
  {
    const Laplacian_method by_default;
    fill_in(options.angle, by_default.gradient_angle_threshold());
    fill_in(options.grow, false);
    fill_in(options.smoothing, curve_of(options) == Curve::MESH_EDGES ? 0 : by_default.number_of_iterations());
    fill_in(options.minimum_branch_edges, by_default.minimum_branch_edges());
  }
  else
  {
    const bool is_given = options.minimum_branch_gap || options.minimum_branch_width;
    fill_in(options.minimum_branch_width, is_given ? 0. : solver.minimum_branch_width());
    fill_in(options.minimum_branch_gap, 0.);
    if(!is_given)
      fill_in(options.minimum_branch_curvature, solver.minimum_branch_curvature());
  }
  fill_in(options.minimum_branch_edges, 0);
  fill_in(options.minimum_branch_length, 0.);
  return options;
}

Cut_locus apply_thresholds(const Options& options, const Cut_locus_solver& solver)
{
  const Method method = std::visit([&](const auto& m) { return options_of(options, m); }, options.method);
  return solver.cut_locus(
    CGAL::parameters::cut_locus_method(method).cut_locus_curve(curve_of(options)).kept_part(options.kept));
}

Cut_locus voronoi_diagram(const Options& options, const Cut_locus_solver& solver)
{
  Options all;
  all.method = options.method;
  all.curve = options.curve;
  all.smoothing = options.smoothing;
  all.kept = Kept_part::VORONOI;
  return apply_thresholds(all, solver);
}

// no smoothing leaves edges of the mesh
Curve curve_of(const Options& options)
{
  return options.curve.value_or(options.smoothing == std::size_t(0) ? Curve::MESH_EDGES : Curve::THROUGH_FACES);
}
