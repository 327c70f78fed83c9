// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_CHECK_DISTANCES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_CHECK_DISTANCES_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/Surface_component.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// Throws if these are not finite distances, one for each vertex of a component of a mesh. `positions` are
/// those of its vertices in the range of all, for the message, and `who` tells where the distances come from. `number`
/// is that of the vertices if there are more than those.
inline void check_distances(const std::vector<double>& distance, const Surface_component& component,
                            const std::vector<Index>& positions, const std::string& who, Index number)
{
  if(distance.size() != number)
    throw Invalid_input(Cause::INVALID_DISTANCE, who + " " + std::to_string(distance.size()) + " distances for " +
                                                   std::to_string(number) + " vertices");
  for(Index v = 0; v < distance.size(); ++v)
    if(!std::isfinite(distance[v]))
      throw Invalid_input(Cause::INVALID_DISTANCE,
                          who + " a distance that is not a finite number for " + component.name_of(v, positions));
}

/// Throws if one of the distances cannot be that of a shortest path: none is longer than one of edges, which passes each of
/// them once at most. What is longer may also be too large to compute with. `what_to_do` ends the message.
inline void check_range(const std::vector<double>& distance, const Surface_component& component,
                        const std::vector<Index>& positions, const std::string& who, const std::string& what_to_do)
{
  const double longest = component.sum_of_edge_lengths();
  for(Index v = 0; v < distance.size(); ++v)
    if(distance[v] < 0. || distance[v] > longest)
    {
      std::string message = who;
      message += " a distance that is ";
      message += distance[v] < 0. ? "negative" : "longer than all edges together";
      message += " for " + component.name_of(v, positions) + ": " + what_to_do;
      throw Invalid_input(Cause::INVALID_DISTANCE, message);
    }
}

/// Throws if all distances in a `vertex_distance_map` are the same, though not all vertices are on sources.
inline void check_is_not_constant(const std::vector<double>& distance, const Indexed_triangle_mesh& mesh,
                                  const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves)
{
  if(!std::equal(distance.begin() + 1, distance.end(), distance.begin()))
    return;
  std::vector<unsigned char> is_source(distance.size(), 0);
  for(const Indexed_source& point : points)
    if(point.vertex != null_index)
      is_source[point.vertex] = 1;
  for(const Indexed_curve& curve : curves)
    for(Index h : curve.halfedges)
      is_source[mesh.source(h)] = is_source[mesh.target(h)] = 1;
  if(std::count(is_source.begin(), is_source.end(), 0) > 0)
    throw Invalid_input(Cause::INVALID_DISTANCE,
                        "the vertex distance map holds the same distance for all vertices: it must hold the geodesic "
                        "distances to the source");
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_CHECK_DISTANCES_H
