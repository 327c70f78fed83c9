// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_PLANAR_POSITIONS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_PLANAR_POSITIONS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * moves nodes of trees in a face to the mean of their neighbors, all but those that are fixed. If these are on the
 * boundary of the face, not all of a tree on one edge, and in an order in which the trees do not cross each other, no edges
 * do so then \cgalCite{cgal:t-hdg-63}.
 *
 * @param links the two nodes of each edge
 */
inline void move_to_planar_positions(const std::vector<std::array<Index, 2>>& links,
                                     const std::vector<unsigned char>& is_fixed, std::vector<Plane_point>& position)
{
  const std::size_t n = position.size();
  std::vector<double> degree(n, 0.);
  for(const std::array<Index, 2>& link : links)
    for(Index i : link)
      ++degree[i];
  double size = 0.;
  for(const Plane_point& p : position)
    size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
  std::vector<Plane_point> sum(n);
  // A chain of n nodes takes about n * n steps. In a face with many nodes, longer ones than this come near to their places
  // in part only, in time O(n^2).
  constexpr std::size_t longest = 64;
  double change = size;
  for(std::size_t step = 0; step < longest * n && change > 1e-12 * size; ++step)
  {
    std::fill(sum.begin(), sum.end(), Plane_point{0., 0.});
    for(const std::array<Index, 2>& link : links)
      for(int k = 0; k < 2; ++k)
      {
        sum[link[k]].x += position[link[1 - k]].x;
        sum[link[k]].y += position[link[1 - k]].y;
      }
    change = 0.;
    for(std::size_t i = 0; i < n; ++i)
      if(!is_fixed[i])
      {
        const Plane_point mean{sum[i].x / degree[i], sum[i].y / degree[i]};
        change = (std::max)({change, std::fabs(mean.x - position[i].x), std::fabs(mean.y - position[i].y)});
        position[i] = {0.5 * (position[i].x + mean.x), 0.5 * (position[i].y + mean.y)};
      }
  }
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_PLANAR_POSITIONS_H
