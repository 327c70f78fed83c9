// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_SOLVERS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_SOLVERS_H

#include "border_loops.h"

#include <CGAL/Surface_mesh_cut_locus.h>

#include <memory>
#include <vector>

using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;

// Tells the page which stage runs, and how far it is.
struct Stage_reporter
{
  void start_stage(CGAL::Cut_loci::Stage stage) const;
  void end_stage(CGAL::Cut_loci::Stage stage) const;
  void progress(CGAL::Cut_loci::Stage stage, double share) const;
};

// Each solver of distances is compiled on its own: they take long.
std::unique_ptr<Solver> make_exact_solver(const Mesh& mesh, const CGAL::Cut_loci::Method& method);
std::unique_ptr<Solver> make_graph_solver(const Mesh& mesh);
std::unique_ptr<Solver> make_heat_solver(const Mesh& mesh);

// The page has the same numbers.
using CGAL::Cut_loci::Kept_part;

// The thresholds of all methods: each takes its own. What is not a number stands for the default of the library.
struct Thresholds
{
  double width; // of the methods that know the paths, a part of the diagonal
  Kept_part keeps;
  double angle; // and these of the other one
  double laplacian;
  double minimum_edges;
  double minimum_length;
  bool grows;
  unsigned int smoothing;
};

// All methods take points and curves; curves have no relative error.
void set_sources(Solver& solver, const std::vector<Location>& points, const std::vector<Edge_curve>& curves,
                 double relative_error);
Cut_locus cut_locus(const Solver& solver, const Thresholds& thresholds, CGAL::Cut_loci::Curve curve);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_SOLVERS_H
