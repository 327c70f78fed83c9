// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cells of a geodesic Voronoi diagram: their areas, and which of them touch along what length.

#include <CGAL/Cut_loci/voronoi_neighbors.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
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

  std::vector<Mesh::Vertex_index> sources;
  for(Mesh::size_type i = 0; i < 6; ++i)
    sources.push_back(Mesh::Vertex_index(i * mesh.number_of_vertices() / 6));
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  solver.set_sources(sources);
  const auto diagram = solver.cut_locus(CGAL::parameters::kept_part(CGAL::Cut_loci::Kept_part::VORONOI));

  const std::vector<double> areas = CGAL::Cut_loci::voronoi_cell_areas(mesh, diagram);
  for(std::size_t i = 0; i < areas.size(); ++i)
    std::cout << "The cell of " << sources[i] << " has the area " << areas[i] << ".\n";
  for(const auto& [pair, length] : CGAL::Cut_loci::voronoi_neighbors(diagram)) // the edges of the dual graph
    std::cout << "Those of " << sources[pair[0]] << " and " << sources[pair[1]] << " touch along " << length << ".\n";
  return EXIT_SUCCESS;
}
