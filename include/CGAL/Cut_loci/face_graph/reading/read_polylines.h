// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_POLYLINES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_POLYLINES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/reading/read_source.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Polylines as a graph: the nodes of each follow each other, and `first` are the numbers of the first ones, and of all.
struct Indexed_polylines
{
  Indexed_cut_locus graph;
  std::vector<std::size_t> first;
};

// Faces are looked for among those of the mesh, as descriptors may be those of another one.
template <typename TriangleMesh, typename Polylines>
Indexed_polylines read_polylines(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                 const Polylines& polylines)
{
  constexpr double rounding = 1e-10; // of coordinates, as for sources
  std::map<typename boost::graph_traits<TriangleMesh>::face_descriptor, Index> number;
  for(const auto& polyline : polylines)
    for(const auto& location : polyline)
      number[location.first] = null_index;
  for(Index f = 0; f < read.mesh.number_of_faces(); ++f)
    if(const auto found = number.find(face(read.halfedges[3 * std::size_t(f)], tm)); found != number.end())
      found->second = f;

  Indexed_polylines result;
  for(const auto& polyline : polylines)
  {
    const std::size_t first = result.graph.nodes.size();
    result.first.push_back(first);
    for(const auto& location : polyline)
    {
      const std::size_t i = result.graph.nodes.size() - first;
      const std::string name =
        "polyline " + std::to_string(result.first.size() - 1) + ": point " + std::to_string(i) + ": ";
      const Index f = number[location.first];
      if(f == null_index)
        throw Invalid_input(Cause::INVALID_SOURCE, name + "its face is not a face of the mesh");
      try
      {
        const Indexed_source at = source_at(read.mesh, f, location.second, rounding);
        result.graph.nodes.push_back({at.location, at.vertex});
      }
      catch(const Invalid_input& error)
      {
        throw Invalid_input(error.cause(), name + error.what());
      }
      if(i > 0)
        result.graph.edges.push_back({static_cast<Index>(first + i - 1), static_cast<Index>(first + i)});
    }
  }
  result.first.push_back(result.graph.nodes.size());
  return result;
}

inline void check_segments(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                           const Indexed_polylines& polylines)
{
  for(std::size_t k = 0; k + 1 < polylines.first.size(); ++k)
  {
    const std::size_t first = polylines.first[k], last = polylines.first[k + 1];
    const std::string name = "polyline " + std::to_string(k);
    if(last - first < 2)
      throw Invalid_input(Cause::INVALID_SOURCE, name + " has less than two points: one point is a source by itself");
    for(std::size_t i = first; i + 1 < last; ++i)
    {
      bool is_in_face = false;
      for_each_common_face(mesh, connectivity, polylines.graph.nodes[i].location, polylines.graph.nodes[i + 1].location,
                           [&](Index) { is_in_face = true; });
      if(!is_in_face)
        throw Invalid_input(Cause::INVALID_SOURCE,
                            name + ": points " + std::to_string(i - first) + " and " + std::to_string(i + 1 - first) +
                              " are in no common face: the points are needed where it crosses edges");
    }
  }
}

// The seams in parts that are connected, in the order of the first polyline of each; with halfedges of the refined mesh.
inline std::vector<std::vector<Index>> connected_seams(const Refined_mesh& refined, const Indexed_polylines& polylines)
{
  const Indexed_triangle_mesh& mesh = refined.mesh;
  Union_find parts(mesh.number_of_vertices());
  std::vector<Index> seams; // each once
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(refined.seams[h] && (mesh.is_border_edge(h) || h < mesh.opposite[h]))
    {
      seams.push_back(h);
      parts.unite(mesh.source(h), mesh.target(h));
    }
  std::vector<std::vector<Index>> result;
  std::map<Index, std::size_t> number; // of the part, by its representative
  for(std::size_t k = 0; k + 1 < polylines.first.size(); ++k)
    if(number.insert({parts.find(refined.nodes[polylines.first[k]]), result.size()}).second)
      result.emplace_back();
  for(Index h : seams)
    result[number.at(parts.find(mesh.source(h)))].push_back(h);
  for(std::size_t k = 0; k + 1 < polylines.first.size(); ++k)
    if(result[number.at(parts.find(refined.nodes[polylines.first[k]]))].empty())
      throw Invalid_input(
        Cause::INVALID_SOURCE,
        "polyline " + std::to_string(k) +
          " is a point after rounding: a smaller snapping_tolerance keeps it, or one point as a source");
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_POLYLINES_H
