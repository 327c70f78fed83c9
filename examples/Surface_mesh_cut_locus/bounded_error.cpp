// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A fine mesh whose source moves: while it does, distances may be wrong by a thousandth; where it stops they are exact.

#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  if(argc == 1)
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, params::number_of_iterations(3));

  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh);
  CGAL::Real_timer timer;
  for(Mesh::size_type i = 0; i < 4; ++i)
  {
    const Mesh::Vertex_index source(i);
    const double error = i < 3 ? 1e-3 : 0.;
    timer.reset();
    timer.start();
    solver.set_source(source, params::maximum_relative_error(error));
    const auto cut_locus = solver.cut_locus();
    timer.stop();
    std::cout << "an error of " << error << " at most: " << num_edges(cut_locus.graph())
              << " segments, the farthest vertex at " << cut_locus.distance(cut_locus.farthest_vertex()) << ", "
              << timer.time() << " s\n";
  }
  return EXIT_SUCCESS;
}
