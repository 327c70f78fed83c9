// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_EDGE_ARRAYS_H
#define CGAL_CUT_LOCI_INTERNAL_EDGE_ARRAYS_H

#include <array>
#include <cstdint>
#include <type_traits>

namespace CGAL::Cut_loci::internal {

// What files tell of each edge: calls `take(name, value_of)` for each array, and `value_of(e)` has the type of its
// values. So the names are the same in all formats.
template <typename Graph, typename Edge_marks, typename Function>
void for_each_edge_array(const Graph& graph, const Edge_marks& is_marked, const Function& take)
{
  take("strength", [&](const auto& e) { return graph[e].strength; });
  take("width", [&](const auto& e) { return graph[e].width; });
  take("enclosed", [&](const auto& e) { return graph[e].curvature; });
  take("source1", [&](const auto& e) { return static_cast<std::int32_t>(graph[e].sources[0]); });
  take("source2", [&](const auto& e) { return static_cast<std::int32_t>(graph[e].sources[1]); });
  if(is_marked.is_given())
    take("marked", [&](const auto& e) { return static_cast<std::uint8_t>(is_marked(e)); });
}

// The name of a type in a file, of those for real numbers, whole ones and truth values.
template <typename T>
const char* name_of_type(const std::array<const char*, 3>& names)
{
  return names[std::is_same<T, double>::value ? 0 : std::is_same<T, std::int32_t>::value ? 1 : 2];
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_EDGE_ARRAYS_H
