// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// How accurate the cut locus and the distances are with each solver and method, all with their defaults, as
// comma-separated values. `scripts/benchmark` runs it and draws the plot.
//
// The surface is a torus with its sources on the equators, where the cut locus is known in closed form. Columns:
// relative error of the distances to those of the exact solver (mean, max), and distances between curves in mean edge
// lengths: from the estimate to the truth (mean, max), and back.

#include "accuracy_benchmark.h"
#include "analytic_surfaces.h"
#include "curve_distance.h"
#include "remeshed_surface.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/exact_geodesic_distances.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace analytic;
namespace params = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using Vertex = Mesh::Vertex_index;

struct Case
{
  std::string name;
  Point source;
  std::function<Polylines(double)> truth; // sampled at a step
};

Mesh torus_mesh(const Torus& torus, double length, const std::string& cache)
{
  const std::string file = cache + "/torus_" + std::to_string(length) + ".off";
  Mesh mesh;
  if(!cache.empty() && std::ifstream(file).good() && CGAL::IO::read_OFF(file, mesh))
    return mesh;
  mesh = remeshed(torus, length);
  if(!cache.empty())
    CGAL::IO::write_OFF(file, mesh, params::stream_precision(17));
  return mesh;
}

template <typename Solver>
void run(const std::string& solver_name, const Solver& solver, Method method, const Case& test, Mesh mesh)
{
  const Vertex source = snap_vertex(mesh, test.source);
  const double h = mean_edge_length(mesh);
  auto exact = mesh.add_property_map<Vertex, double>("v:exact", 0.).first;
  CGAL::exact_geodesic_distances(mesh, source, exact);

  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(mesh, params::geodesic_solver(solver).cut_locus_method(method));
  cut_loci.set_source(source);
  const auto along_edges = cut_loci.cut_locus(params::cut_locus_curve(Curve::MESH_EDGES));
  const auto through_faces = cut_loci.cut_locus();
  double error_mean = 0., error_max = 0.;
  for(Vertex v : mesh.vertices())
    if(v != source)
    {
      const double error = std::abs(along_edges.distance(v) / exact[v] - 1.);
      error_mean += error / double(mesh.number_of_vertices() - 1);
      error_max = (std::max)(error_max, error);
    }

  const Polylines truth = test.truth(h / 5.);
  for(bool is_smooth : {false, true})
  {
    const Polylines estimate = segments_of(is_smooth ? through_faces : along_edges);
    const Deviation there = deviation(estimate, truth, h / 5.), back = deviation(truth, estimate, h / 5.);
    std::printf("%s,%u,%.5f,%s,%s,%s,%.2e,%.2e,%.3f,%.3f,%.3f,%.3f\n", test.name.c_str(),
                unsigned(mesh.number_of_faces()), h, solver_name.c_str(),
                std::holds_alternative<Default_method>(method) ? "default" : "laplacian", is_smooth ? "faces" : "edges",
                error_mean, error_max, there.mean / h, there.max / h, back.mean / h, back.max / h);
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::string cache;
  std::vector<double> lengths;
  po::options_description options("Accuracy with each solver and method");
  options.add_options()("help", "print this")("cache", po::value(&cache), "folder that keeps the generated meshes")(
    "length", po::value(&lengths)->multitoken()->default_value({0.064, 0.032, 0.022}, "0.064 0.032 0.022"),
    "edge lengths; the torus has radii 1 and 0.4");
  command_line::read(argc, argv, options);

  const Torus torus;
  const std::vector<Case> cases = {
    {"outer equator", torus.point(0., 0.), [&](double s) { return torus.cut_locus_of_outer_equator(0., s); }},
    {"inner equator", torus.point(1., pi), [&](double s) { return torus.cut_locus_of_inner_equator(1., s); }}};
  std::puts("source,faces,h,solver,method,curve,distance_error_mean,distance_error_max,to_truth_mean,to_truth_max,"
            "from_truth_mean,from_truth_max");
  for(double length : lengths)
  {
    const Mesh mesh = torus_mesh(torus, length, cache);
    for(const Case& c : cases)
    {
      run("exact", CGAL::Exact_geodesic_solver(), Default_method(), c, mesh);
      run("exact", CGAL::Exact_geodesic_solver(), Laplacian_method(), c, mesh);
      run("heat", CGAL::Heat_method_geodesic_solver<>(), Laplacian_method(), c, mesh);
      run("heat-direct", CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>(), Laplacian_method(), c, mesh);
      run("graph", CGAL::Graph_geodesic_solver(), Laplacian_method(), c, mesh);
    }
  }
}
