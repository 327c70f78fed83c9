// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_STATISTICS_H
#define CGAL_CUT_LOCI_STATISTICS_H

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// whether a cut locus is what one expects
enum class Cut_locus_status {
  BRANCHES,     ///< it has edges
  ONE_POINT,    ///< it is one point. On a sphere without bumps that is right; else no branch passes the thresholds
  ONLY_A_BORDER ///< it is one point on a surface with one border loop, which shortest paths may not need to meet in: the
                ///< surface may have no cut locus, as a flat disk, or no branch passes the thresholds
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// says it in words, or nothing if all is as one expects.
inline std::string description(Cut_locus_status status)
{
  switch(status)
  {
  case Cut_locus_status::ONE_POINT:
    return "the cut locus is one point: either all shortest paths meet there, as on a sphere, or no branch passes the "
           "thresholds; with smaller ones there may be some";
  case Cut_locus_status::ONLY_A_BORDER:
    return "the cut locus has no branches: either all shortest paths end at the border, as in a flat disk, or no "
           "branch "
           "passes the thresholds; with smaller ones there may be some";
  default:
    return std::string();
  }
}

/// \ingroup PkgSurfaceMeshCutLocusRef
/// describes the graph of a cut locus by a few numbers.
struct Cut_locus_statistics
{
  Cut_locus_status status = Cut_locus_status::BRANCHES;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t components = 0;       ///< connected components of the graph
  std::size_t cycles = 0;           ///< independent cycles: edges - vertices + components
  std::size_t leaves = 0;           ///< vertices of degree 1
  std::size_t branchings = 0;       ///< vertices of degree 3 or more
  double length = 0.;               ///< the sum of the lengths of the edges
  std::size_t narrow_corridors = 0; ///< see `Cut_locus::number_of_narrow_corridors()`
  bool is_one_of_several = false;   ///< see `Cut_locus::is_one_of_several()`
  /// as by `CGAL::Cut_loci::injectivity_radius()`; infinity if the cut locus is empty
  double injectivity_radius = (std::numeric_limits<double>::infinity)();
  double injectivity_lower_bound = 0.; ///< see `Injectivity_radius::lower_bound`
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the statistics of a cut locus, in time proportional to its size.
 */
template <typename TriangleMesh, typename Point_3>
Cut_locus_statistics compute_statistics(const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto& graph = cut_locus.graph();
  Cut_locus_statistics result;
  result.vertices = num_vertices(graph);
  result.edges = num_edges(graph);
  if(result.edges == 0)
    result.status =
      cut_locus.number_of_border_loops() > 0 ? Cut_locus_status::ONLY_A_BORDER : Cut_locus_status::ONE_POINT;
  result.narrow_corridors = cut_locus.number_of_narrow_corridors();
  result.is_one_of_several = cut_locus.is_one_of_several();
  std::vector<std::size_t> component(result.vertices);
  if(!component.empty())
    result.components = boost::connected_components(graph, component.data());
  result.cycles = result.edges + result.components - result.vertices;
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    result.leaves += degree(v, graph) == 1;
    result.branchings += degree(v, graph) > 2;
  }
  for(auto e : CGAL::make_range(edges(graph)))
  {
    const Point_3& p = graph[source(e, graph)].point;
    const Point_3& q = graph[target(e, graph)].point;
    result.length += std::sqrt(CGAL::to_double((p - q) * (p - q)));
  }
  if(result.vertices > 0)
  {
    const auto radius = Cut_loci::injectivity_radius(cut_locus);
    result.injectivity_radius = radius.distance;
    result.injectivity_lower_bound = radius.lower_bound;
  }
  return result;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_STATISTICS_H
