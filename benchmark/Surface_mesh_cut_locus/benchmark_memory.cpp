// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What each stage holds in memory when it ends, and the most it takes meanwhile, in bytes per face of a mesh (Linux, GNU C
// library). What is held counts the mesh, too.

#include "command_line.h"
#include "measuring.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <cstdio>
#include <functional>
#include <malloc.h>
#include <string>
#include <variant>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::Polyhedral_method;
using CGAL::Cut_loci::Stage;

// bytes that are allocated
double held_memory()
{
  const auto info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
}

// Prints a line for each stage.
class Memory_of_stages
{
public:
  Memory_of_stages(std::string mesh, std::string method, double error, std::size_t faces)
    : prefix_(std::move(mesh) + "," + std::to_string(faces) + "," + std::move(method)), error_(error),
      faces_(double(faces))
  {
  }

  void start_stage(Stage) { start(); }
  void end_stage(Stage stage)
  {
    constexpr const char* names[] = {"preprocessing", "distance", "strength", "tree", "homology", "filter"};
    end(names[static_cast<int>(stage)]);
  }

  void start()
  {
    held_ = held_memory();
    base_ = measuring::reset_peak_memory();
  }
  void end(const std::string& stage) const
  {
    const double peak = measuring::peak_memory() - base_;
    std::printf("%s,%g,%s,%.1f,%.1f,%.1f\n", prefix_.c_str(), error_, stage.c_str(), held_memory() / faces_,
                (held_memory() - held_) / faces_, peak / faces_);
    std::fflush(stdout);
  }

private:
  std::string prefix_;
  double error_, faces_, held_ = 0., base_ = 0.;
};

void measure(const std::string& name, const Mesh& mesh, Method method, double error)
{
  const char* const method_name = std::holds_alternative<Default_method>(method)      ? "default"
                                  : std::holds_alternative<Polyhedral_method>(method) ? "polyhedral"
                                                                                      : "laplacian";
  Memory_of_stages memory(name, method_name, error, mesh.number_of_faces());
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, CGAL::parameters::cut_locus_method(method).visitor(std::ref(memory)));
  solver.set_source(Mesh::Vertex_index(17), CGAL::parameters::maximum_relative_error(error));
  solver.cut_locus(CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::vector<std::size_t> tori;
  std::size_t faces = 0;
  po::options_description options(
    "benchmark_memory [OPTION]... [MESH]...: the memory of the stages, in bytes per face");
  options.add_options()("help", "print this")("mesh", po::value(&files), "files of triangle meshes")(
    "torus", po::value(&faces)->default_value(1000000), "without files: a jittered torus of about so many faces")(
    "polyhedral", "also all of the cut locus, which takes ten times as much");
  const po::variables_map values = command_line::read(argc, argv, options, "mesh");
  std::puts("mesh,faces,method,error,stage,held,added,peak_above_start");
  if(files.empty())
    tori.push_back(faces);
  const auto measure_all = [&](const std::string& name, const Mesh& mesh)
  {
    measure(name, mesh, Default_method(), 0.);
    measure(name, mesh, Default_method(), 1e-5);
    measure(name, mesh, Laplacian_method(), 0.);
    if(values.count("polyhedral"))
      measure(name, mesh, Polyhedral_method(), 0.);
  };
  command_line::for_each_mesh<Mesh>(tori, files, measure_all);
}
