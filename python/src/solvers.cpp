// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"

#include <CGAL/Graph_geodesic_solver.h>

#include <optional>
#include <stdexcept>
#include <variant>

namespace np = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Kept_part;
using CGAL::Cut_loci::Laplacian_method;
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

// Without a method, the library chooses one for each source.
template <typename NamedParameters>
std::unique_ptr<Solver> make_exact_solver(const Mesh& mesh, const std::optional<Method>& method,
                                          const NamedParameters& given)
{
  return method ? std::make_unique<Solver>(mesh, given.cut_locus_method(*method))
                : std::make_unique<Solver>(mesh, given);
}

template <typename NamedParameters>
void set_source(Solver& solver, const Source& source, const NamedParameters& parameters)
{
  std::visit([&](const auto& point) { solver.set_source(point, parameters); }, source);
}

// A function of Python takes the options of all methods.
void refuse_option(bool is_given, const char* name, const Method& in_force)
{
  if(is_given)
    throw CGAL::Cut_loci::Invalid_input(CGAL::Cut_loci::Cause::PARAMETER_OF_OTHER_METHOD,
                                        "the parameter " + std::string(name) + " has no meaning for the method " +
                                          name_of(in_force) + ", which is in force: leave it away, or pass " +
                                          (std::holds_alternative<Laplacian_method>(in_force)
                                             ? "method=\"default\", which needs exact distances"
                                             : "method=\"laplacian\""));
}

// No iterations leave edges of the mesh.
Curve curve_of(const Thresholds& t)
{
  const Curve by_iterations = t.number_of_iterations == 0L ? Curve::MESH_EDGES : Curve::THROUGH_FACES;
  if(t.curve && t.number_of_iterations && *t.curve != by_iterations)
    throw CGAL::Cut_loci::Invalid_input(
      CGAL::Cut_loci::Cause::INVALID_PARAMETER,
      "the parameters curve and number_of_iterations contradict each other: no iterations leave edges of the mesh, and "
      "one or more of them give a curve through the faces");
  return t.curve.value_or(by_iterations);
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

template <typename Options>
void set_least_branch(const Thresholds& t, Options& options)
{
  if(t.minimum_branch_edges)
    options.minimum_branch_edges(*t.minimum_branch_edges);
  options.minimum_branch_length(t.minimum_branch_length.value_or(0.));
}

template <typename Path_method>
Method options_of(const Thresholds& t, Path_method options)
{
  refuse_option(t.gradient_angle_threshold.has_value(), "gradient_angle_threshold", options);
  refuse_option(t.laplacian_threshold.has_value(), "laplacian_threshold", options);
  refuse_option(t.filter_policy.has_value(), "filter_policy", options);
  refuse_option(t.number_of_iterations.has_value(), "number_of_iterations", options);
  set_least_branch(t, options);
  if(t.minimum_branch_width)
    options.minimum_branch_width(*t.minimum_branch_width);
  if(t.minimum_branch_gap)
    options.minimum_branch_gap(*t.minimum_branch_gap);
  if(t.minimum_branch_curvature)
    options.minimum_branch_curvature(*t.minimum_branch_curvature);
  return options;
}

Method options_of(const Thresholds& t, Laplacian_method options)
{
  refuse_option(t.minimum_branch_width.has_value(), "minimum_branch_width", options);
  refuse_option(t.minimum_branch_gap.has_value(), "minimum_branch_gap", options);
  refuse_option(t.minimum_branch_curvature.has_value(), "minimum_branch_curvature", options);
  set_least_branch(t, options);
  if(t.gradient_angle_threshold)
    options.gradient_angle_threshold(*t.gradient_angle_threshold);
  if(t.laplacian_threshold)
    options.laplacian_threshold(*t.laplacian_threshold);
  if(t.filter_policy)
    options.filter_policy(*t.filter_policy);
  if(t.number_of_iterations.value_or(0) != 0)
    options.number_of_iterations(*t.number_of_iterations);
  return options;
}

} // namespace

std::unique_ptr<Solver> make_solver(const std::string& name, const std::optional<Method>& method,
                                    std::optional<Laplacian_operator> laplacian_operator,
                                    const std::vector<double>& edge_lengths, const Mesh& mesh, Progress& progress)
{
  const bool is_exact = name == "exact";
  Method in_force = method.value_or(is_exact ? Method() : Laplacian_method());
  Laplacian_method* const laplacian = std::get_if<Laplacian_method>(&in_force);
  if(laplacian == nullptr)
    refuse_option(laplacian_operator.has_value(), "laplacian_operator", in_force);
  else if(laplacian_operator)
    laplacian->laplacian_operator(*laplacian_operator);
  const auto visited = np::visitor(std::ref(progress));
  const std::optional<Method> asked = method ? std::optional<Method>(in_force) : std::nullopt;
  if(is_exact && edge_lengths.empty())
    return make_exact_solver(mesh, asked, visited);
  if(is_exact)
    return make_exact_solver(mesh, asked, visited.edge_length_map(Length_map{&edge_lengths}));
  if(!edge_lengths.empty())
    CGAL::Cut_loci::internal::refuse_lengths("the geodesic_solver");
  if(laplacian == nullptr)
    CGAL::Cut_loci::internal::refuse_distances(in_force);
  if(name == "cgal-exact")
    return make_cgal_exact_solver(mesh, *laplacian, progress);
  if(name == "heat")
    return make_heat_solver(mesh, *laplacian, progress);
  if(name == "heat-direct")
    return make_heat_direct_solver(mesh, *laplacian, progress);
  if(name == "graph")
    return make_laplacian_solver<CGAL::Graph_geodesic_solver>(mesh, *laplacian, progress);
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
  const Method options =
    std::visit([&](const auto& method) { return options_of(thresholds, method); }, solver.method());
  return solver.cut_locus(
    np::cut_locus_method(options).cut_locus_curve(curve_of(thresholds)).kept_part(kept_part(thresholds)));
}
