// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_CURVES_H
#define CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_CURVES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/Mesh_beside_curves.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a mesh cut open along curves that are sources, with the waves of each side of theirs.
 *
 * No shortest path crosses a source: so the cut changes neither distances nor the cut locus.
 */
class Mesh_with_curves : public Mesh_beside_curves
{
public:
  /// @param share of their edges by which the vertices of the curves are moved into a face, each one by another length:
  /// little enough that no curve gets corners, see `Geodesic_results::is_seam()`; distances alone need no such move
  Mesh_with_curves(const Indexed_triangle_mesh& whole, Index number_of_points, const std::vector<Indexed_curve>& curves,
                   double share = 0.)
    : Mesh_beside_curves(whole, number_of_points, curves), owners_(number_of_points)
  {
    std::iota(owners_.begin(), owners_.end(), Index(0));
    std::vector<unsigned char> is_done(mesh().number_of_vertices(), 0);
    for(const Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        for(Index side : {h, whole.opposite[h]})
          if(side != null_index)
            add(side, is_done);
    if(share > 0.)
      move_vertices(share);
  }

  const std::vector<Geodesic_line>& lines() const { return lines_; }
  /// the ends of the lines
  const std::vector<Indexed_location>& points() const { return points_; }
  /// the numbers of the sources, first of those that are points, then of `points()`
  const std::vector<Index>& owners() const { return owners_; }

private:
  void add(Index h, std::vector<unsigned char>& is_done)
  {
    const Index owner = parts().source_of_halfedge(h);
    lines_.push_back({h, owner});
    for(Index v : {mesh().source(h), mesh().target(h)})
      if(!is_done[v])
      {
        is_done[v] = 1;
        points_.push_back(location_of_vertex(connectivity(), v));
        owners_.push_back(owner);
      }
  }

  void move_vertices(double share)
  {
    std::vector<double> length(cut_.mesh.number_of_vertices(), 0.); // of the shortest line at a vertex
    for(const Geodesic_line& line : lines_)
    {
      const Index v = cut_.mesh.source(line.halfedge), w = cut_.mesh.target(line.halfedge);
      const double l = norm(cut_.mesh.points[w] - cut_.mesh.points[v]);
      for(Index end : {v, w})
        length[end] = length[end] > 0. ? (std::min)(length[end], l) : l;
    }
    constexpr double golden = 0.6180339887498949; // its multiples are spread evenly
    constexpr std::array<double, 3> part = {{0.2113, 0.3301, 0.4586}};
    const std::vector<Vector> before = cut_.mesh.points;
    for(std::size_t i = 0; i < points_.size(); ++i)
    {
      const double by = share * (1. + std::fmod(golden * static_cast<double>(i), 1.));
      const Indexed_triangle_mesh::Triangle& t = cut_.mesh.triangles[points_[i].face];
      Vector inside = {{0., 0., 0.}};
      for(std::size_t k = 0; k < 3; ++k)
        inside = inside + part[k] * before[t[k]];
      for(std::size_t k = 0; k < 3; ++k)
        if(points_[i].coordinates[k] == 1.)
        {
          const Vector way = inside - before[t[k]];
          cut_.mesh.points[t[k]] = before[t[k]] + by * length[t[k]] / norm(way) * way;
        }
    }
  }

  std::vector<Geodesic_line> lines_;
  std::vector<Indexed_location> points_;
  std::vector<Index> owners_;
};

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

struct Distances_from_curves
{
  std::vector<double> of_vertices, of_queries;
};

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

/// exact distances from points and curves, of the vertices and of further locations: those of a tree are ones on a mesh whose
/// curves have been moved
inline Distances_from_curves distances_from_curves(const Indexed_triangle_mesh& mesh,
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
  Distances_from_curves result{run.geodesics->distances(), {}};
  result.of_vertices.resize(mesh.number_of_vertices());
  for(std::size_t i = 0; i < queries.size(); ++i)
    result.of_queries.push_back(run.geodesics->query_distance(i));
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

/// gives the nodes of a curve their distances
inline void set_distances_from_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                                      const std::vector<Indexed_curve>& curves, Indexed_cut_locus& curve)
{
  const std::vector<double> distance =
    distances_from_curves(mesh, points, curves, locations_of(curve.nodes)).of_queries;
  for(std::size_t i = 0; i < curve.nodes.size(); ++i)
    curve.nodes[i].distance = distance[i];
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_DISTANCES_FROM_CURVES_H
