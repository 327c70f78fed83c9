// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MESH_EDGE_CURVE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MESH_EDGE_CURVE_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/graph/Edges_off_sources.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/polyhedral/curves/Face_cells.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>
#include <CGAL/Cut_loci/ways/Way_forest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the cut locus made of edges of the mesh.
 *
 * A face that the cut locus divides belongs to the cell that holds its centroid. Two faces are on the same side if these
 * cells touch along the edge between them. A spanning tree of the faces stays on one side as far as it can. What it does
 * not reach so has to be opened elsewhere: across the cut locus, where it is nearest to the source. The edges of the mesh
 * that the tree does not cross form a graph whose complement is an open disk. What of it stands for no piece, and has
 * nothing behind it that does, is no part of the curve.
 *
 * In a corridor that is narrower than its faces are long, the centroids are on other sides. What is behind it is then
 * reached by a detour, which distances tell on the mesh that is cut open along the curve. The tree takes short ways to the
 * vertices there first, and the faces on these belong to the cells that the ways enter. As the ways of `Way_forest` to all
 * vertices are in one tree, no other choice has to be made for them.
 *
 * With several sources the tree is a forest, with one tree for each source that has a face to itself.
 *
 * Sources that are curves are parts of the border of the mesh, which is cut open along them. The curve stays off them.
 * Where it could only go on along a vertex of theirs, as the corridor beside it has no vertex inside, it ends: what is
 * behind is left out, unless it has a cycle.
 */
class Mesh_edge_curve
{
public:
  using Distance_cut_open = std::function<std::vector<double>(const Seams&)>;

  Indexed_cut_locus graph; ///< it counts the corridors that are opened elsewhere

  /// @param kept the edges of the tree that the curve stands for
  /// @param divided the mesh that the tree is on, if it is another one
  /// @param distance of the vertices
  /// @param distance_cut_open of the vertices, on the mesh that is cut open along `Seams`
  /// @param lone the vertex that is left if nothing else is, or null for none
  Mesh_edge_curve(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Divided_mesh* divided,
                  Exact_tree& tree, const std::vector<Tree_branches::Edge>& kept, const Source_roots& sources,
                  const std::vector<double>& distance, const Distance_cut_open& distance_cut_open, Index lone,
                  const Progress& progress = {})
    : mesh_(mesh), connectivity_(connectivity), divided_(divided), sources_(sources), distance_(distance),
      nodes_(mesh, connectivity, sources.parts()), tree_(tree), kept_(kept)
  {
    find_edges({}, progress.part(0., 0.4));
    shorten_ways(distance_cut_open, progress.part(0.4, 1.));
    draw(lone);
  }

private:
  // each takes a run; few surfaces need a third
  static constexpr int most_rounds = 4;

  struct Candidate
  {
    Index edge;       // of the mesh
    Index stands_for; // an edge of the tree, or null
    double gap;
    std::array<Index, 2> sources = {{0, 0}}; // on its two sides
  };

  void find_edges(const Ways_through_faces& ways, const Progress& progress)
  {
    candidates_.clear();
    graph.number_of_narrow_corridors = 0;
    std::vector<Face_entrance> entrances = ways.entrances;
    for(Index f = 0; f < entrances.size() && divided_ != nullptr; ++f)
      if(divided_->is_divided(f)) // they have other numbers in the mesh that the tree is on
        entrances[f] = {};
    const Face_cells cells(tree_.mesh(), tree_.connectivity(), tree_.geodesics().faces(), tree_.graph(), kept_,
                           entrances, progress.part(0., 0.2));
    grow_tree(ways.is_crossed, cells, progress.part(0.2, 0.8));
    drop_weak_leaves(progress.part(0.8, 1.));
    if(!sources_.parts().empty())
    {
      leave_sources();
      drop_weak_leaves(Progress());
    }
  }

  // The ways are taken that cutting lengthens by more than a quarter of an edge, and what that does to others is looked at
  // again, until it is done to none. The best curve so far counts, by the sum of all detours.
  void shorten_ways(const Distance_cut_open& distance_cut_open, const Progress& progress)
  {
    std::vector<unsigned char> is_late(mesh_.number_of_vertices(), 0);
    std::unique_ptr<Way_forest> forest;
    double least = (std::numeric_limits<double>::infinity)();
    std::vector<Candidate> best;
    Index best_number = 0;
    for(int round = 0; round <= most_rounds; ++round)
    {
      if(round > 0)
        find_edges(forest->ways([&](Index v) { return is_late[v] != 0; }), Progress());
      const std::vector<double> cut_open = distance_cut_open(seams());
      if(const double sum = sum_of_detours(cut_open); sum < least)
      {
        least = sum;
        best = candidates_;
        best_number = graph.number_of_narrow_corridors;
      }
      if(!find_late(cut_open, is_late))
        break;
      if(!forest)
      {
        forest.reset(new Way_forest(mesh_, connectivity_, sources_, distance_));
        forest->grow(progress.part(0., 0.5));
      }
    }
    candidates_ = std::move(best);
    graph.number_of_narrow_corridors = best_number;
  }

  Seams seams() const
  {
    Seams result(mesh_.number_of_halfedges(), 0);
    for(const Candidate& c : candidates_)
      add_seam(mesh_, connectivity_.halfedge_of_edge[c.edge], result);
    return result;
  }

  double sum_of_detours(const std::vector<double>& cut_open) const
  {
    double result = 0.;
    for(Index v = 0; v < cut_open.size(); ++v)
      if(cut_open[v] > distance_[v] && std::isfinite(cut_open[v]))
        result += cut_open[v] - distance_[v];
    return result;
  }

  // adds those that are; false if there are no more
  bool find_late(const std::vector<double>& cut_open, std::vector<unsigned char>& is_late) const
  {
    bool result = false;
    for(Index v = 0; v < cut_open.size(); ++v)
      if(!is_late[v] && cut_open[v] - distance_[v] > 0.25 * connectivity_.mean_edge_length)
        is_late[v] = result = true;
    return result;
  }

  void grow_tree(const std::vector<unsigned char>& is_crossed, const Face_cells& cells, const Progress& progress)
  {
    forest_ = Source_forest(mesh_.number_of_faces());
    for(Index i = 0; i < sources_.number_of_sources() && sources_.number_of_sources() > 1; ++i)
      forest_.plant(sources_.face(i), sources_.name(i));
    const auto link = [&](Index e)
    {
      const Index h = connectivity_.halfedge_of_edge[e];
      return forest_.link(h / 3, mesh_.opposite[h] / 3);
    };
    // The faces at a source belong to its cell. Those around one that is a loop form a ring.
    std::vector<unsigned char> is_done = closed_edges(connectivity_, is_crossed, sources_.elements());
    for(Index e = 0; e < is_crossed.size(); ++e)
      if(is_crossed[e])
        link(e);
    for(Index h : sources_.crossings())
      if(const Index e = connectivity_.edge_of_halfedge[h]; is_crossed.empty() || !is_crossed[e])
      {
        is_done[e] = 1;
        if(!link(e))
          candidates_.push_back({e, null_index, 0.});
      }
    // edges between cells that touch come first, in any order, then the others by the distance of their middle
    std::vector<Candidate> barred;
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      progress(e, connectivity_.number_of_edges());
      const Index h = connectivity_.halfedge_of_edge[e];
      if(is_done[e] || mesh_.is_border_edge(h))
        continue;
      const Candidate c = barrier(cells, h);
      if(c.stands_for != null_index)
        barred.push_back(c);
      else if(!link(e))
        candidates_.push_back(c);
    }
    const auto way = [&](const Candidate& c)
    {
      const Index h = connectivity_.halfedge_of_edge[c.edge];
      return distance_[mesh_.source(h)] + distance_[mesh_.target(h)];
    };
    // and between sources only where there is no other way
    const auto is_between = [](const Candidate& c) { return c.gap == (std::numeric_limits<double>::infinity)(); };
    std::sort(barred.begin(), barred.end(),
              [&](const Candidate& a, const Candidate& b) {
      return is_between(a) != is_between(b) ? is_between(b) : way(a) != way(b) ? way(a) < way(b) : a.edge < b.edge;
    });
    for(const Candidate& c : barred)
      if(!link(c.edge))
        candidates_.push_back(c);
      else
        ++graph.number_of_narrow_corridors;
    for(Candidate& c : candidates_)
      for(std::size_t k = 0; k < 2 && sources_.number_of_sources() > 1; ++k)
      {
        const Index h = connectivity_.halfedge_of_edge[c.edge];
        const Index source = forest_.source(k == 0 ? h / 3 : mesh_.opposite[h] / 3);
        c.sources[k] = source != null_index ? source : 0;
      }
  }

  /// what is between the cells of the faces of an edge: the piece of the graph with the largest gap in a face that belongs
  /// to another cell, across the interval of the edge where that is least
  Candidate barrier(const Face_cells& cells, Index h) const
  {
    if(divided_ == nullptr)
      return barrier(cells, h, h);
    Candidate best{null_index, null_index, 0.};
    for(Index part : divided_->parts(h))
    {
      const Candidate here = barrier(cells, h, part);
      const bool is_open = best.edge != null_index && best.stands_for == null_index;
      if(best.edge == null_index || (!is_open && (here.stands_for == null_index || here.gap < best.gap)))
        best = here;
    }
    return best;
  }

  /// the same for a part of the halfedge, in the mesh that the tree is on
  Candidate barrier(const Face_cells& cells, Index whole, Index h) const
  {
    const Index name = connectivity_.edge_of_halfedge[whole], o = tree_.mesh().opposite[h];
    Candidate best{name, null_index, (std::numeric_limits<double>::infinity)()};
    if(cells.is_whole(h / 3) && cells.is_whole(o / 3))
      return best;
    const Index e = tree_.connectivity().edge_of_halfedge[h];
    for(Index k = 0; k <= cells.number_of_nodes(e); ++k)
    {
      Candidate here{name, null_index, 0.};
      for(Index g : {h, o})
        if(!cells.holds_face(g, k))
          for(Index i : cells.edges(g / 3))
            if(here.stands_for == null_index || tree_.graph().edges[i].gap > here.gap)
            {
              here.stands_for = i;
              here.gap = tree_.graph().edges[here.stands_for].gap;
            }
      if(here.stands_for == null_index)
        return here;
      if(here.gap < best.gap || best.stands_for == null_index)
        best = here;
    }
    return best;
  }

  std::array<Index, 2> ends(const Candidate& c) const { return nodes_.ends(connectivity_.halfedge_of_edge[c.edge]); }

  void drop_weak_leaves(const Progress& progress)
  {
    const auto nodes = [this](Index i) { return ends(candidates_[i]); };
    Edges_left left(nodes_.size(), candidates_.size(), nodes, progress.part(0., 0.5));
    for(Index i = 0; i < nodes_.number_of_loops(); ++i)
      left.keep(i);
    std::vector<unsigned char> is_dropped(candidates_.size(), 0);
    left.peel(
      nodes,
      [&](Index i, Index leaf)
      { return (is_dropped[i] = candidates_[i].stands_for == null_index || nodes_.is_source(leaf)) != 0; },
      progress.part(0.5, 1.));
    drop(is_dropped);
  }

  void drop(const std::vector<unsigned char>& is_dropped)
  {
    std::size_t size = 0;
    for(std::size_t i = 0; i < candidates_.size(); ++i)
      if(!is_dropped[i])
        candidates_[size++] = candidates_[i];
    candidates_.resize(size);
  }

  void leave_sources()
  {
    std::vector<Index> halfedges;
    for(const Candidate& c : candidates_)
      halfedges.push_back(connectivity_.halfedge_of_edge[c.edge]);
    const Edges_off_sources off(nodes_, halfedges, "ask for cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)");
    drop(off.is_dropped());
    graph.number_of_narrow_corridors += off.number_at_sources();
  }

  /// the edges from the inside out, and the root first
  void draw(Index lone)
  {
    std::vector<Index> nodes; // dense numbers for those that are left, the loops first
    for(Index i = 0; i < connectivity_.number_of_border_loops; ++i)
      nodes.push_back(i);
    for(const Candidate& c : candidates_)
      for(Index v : ends(c))
        nodes.push_back(v);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto number = [&](Index v)
    { return static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), v) - nodes.begin()); };
    std::vector<std::array<Index, 2>> numbers;
    numbers.reserve(candidates_.size());
    for(const Candidate& c : candidates_)
      numbers.push_back({{number(ends(c)[0]), number(ends(c)[1])}});
    const Tree_branches branches(
      static_cast<Index>(nodes.size()), static_cast<Index>(candidates_.size()), [&](Index i) { return numbers[i]; },
      [&](Index i)
      { return candidates_[i].stands_for != null_index && !is_between_sources(i) ? candidates_[i].gap : 0.; },
      connectivity_.number_of_border_loops);

    std::vector<Index> vertices; // of the curve
    for(const Candidate& c : candidates_)
      for(Index h = connectivity_.halfedge_of_edge[c.edge], k = 0; k < 2; ++k, h = Indexed_triangle_mesh::next(h))
        vertices.push_back(mesh_.source(h));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    position_.assign(vertices.size(), null_index);
    const Index root = branches.root() != null_index ? nodes[branches.root()] : null_index;
    if(root != null_index && nodes_.vertex(root) != null_index && !candidates_.empty())
      add_node(vertices, nodes_.vertex(root));
    for(const Tree_branches::Edge& b : branches.edges())
    {
      const Candidate& c = candidates_[b.edge];
      const Index h = connectivity_.halfedge_of_edge[c.edge];
      const bool is_forward = numbers[b.edge][0] == b.outer;
      const Index outer = is_forward ? mesh_.source(h) : mesh_.target(h);
      const Index inner = is_forward ? mesh_.target(h) : mesh_.source(h);
      const Index i = add_node(vertices, outer), k = add_node(vertices, inner);
      Indexed_cut_locus::Edge edge{i, k, h, (std::min)(b.strength, static_cast<float>(c.gap)),
                                   static_cast<Index>(graph.edges.size())};
      if(c.stands_for == null_index)
        edge.strength = b.strength < (std::numeric_limits<float>::infinity)() ? b.strength : 0.f;
      edge.width = c.stands_for != null_index ? tree_.shown_width(c.stands_for) : 0.f;
      edge.curvature = c.stands_for != null_index ? static_cast<float>(tree_.curvature(c.stands_for)) : 0.f;
      edge.sources = {{(std::min)(c.sources[0], c.sources[1]), (std::max)(c.sources[0], c.sources[1])}};
      if(is_between_sources(b.edge))
        edge.width = static_cast<float>(2. * (std::max)(distance_[outer], distance_[inner]));
      if(is_between_sources(b.edge) || edge.strength == (std::numeric_limits<float>::infinity)())
        edge.strength = gap_between_sources;
      graph.edges.push_back(edge);
    }
    if(graph.edges.empty() && lone != null_index)
      graph.nodes.assign(1, {location_of_vertex(connectivity_, lone), lone, distance_[lone]});
  }

  bool is_between_sources(Index i) const { return candidates_[i].sources[0] != candidates_[i].sources[1]; }

  Index add_node(const std::vector<Index>& vertices, Index v)
  {
    Index& i =
      position_[static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin())];
    if(i == null_index)
    {
      i = static_cast<Index>(graph.nodes.size());
      graph.nodes.push_back({location_of_vertex(connectivity_, v), v, distance_[v]});
    }
    return i;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Divided_mesh* divided_;
  const Source_roots& sources_;
  const std::vector<double>& distance_;
  const Nodes_with_sources nodes_;
  Exact_tree& tree_;
  const std::vector<Tree_branches::Edge>& kept_;
  Source_forest forest_{0}; // of faces
  std::vector<Candidate> candidates_;
  std::vector<Index> position_; // of vertices of the curve in the graph
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MESH_EDGE_CURVE_H
