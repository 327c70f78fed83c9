// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H
#define CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
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

#endif // CGAL_CUT_LOCI_GRAPH_MAXIMAL_CHAINS_H
