// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_TREE_CROSSING_RUNS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_TREE_CROSSING_RUNS_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/labels/Drawn_faces.h>
#include <CGAL/Cut_loci/polyhedral/labels/Edge_crossings.h>
#include <CGAL/Cut_loci/polyhedral/labels/Halfedge_trail.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * runs the exact solver for the distances and for the crossings of the cut locus with edges: once, if all faces are drawn, and
 * else twice, as the first run finds the faces.
 */
class Crossing_runs
{
public:
  Exact_geodesic_options options; // of all runs, but for their progress
  // of the last run, for whoever draws, who may take them
  std::unique_ptr<Edge_crossings> crossings;
  std::vector<unsigned char> is_drawn; // by face, see `Drawn_faces`
  std::vector<float> bend;             // by halfedge

  Crossing_runs(const Indexed_triangle_mesh& mesh, Exact_geodesic_propagation& geodesics)
    : mesh_(mesh), geodesics_(geodesics)
  {
  }

  /// @param least what is weaker may be left out
  /// @param go_on is asked once the distances are known, if something is left out: if it returns false, there are no crossings
  template <typename Function>
  void operator()(const std::vector<Indexed_location>& sources, const Branch_strength& least, const Threads& threads,
                  const Function& go_on, const Progress& progress)
  {
    sources_ = sources;
    least_ = least;
    crossings.reset();
    if(least.is_none())
    {
      is_drawn.assign(mesh_.number_of_faces(), 1);
      bend.clear();
    }
    else if(!find_drawn_faces(threads, go_on, progress))
      return;
    if(!crossings)
      find_crossings(progress);
  }

  /// for the same sources, if other faces are to be drawn
  void once_more(std::vector<unsigned char> drawn, const Progress& progress)
  {
    is_drawn = std::move(drawn);
    bend.clear(); // no other edge has to be crossed
    find_crossings(progress);
  }

private:
  void find_crossings(const Progress& progress)
  {
    // If the first slack is not enough on this mesh, once more with room for more, and then for all.
    options.progress = progress.part(least_.is_none() ? 0. : 0.5, 1.);
    for(double slack : {first_slack, 32., (std::numeric_limits<double>::infinity)()})
    {
      crossings.reset(new Edge_crossings(geodesics_, is_drawn, least_, slack));
      geodesics_.run(sources_, options, *crossings);
      crossings->finish(progress.part(1., 1.));
      if(crossings->number_of_late() == 0)
        return;
      options.progress = progress.part(1., 1.);
    }
  }

  /// finds, if there are threads, the crossings at the same time, in a run that follows the one that finds the faces
  ///
  /// @return whether to go on
  template <typename Function>
  bool find_drawn_faces(const Threads& threads, const Function& go_on, const Progress& progress)
  {
    Halfedge_trail trail(geodesics_.faces().mean_edge_length());
    Drawn_faces found(geodesics_, least_, trail);
    options.progress = progress.part(0., 0.5);
    is_drawn.assign(mesh_.number_of_faces(), 0);
    bool goes_on = true;
    const auto find = [&] { goes_on = run_ahead(found, trail, go_on); };
    if(threads.are_there() && sources_.size() == 1) // which faces are between several is known at the end
      threads.run_both(find, [&] { follow(trail); });
    else
      find();
    if(!goes_on)
    {
      crossings.reset();
      return false;
    }
    is_drawn = std::move(found.is_drawn);
    bend = std::move(found.bend);
    if(sources_.size() > 1)
      draw_between_sources();
    if(crossings)
    {
      crossings->finish();
      if(crossings->number_of_late() > 0)
        crossings.reset();
    }
    return true;
  }

  template <typename Function>
  bool run_ahead(Drawn_faces& found, Halfedge_trail& trail, const Function& go_on)
  {
    bool goes_on = false;
    try
    {
      geodesics_.run(sources_, options, found);
      trail.end();
      found.finish();
      goes_on = go_on();
    }
    catch(...)
    {
      trail.stop();
      throw;
    }
    if(!goes_on)
      trail.stop();
    return goes_on;
  }

  void follow(Halfedge_trail& trail)
  {
    try
    {
      if(!following_)
        following_.reset(new Exact_geodesic_propagation(geodesics_.shared_faces()));
      Exact_geodesic_options silent = options;
      silent.progress = Progress();
      crossings.reset(new Edge_crossings(*following_, is_drawn, least_, first_slack, &trail));
      following_->run(sources_, silent, *crossings);
    }
    catch(...) // what is wrong will be so once more, in the thread that asks
    {
      crossings.reset();
    }
  }

  /// between sources at the ends of an edge there may be no windows
  void draw_between_sources()
  {
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
      for(Index v : mesh_.triangles[f])
        if(geodesics_.nearest_source(v) != geodesics_.nearest_source(mesh_.triangles[f][0]))
          is_drawn[f] = 1;
  }

  // windows of an edge come once the front is there, up to a face or two
  static constexpr double first_slack = 4.;

  const Indexed_triangle_mesh& mesh_;
  Exact_geodesic_propagation& geodesics_;
  std::unique_ptr<Exact_geodesic_propagation> following_; // in another thread
  std::vector<Indexed_location> sources_;
  Branch_strength least_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_TREE_CROSSING_RUNS_H
