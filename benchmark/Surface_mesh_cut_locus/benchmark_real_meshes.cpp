// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// How good the cut locus is on the mesh files of a folder, with all methods and solvers, as comma-separated values on
// standard output: topology, detour (see detour.h) in mean edge lengths, and time; how much of what is strong in the
// polyhedron's cut locus is near the curve, and how much of the curve is near that of the surface. A table that sums them
// up follows on standard error.
//
// No truth is needed, so any meshes will do. A run that is refused is a line with the cause.

#include "Input_mesh.h"
#include "Mesh.h"
#include "completeness.h"
#include "detour.h"

#include <CGAL/Exact_geodesic_solver.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/compute_cut_locus.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace params = CGAL::parameters;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::Polyhedral_method;
using Vertex = Mesh::Vertex_index;
using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;

struct Configuration
{
  std::string method, solver;
  std::function<std::unique_ptr<Solver>(const Mesh&)> make;
  bool has_angle; // a threshold of the method
};

template <typename GeodesicSolver>
Configuration configuration(const std::string& method_name, const std::string& solver_name, Method method)
{
  return {method_name, solver_name,
          [method](const Mesh& mesh) {
    return std::make_unique<Solver>(mesh, params::geodesic_solver(GeodesicSolver()).cut_locus_method(method));
          },
          std::holds_alternative<Laplacian_method>(method)};
}

std::vector<Configuration> all_configurations()
{
  return {configuration<CGAL::Exact_geodesic_solver>("default", "exact", Default_method()),
          configuration<CGAL::Exact_geodesic_solver>("laplacian", "exact", Laplacian_method()),
          configuration<CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Intrinsic_Delaunay>>("laplacian", "heat",
                                                                                                    Laplacian_method()),
          configuration<CGAL::Graph_geodesic_solver>("laplacian", "graph", Laplacian_method())};
}

struct Settings
{
  std::vector<std::string> names; // of configurations; all if empty
  std::vector<double> angles;
  std::vector<std::string> curves;
  std::size_t sources = 3, max_faces = 0;

  bool has(const Configuration& c) const
  {
    return names.empty() || std::find(names.begin(), names.end(), c.method + "-" + c.solver) != names.end();
  }
  bool has_curve(Curve curve) const
  {
    const std::string name = curve == Curve::MESH_EDGES ? "edges" : "faces";
    return std::find(curves.begin(), curves.end(), name) != curves.end();
  }
};

// The detours of all runs of a kind.
struct Kind
{
  std::vector<double> max, completeness;
  double sum_of_means = 0.;
  std::size_t not_measured = 0, topology_faults = 0;
};

class Benchmark
{
public:
  explicit Benchmark(const Settings& settings) : settings_(settings)
  {
    std::printf("mesh,source,method,solver,curve,angle,faces,genus,borders,edges,topology,detour_mean,detour_p99,"
                "detour_max,worst,completeness,precision,seconds,error\n");
  }

  void operator()(const std::filesystem::path& file)
  {
    name_ = file.filename().string();
    Mesh mesh;
    try
    {
      mesh = read_mesh(file.string(), Repair::WELD).mesh;
    }
    catch(const std::exception& error)
    {
      std::string message = error.what();
      const std::size_t at = message.find(file.string());
      if(at != std::string::npos)
        message.replace(at, file.string().size(), name_); // wherever the folder is
      refused("", "", "", message);
      return;
    }
    if(settings_.max_faces > 0 && mesh.number_of_faces() > settings_.max_faces)
      return;
    for(const Vertex v : spread_sources(mesh))
      run(mesh, v);
  }

  void print_summary() const
  {
    std::fprintf(stderr, "%-10s %-6s %-6s %5s %5s  %6s %6s %6s %6s %6s  %9s %6s %6s %6s %6s\n", "method", "solver",
                 "curve", "angle", "runs", "<=1h", "<=2h", "<=3h", "<=5h", "<=15h", "mean/h", "topol.", "failed",
                 "found", ">=95%");
    for(const auto& k : kinds_)
    {
      const double n = double((std::max)(k.second.max.size(), std::size_t(1)));
      const auto share = [&](double h)
      { return 100. * std::count_if(k.second.max.begin(), k.second.max.end(), [&](double x) { return x <= h; }) / n; };
      std::fprintf(stderr, "%s %5zu  %5.1f%% %5.1f%% %5.1f%% %5.1f%% %5.1f%%  %9.4f %6zu %6zu %5.1f%% %5.1f%%\n",
                   k.first.c_str(), k.second.max.size(), share(1.), share(2.), share(3.), share(5.), share(15.),
                   k.second.sum_of_means / n, k.second.topology_faults, k.second.not_measured,
                   100. * mean(k.second.completeness), 100. * share_of_complete(k.second.completeness));
    }
  }

private:
  static double mean(const std::vector<double>& values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / double((std::max)(values.size(), std::size_t(1)));
  }

  static double share_of_complete(const std::vector<double>& values)
  {
    const auto n = std::count_if(values.begin(), values.end(), [](double x) { return x >= 0.95; });
    return double(n) / double((std::max)(values.size(), std::size_t(1)));
  }

  std::vector<Vertex> spread_sources(const Mesh& mesh) const
  {
    std::vector<Vertex> used, result;
    for(const Vertex v : mesh.vertices())
      if(!mesh.is_isolated(v))
        used.push_back(v);
    const std::size_t n = (std::min)(settings_.sources, used.size());
    for(std::size_t i = 0; i < n; ++i)
      result.push_back(used[(2 * i + 1) * used.size() / (2 * n)]);
    return result;
  }

  // The whole cut locus of the polyhedron, and what is missed if it is not found: a tenth stronger than the default asks
  // for. And that of the surface, by the default.
  struct Trusted
  {
    std::unique_ptr<const Cut_locus> tree, pruned;
    double width = 0.;
  };

  Trusted find_trusted(const Mesh& mesh, Vertex source) const
  {
    Trusted result;
    try
    {
      const auto faces = params::cut_locus_curve(Curve::THROUGH_FACES);
      CGAL::Surface_mesh_cut_locus<Mesh> pruned(mesh);
      pruned.set_source(source);
      result.pruned = std::make_unique<const Cut_locus>(pruned.cut_locus(faces));
      const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
      const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
      result.width = 1.1 * pruned.minimum_branch_width() * diagonal;
      result.tree = std::make_unique<const Cut_locus>(
        CGAL::compute_cut_locus(mesh, source, faces.cut_locus_method(Polyhedral_method())));
    }
    catch(const std::exception&)
    {
      // a run says why
    }
    return result;
  }

  void run(const Mesh& mesh, Vertex source)
  {
    std::vector<double> exact; // distances, computed once
    const Trusted trusted = find_trusted(mesh, source);
    for(const Configuration& c : configurations_)
    {
      if(!settings_.has(c))
        continue;
      try
      {
        const auto start = std::chrono::steady_clock::now();
        const std::unique_ptr<Solver> solver = c.make(mesh);
        solver->set_source(source);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
        {
          if(!settings_.has_curve(curve))
            continue;
          if(!c.has_angle)
          {
            const Cut_locus result = solver->cut_locus(params::cut_locus_curve(curve));
            print(mesh, source, c, curve, "", result, trusted, seconds, exact);
            continue;
          }
          for(const double angle : settings_.angles)
            print(
              mesh, source, c, curve, shortest(angle),
              solver->cut_locus(
                params::cut_locus_method(Laplacian_method().gradient_angle_threshold(angle)).cut_locus_curve(curve)),
              trusted, seconds, exact);
        }
      }
      catch(const std::exception& error)
      {
        refused(std::to_string(source.idx()), c.method, c.solver, error.what());
      }
    }
  }

  static std::string shortest(double x)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%g", x);
    return text;
  }

  // as one field
  static std::string quoted(const std::string& text)
  {
    std::string result = "\"";
    for(char c : text)
      result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
    return text.empty() ? text : result + "\"";
  }

  void refused(const std::string& source, const std::string& method, const std::string& solver,
               const std::string& cause) const
  {
    std::printf("%s,%s,%s,%s,,,,,,,,,,,,,,,%s\n", quoted(name_).c_str(), source.c_str(), method.c_str(), solver.c_str(),
                quoted(cause).c_str());
    std::fflush(stdout);
  }

  void print(const Mesh& mesh, Vertex source, const Configuration& c, Curve curve, const std::string& angle,
             const Cut_locus& result, const Trusted& trusted, double seconds, std::vector<double>& exact)
  {
    const curve_measures::Measures m = curve_measures::measure(mesh, result, exact);
    const std::string curve_name = curve == Curve::MESH_EDGES ? "edges" : "faces";
    char key[64];
    std::snprintf(key, sizeof key, "%-10s %-6s %-6s %5s", c.method.c_str(), c.solver.c_str(), curve_name.c_str(),
                  angle.c_str());
    Kind& kind = kinds_[key];
    std::printf("%s,%u,%s,%s,%s,%s,%u,%zu,%zu,%zu,%s,", quoted(name_).c_str(), unsigned(source.idx()), c.method.c_str(),
                c.solver.c_str(), curve_name.c_str(), angle.c_str(), unsigned(mesh.number_of_faces()), result.genus(),
                result.number_of_border_loops(), std::size_t(num_edges(result.graph())),
                quoted(m.topology_fault).c_str());
    kind.topology_faults += m.topology_fault.empty() ? 0 : 1;
    if(m.measuring_failed.empty())
    {
      std::printf("%.4f,%.4f,%.4f,%u,", m.mean, m.p99, m.max, unsigned(m.worst));
      kind.max.push_back(m.max);
      kind.sum_of_means += m.mean;
    }
    else
    {
      std::printf(",,,,");
      ++kind.not_measured;
    }
    if(trusted.tree != nullptr)
    {
      const double reach = 2. * mean_edge_length(mesh);
      const double found = curve_measures::completeness(
        *trusted.tree, [&](const auto& e) { return e.width >= trusted.width; }, result, reach);
      std::printf("%.3f,%.3f", found, curve_measures::completeness(result, *trusted.pruned, reach));
      kind.completeness.push_back(found);
    }
    else
      std::printf(",");
    std::printf(",%.4f,%s\n", seconds, quoted(m.measuring_failed).c_str());
    std::fflush(stdout);
  }

  const Settings settings_;
  const std::vector<Configuration> configurations_ = all_configurations();
  std::string name_;
  std::map<std::string, Kind> kinds_;
};

bool is_mesh(const std::filesystem::path& file)
{
  const std::string extension = file.extension().string();
  for(const char* known : {".off", ".obj", ".ply", ".stl", ".ts"})
    if(extension == known)
      return true;
  return false;
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  Settings settings;
  std::string folder;
  po::options_description options("The cut locus on the mesh files of a folder");
  options.add_options()("help", "print this")("folder", po::value(&folder), "the folder, or one file")(
    "only", po::value(&settings.names)->multitoken(), "methods and solvers: default-exact laplacian-heat ...")(
    "angle", po::value(&settings.angles)->multitoken()->default_value({0.3, 0.7, 1.5}, "0.3 0.7 1.5"),
    "thresholds of the method laplacian")(
    "curve", po::value(&settings.curves)->multitoken()->default_value({"edges", "faces"}, "edges faces"), "curves")(
    "sources", po::value(&settings.sources)->default_value(3), "number of vertices, spread over the list of them")(
    "max-faces", po::value(&settings.max_faces)->default_value(0), "leave out larger meshes");
  po::positional_options_description positional;
  positional.add("folder", 1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), given);
  po::notify(given);
  if(given.count("help") || folder.empty())
  {
    std::cout << "Usage: benchmark_real_meshes FOLDER [OPTION]...\n" << options;
    return given.count("help") ? 0 : 2;
  }

  std::vector<std::filesystem::path> files;
  if(std::filesystem::is_directory(folder))
  {
    for(const auto& entry : std::filesystem::directory_iterator(folder))
      if(is_mesh(entry.path()))
        files.push_back(entry.path());
  }
  else
    files.push_back(folder);
  std::sort(files.begin(), files.end());
  Benchmark benchmark(settings);
  for(const auto& file : files)
    benchmark(file);
  benchmark.print_summary();
}
