// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_SOLVERS_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_SOLVERS_H

#include "Input.h"
#include "Progress.h"

#include <CGAL/Surface_mesh_cut_locus.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;

// The parameters of `Surface_mesh_cut_locus::cut_locus()`; those that are not given have the library's defaults.
struct Thresholds
{
  std::optional<double> minimum_branch_width, minimum_branch_gap, minimum_branch_curvature;
  std::optional<double> gradient_angle_threshold, laplacian_threshold;
  std::optional<CGAL::Cut_loci::Filter_policy> filter_policy;
  std::optional<long> minimum_branch_edges, number_of_iterations;
  std::optional<double> minimum_branch_length;
  std::optional<CGAL::Cut_loci::Curve> curve;
  std::optional<bool> voronoi, medial;
};

// `name` is one of solver_names(); the lengths, one for each edge, are empty if they are the distances between the points.
// Mesh and progress must outlive the solver.
std::unique_ptr<Solver> make_solver(const std::string& name, const std::optional<CGAL::Cut_loci::Method>& method,
                                    std::optional<CGAL::Cut_loci::Laplacian_operator> laplacian_operator,
                                    const std::vector<double>& edge_lengths, const Mesh& mesh, Progress& progress);

// The parameters of `Surface_mesh_cut_locus::set_sources()`.
struct Source_parameters
{
  double snapping_tolerance = 1e-10, maximum_relative_error = 0.;
  std::vector<Source_curve> curves;
  bool border = false;
  // of each vertex to the nearest source, if they are known: then there is no relative error
  std::optional<std::vector<double>> distances;

  bool has_curves() const { return border || !curves.empty(); }
};

void set_source(Solver& solver, const Source& source, const Source_parameters& parameters);
void set_sources(Solver& solver, const std::vector<Source>& sources, const Source_parameters& parameters);

Cut_locus compute_cut_locus(const Solver& solver, const Thresholds& thresholds);

// Those that take distances from CGAL are compiled on their own: they take long.
using Laplacian_operator = CGAL::Cut_loci::Laplacian_operator;
std::unique_ptr<Solver> make_cgal_exact_solver(const Mesh&, const CGAL::Cut_loci::Laplacian_method&, Progress&);
std::unique_ptr<Solver> make_heat_solver(const Mesh&, const CGAL::Cut_loci::Laplacian_method&, Progress&);
std::unique_ptr<Solver> make_heat_direct_solver(const Mesh&, const CGAL::Cut_loci::Laplacian_method&, Progress&);

template <typename GeodesicSolver>
std::unique_ptr<Solver> make_laplacian_solver(const Mesh& mesh, const CGAL::Cut_loci::Laplacian_method& method,
                                              Progress& progress)
{
  return std::make_unique<Solver>(
    mesh, CGAL::parameters::geodesic_solver(GeodesicSolver()).cut_locus_method(method).visitor(std::ref(progress)));
}

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_SOLVERS_H
