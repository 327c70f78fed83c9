// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_LOCATION_IN_PART_H
#define CGAL_CUT_LOCI_SURFACE_LOCATION_IN_PART_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Barycentric coordinates of a point of a triangle, negative if it is outside; of one without area, those of the nearest
// point of its edges, and how far away that is, as a negative part of their length.
inline std::array<double, 3> coordinates_in(const std::array<Vector, 3>& corners, const Vector& point, double& least)
{
  std::array<double, 3> result;
  double longest = 0.;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Vector edge = corners[(i + 1) % 3] - corners[i];
    longest = (std::max)(longest, dot(edge, edge));
  }
  const Vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area = dot(normal, normal);
  if(area > 1e-24 * longest * longest)
  {
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = dot(cross(corners[(i + 1) % 3] - point, corners[(i + 2) % 3] - point), normal) / area;
    least = *std::min_element(result.begin(), result.end());
    return result;
  }
  least = -(std::numeric_limits<double>::infinity)();
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Vector edge = corners[(i + 1) % 3] - corners[i], to_point = point - corners[i];
    const double l = dot(edge, edge), s = l > 0. ? (std::min)((std::max)(dot(to_point, edge) / l, 0.), 1.) : 0.;
    const double away = norm(to_point - s * edge), here = longest > 0. ? -away / std::sqrt(longest) : -away;
    if(!(here > least))
      continue;
    least = here;
    result = {{0., 0., 0.}};
    result[i] = 1. - s;
    result[(i + 1) % 3] = s;
  }
  return result;
}

// The place of a point of a mesh on one of which each face is a part of that with the number `face_origin`: in the part
// that has it, or that it misses least by rounding.
inline Indexed_location location_in_part(const Indexed_triangle_mesh& mesh, const Indexed_triangle_mesh& refined,
                                         const std::vector<Index>& face_origin, const Indexed_location& x)
{
  Vector point = {{0., 0., 0.}};
  for(int i = 0; i < 3; ++i)
    point = point + x.coordinates[i] * mesh.points[mesh.triangles[x.face][i]];
  Indexed_location best;
  double best_least = -(std::numeric_limits<double>::infinity)();
  for(Index part = 0; part < face_origin.size(); ++part)
  {
    if(face_origin[part] != x.face)
      continue;
    const auto& t = refined.triangles[part];
    double least;
    std::array<double, 3> c =
      coordinates_in({{refined.points[t[0]], refined.points[t[1]], refined.points[t[2]]}}, point, least);
    if(!(least > best_least))
      continue;
    normalize(c);
    best_least = least;
    best.face = part;
    best.coordinates = c;
  }
  return best;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_LOCATION_IN_PART_H
