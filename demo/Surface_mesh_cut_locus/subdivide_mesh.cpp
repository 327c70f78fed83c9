// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Refines a triangle mesh by Loop subdivision: subdivide_mesh INPUT OUTPUT STEPS

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const int steps = argc == 4 ? std::atoi(argv[3]) : 0;
  if(steps < 1 || steps > 6)
  {
    std::cerr << "Usage: subdivide_mesh INPUT OUTPUT STEPS, with 1 to 6 steps" << std::endl;
    return EXIT_FAILURE;
  }
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argv[1], mesh) || CGAL::is_empty(mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "subdivide_mesh: '" << argv[1] << "' is not a triangle mesh that can be read" << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(steps));
  if(!CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "subdivide_mesh: cannot write to '" << argv[2] << "'" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
