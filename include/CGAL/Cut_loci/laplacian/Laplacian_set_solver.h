// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SET_SOLVER_H
#define CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SET_SOLVER_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/Mesh_beside_curves.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_solver.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>
#include <CGAL/Cut_loci/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * runs the method for sets of sources: for points on the mesh, and for curves on the mesh cut open along them, each of
 * whose components is a surface with sources on its border.
 *
 * With each of these shrunk to a point, what holds for points holds for them. So the complement of the cut locus in a
 * component is a disk for each point, and for each part of the border that is a source an annulus, if that is a loop, or
 * else a disk; and the graph has 2g - 1 + k independent cycles for k of them together.
 */
class Laplacian_set_solver : public Laplacian_stages
{
public:
  // once per mesh
  Laplacian_set_solver(const Indexed_triangle_mesh& mesh, Laplacian_operator type, const Threads& threads = {},
                       const Progress& progress = {})
    : mesh_(mesh), type_(type), whole_(new Laplacian_solver(mesh, type, threads, progress))
  {
  }

  std::unique_ptr<Laplacian_stages> for_other_sources() const override
  {
    return std::unique_ptr<Laplacian_stages>(new Laplacian_set_solver(*this));
  }

  void report_to(const Progress& progress) override { progress_ = progress; }

  void set_distance(const std::vector<Indexed_source>& points, const std::vector<Indexed_curve>& curves,
                    std::vector<double> distance, std::vector<Index> nearest, bool is_approximate) override
  {
    pieces_.clear();
    beside_.reset();
    number_of_sources_ = points.size() + curves.size();
    if(curves.empty())
    {
      whole_->set_distance(points, std::move(distance), std::move(nearest), is_approximate);
      return;
    }
    beside_.reset(new Mesh_beside_curves(mesh_, static_cast<Index>(points.size()), curves));
    beside_->check_gaps(Laplacian_solver::remedy());
    points_ = points;
    is_approximate_ = is_approximate;
    distance_ = beside_->distances(distance);
  }

  void compute_strengths() override
  {
    const Progress all = progress_;
    if(has_curves())
    {
      make_pieces(all.part(0., 0.7));
      progress_ = all.part(0.7, 1.);
    }
    for_each_solver([](Laplacian_solver& solver) { solver.compute_strengths(); });
    if(has_curves())
      collect_distances();
  }
  void grow_tree() override
  {
    for_each_solver([](Laplacian_solver& solver) { solver.grow_tree(); });
  }
  void close_cycles() override
  {
    for_each_solver([](Laplacian_solver& solver) { solver.close_cycles(); });
  }

  Indexed_cut_locus filter(const Branch_thresholds& thresholds, const Smoothing_parameters& smoothing,
                           Kept_part part) override
  {
    Indexed_cut_locus result;
    if(!has_curves())
    {
      whole_->report_to(progress_);
      result = filtered(*whole_, thresholds, smoothing);
    }
    for(const auto& piece : pieces_)
      append(*piece, filtered(*piece->solver, thresholds, smoothing), result);
    remove_other_parts(mesh_, whole_->connectivity(), part, result);
    return result;
  }

  const std::vector<double>& distance() const override { return has_curves() ? distance_ : whole_->distance(); }
  Index number_of_border_loops() const override { return whole_->connectivity().number_of_border_loops; }
  Index genus() const override { return whole_->genus(); }
  Index farthest() const override { return has_curves() ? farthest_ : whole_->farthest(); }

  std::vector<Index> nearest_sources() const override
  {
    if(!has_curves())
      return whole_->nearest_sources();
    std::vector<Index> result(number_of_sources_ > 1 ? mesh_.number_of_vertices() : 0, null_index);
    for(const auto& piece : pieces_)
    {
      const std::vector<Index> nearest = piece->solver->nearest_sources();
      for(Index v = 0; v < piece->part.vertices.size() && !result.empty(); ++v)
        result[beside_->vertex(piece->part.vertices[v])] =
          nearest.empty() ? piece->solver->roots().name(0) : nearest[v];
    }
    return result;
  }

private:
  // A component of the mesh that is cut open.
  struct Piece
  {
    Mesh_component part;
    std::unique_ptr<Laplacian_solver> solver;

    Piece(const Mesh_beside_curves& beside, const std::vector<Index>& piece_of_face, Index id,
          const std::vector<Indexed_source>& points, const std::vector<double>& distance, bool is_approximate,
          Laplacian_operator type, const Progress& progress)
      : part(extract_component(beside.mesh(), piece_of_face, id)),
        solver(new Laplacian_solver(part.mesh, type, {}, progress))
    {
      std::vector<Indexed_source> points_here;
      std::vector<Index> names;
      for(Index i = 0; i < points.size(); ++i)
        if(piece_of_face[points[i].location.face] == id)
        {
          points_here.push_back(part.local(points[i]));
          names.push_back(i);
        }
      std::vector<Index> source_of_halfedge(part.mesh.number_of_halfedges());
      for(Index h = 0; h < source_of_halfedge.size(); ++h)
        source_of_halfedge[h] = beside.parts().source_of_halfedge(part.halfedge(h));
      std::vector<double> distance_here;
      for(Index v : part.vertices)
        distance_here.push_back(distance[v]);
      solver->set_distance(Source_roots(part.mesh, solver->connectivity(), points_here,
                                        Source_parts(part.mesh, std::move(source_of_halfedge)), names),
                           std::move(distance_here), {}, is_approximate);
    }
  };

  Laplacian_set_solver(const Laplacian_set_solver& other)
    : mesh_(other.mesh_), type_(other.type_), whole_(other.whole_->for_other_sources())
  {
  }

  bool has_curves() const { return beside_ != nullptr; }

  void make_pieces(const Progress& progress)
  {
    Index n = 0;
    const std::vector<Index> piece_of_face = face_components(beside_->mesh(), n);
    for(Index i = 0; i < n; ++i)
      pieces_.emplace_back(new Piece(*beside_, piece_of_face, i, points_, distance_, is_approximate_, type_,
                                     progress.part(double(i) / double(n), double(i + 1) / double(n))));
  }

  // on both sides of the curves they are equal
  void collect_distances()
  {
    distance_.resize(mesh_.number_of_vertices());
    for(const auto& piece : pieces_)
      for(Index v = 0; v < piece->part.vertices.size(); ++v)
        distance_[beside_->vertex(piece->part.vertices[v])] = piece->solver->distance()[v];
    farthest_ = static_cast<Index>(std::max_element(distance_.begin(), distance_.end()) - distance_.begin());
  }

  template <typename Function>
  void for_each_solver(const Function& function)
  {
    if(!has_curves())
    {
      whole_->report_to(progress_);
      function(*whole_);
    }
    for(std::size_t i = 0; i < pieces_.size(); ++i)
    {
      const double n = static_cast<double>(pieces_.size());
      pieces_[i]->solver->report_to(progress_.part(double(i) / n, double(i + 1) / n));
      function(*pieces_[i]->solver);
    }
  }

  static Indexed_cut_locus filtered(const Laplacian_solver& solver, const Branch_thresholds& thresholds,
                                    const Smoothing_parameters& parameters)
  {
    const Indexed_cut_locus edges = solver.filter(thresholds);
    return parameters.number_of_iterations == 0 ? edges : solver.smoothed(edges, parameters);
  }

  void append(const Piece& piece, const Indexed_cut_locus& graph, Indexed_cut_locus& result) const
  {
    const Index n = static_cast<Index>(result.nodes.size());
    for(Indexed_cut_locus::Node node : graph.nodes)
    {
      node.location.face = piece.part.faces[node.location.face];
      if(node.vertex != null_index)
        node.vertex = beside_->vertex(piece.part.vertices[node.vertex]);
      result.nodes.push_back(node);
    }
    for(Indexed_cut_locus::Edge e : graph.edges)
    {
      e.source += n;
      e.target += n;
      if(e.halfedge != null_index)
        e.halfedge = piece.part.halfedge(e.halfedge);
      result.edges.push_back(e);
    }
  }

  const Indexed_triangle_mesh& mesh_;
  Laplacian_operator type_;
  std::unique_ptr<Laplacian_solver> whole_;
  std::unique_ptr<Mesh_beside_curves> beside_; // if there are curves
  std::vector<std::unique_ptr<Piece>> pieces_; // of that
  std::vector<Indexed_source> points_;
  std::vector<double> distance_; // if there are curves; until there are pieces, on the mesh that is cut open
  bool is_approximate_ = false;
  Index farthest_ = null_index;
  std::size_t number_of_sources_ = 0;
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_LAPLACIAN_SET_SOLVER_H
