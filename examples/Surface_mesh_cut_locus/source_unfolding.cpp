// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The convex hull of a mesh, cut along the cut locus of a point and laid flat.

#include <CGAL/Cut_loci/source_unfolding.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/convex_hull_3.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh, hull;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::convex_hull_3(mesh.points().begin(), mesh.points().end(), hull);

  // a point in a face
  const std::pair<Mesh::Face_index, std::array<double, 3>> source(*hull.faces().begin(), {{0.2, 0.5, 0.3}});
  try
  {
    const auto unfolding = CGAL::Cut_loci::source_unfolding(hull, source);
    std::cout << "A polygon of " << unfolding.corners.size() << " corners, with " << unfolding.fold_lines.size()
              << " fold lines. Its first edges:\n";
    for(std::size_t i = 0; i < 3 && i < unfolding.corners.size(); ++i)
      std::cout << "  from (" << unfolding.corners[i].point << "), glued to edge " << unfolding.corners[i].glued_to
                << "\n";
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    std::cerr << error.what() << std::endl; // some sources are refused
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
