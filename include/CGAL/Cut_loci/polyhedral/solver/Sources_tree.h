// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_SOURCES_TREE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_SOURCES_TREE_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/solver/Polyhedral_surface.h>
#include <CGAL/Cut_loci/polyhedral/sources/Perturbed_surface.h>
#include <CGAL/Cut_loci/polyhedral/sources/Prepared_surface.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the tree of one set of sources, with branches down to some strength: the distances, the surface perturbed where it is
 * symmetric, and what has to be seen besides for the topology.
 */
class Sources_tree
{
public:
  Sources_tree(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Polyhedral_surface> surface,
               const Threads& threads = {})
    : mesh_(mesh), surface_(std::move(surface)), connectivity_(*surface_->connectivity), geodesics_(surface_->faces),
      threads_(threads)
  {
  }

  // What is weaker than `least` may be left out, and what is `expected` is completed.
  void expect(const Branch_strength& least, const Branch_strength& expected)
  {
    start_ = least;
    expected_ = expected;
  }
  bool is_for(const Branch_strength& least, const Branch_strength& expected) const
  {
    return start_ == least && expected_ == expected;
  }

  void set_maximum_relative_error(double error) { maximum_relative_error_ = error; }

  void report_to(const Progress& progress)
  {
    progress_ = progress;
    if(tree_)
      tree_->report_to(progress);
  }

  // once per set of sources, in four parts
  void compute_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves)
  {
    least_ = start_;
    refuse_error_without_strength(least_);
    if(is_perturbed() || (prepared_ && prepared_->is_other()))
      tree_.reset(); // it is on that
    perturbed_.reset();
    points_ = points;
    curves_ = curves;
    distance_.clear();
    const Progress all = progress_;
    prepare(0, all.part(0., 0.1));
    if(prepared_->is_other())
      tree_.reset();
    report_to(prepared_->is_other() ? all.part(0.1, 1.) : all);
    start(0);
    if(has_to_be_perturbed())
      start(1);
  }

  void compute_strengths() { tree_->draw_ridges(threads_); }

  /*
   * Where several shortest paths lead to a vertex at which they bend, all points behind it have several, and where such
   * paths run along edges of the mesh, it takes no more than rounding to choose other ones in neighboring faces. Both
   * need a symmetric surface. Then it is perturbed, unless what is left out matters more. The former is seen by the
   * distances: it is perturbed at once, as rounding would decide whether it matters. Vertices of curves are always moved, as
   * the waves of the edges at a corner are symmetric to each other often, and by more where a face could be drawn by its
   * labels only: that may be where edges face each other.
   */
  void grow_tree()
  {
    const Progress all = progress_;
    const double first = least_.is_none() ? 0.2 : 1.;
    report_to(all.part(0., first));
    tree_->join();
    // what is kept is looked at when it is known
    const auto is_open = [this]
    {
      const bool counts_all = !curves_.empty() || (least_.is_none() && is_perturbed());
      return (least_.is_none() && !tree_->is_sure()) || (counts_all && tree_->has_doubtful_faces());
    };
    for(int number = number_ + 1; number <= most && is_open(); ++number)
    {
      const Progress part = all.part(first + (1. - first) * (number - 1) / most, first + (1. - first) * number / most);
      report_to(part.part(0., 0.6));
      start(number);
      report_to(part.part(0.6, 0.8));
      tree_->draw_ridges(threads_);
      report_to(part.part(0.8, 1.));
      tree_->join();
    }
  }

  void close_cycles()
  {
    tree_->prepare_widths();
    see_all_of(expected_, progress_);
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Polyhedral_surface& surface() const { return *surface_; }
  const std::vector<Indexed_source>& points() const { return points_; }
  const std::vector<Indexed_curve>& curves() const { return curves_; }
  const Prepared_surface& prepared() const { return *prepared_; }
  Exact_tree& tree() { return *tree_; }
  const Exact_tree& tree() const { return *tree_; }
  const std::vector<double>& distance() const { return distance_; }
  Index farthest() const { return farthest_; }
  // the number of the nearest source of each vertex, if there are several
  const std::vector<Index>& nearest_source() const { return nearest_source_; }
  // of what the tree has
  const Branch_strength& least() const { return least_; }
  double maximum_relative_error() const { return maximum_relative_error_; }
  // see `Cut_locus`
  bool is_one_of_several() const { return is_one_of_several_; }
  bool is_perturbed() const { return perturbed_ != nullptr; }

  // whether all that is asked for is known, or has been looked for in vain
  bool has_seen(const Branch_strength& asked, const std::vector<Tree_branches::Edge>& kept) const
  {
    if(!can_see_more() || asked == expected_)
      return true;
    const std::vector<Index> unknown = tree_->unknown(kept);
    return std::includes(not_found_.begin(), not_found_.end(), unknown.begin(), unknown.end());
  }

  // What is left if nothing else is: a point of the border if there is one, as all of a curve is joined to it, but the
  // source.
  Index lone_vertex() const
  {
    for(Index v = 0; v < mesh_.number_of_vertices() && connectivity_.number_of_border_loops > 0; ++v)
      if(connectivity_.is_border(v) && !is_source(v) && distance_[v] > 0.)
        return v;
    return farthest_;
  }

  /*
   * What is left out, or has not been looked for, is on branches on which paths meet at small angles: there the distance
   * grows from a vertex of positive curvature on, or from a corner of a curve. So what is nearest is such a vertex, or
   * known. Perturbed surfaces, curves, and errors, have other distances.
   */
  double least_distance() const
  {
    double result = tree_->least_distance();
    if(is_perturbed())
      result *= 1. - perturbed_->change();
    if(!curves_.empty())
      result -= 1.2e-4 * longest_edge(); // more than they are moved, and what the waves of lines are off
    for(Index v = 0; v < distance_.size(); ++v)
      if(surface_->faces->is_tip(v) && distance_[v] > 0.)
        result = (std::min)(result, distance_[v]);
    return has_corners() ? 0. : (std::max)(result, 0.) / (1. + maximum_relative_error_);
  }

private:
  static constexpr int most = 4; // tries: what is open then is left so

  double longest_edge() const
  {
    double result = 0.;
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      result = (std::max)(result, surface_->faces->length(h));
    return result;
  }

  // whether a branch starts at a source that is a curve, where that has an angle of less than pi on a side
  bool has_corners() const
  {
    if(curves_.empty())
      return false;
    const Geodesic_faces& faces = prepared_->geodesics().faces();
    for(Index v = 0; v < faces.number_of_vertices(); ++v)
      if(prepared_->geodesics().is_on_line(v) && prepared_->geodesics().has_corner(v))
        return true;
    return false;
  }

  // of the sources where they are
  void read_distances()
  {
    distance_ = curves_.empty() ? prepared_->geodesics().distances()
                                : distances_from_curves(mesh_, points_, curves_, {}).of_vertices;
    for(Index v = 0; v < distance_.size() && maximum_relative_error_ > 0.; ++v)
      distance_[v] += prepared_->geodesics().distance_error(v);
    distance_.resize(mesh_.number_of_vertices());
    nearest_source_.clear();
    for(Index v = 0; v < mesh_.number_of_vertices() && points_.size() + curves_.size() > 1; ++v)
      nearest_source_.push_back(prepared_->geodesics().nearest_source(v));
    find_farthest();
    is_symmetric_ = prepared_->geodesics().has_several_paths();
    is_one_of_several_ = prepared_->geodesics().has_several_paths_to_bends();
  }

  bool has_to_be_perturbed() const { return is_one_of_several_ && curves_.empty(); }

  // `number` of the perturbation, or of the move of curves
  void prepare(int number, const Progress& progress)
  {
    prepared_.reset(new Prepared_surface(mesh_, connectivity_, geodesics_, points_, curves_, number, progress));
  }

  // `number` other than 0: once more, perturbed in another way
  void start(int number)
  {
    number_ = number;
    if(number > 0)
    {
      tree_.reset();
      if(curves_.empty())
        perturbed_.reset(new Perturbed_surface(prepared_->mesh(), prepared_->geodesics(), number));
      else
        prepare(number, Progress());
    }
    if(!tree_)
      tree_.reset(new Exact_tree(is_perturbed() ? perturbed_->mesh() : prepared_->mesh(), prepared_->connectivity(),
                                 is_perturbed() ? perturbed_->geodesics() : prepared_->geodesics()));
    tree_->report_to(progress_);
    if(!curves_.empty())
      tree_->add_lines(prepared_->cut()->lines(), prepared_->cut()->owners());
    // Windows may be merged where what is between them is half of what the weakest branch needs.
    tree_->allow_error(maximum_relative_error_, 0.5 * least_.least_angle(surface_->extent));
    // returns whether what follows is of use
    const auto read_distances_once = [this]
    {
      if(distance_.empty())
        read_distances();
      return is_perturbed() || !has_to_be_perturbed();
    };
    tree_->propagate(prepared_->locations(), prepared_->vertices(), least_, threads_, read_distances_once);
    read_distances_once();
    const std::vector<double>& distances = tree_->geodesics().distances();
    if(std::all_of(distances.begin(), distances.end(),
                   [](double d) { return d < (std::numeric_limits<double>::infinity)(); }))
      return;
    if(!is_perturbed() || number == most)
      throw Invalid_input(
        Cause::TOO_INACCURATE,
        "the exact solver does not reach all vertices, as some faces are too thin for it: remesh, or take "
        "distances along a graph");
    start(number + 1); // where other windows are lost
  }

  void refuse_error_without_strength(const Branch_strength& least) const
  {
    if(least.is_none() && maximum_relative_error_ > 0.)
      throw Invalid_input(
        Cause::PARAMETER_OF_OTHER_METHOD,
        "all of the cut locus of a polyhedron needs exact distances: leave maximum_relative_error away, "
        "or ask for branches of some minimum_branch_width or minimum_branch_gap by "
        "cut_locus_method(Cut_loci::Default_method())");
  }

  /*
   * Cycles stay whatever their strength, and what leads to a hole of the surface. Where that is weaker than what has been
   * looked for, it is looked for where shortest paths separate what it joins, and again where it leaves these faces and
   * comes back. A symmetric surface leaves it to rounding where it is, or what is drawn along an edge of the mesh: then it
   * is perturbed.
   */
  void see_all_of(const Branch_strength& asked, const Progress& progress)
  {
    not_found_.clear();
    if(!can_see_more())
      return;
    std::vector<Tree_branches::Edge> kept = tree_->kept(asked);
    if(!curves_.empty() && !tree_->is_known(kept))
    {
      compute_more(Branch_strength(), number_, progress);
      return;
    }
    look_where_paths_part(kept, asked, progress.part(0., 0.4));
    const auto is_open = [&]
    { return !tree_->is_known(kept) || (is_symmetric_ && !tree_->faces_off_bisectors(kept).empty()); };
    for(int number = number_ + 1; number <= most && curves_.empty() && is_open(); ++number)
    {
      const Progress part = progress.part(0.4 + 0.6 * (number - 1) / most, 0.4 + 0.6 * number / most);
      compute_more(least_, number, part.part(0., 0.5));
      kept = tree_->kept(asked);
      look_where_paths_part(kept, asked, part.part(0.5, 1.));
    }
    not_found_ = tree_->unknown(kept);
  }

  bool can_see_more() const { return !least_.is_none() && maximum_relative_error_ == 0.; }

  // A branch may leave the faces that are seen, and come back, mostly after a few: more and more are seen around it. At once
  // those are where shortest paths part, as to follow these takes less time than to draw all once more.
  void look_where_paths_part(std::vector<Tree_branches::Edge>& kept, const Branch_strength& asked,
                             const Progress& progress)
  {
    double done = 0.;
    for(Index rings = 3; !tree_->is_known(kept); rings = 2 * rings + 1)
    {
      const Progress part = progress.part(done, 0.5 * (1. + done));
      report_to(part.part(0., 0.6));
      done = 0.5 * (1. + done);
      if(!tree_->propagate_once_more(kept, rings))
        return;
      finish(part.part(0.6, 0.95));
      kept = tree_->kept(asked, part.part(0.95, 1.));
    }
  }

  // `number` as for `start()`
  void compute_more(const Branch_strength& least, int number, const Progress& progress)
  {
    refuse_error_without_strength(least);
    least_ = least;
    report_to(progress.part(0., 0.6));
    start(number);
    finish(progress.part(0.6, 1.));
  }

  void finish(const Progress& progress)
  {
    report_to(progress.part(0., 0.4));
    compute_strengths();
    report_to(progress.part(0.4, 1.));
    grow_tree();
    tree_->prepare_widths();
  }

  bool is_source(Index v) const
  {
    return std::any_of(points_.begin(), points_.end(),
                       [v](const Indexed_source& source) { return source.vertex == v; });
  }

  void find_farthest()
  {
    farthest_ = 0;
    while(farthest_ + 1 < distance_.size() && is_source(farthest_))
      ++farthest_;
    for(Index v = farthest_ + 1; v < distance_.size(); ++v) // no source is it even if all distances are equal
      if(distance_[v] > distance_[farthest_] && !is_source(v))
        farthest_ = v;
  }

  const Indexed_triangle_mesh& mesh_;
  std::shared_ptr<const Polyhedral_surface> surface_;
  const Mesh_connectivity& connectivity_; // of that
  Exact_geodesic_propagation geodesics_;
  Branch_strength start_, expected_, least_;
  double maximum_relative_error_ = 0.; // of the distances

  std::vector<Indexed_source> points_;
  std::vector<Indexed_curve> curves_;
  std::unique_ptr<Prepared_surface> prepared_;
  std::vector<double> distance_;
  std::vector<Index> nearest_source_;
  Index farthest_ = null_index;
  int number_ = 0; // of the perturbation, or of the move of curves
  std::unique_ptr<Perturbed_surface> perturbed_;
  bool is_symmetric_ = false; // whether several shortest paths of one length lead to some vertex
  bool is_one_of_several_ = false;
  std::unique_ptr<Exact_tree> tree_;
  std::vector<Index> not_found_; // of the edges of the tree: where they are is not known
  Progress progress_;
  Threads threads_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_SOURCES_TREE_H
