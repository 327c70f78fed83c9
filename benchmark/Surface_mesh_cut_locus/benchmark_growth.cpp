// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Time of each stage, and memory, against the number of faces, for each solver and method, as comma-separated values.
// `scripts/benchmark` runs it and draws the plots.
//
//   benchmark_growth [--faces N...] [--largest SOLVER=N...] [--trials N] [--only SOLVER...]
//
// The meshes are jittered tori. Each line is a process of its own, so that the peak of the memory is its own, and has
// the processor time of the median run: seconds that other programs take do not count. A run is one source, with the
// object for the mesh at hand; what is done once per mesh is the column `mesh_s`, its memory and all other the peak
// less what the mesh itself takes.

#include "jittered_torus.h"
#include "measuring.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace params = CGAL::parameters;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::Stage;

using measuring::median;

// A torus of radii 1 and 0.4 whose faces are about as long as wide, and irregular.
Mesh torus(std::size_t faces)
{
  const std::size_t n = static_cast<std::size_t>(std::sqrt(faces * 0.5 / 0.4)), m = faces / 2 / n;
  return jittered_torus<Mesh>(n, m);
}

// Adds up the processor time of each stage since the last reset.
class Stage_clock : public CGAL::Cut_loci::Default_visitor
{
public:
  void start_stage(Stage) { start_ = measuring::cpu_time(); }
  void end_stage(Stage stage) { seconds_[stage] += measuring::cpu_time() - start_; }
  double operator[](Stage stage) const { return seconds_.count(stage) ? seconds_.at(stage) : 0.; }
  void reset() { seconds_.clear(); }

private:
  double start_ = 0.;
  std::map<Stage, double> seconds_;
};

struct Figures
{
  double faces, mesh, distance, strength, tree, homology, filter, memory;
};

template <typename Solver>
Figures measure(std::size_t faces, const Solver& solver, Method method, int trials)
{
  const Mesh mesh = torus(faces);
  const double before = measuring::peak_megabytes();
  Stage_clock clock;
  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(
    mesh, params::geodesic_solver(solver).cut_locus_method(method).visitor(std::ref(clock)));
  cut_loci.set_source(*mesh.vertices().begin());
  const double first = clock[Stage::PREPROCESSING] + clock[Stage::DISTANCE];

  std::map<Stage, std::vector<double>> times;
  for(int i = 0; i < trials; ++i)
  {
    clock.reset();
    cut_loci.set_source(
      *(mesh.vertices_begin() + Mesh::size_type(i) * mesh.number_of_vertices() / Mesh::size_type(trials)));
    cut_loci.cut_locus();
    for(Stage stage : {Stage::DISTANCE, Stage::STRENGTH, Stage::TREE, Stage::HOMOLOGY, Stage::FILTER})
      times[stage].push_back(clock[stage]);
  }
  // the first of these sources is the one before, for which the solver made what it needs once
  return {double(num_faces(mesh)),        (std::max)(0., first - times[Stage::DISTANCE].front()),
          median(times[Stage::DISTANCE]), median(times[Stage::STRENGTH]),
          median(times[Stage::TREE]),     median(times[Stage::HOMOLOGY]),
          median(times[Stage::FILTER]),   measuring::peak_megabytes() - before};
}

struct Solver_case
{
  std::string name;
  std::size_t largest; // number of faces by default
  std::function<Figures(std::size_t, int)> run;
};

std::vector<Solver_case> solver_cases()
{
  using Heat = CGAL::Heat_method_geodesic_solver<>;
  using Direct_heat = CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>;
  const std::size_t any = 10000000;
  return {
    {"exact-default", any,
     [](std::size_t n, int k) { return measure(n, CGAL::Exact_geodesic_solver(), Default_method(), k); }},
    {"exact-laplacian", any,
     [](std::size_t n, int k) { return measure(n, CGAL::Exact_geodesic_solver(), Laplacian_method(), k); }},
    {"graph", any,
     [](std::size_t n, int k) { return measure(n, CGAL::Graph_geodesic_solver(), Laplacian_method(), k); }},
    {"heat-direct", 300000, [](std::size_t n, int k) { return measure(n, Direct_heat(), Laplacian_method(), k); }},
    {"heat", 300000, [](std::size_t n, int k) { return measure(n, Heat(), Laplacian_method(), k); }},
    {"cgal-exact", 100000,
     [](std::size_t n, int) { return measure(n, CGAL::Shortest_path_geodesic_solver(), Laplacian_method(), 1); }}};
}

// In a process of its own. Returns false if it has failed.
bool measure_apart(const Solver_case& solver, std::size_t faces, int trials, Figures& figures)
{
  int channel[2];
  if(pipe(channel) != 0)
    return false;
  std::fflush(stdout);
  const pid_t child = fork();
  if(child == 0)
  {
    bool written = false;
    try
    {
      const Figures result = solver.run(faces, trials);
      written = write(channel[1], &result, sizeof(result)) == ssize_t(sizeof(result));
    }
    catch(const std::exception& error)
    {
      std::cerr << solver.name << ", " << faces << " faces: " << error.what() << "\n";
    }
    _exit(written ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(channel[1]);
  const bool is_read = child > 0 && read(channel[0], &figures, sizeof(figures)) == ssize_t(sizeof(figures));
  close(channel[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  return is_read;
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::size_t> sizes;
  std::vector<std::string> limits, only;
  int trials = 3;
  po::options_description options("Time and memory against the number of faces");
  options.add_options()("help", "print this")(
    "faces", po::value(&sizes)->multitoken()->default_value({10000, 100000}, "10000 100000"), "sizes of the meshes")(
    "largest", po::value(&limits)->multitoken(), "SOLVER=N: no mesh of more than N faces for this solver")(
    "only", po::value(&only)->multitoken(), "solvers (default: all)")("trials", po::value(&trials)->default_value(3),
                                                                      "sources; each figure is the median");
  po::variables_map values;
  std::vector<Solver_case> solvers = solver_cases();
  try
  {
    po::store(po::parse_command_line(argc, argv, options), values);
    po::notify(values);
    for(const std::string& limit : limits)
    {
      const std::size_t sign = limit.find('=');
      bool is_known = false;
      for(Solver_case& s : solvers)
        if(sign != std::string::npos && s.name == limit.substr(0, sign))
        {
          s.largest = std::strtoul(limit.c_str() + sign + 1, nullptr, 10);
          is_known = true;
        }
      if(!is_known)
        throw po::error("--largest takes SOLVER=N, not '" + limit + "'");
    }
  }
  catch(const po::error& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  if(values.count("help") || trials < 1)
  {
    std::cout << options;
    return trials < 1 ? EXIT_FAILURE : EXIT_SUCCESS;
  }

  std::puts("solver,faces,mesh_s,distance_s,strength_s,tree_s,homology_s,filter_s,source_s,memory_mb");
  for(const Solver_case& solver : solvers)
  {
    if(!only.empty() && std::find(only.begin(), only.end(), solver.name) == only.end())
      continue;
    for(std::size_t faces : sizes)
    {
      Figures f;
      if(faces > solver.largest || !measure_apart(solver, faces, trials, f))
        continue;
      std::printf("%s,%.0f,%.5f,%.5f,%.5f,%.5f,%.5f,%.6f,%.5f,%.1f\n", solver.name.c_str(), f.faces, f.mesh, f.distance,
                  f.strength, f.tree, f.homology, f.filter, f.distance + f.strength + f.tree + f.homology + f.filter,
                  f.memory);
      std::fflush(stdout);
    }
  }
}
