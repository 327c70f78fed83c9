// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut loci of many sources on a mesh, in one thread and in several: each line is a number of threads. Where the machine
// has other work to do, compare the processor time: what threads cost is by how much it grows with their number. The
// checksum tells that all of them find the same.

#include "command_line.h"
#include "measuring.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/compute_cut_loci.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/program_options.hpp>

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Cut_locus = CGAL::Surface_mesh_cut_locus<Mesh>::Result;

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
  const auto start = measuring::Clock::now();
  const double cpu_start = measuring::cpu_time();
  if(threads == 1)
    CGAL::compute_cut_loci(mesh, sources, output, curve);
  else
    CGAL::compute_cut_loci(mesh, sources, output, curve.concurrency_tag(CGAL::Parallel_if_available_tag()));
  const double cpu = measuring::cpu_time() - cpu_start;
  const double seconds = measuring::seconds_since(start);
  std::printf("%s,%zu,%zu,%d,%.3f,%.3f,%.1f,%.3f,%.0f,%llx\n", name.c_str(), std::size_t(mesh.number_of_faces()),
              number, threads, seconds, cpu, double(number) / seconds, 1000. * cpu / double(number),
              measuring::peak_megabytes(), checksum);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::vector<int> threads;
  std::vector<std::size_t> tori;
  std::size_t faces = 0, number = 0;
  int runs = 0;
  po::options_description options("benchmark_many_sources [OPTION]... [MESH]...: the cut loci of many sources");
  options.add_options()("help", "print this")("mesh", po::value(&files), "files of triangle meshes")(
    "torus", po::value(&faces)->default_value(20000), "without files: a jittered torus of about so many faces")(
    "sources", po::value(&number)->default_value(1000), "number of sources, spread over the vertices")(
    "threads", po::value(&threads)->multitoken()->default_value({1, 2}, "1 2"),
    "numbers of threads")("runs", po::value(&runs)->default_value(1), "how often, in turns");
  command_line::read(argc, argv, options, "mesh");
  std::puts("mesh,faces,sources,threads,seconds,cpu_seconds,sources_per_s,cpu_ms_per_source,peak_mb,checksum");
  if(files.empty())
    tori.push_back(faces);
  const auto measure_all = [&](const std::string& name, const Mesh& mesh)
  {
    for(int run = 0; run < runs; ++run)
      for(int n : threads)
        measure(name, mesh, number, n);
  };
  command_line::for_each_mesh<Mesh>(tori, files, measure_all);
}
