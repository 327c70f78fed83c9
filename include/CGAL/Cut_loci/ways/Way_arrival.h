// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H
#define CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * tells how a way arrives at a vertex: through which face, from which direction, and how far its last straight piece
 * goes back.
 */
struct Way_arrival
{
  Index halfedge = null_index; ///< leaves the vertex, in the face through which the way comes; null if there is none
  double angle = 0.;           ///< from there counterclockwise to the way
  double straight = 0.;        ///< length of the last straight piece
};

namespace internal {

// The distances of points on an edge at a vertex along the way to that, straight on behind it.
class Way_past_vertex
{
public:
  Way_past_vertex(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Way_arrival& arrival,
                  double distance, Index entry)
    : straight_(arrival.straight), before_(distance - arrival.straight)
  {
    const Index v = mesh.source(arrival.halfedge);
    const Index begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
    double to_way = 0., to_edge = 0., around = 0.; // counterclockwise from the first edge
    for(Index k = begin; k < end; ++k)
    {
      const Index h = connectivity.ring_halfedge[k];
      if(h == arrival.halfedge)
        to_way = around + arrival.angle;
      if(k == entry)
        to_edge = around;
      if(mesh.source(h) != v)
        break; // the last edge at a border
      const Planar_vector top = apex(mesh, h);
      around += std::atan2(top[1], top[0]);
    }
    const double turn = std::abs(to_edge - to_way), other = connectivity.is_border(v) ? turn : around - turn;
    // behind a saddle the way bends around the vertex
    cosine_ = std::cos((std::min)({turn, other, 3.14159265358979323846}));
  }

  // at a length along the edge
  double operator()(double s) const
  {
    const double square = straight_ * straight_ + s * (s - 2. * straight_ * cosine_);
    return before_ + std::sqrt((std::max)(0., square));
  }

private:
  double straight_, before_, cosine_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H
