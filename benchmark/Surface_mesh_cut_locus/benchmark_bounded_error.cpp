// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What a maximum relative error of the distances does to the curve through the faces, and what it saves: each line is a
// source on a mesh, and an error. Distances between curves are in mean edge lengths h, both ways; `found` is the share of
// the exact curve, of branches half as wide again as they have to be, within .3 h. The detour sees what is on none of the
// cut locus, and not what is missing. Times are those of the processor, from the source to the curve.

#include "command_line.h"
#include "completeness.h"
#include "curve_distance.h"
#include "detour.h"
#include "measuring.h"

#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using analytic::Mesh;
using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;
using Result = Solver::Result;
namespace params = CGAL::parameters;

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
  const double begin = measuring::cpu_time();
  solver.set_source(v, params::maximum_relative_error(error));
  Result result = solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
  return {result, measuring::cpu_time() - begin};
}

void measure(const std::string& name, const Mesh& mesh, const Settings& settings)
{
  Solver solver(mesh);
  const double h = analytic::mean_edge_length(mesh);
  for(int i = 0; i < settings.sources; ++i)
  {
    const auto n = mesh.number_of_vertices();
    const Mesh::Vertex_index v(i == 0 ? (std::min)(Mesh::size_type(17), n - 1) : Mesh::size_type(i) * (n - 1) / 2);
    std::vector<Run> exact, clear;
    if(settings.compares)
    {
      exact.push_back(run(solver, v, 0.));
      const double width = 1.5 * solver.minimum_branch_width();
      const auto curve = params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES);
      clear.push_back(
        {solver.cut_locus(curve.cut_locus_method(CGAL::Cut_loci::Default_method().minimum_branch_width(width))), 0.});
    }
    for(double error : settings.errors)
    {
      const Run found = run(solver, v, error);
      const auto& graph = found.result.graph();
      std::printf("%s,%zu,%d,%g,%.4f,%.0f,%zu,%ld,%zu", name.c_str(), std::size_t(mesh.number_of_faces()), i, error,
                  found.seconds, measuring::peak_megabytes(), std::size_t(num_edges(graph)),
                  long(num_edges(graph)) - long(num_vertices(graph)) + 1,
                  CGAL::Cut_loci::compute_statistics(found.result).leaves);
      if(settings.compares)
      {
        const analytic::Polylines a = analytic::segments_of(exact.front().result),
                                  b = analytic::segments_of(found.result);
        const analytic::Deviation there = analytic::deviation(b, a, h / 5.), back = analytic::deviation(a, b, h / 5.);
        std::printf(",%.4f,%.5f,%.3f,%.5f,%.3f,%.4f", exact.front().seconds, there.mean / h, there.max / h,
                    back.mean / h, back.max / h,
                    curve_measures::completeness(clear.front().result, found.result, 0.3 * h));
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
  const po::variables_map values = command_line::read(argc, argv, options, "mesh");
  settings.compares = values.count("no-exact") == 0;
  settings.measures_detour = values.count("detour") > 0;
  std::puts("mesh,faces,source,error,seconds,peak_mb,edges,cycles,leaves,exact_seconds,to_exact_mean,to_exact_max,"
            "from_exact_mean,from_exact_max,found,topology,detour_max");
  command_line::for_each_mesh<Mesh>(tori, meshes,
                                    [&](const std::string& name, const Mesh& mesh) { measure(name, mesh, settings); });
}
