// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_BUILD_FACE_GRAPH_H
#define CGAL_CUT_LOCI_FACE_GRAPH_BUILD_FACE_GRAPH_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL::Cut_loci::internal {

template <typename FaceGraph>
struct Built_face_graph
{
  using Traits = boost::graph_traits<FaceGraph>;

  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::halfedge_descriptor> halfedges; // halfedge `3 * f + i` of the dense mesh
};

// Adds the mesh to a model of MutableFaceGraph, but for the points; halfedge(f) starts at the first corner of the face.
// It is glued halfedge by halfedge: two edges may join the same two vertices, which functions that add faces refuse.
template <typename FaceGraph>
Built_face_graph<FaceGraph> build_face_graph(const Indexed_triangle_mesh& mesh, FaceGraph& graph)
{
  using Traits = boost::graph_traits<FaceGraph>;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  Built_face_graph<FaceGraph> result;
  result.vertices.reserve(mesh.number_of_vertices());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    result.vertices.push_back(add_vertex(graph));

  const Index nh = mesh.number_of_halfedges();
  std::vector<halfedge_descriptor>& halfedges = result.halfedges;
  halfedges.resize(nh);
  for(Index h = 0; h < nh; ++h)
  {
    const bool is_new = mesh.is_border_edge(h) || h < mesh.opposite[h];
    halfedges[h] = is_new ? halfedge(add_edge(graph), graph) : opposite(halfedges[mesh.opposite[h]], graph);
    set_target(halfedges[h], result.vertices[mesh.target(h)], graph);
    set_halfedge(result.vertices[mesh.target(h)], halfedges[h], graph);
  }
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    const face_descriptor face = add_face(graph);
    set_halfedge(face, halfedges[3 * f], graph);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      set_face(halfedges[h], face, graph);
      set_next(halfedges[h], halfedges[mesh.next(h)], graph);
    }
  }
  for(Index h = 0; h < nh; ++h)
  {
    if(!mesh.is_border_edge(h))
      continue;
    const halfedge_descriptor border = opposite(halfedges[h], graph);
    set_face(border, Traits::null_face(), graph);
    set_target(border, result.vertices[mesh.source(h)], graph);
    set_halfedge(result.vertices[mesh.source(h)], border, graph);
    Index last = mesh.previous(h); // around the vertex to its other border edge
    while(!mesh.is_border_edge(last))
      last = mesh.previous(mesh.opposite[last]);
    set_next(border, opposite(halfedges[last], graph), graph);
  }
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_BUILD_FACE_GRAPH_H
