// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A surface that is not in space: the flat torus, a square whose opposite sides are one. Edges have lengths, and points are
// only where the result is drawn.

#include <CGAL/compute_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  const int n = 24; // squares along each side, of the length 1
  Mesh mesh;
  std::vector<Mesh::Vertex_index> grid;
  for(int k = 0; k < n * n; ++k)
    grid.push_back(mesh.add_vertex(Point(k % n, k / n, 0.)));
  const auto vertex = [&](int i, int j) { return grid[(j % n) * n + i % n]; };
  auto lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1.).first;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      lengths[mesh.edge(mesh.halfedge(vertex(i, j), vertex(i + 1, j + 1)))] = std::sqrt(2.);
    }

  const auto cut_locus = CGAL::compute_cut_locus(mesh, vertex(0, 0), CGAL::parameters::edge_length_map(lengths));
  const auto& graph = cut_locus.graph();
  double nearest = n, farthest = 0.;
  for(const auto v : CGAL::make_range(vertices(graph)))
  {
    nearest = (std::min)(nearest, graph[v].distance);
    farthest = (std::max)(farthest, graph[v].distance);
  }
  std::cout << "The cut locus has " << num_edges(graph) + 1 - num_vertices(graph) << " cycles, at distances from "
            << nearest << " to " << farthest << ": the sides of the square around the source\n";
  return EXIT_SUCCESS;
}
