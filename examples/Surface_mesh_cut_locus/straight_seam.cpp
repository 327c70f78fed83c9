// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Splits the faces along the cut locus, for seams that do not zigzag along the edges of the mesh.

#include <CGAL/compute_cut_locus.h>
#include <CGAL/cut_along_cut_locus.h>
#include <CGAL/refine_along_cut_locus.h>

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
  const auto cut_locus = CGAL::compute_cut_locus(mesh, *mesh.vertices().begin());

  Mesh refined;
  const auto is_seam = refined.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  CGAL::refine_along_cut_locus(mesh, cut_locus, refined, CGAL::parameters::default_values(),
                               CGAL::parameters::edge_is_constrained_map(is_seam));
  const auto seams =
    std::count_if(refined.edges_begin(), refined.edges_end(), [&](Mesh::Edge_index e) { return is_seam[e]; });
  std::cout << mesh.number_of_faces() << " faces become " << refined.number_of_faces() << ", with " << seams
            << " edges on the cut locus.\n";

  Mesh disk;
  CGAL::cut_along_cut_locus(mesh, cut_locus, disk);
  return CGAL::IO::write_polygon_mesh("disk.off", disk) ? EXIT_SUCCESS : EXIT_FAILURE;
}
