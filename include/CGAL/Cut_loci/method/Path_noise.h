// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_PATH_NOISE_H
#define CGAL_CUT_LOCI_METHOD_PATH_NOISE_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * tells what a mesh and its noise do to two shortest paths that part and meet again. Up to where they part they have the
 * same noise: only the way from there on counts.
 *
 * - A mesh resolves three edges. A surface with a dozen edges around has vertices of half a radian, and a quarter of that
 *   width has room for two of them: two and a half are of the shape.
 * - Noise bends paths by &sigma; on each edge. On a closed way along two paths of n edges, bends sum to
 *   &sigma; &radic;(2 n). They take the two s = h &sigma; n<sup>3/2</sup> / &radic;3 apart, or, as the shortest of many is
 *   taken \cgalCite{cgal:kpz-dsgi-86}, h (s/h)<sup>4/9</sup>.
 * - 1.4 standard deviations of the sum, and twice that way, are for paths as long as the surface, of L edges. There are
 *   L / n ways of n edges one after the other, and the largest of so many is &radic;(2 log(L / n)) standard deviations
 *   larger \cgalCite{cgal:ds-mtqh-01}.
 * - No path turns by more than a right angle at an edge, and what is as wide as a quarter of the way is the shape, as noise
 *   has left it.
 */
struct Path_noise
{
  double sigma = 0.;  // an angle
  double edge = 1.;   // the mean length of edges
  double length = 1.; // of the surface, in edges

  static constexpr double sharp = 0.5; // of vertices: a smooth surface with such ones has a dozen edges around it

  /// how far it takes paths of that length apart
  double width(double way) const
  {
    const double n = edges(way);
    const double apart = std::pow(sigma * std::pow(n, 1.5) / std::sqrt(3.), 4. / 9.);
    return edge * std::hypot(3., (std::min)(std::sqrt(2.) * deviations(n) * apart, 0.25 * n));
  }

  /// the curvature that they enclose
  double enclosed(double way) const { return 2.5 * sharp + bends(way, sigma); }

  /// the part of it that is noise of that standard deviation
  double bends(double way, double s) const
  {
    const double n = edges(way);
    return deviations(n) * s * std::sqrt(2. * n);
  }

  bool operator==(const Path_noise& other) const
  {
    return sigma == other.sigma && edge == other.edge && length == other.length;
  }

private:
  double edges(double way) const { return (std::max)(1., (std::min)(way / edge, length)); }
  double deviations(double n) const { return std::sqrt(2.) + std::sqrt(2. * std::log((std::max)(1., length / n))); }
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_METHOD_PATH_NOISE_H
