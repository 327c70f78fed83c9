// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// How far the computed cut locus is from the true one on surfaces where that is known, at several resolutions.
// All figures are in units of the mean edge length h: mean and max distance from the estimate to the truth, and from
// the truth to the estimate; the larger max is the two-sided Hausdorff distance.

#include "accuracy_benchmark.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Exact_geodesic_solver.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <cstdio>
#include <functional>
#include <iostream>
#include <optional>
#include <string>

namespace {

using namespace analytic;
using Cut_locus = CGAL::Cut_locus<Mesh, Point>;

struct Case
{
  std::string name;
  Point source;
  std::function<Polylines(double)> truth; // sampled at a step
};

struct Thresholds
{
  std::optional<double> angle, laplacian;
  std::size_t minimum_edges = 3;
  std::vector<unsigned int> smoothing = {0}; // numbers of iterations
};

template <typename Solver>
void run(const std::string& solver_name, const Solver& solver, const Case& test, Mesh mesh, const Thresholds& t)
{
  namespace params = CGAL::parameters;
  const Mesh::Vertex_index source = snap_vertex(mesh, test.source);
  const double h = mean_edge_length(mesh);
  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(
    mesh, params::geodesic_solver(solver).cut_locus_method(CGAL::Cut_loci::Laplacian_method()));
  cut_loci.set_source(source);
  const double angle = t.angle.value_or(CGAL::Cut_loci::Laplacian_method().gradient_angle_threshold());
  const double laplacian = t.laplacian.value_or(-1e300);
  const Polylines truth = test.truth(h / 5.);
  for(unsigned int iterations : t.smoothing)
  {
    const Cut_locus result = cut_loci.cut_locus(
      params::cut_locus_method(CGAL::Cut_loci::Laplacian_method()
                                 .gradient_angle_threshold(angle)
                                 .laplacian_threshold(laplacian)
                                 .minimum_branch_edges(t.minimum_edges)
                                 .number_of_iterations(iterations == 0 ? 1 : iterations))
        .cut_locus_curve(iterations == 0 ? CGAL::Cut_loci::Curve::MESH_EDGES : CGAL::Cut_loci::Curve::THROUGH_FACES));
    const Polylines estimate = segments_of(result);
    const Deviation e = deviation(estimate, truth, h / 5.), m = deviation(truth, estimate, h / 5.);
    std::printf("%-22s %7u %8.5f  %-10s %9u %5.2f %9.3g  %7.3f %7.2f  %7.3f %7.2f\n", test.name.c_str(),
                unsigned(mesh.number_of_faces()), h, solver_name.c_str(), iterations, angle,
                t.laplacian ? laplacian : -(std::numeric_limits<double>::infinity)(), e.mean / h, e.max / h, m.mean / h,
                m.max / h);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::string cache;
  std::vector<double> lengths, angles, laplacians;
  std::vector<std::string> solvers;
  std::vector<unsigned int> smoothing;
  std::size_t minimum_edges = 3;
  po::options_description options("Accuracy of the cut locus by the Laplacian against closed forms");
  options.add_options()("help", "print this")("cache", po::value(&cache), "folder that keeps the generated meshes")(
    "length", po::value(&lengths)->multitoken()->default_value({0.064, 0.032, 0.022}, "0.064 0.032 0.022"),
    "edge lengths; the torus has radii 1 and 0.4")("angle", po::value(&angles)->multitoken(),
                                                   "thresholds for the gradient angle (default: the library's)")(
    "laplacian", po::value(&laplacians)->multitoken(), "thresholds for the Laplacian (default: none)")(
    "min-branch-edges", po::value(&minimum_edges), "branches of fewer edges are removed")(
    "solver", po::value(&solvers)->multitoken()->default_value({"exact", "heat"}, "exact heat"),
    "exact, cgal-exact, heat, heat-direct, graph")("smoothing",
                                                   po::value(&smoothing)->multitoken()->default_value({0, 4}, "0 4"),
                                                   "numbers of smoothing iterations (0: edges of the mesh)");
  command_line::read(argc, argv, options);

  const Torus torus;
  const std::vector<Case> cases = {
    {"torus outer equator", torus.point(0., 0.), [&](double s) { return torus.cut_locus_of_outer_equator(0., s); }},
    {"torus inner equator", torus.point(1., pi), [&](double s) { return torus.cut_locus_of_inner_equator(1., s); }}};

  std::printf("%-22s %7s %8s  %-10s %9s %5s %9s  %7s %7s  %7s %7s\n", "surface and source", "faces", "h", "solver",
              "smoothing", "angle", "laplacian", "est mean", "max", "truth mean", "max");
  for(double length : lengths)
  {
    const Mesh mesh = cached_mesh(torus, "torus", length, cache);
    for(const Case& c : cases)
      for(const std::string& solver : solvers)
      {
        std::vector<Thresholds> thresholds;
        for(double a : angles)
          thresholds.push_back({a, std::nullopt, minimum_edges, smoothing});
        for(double l : laplacians)
          thresholds.push_back({std::nullopt, l, minimum_edges, smoothing});
        if(thresholds.empty())
          thresholds.push_back({std::nullopt, std::nullopt, minimum_edges, smoothing});
        for(const Thresholds& t : thresholds)
          if(solver == "exact")
            run(solver, CGAL::Exact_geodesic_solver(), c, mesh, t);
          else if(solver == "cgal-exact")
            run(solver, CGAL::Shortest_path_geodesic_solver(), c, mesh, t);
          else if(solver == "graph")
            run(solver, CGAL::Graph_geodesic_solver(), c, mesh, t);
          else if(solver == "heat")
            run(solver, CGAL::Heat_method_geodesic_solver<>(), c, mesh, t);
          else if(solver == "heat-direct")
            run(solver, CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>(), c, mesh, t);
          else
          {
            std::cerr << "unknown solver " << solver << "\n";
            return EXIT_FAILURE;
          }
      }
  }
}
