// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVAL_H
#define CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVAL_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

// How the shortest path to a vertex arrives: through which face, from which direction, and how far its last straight piece
// goes back.
struct Wave_arrival
{
  Index halfedge = null_index; // leaves the vertex, in the face through which the path comes
  double angle = 0.;           // from there counterclockwise to the path
  double straight = 0.;        // length of the last straight piece
};

// The distances of points on an edge at a vertex along the path to that, straight on behind it.
class Wave_past_vertex
{
public:
  Wave_past_vertex(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const Wave_arrival& arrival, double distance, Index entry)
    : straight_(arrival.straight), before_(distance - arrival.straight)
  {
    const Index v = mesh.source(arrival.halfedge);
    const Index begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
    double to_path = 0., to_edge = 0., around = 0.; // counterclockwise from the first edge
    for(Index k = begin; k < end; ++k)
    {
      const Index h = connectivity.ring_halfedge[k];
      if(h == arrival.halfedge)
        to_path = around + arrival.angle;
      if(k == entry)
        to_edge = around;
      if(mesh.source(h) != v)
        break; // the last edge at a border
      const Planar_vector top = apex(mesh, h);
      around += std::atan2(top[1], top[0]);
    }
    const double turn = std::abs(to_edge - to_path), other = connectivity.is_border(v) ? turn : around - turn;
    // behind a saddle the path bends around the vertex
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

// Tells that from the given distances: a face tells how far its corner is for what comes in across the edge opposite, as
// circles with the distances of both ends of that meet where this seems to come from. The path is in the face that is right
// about the corner, or along an edge. What arrives from the other side of the cut locus would be late.
class Wave_arrivals
{
public:
  Wave_arrivals(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), distance_(distance)
  {
  }

  // If the path is along an edge, it is taken to be on the side where what passes the corner is less wrong.
  Wave_arrival operator()(Index v) const
  {
    const Best best = found(v);
    const Index h = best.arrival.halfedge, o = best.is_along_edge ? mesh_.opposite[h] : null_index;
    if(o == null_index ||
       error_past(mesh_.source(mesh_.previous(h)), v) <= error_past(mesh_.source(mesh_.previous(o)), v))
      return best.arrival;
    const Planar_vector top = apex(mesh_, mesh_.next(o)); // the edge is the last one of that face
    return {mesh_.next(o), std::atan2(top[1], top[0]), best.arrival.straight};
  }

private:
  struct Best
  {
    Wave_arrival arrival;
    bool is_along_edge = false;
    double error = (std::numeric_limits<double>::infinity)();
  };

  Best found(Index v) const
  {
    Best best;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(const Index h = connectivity_.ring_halfedge[k]; mesh_.source(h) == v) // not the last one at a border
        look_at(h, best);
    return best;
  }

  void look_at(Index h, Best& best) const
  {
    const Index to_corner = mesh_.previous(h);
    const Planar_vector left = apex(mesh_, h), right = {{edge_length(mesh_, h), 0.}};
    const double of_left = distance_[mesh_.source(to_corner)], of_right = distance_[mesh_.target(h)];
    const double length = norm(left - right);
    const Planar_vector along = (1. / length) * (left - right), behind = {{along[1], -along[0]}};
    const double x = 0.5 * (length + (of_right - of_left) * (of_right + of_left) / length);
    const double y = std::sqrt((std::max)(0., of_right * of_right - x * x));
    const auto offer = [&](const Planar_vector& from, double before, bool is_along_edge)
    {
      const double straight = norm(from), error = std::abs(before + straight - distance_[mesh_.source(h)]);
      if(error < best.error)
        best = {{h, std::atan2(from[1], from[0]), straight}, is_along_edge, error};
    };
    offer(right, of_right, true);
    if(mesh_.is_border_edge(to_corner)) // else another face offers it
      offer(left, of_left, false);
    for(const double side : {y, -y}) // the second one is seen if the source is in this face
      if(const Planar_vector from = right + x * along + side * behind;
         cross(right, from) >= 0. && cross(from, left) >= 0.)
        offer(from, 0., false);
  }

  // of the distance of a vertex, along the path to a neighbor and straight on
  double error_past(Index w, Index v) const
  {
    Index entry = connectivity_.ring_begin[w];
    while(connectivity_.ring_vertex[entry] != v)
      ++entry;
    const Wave_past_vertex past(mesh_, connectivity_, found(w).arrival, distance_[w], entry);
    return std::abs(past(edge_length(mesh_, connectivity_.ring_halfedge[entry])) - distance_[v]);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const std::vector<double>& distance_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_WAVE_ARRIVAL_H
