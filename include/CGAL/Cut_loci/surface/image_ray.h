// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_IMAGE_RAY_H
#define CGAL_CUT_LOCI_SURFACE_IMAGE_RAY_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <cmath>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The shortest path to the third corner of a face, by the distances of the two others.
struct Image_ray
{
  double place;    // where it crosses the edge between these, from the source of its halfedge on, as a part
  double distance; // of the third corner
};

// In the plane of the face, the distances `a` and `b` of the ends of `h` give an image of the source beyond it. False
// if that does not see the third corner through the edge.
inline bool image_ray(const Indexed_triangle_mesh& mesh, Index h, double a, double b, Image_ray& result)
{
  const double length = edge_length(mesh, h), x = (length * length + a * a - b * b) / (2. * length);
  const double y2 = a * a - x * x;
  if(!(y2 > 0.))
    return false;
  const double y = std::sqrt(y2);
  const Planar_vector top = apex(mesh, h);
  result.place = (x * top[1] + top[0] * y) / ((top[1] + y) * length);
  result.distance = std::hypot(top[0] - x, top[1] + y);
  return result.place > 0. && result.place < 1.;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_IMAGE_RAY_H
