// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The accuracy of the direction method with its defaults: on tori and triaxial ellipsoids, at several resolutions, and
// on jittered, anisotropic and noisy meshes. All figures are in units of the mean edge length h.
//
// Closed forms: distances between sampled curves. General sources: each point of the curve on an edge is verified by
// shooting the two geodesics that meet there, and each end by the conjugate point of the surface; the curve of mesh
// edges is then compared with the verified one. `away` is the maximum farther than 4 h from the ends.

#include "analytic_surfaces.h"
#include "curve_distance.h"
#include "direction_truth.h"
#include "remeshed_surface.h"

#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <string>

namespace {

using namespace analytic;
namespace params = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Method;

// Tells the time of the distance from that of all that follows it.
struct Clock : public CGAL::Cut_loci::Default_visitor
{
  double distance = 0., extraction = 0.;
  std::chrono::steady_clock::time_point start;

  void start_stage(CGAL::Cut_loci::Stage) { start = std::chrono::steady_clock::now(); }
  void end_stage(CGAL::Cut_loci::Stage stage)
  {
    const double t = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if(stage == CGAL::Cut_loci::Stage::DISTANCE)
      distance += t;
    else if(stage != CGAL::Cut_loci::Stage::PREPROCESSING)
      extraction += t;
  }
};

template <typename Surface>
Mesh cached_mesh(const Surface& surface, const std::string& name, double length, const std::string& cache)
{
  const std::string file = cache.empty() ? "" : cache + "/" + name + "_" + std::to_string(length) + ".off";
  Mesh mesh;
  if(!file.empty() && std::ifstream(file).good() && CGAL::IO::read_OFF(file, mesh))
    return mesh;
  mesh = remeshed(surface, length);
  if(!file.empty())
    CGAL::IO::write_OFF(file, mesh, CGAL::parameters::stream_precision(17));
  return mesh;
}

// Moves the vertices along the surface, by up to a quarter of an edge.
template <typename Surface>
Mesh jittered(const Surface& surface, Mesh mesh)
{
  const double h = mean_edge_length(mesh);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random(-0.25 * h, 0.25 * h);
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = surface.project(mesh.point(v) + Vector(random(generator), random(generator), random(generator)));
  return mesh;
}

// Moves the vertices along the normals, by a normal deviate of `amplitude` edges.
template <typename Surface>
Mesh noisy(const Surface& surface, Mesh mesh, double amplitude)
{
  const double h = mean_edge_length(mesh);
  std::mt19937 generator(2);
  std::normal_distribution<double> random(0., amplitude * h);
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + random(generator) * surface.normal(mesh.point(v));
  return mesh;
}

// Faces three times longer than wide.
Mesh anisotropic(const Torus& torus, double length)
{
  const int nu = static_cast<int>(2. * pi * (torus.R + torus.r) / (1.7 * length));
  const int nw = static_cast<int>(2. * pi * torus.r / (0.57 * length));
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nw; ++j)
      v.push_back(mesh.add_vertex(torus.point(2. * pi * i / nu, 2. * pi * j / nw)));
  const auto at = [&](int i, int j) { return v[(i % nu) * nw + j % nw]; };
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nw; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

Mesh anisotropic(const Ellipsoid& ellipsoid, double length)
{
  Ellipsoid stretched = ellipsoid;
  stretched.c *= 3.;
  Mesh mesh = remeshed(stretched, 1.5 * length);
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z() / 3.);
  return mesh;
}

template <typename Surface>
void run(const Surface& surface, const std::string& name, const std::string& variant, Mesh mesh, const Point& at,
         const std::function<Polylines(double)>& closed_form, double limit)
{
  const bool is_noisy = variant.find("noise") != std::string::npos;
  Shot_errors shot;
  Mesh::Vertex_index source;
  if(is_noisy) // the source stays where the noise has put it
  {
    source = *mesh.vertices().begin();
    for(Mesh::Vertex_index v : mesh.vertices())
      if(CGAL::squared_distance(mesh.point(v), at) < CGAL::squared_distance(mesh.point(source), at))
        source = v;
  }
  else
  {
    shot = shot_errors(surface, mesh, at, limit);
    source = snap_vertex(mesh, at);
  }
  const double h = mean_edge_length(mesh);
  Clock clock;
  CGAL::Surface_mesh_cut_locus<Mesh> solver(
    mesh, params::cut_locus_method(Method::DIRECTION).visitor(std::ref(clock)));
  solver.set_source(source); // warms up
  clock.distance = clock.extraction = 0.;
  solver.set_source(source);
  const auto through_faces = solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
  const double extraction = clock.extraction;
  Polylines curve = segments_of(through_faces), edges = segments_of(solver.cut_locus());
  const auto& g = through_faces.graph();
  int leaves = 0;
  for(auto v : CGAL::make_range(vertices(g)))
    leaves += degree(v, g) == 1;
  const int cycles = int(num_edges(g)) - int(num_vertices(g)) + 1;
  for(Polylines* lines : {&curve, &edges})
    for(auto& line : *lines)
      for(Point& p : line)
        p = surface.project(p);

  std::printf("%-16s %-12s %7u %7.4f", name.c_str(), variant.c_str(), unsigned(mesh.number_of_faces()), h);
  const Polylines truth = closed_form ? closed_form(h / 5.) : curve;
  if(closed_form)
  {
    const Deviation e = deviation(curve, truth, h / 5.), t = deviation(truth, curve, h / 5.);
    std::printf("  %6.4f %6.3f %6.3f", e.mean / h, e.max / h, t.max / h);
  }
  else
    std::printf("  %6s %6s %6s", "-", "-", "-");
  const double edge_error = (std::max)(deviation(edges, truth, h / 5.).max, deviation(truth, edges, h / 5.).max) / h;
  if(is_noisy && !closed_form)
    std::printf("  %6s", "-");
  else
    std::printf("  %6.3f", edge_error);
  if(is_noisy)
    std::printf("  %6s %6s %6s %4s", "-", "-", "-", "-");
  else
    std::printf("  %6.4f %6.3f %6.3f %4u", shot.mean, shot.max, shot.max_away, unsigned(shot.unverified));
  double end = 0.;
  for(double d : shot.ends)
    end = (std::max)(end, d);
  std::printf("  %6.3f %3u %3d %3d  %7.1f %7.1f\n", end, unsigned(shot.ends.size()), leaves, cycles,
              1e3 * clock.distance, 1e3 * extraction);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::string cache;
  std::vector<double> lengths;
  std::vector<std::string> variants;
  po::options_description options("Accuracy of the direction method");
  options.add_options()
    ("help", "print this")
    ("cache", po::value(&cache), "folder that keeps the generated meshes")
    ("length", po::value(&lengths)->multitoken()->default_value({0.08, 0.064, 0.04, 0.032}, "0.08 0.064 0.04 0.032"),
     "edge lengths; the torus has radii 1 and 0.4, the ellipsoid the half axes 1, 0.8, 0.6")
    ("variant", po::value(&variants)->multitoken()->default_value(
       {"isotropic", "jittered", "anisotropic", "noise_0.03", "noise_0.1", "noise_0.2"}, "all"),
     "isotropic, jittered, anisotropic, noise_<amplitude>");
  po::variables_map values;
  try
  {
    po::store(po::parse_command_line(argc, argv, options), values);
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

  std::printf("%-16s %-12s %7s %7s  %6s %6s %6s  %6s  %6s %6s %6s %4s  %6s %3s %3s %3s  %7s %7s\n", "source", "mesh",
              "faces", "h", "closed", "max", "truth", "edges", "shot", "max", "away", "bad", "ends", "of", "lvs", "cyc",
              "dist ms", "extr ms");
  const Torus torus;
  const Ellipsoid ellipsoid;
  for(const std::string& variant : variants)
    for(double length : lengths)
    {
      const auto mesh_of = [&](const auto& surface, const std::string& name)
      {
        if(variant == "anisotropic")
          return anisotropic(surface, length);
        Mesh mesh = cached_mesh(surface, name, length, cache);
        if(variant == "jittered")
          return jittered(surface, mesh);
        if(variant.compare(0, 6, "noise_") == 0)
          return noisy(surface, mesh, std::stod(variant.substr(6)));
        return mesh;
      };
      const Mesh t = mesh_of(torus, "torus"), e = mesh_of(ellipsoid, "ellipsoid");
      run(torus, "torus outer", variant, t, torus.point(0., 0.),
          [&](double s) { return torus.cut_locus_of_outer_equator(0., s); }, 4.);
      run(torus, "torus inner", variant, t, torus.point(1., pi),
          [&](double s) { return torus.cut_locus_of_inner_equator(1., s); }, 4.);
      run(torus, "torus general", variant, t, torus.point(0.3, 0.9), nullptr, 4.);
      run(ellipsoid, "ellipsoid 1", variant, e, ellipsoid.project(Point(0.5, 0.4, 0.45)), nullptr, 5.);
      run(ellipsoid, "ellipsoid 2", variant, e, ellipsoid.project(Point(0.2, -0.7, 0.1)), nullptr, 5.);
    }
}
