// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/distances_from_lines.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_curves.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_sources.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// exact distances from points and curves, of the vertices and of further locations: those of a tree are ones on a mesh whose
/// curves have been moved
inline Distances_from_lines distances_from_curves(const Indexed_triangle_mesh& mesh,
                                                  const std::vector<Indexed_source>& points,
                                                  const std::vector<Indexed_curve>& curves,
                                                  const std::vector<Indexed_location>& queries,
                                                  const Progress& progress = {})
{
  const Mesh_with_sources whole(mesh, {}); // cut open, the faces keep their numbers
  const Mesh_with_curves with_curves(mesh, whole, curves);
  std::vector<Indexed_location> sources = with_curves.points();
  for(const Indexed_source& point : points)
    sources.push_back(point.location);
  Distances_from_lines result =
    distances_from_lines(with_curves.mesh(), sources, with_curves.lines(), queries, progress);
  result.of_vertices.resize(mesh.number_of_vertices());
  return result;
}

inline void set_distances_from_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                                      const std::vector<Indexed_curve>& curves, Indexed_cut_locus& curve)
{
  set_distances(distances_from_curves(mesh, points, curves, locations_of_nodes(curve)), curve);
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H
