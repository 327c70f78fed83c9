// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Another geodesic solver: CGAL's heat method, which approximates. It factors two matrices once for the mesh and all vertices
// as sources; a source inside of a face would take new ones. The edges of the cut locus are marked in a property map.

#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
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

  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh,
                                            CGAL::parameters::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()));
  auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  for(const Mesh::size_type i : {Mesh::size_type(0), mesh.number_of_vertices() / 2})
  {
    solver.set_source(Mesh::Vertex_index(i));
    for(const Mesh::Edge_index e : mesh.edges())
      is_cut[e] = false;
    solver.cut_locus(
      CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES).edge_is_constrained_map(is_cut));
    std::cout << "source " << i << ": "
              << std::count_if(mesh.edges_begin(), mesh.edges_end(), [&](Mesh::Edge_index e) { return is_cut[e]; })
              << " edges to cut\n";
  }
  return EXIT_SUCCESS;
}
