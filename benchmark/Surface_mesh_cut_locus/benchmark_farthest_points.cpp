// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Farthest-point sampling: each sample is the vertex that is farthest from those before. Each run of the exact solver stops
// at the distance of that vertex, as nothing beyond gets nearer by the new sample; without that, all vertices are reached
// each time. Then the geodesic Voronoi diagram of all samples at once, and what the cut loci of the first one and of the
// first ten take beside each other, once the mesh has been read.

#include "jittered_torus.h"
#include "mesh_files.h"

#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

double cpu_time()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

struct Sampling
{
  std::vector<Mesh::Vertex_index> samples;
  std::vector<double> seconds; // up to each sample, with the reading of the mesh
  double radius = 0.;          // within which each vertex has a sample
  bool is_connected = true;    // the first one reaches all vertices
};

Sampling sample(const Mesh& mesh, std::size_t number, bool stops)
{
  Sampling result;
  const double start = cpu_time();
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics(mesh);
  std::vector<double> distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  Mesh::Vertex_index next = *mesh.vertices().begin();
  while(result.samples.size() < number)
  {
    result.samples.push_back(next);
    geodesics.compute(next);
    for(const Mesh::Vertex_index v : mesh.vertices())
      distance[v] = (std::min)(distance[v], geodesics.distance(v));
    const auto farthest = std::max_element(distance.begin(), distance.end());
    next = Mesh::Vertex_index(static_cast<Mesh::size_type>(farthest - distance.begin()));
    result.radius = *farthest;
    result.is_connected = result.is_connected && std::isfinite(*farthest);
    if(stops)
      geodesics.set_maximum_distance(*farthest);
    result.seconds.push_back(cpu_time() - start);
  }
  return result;
}

// Not a number if the samples are in several components, of which each has a diagram of its own.
double time_of_diagram(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& samples, bool is_connected)
{
  if(!is_connected)
    return std::numeric_limits<double>::quiet_NaN();
  const double start = cpu_time();
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  solver.set_sources(samples);
  const auto diagram = solver.cut_locus(CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES)
                                          .kept_part(CGAL::Cut_loci::Kept_part::VORONOI));
  if(diagram.number_of_sources() != samples.size())
    throw std::logic_error("the diagram does not have the samples");
  return cpu_time() - start;
}

// The least of three runs each, in turns: from sources to the curve through the faces.
std::array<double, 2> times_of_one_and_ten(const Mesh& mesh, std::vector<Mesh::Vertex_index> samples, bool is_connected)
{
  constexpr std::array<std::size_t, 2> numbers = {{1, 10}};
  std::array<double, 2> least;
  least.fill(std::numeric_limits<double>::quiet_NaN());
  if(!is_connected || samples.size() < numbers.back())
    return least;
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  solver.prepare(samples);
  for(int run = 0; run < 3; ++run)
    for(std::size_t i = 0; i < numbers.size(); ++i)
    {
      const std::vector<Mesh::Vertex_index> sources(samples.begin(), samples.begin() + numbers[i]);
      const double start = cpu_time();
      solver.set_sources(sources);
      solver.cut_locus(CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
      least[i] = std::fmin(least[i], cpu_time() - start);
    }
  return least;
}

void measure(const std::string& name, const Mesh& mesh, std::size_t number, bool is_compared)
{
  const Sampling sampling = sample(mesh, number, true);
  double unbounded = std::numeric_limits<double>::quiet_NaN();
  if(is_compared)
  {
    const Sampling other = sample(mesh, number, false);
    unbounded = other.seconds.back();
    if(other.samples != sampling.samples)
      throw std::logic_error("the samples depend on where the solver stops");
  }
  const std::array<double, 2> sets = times_of_one_and_ten(mesh, sampling.samples, sampling.is_connected);
  std::printf("%s,%zu,%zu,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.6g\n", name.c_str(), std::size_t(mesh.number_of_faces()),
              number, sampling.seconds.front(), sampling.seconds.back(), unbounded,
              time_of_diagram(mesh, sampling.samples, sampling.is_connected), sets[0], sets[1], sampling.radius);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::size_t faces = 0, number = 0;
  int runs = 0;
  bool is_compared = false;
  po::options_description options("benchmark_farthest_points [OPTION]... [MESH]...: farthest-point sampling");
  options.add_options()("help", "print this")("mesh", po::value(&files), "files of triangle meshes")(
    "torus", po::value(&faces)->default_value(100000), "without files: a jittered torus of about so many faces")(
    "samples", po::value(&number)->default_value(100), "number of samples, at least 1")(
    "compare", po::bool_switch(&is_compared),
    "also without stopping: the samples must be the same")("runs", po::value(&runs)->default_value(1), "how often");
  po::variables_map values;
  try
  {
    po::positional_options_description positional;
    positional.add("mesh", -1);
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), values);
    po::notify(values);
    if(values.count("help"))
    {
      std::cout << options;
      return EXIT_SUCCESS;
    }
    if(number == 0)
      throw std::runtime_error("--samples must be at least 1");
    std::puts("mesh,faces,samples,first_cpu_seconds,cpu_seconds,cpu_seconds_without_stopping,diagram_cpu_seconds,"
              "one_source_cpu_seconds,ten_sources_cpu_seconds,radius");
    const auto measure_all = [&](const std::string& name, const Mesh& mesh)
    {
      for(int run = 0; run < runs; ++run)
        measure(name, mesh, (std::min)(number, std::size_t(mesh.number_of_vertices())), is_compared);
    };
    if(files.empty())
    {
      const auto m = static_cast<std::size_t>(std::sqrt(0.2 * double(faces)));
      measure_all("jittered_torus", jittered_torus<Mesh>(5 * m / 2, m));
    }
    for(const std::string& file : files)
      measure_all(file.substr(file.find_last_of('/') + 1), test_meshes::read_surface_mesh<Mesh>(file));
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
