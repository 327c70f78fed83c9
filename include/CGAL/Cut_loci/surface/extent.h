// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_EXTENT_H
#define CGAL_CUT_LOCI_SURFACE_EXTENT_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

// The size of a surface, in which widths and lengths of branches are given: the diagonal of the bounding box or, of
// lengths alone, the square root of the area, which on a sphere is nearly the same.
inline double extent(const Indexed_triangle_mesh& mesh)
{
  if(mesh.is_intrinsic)
  {
    double area = 0.;
    for(std::size_t h = 0; h < mesh.lengths.size(); h += 3)
    {
      const std::array<double, 3> length = {{mesh.lengths[h], mesh.lengths[h + 1], mesh.lengths[h + 2]}};
      area += 0.5 * Triangle_shape(length).twice_area;
    }
    return std::sqrt(area);
  }
  std::array<double, 3> low = mesh.points.front(), high = low;
  for(const auto& p : mesh.points)
    for(std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  return norm(high - low);
}

// About how far points of a surface are apart, whatever its position: of a rod its length, of a cube the 2.24 edges between
// opposite corners, of a sphere 1.1 times the way from pole to pole. It is the diagonal of the bounding box of the
// ellipsoid that has the same second moment. Of lengths alone, the extent.
inline double spread(const Indexed_triangle_mesh& mesh, double extent)
{
  if(mesh.is_intrinsic)
    return extent;
  double area = 0., second = 0.;
  Vector first = {{0., 0., 0.}};
  const auto corner = [&](Index v) { return (1. / extent) * (mesh.points[v] - mesh.points.front()); };
  for(const auto& t : mesh.triangles)
  {
    const Vector a = corner(t[0]), b = corner(t[1]), c = corner(t[2]), sum = a + b + c;
    const double weight = norm(cross(b - a, c - a));
    area += weight;
    first = first + (weight / 3.) * sum;
    second += weight / 12. * (dot(a, a) + dot(b, b) + dot(c, c) + dot(sum, sum));
  }
  return extent * std::sqrt((std::max)(0., 12. * (second / area - dot(first, first) / (area * area))));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_EXTENT_H
