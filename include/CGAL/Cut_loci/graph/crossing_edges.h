// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_CROSSING_EDGES_H
#define CGAL_CUT_LOCI_GRAPH_CROSSING_EDGES_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Local_geodesics.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The edges of a graph of segments in faces that meet another one elsewhere than at a common node.
inline std::vector<Index> crossing_edges(const Local_geodesics& geodesics, const Indexed_cut_locus& graph)
{
  struct Piece
  {
    Index face, edge;
    Planar_vector p, q; // two of the barycentric coordinates: an affine map keeps crossings
  };
  std::vector<Piece> pieces;
  for(Index e = 0; e < graph.edges.size(); ++e)
  {
    const Indexed_location &a = graph.nodes[graph.edges[e].source].location,
                           &b = graph.nodes[graph.edges[e].target].location;
    geodesics.for_each_common_face(a, b,
                                   [&](Index f)
                                   {
      const auto p = geodesics.in_face(a, f).coordinates, q = geodesics.in_face(b, f).coordinates;
      pieces.push_back({f, e, {{p[0], p[1]}}, {{q[0], q[1]}}});
    });
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& s, const Piece& t) { return s.face != t.face ? s.face < t.face : s.edge < t.edge; });

  const auto are_apart = [](const Piece& s, const Piece& t) // both ends of `t` on one side of `s`, or on its line
  {
    const double p = cross(s.q - s.p, t.p - s.p), q = cross(s.q - s.p, t.q - s.p);
    return p * q > 0. || (p == 0. && q == 0.);
  };
  std::vector<Index> result;
  for(std::size_t i = 0; i < pieces.size(); ++i)
    for(std::size_t j = i + 1; j < pieces.size() && pieces[j].face == pieces[i].face; ++j)
    {
      const Indexed_cut_locus::Edge &d = graph.edges[pieces[i].edge], &e = graph.edges[pieces[j].edge];
      if(d.source == e.source || d.source == e.target || d.target == e.source || d.target == e.target)
        continue;
      if(are_apart(pieces[i], pieces[j]) || are_apart(pieces[j], pieces[i]))
        continue;
      result.push_back(pieces[i].edge);
      result.push_back(pieces[j].edge);
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_GRAPH_CROSSING_EDGES_H
