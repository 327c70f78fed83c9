// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A geodesic solver of one's own: two functions on a mesh in arrays. This one walks along edges, from vertex to vertex; a
// better one would be put here in the same way.

#include <CGAL/Cut_loci/Laplacian_method.h> // the method that takes any distances
#include <CGAL/compute_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CGAL::Cut_loci::Index;

class Edge_path_solver // a model of GeodesicSolver
{
public:
  // once for each component of a mesh
  void set_mesh(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh)
  {
    mesh_ = &mesh;
    neighbors_.assign(mesh.number_of_vertices(), {});
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      neighbors_[mesh.source(h)].push_back(mesh.target(h));
      if(mesh.is_border_edge(h))
        neighbors_[mesh.target(h)].push_back(mesh.source(h));
    }
  }

  // once for each source, a point of a face
  void compute_distances(const CGAL::Cut_loci::Indexed_source& source, std::vector<double>& distances) const
  {
    using Item = std::pair<double, Index>;
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
    distances.assign(mesh_->number_of_vertices(), std::numeric_limits<double>::infinity());
    const auto reach = [&](Index v, double distance)
    {
      if(distance >= distances[v])
        return;
      distances[v] = distance;
      queue.push({distance, v});
    };
    std::array<double, 3> point = {{0., 0., 0.}};
    const auto& corners = mesh_->triangles[source.location.face];
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        point[k] += source.location.coordinates[i] * mesh_->points[corners[i]][k];
    for(Index v : corners)
      reach(v, distance(point, mesh_->points[v]));
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d == distances[v])
        for(Index w : neighbors_[v])
          reach(w, d + distance(mesh_->points[v], mesh_->points[w]));
    }
  }

private:
  static double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  const CGAL::Cut_loci::Indexed_triangle_mesh* mesh_ = nullptr;
  std::vector<std::vector<Index>> neighbors_;
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const Mesh::Vertex_index source = *mesh.vertices().begin();
  const auto rough = CGAL::compute_cut_locus(mesh, source, CGAL::parameters::geodesic_solver(Edge_path_solver()));
  const auto exact = CGAL::compute_cut_locus(mesh, source);
  std::cout << "The farthest vertex is at " << rough.distance(rough.farthest_vertex()) << " along edges, and at "
            << exact.distance(exact.farthest_vertex()) << " in truth.\n";
  return EXIT_SUCCESS;
}
