// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_POINTS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_POINTS_H

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Surface_without_flat_faces.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

using Geodesic_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geodesic_mesh = CGAL::Surface_mesh<Geodesic_kernel::Point_3>;

// The mesh as CGAL's solvers take it, whatever the type it came from: with dense indices, one component, no garbage.
// Vertex `i` and face `i` keep their index, and halfedge(f) starts at the first vertex of the face.
inline Geodesic_mesh surface_mesh_copy(const Indexed_triangle_mesh& mesh)
{
  Geodesic_mesh result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_halfedges() / 2, mesh.number_of_faces());
  const auto built = build_face_graph(mesh, result);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    result.point(built.vertices[v]) = {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]};
  return result;
}

/// is a mesh as CGAL's solvers take it. They compute with points, and not with lengths that faces without area have in their
/// place, so it is the same surface without these faces.
class Mesh_of_points
{
public:
  explicit Mesh_of_points(Indexed_triangle_mesh input)
  {
    input.lengths.clear();
    if(needs_mollification(input))
      without_.reset(new Surface_without_flat_faces(input));
    number_of_vertices_ = input.number_of_vertices();
    mesh = surface_mesh_copy(without_ ? without_->mesh() : input);
  }

  Geodesic_mesh mesh;

  /// whether faces have kept their numbers
  bool is_whole() const { return !without_; }
  /// where a vertex of the input is
  Geodesic_mesh::Vertex_index vertex(Index v) const
  {
    return Geodesic_mesh::Vertex_index(without_ ? without_->vertex_without(v) : v);
  }

  /// values of the vertices of the input
  template <typename Value_of_vertex>
  void get_values(const Value_of_vertex& value, std::vector<double>& result) const
  {
    result.resize(number_of_vertices_);
    for(Index v = 0; v < number_of_vertices_; ++v)
      result[v] = value(vertex(v));
  }

private:
  std::unique_ptr<const Surface_without_flat_faces> without_; // if there are any
  Index number_of_vertices_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_POINTS_H
