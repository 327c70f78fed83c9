// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_PATH_NOISE_H
#define CGAL_CUT_LOCI_METHOD_PATH_NOISE_H

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Cut_loci::internal {

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
 *   has left it. What encloses almost a full turn, as a limb does, is none either.
 */
class Path_noise
{
public:
  Path_noise() = default;
  /// @param sigma an angle
  /// @param edge the mean length of edges
  /// @param length of the surface, in edges
  Path_noise(double sigma, double edge, double length)
    : sigma_(sigma), edge_(edge), length_(length), apart_(std::pow(sigma / std::sqrt(3.), 4. / 9.)),
      widest_(width((std::numeric_limits<double>::infinity)()))
  {
  }

  bool is_there() const { return sigma_ > 0.; }
  double sigma() const { return sigma_; }
  double edge() const { return edge_; }
  double length() const { return length_; }

  // Two paths that come from the base of a limb enclose a full turn but for the angle between them there.
  static constexpr double of_limb = 7. / 8. * 6.283185307179586;
  static constexpr double sharp = 0.5; // of vertices: a smooth surface with such ones has a dozen edges around it

  /// how far it takes paths of that length apart
  double width(double way) const
  {
    const double n = edges(way), root = std::cbrt(n);
    const double bent = (std::min)(std::sqrt(2.) * deviations(n) * apart_ * root * root, 0.25 * n);
    return edge_ * std::sqrt(9. + bent * bent);
  }
  /// the same of paths as long as the surface
  double widest() const { return widest_; }

  /// the curvature that they enclose
  double enclosed(double way) const { return (std::min)(2.5 * sharp + bends(way, sigma_), of_limb); }

  /// the part of it that is noise of that standard deviation
  double bends(double way, double s) const
  {
    const double n = edges(way);
    return deviations(n) * s * std::sqrt(2. * n);
  }

  bool operator==(const Path_noise& other) const
  {
    return sigma_ == other.sigma_ && edge_ == other.edge_ && length_ == other.length_;
  }

private:
  double sigma_ = 0., edge_ = 1., length_ = 1.;
  double apart_ = 0.; // how far an edge takes paths apart, in edges
  double widest_ = 3.;

  double edges(double way) const { return (std::max)(1., (std::min)(way / edge_, length_)); }
  double deviations(double n) const { return std::sqrt(2.) + std::sqrt(2. * std::log((std::max)(1., length_ / n))); }
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_METHOD_PATH_NOISE_H
