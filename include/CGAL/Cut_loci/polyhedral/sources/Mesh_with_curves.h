// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_MESH_WITH_CURVES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_MESH_WITH_CURVES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_sources.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * is a mesh cut open along curves that are sources, and with a vertex at each source that is a point.
 *
 * No shortest path crosses a source: so the cut changes neither distances nor the cut locus, and all edges of the
 * curves are on the border, each with the waves of one side. Faces and halfedges keep their numbers.
 */
class Mesh_with_curves
{
public:
  /// @param with_points the mesh without the curves, but with its points
  /// @param share of their edges by which the vertices of the curves are moved into a face, each one by another length:
  /// little enough that no curve gets corners, see `Geodesic_results::is_seam()`; distances alone need no such move
  Mesh_with_curves(const Indexed_triangle_mesh& without_points, const Mesh_with_sources& with_points,
                   const std::vector<Indexed_curve>& curves, double share = 0.)
    : cut_(cut(with_points, curves)), connectivity_(cut_.mesh)
  {
    owners_.resize(with_points.vertices().size());
    for(Index i = 0; i < owners_.size(); ++i)
      owners_[i] = i;
    std::vector<unsigned char> is_done(cut_.mesh.number_of_vertices(), 0);
    Index owner = static_cast<Index>(owners_.size());
    for(const Indexed_curve& curve : curves)
    {
      for(Index whole : curve.halfedges)
        for(Index side : {whole, without_points.opposite[whole]})
          if(side != null_index)
            with_points.for_each_part(side, [&](Index h) { add(h, owner, is_done); });
      ++owner;
    }
    if(share > 0.)
      move_vertices(share);
  }

  const Indexed_triangle_mesh& mesh() const { return cut_.mesh; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const std::vector<Geodesic_line>& lines() const { return lines_; }
  /// the ends of the lines
  const std::vector<Indexed_location>& points() const { return points_; }
  /// the numbers of the sources, first of those that are points, then of `points()`
  const std::vector<Index>& owners() const { return owners_; }

  /// a curve through the faces becomes one of the mesh that is not cut
  void close(Indexed_cut_locus& curve) const
  {
    for(Indexed_cut_locus::Node& node : curve.nodes)
      if(node.vertex != null_index)
        node.vertex = cut_.vertices[node.vertex];
  }

private:
  static Cut_mesh cut(const Mesh_with_sources& with_points, const std::vector<Indexed_curve>& curves)
  {
    Seams seams(with_points.mesh().number_of_halfedges(), 0);
    for(const Indexed_curve& curve : curves)
      for(Index whole : curve.halfedges)
        with_points.for_each_part(whole, [&](Index h) { add_seam(with_points.mesh(), h, seams); });
    return cut_open(with_points.mesh(), seams);
  }

  void add(Index h, Index owner, std::vector<unsigned char>& is_done)
  {
    lines_.push_back({h, owner});
    for(Index v : {cut_.mesh.source(h), cut_.mesh.target(h)})
      if(!is_done[v])
      {
        is_done[v] = 1;
        points_.push_back(location_of_vertex(connectivity_, v));
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

  Cut_mesh cut_;
  Mesh_connectivity connectivity_;
  std::vector<Geodesic_line> lines_;
  std::vector<Indexed_location> points_;
  std::vector<Index> owners_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_MESH_WITH_CURVES_H
