// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_TANGENT_DIRECTIONS_H
#define CGAL_CUT_LOCI_LAPLACIAN_TANGENT_DIRECTIONS_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL::Cut_loci {

/*
 * holds the polar angle of each edge in the tangent plane of each of its ends, as a unit complex number, where the
 * angles around an interior vertex are scaled to sum up to 2 pi. Parallel transport along the edge from `w` to `v`
 * multiplies by `-direction[v to w] * conj(direction[w to v])` \cgalCite{cgal:kcps-gods-13}.
 */
struct Tangent_directions
{
  using Direction = std::complex<float>; ///< an angle needs no more digits; this is the largest table per mesh

  std::vector<Direction> direction; ///< for each entry of the rings of `Mesh_connectivity`

  Tangent_directions(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const internal::Progress& progress = {})
  {
    using namespace internal;
    std::vector<double> angle;
    direction.resize(connectivity.ring_vertex.size());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      progress(v, mesh.number_of_vertices());
      const Index begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
      angle.assign(1, 0.);
      for(Index entry = begin; entry < end; ++entry)
      {
        const Index h = connectivity.ring_halfedge[entry];
        if(mesh.source(h) != v)
          break; // the last edge of a border vertex: no face follows
        const Planar_vector top = apex(mesh, h);
        angle.push_back(angle.back() + std::atan2(top[1], top[0]));
      }
      const double scale = connectivity.is_border(v) ? 1. : 2. * pi() / angle.back();
      for(Index entry = begin; entry < end; ++entry)
      {
        const double phi = scale * angle[entry - begin];
        direction[entry] = Direction(static_cast<float>(std::cos(phi)), static_cast<float>(std::sin(phi)));
      }
    }
  }

  /// rotates the directions at each vertex to where the edges lie, on the mean, in the plane of its frame. Angles in the
  /// plane are not those on the surface: with the first edge as zero in both, the result would depend on which is first
  template <typename Frame>
  void align(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const std::vector<Frame>& frames,
             const internal::Progress& progress = {})
  {
    using namespace internal;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      const Index begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
      progress(v, mesh.number_of_vertices());
      std::complex<double> sum = 0.;
      for(Index entry = begin; entry < end; ++entry)
      {
        const Vector edge = mesh.points[connectivity.ring_vertex[entry]] - mesh.points[v];
        sum += std::complex<double>(dot(edge, frames[v].e1), dot(edge, frames[v].e2)) *
               std::conj(std::complex<double>(direction[entry])) / edge_length(mesh, connectivity.ring_halfedge[entry]);
      }
      if(!(std::abs(sum) > 0.))
        continue;
      const Direction rotation(sum / std::abs(sum));
      for(Index entry = begin; entry < end; ++entry)
        direction[entry] *= rotation;
    }
  }

  /// rotates directions at the neighbor of entry `entry` into the tangent plane of the vertex whose ring it is in
  Direction transport(const Mesh_connectivity& connectivity, Index entry) const
  {
    return -direction[entry] * std::conj(direction[connectivity.ring_reverse[entry]]);
  }

private:
  static double pi() { return 3.14159265358979323846; }
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_LAPLACIAN_TANGENT_DIRECTIONS_H
