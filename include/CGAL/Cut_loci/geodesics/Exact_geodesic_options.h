// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_OPTIONS_H
#define CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_OPTIONS_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is an edge on the border all of whose points are sources, and the number of the set of sources that it belongs to.
struct Geodesic_line
{
  Index halfedge, owner;
};

/// is what is known of a `Geodesic_window` where it crosses the face of its halfedge.
struct Crossing_window
{
  Index halfedge;
  bool is_parallel;
  double a, b, x, y, sigma;

  double distance(double t) const
  {
    return sigma + (is_parallel ? Geodesic_window::parallel_way(x, y, t, 0.) : std::hypot(x - t, y));
  }
};

/// says what a run of `Exact_geodesic_propagation` computes.
struct Exact_geodesic_options
{
  double maximum_distance = (std::numeric_limits<double>::infinity)(); ///< nothing beyond it is reached
  bool directions = false;                                             ///< whether directions at the source are wanted
  double maximum_relative_error = 0.;                                  ///< by which distances may be wrong
  double merging_angle = 0.; ///< with such an error: by which directions may change where windows are merged
  std::vector<Indexed_location> queries; ///< further points whose distance is wanted
  std::vector<Geodesic_line> lines;      ///< sources that are edges; with directions, and without an error
  std::vector<Index> owners;             ///< of the sources that are points, see `Geodesic_line`; empty: its own number
  /// whether the waves of lines are parallel, or those of images far behind them, see `Geodesic_sources`
  bool parallel_waves = false;
  std::vector<Crossing_window>* windows = nullptr; ///< gets all windows that cross faces, if it is there
  Progress progress; ///< is told, every few milliseconds, the share of the vertices that are reached
};

/// for distances alone, from sources that are edges
inline void set_lines(const std::vector<Geodesic_line>& lines, Exact_geodesic_options& options)
{
  options.lines = lines;
  options.directions = true;
  options.parallel_waves = true;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_OPTIONS_H
