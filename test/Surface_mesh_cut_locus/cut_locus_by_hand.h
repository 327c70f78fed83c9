// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_TEST_CUT_LOCUS_BY_HAND_H
#define SURFACE_MESH_CUT_LOCUS_TEST_CUT_LOCUS_BY_HAND_H

#include <CGAL/Cut_locus.h>

#include <memory>
#include <vector>

// Only the package makes a cut locus, and this specialization, which takes any graph.
template <>
class CGAL::Cut_loci::internal::Cut_locus_builder<void, void>
{
public:
  template <typename CutLocus>
  static CutLocus make(const typename CutLocus::Graph& graph, const std::vector<typename CutLocus::Vertex>& sources)
  {
    return CutLocus(
      graph, sources, {}, std::make_shared<Source_result>(), [](const auto&) { return 0.; }, nullptr, 0, false);
  }
};

template <typename CutLocus>
CutLocus cut_locus_by_hand(const typename CutLocus::Graph& graph,
                           const std::vector<typename CutLocus::Vertex>& sources = {{}})
{
  return CGAL::Cut_loci::internal::Cut_locus_builder<void, void>::make<CutLocus>(graph, sources);
}

#endif // SURFACE_MESH_CUT_LOCUS_TEST_CUT_LOCUS_BY_HAND_H
