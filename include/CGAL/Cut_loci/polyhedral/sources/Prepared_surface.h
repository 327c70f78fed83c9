// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PREPARED_SURFACE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PREPARED_SURFACE_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the surface on which the cut locus of some sources is looked for, and the way back to the mesh: that mesh itself for
 * one point, or several at vertices, and else one with a vertex at each point, cut open along the curves.
 */
class Prepared_surface
{
public:
  /// @param geodesics on the mesh
  /// @param number the vertices of curves are moved by more for each, see `Mesh_with_curves`
  Prepared_surface(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   Exact_geodesic_propagation& geodesics, const std::vector<Indexed_source>& points,
                   const std::vector<Indexed_curve>& curves, int number, const Progress& progress)
    : mesh_(&mesh), connectivity_(&connectivity), geodesics_(&geodesics)
  {
    for(const Indexed_source& source : points)
    {
      locations_.push_back(source.location);
      if(source.vertex != null_index)
        vertices_.push_back(source.vertex);
    }
    if(curves.empty() && (points.size() < 2 || vertices_.size() == points.size()))
      return;
    divided_.reset(new Divided_mesh(mesh, points));
    vertices_ = divided_->vertices();
    mesh_ = &divided_->mesh();
    if(!curves.empty())
    {
      cut_.reset(new Mesh_with_curves(*mesh_, static_cast<Index>(points.size()), divided_->divided(curves),
                                      1e-6 * std::pow(2.5, number)));
      mesh_ = &cut_->mesh();
    }
    own_connectivity_.reset(new Mesh_connectivity(*mesh_, progress.part(0., 0.5)));
    connectivity_ = own_connectivity_.get();
    own_geodesics_.reset(new Exact_geodesic_propagation(*mesh_, nullptr, progress.part(0.5, 1.)));
    geodesics_ = own_geodesics_.get();
    for(std::size_t i = 0; i < points.size(); ++i)
      locations_[i] = geodesics_->vertex_location(vertices_[i]);
    if(cut_)
      locations_.insert(locations_.end(), cut_->points().begin(), cut_->points().end());
  }

  /// whether it is another surface than the mesh
  bool is_other() const { return divided_ != nullptr; }
  const Indexed_triangle_mesh& mesh() const { return *mesh_; }
  const Mesh_connectivity& connectivity() const { return *connectivity_; }
  Exact_geodesic_propagation& geodesics() const { return *geodesics_; }
  /// those at points
  const std::vector<Index>& vertices() const { return vertices_; }
  /// of the points, and of the vertices of curves
  const std::vector<Indexed_location>& locations() const { return locations_; }
  /// with the vertices, before it is cut open; null if it is the mesh
  const Divided_mesh* divided() const { return divided_.get(); }
  /// null if there are no curves
  const Mesh_with_curves* cut() const { return cut_.get(); }

  /// a curve through the faces, and the face of each of its edges, becomes one of the mesh
  void to_mesh(Indexed_cut_locus& curve, std::vector<Index>& face) const
  {
    if(cut_)
      cut_->close(curve);
    if(divided_)
      divided_->to_whole(curve, face);
  }

private:
  const Indexed_triangle_mesh* mesh_;
  const Mesh_connectivity* connectivity_;
  Exact_geodesic_propagation* geodesics_;
  std::vector<Index> vertices_;
  std::vector<Indexed_location> locations_;
  std::unique_ptr<Divided_mesh> divided_; // what is other, as far as it is
  std::unique_ptr<Mesh_with_curves> cut_;
  std::unique_ptr<Mesh_connectivity> own_connectivity_;
  std::unique_ptr<Exact_geodesic_propagation> own_geodesics_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PREPARED_SURFACE_H
