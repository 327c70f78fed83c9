// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The vertex with the most room: the one whose injectivity radius is largest. Each thread has its own copy of the solver;
// all copies share what has been read of the mesh. CGAL::compute_cut_loci() does the same by TBB.

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  const std::size_t step = argc > 2 ? std::stoul(argv[2]) : 10;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh) || step == 0)
  {
    std::cerr << "Usage: sources_in_threads MESH [EVERY_NTH_VERTEX]" << std::endl;
    return EXIT_FAILURE;
  }
  const std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<double> radius(vertices.size(), 0.);

  CGAL::Surface_mesh_cut_locus<Mesh> original(mesh);
  original.prepare(vertices); // reads all that the copies share
  const std::size_t number = (std::max)(std::thread::hardware_concurrency(), 1u);
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < number; ++i)
    threads.emplace_back(
      [&, i, solver = original]() mutable
      {
      for(std::size_t k = i * step; k < vertices.size(); k += number * step)
      {
        solver.set_source(vertices[k]);
        const auto cut_locus = solver.cut_locus();
        radius[k] = CGAL::Cut_loci::injectivity_radius(cut_locus).distance;
      }
    });
  for(std::thread& t : threads)
    t.join();

  const auto best = std::max_element(radius.begin(), radius.end());
  std::cout << "Of each " << step << "th vertex, " << vertices[static_cast<std::size_t>(best - radius.begin())]
            << " has the largest injectivity radius: " << *best << "\n";
  return EXIT_SUCCESS;
}
