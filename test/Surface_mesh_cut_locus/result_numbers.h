// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_RESULT_NUMBERS_H
#define CGAL_CUT_LOCI_RESULT_NUMBERS_H

#include <cstddef>
#include <vector>

// All numbers of a cut locus: two of them that are the same to the last bit have equal ones.
template <typename Cut_locus>
std::vector<double> result_numbers(const Cut_locus& cut_locus)
{
  std::vector<double> result;
  const auto& graph = cut_locus.graph();
  for(std::size_t v = 0; v < num_vertices(graph); ++v)
    result.insert(result.end(), {graph[v].point.x(), graph[v].point.y(), graph[v].point.z(), graph[v].distance});
  for(auto range = edges(graph); range.first != range.second; ++range.first)
  {
    const auto e = *range.first;
    result.insert(result.end(),
                  {double(source(e, graph)), double(target(e, graph)), graph[e].strength, graph[e].width});
  }
  return result;
}

#endif // CGAL_CUT_LOCI_RESULT_NUMBERS_H
