// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Exact distances from curves: a loop of edges, and a point beside it.

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
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

  // the loop of edges around a vertex; with add_source_border(), each loop of the border is a source
  std::vector<Mesh::Edge_index> loop;
  for(const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(*mesh.vertices().begin())))
    if(!mesh.is_border(h))
      loop.push_back(mesh.edge(mesh.prev(h)));
  Geodesics geodesics(mesh);
  geodesics.add_source(*std::next(mesh.vertices().begin(), mesh.number_of_vertices() / 2));
  geodesics.add_source_curve(loop);
  geodesics.compute();

  std::vector<std::size_t> size(geodesics.number_of_sources(), 0);
  for(const Mesh::Vertex_index v : mesh.vertices())
    ++size[geodesics.nearest_source(v)]; // points have the first numbers
  std::cout << size[0] << " vertices are nearer to the point, and " << size[1] << " to the loop.\n";

  const Mesh::Vertex_index last = *std::prev(mesh.vertices().end());
  std::vector<Geodesics::Face_location> path;
  geodesics.shortest_path(last, std::back_inserter(path));
  std::cout << last << " is at the distance " << geodesics.distance(last) << ", by a path of " << path.size()
            << " points.\n";
  return EXIT_SUCCESS;
}
