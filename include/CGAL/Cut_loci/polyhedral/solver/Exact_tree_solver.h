// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/polyhedral/curves/Mesh_edge_curve.h>
#include <CGAL/Cut_loci/polyhedral/curves/Tree_curve.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_jumps.h>
#include <CGAL/Cut_loci/polyhedral/solver/cut_locus_of_curves.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_curves.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_sources.h>
#include <CGAL/Cut_loci/polyhedral/sources/Source_moves.h>
#include <CGAL/Cut_loci/polyhedral/sources/distances_from_curves.h>
#include <CGAL/Cut_loci/polyhedral/strength/Default_branch_strength.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/extent.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
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
    : Exact_tree_solver(mesh, std::make_shared<const Surface>(mesh, threads, progress))
  {
    threads_ = threads;
  }

  std::unique_ptr<Exact_tree_method> for_other_sources() const override
  {
    return std::unique_ptr<Exact_tree_method>(new Exact_tree_solver(mesh_, surface_));
  }

  void set_curves(const std::vector<Indexed_curve>& curves) override
  {
    thresholds_ = surface_->thresholds;
    if(!curves.empty())
      static_cast<Branch_strength&>(thresholds_) =
        Default_branch_strength(mesh_, connectivity_, *surface_->faces, surface_->extent, {},
                                Curve_turns(mesh_, *surface_->faces, curves))
          .strength;
  }

  // for the cut locus of the surface that the polyhedron stands for
  const Exact_tree_thresholds& default_thresholds() const override { return thresholds_; }

  // What does not pass may be left out; `filter()` computes it if it is asked for.
  void expect(const Branch_strength& least) override { start_ = expected_ = least; }

  // for all sources that follow
  void set_maximum_relative_error(double error) override { maximum_relative_error_ = error; }

  void report_to(const Progress& progress) override
  {
    progress_ = progress;
    if(tree_)
      tree_->report_to(progress);
  }

  // once per source, or set of sources, in four parts
  void compute_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves) override
  {
    least_ = start_;
    refuse_error_without_strength(least_);
    sources_ = points;
    if(divided_ != nullptr)
      tree_.reset(); // it is on that
    divided_.reset();
    other_.reset();
    curves_ = curves;
    distance_.clear();
    moves_.reset();
    if(!curves.empty() || (has_source_off_vertices() && points.size() > 1))
      divided_.reset(new Divided_surface(mesh_, points, curves, progress_.part(0., 0.1)));
    const Progress all = progress_;
    report_to(divided_ != nullptr ? all.part(0.1, 1.) : all);
    start();
    if(!distance_.empty())
      return;
    read_distances();
    if(has_to_be_moved())
      start(1);
  }
  void compute_distance(const Indexed_source& source) { compute_distance({source}, {}); }

  void compute_strengths() override { tree_->draw_ridges(threads_); }

  /*
   * Where several shortest paths lead to a vertex at which they bend, all points behind it have several, and where such
   * paths run along edges of the mesh, it takes no more than rounding to choose other ones in neighboring faces. Both
   * need a symmetric placement of the source. Then it is moved, unless what is left out matters more: by far less than
   * the accuracy of any mesh, and far more than that of the windows. The former is seen by the distances: it is moved at
   * once, as rounding would decide whether it matters. Of several sources all are moved, each one by another length, as
   * they may be symmetric to each other too. Vertices of curves are always moved, as the waves of the edges at a corner are
   * symmetric to each other often, and once more where a face could be drawn by its labels only: that may be where edges
   * face each other.
   */
  void grow_tree() override
  {
    const Progress all = progress_;
    const double first = least_.is_none() ? 0.2 : 1.;
    report_to(all.part(0., first));
    tree_->join();
    remove_branches_to_moved_sources();
    const int most = has_curves() || is_one_of_several_ ? Source_moves::most_moves : most_moves;
    // what is kept is looked at when it is known
    const auto needs_move = [this]
    {
      const bool counts_all = has_curves() || (least_.is_none() && number_of_moves_ > 0);
      return (least_.is_none() && !tree_->is_sure()) || (counts_all && tree_->has_doubtful_faces());
    };
    for(int number = number_of_moves_ + 1; number <= most && needs_move(); ++number)
    {
      const Progress part = all.part(first + (1. - first) * (number - 1) / most, first + (1. - first) * number / most);
      report_to(part.part(0., 0.6));
      start(number);
      report_to(part.part(0.6, 0.8));
      tree_->draw_ridges(threads_);
      report_to(part.part(0.8, 1.));
      tree_->join();
      remove_branches_to_moved_sources();
    }
  }

  void close_cycles() override
  {
    tree_->prepare_widths();
    see_all_of(expected_, progress_);
  }

  // once per threshold. What it returns does not depend on what has been asked before.
  Indexed_cut_locus filter(const Exact_tree_thresholds& thresholds, Curve curve) override
  {
    const Progress all = progress_;
    std::vector<Tree_branches::Edge> kept;
    Exact_tree_solver& solver = solver_for(thresholds, kept, all.part(0., 0.7));
    Indexed_cut_locus result = solver.curve_of(kept, thresholds, curve, all);
    result.is_one_of_several = is_one_of_several_;
    return result;
  }

  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Exact_geodesic_propagation& geodesics() const { return divided_ != nullptr ? divided_->geodesics : geodesics_; }
  Exact_tree& tree() { return *tree_; }
  const std::vector<double>& distance() const override { return distance_; }
  Index farthest() const override { return farthest_; }
  Index number_of_border_loops() const override { return connectivity_.number_of_border_loops; }
  Index genus() const override { return connectivity_.genus(mesh_); }
  // the farthest vertex: on a closed surface it is on the cut locus
  Index root() const override { return farthest_; }
  std::vector<Index> nearest_sources() const override { return nearest_source_; }

  /*
   * What is left out, or has not been looked for, is on branches on which paths meet at small angles: there the distance
   * grows from a vertex of positive curvature on, or from a corner of a curve. So what is nearest is such a vertex, or
   * known. Sources that are moved, and errors, have other distances.
   */
  double least_distance() const override
  {
    double result = tree_->least_distance();
    if(number_of_moves_ > 0 || has_curves())
      result -= 1.2e-4 * longest_edge(); // more than any move, and what the waves of lines are off
    for(Index v = 0; v < distance_.size(); ++v)
      if(surface_->faces->is_tip(v) && distance_[v] > 0.)
        result = (std::min)(result, distance_[v]);
    return has_corners() ? 0. : (std::max)(result, 0.) / (1. + maximum_relative_error_);
  }

private:
  static constexpr int most_moves = 2; // of a source: what one leaves doubtful, another one decides

  // By how much it is moved. Where regions have several shortest paths, by the same each time, in other directions: the
  // radius of sources that are symmetric to each other differs by no more, whichever move leaves no doubts.
  double share_of_face(int number) const { return is_one_of_several_ ? 2e-6 : 1e-6 * number; }

  // The solver that has all that is asked for, as it is after the source has been set: this one, or one for weaker branches.
  // It is never a tree that other questions have completed in places, as that would be another one. Weaker branches are
  // computed in levels, so that a slider needs a new one seldom.
  Exact_tree_solver& solver_for(const Branch_strength& asked, std::vector<Tree_branches::Edge>& kept,
                                const Progress& progress)
  {
    const bool is_weaker = asked.is_weaker_than(least_);
    const Branch_strength level = is_weaker ? level_below(asked) : start_;
    if(other_ && other_->is_for(level, asked))
      return other_->with_kept(asked, kept, progress);
    if(is_weaker)
      compute_other(level, level, progress.part(0., 0.4));
    Exact_tree_solver& first = is_weaker ? *other_ : *this;
    first.with_kept(asked, kept, progress.part(0.4, 0.5));
    if(first.has_seen(asked, kept))
      return first;
    compute_other(level, asked, progress.part(0.5, 0.9));
    return other_->with_kept(asked, kept, progress.part(0.9, 1.));
  }

  bool is_for(const Branch_strength& least, const Branch_strength& expected) const
  {
    return start_ == least && expected_ == expected;
  }

  Exact_tree_solver& with_kept(const Branch_strength& asked, std::vector<Tree_branches::Edge>& kept,
                               const Progress& progress)
  {
    kept = tree_->kept(asked, progress);
    return *this;
  }

  void compute_other(const Branch_strength& least, const Branch_strength& expected, const Progress& progress)
  {
    if(other_ && other_->is_for(least, expected))
      return;
    other_.reset();
    std::unique_ptr<Exact_tree_solver> solver(new Exact_tree_solver(mesh_, surface_));
    solver->threads_ = threads_;
    solver->maximum_relative_error_ = maximum_relative_error_;
    solver->start_ = least;
    solver->expected_ = expected;
    solver->progress_ = progress.part(0., 0.5);
    solver->compute_distance(sources_, curves_);
    solver->report_to(progress.part(0.5, 0.6));
    solver->compute_strengths();
    solver->report_to(progress.part(0.6, 0.8));
    solver->grow_tree();
    solver->report_to(progress.part(0.8, 1.));
    solver->close_cycles();
    other_ = std::move(solver);
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

  Indexed_cut_locus curve_of(std::vector<Tree_branches::Edge>& kept, const Exact_tree_thresholds& thresholds,
                             Curve curve, const Progress& all)
  {
    tree_->measure_widths(kept, all.part(0.7, 0.8));
    if(has_curves())
      return curve == Curve::MESH_EDGES
               ? mesh_edges_between_curves(mesh_, sources_, curves_, distance_, *divided_, *tree_, kept, thresholds)
               : curve_between_curves(mesh_, connectivity_, sources_, curves_, *divided_, *divided_->with_curves,
                                      *tree_, kept, thresholds, lone_vertex());
    std::vector<Index> face;
    Indexed_cut_locus result =
      curve == Curve::MESH_EDGES ? mesh_edges(kept, all.part(0.8, 1.)) : through_faces(kept, face, all.part(0.8, 1.));
    remove_short_branches(mesh_, connectivity_, face, thresholds.minimum_edges, thresholds.minimum_length, result);
    remove_other_parts(mesh_, connectivity_, thresholds.part, result);
    return result;
  }

  Indexed_cut_locus mesh_edges(const std::vector<Tree_branches::Edge>& kept, const Progress& progress)
  {
    const Source_roots roots(mesh_, connectivity_, sources_);
    roots.check_faces("ask for cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)");
    const auto cut_open = [&](const Seams& seams)
    { return distances_cut_open(mesh_, sources_, {}, seams, maximum_relative_error_); };
    return std::move(Mesh_edge_curve(mesh_, connectivity_, divided_.get(), *tree_, kept, roots, distance_, cut_open,
                                     lone_vertex(), progress)
                       .graph);
  }

  // `face` becomes that of each edge
  Indexed_cut_locus through_faces(const std::vector<Tree_branches::Edge>& kept, std::vector<Index>& face,
                                  const Progress& progress)
  {
    Tree_curve result(tree_->mesh(), tree_->connectivity(), geodesics(), *tree_, kept, lone_vertex(), progress);
    if(divided_ != nullptr)
      divided_->remove_sources(result.graph, result.face);
    correct_distances(kept, result.graph);
    face = std::move(result.face);
    return std::move(result.graph);
  }

  // Pieces that the topology alone has added have no paths to tell them, in doubtful faces there may be shorter ones, and
  // those of a moved source are of other lengths.
  void correct_distances(const std::vector<Tree_branches::Edge>& kept, Indexed_cut_locus& curve) const
  {
    const std::vector<Index> faces = tree_->faces_off_bisectors(kept);
    if(number_of_moves_ == 0 && (faces.empty() || maximum_relative_error_ > 0.))
      return;
    const bool are_all = number_of_moves_ > 0 || divided_ != nullptr; // else faces have their own numbers
    std::vector<Index> nodes;
    Exact_geodesic_options options;
    for(Index i = 0; i < curve.nodes.size(); ++i)
      if(are_all || std::binary_search(faces.begin(), faces.end(), curve.nodes[i].location.face))
      {
        nodes.push_back(i);
        options.queries.push_back(curve.nodes[i].location);
      }
    Exact_geodesic_propagation exact(surface_->faces);
    exact.run(locations_of(sources_), options);
    for(std::size_t i = 0; i < nodes.size(); ++i)
      curve.nodes[nodes[i]].distance = exact.query_distance(i);
  }

  // With a vertex at each source, and cut open along curves.
  struct Divided_surface : public Mesh_with_sources
  {
    std::unique_ptr<Mesh_with_curves> with_curves; // if there are any
    Mesh_connectivity connectivity;
    Exact_geodesic_propagation geodesics;

    Divided_surface(const Indexed_triangle_mesh& without, const std::vector<Indexed_source>& points,
                    const std::vector<Indexed_curve>& curves, const Progress& progress, int number = 1)
      : Mesh_with_sources(without, points),
        with_curves(curves.empty() ? nullptr
                                   : new Mesh_with_curves(mesh(), static_cast<Index>(points.size()), divided(curves),
                                                          1e-6 * std::pow(2.5, number - 1))),
        connectivity(surface(), progress.part(0., 0.5)), geodesics(surface(), nullptr, progress.part(0.5, 1.))
    {
    }

    const Indexed_triangle_mesh& surface() const { return with_curves ? with_curves->mesh() : mesh(); }
  };

  bool has_curves() const { return divided_ != nullptr && divided_->with_curves; }

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
    if(!has_curves())
      return false;
    const Geodesic_faces& faces = geodesics().faces();
    for(Index v = 0; v < faces.number_of_vertices(); ++v)
      if(geodesics().is_on_line(v) && geodesics().has_corner(v))
        return true;
    return false;
  }

  // of the sources where they are
  void read_distances()
  {
    distance_ =
      curves_.empty() ? geodesics().distances() : distances_from_curves(mesh_, sources_, curves_, {}).of_vertices;
    for(Index v = 0; v < distance_.size() && maximum_relative_error_ > 0.; ++v)
      distance_[v] += geodesics().distance_error(v);
    distance_.resize(mesh_.number_of_vertices());
    nearest_source_.clear();
    for(Index v = 0; v < mesh_.number_of_vertices() && sources_.size() + curves_.size() > 1; ++v)
      nearest_source_.push_back(geodesics().nearest_source(v));
    find_farthest();
    is_symmetric_ = geodesics().has_several_paths();
    is_one_of_several_ = geodesics().has_several_paths_to_bends();
  }

  bool has_to_be_moved() const { return is_one_of_several_ && sources_.size() == 1 && curves_.empty(); }

  /// \pre distances are known if `number` is not 0
  void set_number_of_moves(int number)
  {
    if(number > 0 && !moves_)
      moves_.reset(new Source_moves(geodesics()));
    number_of_moves_ = number;
  }

  // `number` other than 0: with the sources moved, each time elsewhere
  void start(int number = 0)
  {
    set_number_of_moves(number);
    if(number > 0 && has_curves())
      divided_.reset(new Divided_surface(mesh_, sources_, curves_, Progress(), number + 1));
    if(divided_ != nullptr)
      tree_.reset(new Exact_tree(divided_->surface(), divided_->connectivity, divided_->geodesics));
    else if(!tree_)
      tree_.reset(new Exact_tree(mesh_, connectivity_, geodesics_));
    tree_->report_to(progress_);
    if(has_curves())
      tree_->add_lines(divided_->with_curves->lines(), divided_->with_curves->owners());
    // Windows may be merged where what is between them is half of what the weakest branch needs.
    tree_->allow_error(maximum_relative_error_, 0.5 * least_.least_angle(surface_->extent));
    tree_->propagate(locations(number), divided_ != nullptr ? divided_->vertices() : source_vertices(), least_,
                     [this](std::vector<Indexed_location>& sources)
                     {
      if(!distance_.empty())
        return false;
      read_distances();
      if(!has_to_be_moved())
        return false;
      set_number_of_moves(1);
      sources = locations(1);
      return true;
    });
    for(double d : geodesics().distances())
      if(!(d < (std::numeric_limits<double>::infinity)()))
        throw Invalid_input(Cause::TOO_INACCURATE,
                            "the exact solver does not reach all vertices: some faces may be too thin for it");
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
   * comes back. A symmetric source leaves it to rounding where it is, or what is drawn along an edge of the mesh: then the
   * source is moved, if there is one only, as what is between several depends on where they are.
   */
  void see_all_of(const Branch_strength& asked, const Progress& progress)
  {
    not_found_.clear();
    if(!can_see_more())
      return;
    std::vector<Tree_branches::Edge> kept = tree_->kept(asked);
    if(has_curves() && !tree_->is_known(kept))
    {
      compute_more(Branch_strength(), 0, progress);
      return;
    }
    look_where_paths_part(kept, asked, progress.part(0., 0.4));
    const auto is_open = [&]
    { return !tree_->is_known(kept) || (is_symmetric_ && !tree_->faces_off_bisectors(kept).empty()); };
    for(int number = number_of_moves_ + 1; number <= most_moves && sources_.size() == 1 && is_open(); ++number)
    {
      const Progress part = progress.part(0.4 + 0.3 * (number - 1), 0.4 + 0.3 * number);
      compute_more(least_, number, part.part(0., 0.5));
      kept = tree_->kept(asked);
      look_where_paths_part(kept, asked, part.part(0.5, 1.));
    }
    not_found_ = tree_->unknown(kept);
  }

  bool can_see_more() const { return !least_.is_none() && maximum_relative_error_ == 0.; }

  // whether all that is asked for is known, or has been looked for in vain
  bool has_seen(const Branch_strength& asked, const std::vector<Tree_branches::Edge>& kept) const
  {
    if(!can_see_more() || asked == expected_)
      return true;
    const std::vector<Index> unknown = tree_->unknown(kept);
    return std::includes(not_found_.begin(), not_found_.end(), unknown.begin(), unknown.end());
  }

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

  void remove_branches_to_moved_sources()
  {
    if(number_of_moves_ == 0)
      return;
    for(Index v : divided_ != nullptr ? divided_->vertices() : source_vertices())
      tree_->remove_branch_to(v);
  }

  bool has_source_off_vertices() const
  {
    return std::any_of(sources_.begin(), sources_.end(),
                       [](const Indexed_source& source) { return source.vertex == null_index; });
  }

  std::vector<Index> source_vertices() const
  {
    std::vector<Index> result;
    for(const Indexed_source& source : sources_)
      if(source.vertex != null_index)
        result.push_back(source.vertex);
    return result;
  }

  std::vector<Indexed_location> locations(int number) const
  {
    std::vector<Indexed_location> result;
    for(std::size_t i = 0; i < sources_.size(); ++i)
    {
      const Indexed_location at =
        divided_ != nullptr ? divided_->geodesics.vertex_location(divided_->vertices()[i]) : sources_[i].location;
      const double share = static_cast<double>(i) / static_cast<double>(sources_.size());
      result.push_back(number == 0 ? at : moves_->moved(i, share_of_face(number) * (1. + share), number));
    }
    if(has_curves())
      result.insert(result.end(), divided_->with_curves->points().begin(), divided_->with_curves->points().end());
    return result;
  }

  bool is_source(Index v) const
  {
    return std::any_of(sources_.begin(), sources_.end(),
                       [v](const Indexed_source& source) { return source.vertex == v; });
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

  void find_farthest()
  {
    farthest_ = 0;
    while(farthest_ + 1 < distance_.size() && is_source(farthest_))
      ++farthest_;
    for(Index v = farthest_ + 1; v < distance_.size(); ++v) // no source is it even if all distances are equal
      if(distance_[v] > distance_[farthest_] && !is_source(v))
        farthest_ = v;
  }

  // what depends on the mesh alone
  struct Surface
  {
    Surface(const Indexed_triangle_mesh& mesh, const Threads& threads, const Progress& progress)
      : extent(internal::extent(mesh))
    {
      // only the thread that asks for the work is to be told of it
      if(threads.are_there() && !progress.is_wanted())
        read_in_threads(mesh, threads);
      else
      {
        connectivity.reset(new Mesh_connectivity(mesh, progress.part(0., 0.3)));
        checked_mesh(mesh, *connectivity, progress.part(0.3, 0.4)); // has more to say than the faces
        faces = std::make_shared<const Geodesic_faces>(mesh, nullptr, progress.part(0.4, 0.8));
      }
      static_cast<Branch_strength&>(thresholds) =
        Default_branch_strength(mesh, *connectivity, *faces, extent, progress.part(0.8, 1.)).strength;
      progress(1.);
    }

    void read_in_threads(const Indexed_triangle_mesh& mesh, const Threads& threads)
    {
      std::exception_ptr error;
      const auto read = [&](std::size_t i)
      {
        if(i == 0)
          connectivity.reset(new Mesh_connectivity(mesh));
        else
          try
          {
            faces = std::make_shared<const Geodesic_faces>(mesh);
          }
          catch(...)
          {
            error = std::current_exception();
          }
      };
      threads.run(2, read);
      checked_mesh(mesh, *connectivity); // has more to say
      if(error)
        std::rethrow_exception(error);
    }

    std::unique_ptr<const Mesh_connectivity> connectivity;
    std::shared_ptr<const Geodesic_faces> faces;
    double extent;
    Exact_tree_thresholds thresholds; // the default
  };

  Exact_tree_solver(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Surface> surface)
    : mesh_(mesh), surface_(std::move(surface)), connectivity_(*surface_->connectivity), geodesics_(surface_->faces),
      thresholds_(surface_->thresholds)
  {
  }

  const Indexed_triangle_mesh& mesh_;
  std::shared_ptr<const Surface> surface_;
  const Mesh_connectivity& connectivity_; // of that
  Exact_geodesic_propagation geodesics_;
  Exact_tree_thresholds thresholds_;   // the default for the curves among the sources
  Branch_strength start_, expected_;   // of the first tree, and of those for which it is completed
  Branch_strength least_;              // of what the tree has
  double maximum_relative_error_ = 0.; // of the distances

  std::vector<Indexed_source> sources_; // the points
  std::vector<Indexed_curve> curves_;
  std::unique_ptr<Divided_surface> divided_; // if there are several sources, and not all of them at vertices
  std::vector<double> distance_;
  std::vector<Index> nearest_source_; // of each vertex, if there are several
  Index farthest_ = null_index;
  std::unique_ptr<Source_moves> moves_; // once the sources have been moved
  int number_of_moves_ = 0;
  bool is_symmetric_ = false;      // whether several shortest paths of one length lead to some vertex
  bool is_one_of_several_ = false; // see `Cut_locus`
  std::unique_ptr<Exact_tree> tree_;
  std::vector<Index> not_found_;             // of the edges of the tree: where they are is not known
  std::unique_ptr<Exact_tree_solver> other_; // for the same sources and other thresholds, the last that needed one
  Progress progress_;
  Threads threads_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_EXACT_TREE_SOLVER_H
