// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_METHOD_THRESHOLDS_H
#define CGAL_CUT_LOCI_METHOD_METHOD_THRESHOLDS_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace CGAL::Cut_loci {

// holds the thresholds of `Branch_filter`.
struct Branch_thresholds
{
  double gradient_angle = 0.;                                    ///< in radians
  double laplacian = -(std::numeric_limits<double>::infinity)(); ///< for minus the Laplacian times the mean edge length
  Filter_policy policy = Filter_policy::PRUNING;
  Index minimum_edges = 0;    ///< branches that lead fewer edges away from the rest are removed
  double minimum_length = 0.; ///< branches that are shorter are removed
};

// holds the parameters of `Cut_locus_smoother`.
struct Smoothing_parameters
{
  Index number_of_iterations = 4;
  double damping = 0.5;            ///< the part of the way that an iteration leaves: halved with each one
  Index number_of_relaxations = 1; ///< steps of smoothing in the tangent plane at the end
};

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

inline bool is_laplacian(const Method& method)
{
  return std::holds_alternative<Laplacian_method>(method);
}

inline Laplacian_operator operator_of(const Laplacian_method& method)
{
  return method.laplacian_operator().value_or(Laplacian_operator::QUADRATIC_FIT);
}

/// is how strong a branch must be at least, to matter.
struct Branch_strength
{
  double gap = 0.;   // an angle
  double width = 0.; // a length
  // What encloses that much curvature is strong enough even if it is only as wide as `narrow`. By Gauss-Bonnet it is the
  // angle at which the two paths part and the one at which they meet: on a branch that goes around one vertex, that of
  // the vertex, from the tip on, where they part at none.
  double enclosed = (std::numeric_limits<double>::infinity)();
  double narrow = 0.;
  static constexpr double narrow_share = 0.25; // of the width, where corners do not count
  double spur = 0.; // a length: of branches that meet, those that are not as high are none; see `remove_spurs()`
  // If there is any, widths and what is enclosed are for paths as long as the surface, and others for shorter ones.
  Path_noise noise;

  bool is_none() const { return gap == 0. && width == 0.; }
  bool operator==(const Branch_strength& other) const
  {
    return gap == other.gap && width == other.width && enclosed == other.enclosed && narrow == other.narrow &&
           spur == other.spur && noise == other.noise;
  }
  /// whether it needs angles that the other one does not: those of what encloses much are never small
  bool is_weaker_than(const Branch_strength& other) const
  {
    return gap < other.gap || width < other.width || (enclosed < 2. * usual_angle && enclosed < other.enclosed);
  }

  /// whether paths of that length, from where they part, enclose enough
  bool is_enough(double curvature, double way) const
  {
    return curvature >= enclosed || (noise.is_there() && curvature >= noise.enclosed(way));
  }
  /// the widths that are asked of them, as shares of those of paths as long as the surface
  double share_of_width(double way) const { return noise.is_there() ? noise.width(way) / noise.widest() : 1.; }
  static constexpr double share_of_angle = 0.5; // that paths of some width need, see `least_angle()`

  /*
   * Of the gap, at this distance from where the paths part. Where the curvature is not negative, two paths of the length
   * d that part at an angle are never farther apart than that angle times d. A share of it is for places where it is. A gap
   * needs no such margin, but cycles, which stay whatever the strength, have weak parts; a tenth of a radian finds most
   * of them. Of the two angles that enclose a curvature one is half of it.
   */
  double least_angle(double distance) const
  {
    return (std::min)(
      {usual_angle, 0.5 * enclosed,
       (std::max)(0.1 * gap, distance > 0. ? share_of_angle * share_of_width(distance) * width / distance : 0.)});
  }

private:
  static constexpr double usual_angle = 0.1;
};

struct Exact_tree_thresholds : Branch_strength
{
  Kept_part part = Kept_part::ALL;
  Index minimum_edges = 0;    // branches of fewer edges of the mesh are removed
  double minimum_length = 0.; // branches that are shorter are removed
};

} // namespace internal
} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_METHOD_METHOD_THRESHOLDS_H
