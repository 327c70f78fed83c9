// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_METHOD_PARAMETERS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_METHOD_PARAMETERS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace CGAL::Cut_loci::internal {

// The named parameters that depend on the method: which of them it takes, and their values.

template <typename NamedParameters, typename Tag>
constexpr bool is_given()
{
  return !parameters::is_default_parameter<NamedParameters, Tag>::value;
}

[[noreturn]] inline void refuse_distances(Method method)
{
  throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD,
                      "the method " + std::string(name_of(method)) +
                        " needs the paths of the package's own exact solver, and not distances alone: leave "
                        "geodesic_solver and vertex_distance_map away, or pass "
                        "cut_locus_method(Cut_loci::Method::LAPLACIAN)");
}

inline void refuse_error_of_curves(double error)
{
  if(error > 0.)
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "sources that are curves need exact distances: leave maximum_relative_error away");
}

[[noreturn]] inline void refuse_without_mesh_edges(const std::string& name, const std::string& result)
{
  throw Invalid_input(Cause::INVALID_PARAMETER, "the parameter " + name +
                                                  " is for a cut locus made of edges of the mesh, and " + result +
                                                  " runs through the faces: leave it away, or pass "
                                                  "cut_locus_curve(Cut_loci::Curve::MESH_EDGES)");
}

// One answer is about one curve: the map would be of another one.
template <typename NamedParameters>
void refuse_map_of_other_curve(const NamedParameters&, Curve curve)
{
  if(is_given<NamedParameters, internal_np::edge_is_constrained_t>() && curve != Curve::MESH_EDGES)
    refuse_without_mesh_edges("edge_is_constrained_map", "this one");
}

// Of sources that are curves, branches are known to be short only where they do not end at a source, as edges do not.
inline void refuse_short_branches(const Exact_tree_thresholds& thresholds, Curve curve)
{
  if(curve == Curve::MESH_EDGES)
    return;
  if(thresholds.minimum_edges > 1)
    refuse_without_mesh_edges("minimum_branch_edges", "that of sources that are curves");
  if(thresholds.minimum_length > 0.)
    refuse_without_mesh_edges("minimum_branch_length", "that of sources that are curves");
}

// A parameter of another method would be ignored, and the caller would take the result for what it asked for.
template <typename NamedParameters>
void refuse_parameters_of_other_methods(Method method, const NamedParameters&)
{
  namespace np = internal_np;
  static_assert(!is_given<NamedParameters, np::face_is_excluded_map_t>(),
                "face_is_excluded_map is for exact distances alone: use Surface_mesh_exact_geodesics, or a mesh "
                "without these faces");
  static_assert(!is_given<NamedParameters, np::maximum_deviation_t>(),
                "maximum_deviation is for isolines: use Surface_mesh_exact_geodesics");
  const bool is_laplacian = method == Method::LAPLACIAN;
  const auto refuse = [&](bool is_there, const char* name, const char* remedy)
  {
    if(is_there)
      throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD, "the parameter " + std::string(name) +
                                                              " has no meaning for the method " + name_of(method) +
                                                              ", which is in force: " + remedy);
  };
  const auto of_laplacian = [&](bool is_there, const char* name)
  { refuse(is_there && !is_laplacian, name, "leave it away, or pass cut_locus_method(Cut_loci::Method::LAPLACIAN)"); };
  const auto of_paths = [&](bool is_there, const char* name)
  {
    refuse(is_there && is_laplacian, name,
           "leave it away, or pass cut_locus_method(Cut_loci::Method::DIRECTION), which needs exact distances");
  };
  of_laplacian(is_given<NamedParameters, np::gradient_angle_threshold_t>(), "gradient_angle_threshold");
  of_laplacian(is_given<NamedParameters, np::laplacian_threshold_t>(), "laplacian_threshold");
  of_laplacian(is_given<NamedParameters, np::filter_policy_t>(), "filter_policy");
  of_laplacian(is_given<NamedParameters, np::laplacian_operator_t>(), "laplacian_operator");
  refuse(is_given<NamedParameters, np::number_of_iterations_t>() && !is_laplacian, "number_of_iterations",
         "pass cut_locus_curve(Cut_loci::Curve::THROUGH_FACES), which needs no iterations, or "
         "cut_locus_method(Cut_loci::Method::LAPLACIAN)");
  of_paths(is_given<NamedParameters, np::minimum_branch_gap_t>(), "minimum_branch_gap");
  of_paths(is_given<NamedParameters, np::minimum_branch_width_t>(), "minimum_branch_width");
  of_paths(is_given<NamedParameters, np::minimum_branch_curvature_t>(), "minimum_branch_curvature");
}

template <typename Number>
std::size_t to_count(Number value, const char* name)
{
  if(!(static_cast<double>(value) >= 0.))
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        std::string("the parameter ") + name + " must be a number, and must not be negative");
  return static_cast<std::size_t>(value);
}

// The thresholds of both methods but for their own one. `minimum_length` is in units of `diagonal`.
template <typename Thresholds, typename NamedParameters>
void read_least_branch(const NamedParameters& np, std::size_t default_edges, double diagonal, Thresholds& thresholds)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const std::size_t edges = to_count(
    choose_parameter(get_parameter(np, internal_np::minimum_branch_edges), default_edges), "minimum_branch_edges");
  thresholds.minimum_edges = static_cast<Index>((std::min)(edges, static_cast<std::size_t>(null_index)));
  thresholds.minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_branch_length), 0.);
  if(!(thresholds.minimum_length >= 0.))
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "the minimum length of a branch must be a number that is not negative");
  thresholds.minimum_length *= diagonal;
}

template <typename NamedParameters>
Branch_thresholds read_branch_thresholds(const NamedParameters& np, double default_angle, std::size_t default_edges,
                                         double diagonal)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Branch_thresholds result;
  result.gradient_angle = choose_parameter(get_parameter(np, internal_np::gradient_angle_threshold), default_angle);
  result.laplacian = choose_parameter(get_parameter(np, internal_np::laplacian_threshold), result.laplacian);
  result.policy = choose_parameter(get_parameter(np, internal_np::filter_policy), result.policy);
  if(!(result.gradient_angle >= 0. && result.gradient_angle <= geodesic_pi))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the threshold for the gradient angle must be an angle from 0 to pi");
  if(std::isnan(result.laplacian))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the threshold for the Laplacian is not a number");
  read_least_branch(np, default_edges, diagonal, result);
  return result;
}

template <typename NamedParameters>
Kept_part read_kept_part(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::kept_part), Kept_part::ALL);
}

// The width is in units of `diagonal`, but for that of `by_default`, a length. Who asks for one of both gets all that
// passes it. No two points in space are farther apart than 1; of lengths alone nothing is known.
template <typename NamedParameters>
Exact_tree_thresholds read_exact_tree_thresholds(const NamedParameters& np, const Exact_tree_thresholds& by_default,
                                                 double diagonal, bool is_intrinsic)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr bool is_asked = is_given<NamedParameters, internal_np::minimum_branch_gap_t>() ||
                            is_given<NamedParameters, internal_np::minimum_branch_width_t>();
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  Exact_tree_thresholds result = by_default;
  if(is_asked)
  {
    result.enclosed = infinity;
    result.gap = choose_parameter(get_parameter(np, internal_np::minimum_branch_gap), 0.);
    const double width = choose_parameter(get_parameter(np, internal_np::minimum_branch_width), 0.);
    if(!(width >= 0. && width <= (is_intrinsic ? (std::numeric_limits<double>::max)() / diagonal : 1.)))
      throw Invalid_input(
        Cause::INVALID_PARAMETER,
        "the minimum width of a branch must be a number that is not negative, and no larger than 1, the "
        "diagonal of the bounding box, if the mesh is in space");
    result.width = diagonal * width;
    result.narrow = Branch_strength::narrow_share * result.width;
    result.spur = 0.;
    result.noise = {};
  }
  if(is_given<NamedParameters, internal_np::minimum_branch_curvature_t>())
  {
    result.noise = {};
    result.enclosed = choose_parameter(get_parameter(np, internal_np::minimum_branch_curvature), infinity);
    if(!(result.enclosed >= 0. && result.enclosed <= 4. * geodesic_pi))
      throw Invalid_input(Cause::INVALID_PARAMETER,
                          "the minimum curvature of a branch must be an angle from 0 to 4 pi, that of a sphere");
  }
  if(!(result.gap >= 0. && result.gap <= geodesic_pi))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the minimum gap of a branch must be an angle from 0 to pi");
  read_least_branch(np, 0, diagonal, result);
  result.part = read_kept_part(np);
  return result;
}

// Beyond a tenth, distances would say little about where paths meet.
template <typename NamedParameters>
double read_maximum_relative_error(const NamedParameters& np)
{
  const double result =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_relative_error), 0.);
  if(!(result >= 0. && result <= 0.1))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the maximum relative error must be a number from 0 to 0.1");
  return result;
}

[[noreturn]] inline void refuse_error()
{
  throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD,
                      "the parameter maximum_relative_error is for the package's own exact solver: leave it away, or "
                      "geodesic_solver and vertex_distance_map");
}

struct Curve_parameters
{
  Curve curve;
  std::size_t iterations; // of smoothing, for the method that needs it
};

// The only place that decides which curve there is: the one through the faces, unless edges of the mesh are asked for, by
// their name or by no steps of smoothing.
inline Curve_parameters curve_parameters(std::optional<Curve> curve, std::optional<std::size_t> iterations)
{
  constexpr std::size_t enough = 4; // each one halves what is left
  const Curve by_iterations = iterations == std::size_t(0) ? Curve::MESH_EDGES : Curve::THROUGH_FACES;
  if(curve && iterations && *curve != by_iterations)
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "the parameters cut_locus_curve and number_of_iterations contradict each other: no iterations "
                        "leave edges of the mesh, and one or more of them give a curve through the faces");
  const bool is_of_edges = curve.value_or(by_iterations) == Curve::MESH_EDGES;
  return {curve.value_or(by_iterations), is_of_edges ? 0 : iterations.value_or(enough)};
}

template <typename NamedParameters>
Curve_parameters read_curve(const NamedParameters& np)
{
  using parameters::get_parameter;
  std::optional<Curve> curve;
  std::optional<std::size_t> iterations;
  if constexpr(is_given<NamedParameters, internal_np::cut_locus_curve_t>())
    curve = get_parameter(np, internal_np::cut_locus_curve);
  if constexpr(is_given<NamedParameters, internal_np::number_of_iterations_t>())
    iterations = to_count(get_parameter(np, internal_np::number_of_iterations), "number_of_iterations");
  return curve_parameters(curve, iterations);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_METHOD_PARAMETERS_H
