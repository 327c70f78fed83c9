// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_TRIANGLE_MESH_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_TRIANGLE_MESH_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The dense copy of a FaceListGraph, with the way back to its descriptors. Excluded faces and vertices without a face are left
// out: their index is `null_index`.
template <typename TriangleMesh>
struct Read_triangle_mesh
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Vertex_index_map =
    typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Index>>::const_type;
  using Face_index_map = typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<Index>>::const_type;

  Indexed_triangle_mesh mesh;
  double unit = 1.;                           // the length in the user's mesh of 1 in `mesh`
  double unit_of_points = 1.;                 // the same, unless there are lengths: these are in a unit of their own
  std::vector<vertex_descriptor> vertices;    // the vertex of each index
  std::vector<Index> positions;               // its position in the range vertices(mesh), for messages and output
  std::vector<halfedge_descriptor> halfedges; // halfedge `3 * f + i` of the dense mesh
  Vertex_index_map index_of_vertex;           // dense index, or null_index for vertices without a face
  Face_index_map index_of_face;               // the same, null_index for excluded faces
};

inline std::string vertex_name(Index position)
{
  return "vertex #" + std::to_string(position);
}
inline std::string face_name(Index position)
{
  return "face #" + std::to_string(position);
}

// The position of face number `f` in the range faces(tm), for messages: it takes linear time.
template <typename TriangleMesh>
Index position_of_face(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read, Index f)
{
  const auto range = CGAL::make_range(faces(tm));
  return static_cast<Index>(
    std::distance(range.begin(), std::find(range.begin(), range.end(), face(read.halfedges[3 * f], tm))));
}

// Throws if the face of `h`, number `f`, is no triangle.
template <typename TriangleMesh>
void check_triangle(const TriangleMesh& tm, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, Index f)
{
  std::size_t sides = 1;
  for(auto g = next(h, tm); g != h; g = next(g, tm))
    ++sides;
  if(sides != 3)
    throw Invalid_input(Cause::NO_TRIANGLE, face_name(f) + " has " + std::to_string(sides) +
                                              " sides: all faces must be triangles "
                                              "(CGAL::Polygon_mesh_processing::triangulate_faces() makes them so)");
}

// Numbers the faces that are not excluded and their halfedges; vertices without one keep the null index, others get zero.
template <typename TriangleMesh, typename FaceIsExcludedMap, typename IndexOfHalfedge>
void number_faces(const TriangleMesh& tm, FaceIsExcludedMap is_excluded, Read_triangle_mesh<TriangleMesh>& result,
                  IndexOfHalfedge index_of_halfedge)
{
  bool has_vertices = false;
  for(auto v : CGAL::make_range(vertices(tm)))
  {
    put(result.index_of_vertex, v, null_index);
    has_vertices = true;
  }
  if(!has_vertices)
    throw Invalid_input(Cause::EMPTY_MESH, "the mesh is empty: it has no vertices");
  result.halfedges.reserve(3 * num_faces(tm)); // at least as many as there are: some meshes count removed ones
  Index nf = 0, position = 0;
  for(auto f : CGAL::make_range(faces(tm)))
  {
    ++position;
    if(get(is_excluded, f))
    {
      put(result.index_of_face, f, null_index);
      continue;
    }
    auto h = halfedge(f, tm);
    check_triangle(tm, h, position - 1);
    put(result.index_of_face, f, nf++);
    for(int i = 0; i < 3; ++i, h = next(h, tm))
    {
      put(index_of_halfedge, h, static_cast<Index>(result.halfedges.size()));
      result.halfedges.push_back(h);
      put(result.index_of_vertex, source(h, tm), Index(0));
    }
  }
  if(nf == 0)
    throw Invalid_input(Cause::EMPTY_MESH,
                        position == 0
                          ? "the mesh has no faces"
                          : "all faces of the mesh are excluded: the face_is_excluded_map must leave at least one");
}

// Numbers the vertices that have a face.
template <typename TriangleMesh, typename VertexPointMap>
void read_points(const TriangleMesh& tm, VertexPointMap vpm, bool needs_points,
                 Read_triangle_mesh<TriangleMesh>& result)
{
  result.mesh.points.reserve(num_vertices(tm));
  result.vertices.reserve(num_vertices(tm));
  result.positions.reserve(num_vertices(tm));
  Index position = 0;
  for(auto v : CGAL::make_range(vertices(tm)))
  {
    if(get(result.index_of_vertex, v) != null_index)
    {
      const auto& p = get(vpm, v);
      const Indexed_triangle_mesh::Point point = {
        {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
      if(needs_points && !(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])))
        throw Invalid_input(Cause::INVALID_COORDINATE, vertex_name(position) + " has a coordinate that is not finite");
      put(result.index_of_vertex, v, result.mesh.number_of_vertices());
      result.mesh.points.push_back(point);
      result.vertices.push_back(v);
      result.positions.push_back(position);
    }
    ++position;
  }
}

// The named parameter `vertex_point_map`, or the map of the mesh.
template <typename TriangleMesh, typename NamedParameters>
auto point_map(const TriangleMesh& tm, const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, tm));
}

// This is the one place that touches the mesh: everything after it runs on dense indices.
template <typename TriangleMesh, typename VertexPointMap,
          typename FaceIsExcludedMap =
            Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::face_descriptor, false>>
Read_triangle_mesh<TriangleMesh> read_triangle_mesh(const TriangleMesh& tm, VertexPointMap vpm,
                                                    bool needs_points = true, const Progress& progress = {},
                                                    FaceIsExcludedMap is_excluded = {})
{
  Read_triangle_mesh<TriangleMesh> result;
  result.index_of_vertex = get(CGAL::dynamic_vertex_property_t<Index>(), tm);
  result.index_of_face = get(CGAL::dynamic_face_property_t<Index>(), tm);
  auto index_of_halfedge = get(CGAL::dynamic_halfedge_property_t<Index>(), tm);
  number_faces(tm, is_excluded, result, index_of_halfedge);
  progress(0.4);
  read_points(tm, vpm, needs_points, result);
  progress(0.6);
  const std::size_t nh = result.halfedges.size();
  result.mesh.triangles.resize(nh / 3);
  result.mesh.opposite.resize(nh);
  for(std::size_t h = 0; h < nh; ++h)
  {
    const auto o = opposite(result.halfedges[h], tm);
    result.mesh.triangles[h / 3][h % 3] = get(result.index_of_vertex, target(o, tm));
    result.mesh.opposite[h] =
      is_border(o, tm) || get(is_excluded, face(o, tm)) ? null_index : get(index_of_halfedge, o);
  }
  return result;
}

// Brings the largest coordinate, or length, near 1: products of lengths stay in the range of numbers, also of `float`,
// whatever the unit of length. A power of two changes no digit.
template <typename TriangleMesh>
void normalize_lengths(Read_triangle_mesh<TriangleMesh>& read)
{
  Indexed_triangle_mesh& mesh = read.mesh;
  double largest = 0.;
  for(double length : mesh.lengths)
    largest = (std::max)(largest, length);
  for(const Indexed_triangle_mesh::Point& p : mesh.points)
    for(double x : p)
      largest = mesh.is_intrinsic ? largest : (std::max)(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  --exponent; // the unit, too, must be in the range
  read.unit = std::ldexp(1., exponent);
  for(double& length : mesh.lengths)
    length = std::ldexp(length, -exponent);
  if(mesh.is_intrinsic)
    return;
  read.unit_of_points = read.unit;
  for(Indexed_triangle_mesh::Point& p : mesh.points)
    for(double& x : p)
      x = std::ldexp(x, -exponent);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_TRIANGLE_MESH_H
