// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_CURVE_BESIDE_VERTICES_H
#define CGAL_CUT_LOCI_LAPLACIAN_CURVE_BESIDE_VERTICES_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/laplacian/Wave_arrivals.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A graph of mesh edges, pushed off its vertices to where no shortest path to a vertex arrives.
//
// A path comes to each vertex from one of the sides of the graph there. So the vertex belongs to that side, and the curve
// passes it on the others: it crosses the edges at the vertex that are there. What is left is the order of the points in
// which it crosses edges of the mesh, and wherever these are on their edges, segments between them meet nowhere: the
// complement of the curve stays what that of the graph is.
//
// Where three branches meet, they do so on the one that the path arrives opposite to. Tips and vertices on the border stay,
// and where more branches meet, or the curve would enter a face at a source.
class Curve_beside_vertices
{
public:
  // on an edge of the mesh, or at a vertex
  struct Point
  {
    Index vertex;             // at which it is, or next to which it crosses an edge
    Index entry = null_index; // of the ring of that vertex: the edge
    bool is_end = true;       // of chains
  };
  struct Stop
  {
    Index point;
    double place;                // from node to node of the chain of the graph
    Index halfedge = null_index; // of the edge of the mesh along which it is reached from another vertex
  };
  struct Chain
  {
    std::vector<Stop> stops;  // the first one again at the end if it is a loop
    std::vector<Index> edges; // of the graph
  };

  Curve_beside_vertices(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                        const Wave_arrivals& arrivals, const Indexed_cut_locus& graph,
                        const std::vector<Index>& source_of_face)
    : mesh_(mesh), connectivity_(connectivity), arrivals_(arrivals), graph_(graph), source_of_face_(source_of_face),
      network_(graph)
  {
    for(Index node = 0; node < graph.nodes.size(); ++node)
      passed_.push_back(look_at(node));
    for(const Curve_network::Chain& chain : network_.chains)
      push_off(chain);
  }

  const std::vector<Point>& points() const { return points_; }
  const std::vector<Chain>& chains() const { return chains_; }
  // the one in place of the first node of the graph
  Index root() const { return root_; }

  Index edge_of(const Point& p) const { return p.entry == null_index ? null_index : connectivity_.ring_edge(p.entry); }

private:
  // How the curve passes a node: the entry of the face where the path arrives, if it does not run through its vertex, and
  // where chains end there, if they do; of three edges, the one that is opposite to the path.
  struct Passed
  {
    Index arrival = null_index, end = null_index, opposite = null_index;
  };

  Index entry_of_edge(Index node, Index edge) const
  {
    Index entry = connectivity_.ring_begin[graph_.nodes[node].vertex];
    while(connectivity_.ring_edge(entry) != connectivity_.edge_of_halfedge[graph_.edges[edge].halfedge])
      ++entry;
    return entry;
  }

  // around a vertex, counterclockwise
  Index next(Index v, Index entry) const
  {
    return entry + 1 < connectivity_.ring_begin[v + 1] ? entry + 1 : connectivity_.ring_begin[v];
  }
  Index previous(Index v, Index entry) const
  {
    return entry > connectivity_.ring_begin[v] ? entry - 1 : connectivity_.ring_begin[v + 1] - 1;
  }
  // whether that of three entries around a vertex is met before `end`, from `begin` on
  static bool is_between(Index entry, Index begin, Index end)
  {
    return begin < end ? entry >= begin && entry < end : entry >= begin || entry < end;
  }

  Index add_point(Index v, Index entry, bool is_end)
  {
    points_.push_back({v, entry, is_end});
    return static_cast<Index>(points_.size() - 1);
  }

  Passed look_at(Index node)
  {
    const Index v = graph_.nodes[node].vertex, degree = network_.degree(node);
    Passed result;
    if(degree == 2 || degree == 3)
      result.arrival = arrival_off_sources(node);
    if(result.arrival == null_index)
      result.end = add_point(v, null_index, true);
    else if(degree == 3)
    {
      const std::vector<Index> entries = entries_of_edges(node);
      for(std::size_t i = 0; i < 3; ++i)
        if(is_between(result.arrival, entries[i], entries[(i + 1) % 3]))
          result.opposite = entries[(i + 2) % 3];
      result.end = add_point(v, result.opposite, true);
    }
    return result;
  }

  std::vector<Index> entries_of_edges(Index node) const
  {
    std::vector<Index> result;
    for(Index e : network_.edges_at(node))
      result.push_back(entry_of_edge(node, e));
    std::sort(result.begin(), result.end());
    return result;
  }

  // the entry of the face where the path arrives, or null if the curve has to go through the vertex
  Index arrival_off_sources(Index node) const
  {
    const Index v = graph_.nodes[node].vertex, h = arrivals_[v].halfedge;
    if(connectivity_.is_border(v))
      return null_index;
    Index result = connectivity_.ring_begin[v];
    while(connectivity_.ring_halfedge[result] != h)
      ++result;
    if(source_of_face_.empty())
      return result;
    const std::vector<Index> entries = entries_of_edges(node);
    Index begin = entries.back(), end = entries.front(); // of the side where the path arrives
    for(std::size_t i = 0; i + 1 < entries.size(); ++i)
      if(is_between(result, entries[i], entries[i + 1]))
      {
        begin = entries[i];
        end = entries[i + 1];
      }
    for(Index k = end; k != begin; k = next(v, k))
      if(source_of_face_[connectivity_.ring_halfedge[k] / 3] != null_index)
        return null_index;
    return result;
  }

  enum class Side {
    ON, // ends of chains are on the graph
    LEFT,
    RIGHT
  };

  // The points of a chain, as they are found.
  struct Walk
  {
    Chain chain;
    double place = 0.;
    Side side = Side::ON;
  };

  void push_off(const Curve_network::Chain& chain)
  {
    const std::size_t m = chain.edges.size();
    const Passed &first = passed_[chain.nodes.front()], &last = passed_[chain.nodes.back()];
    Walk walk;
    walk.chain.edges = chain.edges;
    const bool is_loop = first.end == null_index;
    if(is_loop)
      pass(chain, 0, entry_of_edge(chain.nodes[0], chain.edges[m - 1]), entry_of_edge(chain.nodes[0], chain.edges[0]),
           walk);
    else
      add_end(first, chain, 0, walk);
    const Side side_of_first = walk.side;
    for(std::size_t i = 1; i < m; ++i)
    {
      walk.place = static_cast<double>(i);
      const Index node = chain.nodes[i];
      if(passed_[node].end != null_index)
        push_end(passed_[node].end, walk);
      else
        pass(chain, i, entry_of_edge(node, chain.edges[i - 1]), entry_of_edge(node, chain.edges[i]), walk);
    }
    walk.place = static_cast<double>(m);
    if(is_loop)
      close(chain, side_of_first, walk);
    else
      add_end(last, chain, m, walk);
    note_root(chain, walk.chain);
    chains_.push_back(std::move(walk.chain));
  }

  // An end, and how the chain gets there beside the vertex.
  void add_end(const Passed& end, const Curve_network::Chain& chain, std::size_t i, Walk& walk)
  {
    const bool is_first = i == 0;
    const Index node = chain.nodes[i], entry = entry_of_edge(node, chain.edges[is_first ? 0 : i - 1]);
    const bool is_beside = end.opposite != null_index && end.opposite != entry;
    if(!is_first && is_beside)
      pass(chain, i, entry, end.opposite, walk);
    push_end(end.end, walk);
    if(is_first && is_beside)
      pass(chain, i, end.opposite, entry, walk);
  }

  // Passes a vertex that is entered along one edge and left along another, on the side where no path arrives.
  void pass(const Curve_network::Chain& chain, std::size_t i, Index in, Index out, Walk& walk)
  {
    const Index node = chain.nodes[i], v = graph_.nodes[node].vertex;
    const Side side = is_between(passed_[node].arrival, out, in) ? Side::RIGHT : Side::LEFT;
    if(i > 0)
      change_side(chain, i, side, walk);
    walk.side = side;
    const auto following = [&](Index k) { return side == Side::RIGHT ? next(v, k) : previous(v, k); };
    for(Index k = following(in); k != out; k = following(k))
      push(v, k, walk);
  }

  // across the edge before node `i`
  void change_side(const Curve_network::Chain& chain, std::size_t i, Side side, Walk& walk)
  {
    if(walk.side == Side::ON || walk.side == side)
      return;
    const Index before = chain.nodes[i - 1];
    walk.place -= 0.5;
    push(graph_.nodes[before].vertex, entry_of_edge(before, chain.edges[i - 1]), walk);
    walk.place += 0.5;
  }

  // Where the curve would come back to the edge that it has crossed last, it turns before that: there is no vertex between.
  void push(Index v, Index entry, Walk& walk)
  {
    std::vector<Stop>& stops = walk.chain.stops;
    const Index edge = connectivity_.ring_edge(entry);
    if(stops.empty() || !is_at_edge(stops.back().point, edge))
      stops.push_back({add_point(v, entry, false), walk.place});
    else if(!points_[stops.back().point].is_end)
      stops.pop_back();
  }

  void push_end(Index end, Walk& walk)
  {
    std::vector<Stop>& stops = walk.chain.stops;
    const auto is_next = [&](Index point)
    {
      const Index edge = edge_of(points_[point]);
      return !points_[point].is_end && is_at_edge(end, edge);
    };
    while(!stops.empty() && is_next(stops.back().point))
      stops.pop_back();
    stops.push_back({end, walk.place, stops.empty() ? null_index : halfedge_to(end, walk)});
    walk.side = Side::ON;
  }

  // The edge along which a curve that crosses none gets from its last stop to a point, if both are at vertices: two may join
  // them. It is the first one from the edge of the graph on, on the side on which the vertices between are passed.
  Index halfedge_to(Index point, const Walk& walk) const
  {
    const Stop& stop = walk.chain.stops.back();
    const Point &from = points_[stop.point], &to = points_[point];
    if(from.entry != null_index || to.entry != null_index)
      return null_index;
    const Index edge = walk.chain.edges[static_cast<std::size_t>(stop.place)], node = graph_.edges[edge].source;
    const Index first =
      entry_of_edge(graph_.nodes[node].vertex == from.vertex ? node : graph_.edges[edge].target, edge);
    Index entry = first;
    do
    {
      if(connectivity_.ring_vertex[entry] == to.vertex)
        return connectivity_.ring_halfedge[entry];
      entry = walk.side == Side::RIGHT ? previous(from.vertex, entry) : next(from.vertex, entry);
    } while(entry != first);
    return null_index;
  }

  bool is_at_edge(Index point, Index edge) const
  {
    const Point& p = points_[point];
    const Index h = connectivity_.halfedge_of_edge[edge];
    return p.entry != null_index ? edge_of(p) == edge : mesh_.source(h) == p.vertex || mesh_.target(h) == p.vertex;
  }

  void close(const Curve_network::Chain& chain, Side side_of_first, Walk& walk)
  {
    change_side(chain, chain.edges.size(), side_of_first, walk);
    std::vector<Stop>& stops = walk.chain.stops;
    auto first = stops.begin();
    while(first + 1 < stops.end() && !points_[stops.back().point].is_end &&
          is_at_edge(first->point, edge_of(points_[stops.back().point])))
    {
      stops.pop_back();
      first += points_[first->point].is_end ? 0 : 1;
    }
    stops.erase(stops.begin(), first);
    walk.side = side_of_first;
    stops.push_back({stops.front().point, walk.place, halfedge_to(stops.front().point, walk)});
  }

  void note_root(const Curve_network::Chain& chain, const Chain& result)
  {
    const auto found = std::find(chain.nodes.begin(), chain.nodes.end(), Index(0));
    if(found == chain.nodes.end())
      return;
    const auto place = static_cast<double>(found - chain.nodes.begin());
    root_ =
      std::find_if(result.stops.begin(), result.stops.end(), [&](const Stop& s) { return s.place >= place; })->point;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Wave_arrivals& arrivals_;
  const Indexed_cut_locus& graph_;
  const std::vector<Index>& source_of_face_; // the source at a face, or null; empty if they are not known
  Curve_network network_;
  std::vector<Passed> passed_; // of each node
  std::vector<Point> points_;
  std::vector<Chain> chains_;
  Index root_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_CURVE_BESIDE_VERTICES_H
