// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H
#define CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <unordered_set>
#include <vector>

namespace CGAL::Cut_loci::internal {

template <typename Graph>
struct Chain
{
  // the first one again at the end if the chain is closed
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> edges; // one less than vertices
};

// The chains between vertices of degree other than 2, each edge in one of them; isolated vertices are chains without
// edges, and loops without such a vertex start at the first of theirs.
// The edges of an adjacency_list have no index: the address of their property tells them apart, parallel ones too.
template <typename Graph>
std::vector<Chain<Graph>> maximal_chains(const Graph& graph)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;

  std::vector<Chain<Graph>> chains;
  std::unordered_set<const void*> visited;
  const auto visit = [&](edge_descriptor e) { return visited.insert(&graph[e]).second; };

  const auto follow = [&](vertex_descriptor start, edge_descriptor e)
  {
    Chain<Graph> chain;
    chain.vertices.push_back(start);
    vertex_descriptor v = start;
    for(bool goes_on = true; goes_on;)
    {
      v = target(e, graph);
      chain.edges.push_back(e);
      chain.vertices.push_back(v);
      goes_on = false;
      if(v != start && degree(v, graph) == 2)
        for(edge_descriptor following : CGAL::make_range(out_edges(v, graph)))
          if(visit(following))
          {
            e = following;
            goes_on = true;
            break;
          }
    }
    chains.push_back(chain);
  };

  for(vertex_descriptor v : CGAL::make_range(vertices(graph)))
  {
    if(degree(v, graph) == 2)
      continue;
    if(degree(v, graph) == 0)
    {
      chains.emplace_back();
      chains.back().vertices.push_back(v);
    }
    for(edge_descriptor e : CGAL::make_range(out_edges(v, graph)))
      if(visit(e))
        follow(v, e);
  }
  for(vertex_descriptor v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 2)
      for(edge_descriptor e : CGAL::make_range(out_edges(v, graph)))
        if(visit(e))
          follow(v, e);
  return chains;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H
