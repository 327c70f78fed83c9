// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_SHORTEST_PATH_GEODESIC_SOLVER_H
#define SURFACE_MESH_CUT_LOCUS_SHORTEST_PATH_GEODESIC_SOLVER_H

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {

// Exact geodesic distances by CGAL::Surface_mesh_shortest_path, to check those of the package by: slow, a sequence tree for
// 100 000 faces takes many seconds. A model of GeodesicSolver.
class Shortest_path_geodesic_solver
{
public:
  void set_mesh(const Cut_loci::Indexed_triangle_mesh& mesh)
  {
    input_ = &mesh;
    mesh_ = std::make_shared<const Mesh>(mesh);
  }

  void compute_distances(const Cut_loci::Indexed_source& source, std::vector<double>& distances)
  {
    compute_distances(std::vector<Cut_loci::Indexed_source>(1, source), distances);
  }

  /// computes the distances to the nearest of several sources, in one run
  void compute_distances(const std::vector<Cut_loci::Indexed_source>& sources, std::vector<double>& distances)
  {
    const bool is_whole = mesh_->is_whole();
    if(std::none_of(sources.begin(), sources.end(),
                    [&](const Cut_loci::Indexed_source& source)
                    { return is_whole ? is_on_edge(source) : source.vertex == Cut_loci::null_index; }))
      return compute_distances(*mesh_, sources, distances);
    // CGAL 5.5 takes the mirror image of a source on an edge, on the border as inside: there it becomes a vertex of its own,
    // and everywhere if faces have other numbers.
    const Cut_loci::internal::Divided_mesh refined(*input_, sources);
    std::vector<Cut_loci::Indexed_source> inserted = sources;
    for(std::size_t i = 0; i < sources.size(); ++i)
      inserted[i].vertex = refined.vertices()[i];
    compute_distances(Mesh(refined.mesh()), inserted, distances);
    distances.resize(input_->number_of_vertices());
  }

private:
  using Mesh = Cut_loci::internal::Mesh_of_points;
  using Vertex = Cut_loci::internal::Geodesic_mesh::Vertex_index;
  using Face = Cut_loci::internal::Geodesic_mesh::Face_index;
  using Traits =
    CGAL::Surface_mesh_shortest_path_traits<Cut_loci::internal::Geodesic_kernel, Cut_loci::internal::Geodesic_mesh>;
  using Shortest_path = CGAL::Surface_mesh_shortest_path<Traits>;

  static bool is_on_edge(const Cut_loci::Indexed_source& source)
  {
    const std::array<double, 3>& c = source.location.coordinates;
    return source.vertex == Cut_loci::null_index && std::find(c.begin(), c.end(), 0.) != c.end();
  }

  static void compute_distances(const Mesh& mesh, const std::vector<Cut_loci::Indexed_source>& sources,
                                std::vector<double>& distances)
  {
    Shortest_path solver(mesh.mesh);
    for(const Cut_loci::Indexed_source& source : sources)
      if(source.vertex != Cut_loci::null_index)
        solver.add_source_point(mesh.vertex(source.vertex));
      else
      {
        const std::array<double, 3>& c = source.location.coordinates;
        solver.add_source_point(Face(source.location.face), {{c[0], c[1], c[2]}});
      }
    solver.build_sequence_tree();
    const auto distance = [&](Vertex v)
    {
      const double d = solver.shortest_distance_to_source_points(v).first;
      return d < 0. ? (std::numeric_limits<double>::infinity)() : d;
    };
    mesh.get_values(distance, distances);
  }

  const Cut_loci::Indexed_triangle_mesh* input_ = nullptr;
  std::shared_ptr<const Mesh> mesh_;
};

} // namespace CGAL

#endif // SURFACE_MESH_CUT_LOCUS_SHORTEST_PATH_GEODESIC_SOLVER_H
