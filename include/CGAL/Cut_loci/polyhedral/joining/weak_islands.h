// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_JOINING_WEAK_ISLANDS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_JOINING_WEAK_ISLANDS_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Union_find.h>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*
 * On faces that are flat but for the rounding of coordinates, each vertex has a branch along which two paths differ by
 * as little as their directions are known to. Where they differ by less, no label shows it: what is left is an island,
 * from which only the topology leads to the rest, somewhere. The edges of such islands without a cycle and a border loop,
 * and of the ways that lead to them, are returned as flags.
 *
 * `is_known` tells of an edge whether a label shows it, and `is_weak` whether its paths differ by as little as that.
 */
template <typename Edges, typename Is_known, typename Is_weak>
std::vector<unsigned char> weak_islands(const Edges& edges, std::size_t number_of_nodes, Index number_of_loops,
                                        const Is_known& is_known, const Is_weak& is_weak, const Progress& progress = {})
{
  std::vector<unsigned char> result(edges.size(), 0);
  std::vector<std::size_t> ways;
  Union_find islands(number_of_nodes);
  std::vector<unsigned char> stays(number_of_nodes, 0);
  std::vector<Index> on_cycles;
  const Progress finding = progress.part(0., 0.3), marking = progress.part(0.3, 0.6), rest = progress.part(0.7, 1.);
  for(std::size_t e = 0; e < edges.size(); ++e)
  {
    finding(e, edges.size());
    if(!is_known(edges[e]))
      ways.push_back(e);
    else if(!islands.unite(edges[e].nodes[0], edges[e].nodes[1]))
      on_cycles.push_back(edges[e].nodes[0]);
  }
  if(ways.empty())
    return result;
  for(Index i : on_cycles)
    stays[islands.find(i)] = 1;
  for(Index i = 0; i < number_of_loops; ++i)
    stays[islands.find(i)] = 1;
  for(std::size_t e = 0; e < edges.size(); ++e)
  {
    marking(e, edges.size());
    if(is_known(edges[e]) && !is_weak(edges[e]))
      stays[islands.find(edges[e].nodes[0])] = 1;
  }

  // leaves of the graph of islands and ways
  const auto ends = [&](Index k) -> Edges_left::Nodes {
    return {{islands.find(edges[ways[k]].nodes[0]), islands.find(edges[ways[k]].nodes[1])}};
  };
  Edges_left left(number_of_nodes, ways.size(), ends);
  for(Index i = 0; i < number_of_nodes; ++i)
    if(stays[i])
      left.keep(i);
  left.peel(
    ends,
    [&](Index k, Index)
    {
    result[ways[k]] = 1;
    return true;
    },
    progress.part(0.6, 0.7));
  for(std::size_t e = 0; e < edges.size(); ++e)
  {
    rest(e, edges.size());
    if(is_known(edges[e]) && left.degree(islands.find(edges[e].nodes[0])) == 0)
      result[e] = 1;
  }
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_JOINING_WEAK_ISLANDS_H
