// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"

#include <CGAL/Graph_geodesic_solver.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>

namespace np = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Filter_policy;
using CGAL::Cut_loci::Kept_part;
using CGAL::Cut_loci::Method;

namespace {

// The distances that the user has, as a property map.
struct Distance_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const std::vector<double>* distances;

  friend double get(const Distance_map& map, Mesh::Vertex_index v) { return (*map.distances)[v]; }
};

// The same for lengths.
struct Length_map
{
  using key_type = Mesh::Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const std::vector<double>* lengths;

  friend double get(const Length_map& map, Mesh::Edge_index e) { return (*map.lengths)[e]; }
};

// What is given is passed on, so that the library refuses what has no meaning for the method. Each combination is a type.
template <typename NamedParameters>
std::unique_ptr<Solver> make_exact_solver(const Mesh& mesh, std::optional<Method> method,
                                          std::optional<Laplacian_operator> laplacian_operator,
                                          const NamedParameters& given)
{
  if(method && laplacian_operator)
    return std::make_unique<Solver>(mesh, given.cut_locus_method(*method).laplacian_operator(*laplacian_operator));
  if(method)
    return std::make_unique<Solver>(mesh, given.cut_locus_method(*method));
  if(laplacian_operator)
    return std::make_unique<Solver>(mesh, given.laplacian_operator(*laplacian_operator));
  return std::make_unique<Solver>(mesh, given);
}

template <typename NamedParameters>
void set_source(Solver& solver, const Source& source, const NamedParameters& parameters)
{
  std::visit([&](const auto& point) { solver.set_source(point, parameters); }, source);
}

void refuse_thresholds_of_other_methods(Method method, const Thresholds& t)
{
  using CGAL::Cut_loci::internal::refuse_parameters_of_other_methods;
  if(t.minimum_branch_width)
    refuse_parameters_of_other_methods(method, np::minimum_branch_width(0.));
  if(t.minimum_branch_gap)
    refuse_parameters_of_other_methods(method, np::minimum_branch_gap(0.));
  if(t.minimum_branch_curvature)
    refuse_parameters_of_other_methods(method, np::minimum_branch_curvature(0.));
  if(t.gradient_angle_threshold)
    refuse_parameters_of_other_methods(method, np::gradient_angle_threshold(0.));
  if(t.laplacian_threshold)
    refuse_parameters_of_other_methods(method, np::laplacian_threshold(0.));
  if(t.filter_policy)
    refuse_parameters_of_other_methods(method, np::filter_policy(Filter_policy::PRUNING));
  if(t.number_of_iterations)
    refuse_parameters_of_other_methods(method, np::number_of_iterations(0));
}

Kept_part kept_part(const Thresholds& t)
{
  const bool is_voronoi = t.voronoi.value_or(false), is_medial = t.medial.value_or(false);
  if(is_voronoi && is_medial)
    throw CGAL::Cut_loci::Invalid_input(
      CGAL::Cut_loci::Cause::INVALID_PARAMETER,
      "the parameters voronoi and medial exclude each other: without both, the result has all edges");
  return is_voronoi ? Kept_part::VORONOI : is_medial ? Kept_part::MEDIAL : Kept_part::ALL;
}

template <typename NamedParameters>
Cut_locus exact_cut_locus(const Solver& solver, const Thresholds& t, const NamedParameters& given)
{
  const auto with_curvature = [&](const auto& parameters)
  {
    return t.minimum_branch_curvature
             ? solver.cut_locus(parameters.minimum_branch_curvature(*t.minimum_branch_curvature))
             : solver.cut_locus(parameters);
  };
  if(t.minimum_branch_width || t.minimum_branch_gap)
    return with_curvature(given.minimum_branch_width(t.minimum_branch_width.value_or(0.))
                            .minimum_branch_gap(t.minimum_branch_gap.value_or(0.)));
  return with_curvature(given);
}

Cut_locus exact_cut_locus(const Solver& solver, const Thresholds& t, Curve curve)
{
  return exact_cut_locus(solver, t,
                         np::cut_locus_curve(curve)
                           .kept_part(kept_part(t))
                           .minimum_branch_edges(t.minimum_branch_edges.value_or(0))
                           .minimum_branch_length(t.minimum_branch_length.value_or(0.)));
}

Cut_locus laplacian_cut_locus(const Solver& solver, const Thresholds& t, std::size_t iterations)
{
  return solver.cut_locus(
    np::gradient_angle_threshold(t.gradient_angle_threshold.value_or(solver.default_gradient_angle_threshold()))
      .laplacian_threshold(t.laplacian_threshold.value_or(-std::numeric_limits<double>::infinity()))
      .filter_policy(t.filter_policy.value_or(Filter_policy::PRUNING))
      .minimum_branch_edges(t.minimum_branch_edges.value_or(static_cast<long>(Solver::default_minimum_branch_edges())))
      .minimum_branch_length(t.minimum_branch_length.value_or(0.))
      .kept_part(kept_part(t))
      .number_of_iterations(iterations));
}

} // namespace

std::unique_ptr<Solver> make_solver(const std::string& name, std::optional<Method> method,
                                    std::optional<Laplacian_operator> laplacian_operator,
                                    const std::vector<double>& edge_lengths, const Mesh& mesh, Progress& progress)
{
  const auto visited = np::visitor(std::ref(progress));
  if(name == "exact" && edge_lengths.empty())
    return make_exact_solver(mesh, method, laplacian_operator, visited);
  if(name == "exact")
    return make_exact_solver(mesh, method, laplacian_operator, visited.edge_length_map(Length_map{&edge_lengths}));
  if(!edge_lengths.empty())
    CGAL::Cut_loci::internal::refuse_lengths("the geodesic_solver");
  if(method && *method != Method::LAPLACIAN)
    CGAL::Cut_loci::internal::refuse_distances(*method);
  const Laplacian_operator type = laplacian_operator.value_or(Laplacian_operator::QUADRATIC_FIT);
  if(name == "cgal-exact")
    return make_cgal_exact_solver(mesh, type, progress);
  if(name == "heat")
    return make_heat_solver(mesh, type, progress);
  if(name == "heat-direct")
    return make_heat_direct_solver(mesh, type, progress);
  if(name == "graph")
    return make_laplacian_solver<CGAL::Graph_geodesic_solver>(mesh, type, progress);
  throw std::invalid_argument("there is no solver '" + name + "'");
}

void set_source(Solver& solver, const Source& source, const Source_parameters& parameters)
{
  const auto given = np::snapping_tolerance(parameters.snapping_tolerance);
  if(parameters.distances)
    set_source(solver, source, given.vertex_distance_map(Distance_map{&*parameters.distances}));
  else
    set_source(solver, source, given.maximum_relative_error(parameters.maximum_relative_error));
}

void set_sources(Solver& solver, const std::vector<Source>& sources, const Source_parameters& parameters)
{
  const auto given = np::snapping_tolerance(parameters.snapping_tolerance)
                       .source_curves(parameters.curves)
                       .source_border(parameters.border);
  if(parameters.distances)
    solver.set_sources(sources, given.vertex_distance_map(Distance_map{&*parameters.distances}));
  else
    solver.set_sources(sources, given.maximum_relative_error(parameters.maximum_relative_error));
}

Cut_locus compute_cut_locus(const Solver& solver, const Thresholds& thresholds)
{
  namespace library = CGAL::Cut_loci::internal;
  refuse_thresholds_of_other_methods(solver.method(), thresholds);
  std::optional<std::size_t> steps;
  if(thresholds.number_of_iterations)
    steps = library::to_count(*thresholds.number_of_iterations, "number_of_iterations");
  const library::Curve_parameters curve = library::curve_parameters(thresholds.curve, steps);
  return solver.method() == Method::LAPLACIAN ? laplacian_cut_locus(solver, thresholds, curve.iterations)
                                              : exact_cut_locus(solver, thresholds, curve.curve);
}
