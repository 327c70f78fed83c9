// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertices = std::vector<Mesh::Vertex_index>;
using Edges = std::vector<Mesh::Edge_index>;

namespace params = CGAL::parameters;

int main()
{
  // a rectangle, of 3 x 1
  Mesh mesh;
  CGAL::make_grid(30, 10, mesh, [](std::size_t i, std::size_t j) { return Kernel::Point_3(0.1 * i, 0.1 * j, 0.); });
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);

  // a polyhedron, of which nothing is left out: also the branches from its corners
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method()));
  solver.set_sources(Vertices(), params::source_border(true));
  const auto medial_axis = solver.cut_locus();
  std::cout << "The medial axis has the length " << CGAL::Cut_loci::compute_statistics(medial_axis).length
            << ", and no point is farther than " << medial_axis.distance(medial_axis.farthest_vertex())
            << " from the border.\n";

  // two of its sides, and a vertex
  std::vector<Edges> sides(2);
  for(const Mesh::Edge_index e : mesh.edges())
    for(std::size_t k = 0; k < 2; ++k)
      if(mesh.point(mesh.vertex(e, 0)).x() == 3. * k && mesh.point(mesh.vertex(e, 1)).x() == 3. * k)
        sides[k].push_back(e);
  solver.set_sources(Vertices{Mesh::Vertex_index(15)}, params::source_curves(sides));
  const auto diagram = solver.cut_locus(params::kept_part(CGAL::Cut_loci::Kept_part::VORONOI));
  const auto& graph = diagram.graph();
  std::size_t number_between_sides = 0;
  for(const auto e : CGAL::make_range(edges(graph)))
    number_between_sides +=
      graph[e].sources[0] == 1; // the vertex comes first: it is source 0, and the sides are 1 and 2
  std::cout << "The diagram of a vertex and two sides has " << num_edges(graph) << " edges, " << number_between_sides
            << " of them between the sides.\n";
  return CGAL::IO::write_cut_locus("medial_axis.polylines.txt", medial_axis) ? EXIT_SUCCESS : EXIT_FAILURE;
}
