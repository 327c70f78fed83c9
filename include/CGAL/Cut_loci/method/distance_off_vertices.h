// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_DISTANCE_OFF_VERTICES_H
#define CGAL_CUT_LOCI_METHOD_DISTANCE_OFF_VERTICES_H

#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// the exact distance of a point from sources that are points, among them the ends of lines, and those lines: for the few
/// points whose distance no run for the vertices says
inline double distance_off_vertices(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_location>& points,
                                    const std::vector<Geodesic_line>& lines, const Indexed_location& at)
{
  Exact_geodesic_propagation propagation(mesh);
  Exact_geodesic_options options;
  options.directions = true;
  options.lines = lines;
  options.owners.assign(points.size(), 0);
  options.queries = {at};
  propagation.run(points, options);
  return propagation.query_distance(0);
}

/// the same for points and parts of the border
inline double distance_off_vertices(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& sources,
                                    const Source_parts& parts, const Indexed_location& at)
{
  std::vector<Indexed_location> points;
  for(const Indexed_source& source : sources)
    points.push_back(source.location);
  std::vector<Geodesic_line> lines;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(parts.is_on_source(h))
    {
      lines.push_back({h, 0});
      points.push_back(location_on(h));
      points.push_back(location_on(h, 1.));
    }
  return distance_off_vertices(mesh, points, lines, at);
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_METHOD_DISTANCE_OFF_VERTICES_H
