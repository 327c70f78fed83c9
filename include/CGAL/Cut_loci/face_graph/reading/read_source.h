// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_SOURCE_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_SOURCE_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Cut_loci::internal {

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
  throw Invalid_input(Cause::INVALID_SOURCE, "the source is an isolated vertex: no face is incident to it");
}

template <typename TriangleMesh>
Indexed_source source_at_vertex(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
{
  if(v == boost::graph_traits<TriangleMesh>::null_vertex())
    throw Invalid_input(Cause::INVALID_SOURCE, "the source is the null vertex");
  // A descriptor of another mesh must not be used for a look-up: the search is linear, like all that a source costs.
  const auto found = std::find(read.vertices.begin(), read.vertices.end(), v);
  if(found == read.vertices.end())
  {
    for(auto w : CGAL::make_range(vertices(tm)))
      if(w == v)
        throw Invalid_input(Cause::INVALID_SOURCE, "the source is an isolated vertex: no face is incident to it");
    throw Invalid_input(Cause::INVALID_SOURCE, "the source is not a vertex of the mesh");
  }
  const Index index = static_cast<Index>(found - read.vertices.begin());
  return {location_on(outgoing_halfedge(tm, read, index)), index};
}

inline double checked_snapping_tolerance(double tolerance)
{
  if(!(tolerance >= 0. && tolerance < 1. / 3.)) // else no coordinate of a centroid would be left
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "the snapping tolerance must be a number from 0 to less than a third");
  return tolerance;
}

// A point of the face with the number `face`. The sum of the coordinates becomes one, and then each of them that is no
// larger than `tolerance` zero.
template <typename FT>
Indexed_source source_at(const Indexed_triangle_mesh& mesh, Index face, const std::array<FT, 3>& coordinates,
                         double tolerance)
{
  Indexed_source source;
  source.location.face = face;
  std::array<double, 3>& c = source.location.coordinates;
  double sum = 0.;
  for(int i = 0; i < 3; ++i)
  {
    c[i] = to_double(coordinates[i]);
    if(!std::isfinite(c[i]))
      throw Invalid_input(Cause::INVALID_SOURCE, "a barycentric coordinate of the source is not finite");
    sum += c[i];
  }
  if(!std::isfinite(sum))
    throw Invalid_input(Cause::INVALID_SOURCE, "the sum of the barycentric coordinates of the source is not finite");
  if(!(sum > 0.))
    throw Invalid_input(Cause::INVALID_SOURCE, "the barycentric coordinates of the source sum up to zero");
  for(double& x : c)
    if((x /= sum) < -tolerance)
      throw Invalid_input(Cause::INVALID_SOURCE,
                          "a barycentric coordinate of the source is negative: it is outside its face");
  snap(source.location, tolerance);
  source.vertex = vertex_of(mesh, source.location);
  return source;
}

template <typename TriangleMesh, typename FT>
Indexed_source source_in_face(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                              typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                              const std::array<FT, 3>& coordinates, double tolerance)
{
  if(f == boost::graph_traits<TriangleMesh>::null_face())
    throw Invalid_input(Cause::INVALID_SOURCE, "the face of the source is null");
  Index number = 0;
  while(number < read.mesh.number_of_faces() && face(read.halfedges[3 * std::size_t(number)], tm) != f)
    ++number;
  if(number == read.mesh.number_of_faces())
    throw Invalid_input(Cause::INVALID_SOURCE, "the face of the source is not a face of the mesh");
  return source_at(read.mesh, number, coordinates, tolerance);
}

template <typename T, typename = void>
struct Is_range : std::false_type
{
};

template <typename T>
struct Is_range<T, std::void_t<decltype(std::declval<const T&>().begin()), decltype(std::declval<const T&>().end())>>
  : std::true_type
{
};

// One of several sources: a vertex, a face location, or a variant of both.
template <typename TriangleMesh, typename FT>
Indexed_source
read_source(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
            const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>& location,
            double tolerance)
{
  return source_in_face(tm, read, location.first, location.second, tolerance);
}

template <typename TriangleMesh>
Indexed_source read_source(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                           typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, double)
{
  return source_at_vertex(tm, read, v);
}

template <typename TriangleMesh, typename... Points>
Indexed_source read_source(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                           const std::variant<Points...>& source, double tolerance)
{
  return std::visit([&](const auto& point) { return read_source(tm, read, point, tolerance); }, source);
}

template <typename TriangleMesh, typename Sources>
std::vector<Indexed_source> read_sources(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                         const Sources& sources, double tolerance, bool is_all)
{
  std::vector<Indexed_source> result;
  for(const auto& source : sources)
    try
    {
      result.push_back(read_source(tm, read, source, tolerance));
    }
    catch(const Invalid_input& error)
    {
      throw Invalid_input(error.cause(), "source " + std::to_string(result.size()) + ": " + error.what());
    }
  if(result.empty() && is_all)
    throw Invalid_input(Cause::NO_SOURCE, "the range of sources is empty");
  return result;
}

// The largest difference of the coordinates of two locations in a face, or on an edge that they name by different faces; 1 if
// they have no face or edge in common.
inline double difference(const Indexed_triangle_mesh& mesh, const Indexed_location& a, const Indexed_location& b)
{
  double result = 0.;
  for(std::size_t i = 0; i < 3; ++i)
  {
    double same = 0.; // the coordinate of `b` for the same vertex
    for(std::size_t j = 0; j < 3; ++j)
      if(mesh.triangles[b.face][j] == mesh.triangles[a.face][i])
        same = b.coordinates[j];
    result = (std::max)(result, std::fabs(same - a.coordinates[i]));
  }
  return result;
}

// Throws if two sources are at the same point, up to `tolerance` of their coordinates, closer to each other than rounding lets
// their cells be told apart, or in different components.
inline void check_sources(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& sources,
                          const std::vector<Index>& component_of_face, double tolerance)
{
  // Paths are known to 1e-9 of an edge, so that the cells of two sources end to 1e-4 of it then; closer ones do not.
  constexpr double least_difference = 1e-5;
  const auto name = [](Index i, Index k) { return "sources " + std::to_string(i) + " and " + std::to_string(k); };
  std::unordered_map<Index, std::vector<Index>> at_vertex; // the sources in its faces
  for(Index i = 0; i < sources.size(); ++i)
  {
    const Indexed_location& at = sources[i].location;
    if(component_of_face[at.face] != component_of_face[sources.front().location.face])
      throw Invalid_input(Cause::SOURCES_APART,
                          name(0, i) + " are in different components of the mesh: each component is a surface of its "
                                       "own, whose cut locus has to be computed for the sources in it");
    const auto largest = std::max_element(at.coordinates.begin(), at.coordinates.end()) - at.coordinates.begin();
    for(Index k : at_vertex[mesh.triangles[at.face][static_cast<std::size_t>(largest)]])
    {
      const double apart = difference(mesh, sources[k].location, at);
      if(apart <= tolerance)
        throw Invalid_input(Cause::SAME_SOURCES, name(k, i) + " are at the same point");
      if(apart < least_difference)
        throw Invalid_input(Cause::TOO_INACCURATE,
                            name(k, i) +
                              " are closer to each other than 1e-5 of an edge: where the cell of one ends can "
                              "not be told from rounding; leave one of them away");
    }
    for(std::size_t k = 0; k < 3; ++k)
      if(at.coordinates[k] > 0.)
        at_vertex[mesh.triangles[at.face][k]].push_back(i);
  }
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_SOURCE_H
