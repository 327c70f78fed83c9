// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Another geodesic solver: CGAL's heat method is fast, and approximates. Here the source is a point inside a face, and the
// edges of the cut locus are marked, ready for CGAL::Seam_mesh.

#include <CGAL/compute_cut_locus.h>
#include <CGAL/Heat_method_geodesic_solver.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const Face_location source(*mesh.faces().begin(), {{0.2, 0.3, 0.5}});
  auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto cut_locus = CGAL::compute_cut_locus(
    mesh, source,
    CGAL::parameters::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()).edge_is_constrained_map(is_cut));

  const auto number_of_cut_edges =
    std::count_if(mesh.edges_begin(), mesh.edges_end(), [&](Mesh::Edge_index e) { return get(is_cut, e); });
  std::cout << "source at " << cut_locus.source().point << ", " << number_of_cut_edges << " edges to cut\n";
  return EXIT_SUCCESS;
}
