// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_CURVE_NETWORK_H
#define CGAL_CUT_LOCI_GRAPH_CURVE_NETWORK_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A graph of mesh edges as chains of nodes between its leaves and branch points, and the sides of its edges.
class Curve_network
{
public:
  // From end to end; the ends of a loop are the same node.
  struct Chain
  {
    std::vector<Index> nodes, edges;
  };

  std::vector<Chain> chains;

  Curve_network(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                const Indexed_cut_locus& graph)
    : mesh_(mesh), connectivity_(connectivity), graph_(graph), node_of_vertex_(mesh.number_of_vertices(), null_index)
  {
    const Index n = static_cast<Index>(graph.nodes.size());
    for(Index i = 0; i < n; ++i)
      node_of_vertex_[graph.nodes[i].vertex] = i;
    incident_ = incident_edges(graph);

    std::vector<bool> is_walked(graph.edges.size(), false);
    for(int pass = 0; pass < 2; ++pass) // closed curves without a branch point come last
      for(Index i = 0; i < n; ++i)
        if(degree(i) != 2 || pass == 1)
          for(Index e : incident_[i])
            if(!is_walked[e])
              walk(i, e, is_walked);
  }

  Index degree(Index node) const { return incident_.size(node); }
  bool is_leaf(Index node) const { return degree(node) == 1; }
  Index node_of_vertex(Index v) const { return node_of_vertex_[v]; }

  // the mean length of the edges at the vertex that `node` was at
  double edge_length(Index node) const
  {
    const Index v = graph_.nodes[node].vertex;
    double sum = 0.;
    for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
      sum += internal::edge_length(mesh_, connectivity_.ring_halfedge[entry]);
    return sum / connectivity_.valence(v);
  }

  // The vertices next to edges `begin`, ..., `end - 1` of `chain`, on its left and on its right. What is around a leaf
  // is on no side.
  void seeds(const Chain& chain, std::size_t begin, std::size_t end, std::array<std::vector<Index>, 2>& result) const
  {
    result[0].clear();
    result[1].clear();
    for(std::size_t i = begin; i < end; ++i)
    {
      sweep(chain.nodes[i], chain.edges[i], true, result[0]);
      sweep(chain.nodes[i], chain.edges[i], false, result[1]);
      sweep(chain.nodes[i + 1], chain.edges[i], false, result[0]);
      sweep(chain.nodes[i + 1], chain.edges[i], true, result[1]);
    }
  }

  bool is_graph_edge(Index node, Index mesh_edge) const
  {
    const auto edges = incident_[node];
    return std::any_of(edges.begin(), edges.end(),
                       [&](Index e) { return connectivity_.edge_of_halfedge[graph_.edges[e].halfedge] == mesh_edge; });
  }

private:
  void walk(Index start, Index edge, std::vector<bool>& is_walked)
  {
    Chain chain;
    chain.nodes.push_back(start);
    Index node = start;
    while(true)
    {
      is_walked[edge] = true;
      chain.edges.push_back(edge);
      const Indexed_cut_locus::Edge& e = graph_.edges[edge];
      node = e.source == node ? e.target : e.source;
      chain.nodes.push_back(node);
      if(degree(node) != 2 || node == start)
        break;
      const auto both = incident_[node].begin();
      edge = both[0] == edge ? both[1] : both[0];
    }
    chains.push_back(std::move(chain));
  }

  // The neighbors of a node between an edge of the graph and the next one.
  void sweep(Index node, Index edge, bool is_counterclockwise, std::vector<Index>& result) const
  {
    if(is_leaf(node))
      return;
    const Index v = graph_.nodes[node].vertex;
    const Index begin = connectivity_.ring_begin[v], end = connectivity_.ring_begin[v + 1];
    const Index mesh_edge = connectivity_.edge_of_halfedge[graph_.edges[edge].halfedge];
    Index entry = begin;
    while(connectivity_.ring_edge(entry) != mesh_edge)
      ++entry;
    while(true)
    {
      if(entry == (is_counterclockwise ? end - 1 : begin))
      {
        if(connectivity_.is_border(v))
          return;
        entry = is_counterclockwise ? begin : end - 1;
      }
      else
        entry = is_counterclockwise ? entry + 1 : entry - 1;
      if(is_graph_edge(node, connectivity_.ring_edge(entry)))
        return;
      result.push_back(connectivity_.ring_vertex[entry]);
    }
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Indexed_cut_locus& graph_;
  std::vector<Index> node_of_vertex_;
  Compressed_rows<Index> incident_; // the edges at each node
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_GRAPH_CURVE_NETWORK_H
