// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INJECTIVITY_RADIUS_H
#define CGAL_CUT_LOCI_INJECTIVITY_RADIUS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// is the point of a cut locus that is nearest to the source.
template <typename TriangleMesh, typename Point_3>
struct Injectivity_radius
{
  using Graph = typename Cut_locus<TriangleMesh, Point_3>::Graph;
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;

  /// the injectivity radius: the distance of `point` to the source
  double distance = (std::numeric_limits<double>::infinity)();
  /// Within this distance no point of the polyhedron has several shortest paths, whatever the thresholds: branches that
  /// are left out begin no nearer. It is at most `distance`, and 0 if it is not known, as with
  /// `Cut_loci::Laplacian_method`.
  double lower_bound = 0.;
  Point_3 point; ///< where it is reached
  /// the vertex of the graph that it is reached at, or the nearer end of `edge`
  vertex_descriptor vertex = boost::graph_traits<Graph>::null_vertex();
  /// the edge of the graph, if it is reached between its ends
  std::optional<edge_descriptor> edge;
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the injectivity radius of the exponential map at the source: the smallest distance on the cut locus, and
 * where it is reached. On the smooth surface, each point within this radius has one shortest path to the source. On the
 * polyhedron, this holds within `lower_bound`, which is the radius of the cut locus of `Cut_loci::Polyhedral_method`. That
 * has a branch to each vertex of positive curvature: on a mesh of a smooth surface, where it is positive, the bound is the
 * distance of the nearest such vertex, about an edge, and says how little the polyhedron knows of the surface; on a
 * polyhedron that stands for itself, and where curvature is not positive, the two are equal, or near to each other. Beside
 * a source that is a curve with corners it is 0. Time is proportional to the size of the cut locus.
 *
 * The distance between the ends of an edge of length l, with distances a and b, is taken to be that to a point of a
 * plane: the square of the distance is a parabola, and its minimum is the foot of the perpendicular. That is exact
 * where the shortest paths to the edge run through the same faces, and a lower bound on a convex surface, where several
 * such parts join. It is at most l^2 / (4 (a + b)) below the ends. Beside sources that are curves it is the smallest
 * distance at a vertex of the graph: waves of their edges are straight.
 *
 * A cut locus of edges of the mesh is off the true one by a part of an edge, and so is the radius. Where that matters,
 * use `Cut_loci::Curve::THROUGH_FACES`: where the radius is reached inside of a curve, the error then falls with the
 * square of the length of the edges. Ends of branches, where it is reached as often, remain off by a part of an edge,
 * and a threshold that shortens a branch removes them: `Cut_loci::Default_method` finds them best. Take a slightly
 * smaller radius where injectivity must be certain.
 *
 * @throws Invalid_input if the cut locus has no vertices
 */
template <typename TriangleMesh, typename Point_3>
Injectivity_radius<TriangleMesh, Point_3> injectivity_radius(const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto& graph = cut_locus.graph();
  if(num_vertices(graph) == 0)
    throw Invalid_input(Cause::INVALID_CUT_LOCUS, "the cut locus is empty: it has no distance to the source");

  Injectivity_radius<TriangleMesh, Point_3> result;
  for(auto v : CGAL::make_range(vertices(graph)))
    if(!(graph[v].distance >= result.distance))
    {
      result.distance = graph[v].distance;
      result.point = graph[v].point;
      result.vertex = v;
    }
  for(auto e : CGAL::make_range(edges(graph)))
  {
    if(cut_locus.is_curve(graph[e].sources[0]) || cut_locus.is_curve(graph[e].sources[1]))
      continue; // the distance to a line is no larger between two points than at both
    const auto s = source(e, graph), t = target(e, graph);
    const Point_3 &p = graph[s].point, &q = graph[t].point;
    const double a = graph[s].distance, b = graph[t].distance;
    const double squared_length = CGAL::to_double((q - p) * (q - p));
    const double difference = (a - b) * (a + b);
    if(!(std::abs(difference) < squared_length))
      continue; // the perpendicular meets the line outside of the edge
    if(!((a + b) * (a + b) > squared_length))
      continue; // such distances, which are not exact, do not exist in a plane
    const double position = 0.5 * (1. + difference / squared_length);
    const double distance = std::sqrt((std::max)(0., a * a - position * position * squared_length));
    if(!(distance < result.distance))
      continue;
    result.distance = distance;
    result.point = p + typename Kernel_traits<Point_3>::Kernel::FT(position) * (q - p);
    result.vertex = a <= b ? s : t;
    result.edge = e;
  }
  result.lower_bound = (std::min)(cut_locus.least_distance(), result.distance);
  return result;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_INJECTIVITY_RADIUS_H
