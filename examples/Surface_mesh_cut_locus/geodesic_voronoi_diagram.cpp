// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Several sources: samples each as far as possible from those before, and their geodesic Voronoi diagram.

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Surface_mesh_cut_locus.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // farthest-point sampling: only what is nearer to the last sample than to all others has to be computed
  std::vector<Mesh::Vertex_index> samples(1, *mesh.vertices().begin());
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics(mesh);
  std::vector<double> distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(const std::size_t number = 20; samples.size() < number;)
  {
    geodesics.compute(samples.back());
    for(const Mesh::Vertex_index v : mesh.vertices())
      distance[v] = (std::min)(distance[v], geodesics.distance(v));
    const auto farthest = std::max_element(distance.begin(), distance.end());
    geodesics.set_maximum_distance(*farthest);
    samples.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(farthest - distance.begin())));
  }

  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  solver.set_sources(samples);
  const auto diagram =
    solver.cut_locus(CGAL::parameters::kept_part(CGAL::Cut_loci::Kept_part::VORONOI)); // no cut loci inside cells
  std::vector<std::size_t> size(diagram.number_of_sources(), 0);
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const auto cell = diagram.nearest_source(v))
      ++size[*cell];
  std::cout << "The geodesic Voronoi diagram of " << size.size() << " samples has cells of "
            << *std::min_element(size.begin(), size.end()) << " to " << *std::max_element(size.begin(), size.end())
            << " vertices; no point is farther than " << diagram.distance(diagram.farthest_vertex())
            << " from a sample.\n";
  return CGAL::IO::write_cut_locus("voronoi.polylines.txt", diagram) ? EXIT_SUCCESS : EXIT_FAILURE;
}
