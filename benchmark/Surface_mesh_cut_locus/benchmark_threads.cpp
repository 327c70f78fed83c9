// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What threads give to the stages of one cut locus: for each stage and number of threads, the processor time of the thread
// that calls, that of all threads, and the time that passes, on a machine with nothing else to do. The second tells what the
// threads cost. Each figure is the median of some runs, in turns.

#include "command_line.h"
#include "measuring.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <boost/program_options.hpp>

#include <array>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <time.h>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::Stage;
namespace params = CGAL::parameters;

// of the thread that calls
double thread_time()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// by the thread that calls, by all threads, and by the clock
using Times = std::array<double, 3>;

Times now()
{
  return {{thread_time(), measuring::cpu_time(), measuring::seconds_since({})}};
}

constexpr const char* all_stages = "all";

// Adds up the times of each stage in a run. Stages start and end in the thread that calls.
class Stage_times : public CGAL::Cut_loci::Default_visitor
{
public:
  void start_stage(Stage) { start_ = now(); }
  void end_stage(Stage stage)
  {
    constexpr const char* names[] = {"preprocessing", "distance", "strength", "tree", "homology", "filter"};
    const Times end = now();
    for(std::size_t i = 0; i < 3; ++i)
    {
      run_[names[static_cast<int>(stage)]][i] += end[i] - start_[i];
      run_[all_stages][i] += end[i] - start_[i];
    }
  }

  const std::map<std::string, Times>& of_run() const { return run_; }

private:
  Times start_ = {{0., 0., 0.}};
  std::map<std::string, Times> run_;
};

std::map<std::string, Times> times_of_run(const Mesh& mesh, Method method, int threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
#endif
  Stage_times times;
  const auto run = [&](const auto& np)
  {
    CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, np);
    solver.set_source(Mesh::Vertex_index(17));
    solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES));
  };
  const auto np = params::cut_locus_method(method).visitor(std::ref(times));
  if(threads == 1)
    run(np);
  else
    run(np.concurrency_tag(CGAL::Parallel_if_available_tag()));
  return times.of_run();
}

void measure(const std::string& name, const Mesh& mesh, const std::vector<int>& threads, int runs)
{
  for(const auto& method :
      {std::make_pair(Method(Default_method()), "default"), std::make_pair(Method(Laplacian_method()), "laplacian")})
  {
    std::map<std::pair<int, std::string>, std::array<std::vector<double>, 3>> times;
    for(int run = 0; run < runs; ++run)
      for(int n : threads)
        for(const auto& [stage, seconds] : times_of_run(mesh, method.first, n))
          for(std::size_t i = 0; i < 3; ++i)
            times[{n, stage}][i].push_back(seconds[i]);
    for(const auto& [key, seconds] : times)
      std::printf("%s,%zu,%s,%d,%s,%.4f,%.4f,%.4f\n", name.c_str(), std::size_t(mesh.number_of_faces()), method.second,
                  key.first, key.second.c_str(), measuring::median(seconds[0]), measuring::median(seconds[1]),
                  measuring::median(seconds[2]));
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  std::vector<std::size_t> tori;
  std::vector<int> threads;
  std::size_t faces = 0;
  int runs = 0;
  po::options_description options("benchmark_threads [OPTION]... [MESH]...: the stages of one cut locus in threads");
  options.add_options()("help", "print this")("mesh", po::value(&files), "files of triangle meshes")(
    "torus", po::value(&faces)->default_value(100000), "without files: a jittered torus of about so many faces")(
    "threads", po::value(&threads)->multitoken()->default_value({1, 2}, "1 2"),
    "numbers of threads")("runs", po::value(&runs)->default_value(5), "each figure is the median of so many runs");
  command_line::read(argc, argv, options, "mesh");
  std::puts("mesh,faces,method,threads,stage,caller_seconds,cpu_seconds,seconds");
  if(files.empty())
    tori.push_back(faces);
  command_line::for_each_mesh<Mesh>(
    tori, files, [&](const std::string& name, const Mesh& mesh) { measure(name, mesh, threads, runs); });
}
