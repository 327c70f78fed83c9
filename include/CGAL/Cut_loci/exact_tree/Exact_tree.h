// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_H
#define CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_H

#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/exact_tree/Branch_widths.h>
#include <CGAL/Cut_loci/exact_tree/Cut_graph.h>
#include <CGAL/Cut_loci/exact_tree/Digon_width.h>
#include <CGAL/Cut_loci/exact_tree/Drawn_faces.h>
#include <CGAL/Cut_loci/exact_tree/Edge_crossings.h>
#include <CGAL/Cut_loci/exact_tree/Label_changes.h>
#include <CGAL/Cut_loci/exact_tree/Ridges.h>
#include <CGAL/Cut_loci/exact_tree/Shot_width.h>
#include <CGAL/Cut_loci/exact_tree/Tree_branches.h>
#include <CGAL/Cut_loci/exact_tree/Tree_graph.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * is the cut locus of a polyhedron for one source or several, with the strengths of its branches: the stages in their
 * order.
 */
class Exact_tree
{
public:
  /// @param source_vertices those at, or right beside, several sources; of one it may be empty
  Exact_tree(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
             Exact_geodesic_propagation& geodesics, const std::vector<Index>& source_vertices = {})
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), source_vertices_(source_vertices)
  {
  }

  /// lets the distances have an error, see `Exact_geodesic_options`; the tree is one above some strength then
  void allow_error(double maximum_relative_error, double merging_angle)
  {
    options_.maximum_relative_error = maximum_relative_error;
    options_.merging_angle = merging_angle;
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Exact_geodesic_propagation& geodesics() const { return geodesics_; }

  /// computes the distances, and where the cut locus crosses the edges of the mesh
  ///
  /// @param least what is weaker may be left out
  void propagate(const std::vector<Indexed_location>& sources, const Branch_strength& least)
  {
    least_ = least;
    find_drawn_faces(sources);
    // Windows of an edge come once the front is there, up to a face or two. If that is not enough on this mesh, once
    // more with room for more, and then for all.
    for(double slack : {4., 32., (std::numeric_limits<double>::infinity)()})
    {
      crossings_.reset(new Edge_crossings(geodesics_, is_drawn_, slack));
      geodesics_.run(sources, options_, *crossings_);
      crossings_->finish();
      if(crossings_->number_of_late() == 0)
        return;
    }
  }

  void draw_ridges()
  {
    changes_ = Label_changes(connectivity_, geodesics_, *crossings_, std::move(is_drawn_), std::move(bend_));
    crossings_.reset();
    ridges_ = Ridges(mesh_, connectivity_, geodesics_, changes_);
  }

  void join()
  {
    const Cut_graph cut(mesh_, connectivity_, geodesics_, changes_, ridges_, source_vertices_);
    graph_.reset(new Tree_graph(mesh_, connectivity_, geodesics_, changes_, ridges_, cut));
    if(!least_.is_none())
      graph_->drop_weak_branches(least_);
  }

  /// The source is moved away from a vertex: what starts there is none of it.
  void remove_branch_to(Index vertex)
  {
    if(vertex != null_index)
      graph_->remove_branch_to(vertex);
  }

  void prepare_widths()
  {
    measured_from_ = (std::numeric_limits<double>::infinity)();
    measure_.reset(new Digon_width(mesh_, geodesics_));
    shots_.reset(new Shot_width(mesh_, geodesics_));
  }

  const Tree_graph& graph() const { return *graph_; }
  /// whether the labels decided on everything
  bool is_sure() const { return graph_->is_sure(); }
  const Tree_branches& branches() const { return branches_; }
  const Ridges& ridges() const { return ridges_; }

  /// the edges of the graph whose branches are at least that strong: those that have an edge behind them, or are one, that
  /// passes all thresholds. So they are connected, wherever a branch is weaker than it is farther out.
  std::vector<Tree_branches::Edge> kept(const Branch_strength& least)
  {
    if(least.width > 0. && least.width < measured_from_)
      measure_widths(least);
    branches_ = Tree_branches(
      static_cast<Index>(graph_->nodes.size()), static_cast<Index>(graph_->edges.size()),
      [&](Index e) { return graph_->edges[e].nodes; }, [&](Index e) { return share_of(least, e); },
      connectivity_.number_of_border_loops);
    const float enough = least.is_none() ? 0.f : 1.f;
    std::vector<Tree_branches::Edge> result;
    for(const Tree_branches::Edge& b : branches_.edges())
      if(b.strength >= enough)
        result.push_back(b);
    return without_weak_ends(result);
  }

  /// finds what `width()` returns
  void measure_kept(const std::vector<Tree_branches::Edge>& edges)
  {
    if(measured_from_ == (std::numeric_limits<double>::infinity)())
      measure(edges);
  }
  /// of an edge, if it has been measured
  float width(Index edge) const { return width_.empty() ? 0.f : width_[edge]; }

  /// whether labels say of all these edges where they are, and not the topology alone that there is something
  bool is_known(const std::vector<Tree_branches::Edge>& edges) const
  {
    return std::all_of(edges.begin(), edges.end(),
                       [this](const Tree_branches::Edge& b)
                       { return graph_->edges[b.edge].piece != null_index || graph_->edges[b.edge].is_virtual; });
  }

private:
  /// how strong an edge is, as a share of what it has to be; without thresholds, its gap
  double share_of(const Branch_strength& least, Index e) const
  {
    const Tree_graph::Edge& edge = graph_->edges[e];
    if(edge.is_between_sources())
      return 0.; // it is on a cycle, and if not, it is rounding, and holds no branch
    if(least.is_none())
      return edge.gap;
    const double of_gap = least.gap > 0. ? edge.gap / least.gap : (std::numeric_limits<double>::infinity)();
    return least.width > 0. ? (std::min)(of_gap, width(e) / least.width) : of_gap;
  }

  /// of all edges that may be that wide
  void measure_widths(const Branch_strength& least)
  {
    std::vector<Tree_branches::Edge> edges;
    for(Index e = 0; e < graph_->edges.size(); ++e)
      if(graph_->can_be(e, least))
        edges.push_back({e, graph_->edges[e].nodes[0], graph_->edges[e].nodes[1], 0.f});
    measure(edges);
    measured_from_ = least.width;
  }

  void measure(const std::vector<Tree_branches::Edge>& edges)
  {
    const auto measured = [this](Index e) { return static_cast<float>(exact_width(e)); };
    // some faces: in each it crosses, a branch has about as many pieces as there are on average
    const std::size_t most = 1 + 16 * edges.size() / (std::max)(ridges_.faces().size(), std::size_t(1));
    width_.assign(graph_->edges.size(), 0.f);
    Branch_widths<decltype(measured)>(edges, static_cast<Index>(graph_->nodes.size()), most, measured, width_);
  }

  /// the largest separation of the two shortest paths to the points of a piece; between two sources, where nothing is
  /// too narrow, the length of the way from one to the other
  double exact_width(Index edge) const
  {
    const Tree_graph::Edge& e = graph_->edges[edge];
    if(e.is_between_sources())
      return 2. * (std::max)(graph_->nodes[e.nodes[0]].distance, graph_->nodes[e.nodes[1]].distance);
    double result = 0.;
    if(e.piece == null_index)
      return result;
    // at the end where the gap is larger, or at both if it is constant
    const Ridges::Piece& piece = ridges_.piece(e.piece);
    for(int k = 0; k < 2; ++k)
      if(piece.gaps[k] >= piece.gaps[1 - k] - 1e-9)
      {
        const Plane_point p = ridges_.piece_end(e.piece, k);
        result =
          (std::max)(result, geodesics_.is_approximate() ? (*shots_)(e.face, p, piece.images[0], piece.images[1])
                                                         : (*measure_)(e.face, p, piece.images[0], piece.images[1]));
      }
    return result;
  }

  void find_drawn_faces(const std::vector<Indexed_location>& sources)
  {
    if(least_.is_none())
    {
      is_drawn_.assign(mesh_.number_of_faces(), 1);
      return;
    }
    Drawn_faces found(geodesics_, least_);
    geodesics_.run(sources, options_, found);
    // between sources at the ends of an edge there may be no windows
    for(Index f = 0; f < mesh_.number_of_faces() && sources.size() > 1; ++f)
      for(Index v : mesh_.triangles[f])
        if(geodesics_.nearest_source(v) != geodesics_.nearest_source(mesh_.triangles[f][0]))
          found.is_drawn[f] = 1;
    is_drawn_ = std::move(found.is_drawn);
    bend_ = std::move(found.bend);
  }

  /// what only the topology has joined is kept as long as there is something behind it
  std::vector<Tree_branches::Edge> without_weak_ends(const std::vector<Tree_branches::Edge>& edges) const
  {
    std::vector<unsigned char> is_kept(edges.size(), 1);
    std::vector<Tree_branches::Edge> result;
    std::vector<Index> used;
    used.reserve(edges.size());
    for(const Tree_branches::Edge& b : edges)
      used.push_back(b.outer);
    std::sort(used.begin(), used.end());
    std::vector<unsigned char> has_kept(used.size(), 0);
    const auto slot = [&](Index node) -> unsigned char*
    {
      const auto found = std::lower_bound(used.begin(), used.end(), node);
      return found != used.end() && *found == node ? &has_kept[static_cast<std::size_t>(found - used.begin())]
                                                   : nullptr;
    };
    const std::size_t core = branches_.number_of_core_edges();
    for(std::size_t i = edges.size(); i-- > core;)
    {
      const unsigned char* behind = slot(edges[i].outer);
      is_kept[i] = graph_->edges[edges[i].edge].piece != null_index || (behind != nullptr && *behind != 0);
      if(is_kept[i])
        if(unsigned char* mark = slot(edges[i].inner))
          *mark = 1;
    }
    for(std::size_t i = 0; i < edges.size(); ++i)
      if(is_kept[i])
        result.push_back(edges[i]);
    return result;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  Exact_geodesic_propagation& geodesics_;
  std::vector<Index> source_vertices_;
  Exact_geodesic_options options_;
  Branch_strength least_;
  std::vector<unsigned char> is_drawn_; // by face, and
  std::vector<float> bend_;             // by halfedge, until the ridges are drawn
  std::unique_ptr<Edge_crossings> crossings_;
  Label_changes changes_;
  Ridges ridges_;
  std::unique_ptr<Tree_graph> graph_;
  Tree_branches branches_;
  std::vector<float> width_;  // of the edges that have been measured, else 0
  double measured_from_ = 0.; // the least width for which it is of all
  std::unique_ptr<Digon_width> measure_;
  std::unique_ptr<Shot_width> shots_; // for distances with an error
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_EXACT_TREE_H
