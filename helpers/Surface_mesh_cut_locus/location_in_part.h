// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_LOCATION_IN_PART_H
#define CGAL_CUT_LOCI_HELPERS_LOCATION_IN_PART_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace curve_measures {
namespace internal {

// The place of a point of a mesh on one of which each face is a part of that with the number `face_origin`: in the part
// that has it, or that it misses least by rounding.
inline CGAL::Cut_loci::Indexed_location location_in_part(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
                                                         const CGAL::Cut_loci::Indexed_triangle_mesh& refined,
                                                         const std::vector<CGAL::Cut_loci::Index>& face_origin,
                                                         const CGAL::Cut_loci::Indexed_location& x)
{
  using namespace CGAL::Cut_loci::internal;
  using CGAL::Cut_loci::Index;
  Vector point = {{0., 0., 0.}};
  for(int i = 0; i < 3; ++i)
    point = point + x.coordinates[i] * mesh.points[mesh.triangles[x.face][i]];
  CGAL::Cut_loci::Indexed_location best;
  double best_least = -(std::numeric_limits<double>::infinity)();
  for(Index part = 0; part < face_origin.size(); ++part)
  {
    if(face_origin[part] != x.face)
      continue;
    const auto& t = refined.triangles[part];
    const Vector &p = refined.points[t[0]], &q = refined.points[t[1]], &r = refined.points[t[2]];
    const Vector normal = cross(q - p, r - p);
    const double area = dot(normal, normal);
    std::array<double, 3> c = {{dot(cross(q - point, r - point), normal) / area,
                                dot(cross(r - point, p - point), normal) / area,
                                dot(cross(p - point, q - point), normal) / area}};
    const double least = *std::min_element(c.begin(), c.end());
    if(!(least > best_least))
      continue;
    double sum = 0.;
    for(double& y : c)
      sum += y = (std::max)(y, 0.);
    for(double& y : c)
      y /= sum;
    best_least = least;
    best.face = part;
    best.coordinates = c;
  }
  return best;
}

} // namespace internal
} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_LOCATION_IN_PART_H
