// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SOLVERS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SOLVERS_H

#include <CGAL/Surface_mesh_cut_locus.h>

#include "Mesh.h"
#include "Progress.h"

#include <memory>
#include <string>

using Cut_locus_solver = CGAL::Surface_mesh_cut_locus<Mesh>;

std::string default_solver_name();
std::string solver_names();        // " a b c"
std::string solver_descriptions(); // a line for each

// the method for the distances of a solver, as the library chooses it
CGAL::Cut_loci::Method default_method(const std::string& solver);
std::string default_methods(); // "default with the solver a, laplacian with b and c"

// `progress` may be null.
std::unique_ptr<Cut_locus_solver> make_solver(const std::string& name, const CGAL::Cut_loci::Method& method,
                                              const Mesh& mesh, Progress* progress, bool has_threads);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SOLVERS_H
