// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Computes the cut locus of a point on a mesh, and writes it in several formats.

#include "Input_mesh.h"
#include "Options.h"
#include "Progress.h"
#include "atlas.h"
#include "cells.h"
#include "check.h"
#include "each_source.h"
#include "log_map.h"
#include "output.h"
#include "report.h"
#include "set_source.h"
#include "solvers.h"
#include "surface_files.h"
#include "threads.h"
#include "thresholds.h"
#include "unfolding.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace {

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Method;

Unfolding unfolded(const Mesh& mesh, const Cut_locus& cut_locus)
{
  const auto& source = cut_locus.source();
  if(source.mesh_vertex != Mesh::null_vertex())
    return CGAL::Cut_loci::source_unfolding(mesh, source.mesh_vertex);
  return CGAL::Cut_loci::source_unfolding(mesh, source.location);
}

std::string component_note(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus)
{
  const bool is_chosen = number_of_source_points(options) > 0 || has_curves(options);
  return "the mesh has " + std::to_string(input.component_size.size()) + " components; this is about the one " +
         (is_chosen ? "of the source" : "with the largest area") + ", " +
         std::to_string(input.component_size[component_of_source(input, cut_locus)]) + " of " +
         std::to_string(input.mesh.number_of_faces());
}

// How much of the polyhedron's cut locus is there, of what is as wide as the thresholds ask for.
Completeness check_completeness(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus)
{
  const bool has_threads = options.threads > 1;
  const auto full = make_solver("exact", Method::POLYHEDRAL, input.mesh, nullptr, has_threads);
  set_source(options, input, *full);
  double width = options.minimum_branch_width.value_or(0.);
  if(width == 0.)
  {
    const auto usual = make_solver("exact", Method::DIRECTION, input.mesh, nullptr, has_threads);
    set_source(options, input, *usual);
    width = usual->minimum_branch_width();
  }
  return {width, share_near(input.mesh, full->cut_locus(CGAL::parameters::minimum_branch_width(width)), cut_locus),
          share_near(input.mesh, cut_locus, full->cut_locus())};
}

// whether the result is right, as far as it is checked
bool run(const Options& options)
{
  const Thread_limit limit(options.threads);
  Progress progress(options.is_quiet);
  const Input_mesh input =
    progress.run("read", [&]() { return read_mesh(options.mesh, options.repair, options.input_format); });
  const Mesh& mesh = input.mesh;
  if(!options.is_quiet && !input.repairs.is_empty())
    std::cerr << "repaired: " << description(input.repairs) << std::endl;
  const bool is_each_source = !options.each_source.empty(); // then stages are those of many sources at once
  const std::unique_ptr<Cut_locus_solver> solver =
    make_solver(options.solver, options.method, mesh, is_each_source ? nullptr : &progress, options.threads > 1);
  if(is_each_source)
    return compute_each_source(options, input, *solver, progress);
  const std::vector<std::vector<Mesh::Edge_index>> source_curves = set_source(options, input, *solver);
  const Curve curve = curve_of(options);
  const Cut_locus cut_locus = apply_thresholds(options, *solver);
  std::optional<Cells> cells;
  const bool has_picture = std::any_of(options.outputs.begin(), options.outputs.end(), is_picture_name);
  if(!options.cells.empty() || (has_picture && cut_locus.number_of_sources() > 1))
    progress.run("cells", [&]() { cells = make_cells(mesh, voronoi_diagram(options, *solver)); });
  progress.run("write",
               [&]()
               {
    write_outputs(options.outputs, cut_locus, input, source_curves, cells, options.view);
    if(!options.cells.empty())
      write_cells(options.cells, *cells);
    if(!options.surface.empty())
      write_surface(options, input, cut_locus);
    if(!options.edges.empty())
      write_edges(options.edges, cut_locus, input);
  });
  std::optional<Atlas> atlas;
  if(!options.uv.empty())
    progress.run("flatten",
                 [&]()
                 {
      atlas = cut_locus.number_of_sources() > 1 || !source_curves.empty()
                ? make_atlas_of_cells(mesh, cut_locus, options.parameterization)
                : make_atlas(mesh, cut_locus, options.parameterization);
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
    progress.run("check",
                 [&]()
                 {
      checked = check(mesh, cut_locus, source_curves);
      if(options.check_completeness)
        checked->completeness = check_completeness(options, input, cut_locus);
    });
  if(!options.report.empty())
    write_report(fill_in_defaults(options, *solver), curve, input, cut_locus, atlas, checked, progress);
  const bool is_right = !checked || checked->topology_fault.empty();
  if(!options.is_quiet)
  {
    if(input.component_size.size() > 1)
      std::cerr << component_note(options, input, cut_locus) << std::endl;
    std::cerr << moved_source_points(options, mesh, cut_locus)
              << summary(fill_in_defaults(options, *solver), curve, mesh, cut_locus) << std::endl;
    if(!options.surface.empty() && !cause_of_no_log_map(options).empty())
      std::cerr << "note: --surface has no log_map: " << cause_of_no_log_map(options) << std::endl;
    if(atlas)
      std::cerr << summary(*atlas) << std::endl;
    if(unfolding)
      std::cerr << summary(*unfolding) << std::endl;
  }
  if(checked)
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
    if(!options.text.empty())
    {
      std::cout << options.text;
      return EXIT_SUCCESS;
    }
    return run(options) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const Usage_error& error)
  {
    return fail(error.what(), wrong_usage);
  }
  catch(const Needs_repair& error)
  {
    return fail(error.what() + std::string(" (--repair weld takes it)"), EXIT_FAILURE);
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
