// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Distances that one has: here those of CGAL's heat method, computed elsewhere, and one by one for each vertex in a property
// map. No solver runs, and the method is Cut_loci::Laplacian_method, which takes any distances.

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

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
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  const auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distance, source);

  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  try
  {
    solver.set_source(source, CGAL::parameters::vertex_distance_map(distance));
  }
  catch(const CGAL::Cut_loci::Invalid_input& error) // a negative distance, for example
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  // smoothed distances meet at narrower angles than exact ones
  const auto cut_locus = solver.cut_locus(
    CGAL::parameters::cut_locus_method(CGAL::Cut_loci::Laplacian_method().gradient_angle_threshold(0.4)));
  std::cout << "From distances that were given: " << num_edges(cut_locus.graph()) << " edges, by "
            << name_of(solver.method()) << ".\n";
  return EXIT_SUCCESS;
}
