// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the default costs beside exact distances: the processor time of sources on a mesh that has been read, of plain
// distances, and of the cut locus through the faces with each of its stages, in turn. The first source is not counted: it
// takes memory that the others use again.

#include "command_line.h"
#include "measuring.h"

#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Stage = CGAL::Cut_loci::Stage;

constexpr std::array<Stage, 5> stages = {
  {Stage::DISTANCE, Stage::STRENGTH, Stage::TREE, Stage::HOMOLOGY, Stage::FILTER}};

// Adds up the processor time of each stage.
struct Stage_times
{
  std::array<double, 7> seconds = {};
  double start = 0.;

  void start_stage(Stage) { start = measuring::cpu_time(); }
  void end_stage(Stage stage) { seconds[static_cast<std::size_t>(stage)] += measuring::cpu_time() - start; }
};

void measure(const std::string& name, const Mesh& mesh, std::size_t number)
{
  Stage_times times;
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics(mesh);
  CGAL::Surface_mesh_cut_locus<Mesh> cut_loci(mesh, CGAL::parameters::visitor(std::ref(times)));
  std::vector<double> plain, all;
  for(std::size_t i = 0; i <= number; ++i)
  {
    const Mesh::Vertex_index source(static_cast<Mesh::size_type>(i * mesh.number_of_vertices() / (number + 1)));
    const double start = measuring::cpu_time();
    geodesics.compute(source);
    const double middle = measuring::cpu_time();
    cut_loci.set_source(source);
    cut_loci.cut_locus();
    plain.push_back(middle - start);
    all.push_back(measuring::cpu_time() - middle);
    if(i > 0)
      continue;
    times = Stage_times();
    plain.clear();
    all.clear();
  }
  std::printf("%s,%zu,%zu,%.4f,%.4f", name.c_str(), std::size_t(mesh.number_of_faces()), number,
              measuring::median(plain), measuring::median(all));
  for(Stage stage : stages)
    std::printf(",%.4f", times.seconds[static_cast<std::size_t>(stage)] / static_cast<double>(number));
  std::printf(",%.2f,%.2f,%.0f\n", measuring::median(all) / measuring::median(plain),
              *std::max_element(all.begin(), all.end()) / measuring::median(all), measuring::peak_megabytes());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::size_t number = 0;
  po::options_description options(
    "The default beside plain exact distances. Usage: benchmark_further_source [options] MESH...");
  options.add_options()("help", "print this")("mesh", po::value(&files),
                                              "meshes")("sources", po::value(&number)->default_value(9), "so many");
  command_line::read(argc, argv, options, "mesh");
  if(files.empty() || number == 0)
    command_line::fail("no MESH, or no source: see --help");
  std::printf(
    "mesh,faces,sources,plain,all,distances,strengths,tree,cycles,filter,all/plain,slowest/median,peak [MB]\n");
  for(const std::string& file : files)
    measure(file, command_line::read_mesh<Mesh>(file), number);
}
