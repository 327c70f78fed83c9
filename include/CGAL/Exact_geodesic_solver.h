// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_EXACT_GEODESIC_SOLVER_H
#define CGAL_EXACT_GEODESIC_SOLVER_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <memory>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * computes exact geodesic distances by the propagation of windows, as `Surface_mesh_exact_geodesics` does: exact on the
 * polyhedron up to rounding errors, and faster than `Surface_mesh_shortest_path`, the more the finer the mesh.
 *
 * \cgalModels{GeodesicSolver}
 */
class Exact_geodesic_solver
{
public:
  /// the default of the parameter `cut_locus_method`: with these distances come the directions of the shortest paths
  static Cut_loci::Default_method cut_locus_method() { return {}; }

  void set_mesh(const Cut_loci::Indexed_triangle_mesh& mesh)
  {
    mesh_ = &mesh;
    propagation_ =
      std::make_shared<Cut_loci::internal::Exact_geodesic_propagation>(mesh, nullptr, progress_.part(0., 0.));
  }

  /// lets distances be longer than the exact ones, by this share of their length at most; zero by default, and what the
  /// parameter `maximum_relative_error` sets
  void set_maximum_relative_error(double error) { maximum_relative_error_ = error; }

  void compute_distances(const Cut_loci::Indexed_source& source, std::vector<double>& distances)
  {
    compute_distances(std::vector<Cut_loci::Indexed_source>(1, source), distances);
  }

  /// computes the distances to the nearest of several sources, in one run
  void compute_distances(const std::vector<Cut_loci::Indexed_source>& sources, std::vector<double>& distances)
  {
    Cut_loci::internal::Exact_geodesic_options options;
    options.maximum_relative_error = maximum_relative_error_;
    options.progress = progress_;
    std::vector<Cut_loci::Indexed_location> locations;
    locations.reserve(sources.size());
    for(const Cut_loci::Indexed_source& source : sources)
      locations.push_back(source.location);
    propagation_->run(locations, options);
    distances = propagation_->distances();
  }

  /// computes the distances to the nearest of points and curves, exactly: waves start from the edges of the curves, along
  /// which the mesh is cut open
  void compute_distances(const std::vector<Cut_loci::Indexed_source>& points,
                         const std::vector<Cut_loci::Indexed_curve>& curves, std::vector<double>& distances)
  {
    distances = Cut_loci::internal::distances_from_curves(*mesh_, points, curves, {}, progress_).of_vertices;
  }

#ifndef DOXYGEN_RUNNING
  // is told the share of the vertices that are reached
  void report_to(const Cut_loci::internal::Progress& progress)
  {
    progress_ = progress;
  }

  // of the vertices, from the last call with points
  std::vector<Cut_loci::Index> nearest_sources() const
  {
    std::vector<Cut_loci::Index> result;
    for(Cut_loci::Index v = 0; v < mesh_->number_of_vertices(); ++v)
      result.push_back(propagation_->nearest_source(v));
    return result;
  }
#endif

private:
  const Cut_loci::Indexed_triangle_mesh* mesh_ = nullptr;
  std::shared_ptr<Cut_loci::internal::Exact_geodesic_propagation> propagation_;
  double maximum_relative_error_ = 0.;
  Cut_loci::internal::Progress progress_;
};

} // namespace CGAL

#endif // CGAL_EXACT_GEODESIC_SOLVER_H
