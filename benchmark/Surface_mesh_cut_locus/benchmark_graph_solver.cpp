// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors
//
// The time per source of the graph solver over that of CGAL's exact one, in one run, and its error relative to the
// exact distances. Arguments: mesh files.

#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Graph_geodesic_solver.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Exact_mesh = CGAL::Cut_loci::internal::Geodesic_mesh;
using Exact_traits = CGAL::Surface_mesh_shortest_path_traits<CGAL::Cut_loci::internal::Geodesic_kernel, Exact_mesh>;
using Exact = CGAL::Surface_mesh_shortest_path<Exact_traits>;

template <typename Function>
double seconds(const Function& f)
{
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

int main(int argc, char** argv)
{
  std::printf("%-34s %8s %10s %12s %10s %10s %10s %10s\n", "mesh", "faces", "build (s)", "source (s)", "exact (s)",
              "ratio", "error mean", "max");
  for(int i = 1; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh) || !CGAL::is_triangle_mesh(mesh))
    {
      std::cerr << argv[i] << " is not a triangle mesh\n";
      return EXIT_FAILURE;
    }
    const auto read = CGAL::Cut_loci::internal::read_triangle_mesh(mesh, mesh.points());

    CGAL::Cut_loci::Indexed_source source;
    source.vertex = 0;
    CGAL::Graph_geodesic_solver graph;
    std::vector<double> distances, times;
    const double build = seconds([&] { graph.set_mesh(read.mesh); });
    for(int k = 0; k < 5; ++k)
      times.push_back(seconds([&] { graph.compute_distances(source, distances); }));
    std::sort(times.begin(), times.end());

    const Exact_mesh copy = CGAL::Cut_loci::internal::surface_mesh_copy(read.mesh);
    Exact exact(copy);
    exact.add_source_point(Exact_mesh::Vertex_index(source.vertex));
    const double exact_time = seconds([&] { exact.build_sequence_tree(); });

    double mean = 0., max = 0.;
    std::size_t n = 0;
    for(Exact_mesh::Vertex_index v : copy.vertices())
    {
      const double d = exact.shortest_distance_to_source_points(v).first;
      if(!(d > 0.))
        continue;
      const double error = distances[v] / d - 1.;
      mean += error;
      max = (std::max)(max, error);
      ++n;
    }
    std::printf("%-34s %8u %10.4f %12.6f %10.3f %10.6f %9.2f%% %9.2f%%\n", argv[i], unsigned(mesh.number_of_faces()),
                build, times[2], exact_time, times[2] / exact_time, 100. * mean / double(n), 100. * max);
  }
}
