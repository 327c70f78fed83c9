// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_METHOD_PARAMETERS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_METHOD_PARAMETERS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

namespace CGAL {
class Exact_geodesic_solver; // the default
}

namespace CGAL::Cut_loci::internal {

// The named parameters that depend on the method: which of them it takes, and their values.

template <typename NamedParameters, typename Tag>
constexpr bool is_given()
{
  return !parameters::is_default_parameter<NamedParameters, Tag>::value;
}

template <typename NamedParameters>
constexpr bool has_own_solver()
{
  return !std::is_same<typename internal_np::Lookup_named_param_def<internal_np::geodesic_solver_t, NamedParameters,
                                                                    Exact_geodesic_solver>::type,
                       Exact_geodesic_solver>::value;
}

// whether the method can be `Laplacian_method`, by the types of these parameters
template <typename NamedParameters>
constexpr bool may_be_laplacian()
{
  using internal_np::Lookup_named_param_def;
  using Given = typename Lookup_named_param_def<internal_np::cut_locus_method_t, NamedParameters, Default_method>::type;
  if constexpr(is_given<NamedParameters, internal_np::cut_locus_method_t>())
    return !std::is_same<Given, Default_method>::value && !std::is_same<Given, Polyhedral_method>::value;
  else
    return has_own_solver<NamedParameters>() || is_given<NamedParameters, internal_np::vertex_distance_map_t>();
}

[[noreturn]] inline void refuse_distances(const Method& method)
{
  throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD,
                      "the method " + std::string(name_of(method)) +
                        " needs the paths of the package's own exact solver, and not distances alone: leave "
                        "geodesic_solver and vertex_distance_map away, or pass "
                        "cut_locus_method(Cut_loci::Laplacian_method())");
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

// What would be ignored, and the caller would take the result for what it asked for.
template <typename NamedParameters>
constexpr void refuse_parameters_of_distances()
{
  static_assert(!is_given<NamedParameters, internal_np::face_is_excluded_map_t>(),
                "face_is_excluded_map is for exact distances alone: use Surface_mesh_exact_geodesics, or a mesh "
                "without these faces");
}

// The options for a cut locus: those of the method in force unless others are given.
template <typename NamedParameters>
Method read_options(const NamedParameters& np, const Method& in_force)
{
  if constexpr(is_given<NamedParameters, internal_np::cut_locus_method_t>())
  {
    const Method given = parameters::get_parameter(np, internal_np::cut_locus_method);
    const bool is_same = given.index() == in_force.index();
    const Laplacian_method* const laplacian = std::get_if<Laplacian_method>(&given);
    if(!is_same || (laplacian != nullptr && laplacian->laplacian_operator() &&
                    operator_of(*laplacian) != operator_of(std::get<Laplacian_method>(in_force))))
      throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD,
                          std::string(is_same ? "the Laplacian operator" : "the method") + " of the parameter " +
                            "cut_locus_method(" + name_of(given) + "()) is not that of " + name_of(in_force) +
                            ", which is in force: give it to the constructor of Surface_mesh_cut_locus, too");
    return given;
  }
  else
    return in_force;
}

inline std::size_t to_count(long value, const char* name)
{
  if(value < 0)
    throw Invalid_input(Cause::INVALID_PARAMETER, std::string("the option ") + name + " must not be negative");
  return static_cast<std::size_t>(value);
}

// `minimum_length` is in units of `diagonal`.
template <typename Options, typename Thresholds>
void read_least_branch(const Options& options, double diagonal, Thresholds& thresholds)
{
  const std::size_t edges = to_count(options.minimum_branch_edges(), "minimum_branch_edges");
  thresholds.minimum_edges = static_cast<Index>((std::min)(edges, static_cast<std::size_t>(null_index)));
  thresholds.minimum_length = options.minimum_branch_length();
  if(!(thresholds.minimum_length >= 0.))
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "the minimum length of a branch must be a number that is not negative");
  thresholds.minimum_length *= diagonal;
}

inline Branch_thresholds read_branch_thresholds(const Laplacian_method& options, double diagonal)
{
  Branch_thresholds result;
  result.gradient_angle = options.gradient_angle_threshold();
  result.laplacian = options.laplacian_threshold();
  result.policy = options.filter_policy();
  if(!(result.gradient_angle >= 0. && result.gradient_angle <= geodesic_pi))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the threshold for the gradient angle must be an angle from 0 to pi");
  if(std::isnan(result.laplacian))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the threshold for the Laplacian is not a number");
  read_least_branch(options, diagonal, result);
  return result;
}

// None leave edges of the mesh.
inline Smoothing_parameters read_smoothing(const Laplacian_method& options, Curve curve)
{
  const std::size_t iterations = to_count(options.number_of_iterations(), "number_of_iterations");
  if(iterations == 0)
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "the option number_of_iterations must not be 0: for edges of the mesh "
                        "pass cut_locus_curve(Cut_loci::Curve::MESH_EDGES)");
  Smoothing_parameters result;
  result.number_of_iterations = curve == Curve::MESH_EDGES ? 0 : static_cast<Index>(iterations);
  return result;
}

// The width is in units of `diagonal`, but for that of `by_default`, a length. Who asks for one of both gets all that
// passes it. No two points in space are farther apart than 1; of lengths alone nothing is known.
template <typename Options>
Exact_tree_thresholds read_exact_tree_thresholds(const Options& options, const Exact_tree_thresholds& by_default,
                                                 double diagonal, bool is_intrinsic)
{
  Exact_tree_thresholds result = by_default;
  if(options.minimum_branch_gap() || options.minimum_branch_width())
  {
    result.enclosed = (std::numeric_limits<double>::infinity)();
    result.gap = options.minimum_branch_gap().value_or(0.);
    const double width = options.minimum_branch_width().value_or(0.);
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
  if(options.minimum_branch_curvature())
  {
    result.noise = {};
    result.enclosed = *options.minimum_branch_curvature();
    if(!(result.enclosed >= 0. && result.enclosed <= 4. * geodesic_pi))
      throw Invalid_input(Cause::INVALID_PARAMETER,
                          "the minimum curvature of a branch must be an angle from 0 to 4 pi, that of a sphere");
  }
  if(!(result.gap >= 0. && result.gap <= geodesic_pi))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the minimum gap of a branch must be an angle from 0 to pi");
  read_least_branch(options, diagonal, result);
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

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_METHOD_PARAMETERS_H
