// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_POINT_ON_PATH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_POINT_ON_PATH_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>

namespace CGAL::Cut_loci::internal {

struct Point_on_path
{
  Vector point;
  double distance; // from the source
};

/// the point at this distance, between two of which the first is farther from the source
inline Vector point_between(const Point_on_path& a, const Point_on_path& b, double distance)
{
  const double length = a.distance - b.distance;
  const double s = length > 0. ? (std::min)((std::max)((a.distance - distance) / length, 0.), 1.) : 0.;
  return a.point + s * (b.point - a.point);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_POINT_ON_PATH_H
