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
#include "component_charts.h"
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

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Polyhedral_method;

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
  const auto full = make_solver("exact", Polyhedral_method(), input.mesh, nullptr, has_threads);
  set_source(options, input, *full);
  double width = options.minimum_branch_width.value_or(0.);
  if(width == 0.)
  {
    const auto usual = make_solver("exact", CGAL::Cut_loci::Default_method(), input.mesh, nullptr, has_threads);
    set_source(options, input, *usual);
    width = usual->minimum_branch_width();
  }
  return {
    width,
    share_near(input.mesh,
               full->cut_locus(CGAL::parameters::cut_locus_method(Polyhedral_method().minimum_branch_width(width))),
               cut_locus),
    share_near(input.mesh, cut_locus, full->cut_locus())};
}

// What is computed beside the cut locus, as far as it is asked for.
struct Results
{
  std::vector<std::vector<Mesh::Edge_index>> source_curves;
  std::optional<Cells> cells;
  std::optional<Atlas> atlas;
  std::optional<Unfolding> unfolding;
  std::optional<Check> checked;
};

void write_files(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus, const Results& results)
{
  write_outputs(options.outputs, cut_locus, input, results.source_curves, results.cells, options.view);
  if(!options.cells.empty())
    write_cells(options.cells, *results.cells);
  if(!options.surface.empty())
    write_surface(options, input, cut_locus);
  if(!options.edges.empty())
    write_edges(options.edges, cut_locus, input);
}

void write_summaries(const Options& options, const Options& filled_in, const Input_mesh& input,
                     const Cut_locus& cut_locus, const Results& results)
{
  if(input.component_size.size() > 1 && !has_atlas(options))
    std::cerr << component_note(options, input, cut_locus) << std::endl;
  std::cerr << moved_source_points(options, input.mesh, cut_locus)
            << summary(filled_in, curve_of(options), input.mesh, cut_locus) << std::endl;
  if(!options.surface.empty() && !cause_of_no_log_map(options).empty())
    std::cerr << "note: --surface has no log_map: " << cause_of_no_log_map(options) << std::endl;
  if(results.atlas)
    std::cerr << summary(*results.atlas, input) << std::endl;
  if(results.unfolding)
    std::cerr << summary(*results.unfolding) << std::endl;
}

// whether the result is right, as far as it is checked
bool run(const Options& given)
{
  const Thread_limit limit(given.threads);
  Progress progress(given.is_quiet);
  File_content content;
  const Input_mesh input = progress.run("read",
                                        [&]() {
    return read_mesh(given.mesh, given.repair, given.input_format, has_atlas(given) ? &content : nullptr);
  });
  const Mesh& mesh = input.mesh;
  if(!given.is_quiet && !input.repairs.is_empty())
    std::cerr << "repaired: " << description(input.repairs) << std::endl;
  const bool is_each_source = !given.each_source.empty(); // then stages are those of many sources at once
  const std::unique_ptr<Cut_locus_solver> solver =
    make_solver(given.solver, given.method, mesh, is_each_source ? nullptr : &progress, given.threads > 1);
  if(is_each_source)
    return compute_each_source(given, input, *solver, progress);
  const std::vector<Options> of_components =
    has_atlas(given) ? options_of_components(given, input) : std::vector<Options>{given};
  const Options& options = of_components.front(); // all but the atlas is about one component
  Results results;
  results.source_curves = set_source(options, input, *solver);
  const Cut_locus cut_locus = apply_thresholds(options, *solver);
  const bool has_picture = std::any_of(options.outputs.begin(), options.outputs.end(), is_picture_name);
  if(!options.cells.empty() || (has_picture && cut_locus.number_of_sources() > 1))
    progress.run("cells", [&]() { results.cells = make_cells(mesh, voronoi_diagram(options, *solver)); });
  progress.run("write", [&]() { write_files(options, input, cut_locus, results); });
  if(has_atlas(options))
    progress.run("flatten",
                 [&]()
                 {
      results.atlas = make_atlas(input, cut_locus, charts_of_components(of_components, input, *solver, cut_locus),
                                 options.parameterization);
      if(!options.uv.empty())
        write_atlas(options.uv, *results.atlas, input, content);
      if(!options.seams.empty())
        write_seams(options.seams, *results.atlas, input, content.soup);
    });
  if(!options.unfold.empty())
    progress.run("unfold",
                 [&]()
                 {
      results.unfolding = unfolded(mesh, cut_locus);
      write_unfolding(options.unfold, *results.unfolding);
    });
  if(options.check)
    progress.run("check",
                 [&]()
                 {
      results.checked = check(mesh, cut_locus, results.source_curves);
      if(options.check_completeness)
        results.checked->completeness = check_completeness(options, input, cut_locus);
    });
  const Options filled_in = fill_in_defaults(options, *solver);
  if(!options.report.empty())
    write_report(filled_in, curve_of(options), input, cut_locus, results.atlas, results.checked, progress);
  if(!options.is_quiet)
    write_summaries(options, filled_in, input, cut_locus, results);
  if(results.checked)
    std::cerr << summary(*results.checked) << std::endl;
  return !results.checked || results.checked->topology_fault.empty();
}

// The library names its parameters and functions as in C++.
std::string as_options(std::string message)
{
  const std::pair<const char*, const char*> words[] = {
    {"cut_locus_method(Cut_loci::Default_method())", "--method default"},
    {"cut_locus_method(Cut_loci::Laplacian_method())", "--method laplacian"},
    {"cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)", "--curve faces"},
    {"cut_locus_curve(Cut_loci::Curve::MESH_EDGES)", "--curve edges"},
    {"heat method with Heat_method_3::Intrinsic_Delaunay", "method of --solver heat"},
    {"Heat_method_geodesic_solver<Heat_method_3::Direct>", "--solver heat-direct"},
    {"the default solver", "--solver exact"},
    {" (CGAL::convex_hull_3() makes one); to flatten others see CGAL::cut_along_cut_locus()",
     "; others are flattened by --uv"}};
  for(const auto& [parameter, option] : words)
    boost::replace_all(message, parameter, option);
  return message;
}

int fail(const std::string& cause, int status)
{
  std::cerr << "cut_locus: " << as_options(cause) << std::endl;
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
