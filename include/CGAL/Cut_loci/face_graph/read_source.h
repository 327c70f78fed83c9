// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READ_SOURCE_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READ_SOURCE_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/read_triangle_mesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A halfedge of the dense mesh that leaves vertex `v`.
template <typename TriangleMesh>
Index outgoing_halfedge(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read, Index v)
{
  const auto h = halfedge(read.vertices[v], tm);
  for(auto around : CGAL::halfedges_around_target(h, tm))
  {
    const auto f = face(around, tm);
    if(f == boost::graph_traits<TriangleMesh>::null_face())
      continue;
    const Index fi = get(read.index_of_face, f);
    for(Index i = 0; i < 3; ++i)
      if(read.mesh.triangles[fi][i] == v)
        return 3 * fi + i;
  }
  throw Invalid_input("the source is an isolated vertex: no face is incident to it");
}

template <typename TriangleMesh>
Indexed_source source_at_vertex(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  if(v == boost::graph_traits<TriangleMesh>::null_vertex())
    throw Invalid_input("the source is the null vertex");
  // A descriptor of another mesh must not be used for a look-up: the search is linear, like all that a source costs.
  const auto found = std::find(read.vertices.begin(), read.vertices.end(), v);
  if(found == read.vertices.end())
  {
    for(auto w : CGAL::make_range(vertices(tm)))
      if(w == v)
        throw Invalid_input("the source is an isolated vertex: no face is incident to it");
    throw Invalid_input("the source is not a vertex of the mesh");
  }
  const Index index = static_cast<Index>(found - read.vertices.begin());
  const Index h = outgoing_halfedge(tm, read, index);
  Indexed_source source;
  source.vertex = index;
  source.location.face = h / 3;
  source.location.coordinates[h % 3] = 1.;
  return source;
}

// A coordinate up to `tolerance` is taken for zero; their sum becomes one.
template <typename TriangleMesh, typename FT>
Indexed_source source_in_face(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                              typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                              const std::array<FT, 3>& coordinates, double tolerance)
{
  if(f == boost::graph_traits<TriangleMesh>::null_face())
    throw Invalid_input("the face of the source is null");
  Indexed_source source;
  source.location.face = 0;
  while(source.location.face < read.mesh.number_of_faces() &&
        face(read.halfedges[3 * std::size_t(source.location.face)], tm) != f)
    ++source.location.face;
  if(source.location.face == read.mesh.number_of_faces())
    throw Invalid_input("the face of the source is not a face of the mesh");

  std::array<double, 3>& c = source.location.coordinates;
  double sum = 0.;
  for(int i = 0; i < 3; ++i)
  {
    c[i] = to_double(coordinates[i]);
    if(!std::isfinite(c[i]))
      throw Invalid_input("a barycentric coordinate of the source is not finite");
    if(c[i] < -tolerance)
      throw Invalid_input("a barycentric coordinate of the source is negative: it is outside its face");
    if(c[i] <= tolerance)
      c[i] = 0.;
    sum += c[i];
  }
  if(!std::isfinite(sum))
    throw Invalid_input("the sum of the barycentric coordinates of the source is not finite");
  if(!(sum > 0.))
    throw Invalid_input("the barycentric coordinates of the source sum up to zero");
  for(int i = 0; i < 3; ++i)
  {
    c[i] /= sum;
    if(c[i] == 1.)
      source.vertex = read.mesh.triangles[source.location.face][i];
  }
  return source;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READ_SOURCE_H
