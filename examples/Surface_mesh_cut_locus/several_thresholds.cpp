// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The class: what depends on the mesh is computed once, what depends on the source once for each source, and a threshold
// costs next to nothing.

#include <CGAL/Surface_mesh_cut_locus.h>

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

  try
  {
    CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
    for(Mesh::size_type i : {Mesh::size_type(0), mesh.number_of_vertices() / 2})
    {
      const Mesh::Vertex_index source = *(mesh.vertices_begin() + i);
      solver.set_source(source);
      // Widths are in diagonals of the bounding box. Below the default for the mesh, the first call computes more.
      for(double factor : {0.1, 0.5, 1., 2.})
      {
        const double width = factor * solver.minimum_branch_width();
        const auto cut_locus = solver.cut_locus(
          CGAL::parameters::cut_locus_method(CGAL::Cut_loci::Default_method().minimum_branch_width(width)));
        std::cout << "source " << source << ", branches of width " << width
                  << " or more: " << num_edges(cut_locus.graph()) << " edges\n";
      }
    }
  }
  catch(const CGAL::Cut_loci::Invalid_input& error) // the mesh is not triangulated, for example
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
