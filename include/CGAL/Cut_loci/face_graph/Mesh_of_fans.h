// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_FANS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_FANS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/reading/read_edge_lengths.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The named parameter `face_is_excluded_map`, or a map that excludes none.
template <typename TriangleMesh, typename NamedParameters>
auto excluded_faces(const NamedParameters& np)
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::face_is_excluded_map),
                                      Static_boolean_property_map<face_descriptor, false>());
}

/*!
 * is a mesh of the user's as the exact solver takes it, and the way there and back: without the faces that are excluded, and
 * where the faces at a vertex form several fans, as where excluded regions touch, with a vertex for each, as no path leads
 * from one to the other. All but the first come behind all others.
 */
template <typename TriangleMesh>
class Mesh_of_fans
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using Face_location = std::pair<typename Traits::face_descriptor, std::array<double, 3>>;

public:
  template <typename NamedParameters>
  Mesh_of_fans(const TriangleMesh& tm, const NamedParameters& np)
    : tm_(&tm), read_(read_triangle_mesh(tm, point_map(tm, np), !has_edge_lengths<NamedParameters>(), {},
                                         excluded_faces<TriangleMesh>(np)))
  {
    give_fans_vertices();
    read_edge_lengths(tm, read_, parameters::get_parameter(np, internal_np::edge_length_map));
    normalize_lengths(read_);
    if(needs_mollification(read_.mesh))
      read_.mesh.lengths = Mollification(read_.mesh).lengths;
  }

  const TriangleMesh& tm() const { return *tm_; }
  const Read_triangle_mesh<TriangleMesh>& read() const { return read_; }
  /// of lengths
  double unit() const { return read_.unit; }

  /// what a solver that has read the mesh has a copy of
  void forget_mesh()
  {
    read_.mesh = Indexed_triangle_mesh();
    std::vector<Index>().swap(read_.positions);
  }

  /// the number of `v`; of several copies, that of the one with the least `distance_of`
  template <typename Distance>
  Index index(vertex_descriptor v, const Distance& distance_of) const
  {
    Index nearest = get(read_.index_of_vertex, v);
    if(copies_.empty() || nearest == null_index)
      return nearest;
    const auto copies = copies_of(nearest);
    for(auto copy = copies.first; copy != copies.second; ++copy)
      if(distance_of(copy->second) < distance_of(nearest))
        nearest = copy->second;
    return nearest;
  }

  /// the number of a vertex that is a source
  Index source(vertex_descriptor v) const
  {
    if(v == Traits::null_vertex())
      throw Invalid_input(Cause::INVALID_SOURCE, "the source is the null vertex");
    const Index i = get(read_.index_of_vertex, v);
    if(i == null_index && halfedge(v, *tm_) == Traits::null_halfedge())
      throw Invalid_input(Cause::INVALID_SOURCE, "the source is an isolated vertex: it is on no face");
    if(i == null_index)
      throw Invalid_input(Cause::INVALID_SOURCE, "all faces at the source are excluded: it has to be a vertex "
                                                 "or a point of a face that is not");
    const auto copies = copies_of(i);
    if(copies.first != copies.second)
      throw Invalid_input(Cause::INVALID_SOURCE,
                          "the faces around the source form several fans, between which no path leads: a "
                          "location in a face of one of them has to say which is meant");
    return i;
  }

  bool is_excluded(typename Traits::face_descriptor f) const { return get(read_.index_of_face, f) == null_index; }

  Indexed_location location(const Face_location& location) const
  {
    if(location.first == Traits::null_face())
      throw Invalid_input(Cause::INVALID_SOURCE, "a location is in the null face");
    if(is_excluded(location.first))
      throw Invalid_input(Cause::INVALID_SOURCE,
                          "a location is in an excluded face: on the rim of an excluded region, it has to be "
                          "given in the face on the other side");
    Indexed_location result;
    result.face = get(read_.index_of_face, location.first);
    result.coordinates = location.second;
    return result;
  }

  Face_location face_location(const Indexed_location& location) const
  {
    return Face_location(face(read_.halfedges[3 * location.face], *tm_), location.coordinates);
  }

private:
  using Copies = std::vector<std::pair<Index, Index>>;

  void give_fans_vertices()
  {
    Cut_mesh fans = cut_open(read_.mesh);
    for(Index copy = static_cast<Index>(read_.vertices.size()); copy < fans.vertices.size(); ++copy)
    {
      const Index v = fans.vertices[copy];
      copies_.push_back({v, copy});
      read_.vertices.push_back(read_.vertices[v]);
      read_.positions.push_back(read_.positions[v]);
    }
    read_.mesh = std::move(fans.mesh);
    std::sort(copies_.begin(), copies_.end());
  }

  // the copies that vertex number `i` has besides itself
  std::pair<Copies::const_iterator, Copies::const_iterator> copies_of(Index i) const
  {
    return {std::lower_bound(copies_.begin(), copies_.end(), Copies::value_type(i, 0)),
            std::lower_bound(copies_.begin(), copies_.end(), Copies::value_type(i + 1, 0))};
  }

  const TriangleMesh* tm_;
  Read_triangle_mesh<TriangleMesh> read_;
  Copies copies_; // of vertices whose faces form several fans
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_MESH_OF_FANS_H
