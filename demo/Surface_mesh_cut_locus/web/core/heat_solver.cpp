// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"

#include <CGAL/Heat_method_geodesic_solver.h>

std::unique_ptr<Solver> make_heat_solver(const Mesh& mesh)
{
  return std::make_unique<Solver>(
    mesh, CGAL::parameters::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()).visitor(Stage_reporter()));
}
