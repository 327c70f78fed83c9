// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_MESH_WITH_CURVES_H
#define CGAL_CUT_LOCI_EXACT_TREE_MESH_WITH_CURVES_H

#include <CGAL/Cut_loci/curve/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/exact_tree/Mesh_with_sources.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

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
  Mesh_with_curves(const Indexed_triangle_mesh& without_points, const Mesh_with_sources& with_points,
                   const std::vector<Indexed_curve>& curves)
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

  Cut_mesh cut_;
  Mesh_connectivity connectivity_;
  std::vector<Geodesic_line> lines_;
  std::vector<Indexed_location> points_;
  std::vector<Index> owners_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_MESH_WITH_CURVES_H
