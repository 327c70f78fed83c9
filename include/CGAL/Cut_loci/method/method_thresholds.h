// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_METHOD_METHOD_THRESHOLDS_H
#define CGAL_CUT_LOCI_METHOD_METHOD_THRESHOLDS_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/method/Path_noise.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
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
