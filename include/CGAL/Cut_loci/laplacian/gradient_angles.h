// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_GRADIENT_ANGLES_H
#define CGAL_CUT_LOCI_LAPLACIAN_GRADIENT_ANGLES_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/laplacian/Tangent_directions.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Cut_loci {

/*
 * computes for each vertex the largest angle, in radians in [0, pi], between two gradients at its neighbors,
 * parallel-transported to the vertex: the strength of the cut locus there.
 *
 * Only pairs of gradients that converge count, that is, that point towards each other from their places. Those of a
 * convex function diverge, as around the source, which is a singularity of the distance as well: there the strength is 0.
 *
 * @param gradient the coordinates of the gradients in the frames of `Differential_operators`; those that are zero have no
 *        direction, and do not count
 */
inline std::vector<float> gradient_angles(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                          const Tangent_directions& tangent, const Eigen::VectorXd& gradient,
                                          const internal::Progress& progress = {})
{
  using Direction = Tangent_directions::Direction;
  const Index nv = static_cast<Index>(connectivity.ring_begin.size() - 1);
  std::vector<Direction> unit(nv);
  for(Index v = 0; v < nv; ++v)
  {
    const double x = gradient[2 * v], y = gradient[2 * v + 1], length = std::sqrt(x * x + y * y);
    if(length > 0.)
      unit[v] = Direction(static_cast<float>(x / length), static_cast<float>(y / length));
  }

  std::vector<float> angle(nv, 0.f);
  std::vector<Direction> transported, place; // of the neighbors, in the tangent plane
  for(Index v = 0; v < nv; ++v)
  {
    progress(v, nv);
    const Index begin = connectivity.ring_begin[v], k = connectivity.valence(v);
    transported.resize(k);
    place.resize(k);
    for(Index i = 0; i < k; ++i)
    {
      const double length = internal::edge_length(mesh, connectivity.ring_halfedge[begin + i]);
      place[i] = static_cast<float>(length) * tangent.direction[begin + i];
      transported[i] = tangent.transport(connectivity, begin + i) * unit[connectivity.ring_vertex[begin + i]];
    }

    float smallest = 1.f, sine = 0.f; // cosine and sine of the largest angle
    for(Index i = 0; i + 1 < k; ++i)
      for(Index j = i + 1; j < k; ++j)
      {
        const Direction a = transported[i], b = transported[j];
        if(a == Direction() || b == Direction())
          continue;
        const float cosine = a.real() * b.real() + a.imag() * b.imag();
        if(cosine >= smallest)
          continue;
        const Direction difference = a - b, apart = place[i] - place[j];
        if(difference.real() * apart.real() + difference.imag() * apart.imag() >= 0.f)
          continue;
        smallest = cosine;
        sine = std::abs(a.real() * b.imag() - a.imag() * b.real());
      }
    angle[v] = smallest < 1.f ? std::atan2(sine, smallest) : 0.f;
  }
  return angle;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_LAPLACIAN_GRADIENT_ANGLES_H
