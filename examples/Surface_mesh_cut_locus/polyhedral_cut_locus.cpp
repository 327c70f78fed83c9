// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The mesh at its word: the cut locus of a cube itself, with a branch to each of its corners.

#include <CGAL/compute_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point = Kernel::Point_3;

int main()
{
  Mesh cube;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), cube);
  CGAL::Polygon_mesh_processing::triangulate_faces(cube);

  const std::pair<Mesh::Face_index, std::array<double, 3>> source(*cube.faces().begin(), {{0.5, 0.2, 0.3}});
  const auto cut_locus =
    CGAL::compute_cut_locus(cube, source, CGAL::parameters::cut_locus_method(CGAL::Cut_loci::Polyhedral_method()));
  const auto& graph = cut_locus.graph();
  std::size_t corners = 0;
  for(auto v : CGAL::make_range(vertices(graph)))
    if(graph[v].mesh_vertex != Mesh::null_vertex())
    {
      ++corners;
      std::cout << "corner (" << graph[v].point << ") is at the distance " << graph[v].distance << '\n';
    }
  return corners == num_vertices(cube) ? EXIT_SUCCESS : EXIT_FAILURE;
}
