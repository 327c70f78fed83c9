// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Computes the cut locus of a point on a mesh, and writes it in several formats.

#include "Mesh.h"
#include "Options.h"
#include "Progress.h"
#include "atlas.h"
#include "check.h"
#include "output.h"
#include "report.h"
#include "solvers.h"
#include "unfolding.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>

namespace {

void set_source(const Options& options, const Mesh& mesh, Cut_locus_solver& solver)
{
  if(options.source_point)
  {
    const auto& p = *options.source_point;
    solver.set_source(closest_location(mesh, Kernel::Point_3(p[0], p[1], p[2])));
    return;
  }
  if(options.source)
  {
    if(*options.source >= mesh.number_of_vertices())
      throw Usage_error("--source " + std::to_string(*options.source) +
                        " is out of range: the mesh has the vertices 0 to " +
                        std::to_string(mesh.number_of_vertices() - 1));
    solver.set_source(Mesh::Vertex_index(static_cast<Mesh::size_type>(*options.source)));
    return;
  }
  Mesh::Vertex_index v(0);
  while(mesh.is_isolated(v)) // there is a face, thus an end
    ++v;
  solver.set_source(v);
}

Cut_locus apply_thresholds(const Options& options, const Cut_locus_solver& solver, std::size_t smoothing)
{
  using CGAL::Cut_loci::Filter_policy;
  using CGAL::Cut_loci::Method;
  const double least_length = options.minimum_branch_length.value_or(0.);
  if(options.method == Method::POLYHEDRAL)
    return solver.cut_locus(CGAL::parameters::minimum_branch_gap(options.minimum_branch_gap.value_or(0.))
                              .minimum_branch_width(options.minimum_branch_width.value_or(0.)));
  if(options.method == Method::DIRECTION)
  {
    const auto parameters = CGAL::parameters::minimum_branch_edges(options.minimum_branch_edges.value_or(0))
                              .minimum_branch_length(least_length)
                              .number_of_iterations(smoothing);
    return options.strength ? solver.cut_locus(parameters.strength_threshold(*options.strength))
                            : solver.cut_locus(parameters);
  }
  return solver.cut_locus(
    CGAL::parameters::gradient_angle_threshold(options.angle.value_or(solver.gradient_angle_threshold()))
      .laplacian_threshold(options.laplacian.value_or(-std::numeric_limits<double>::infinity()))
      .filter_policy(options.grow.value_or(false) ? Filter_policy::GROWING : Filter_policy::PRUNING)
      .minimum_branch_edges(options.minimum_branch_edges.value_or(solver.default_minimum_branch_edges()))
      .minimum_branch_length(least_length)
      .number_of_iterations(smoothing));
}

Unfolding unfolded(const Mesh& mesh, const Cut_locus& cut_locus)
{
  const auto& source = cut_locus.source();
  if(source.mesh_vertex != Mesh::null_vertex())
    return CGAL::Cut_loci::source_unfolding(mesh, source.mesh_vertex);
  return CGAL::Cut_loci::source_unfolding(mesh, source.location);
}

// whether the result is right, as far as it is checked
bool run(const Options& options)
{
  Progress progress(options.is_quiet);
  const Mesh mesh = progress.run("read", [&]() { return read_mesh(options.mesh); });
  const std::unique_ptr<Cut_locus_solver> solver = make_solver(options.solver, options.method, mesh, progress);
  set_source(options, mesh, *solver);
  const Cut_locus cut_locus = apply_thresholds(options, *solver, options.smoothing);
  const Cut_locus mesh_edges =
    options.edges.empty() || options.smoothing == 0 ? cut_locus : apply_thresholds(options, *solver, 0);
  progress.run("write",
               [&]()
               {
    write_outputs(options.outputs, cut_locus, mesh, options.view);
    if(!options.edges.empty())
      write_edges(options.edges, mesh_edges, mesh);
  });
  std::optional<Atlas> atlas;
  if(!options.uv.empty())
    progress.run("flatten",
                 [&]()
                 {
      atlas = make_atlas(mesh, cut_locus, options.parameterization);
      write_atlas(options.uv, *atlas);
    });
  std::optional<Unfolding> unfolding;
  if(!options.unfold.empty())
    progress.run("unfold",
                 [&]()
                 {
      unfolding = unfolded(mesh, cut_locus);
      write_unfolding(options.unfold, *unfolding);
    });
  std::optional<Check> checked;
  if(options.check)
    progress.run("check", [&]() { checked = check(mesh, cut_locus); });
  if(!options.report.empty())
    write_report(options, mesh, cut_locus, atlas, checked, progress);
  const bool is_right = !checked || checked->topology_fault.empty();
  if(!options.is_quiet)
  {
    std::cerr << summary(mesh, cut_locus) << std::endl;
    if(atlas)
      std::cerr << summary(*atlas) << std::endl;
    if(unfolding)
      std::cerr << summary(*unfolding) << std::endl;
  }
  if(checked && (!options.is_quiet || !is_right))
    std::cerr << summary(*checked) << std::endl;
  return is_right;
}

int fail(const std::string& cause, int status)
{
  std::cerr << "cut_locus: " << cause << std::endl;
  return status;
}

} // namespace

int main(int argc, char* argv[])
{
  constexpr int wrong_usage = 2;
  try
  {
    const Options options = parse_command_line(argc, argv);
    if(options.help)
    {
      std::cout << usage();
      return EXIT_SUCCESS;
    }
    return run(options) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const Usage_error& error)
  {
    return fail(error.what(), wrong_usage);
  }
  catch(const std::bad_alloc&)
  {
    return fail("there is not enough memory", EXIT_FAILURE);
  }
  catch(const std::exception& error)
  {
    return fail(error.what(), EXIT_FAILURE);
  }
}
