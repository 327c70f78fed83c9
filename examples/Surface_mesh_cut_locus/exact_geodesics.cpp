// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The exact geodesic solver on its own: distances with one call, and directions and a shortest path with the class.

#include <CGAL/Surface_mesh_exact_geodesics.h>
#include <CGAL/exact_geodesic_distances.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
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

  const Vertex source = *mesh.vertices().begin();
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  CGAL::exact_geodesic_distances(mesh, source, distance);
  const Vertex farthest = *std::max_element(mesh.vertices_begin(), mesh.vertices_end(),
                                            [&](Vertex v, Vertex w) { return distance[v] < distance[w]; });
  std::cout << "the vertex farthest from " << source << " is " << farthest << ", at the distance " << distance[farthest]
            << '\n';

  // the class keeps the geometry of the mesh for further sources
  Geodesics geodesics(mesh);
  geodesics.set_directions(true);
  geodesics.compute(source);
  std::cout << "the shortest path starts at the angle " << geodesics.direction_at_source(farthest) << " of "
            << geodesics.source_angle() << " from " << geodesics.source_halfedge() << " and, backwards, runs along\n";
  std::vector<Geodesics::Face_location> path;
  geodesics.shortest_path(farthest, std::back_inserter(path));
  for(const Geodesics::Face_location& location : path)
    std::cout << "  " << CGAL::Polygon_mesh_processing::construct_point(location, mesh) << '\n';
  return EXIT_SUCCESS;
}
