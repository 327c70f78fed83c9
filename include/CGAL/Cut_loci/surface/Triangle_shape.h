// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_TRIANGLE_SHAPE_H
#define CGAL_CUT_LOCI_SURFACE_TRIANGLE_SHAPE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

// A triangle of given edge lengths: its area, and at each corner the scalar product of the edges that start there.
// Edge `i` goes from corner `i` to the next one.
struct Triangle_shape
{
  double twice_area; // zero if the longest edge is as long as both others together, or longer
  std::array<double, 3> dots;

  explicit Triangle_shape(const std::array<double, 3>& length) : twice_area(doubled_area(length))
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double a = length[i], b = length[(i + 2) % 3], c = length[(i + 1) % 3];
      // (a^2 + b^2 - c^2) / 2, by a product where two squares nearly cancel
      dots[i] = 0.5 * (a > b ? (a - c) * (a + c) + b * b : (b - c) * (b + c) + a * a);
    }
  }

  // by how much the two shorter edges are longer than the longest one
  static double slack(std::array<double, 3> length)
  {
    std::sort(length.begin(), length.end());
    return length[0] - (length[2] - length[1]);
  }

private:
  // Heron's formula in the order in which nothing cancels but the lengths themselves, after Kahan.
  static double doubled_area(std::array<double, 3> length)
  {
    std::sort(length.begin(), length.end());
    const double a = length[2], b = length[1], c = length[0];
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0. ? 0.5 * std::sqrt(product) : 0.;
  }
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_TRIANGLE_SHAPE_H
