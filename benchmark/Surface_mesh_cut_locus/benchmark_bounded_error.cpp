// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What a maximum relative error of the distances does to the curve through the faces, and what it saves: each line is a
// source on a mesh, and an error. Distances between curves are in mean edge lengths h, both ways; `found` is the share of
// the exact curve, of branches half as wide again as they have to be, within .3 h. The detour sees what is on none of the
// cut locus, and not what is missing. Times are those of the processor, from the source to the curve.

#include "completeness.h"
#include "curve_distance.h"
#include "detour.h"
#include "jittered_torus.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace {

using Kernel = analytic::Kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;
using Result = Solver::Result;
namespace params = CGAL::parameters;

double cpu_time()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.;
}

analytic::Polylines polylines_of(const Result& result)
{
  analytic::Polylines polylines;
  const auto& graph = result.graph();
  for(const auto e : CGAL::make_range(edges(graph)))
    polylines.push_back({graph[source(e, graph)].point, graph[target(e, graph)].point});
  return polylines;
}

std::size_t number_of_leaves(const Result& result)
{
  const auto range = vertices(result.graph());
  return std::size_t(
    std::count_if(range.first, range.second, [&](auto v) { return out_degree(v, result.graph()) == 1; }));
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

struct Settings
{
  std::vector<double> errors;
  int sources;
  bool compares, measures_detour;
};

struct Run
{
  Result result;
  double seconds;
};

Run run(Solver& solver, Mesh::Vertex_index v, double error)
{
  const double begin = cpu_time();
  solver.set_source(v, params::maximum_relative_error(error));
  Result result = solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
  return {result, cpu_time() - begin};
}

void measure(const std::string& name, const Mesh& mesh, const Settings& settings)
{
  Solver solver(mesh);
  const double h = mean_edge_length(mesh);
  for(int i = 0; i < settings.sources; ++i)
  {
    const auto n = mesh.number_of_vertices();
    const Mesh::Vertex_index v(i == 0 ? (std::min)(Mesh::size_type(17), n - 1) : Mesh::size_type(i) * (n - 1) / 2);
    std::vector<Run> exact, clear;
    if(settings.compares)
    {
      exact.push_back(run(solver, v, 0.));
      const double width = 1.5 * solver.minimum_branch_width(), gap = 1.5 * solver.minimum_branch_gap();
      const auto curve = params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES);
      clear.push_back({solver.cut_locus(curve.minimum_branch_width(width).minimum_branch_gap(gap)), 0.});
    }
    for(double error : settings.errors)
    {
      const Run found = run(solver, v, error);
      const auto& graph = found.result.graph();
      std::printf("%s,%zu,%d,%g,%.4f,%.0f,%zu,%ld,%zu", name.c_str(), std::size_t(mesh.number_of_faces()), i, error,
                  found.seconds, peak_memory(), std::size_t(num_edges(graph)),
                  long(num_edges(graph)) - long(num_vertices(graph)) + 1, number_of_leaves(found.result));
      if(settings.compares)
      {
        const analytic::Polylines a = polylines_of(exact.front().result), b = polylines_of(found.result);
        const analytic::Deviation there = analytic::deviation(b, a, h / 5.), back = analytic::deviation(a, b, h / 5.);
        std::printf(",%.4f,%.5f,%.3f,%.5f,%.3f,%.4f", exact.front().seconds, there.mean / h, there.max / h,
                    back.mean / h, back.max / h,
                    curve_measures::completeness(clear.front().result, 0., found.result, 0.3 * h));
      }
      else
        std::printf(",,,,,,");
      if(settings.measures_detour)
      {
        const auto m = curve_measures::measure(mesh, found.result);
        std::printf(",%s,%.4f\n", m.topology_fault.empty() ? "right" : m.topology_fault.c_str(), m.max);
      }
      else
        std::puts(",,");
      std::fflush(stdout);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> meshes;
  std::vector<std::size_t> tori;
  Settings settings;
  po::options_description options(
    "benchmark_bounded_error [OPTION]... [MESH]...: cut loci from distances with an error");
  options.add_options()("help", "print this")("mesh", po::value(&meshes), "files of triangle meshes")(
    "torus", po::value(&tori)->multitoken(), "jittered tori of about so many faces")(
    "errors", po::value(&settings.errors)->multitoken()->default_value({1e-5, 1e-4, 1e-3, 1e-2}, "1e-5 ... 1e-2"),
    "maximum relative errors")("sources", po::value(&settings.sources)->default_value(1), "number of sources")(
    "no-exact", "without the exact curve to compare with")("detour", "measure detours");
  po::variables_map values;
  try
  {
    po::positional_options_description positional;
    positional.add("mesh", -1);
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), values);
    po::notify(values);
  }
  catch(const po::error& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  if(values.count("help"))
  {
    std::cout << options;
    return EXIT_SUCCESS;
  }
  settings.compares = values.count("no-exact") == 0;
  settings.measures_detour = values.count("detour") > 0;
  std::puts("mesh,faces,source,error,seconds,peak_mb,edges,cycles,leaves,exact_seconds,to_exact_mean,to_exact_max,"
            "from_exact_mean,from_exact_max,found,topology,detour_max");
  try
  {
    for(std::size_t faces : tori)
    {
      const auto m = static_cast<std::size_t>(std::sqrt(0.2 * double(faces)));
      measure("jittered_torus", jittered_torus<Mesh>(5 * m / 2, m), settings);
    }
    for(const std::string& file : meshes)
    {
      Mesh mesh;
      if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
        throw std::runtime_error("'" + file + "' holds no triangle mesh");
      measure(file.substr(file.find_last_of('/') + 1), mesh, settings);
    }
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
