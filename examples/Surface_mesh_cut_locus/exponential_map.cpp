// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The exponential map: straight walks from a point in twelve directions, and how far their ends are.

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const double length = argc > 2 ? std::stod(argv[2]) : 6.; // in the unit of the points
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  Geodesics geodesics(mesh);
  geodesics.compute(source);
  std::vector<Geodesics::Face_location> ends;
  const std::size_t number = 12;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double angle = 2. * 3.14159265358979323846 * double(i) / double(number); // from geodesics.source_halfedge()
    ends.push_back(geodesics.exponential_map({{length * std::cos(angle), length * std::sin(angle)}}));
  }

  // behind the cut locus, a straight walk goes on, but it is no longer the shortest path to its end
  for(std::size_t i = 0; i < number; ++i)
    std::cout << "The walk number " << i << " ends at ("
              << CGAL::Polygon_mesh_processing::construct_point(ends[i], mesh) << "), at the distance "
              << geodesics.distance(ends[i]) << ".\n";
  return EXIT_SUCCESS;
}
