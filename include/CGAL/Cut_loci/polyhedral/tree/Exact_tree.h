// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_TREE_EXACT_TREE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_TREE_EXACT_TREE_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridges.h>
#include <CGAL/Cut_loci/polyhedral/joining/Cut_graph.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph_builder.h>
#include <CGAL/Cut_loci/polyhedral/labels/Label_changes.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/strength/Branch_widths.h>
#include <CGAL/Cut_loci/polyhedral/strength/Comparison_width.h>
#include <CGAL/Cut_loci/polyhedral/strength/Digon_width.h>
#include <CGAL/Cut_loci/polyhedral/strength/Path_classes.h>
#include <CGAL/Cut_loci/polyhedral/strength/Shot_width.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/strength/Width_bounds.h>
#include <CGAL/Cut_loci/polyhedral/strength/spurs.h>
#include <CGAL/Cut_loci/polyhedral/tree/Crossing_runs.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the cut locus of a polyhedron for one source or several, with the strengths of its branches: the stages in their
 * order.
 */
class Exact_tree
{
public:
  Exact_tree(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
             Exact_geodesic_propagation& geodesics)
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), runs_(mesh, geodesics),
      graph_(ridges_, connectivity.number_of_border_loops)
  {
  }

  /// lets the distances have an error, see `Exact_geodesic_options`; the tree is one above some strength then
  void allow_error(double maximum_relative_error, double merging_angle)
  {
    runs_.options.maximum_relative_error = maximum_relative_error;
    runs_.options.merging_angle = merging_angle;
  }

  /// is told the share of a stage that is done
  void report_to(const Progress& progress) { progress_ = progress; }

  /// adds sources that are edges of the border
  ///
  /// @param owners of the sources that are points, first those of `source_vertices`
  void add_lines(const std::vector<Geodesic_line>& lines, const std::vector<Index>& owners)
  {
    runs_.options.lines = lines;
    runs_.options.owners = owners;
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Exact_geodesic_propagation& geodesics() const { return geodesics_; }

  /// computes the distances, and where the cut locus crosses the edges of the mesh: of a further source in the memory of
  /// the one before
  ///
  /// @param source_vertices those at, or right beside, several sources; of one it may be empty
  /// @param least what is weaker may be left out
  /// @param go_on is asked once the distances are known, if something is left out: if it returns false, all ends there
  template <typename Function>
  void propagate(const std::vector<Indexed_location>& sources, const std::vector<Index>& source_vertices,
                 const Branch_strength& least, const Threads& threads, const Function& go_on)
  {
    least_ = least;
    source_vertices_ = source_vertices;
    runs_(sources, least, threads, go_on, progress_);
  }

  /// The same, with what `edges` need that are not known: `draw_ridges()` and what follows have to be called again. The
  /// topology says how they are to be joined, and faces are looked at in which shortest paths separate what is to be joined.
  ///
  /// @param rings of faces around what is not known that are looked at, too
  /// @return false, and does nothing, if all is known in the faces that may matter
  bool propagate_once_more(const std::vector<Tree_branches::Edge>& edges, Index rings)
  {
    std::vector<unsigned char> is_drawn = changes_.drawn_faces();
    bool is_more = false;
    const auto draw = [&](Index f)
    {
      is_more = is_more || is_drawn[f] < Drawn_faces::wholly;
      is_drawn[f] = Drawn_faces::wholly;
    };
    for(Index f : unknown_faces(edges, rings))
      draw(f);
    const Path_classes classes(mesh_, connectivity_, geodesics_, known_parts(edges));
    for(Index h : connectivity_.halfedge_of_edge)
      if(classes.separates(h))
      {
        draw(h / 3);
        if(mesh_.opposite[h] != null_index)
          draw(mesh_.opposite[h] / 3);
      }
    if(!is_more)
      return false;
    runs_.once_more(std::move(is_drawn), progress_);
    return true;
  }

  void draw_ridges(const Threads& threads = {})
  {
    changes_ = Label_changes(connectivity_, geodesics_, *runs_.crossings, std::move(runs_.is_drawn),
                             std::move(runs_.bend), least_, progress_.part(0., 0.4));
    runs_.crossings.reset();
    ridges_ = Ridges(mesh_, connectivity_, geodesics_, changes_, threads, progress_.part(0.4, 1.));
    ridges_.renumber_crossings(changes_.forget_all_but(ridges_.crossings_with_pieces()));
  }

  void join()
  {
    const Cut_graph cut(mesh_, connectivity_, geodesics_, changes_, ridges_, source_vertices_, progress_.part(0., 0.5));
    const Tree_graph_builder builder(mesh_, connectivity_, geodesics_, changes_, ridges_, cut, graph_,
                                     progress_.part(0.5, 0.9));
    kept_for_.reset();
    changes_.forget_crossings();
    if(!least_.is_none())
    {
      graph_.drop_weak_branches(least_, progress_.part(0.9, 1.));
      keep_what_is_left();
    }
  }

  /// The source is moved away from a vertex: what starts there is none of it.
  void remove_branch_to(Index vertex)
  {
    kept_for_.reset();
    if(vertex != null_index)
      graph_.remove_branch_to(vertex);
  }

  void prepare_widths()
  {
    width_.assign(graph_.edges.size(), -1.f);
    measure_.reset(new Digon_width(mesh_, geodesics_));
    shots_.reset(new Shot_width(mesh_, geodesics_));
  }

  const Tree_graph& graph() const { return graph_; }
  /// whether the labels decided on everything
  bool is_sure() const { return graph_.is_sure(); }
  /// whether pieces are somewhere in their face, as labels did not fit each other
  bool has_doubtful_faces() const { return ridges_.number_of_doubtful() > 0; }
  /// a node of those that have been kept at last, or null if there is none
  Index root() const { return root_; }
  const Ridges& ridges() const { return ridges_; }

  /// the edges of the graph whose branches are at least that strong: those that pass the thresholds, or have one behind
  /// them that does. So they are connected, wherever a branch is weaker than it is farther out. No branch is a spur, but
  /// those that enclose much.
  std::vector<Tree_branches::Edge> kept(const Branch_strength& least, const Progress& progress = {})
  {
    if(!(kept_for_ == least)) // a source is completed for the thresholds that are asked for next
    {
      kept_ = find_kept(least, progress);
      kept_for_ = least;
    }
    return kept_;
  }

  /// the largest separation of the two shortest paths to the points of a piece; between two sources, where nothing is
  /// too narrow, the length of the way from one to the other
  double width(Index edge)
  {
    const Tree_graph::Edge& e = graph_.edges[edge];
    if(e.is_between_sources())
      return 2. * (std::max)(graph_.nodes[e.nodes[0]].distance, graph_.nodes[e.nodes[1]].distance);
    float& result = width_[edge];
    if(result < 0.f)
    {
      result = 0.f;
      if(e.piece != null_index)
      {
        // at the end where the gap is larger, or at both if it is constant
        const Ridges::Piece& piece = ridges_.piece(e.piece);
        for(int k = 0; k < 2; ++k)
          if(piece.gaps[k] >= piece.gaps[1 - k] - 1e-9)
            result = (std::max)(result, static_cast<float>(separation(e.face, piece, next_to_end(e.piece, k))));
      }
    }
    return result;
  }

  /// the curvature that the paths to an edge enclose; those from curves part nowhere, and their gap is the angle at which
  /// they meet
  double curvature(Index e) const { return enclosed(e).curvature; }

  /// finds what `shown_width()` returns, for edges that are kept
  void measure_widths(const std::vector<Tree_branches::Edge>& edges, const Threads& threads = {},
                      const Progress& progress = {})
  {
    const auto measure = [this](Index e) { return static_cast<float>(width(e)); };
    // some faces: in each it crosses, a branch has about as many pieces as there are on average
    const std::size_t most = 1 + 16 * edges.size() / (std::max)(ridges_.number_of_faces(), Index(1));
    shown_width_.assign(graph_.edges.size(), 0.f);
    const auto length_of = [this](Index e) { return length(e); };
    Branch_widths<decltype(measure), decltype(length_of)>(edges, static_cast<Index>(graph_.nodes.size()), most, measure,
                                                          length_of, shown_width_,
                                                          geodesics_.is_approximate() ? Threads() : threads, progress);
  }
  float shown_width(Index edge) const { return shown_width_[edge]; }

  /// No point of the branches that are known, strong or weak, is nearer to the source than this. Where two paths meet
  /// head-on, their bisector is nearest; else the distance grows along it, so that it is least at an end.
  double least_distance() const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for(const Tree_graph::Edge& e : graph_.edges)
    {
      if(e.is_virtual)
        continue;
      if(e.piece == null_index || !ridges_.piece(e.piece).is_bisector)
      {
        result = (std::min)(result, least_distance_in(e.face));
        continue;
      }
      for(Index i : e.nodes)
        if(graph_.nodes[i].face != null_index)
          result = (std::min)(result, graph_.nodes[i].distance);
      const Image &a = ridges_.piece(e.piece).images[0], &b = ridges_.piece(e.piece).images[1];
      const auto side = [&](const Plane_point& p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
      if(side(ridges_.piece_end(e.piece, 0)) * side(ridges_.piece_end(e.piece, 1)) < 0.)
        result = (std::min)(result, 0.5 * (std::hypot(b.x - a.x, b.y - a.y) + a.sigma + b.sigma));
    }
    return result;
  }

  /// those of the edges of which labels do not say where they are, and the topology alone that there is something
  std::vector<Index> unknown(const std::vector<Tree_branches::Edge>& edges) const
  {
    std::vector<Index> result;
    for(const Tree_branches::Edge& b : edges)
      if(graph_.edges[b.edge].piece == null_index && !graph_.edges[b.edge].is_virtual)
        result.push_back(b.edge);
    std::sort(result.begin(), result.end());
    return result;
  }
  bool is_known(const std::vector<Tree_branches::Edge>& edges) const { return unknown(edges).empty(); }
  /// the faces of those that do not follow bisectors of labels, so that distances may be wrong on them, in order
  std::vector<Index> faces_off_bisectors(const std::vector<Tree_branches::Edge>& edges) const
  {
    std::vector<Index> result;
    for(const Tree_branches::Edge& b : edges)
    {
      const Tree_graph::Edge& e = graph_.edges[b.edge];
      if(!e.is_virtual && (e.piece == null_index || !ridges_.piece(e.piece).is_bisector))
        result.push_back(e.face);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  Ridges::Enclosed enclosed(Index e) const
  {
    const Tree_graph::Edge& edge = graph_.edges[e];
    constexpr double whole = (std::numeric_limits<double>::infinity)();
    if(edge.piece == null_index || edge.is_between_sources())
      return {0., whole};
    return runs_.options.lines.empty() ? ridges_.enclosed(edge.piece, edge.face) : Ridges::Enclosed{edge.gap, whole};
  }

  /// how wide an edge has to be
  static double least_width(const Branch_strength& least, const Ridges::Enclosed& there)
  {
    const double width = least.is_enough(there.curvature, there.length) ? least.narrow : least.width;
    return width > 0. ? least.share_of_width(there.length) * width : 0.;
  }

  /// how long a branch through an edge has to be that is low, but encloses enough: behind a corner, or a limb, paths get no
  /// farther apart than twice the length of the branch that comes from it; what is shorter is a fork at the end of another
  double least_length(Index e, const Branch_strength& least)
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    // in the middle of a curve that is nearly a circle, what it encloses is no corner
    if(!runs_.options.lines.empty() || graph_.edges[e].piece == null_index)
      return infinity;
    const Ridges::Enclosed there = enclosed(e);
    if(!least.is_enough(there.curvature, there.length))
      return infinity;
    const double wide = width(e);
    return wide >= least_width(least, there) ? 0.25 * wide : infinity;
  }

  /// of an edge at a leaf; if it is weak, it falls off, and the bounds know of it
  bool is_strong(Index e, Index leaf, const Branch_strength& least, Width_bounds& bounds)
  {
    double most = (std::numeric_limits<double>::infinity)();
    if(graph_.edges[e].piece != null_index && (least.is_none() || is_a_branch(e, least)))
    {
      const double needed = least_width(least, enclosed(e));
      if(!mesh_.is_intrinsic && !geodesics_.is_approximate()) // else widths are no separations of known paths
        most = bounds.most(e, leaf);
      if(!(most < needed))
      {
        if(needed == 0. || width(e) >= needed)
          return true;
        most = bounds.most(e, double(width(e)));
      }
    }
    bounds.add(e, leaf, most);
    return false;
  }

  std::vector<Tree_branches::Edge> find_kept(const Branch_strength& least, const Progress& progress)
  {
    Width_bounds bounds(graph_, ridges_, geodesics_);
    const std::vector<Index> edges = graph_.strong_branches(
      [&](Index e, Index leaf) { return is_strong(e, leaf, least, bounds); }, progress.part(0., 0.6));
    const Tree_branches branches(
      static_cast<Index>(graph_.nodes.size()), static_cast<Index>(edges.size()),
      [&](Index i) { return graph_.edges[edges[i]].nodes; }, [&](Index i) { return graph_.edges[edges[i]].gap; },
      connectivity_.number_of_border_loops, progress.part(0.6, 1.));
    root_ = branches.root();
    std::vector<Tree_branches::Edge> result = branches.edges();
    for(Tree_branches::Edge& b : result)
      b.edge = edges[b.edge];
    remove_spurs(
      result, static_cast<Index>(graph_.nodes.size()), connectivity_.number_of_border_loops, least.spur,
      [this](Index e) { return height(e); }, [this](Index e) { return length(e); },
      [&](Index e) { return least_length(e, least); });
    return result;
  }

  /// Of all pieces in the faces that have been drawn, few are on strong branches.
  void keep_what_is_left()
  {
    graph_.drop_lone_nodes();
    std::vector<Index> pieces;
    for(Tree_graph::Edge& e : graph_.edges)
      if(e.piece != null_index)
      {
        pieces.push_back(e.piece);
        e.piece = static_cast<Index>(pieces.size() - 1);
      }
    ridges_.keep(pieces);
  }

  /// What is between two sources is on a cycle. On no branch it is more than rounding, so that it holds none.
  bool is_a_branch(Index e, const Branch_strength& least) const
  {
    const Tree_graph::Edge& edge = graph_.edges[e];
    return !edge.is_between_sources() && edge.gap >= least.gap && graph_.can_be(e, least);
  }

  /// by how much a way along it is longer than the distance grows there; see `remove_spurs()`
  double height(Index edge) const
  {
    const auto& [a, b] = graph_.edges[edge].nodes;
    return (std::max)(0., length(edge) - std::fabs(graph_.nodes[a].distance - graph_.nodes[b].distance));
  }

  /// nothing is known of what the topology alone has added
  double length(Index edge) const
  {
    const Index p = graph_.edges[edge].piece;
    if(p == null_index)
      return 0.;
    const Plane_point a = ridges_.piece_end(p, 0), b = ridges_.piece_end(p, 1);
    return std::hypot(a.x - b.x, a.y - b.y);
  }

  /// a lower bound of the distances of all points of a face
  double least_distance_in(Index face) const
  {
    double result = 0.;
    for(Index h = 3 * face; h < 3 * face + 3; ++h)
      result = (std::max)(result, geodesics_.distance(mesh_.source(h)) -
                                    (std::max)(geodesics_.faces().length(h),
                                               geodesics_.faces().length(Indexed_triangle_mesh::previous(h))));
    return result;
  }

  /// of the two paths to a point of the piece
  double separation(Index face, const Ridges::Piece& piece, const Plane_point& p) const
  {
    if(mesh_.is_intrinsic)
      return Comparison_width(geodesics_)(face, p, piece.images[0], piece.images[1]);
    return geodesics_.is_approximate() ? (*shots_)(face, p, piece.images[0], piece.images[1])
                                       : (*measure_)(face, p, piece.images[0], piece.images[1]);
  }

  /// a point of a piece; at an end that is a vertex of the mesh nothing would tell how the paths to it go around that
  Plane_point next_to_end(Index piece, int end) const
  {
    constexpr double share = 1e-6;
    return between(ridges_.piece_end(piece, end), ridges_.piece_end(piece, 1 - end), share);
  }

  /// the faces of edges of which nothing is known but that they are there, and rings of faces around these
  std::vector<Index> unknown_faces(const std::vector<Tree_branches::Edge>& edges, Index rings) const
  {
    std::vector<Index> result;
    std::vector<unsigned char> is_found(mesh_.number_of_faces(), 0), is_reached(mesh_.number_of_vertices(), 0);
    const auto add = [&](Index f)
    {
      if(is_found[f])
        return;
      is_found[f] = 1;
      result.push_back(f);
    };
    for(const Tree_branches::Edge& b : edges)
    {
      const Tree_graph::Edge& e = graph_.edges[b.edge];
      if(e.piece == null_index && e.face != null_index && !changes_.is_drawn_wholly(e.face))
        add(e.face);
    }
    for(Index ring = 0; ring < rings && !result.empty(); ++ring)
    {
      for(Index f : result)
        for(Index v : mesh_.triangles[f])
          is_reached[v] = 1;
      for(Index f = 0; f < mesh_.number_of_faces(); ++f)
        for(Index v : mesh_.triangles[f])
          if(is_reached[v])
            add(f);
    }
    return result;
  }

  /// the farthest point of each connected part of the edges that are known, border loops among them
  std::vector<Path_classes::Mark> known_parts(const std::vector<Tree_branches::Edge>& edges) const
  {
    Union_find parts(graph_.nodes.size());
    std::vector<Path_classes::Mark> mark(graph_.nodes.size(), Path_classes::Mark{null_index, 0.});
    const auto is_farther = [&](const Path_classes::Mark& a, const Path_classes::Mark& b)
    {
      return b.halfedge == null_index ||
             geodesics_.distance(mesh_.source(a.halfedge)) > geodesics_.distance(mesh_.source(b.halfedge));
    };
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if(mesh_.is_border_edge(h) && is_farther({h, 0.}, mark[connectivity_.border_loop[mesh_.source(h)]]))
        mark[connectivity_.border_loop[mesh_.source(h)]] = {h, 0.};
    for(const Tree_branches::Edge& b : edges)
    {
      const Tree_graph::Edge& e = graph_.edges[b.edge];
      if(e.piece == null_index && !e.is_virtual)
        continue;
      parts.unite(e.nodes[0], e.nodes[1]);
      for(Index i : e.nodes)
        if(graph_.nodes[i].crossing != null_index && graph_.nodes[i].t > 0.)
          mark[i] = {graph_.nodes[i].halfedge, graph_.nodes[i].t};
    }
    for(Index i = 0; i < mark.size(); ++i)
      if(mark[i].halfedge != null_index && is_farther(mark[i], mark[parts.find(i)]))
        mark[parts.find(i)] = mark[i];
    std::vector<Path_classes::Mark> result;
    for(Index i = 0; i < mark.size(); ++i)
      if(mark[i].halfedge != null_index && parts.find(i) == i)
        result.push_back(mark[i]);
    return result;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  Exact_geodesic_propagation& geodesics_;
  Crossing_runs runs_;
  std::vector<Index> source_vertices_;
  Progress progress_;
  Branch_strength least_;
  Label_changes changes_;
  Ridges ridges_;
  Tree_graph graph_;
  Index root_ = null_index;
  std::vector<float> width_;              // of each edge, negative as long as nobody has asked for it
  std::vector<Tree_branches::Edge> kept_; // what `kept()` has returned at last
  std::optional<Branch_strength> kept_for_;
  std::vector<float> shown_width_;
  std::unique_ptr<Digon_width> measure_;
  std::unique_ptr<Shot_width> shots_; // for distances with an error
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_TREE_EXACT_TREE_H
