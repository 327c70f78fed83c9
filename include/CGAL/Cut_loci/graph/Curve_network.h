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

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A graph of mesh edges as chains of nodes between its leaves and branch points.
class Curve_network
{
public:
  // From end to end; the ends of a loop are the same node.
  struct Chain
  {
    std::vector<Index> nodes, edges;
  };

  std::vector<Chain> chains;

  explicit Curve_network(const Indexed_cut_locus& graph) : graph_(graph), incident_(incident_edges(graph))
  {
    const Index n = static_cast<Index>(graph.nodes.size());
    std::vector<bool> is_walked(graph.edges.size(), false);
    for(int pass = 0; pass < 2; ++pass) // closed curves without a branch point come last
      for(Index i = 0; i < n; ++i)
        if(degree(i) != 2 || pass == 1)
          for(Index e : incident_[i])
            if(!is_walked[e])
              walk(i, e, is_walked);
  }

  Index degree(Index node) const { return incident_.size(node); }
  auto edges_at(Index node) const { return incident_[node]; }

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

  const Indexed_cut_locus& graph_;
  Compressed_rows<Index> incident_; // the edges at each node
};

template <typename Graph>
struct Chain
{
  // the first one again at the end if the chain is closed
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> edges; // one less than vertices
};

// The chains between vertices of degree other than 2, each edge in one of them; isolated vertices are chains without
// edges, and loops without such a vertex start at the first of theirs.
template <typename Graph>
std::vector<Chain<Graph>> maximal_chains(const Graph& graph)
{
  Indexed_cut_locus indexed;
  indexed.nodes.resize(num_vertices(graph));
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> descriptors;
  for(auto e : CGAL::make_range(edges(graph)))
  {
    descriptors.push_back(e);
    indexed.edges.push_back({static_cast<Index>(source(e, graph)), static_cast<Index>(target(e, graph))});
  }
  const Curve_network network(indexed);
  std::vector<Chain<Graph>> result;
  Index next = 0;
  const auto add_isolated_before = [&](std::size_t end)
  {
    for(; next < end; ++next)
      if(network.degree(next) == 0)
        result.push_back({{next}, {}});
  };
  for(const Curve_network::Chain& chain : network.chains)
  {
    const Index start = chain.nodes.front();
    add_isolated_before(network.degree(start) != 2 ? start : indexed.nodes.size());
    result.push_back({{chain.nodes.begin(), chain.nodes.end()}, {}});
    for(Index e : chain.edges)
      result.back().edges.push_back(descriptors[e]);
  }
  add_isolated_before(indexed.nodes.size());
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_CURVE_NETWORK_H
