// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The accuracy of a method with its default parameters and exact distances, against cut loci of smooth surfaces that are known in
// closed form or found by shooting geodesics: on isotropic, jittered, stretched and noisy meshes at several
// resolutions, for the curve through the faces and for that of mesh edges.
//
// The source is a vertex of each mesh, exactly where the truth has it. Lengths are in units of the mean edge length h.
// `tip` is the distance of a true tip to the nearest leaf that was found, at most; `away` is the largest distance of
// the curve to the truth farther than 3 h from all true tips.

#include "accuracy_benchmark.h"
#include "accuracy_surfaces.h"
#include "measuring.h"
#include "shot_cut_locus.h"
#include "stretched_mesh.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace analytic;
namespace params = CGAL::parameters;
using CGAL::Cut_loci::Curve;

using measuring::seconds_since;

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

  void row(const std::vector<std::string>& cells)
  {
    for(std::size_t i = 0; i < cells.size(); ++i)
    {
      std::printf("%*s", i == 0 ? -26 : i == 1 ? -14 : 9, cells[i].c_str());
      if(csv_ != nullptr)
        std::fprintf(csv_, "%s%s", i == 0 ? "" : ",", cells[i].c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
    if(csv_ != nullptr)
    {
      std::fprintf(csv_, "\n");
      std::fflush(csv_);
    }
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

struct Errors
{
  Deviation to_truth;
  double from_truth = 0., tip = 0., away = 0.;
};

double distance_to_nearest(const Point& p, const std::vector<Point>& points)
{
  double result = (std::numeric_limits<double>::infinity)();
  for(const Point& q : points)
    result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, q)));
  return result;
}

Errors compare(const Polylines& curve, const std::vector<Point>& leaves, const True_cut_locus& truth, double h)
{
  Errors e;
  const std::vector<Point> samples = sampled(curve, h / 5.);
  const std::vector<double> d = distances(samples, truth.curves);
  for(std::size_t i = 0; i < d.size(); ++i)
  {
    e.to_truth.mean += d[i] / h / static_cast<double>(d.size());
    e.to_truth.max = (std::max)(e.to_truth.max, d[i] / h);
    if(distance_to_nearest(samples[i], truth.tips) > 3. * h)
      e.away = (std::max)(e.away, d[i] / h);
  }
  e.from_truth = deviation(truth.curves, curve, h / 5.).max / h;
  for(const Point& tip : truth.tips)
    e.tip = (std::max)(e.tip, distance_to_nearest(tip, leaves) / h);
  return e;
}

// Computes and compares both curves.
template <typename Surface>
void run(const Surface& surface, const std::string& surface_name, const std::string& mesh_name, const Mesh& mesh,
         const Point& at, const True_cut_locus& truth, CGAL::Cut_loci::Method method, Table& table)
{
  const double h = mean_edge_length(mesh);
  const Mesh::Vertex_index source_vertex = vertex_at(mesh, at);
  const auto start = measuring::Clock::now();
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(method));
  solver.set_source(source_vertex);
  const double source_time = seconds_since(start);
  for(Curve kind : {Curve::THROUGH_FACES, Curve::MESH_EDGES})
  {
    const auto curve_start = measuring::Clock::now();
    const auto result = solver.cut_locus(params::cut_locus_curve(kind));
    const double time = source_time + seconds_since(curve_start);
    const auto& g = result.graph();
    Polylines curve = segments_of(result);
    for(auto& line : curve)
      for(Point& p : line)
        p = surface.project(p);
    std::vector<Point> leaves;
    for(auto v : CGAL::make_range(vertices(g)))
      if(degree(v, g) == 1)
        leaves.push_back(surface.project(g[v].point));
    const Errors e = compare(curve, leaves, truth, h);
    table.row({surface_name, mesh_name, kind == Curve::THROUGH_FACES ? "faces" : "edges",
               std::to_string(mesh.number_of_faces()), number(h, 5), std::to_string(leaves.size()),
               std::to_string(truth.tips.size()), number(e.to_truth.mean, 4), number(e.to_truth.max, 3),
               number(e.from_truth, 3), number(e.tip, 3), number(e.away, 4),
               std::to_string(int(num_edges(g)) - int(num_vertices(g)) + 1), number(time, 2)});
  }
}

struct Source
{
  std::string name;
  Point point;
  True_cut_locus truth; // empty: to be shot
};

struct Options
{
  std::string cache, csv, method;
  std::vector<std::string> surfaces, meshes;
  std::vector<std::size_t> faces;
};

CGAL::Cut_loci::Method method_named(const std::string& name)
{
  if(name != "default" && name != "laplacian")
    throw std::runtime_error("there is no method " + name);
  if(name == "default")
    return CGAL::Cut_loci::Default_method();
  return CGAL::Cut_loci::Laplacian_method();
}

bool is_wanted(const std::vector<std::string>& wanted, const std::string& name)
{
  return wanted.empty() || std::any_of(wanted.begin(), wanted.end(),
                                       [&](const std::string& w) { return name.find(w) != std::string::npos; });
}

// The meshes are shared by all sources of a surface.
template <typename Surface>
void run(const Surface& surface, const std::string& file_name, std::vector<Source> sources, const Options& options,
         Table& table)
{
  std::vector<Point> points;
  for(const Source& s : sources)
    points.push_back(s.point);
  sources.erase(std::remove_if(sources.begin(), sources.end(),
                               [&](const Source& s) { return !is_wanted(options.surfaces, s.name); }),
                sources.end());
  const double step = 0.01;
  for(Source& s : sources)
    if(s.truth.curves.empty())
    {
      const Shot_cut_locus<Surface> shot(surface, s.point, 5., step);
      if(shot.longest_step() > 1.01 * step)
        throw std::runtime_error("the true cut locus has a gap");
      s.truth = shot();
    }
  if(sources.empty())
    return;
  const std::map<std::string, double> aspects = {{"4:1", 4.}, {"10:1", 10.}, {"1:4", 0.25}, {"1:10", 0.1}};
  for(const std::string kind : {"isotropic", "jittered", "4:1", "10:1", "1:4", "1:10", "noise_0.03", "noise_0.1"})
  {
    if(!is_wanted(options.meshes, kind))
      continue;
    for(std::size_t n : options.faces)
    {
      const auto found = aspects.find(kind);
      const double aspect = found == aspects.end() ? 1. : found->second;
      Mesh mesh;
      try
      {
        mesh = stretched_mesh(surface, file_name, aspect, n, points, options.cache);
      }
      catch(const std::runtime_error& error) // triangles too long for the curvature of the surface
      {
        std::cerr << file_name << ", " << kind << ", " << n << " faces: " << error.what() << "\n";
        continue;
      }
      if(kind == "jittered")
        jitter(surface, mesh, points);
      else if(kind.compare(0, 6, "noise_") == 0)
        add_noise(surface, mesh, std::stod(kind.substr(6)), points);
      for(const Source& s : sources)
        run(surface, s.name, kind, mesh, s.point, s.truth, method_named(options.method), table);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options o;
  po::options_description options("Accuracy on meshes of smooth surfaces");
  options.add_options()("help", "print this")("cache", po::value(&o.cache), "folder that keeps the generated meshes")(
    "csv", po::value(&o.csv), "file for the table, as comma separated values")(
    "faces", po::value(&o.faces)->multitoken()->default_value({5000, 20000, 80000}, "5000 20000 80000"),
    "numbers of faces, nearly")("method", po::value(&o.method)->default_value("default"), "default or laplacian")(
    "surface", po::value(&o.surfaces)->multitoken(), "only the surfaces whose names contain one of these")(
    "mesh", po::value(&o.meshes)->multitoken(),
    "only the kinds of meshes whose names contain one of these; all are isotropic, jittered, 4:1 and "
    "10:1 (long along x), 1:4 and 1:10 (short along x), noise_0.03 and noise_0.1");
  command_line::read(argc, argv, options);

  Table table(o.csv);
  table.row({"surface", "mesh", "curve", "faces", "h", "leaves", "true", "mean", "max", "back", "tip", "away", "cycles",
             "seconds"});
  const double step = 2e-3;
  const Torus torus;
  const double conjugate = pi * std::sqrt(torus.r / (torus.R + torus.r));
  const True_cut_locus outer{torus.cut_locus_of_outer_equator(0., step),
                             {torus.point(conjugate, 0.), torus.point(-conjugate, 0.)}},
    inner{torus.cut_locus_of_inner_equator(1., step), {}};
  run(torus, "torus",
      {{"torus outer", torus.point(0., 0.), outer},
       {"torus inner", torus.point(1., pi), inner},
       {"torus general", torus.point(0.3, 0.9), {}}},
      o, table);
  const Ellipsoid plain{1., 0.8, 0.6}, flat{1., 0.9, 0.25}, slim{1., 0.5, 0.3};
  run(plain, "ellipsoid_1_0.8_0.6", {{"ellipsoid 1 .8 .6", plain.project(Point(0.5, 0.4, 0.45)), {}}}, o, table);
  run(flat, "ellipsoid_1_0.9_0.25", {{"ellipsoid 1 .9 .25", flat.project(Point(0.5, 0.4, 0.2)), {}}}, o, table);
  run(slim, "ellipsoid_1_0.5_0.3", {{"ellipsoid 1 .5 .3 umbilic", near_umbilic(slim, 0.1), {}}}, o, table);
  const Bumpy_sphere bumpy;
  run(bumpy, "bumpy", {{"bumpy sphere", bumpy.project(Point(0.3, 0.5, 0.7)), {}}}, o, table);
  const auto run_one =
    [&](const Sum_of_exponentials& s, const std::string& file, const std::string& name, const Point& p) {
    run(s, file, {{name, s.project(p), {}}}, o, table);
  };
  run_one(rounded_box(), "rounded_box", "rounded box", Point(0.3, 0.2, 0.5));
  run_one(rounded_tetrahedron(), "rounded_tetrahedron", "rounded tetrahedron", Point(0.3, 0.4, 0.5));
  run_one(cone_cap(), "cone_cap", "cone cap", Point(0.3, 0.5, -0.2));
  run_one(dumbbell_with_bump(), "dumbbell", "dumbbell with a bump", Point(-0.8, 0.4, 0.3));
  run_one(ball_with_arms(), "arms", "ball with arms", Point(0.2, 0.3, 0.5));
}
