// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H
#define CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H

#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// two sources whose cells of the geodesic Voronoi diagram touch along a curve: an edge of the dual graph.
struct Voronoi_neighbors
{
  std::array<std::size_t, 2> sources; ///< the smaller number first
  double length;                      ///< of the curve, in the unit of the points
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * finds which cells of the geodesic Voronoi diagram touch, and along what length, in the order of the sources: the dual
 * graph of the diagram, which on a smooth surface is the geodesic Delaunay triangulation if there are enough sources.
 *
 * Cells that touch in points alone are none. Time is O(n log k) for `n` edges of the cut locus and `k` pairs.
 *
 * @param cut_locus the cut locus of several points or curves, such as by `Surface_mesh_cut_locus::set_sources()`; of its
 *        edges those between two sources count
 */
template <typename TriangleMesh, typename Point_3>
std::vector<Voronoi_neighbors> voronoi_neighbors(const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto& graph = cut_locus.graph();
  std::map<std::array<std::size_t, 2>, double> length;
  for(auto e : CGAL::make_range(edges(graph)))
    if(graph[e].sources[0] != graph[e].sources[1])
    {
      const Point_3 &p = graph[source(e, graph)].point, &q = graph[target(e, graph)].point;
      length[graph[e].sources] += std::sqrt(CGAL::to_double((p - q) * (p - q)));
    }
  std::vector<Voronoi_neighbors> result;
  result.reserve(length.size());
  for(const auto& entry : length)
    result.push_back({entry.first, entry.second});
  return result;
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_VORONOI_NEIGHBORS_H
