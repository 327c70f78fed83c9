// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/solver/Polyhedral_surface.h>
#include <CGAL/Cut_loci/polyhedral/solver/Sources_tree.h>
#include <CGAL/Cut_loci/polyhedral/solver/curve_of_sources.h>
#include <CGAL/Cut_loci/polyhedral/strength/Default_branch_strength.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The cut locus of the polyhedron, all of it or pruned, on one connected component.
class Exact_tree_solver : public Exact_tree_method
{
public:
  // once per mesh
  explicit Exact_tree_solver(const Indexed_triangle_mesh& mesh, const Threads& threads = {},
                             const Progress& progress = {})
    : Exact_tree_solver(mesh, std::make_shared<const Polyhedral_surface>(mesh, threads, progress), threads)
  {
  }

  std::unique_ptr<Exact_tree_method> for_other_sources() const override
  {
    return std::unique_ptr<Exact_tree_method>(new Exact_tree_solver(mesh_, surface_, {}));
  }

  void set_curves(const std::vector<Indexed_curve>& curves) override
  {
    thresholds_ = surface_->thresholds;
    if(!curves.empty())
      static_cast<Branch_strength&>(thresholds_) =
        Default_branch_strength(mesh_, connectivity(), *surface_->faces, surface_->extent, {},
                                Curve_turns(mesh_, *surface_->faces, curves))
          .strength;
  }

  const Exact_tree_thresholds& default_thresholds() const override { return thresholds_; }

  void expect(const Branch_strength& least) override
  {
    expected_ = least;
    first_.expect(least, least);
  }

  // for all sources that follow
  void set_maximum_relative_error(double error) override { first_.set_maximum_relative_error(error); }

  void report_to(const Progress& progress) override
  {
    progress_ = progress;
    first_.report_to(progress);
  }

  // once per source, or set of sources, in four parts
  void compute_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves) override
  {
    other_.reset();
    first_.compute_distance(points, curves);
  }
  void compute_distance(const Indexed_source& source) { compute_distance({source}, {}); }
  void compute_strengths() override { first_.compute_strengths(); }
  void grow_tree() override { first_.grow_tree(); }
  void close_cycles() override { first_.close_cycles(); }

  // once per threshold. What it returns does not depend on what has been asked before.
  Indexed_cut_locus filter(const Exact_tree_thresholds& thresholds, Curve curve) override
  {
    const Progress all = progress_;
    std::vector<Tree_branches::Edge> kept;
    Sources_tree& of = tree_for(thresholds, kept, all.part(0., 0.7));
    of.tree().measure_widths(kept, threads_, all.part(0.7, 0.8));
    Indexed_cut_locus result = curve == Curve::MESH_EDGES
                                 ? mesh_edges_of_sources(of, kept, thresholds, all.part(0.8, 1.))
                                 : curve_through_faces(of, kept, thresholds, all.part(0.8, 1.));
    result.is_one_of_several = first_.is_one_of_several();
    return result;
  }

  const Mesh_connectivity& connectivity() const { return *surface_->connectivity; }
  const Geodesic_faces& faces() const { return *surface_->faces; }
  const Exact_geodesic_propagation& geodesics() const { return first_.tree().geodesics(); }
  Exact_tree& tree() { return first_.tree(); }
  const std::vector<double>& distance() const override { return first_.distance(); }
  Index farthest() const override { return first_.farthest(); }
  Index number_of_border_loops() const override { return connectivity().number_of_border_loops; }
  Index genus() const override { return connectivity().genus(mesh_); }
  std::vector<Index> nearest_sources() const override { return first_.nearest_source(); }
  double least_distance() const override { return first_.least_distance(); }

private:
  Exact_tree_solver(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Polyhedral_surface> surface,
                    const Threads& threads)
    : mesh_(mesh), surface_(std::move(surface)), thresholds_(surface_->thresholds), threads_(threads),
      first_(mesh, surface_, threads)
  {
  }

  // The tree that has all that is asked for, as it is after the source has been set: the first, or one for weaker branches.
  // It is never one that other questions have completed in places, as that would be another one. Weaker branches are
  // computed in levels, so that a slider needs a new one seldom.
  Sources_tree& tree_for(const Branch_strength& asked, std::vector<Tree_branches::Edge>& kept, const Progress& progress)
  {
    const auto with_kept = [&](Sources_tree& of, const Progress& part) -> Sources_tree&
    {
      kept = of.tree().kept(asked, part);
      return of;
    };
    const bool is_weaker = asked.is_weaker_than(first_.least());
    const Branch_strength level = is_weaker ? level_below(asked) : expected_;
    if(other_ && other_->is_for(level, asked))
      return with_kept(*other_, progress);
    if(is_weaker)
      compute_other(level, level, progress.part(0., 0.4));
    Sources_tree& first = with_kept(is_weaker ? *other_ : first_, progress.part(0.4, 0.5));
    if(first.has_seen(asked, kept))
      return first;
    compute_other(level, asked, progress.part(0.5, 0.9));
    return with_kept(*other_, progress.part(0.9, 1.));
  }

  void compute_other(const Branch_strength& least, const Branch_strength& expected, const Progress& progress)
  {
    if(other_ && other_->is_for(least, expected))
      return;
    other_.reset();
    std::unique_ptr<Sources_tree> other(new Sources_tree(mesh_, surface_, threads_));
    other->set_maximum_relative_error(first_.maximum_relative_error());
    other->expect(least, expected);
    other->report_to(progress.part(0., 0.5));
    other->compute_distance(first_.points(), first_.curves());
    other->report_to(progress.part(0.5, 0.6));
    other->compute_strengths();
    other->report_to(progress.part(0.6, 0.8));
    other->grow_tree();
    other->report_to(progress.part(0.8, 1.));
    other->close_cycles();
    other_ = std::move(other);
  }

  // at most half as strong, and the same for many
  Branch_strength level_below(const Branch_strength& asked) const
  {
    const auto rounded = [](double value, double unit)
    { return value > 0. ? unit * std::exp2(std::floor(std::log2(value / unit))) : 0.; };
    Branch_strength result; // without spurs
    result.gap = rounded(asked.gap, 1.);
    result.width = rounded(asked.width, surface_->extent);
    result.enclosed = rounded(asked.enclosed, 1.);
    result.narrow = Branch_strength::narrow_share * result.width;
    result.noise = asked.noise;
    return result;
  }

  const Indexed_triangle_mesh& mesh_;
  std::shared_ptr<const Polyhedral_surface> surface_;
  Exact_tree_thresholds thresholds_; // the default for the curves among the sources
  Threads threads_;
  Branch_strength expected_;
  Sources_tree first_;                  // with what is expected
  std::unique_ptr<Sources_tree> other_; // for the same sources and other thresholds, the last that needed one
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H
