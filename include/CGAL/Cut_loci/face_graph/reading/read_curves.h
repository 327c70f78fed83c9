// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_CURVES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_CURVES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/connected_components.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The number of a halfedge of the mesh, or of its opposite if it has no face or an excluded one.
template <typename TriangleMesh>
Index halfedge_of_curve(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                        typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h)
{
  if(h == boost::graph_traits<TriangleMesh>::null_halfedge())
    throw Invalid_input(Cause::INVALID_SOURCE, "one of its edges is null");
  for(const auto side : {h, opposite(h, tm)})
  {
    const auto f = face(side, tm);
    if(f == boost::graph_traits<TriangleMesh>::null_face())
      continue;
    const std::size_t first = 3 * std::size_t(get(read.index_of_face, f));
    for(std::size_t i = first; i < first + 3 && i < read.halfedges.size(); ++i)
      if(read.halfedges[i] == side)
        return static_cast<Index>(i);
  }
  throw Invalid_input(Cause::INVALID_SOURCE,
                      "one of its edges is not an edge of a face of the mesh, or all its faces are excluded: "
                      "leave the edge out");
}

inline void check_curve(const Indexed_triangle_mesh& mesh, const Indexed_curve& curve)
{
  if(curve.halfedges.empty())
    throw Invalid_input(Cause::NO_SOURCE, "it has no edges");
  std::unordered_map<Index, Index> number; // of its vertices
  std::vector<std::pair<Index, Index>> ends;
  for(Index h : curve.halfedges)
  {
    const Index a = number.insert({mesh.source(h), static_cast<Index>(number.size())}).first->second;
    const Index b = number.insert({mesh.target(h), static_cast<Index>(number.size())}).first->second;
    ends.push_back({a, b});
  }
  Union_find parts(number.size());
  std::size_t n = number.size();
  for(const auto& e : ends)
    n -= parts.unite(e.first, e.second);
  if(n > 1)
    throw Invalid_input(Cause::INVALID_SOURCE, "it is not connected: its parts have to be curves of their own");
}

// A range of edges of the mesh, which is read as `mesh`, with the number that messages give it.
template <typename TriangleMesh, typename Edges>
Indexed_curve read_curve(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                         const Indexed_triangle_mesh& mesh, const Edges& edges, std::size_t number)
{
  Indexed_curve result;
  try
  {
    for(const auto& e : edges)
      result.halfedges.push_back(halfedge_of_curve(tm, read, halfedge(e, tm)));
    check_curve(mesh, result);
  }
  catch(const Invalid_input& error)
  {
    throw Invalid_input(error.cause(), "source curve " + std::to_string(number) + ": " + error.what());
  }
  return result;
}

// A range of curves, each of which is a range of edges of the mesh.
template <typename TriangleMesh, typename Curves>
std::vector<Indexed_curve> read_curves(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                       const Curves& curves)
{
  std::vector<Indexed_curve> result;
  for(const auto& edges : curves)
    result.push_back(read_curve(tm, read, read.mesh, edges, result.size()));
  return result;
}

template <typename TriangleMesh>
std::vector<Indexed_curve> read_curves(const TriangleMesh&, const Read_triangle_mesh<TriangleMesh>&,
                                       internal_np::Param_not_found)
{
  return {};
}

// Each border loop is a curve.
inline std::vector<Indexed_curve> border_curves(const Indexed_triangle_mesh& mesh)
{
  std::vector<Indexed_curve> result = border_loops(mesh);
  if(result.empty())
    throw Invalid_input(Cause::NO_SOURCE, "the mesh has no border that could be a source");
  return result;
}

// Throws if two sources, numbered with the points first, have a point in common, or are in different components.
inline void check_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                         const std::vector<Indexed_curve>& curves, const std::vector<Index>& component_of_face)
{
  const auto name = [](std::size_t i, std::size_t k)
  { return "sources " + std::to_string(i) + " and " + std::to_string(k); };
  const Index component =
    component_of_face[points.empty() ? curves.front().halfedges.front() / 3 : points.front().location.face];
  std::unordered_map<Index, std::size_t> source_at; // by vertex
  std::unordered_map<Index, std::size_t> source_on; // by halfedge
  for(std::size_t i = 0; i < curves.size(); ++i)
    for(Index h : curves[i].halfedges)
    {
      const std::size_t number = points.size() + i;
      if(component_of_face[h / 3] != component)
        throw Invalid_input(Cause::SOURCES_APART,
                            name(0, number) + " are in different components of the mesh: each component is a surface "
                                              "of its own, whose cut locus has to be computed for the sources in it");
      for(Index v : {mesh.source(h), mesh.target(h)})
        if(const std::size_t other = source_at.insert({v, number}).first->second; other != number)
          throw Invalid_input(Cause::SAME_SOURCES,
                              name(other, number) + " have a vertex in common: together, they are one source");
      source_on[h] = number;
      if(!mesh.is_border_edge(h))
        source_on[mesh.opposite[h]] = number;
    }
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Indexed_location& at = points[i].location;
    if(const auto found = source_at.find(points[i].vertex); found != source_at.end())
      throw Invalid_input(Cause::SAME_SOURCES, name(i, found->second) + " have a point in common");
    for(Index k = 0; k < 3; ++k)
      if(const auto found = source_on.find(3 * at.face + k);
         found != source_on.end() && at.coordinates[(k + 2) % 3] == 0.)
        throw Invalid_input(Cause::SAME_SOURCES, name(i, found->second) + " have a point in common");
  }
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_CURVES_H
