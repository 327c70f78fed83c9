// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The time of each stage of the method by the Laplacian, as seconds and as a fraction of CGAL's Surface_mesh_shortest_path::build_sequence_tree in the
// same run, and the memory of all stages but the distance.

#include "command_line.h"
#include "measuring.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Stage = CGAL::Cut_loci::Stage;
using measuring::Clock;
using measuring::median;
using measuring::seconds_since;

// Adds up the time of each stage in a run.
class Stage_times
{
public:
  void start_stage(Stage) { start_ = Clock::now(); }
  void end_stage(Stage stage) { run_[stage] += seconds_since(start_); }

  void end_run()
  {
    for(const auto& [stage, seconds] : run_)
      times_[stage].push_back(seconds);
    run_.clear();
  }
  double operator[](Stage stage) const { return times_.count(stage) ? median(times_.at(stage)) : 0.; }

private:
  Clock::time_point start_;
  std::map<Stage, double> run_;
  std::map<Stage, std::vector<double>> times_;
};

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  namespace params = CGAL::parameters;
  std::vector<std::string> files;
  int runs = 5, subdivisions = 0;
  double reference = 0.;
  po::options_description options("Time and memory of the stages. Usage: benchmark_stages [options] MESH...");
  options.add_options()("help", "print this")("mesh", po::value(&files), "meshes")(
    "runs", po::value(&runs)->default_value(5), "each figure is the median of so many runs")(
    "loop", po::value(&subdivisions)->default_value(0), "steps of Loop subdivision before")(
    "reference", po::value(&reference), "seconds to compare with, instead of a run of build_sequence_tree");
  const po::variables_map values = command_line::read(argc, argv, options, "mesh");
  if(files.empty())
    command_line::fail("no MESH: see --help");
  for(const std::string& file : files)
  {
    Mesh mesh = command_line::read_mesh<Mesh>(file);
    if(subdivisions > 0)
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, params::number_of_iterations(subdivisions));
    const Mesh::Vertex_index source(0);
    const double nv = static_cast<double>(mesh.number_of_vertices());

    double exact = reference;
    if(!values.count("reference"))
    {
      CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> shortest_paths(mesh);
      shortest_paths.add_source_point(source);
      const Clock::time_point start = Clock::now();
      shortest_paths.build_sequence_tree();
      exact = seconds_since(start);
    }

    // The distances come from the heat method and are handed in, so that the memory of no solver counts.
    auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
    {
      CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Direct> heat(mesh);
      heat.add_source(source);
      heat.estimate_geodesic_distances(distance);
    }

    Stage_times times;
    std::vector<double> thresholds;
    double memory = 0.;
    std::size_t cycles = 0;
    for(int run = 0; run < runs; ++run)
    {
      const double before = measuring::reset_peak_memory();
      CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(
        mesh, params::visitor(std::ref(times)).cut_locus_method(CGAL::Cut_loci::Laplacian_method()));
      cut_loci.set_source(source, params::vertex_distance_map(distance));
      memory = measuring::peak_memory() - before;
      // a slider that moves over the range in which branches come and go
      for(double angle = 0.2; angle < 2.; angle += 0.1)
        for(CGAL::Cut_loci::Filter_policy policy :
            {CGAL::Cut_loci::Filter_policy::PRUNING, CGAL::Cut_loci::Filter_policy::GROWING})
        {
          const Clock::time_point start = Clock::now();
          const auto result = cut_loci.cut_locus(
            params::cut_locus_method(
              CGAL::Cut_loci::Laplacian_method().gradient_angle_threshold(angle).filter_policy(policy))
              .cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
          thresholds.push_back(seconds_since(start));
          cycles = num_edges(result.graph()) + 1 - num_vertices(result.graph());
        }
      times.end_run();
    }

    std::printf("%s: %u faces, %zu cycles\n", file.c_str(), unsigned(mesh.number_of_faces()), cycles);
    const auto row = [&](const char* name, double seconds)
    { std::printf("  %-34s %10.6f s %12.7f\n", name, seconds, seconds / exact); };
    row("build_sequence_tree", exact);
    row("preprocess", times[Stage::PREPROCESSING]);
    row("strengths, tree and thinning", times[Stage::STRENGTH] + times[Stage::TREE]);
    row("homology", times[Stage::HOMOLOGY]);
    row("changed threshold, median", median(thresholds));
    row("changed threshold, slowest", *std::max_element(thresholds.begin(), thresholds.end()));
    std::printf("  %-34s %10.0f bytes per vertex\n", "peak memory but for the distance", memory / nv);
  }
}
