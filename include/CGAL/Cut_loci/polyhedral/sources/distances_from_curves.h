// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/distances_from_lines.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_curves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is what a run from points and curves takes, all of it on a mesh that is cut open along the curves. Faces and their
/// halfedges keep their numbers, and so do vertices, but for further copies at the end.
struct Run_from_curves
{
  std::unique_ptr<Exact_geodesic_propagation> geodesics;
  std::vector<Indexed_location> sources;
  Exact_geodesic_options options;
};

/// @param options what else they say is kept; the curves are numbered behind the points
inline Run_from_curves run_from_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_location>& points,
                                       const std::vector<Indexed_curve>& curves, const Exact_geodesic_options& options)
{
  const Mesh_with_curves cut(mesh, static_cast<Index>(points.size()), curves);
  Run_from_curves result{nullptr, points, options};
  result.sources.insert(result.sources.end(), cut.points().begin(), cut.points().end());
  set_lines(cut.lines(), result.options);
  result.options.owners = cut.owners();
  result.geodesics = std::make_unique<Exact_geodesic_propagation>(cut.mesh(), nullptr, options.progress.part(0., 0.));
  return result;
}

/// exact distances from points and curves, of the vertices and of further locations: those of a tree are ones on a mesh whose
/// curves have been moved
inline Distances_from_lines distances_from_curves(const Indexed_triangle_mesh& mesh,
                                                  const std::vector<Indexed_source>& points,
                                                  const std::vector<Indexed_curve>& curves,
                                                  const std::vector<Indexed_location>& queries,
                                                  const Progress& progress = {})
{
  Exact_geodesic_options options;
  options.queries = queries;
  options.progress = progress;
  const Run_from_curves run = run_from_curves(mesh, locations_of(points), curves, options);
  run.geodesics->run(run.sources, run.options);
  Distances_from_lines result = distances_of(*run.geodesics);
  result.of_vertices.resize(mesh.number_of_vertices());
  return result;
}

/// the same on the mesh cut open along seams, of the vertices alone: of several copies of one, the least
inline std::vector<double> distances_cut_open(const Indexed_triangle_mesh& mesh,
                                              const std::vector<Indexed_source>& points,
                                              const std::vector<Indexed_curve>& curves, const Seams& seams,
                                              double maximum_relative_error)
{
  const Cut_mesh cut = cut_open(mesh, seams);
  Exact_geodesic_options options;
  if(curves.empty())
    options.maximum_relative_error = maximum_relative_error;
  const Run_from_curves run = run_from_curves(cut.mesh, locations_of(points), curves, options);
  run.geodesics->run(run.sources, run.options);
  std::vector<double> result(mesh.number_of_vertices(), (std::numeric_limits<double>::infinity)());
  for(Index v = 0; v < cut.vertices.size(); ++v)
  {
    double& least = result[cut.vertices[v]];
    least = (std::min)(least, run.geodesics->true_distance(v));
  }
  return result;
}

inline void set_distances_from_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                                      const std::vector<Indexed_curve>& curves, Indexed_cut_locus& curve)
{
  set_distances(distances_from_curves(mesh, points, curves, locations_of(curve.nodes)), curve);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_DISTANCES_FROM_CURVES_H
