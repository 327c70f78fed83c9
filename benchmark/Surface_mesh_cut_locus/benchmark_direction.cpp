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
// edges is then compared with the verified one, and on a noisy mesh all is compared with the curve of the mesh without
// noise. `away` is the maximum farther than 4 h from the ends. At the end, the order in h of `away` times h, for each
// source and kind of mesh: 2 is what a second-order method has.

#include "accuracy_benchmark.h"
#include "direction_truth.h"

#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

// Prints rows, and writes them to a file as well.
class Table
{
public:
  explicit Table(const std::string& csv) : csv_(csv.empty() ? nullptr : std::fopen(csv.c_str(), "w"))
  {
    if(csv_ == nullptr && !csv.empty())
      throw std::runtime_error("cannot write " + csv);
  }

  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  ~Table()
  {
    if(csv_ != nullptr)
      std::fclose(csv_);
  }

  // `-` where there is no value
  void row(const std::vector<std::string>& cells)
  {
    for(std::size_t i = 0; i < cells.size(); ++i)
    {
      std::printf("%*s", i < 2 ? -15 : 8, cells[i].c_str());
      if(csv_ != nullptr)
        std::fprintf(csv_, "%s%s", i == 0 ? "" : ",", cells[i] == "-" ? "" : cells[i].c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
    if(csv_ != nullptr)
      std::fprintf(csv_, "\n");
  }

private:
  std::FILE* csv_;
};

std::string number(double x, int digits)
{
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), "%.*f", digits, x);
  return buffer;
}

// The slope of the logarithm of the absolute error over that of h, by least squares.
double fitted_order(const std::vector<std::pair<double, double>>& h_and_error)
{
  double n = 0., sx = 0., sy = 0., sxx = 0., sxy = 0.;
  for(const auto& p : h_and_error)
  {
    const double x = std::log(p.first), y = std::log(p.second);
    n += 1.;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

struct Run
{
  Clock clock;
  double h = 0.;
  Polylines curve, edges;
  int leaves = 0, cycles = 0;
};

template <typename Surface>
Run solve(const Surface& surface, const Mesh& mesh, Mesh::Vertex_index source)
{
  Run run;
  run.h = mean_edge_length(mesh);
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh,
                                            params::cut_locus_method(Method::DIRECTION).visitor(std::ref(run.clock)));
  solver.set_source(source); // warms up
  run.clock.distance = run.clock.extraction = 0.;
  solver.set_source(source);
  const auto through_faces = solver.cut_locus(params::cut_locus_curve(Curve::THROUGH_FACES));
  const double extraction = run.clock.extraction;
  run.curve = segments_of(through_faces);
  run.edges = segments_of(solver.cut_locus(params::cut_locus_curve(Curve::MESH_EDGES)));
  run.clock.extraction = extraction;
  const auto& g = through_faces.graph();
  for(auto v : CGAL::make_range(vertices(g)))
    run.leaves += degree(v, g) == 1;
  run.cycles = int(num_edges(g)) - int(num_vertices(g)) + 1;
  for(Polylines* lines : {&run.curve, &run.edges})
    for(auto& line : *lines)
      for(Point& p : line)
        p = surface.project(p);
  return run;
}

using Orders = std::map<std::string, std::vector<std::pair<double, double>>>;

// `smooth` is the mesh before the noise.
template <typename Surface>
void run(const Surface& surface, const std::string& name, const std::string& variant, Mesh mesh, const Mesh& smooth,
         const Point& at, const std::function<Polylines(double)>& closed_form, double limit, Table& table,
         Orders& orders)
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
  const Run result = solve(surface, mesh, source);
  const double h = result.h, step = h / 5.;
  const Polylines truth = closed_form ? closed_form(step)
                          : is_noisy  ? solve(surface, smooth, source).curve
                                      : result.curve;
  std::vector<std::string> cells = {name, variant, std::to_string(mesh.number_of_faces()), number(h, 4)};
  if(closed_form || is_noisy)
  {
    const Deviation e = deviation(result.curve, truth, step), t = deviation(truth, result.curve, step);
    cells.insert(cells.end(), {number(e.mean / h, 4), number(e.max / h, 3), number(t.max / h, 3)});
  }
  else
    cells.insert(cells.end(), 3, "-");
  cells.push_back(
    number((std::max)(deviation(result.edges, truth, step).max, deviation(truth, result.edges, step).max) / h, 3));
  if(is_noisy)
    cells.insert(cells.end(), 6, "-");
  else
  {
    double end = 0.;
    for(double d : shot.ends)
      end = (std::max)(end, d);
    cells.insert(cells.end(), {number(shot.mean, 4), number(shot.max, 3), number(shot.max_away, 4),
                               std::to_string(shot.unverified), number(end, 3), std::to_string(shot.ends.size())});
    orders[name + ", " + variant].push_back({h, shot.max_away * h});
  }
  cells.insert(cells.end(), {std::to_string(result.leaves), std::to_string(result.cycles),
                             number(1e3 * result.clock.distance, 1), number(1e3 * result.clock.extraction, 1)});
  table.row(cells);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::string cache, csv;
  std::vector<double> lengths;
  std::vector<std::string> variants;
  po::options_description options("Accuracy of the direction method");
  options.add_options()("help", "print this")("cache", po::value(&cache), "folder that keeps the generated meshes")(
    "csv", po::value(&csv), "file for the table, as comma separated values")(
    "length", po::value(&lengths)->multitoken()->default_value({0.08, 0.064, 0.04, 0.032}, "0.08 0.064 0.04 0.032"),
    "edge lengths; the torus has radii 1 and 0.4, the ellipsoid the half axes 1, 0.8, 0.6")(
    "variant",
    po::value(&variants)->multitoken()->default_value(
      {"isotropic", "jittered", "anisotropic", "noise_0.03", "noise_0.1", "noise_0.2"}, "all"),
    "isotropic, jittered, anisotropic, noise_<amplitude>");
  analytic::read_options(argc, argv, options);

  Table table(csv);
  Orders orders;
  table.row({"source", "mesh", "faces", "h", "closed", "max", "truth", "edges", "shot", "max", "away", "bad", "ends",
             "of", "leaves", "cycles", "dist ms", "extr ms"});
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
      const Mesh smooth_t = cached_mesh(torus, "torus", length, cache),
                 smooth_e = cached_mesh(ellipsoid, "ellipsoid", length, cache);
      run(
        torus, "torus outer", variant, t, smooth_t, torus.point(0., 0.),
        [&](double s) { return torus.cut_locus_of_outer_equator(0., s); }, 4., table, orders);
      run(
        torus, "torus inner", variant, t, smooth_t, torus.point(1., pi),
        [&](double s) { return torus.cut_locus_of_inner_equator(1., s); }, 4., table, orders);
      run(torus, "torus general", variant, t, smooth_t, torus.point(0.3, 0.9), nullptr, 4., table, orders);
      run(ellipsoid, "ellipsoid 1", variant, e, smooth_e, ellipsoid.project(Point(0.5, 0.4, 0.45)), nullptr, 5., table,
          orders);
      run(ellipsoid, "ellipsoid 2", variant, e, smooth_e, ellipsoid.project(Point(0.2, -0.7, 0.1)), nullptr, 5., table,
          orders);
    }
  for(const auto& o : orders)
    if(o.second.size() > 1)
      std::printf("order of the error away from the ends, %-28s %5.2f\n", (o.first + ":").c_str(),
                  fitted_order(o.second));
}
