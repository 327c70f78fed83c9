// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// CGAL::Polyhedron_3, without ids: any model of FaceListGraph will do. The graph of the cut locus is one for the algorithms
// of Boost; here its vertices are visited.

#include <CGAL/compute_cut_locus.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto cut_locus = CGAL::compute_cut_locus(mesh, *vertices(mesh).begin());
  const auto& graph = cut_locus.graph();
  for(auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) != 2)
      std::cout << (degree(v, graph) < 2 ? "a tip" : "a branching") << " at " << graph[v].point << ", at the distance "
                << graph[v].distance << '\n';
  return EXIT_SUCCESS;
}
