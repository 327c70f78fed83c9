// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_OPTIONS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_OPTIONS_H

#include "Input_mesh.h"

#include <CGAL/Cut_loci/cut_locus_method.h>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using CGAL::Cut_loci::Kept_part;

// What the command line asks for; what is not set is left to the library's defaults.
struct Options
{
  std::string mesh;         // "-": standard input
  std::string input_format; // empty: see `load_file()`
  Repair repair = Repair::WELD;
  std::vector<std::size_t> sources;
  std::vector<std::array<double, 3>> source_points; // numbered behind the vertices
  std::optional<std::array<double, 3>> from_view;   // the source of each component is what is nearest in this direction
  std::string each_source;                          // a file of sources, each of which gets a cut locus
  std::size_t part = 1, number_of_parts = 1;        // of that file
  unsigned threads = 1;
  std::vector<std::vector<std::size_t>> source_edges; // vertices along edges
  bool source_border = false;
  std::string solver;
  std::optional<double> maximum_relative_error; // of the distances
  std::optional<double> angle;
  std::optional<double> laplacian;
  std::optional<bool> grow; // or prune
  std::optional<std::size_t> minimum_branch_edges;
  std::optional<double> minimum_branch_length;
  std::optional<double> minimum_branch_gap;
  std::optional<double> minimum_branch_curvature;
  std::optional<double> minimum_branch_width;
  std::optional<std::size_t> smoothing;       // iterations
  std::optional<CGAL::Cut_loci::Curve> curve; // null: see `curve_of()`
  CGAL::Cut_loci::Method method;              // which one; its options are below
  std::string method_name;
  std::vector<std::string> outputs;
  std::optional<std::array<double, 3>> view; // the direction from which pictures look
  std::string edges;
  std::string cells; // a file for the surface with the source nearest to each face
  std::string surface;
  std::string uv;
  std::string seams;
  std::string parameterization;
  double maximum_stretch = 2.; // of a chart, unless the detail of seams is given
  std::string unfold;
  std::string report;
  Kept_part kept = Kept_part::ALL;
  bool check = false;              // the topology, the detour and the distances of the result
  bool check_completeness = false; // and what it lacks
  bool is_quiet = false;
  std::string text; // what was asked for in place of a cut locus: help, or the version
};

inline std::size_t number_of_source_points(const Options& options)
{
  return options.sources.size() + options.source_points.size();
}

// whether sources that are curves are asked for
inline bool has_curves(const Options& options)
{
  return !options.source_edges.empty() || options.source_border;
}

// whether all components are cut open, and not only that of the source
inline bool has_atlas(const Options& options)
{
  return !options.uv.empty() || !options.seams.empty();
}

struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Numbers as text: `option` is what a message names. They throw `Usage_error`.
double to_number(const std::string& text, const std::string& option);
std::size_t to_count(const std::string& text, const std::string& option);

// where the results of many sources are until all are there
std::string part_of_results(const Options& options);

// Throws `Usage_error`.
Options parse_command_line(int argc, char* argv[]);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_OPTIONS_H
