// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_LINES_H
#define CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_LINES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

struct Distances_from_lines
{
  std::vector<double> of_vertices, of_queries;
};

inline Distances_from_lines distances_of(const Exact_geodesic_propagation& propagation)
{
  Distances_from_lines result{propagation.distances(), {}};
  for(std::size_t i = 0; i < propagation.number_of_queries(); ++i)
    result.of_queries.push_back(propagation.query_distance(i));
  return result;
}

/// exact distances from sources that are points, among them the ends of lines, and from those lines
inline Distances_from_lines distances_from_lines(const Indexed_triangle_mesh& mesh,
                                                 const std::vector<Indexed_location>& points,
                                                 const std::vector<Geodesic_line>& lines,
                                                 const std::vector<Indexed_location>& queries,
                                                 const Progress& progress = {})
{
  Exact_geodesic_propagation propagation(mesh, nullptr, progress.part(0., 0.));
  Exact_geodesic_options options;
  set_lines(lines, options);
  options.progress = progress;
  options.owners.assign(points.size(), 0);
  options.queries = queries;
  propagation.run(points, options);
  return distances_of(propagation);
}

/// of nodes or sources
template <typename Place>
std::vector<Indexed_location> locations_of(const std::vector<Place>& places)
{
  std::vector<Indexed_location> result;
  result.reserve(places.size());
  for(const Place& place : places)
    result.push_back(place.location);
  return result;
}

inline void set_distances(const Distances_from_lines& at_nodes, Indexed_cut_locus& curve)
{
  for(std::size_t i = 0; i < curve.nodes.size(); ++i)
    curve.nodes[i].distance = at_nodes.of_queries[i];
}

/// gives the nodes of a curve their distances from points and parts of the border
inline void set_distances_from_parts(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                                     const Source_parts& parts, Indexed_cut_locus& curve)
{
  std::vector<Indexed_location> sources = locations_of(points);
  std::vector<Geodesic_line> lines;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(parts.is_on_source(h))
    {
      lines.push_back({h, 0});
      sources.push_back(location_on(h));
      sources.push_back(location_on(h, 1.));
    }
  set_distances(distances_from_lines(mesh, sources, lines, locations_of(curve.nodes)), curve);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_LINES_H
