// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_STRAIGHT_WAVES_H
#define CGAL_CUT_LOCI_WAYS_STRAIGHT_WAVES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Where a wave comes from that is as old as told at two points: behind them as seen from the origin, from which they are in
// counterclockwise order. False if there is no such point, or the origin sees it past them.
inline bool find_virtual_source(const Planar_vector& right, const Planar_vector& left, double of_right, double of_left,
                                Planar_vector& from)
{
  const double length = norm(left - right);
  const Planar_vector along = (1. / length) * (left - right), behind = {{along[1], -along[0]}};
  const double x = 0.5 * (length + (of_right - of_left) * (of_right + of_left) / length);
  const double square = of_right * of_right - x * x;
  if(!(square > 0.))
    return false;
  from = right + x * along + std::sqrt(square) * behind;
  return cross(right, from) >= 0. && cross(from, left) >= 0.;
}

// the sum of the angles of faces at a vertex
inline double angle_around(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index v)
{
  double result = 0.;
  for(Index k = connectivity.ring_begin[v]; k < connectivity.ring_begin[v + 1]; ++k)
    if(const Index h = connectivity.ring_halfedge[k]; mesh.source(h) == v)
    {
      const Planar_vector top = apex(mesh, h);
      result += std::atan2(top[1], top[0]);
    }
  return result;
}

// Lengths of ways, which bend where their rows of faces do, straightened: a vertex is as far as a wave says that comes across
// one of its faces, from where circles around the other two corners meet, or around one of them, or as its way if that is
// shorter. One sweep in the order of the lengths.
//
// Virtual sources behind faces are those of Trettner, Bommes and Kobbelt \cgalCite{cgal:tbk-gdvsp-21}. On a smooth surface
// they err by the difference between the curvature of a wave and that of a circle in the plane.
class Straight_waves
{
public:
  // `before` is the distance of the virtual source for vertices that are reached from their source with no face in between,
  // which is far below zero if waves are lines; infinite for others.
  Straight_waves(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, std::vector<double> before,
                 std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), before_(std::move(before)), distance_(distance)
  {
  }

  void straighten()
  {
    std::vector<Index> vertices;
    for(Index v = 0; v < distance_.size(); ++v)
      if(before_[v] == infinity())
        vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end(),
              [&](Index v, Index w) { return std::tie(distance_[v], v) < std::tie(distance_[w], w); });
    for(Index v : vertices)
      straighten(v);
  }

  static constexpr double infinity() { return (std::numeric_limits<double>::infinity)(); }

private:
  struct Wave
  {
    double distance, before;
    Index around = null_index; // the vertex that it passes
  };

  void straighten(Index v)
  {
    Wave best = {infinity(), 0.};
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      if(const Index h = connectivity_.ring_halfedge[k]; mesh_.source(h) == v)
        look_across(h, best);
    before_[v] = best.around != null_index && bends(best.around) ? distance_[best.around] : best.before;
    distance_[v] = (std::min)(distance_[v], best.distance);
  }

  static void offer(double distance, double before, Index around, Wave& best)
  {
    if(distance < (1. - 1e-9) * best.distance) // by more than rounding
      best = {distance, before, around};
  }

  void look_across(Index h, Wave& best) const
  {
    const Index a = mesh_.target(h), b = mesh_.source(mesh_.previous(h));
    const Planar_vector left = apex(mesh_, h), right = {{edge_length(mesh_, h), 0.}};
    look_between(mesh_.next(h), right, left, distance_[mesh_.source(h)], best);
    for(const auto& [u, length] : {std::pair<Index, double>(a, right[0]), std::pair<Index, double>(b, norm(left))})
      if(before_[u] < infinity())
        offer(distance_[u] + length, before_[u], u, best);
  }

  // Across a halfedge, from behind it. Where its ends are seen under an obtuse angle, two waves that meet in between could
  // pass for a shorter one. So there, what is seen through the edge parts them, as in fast marching \cgalCite{cgal:ks-cgpm-98},
  // unless it is farther than the source.
  void look_between(Index h, const Planar_vector& right, const Planar_vector& left, double way, Wave& best) const
  {
    const Index a = mesh_.source(h), b = mesh_.target(h), o = mesh_.opposite[h];
    if(dot(right, left) >= 0.)
    {
      // where two waves meet, that of the earlier source goes on: the other one is but beside it
      const double before = (std::min)(before_[a], before_[b]);
      Planar_vector from;
      if(before < infinity() && find_virtual_source(right, left, distance_[a] - before, distance_[b] - before, from))
        offer(before + norm(from), before, null_index, best);
      return;
    }
    if(o == null_index)
      return;
    const Planar_vector top = apex(mesh_, o), base = right - left, along = (1. / norm(base)) * base;
    const Planar_vector behind = left + top[0] * along + top[1] * Planar_vector{{-along[1], along[0]}};
    if(cross(right, behind) <= 0. || cross(behind, left) <= 0. || norm(behind) > way)
      return;
    look_between(mesh_.next(o), right, behind, way, best);
    look_between(mesh_.previous(o), behind, left, way, best);
  }

  // Paths bend around saddles, and at the border.
  bool bends(Index v) const
  {
    return connectivity_.is_border(v) || angle_around(mesh_, connectivity_, v) > 2. * 3.14159265358979;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  std::vector<double> before_;
  std::vector<double>& distance_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_WAYS_STRAIGHT_WAVES_H
