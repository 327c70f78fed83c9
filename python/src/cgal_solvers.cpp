// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Heat_method_geodesic_solver.h>

std::unique_ptr<Solver> make_cgal_exact_solver(const Mesh& mesh, const CGAL::Cut_loci::Laplacian_method& method,
                                               Progress& progress)
{
  return make_laplacian_solver<CGAL::Shortest_path_geodesic_solver>(mesh, method, progress);
}

std::unique_ptr<Solver> make_heat_solver(const Mesh& mesh, const CGAL::Cut_loci::Laplacian_method& method,
                                         Progress& progress)
{
  return make_laplacian_solver<CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Intrinsic_Delaunay>>(mesh, method,
                                                                                                           progress);
}

std::unique_ptr<Solver> make_heat_direct_solver(const Mesh& mesh, const CGAL::Cut_loci::Laplacian_method& method,
                                                Progress& progress)
{
  return make_laplacian_solver<CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>>(mesh, method, progress);
}
