// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "solvers.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Exact_geodesic_solver.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace {

struct Solver_entry
{
  const char* name;
  const char* description;
  std::unique_ptr<Cut_locus_solver> (*make)(const Mesh&, const CGAL::Cut_loci::Method&, Progress*, bool has_threads);
  CGAL::Cut_loci::Method method;
};

// Without the tag, TBB is not called: it starts threads even if it is told that there is one.
template <typename GeodesicSolver>
std::unique_ptr<Cut_locus_solver> make(const Mesh& mesh, const CGAL::Cut_loci::Method& method, Progress* progress,
                                       bool has_threads)
{
  const auto parameters =
    CGAL::parameters::geodesic_solver(GeodesicSolver()).cut_locus_method(method).visitor(Progress_visitor(progress));
  return has_threads
           ? std::make_unique<Cut_locus_solver>(mesh, parameters.concurrency_tag(CGAL::Parallel_if_available_tag()))
           : std::make_unique<Cut_locus_solver>(mesh, parameters);
}

template <typename GeodesicSolver>
Solver_entry entry(const char* name, const char* description)
{
  return {name, description, make<GeodesicSolver>,
          CGAL::Cut_loci::internal::Geodesic_solver_handle(GeodesicSolver()).cut_locus_method()};
}

// The first one is the default.
const Solver_entry solvers[] = {
  entry<CGAL::Exact_geodesic_solver>("exact", "exact geodesic distances"),
  entry<CGAL::Shortest_path_geodesic_solver>("cgal-exact", "CGAL's exact shortest paths"),
  entry<CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Intrinsic_Delaunay>>(
    "heat", "CGAL's heat method on an intrinsic Delaunay triangulation"),
  entry<CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>>("heat-direct",
                                                                        "CGAL's heat method on the mesh as it is"),
  entry<CGAL::Graph_geodesic_solver>("graph", "shortest paths over edges and dual edges"),
};

const Solver_entry* find_solver(const std::string& name)
{
  const auto found =
    std::find_if(std::begin(solvers), std::end(solvers), [&](const auto& s) { return name == s.name; });
  return found == std::end(solvers) ? nullptr : found;
}

} // namespace

std::string default_solver_name()
{
  return solvers[0].name;
}

std::string solver_names()
{
  std::string result;
  for(const Solver_entry& s : solvers)
    result += std::string(" ") + s.name;
  return result;
}

std::string solver_descriptions()
{
  std::string result;
  for(const Solver_entry& s : solvers)
    result += std::string(result.empty() ? "  " : "\n  ") + s.name + ": " + s.description;
  return result;
}

CGAL::Cut_loci::Method default_method(const std::string& solver)
{
  const Solver_entry* const found = find_solver(solver);
  return found == nullptr ? CGAL::Cut_loci::Laplacian_method() : found->method;
}

std::string default_methods()
{
  std::string standard, laplacian;
  for(const Solver_entry& s : solvers)
  {
    std::string& names = std::holds_alternative<CGAL::Cut_loci::Default_method>(s.method) ? standard : laplacian;
    names += (names.empty() ? "" : ", ") + std::string(s.name);
  }
  return "default with the solver " + standard + ", laplacian with " + laplacian;
}

std::unique_ptr<Cut_locus_solver> make_solver(const std::string& name, const CGAL::Cut_loci::Method& method,
                                              const Mesh& mesh, Progress* progress, bool has_threads)
{
  const Solver_entry* const solver = find_solver(name);
  if(solver == nullptr)
    throw std::invalid_argument("there is no solver '" + name + "'");
  return solver->make(mesh, method, progress, has_threads);
}
