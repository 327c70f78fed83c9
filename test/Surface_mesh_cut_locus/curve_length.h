// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CURVE_LENGTH_H
#define CGAL_CUT_LOCI_CURVE_LENGTH_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>

namespace curve_length {

template <typename Cut_locus>
double length(const Cut_locus& cut_locus)
{
  double sum = 0.;
  const auto& graph = cut_locus.graph();
  for(const auto e : CGAL::make_range(edges(graph)))
    sum += std::sqrt(CGAL::squared_distance(graph[source(e, graph)].point, graph[target(e, graph)].point));
  return sum;
}

inline double length(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh, const CGAL::Cut_loci::Indexed_cut_locus& graph)
{
  using namespace CGAL::Cut_loci::internal;
  double sum = 0.;
  for(const auto& e : graph.edges)
    sum += norm(position(mesh, graph.nodes[e.source].location) - position(mesh, graph.nodes[e.target].location));
  return sum;
}

} // namespace curve_length

#endif // CGAL_CUT_LOCI_CURVE_LENGTH_H
