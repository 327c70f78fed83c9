// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_CHECKED_MESH_H
#define CGAL_CUT_LOCI_SURFACE_CHECKED_MESH_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Cut_loci::internal {

// thrown with the component's index, for the caller to name the element of the input
struct Face_without_area
{
  Index face;
};
struct Non_manifold_vertex
{
  Index vertex;
};

// Faces without area have no tangent plane. Coordinates of the size of a face resolve 2^-53 of it: at 100 times that,
// the direction of its normal is noise.
inline const Indexed_triangle_mesh& checked_mesh(const Indexed_triangle_mesh& mesh,
                                                 const Mesh_connectivity& connectivity, const Progress& progress = {})
{
  if(!connectivity.first_non_manifold.empty())
    throw Non_manifold_vertex{connectivity.first_non_manifold.front()};
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    progress(f, mesh.number_of_faces());
    if(!mesh.lengths.empty())
      continue; // who gave them has seen to it
    const Vector &p = mesh.points[mesh.triangles[f][0]], &q = mesh.points[mesh.triangles[f][1]],
                 &r = mesh.points[mesh.triangles[f][2]];
    const Vector a = q - p, b = r - p, c = r - q;
    const double longest = (std::max)({dot(a, a), dot(b, b), dot(c, c)});
    const double twice_area = norm(cross(a, b));
    if(!(twice_area > 1e-14 * longest) || !std::isfinite(twice_area))
      throw Face_without_area{f};
  }
  return mesh;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_CHECKED_MESH_H
