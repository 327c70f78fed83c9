// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Regions that no path may cross: the way around what blocks the shortest path.

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
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

  const Mesh::Vertex_index source = *mesh.vertices().begin(), target = *std::prev(mesh.vertices().end());
  Geodesics geodesics(mesh);
  geodesics.compute(source);
  std::vector<Geodesics::Face_location> path;
  geodesics.shortest_path(target, std::back_inserter(path));

  // the faces around the middle of the path
  auto excluded = mesh.add_property_map<Mesh::Face_index, bool>("f:excluded", false).first;
  const Mesh::Face_index middle = path[path.size() / 2].first;
  for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(middle)))
    for(const Mesh::Face_index f : mesh.faces_around_target(mesh.halfedge(v)))
      if(f != Mesh::null_face())
        excluded[f] = true;

  Geodesics around(mesh, CGAL::parameters::face_is_excluded_map(excluded));
  around.compute(source);
  std::cout << "The shortest path has the length " << geodesics.distance(target) << ", and around the region "
            << around.distance(target) << ".\n";
  return EXIT_SUCCESS;
}
