// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The free function: the cut locus of a vertex, with the defaults.

#include <CGAL/compute_cut_locus.h>
#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/statistics.h>

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
  const auto cut_locus = CGAL::compute_cut_locus(mesh, source);

  const auto statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
  std::cout << "The cut locus of vertex " << source << " on a surface of genus " << cut_locus.genus() << " has "
            << statistics.edges << " edges and " << statistics.cycles << " independent cycles.\n"
            << "The injectivity radius is " << statistics.injectivity_radius << ", the farthest vertex is at "
            << cut_locus.distance(cut_locus.farthest_vertex()) << ".\n";
  if(!CGAL::IO::write_cut_locus("cut_locus.polylines.txt", cut_locus))
    return EXIT_FAILURE;
  return EXIT_SUCCESS;
}
