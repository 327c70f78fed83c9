// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CURVE_CURVE_CORRESPONDENCE_H
#define CGAL_CUT_LOCI_CURVE_CURVE_CORRESPONDENCE_H

#include <CGAL/Cut_loci/curve/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// Gives segments without an origin that of the next one along the curve that has one.
inline void spread_origins(Indexed_cut_locus& curve)
{
  std::vector<Index> queue;
  for(Index s = 0; s < curve.edges.size(); ++s)
    if(curve.edges[s].origin != null_index)
      queue.push_back(s);
  const Compressed_rows<Index> incident = incident_edges(curve);
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(Index node : {curve.edges[queue[i]].source, curve.edges[queue[i]].target})
      for(Index e : incident[node])
        if(curve.edges[e].origin == null_index)
        {
          curve.edges[e].origin = curve.edges[queue[i]].origin;
          queue.push_back(e);
        }
}

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * sets `origin` of each segment of `curve`, drawn through the faces, to the edge of `mesh_edges` that it corresponds
 * to: the nearest one of its face, or, where a segment shrinks to a vertex, that of the next segment along the curve.
 * A branch that shrinks to a point of the border corresponds to none: its segments get `null_index`.
 *
 * @param face the face of each segment
 */
inline void set_origins(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                        const Indexed_cut_locus& mesh_edges, const std::vector<Index>& face, Indexed_cut_locus& curve)
{
  if(mesh_edges.edges.empty())
    return;
  std::vector<std::pair<Index, Index>> by_edge;
  for(Index i = 0; i < mesh_edges.edges.size(); ++i)
    by_edge.push_back({connectivity.edge_of_halfedge[mesh_edges.edges[i].halfedge], i});
  std::sort(by_edge.begin(), by_edge.end());

  const auto coordinates = [&](const Indexed_location& location, Index f)
  {
    std::array<double, 3> result = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(mesh.triangles[location.face][i] == mesh.triangles[f][j])
          result[j] = location.coordinates[i];
    return result;
  };
  for(Index s = 0; s < curve.edges.size(); ++s)
  {
    Indexed_cut_locus::Edge& segment = curve.edges[s];
    segment.origin = null_index;
    const std::array<double, 3> p = coordinates(curve.nodes[segment.source].location, face[s]),
                                q = coordinates(curve.nodes[segment.target].location, face[s]);
    double nearest = (std::numeric_limits<double>::infinity)();
    for(Index i = 0; i < 3; ++i)
    {
      const Index e = connectivity.edge_of_halfedge[3 * face[s] + i];
      const auto found = std::lower_bound(by_edge.begin(), by_edge.end(), std::make_pair(e, Index(0)));
      const double away = p[(i + 2) % 3] + q[(i + 2) % 3]; // zero on the edge, two at the opposite vertex
      if(found != by_edge.end() && found->first == e && away < nearest)
      {
        nearest = away;
        segment.origin = found->second;
      }
    }
  }
  internal::spread_origins(curve);
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_CURVE_CURVE_CORRESPONDENCE_H
