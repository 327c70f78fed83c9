// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Times the exact geodesic solver.
//
//   benchmark_exact_geodesics [--cpu] [--error e] [--trials n] [--cgal-trials n] mesh...
//     against CGAL's Surface_mesh_shortest_path: from the mesh object to the distances of all vertices, and for CGAL
//     the construction of its sequence tree alone
//   benchmark_exact_geodesics [--cpu] [--error e] [--csv file] --growth [largest number of faces]
//     on jittered tori of 12500 faces, twice as many, and so on, and of the largest number; prints time, memory and
//     windows, as comma-separated values, and the exponents fitted to them; the file gets the values alone
//     (scripts/plot_benchmark draws them)
//   benchmark_exact_geodesics [--cpu] [--error e] [--csv file] --points [largest number of faces]
//     points at random that are named after the run, on jittered tori of 25000 faces, four times as many, and so on
//   --error e allows distances to be too long by e times their length: no directions then
//   --cpu measures processor time instead of elapsed time, for machines with other work to do

#include "jittered_torus.h"
#include "measuring.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;

namespace {

using measuring::median;

bool measures_processor_time = false;
double maximum_relative_error = 0.;

double now()
{
  if(measures_processor_time)
    return measuring::cpu_time();
  return measuring::seconds_since({});
}

struct Times
{
  double read, total, again;
};

/// the whole way from the mesh object to distances, and to directions if wanted; `again` is one more source
Times time_ours(const Mesh& mesh, Vertex source, bool directions, bool centroids, int trials,
                std::vector<double>& distances, std::size_t& windows)
{
  directions = directions && maximum_relative_error == 0.;
  std::vector<double> read, total, again, angles(num_vertices(mesh));
  for(int i = 0; i < trials; ++i)
  {
    const double start = now();
    Geodesics geodesics(mesh);
    const double have_read = now();
    geodesics.set_maximum_relative_error(maximum_relative_error);
    geodesics.set_directions(directions);
    for(auto f : mesh.faces())
      if(centroids)
        geodesics.add_query({f, {{1. / 3., 1. / 3., 1. / 3.}}});
    geodesics.compute(source);
    for(Vertex v : mesh.vertices())
      distances[v] = geodesics.distance(v);
    if(directions)
      for(Vertex v : mesh.vertices())
        if(v != source && distances[v] < std::numeric_limits<double>::infinity())
          angles[v] = geodesics.direction_at_source(v);
    const double end = now();
    geodesics.compute(source);
    again.push_back(now() - end);
    read.push_back(have_read - start);
    total.push_back(end - start);
    windows = geodesics.number_of_windows();
  }
  return {median(read), median(total), median(again)};
}

struct Time_of_point
{
  double all, point;
};

/// the distances of all vertices from one more source, and then that of one of many points at random
Time_of_point time_of_point(const Mesh& mesh)
{
  Geodesics geodesics(mesh);
  geodesics.set_maximum_relative_error(maximum_relative_error);
  geodesics.compute(Vertex(1));
  const double begin = now();
  geodesics.compute(Vertex(0));
  const double computed = now();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::vector<Geodesics::Face_location> points;
  for(int i = 0; i < 1000; ++i)
  {
    const double a = std::sqrt(unit(random)), b = unit(random);
    points.emplace_back(Mesh::Face_index(static_cast<Mesh::size_type>(random() % num_faces(mesh))),
                        std::array<double, 3>{{1. - a, a * (1. - b), a * b}});
  }
  double sum = 0.;
  const double start = now();
  for(const Geodesics::Face_location& p : points)
    sum += geodesics.distance(p);
  const double end = now();
  return {computed - begin, sum > 0. ? (end - start) / double(points.size()) : 0.};
}

void compare(const std::string& file, int trials, int cgal_trials)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::fprintf(stderr, "%s is no triangle mesh\n", file.c_str());
    return;
  }
  const Vertex source(0);
  std::vector<double> distances(num_vertices(mesh));
  std::size_t windows = 0;
  const Times plain = time_ours(mesh, source, false, false, trials, distances, windows);
  const Times directed = time_ours(mesh, source, true, false, trials, distances, windows);
  const Times centroids = time_ours(mesh, source, false, true, trials, distances, windows);
  std::printf("%s: %zu faces, %.2f M windows\n", file.c_str(), std::size_t(num_faces(mesh)), windows * 1e-6);
  std::printf("  mesh to distances                 %8.5f s (of it reading the mesh %.5f; one more source %.5f)\n",
              plain.total, plain.read, plain.again);
  std::printf("  mesh to distances and directions  %8.4f s\n", directed.total);
  std::printf("  ... and to centroids              %8.4f s\n", centroids.total);
  std::printf("  a point that is named afterwards  %8.6f s\n", time_of_point(mesh).point);
  if(cgal_trials == 0)
    return;
  std::vector<double> cgal_times;
  double difference = 0.;
  for(int i = 0; i < cgal_trials; ++i)
  {
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> shortest_path(mesh);
    shortest_path.add_source_point(source);
    const double start = now();
    shortest_path.build_sequence_tree();
    cgal_times.push_back(now() - start);
    for(Vertex v : mesh.vertices())
    {
      const double d = shortest_path.shortest_distance_to_source_points(v).first;
      if(d > 0.)
        difference = (std::max)(difference, std::fabs(d - distances[v]) / d);
    }
  }
  const double cgal = median(cgal_times);
  std::printf("  CGAL's sequence tree              %8.4f s: ratio %.0f, with directions %.0f\n", cgal,
              cgal / plain.total, cgal / directed.total);
  std::printf("  largest relative difference of the distances %.2g\n", difference);
}

Mesh torus(std::size_t faces)
{
  // quadrilaterals of about the same width both ways
  const std::size_t n = static_cast<std::size_t>(std::sqrt(0.5 * faces * 2.)), m = faces / 2 / n;
  return jittered_torus<Mesh>(n, m);
}

/// the slope of a line fitted to the logarithms
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
  double sx = 0., sy = 0., sxx = 0., sxy = 0.;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u;
    sy += v;
    sxx += u * u;
    sxy += u * v;
  }
  const double n = double(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// `csv` may be null
void growth(std::size_t largest, std::FILE* csv)
{
  std::vector<double> sizes, times, counts;
  const auto print = [csv](const char* line)
  {
    std::puts(line);
    std::fflush(stdout);
    if(csv != nullptr)
    {
      std::fprintf(csv, "%s\n", line);
      // nothing may be left for the child processes to write
      std::fflush(csv);
    }
  };
  print("faces,mesh_to_distances_s,directions_s,peak_mb,mesh_only_mb,windows");
  std::vector<std::size_t> wanted;
  for(std::size_t faces = 12500; faces < largest; faces *= 2)
    wanted.push_back(faces);
  wanted.push_back(largest);
  for(const std::size_t faces : wanted)
  {
    // a process of its own per size, so that the peak of the memory is its own
    int channel[2];
    if(pipe(channel) != 0)
      return;
    const pid_t child = fork();
    if(child < 0)
      return;
    if(child == 0)
    {
      double result[6];
      const Mesh mesh = torus(faces);
      result[4] = measuring::peak_megabytes();
      std::vector<double> distances(num_vertices(mesh));
      std::size_t windows = 0;
      result[0] = double(num_faces(mesh));
      result[1] = time_ours(mesh, Vertex(0), false, false, 3, distances, windows).total;
      result[2] = time_ours(mesh, Vertex(0), true, false, 3, distances, windows).total;
      result[3] = measuring::peak_megabytes();
      result[5] = double(windows);
      const bool written = write(channel[1], result, sizeof(result)) == ssize_t(sizeof(result));
      _exit(written ? 0 : 1);
    }
    double result[6];
    const bool have_read = read(channel[0], result, sizeof(result)) == ssize_t(sizeof(result));
    waitpid(child, nullptr, 0);
    close(channel[0]);
    close(channel[1]);
    if(!have_read)
      return;
    char line[160];
    std::snprintf(line, sizeof(line), "%.0f,%.4f,%.4f,%.0f,%.0f,%.0f", result[0], result[1], result[2], result[3],
                  result[4], result[5]);
    print(line);
    sizes.push_back(result[0]);
    times.push_back(result[1]);
    counts.push_back(result[5]);
  }
  if(sizes.size() > 1)
    std::printf("exponent of the time %.3f, of the windows %.3f\n", exponent(sizes, times), exponent(sizes, counts));
}

/// `csv` may be null
void points(std::size_t largest, std::FILE* csv)
{
  for(std::FILE* file : {stdout, csv})
    if(file != nullptr)
      std::fprintf(file, "faces,source_s,point_s\n");
  for(std::size_t faces = 25000; faces <= largest; faces *= 4)
  {
    const Mesh mesh = torus(faces);
    const Time_of_point time = time_of_point(mesh);
    for(std::FILE* file : {stdout, csv})
      if(file != nullptr)
        std::fprintf(file, "%zu,%.4f,%.6f\n", std::size_t(num_faces(mesh)), time.all, time.point);
  }
}

} // namespace

int main(int argc, char** argv)
{
  int trials = 5, cgal_trials = 1;
  const char* csv_file = nullptr;
  bool done = false;
  for(int i = 1; i < argc; ++i)
  {
    if(std::strcmp(argv[i], "--cpu") == 0)
      measures_processor_time = true;
    else if(std::strcmp(argv[i], "--error") == 0 && i + 1 < argc)
      maximum_relative_error = std::atof(argv[++i]);
    else if(std::strcmp(argv[i], "--growth") == 0 || std::strcmp(argv[i], "--points") == 0)
    {
      const auto measure = std::strcmp(argv[i], "--growth") == 0 ? growth : points;
      const bool has_size = i + 1 < argc && std::atoi(argv[i + 1]) > 0;
      std::FILE* csv = csv_file == nullptr ? nullptr : std::fopen(csv_file, "w");
      if(csv_file != nullptr && csv == nullptr)
      {
        std::fprintf(stderr, "cannot write %s\n", csv_file);
        return EXIT_FAILURE;
      }
      measure(has_size ? std::size_t(std::atoi(argv[++i])) : 1600000, csv);
      if(csv != nullptr)
        std::fclose(csv);
    }
    else if(std::strcmp(argv[i], "--csv") == 0 && i + 1 < argc)
      csv_file = argv[++i];
    else if(std::strcmp(argv[i], "--trials") == 0 && i + 1 < argc)
      trials = (std::max)(1, std::atoi(argv[++i]));
    else if(std::strcmp(argv[i], "--cgal-trials") == 0 && i + 1 < argc)
      cgal_trials = std::atoi(argv[++i]);
    else
      compare(argv[i], trials, cgal_trials);
    done = true;
  }
  if(!done)
    std::fprintf(stderr,
                 "usage: %s [--cpu] [--error e] [--trials n] [--cgal-trials n] mesh...\n"
                 "       | [--cpu] [--error e] [--csv file] --growth [faces] | --points [faces]\n",
                 argv[0]);
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
