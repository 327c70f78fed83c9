// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The largest disk around a point in which every other point has one shortest path to it.

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/compute_cut_locus.h>

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

  const auto cut_locus = CGAL::compute_cut_locus(mesh, *mesh.vertices().begin());
  const auto radius = CGAL::Cut_loci::injectivity_radius(cut_locus);
  std::cout << "The injectivity radius is " << radius.distance << ", reached at (" << radius.point << "), "
            << (radius.edge ? "within an edge" : "at a vertex") << " of the cut locus.\n"
            << "Branches that are left out may be nearer: the polyhedron has none within " << radius.lower_bound
            << ".\n";
  return EXIT_SUCCESS;
}
