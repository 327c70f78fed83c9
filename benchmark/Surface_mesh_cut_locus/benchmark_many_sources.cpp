// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut loci of many sources on a mesh, in one thread and in several: each line is a number of threads. Where the machine
// has other work to do, compare the processor time: what threads cost is by how much it grows with their number. The
// checksum tells that all of them find the same.

#include "jittered_torus.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/compute_cut_loci.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/program_options.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <sys/resource.h>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Cut_locus = CGAL::Surface_mesh_cut_locus<Mesh>::Result;
using Clock = std::chrono::steady_clock;

double cpu_time()
{
  return double(std::clock()) / CLOCKS_PER_SEC; // of all threads
}

double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.;
}

void measure(const std::string& name, const Mesh& mesh, std::size_t number, int threads)
{
  std::vector<Mesh::Vertex_index> sources;
  for(std::size_t i = 0; i < number; ++i)
    sources.emplace_back(Mesh::size_type(i * mesh.number_of_vertices() / number));
  unsigned long long checksum = 0;
  const auto add = [&](const Cut_locus& cut_locus)
  {
    unsigned long long bits = 0;
    const double radius = CGAL::Cut_loci::injectivity_radius(cut_locus).distance;
    std::memcpy(&bits, &radius, sizeof radius);
    checksum = 31 * checksum + bits + num_edges(cut_locus.graph());
  };
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
#endif
  const auto curve = CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES);
  const auto output = boost::make_function_output_iterator(add);
  const Clock::time_point start = Clock::now();
  const double cpu_start = cpu_time();
  if(threads == 1)
    CGAL::compute_cut_loci(mesh, sources, output, curve);
  else
    CGAL::compute_cut_loci(mesh, sources, output, curve.concurrency_tag(CGAL::Parallel_if_available_tag()));
  const double cpu = cpu_time() - cpu_start;
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  std::printf("%s,%zu,%zu,%d,%.3f,%.3f,%.1f,%.3f,%.0f,%llx\n", name.c_str(), std::size_t(mesh.number_of_faces()),
              number, threads, seconds, cpu, double(number) / seconds, 1000. * cpu / double(number), peak_memory(),
              checksum);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::vector<int> threads;
  std::size_t faces = 0, number = 0;
  int runs = 0;
  po::options_description options("benchmark_many_sources [OPTION]... [MESH]...: the cut loci of many sources");
  options.add_options()("help", "print this")("mesh", po::value(&files), "files of triangle meshes")(
    "torus", po::value(&faces)->default_value(20000), "without files: a jittered torus of about so many faces")(
    "sources", po::value(&number)->default_value(1000), "number of sources, spread over the vertices")(
    "threads", po::value(&threads)->multitoken()->default_value({1, 2}, "1 2"),
    "numbers of threads")("runs", po::value(&runs)->default_value(1), "how often, in turns");
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
    std::puts("mesh,faces,sources,threads,seconds,cpu_seconds,sources_per_s,cpu_ms_per_source,peak_mb,checksum");
    const auto measure_all = [&](const std::string& name, const Mesh& mesh)
    {
      for(int run = 0; run < runs; ++run)
        for(int n : threads)
          measure(name, mesh, number, n);
    };
    if(files.empty())
    {
      const auto m = static_cast<std::size_t>(std::sqrt(0.2 * double(faces)));
      measure_all("jittered_torus", jittered_torus<Mesh>(5 * m / 2, m));
    }
    for(const std::string& file : files)
    {
      Mesh mesh;
      if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
        throw std::runtime_error("'" + file + "' holds no triangle mesh");
      measure_all(file.substr(file.find_last_of('/') + 1), mesh);
    }
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
