// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_DIVIDED_SOLVER_H
#define CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_DIVIDED_SOLVER_H

#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_set_solver.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * runs the method on a mesh with long edges: on a copy with these divided, on which distances of vertices tell more, if
 * they are known there. Its curve runs through the faces; that of mesh edges is found on the mesh itself once it is asked for.
 */
class Laplacian_divided_solver : public Laplacian_stages
{
public:
  // once per mesh
  Laplacian_divided_solver(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Divided_mesh> divided,
                           Laplacian_operator type, const Threads& threads, const Progress& progress)
    : mesh_(checked_mesh(mesh, Mesh_connectivity(mesh))), type_(type), threads_(threads), divided_(std::move(divided)),
      fine_(new Laplacian_set_solver(divided_->mesh(), type, threads, progress)), in_use_(fine_.get())
  {
  }

  std::unique_ptr<Laplacian_stages> for_other_sources() const override
  {
    return std::unique_ptr<Laplacian_stages>(new Laplacian_divided_solver(*this));
  }

  void report_to(const Progress& progress) override
  {
    progress_ = progress;
    in_use_->report_to(progress);
  }

  const Divided_mesh* divided() const override { return divided_.get(); }

  void set_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                    std::vector<double> distance, std::vector<Index> nearest, bool is_approximate) override
  {
    has_mesh_edges_ = false;
    const bool is_fine = distance.size() > mesh_.number_of_vertices();
    if(is_fine)
      fine_->set_distance(divided_->divided(points), divided_->divided(curves), distance, nearest, is_approximate);
    given_ = {points, curves, of_vertices(std::move(distance)), of_vertices(std::move(nearest)), is_approximate};
    if(!is_fine)
      start_on_mesh(progress_);
    in_use_ = is_fine ? fine_.get() : on_mesh_.get();
  }

  void compute_strengths() override
  {
    in_use_->compute_strengths();
    distance_ = of_vertices(in_use_->distance());
  }
  void grow_tree() override { in_use_->grow_tree(); }
  void close_cycles() override { in_use_->close_cycles(); }

  Indexed_cut_locus filter(const Branch_thresholds& thresholds, const Smoothing_parameters& smoothing,
                           Kept_part part) override
  {
    const bool is_fine = in_use_ == fine_.get();
    if(is_fine && smoothing.number_of_iterations == 0)
    {
      find_mesh_edges();
      return on_mesh_->filter(thresholds, smoothing, part);
    }
    Indexed_cut_locus result = in_use_->filter(thresholds, smoothing, part);
    std::vector<Index> faces;
    if(is_fine)
      divided_->to_whole(result, faces);
    return result;
  }

  const std::vector<double>& distance() const override { return distance_; }
  Index number_of_border_loops() const override { return in_use_->number_of_border_loops(); }
  Index genus() const override { return in_use_->genus(); }
  Index farthest() const override
  {
    const Index result = in_use_->farthest();
    return result < distance_.size()
             ? result
             : static_cast<Index>(std::max_element(distance_.begin(), distance_.end()) - distance_.begin());
  }
  std::vector<Index> nearest_sources() const override { return of_vertices(in_use_->nearest_sources()); }

private:
  // what is known of the sources on the mesh itself
  struct Input
  {
    std::vector<Indexed_source> points;
    std::vector<Indexed_curve> curves;
    std::vector<double> distance;
    std::vector<Index> nearest;
    bool is_approximate = false;
  };

  Laplacian_divided_solver(const Laplacian_divided_solver& other)
    : mesh_(other.mesh_), type_(other.type_), divided_(other.divided_), fine_(other.fine_->for_other_sources()),
      on_mesh_(other.on_mesh_ ? other.on_mesh_->for_other_sources() : nullptr), in_use_(fine_.get())
  {
  }

  // those of the mesh come first; none stay none
  template <typename T>
  std::vector<T> of_vertices(std::vector<T> values) const
  {
    values.resize((std::min)(values.size(), mesh_.points.size()));
    return values;
  }

  void start_on_mesh(const Progress& progress)
  {
    if(!on_mesh_)
      on_mesh_.reset(new Laplacian_set_solver(mesh_, type_, threads_, progress));
    on_mesh_->set_distance(given_.points, given_.curves, given_.distance, given_.nearest, given_.is_approximate);
  }

  void find_mesh_edges()
  {
    if(has_mesh_edges_)
      return;
    start_on_mesh(progress_.part(0., 0.5));
    on_mesh_->report_to(progress_.part(0.5, 0.8));
    on_mesh_->compute_strengths();
    on_mesh_->report_to(progress_.part(0.8, 0.9));
    on_mesh_->grow_tree();
    on_mesh_->report_to(progress_.part(0.9, 1.));
    on_mesh_->close_cycles();
    has_mesh_edges_ = true;
  }

  const Indexed_triangle_mesh& mesh_;
  Laplacian_operator type_;
  Threads threads_; // not of copies
  std::shared_ptr<const Divided_mesh> divided_;
  std::unique_ptr<Laplacian_stages> fine_;    // on that
  std::unique_ptr<Laplacian_stages> on_mesh_; // from when it is needed
  Laplacian_stages* in_use_;                  // that of them on which the distances are known
  Input given_;
  bool has_mesh_edges_ = false;
  std::vector<double> distance_;
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_DIVIDED_SOLVER_H
