// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAYOUT_QUALITY_H
#define CGAL_CUT_LOCI_LAYOUT_QUALITY_H

#include <cstddef>

namespace CGAL::Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * tells how good a disk in the plane is: whether it is injective, and how much it distorts.
 *
 * Means are over the area of the surface, once the disk in the plane is scaled to this area. Faces thinner than a
 * ten-thousandth of their longest edge count as if they were as thick as that.
 */
struct Layout_quality
{
  /// the faces that are upside down in the plane, or have no area there; exact for the coordinates
  std::size_t flipped_faces = 0;
  /// whether no face is flipped, and no two faces overlap; exact for the coordinates
  bool is_injective = false;
  /// the faces that have others over or under them; exact for the coordinates
  std::size_t overlapping_faces = 0;
  /// the part of the covered points of a grid of 1024 x 1024 that several faces cover
  double overlap = 0.;
  /// the mean of (s + 1/s) / 2, where s is the ratio of the areas of a face in the plane and in space; least is 1
  double area_distortion = 0.;
  /// the same for the ratio of the largest and the least stretch; infinite if a face has no area in the plane
  double angle_distortion = 0.;
  /// the mean of (s^2 + t^2 + 1/s^2 + 1/t^2) / 4, where s and t are the largest and the least stretch; least is 1, and it
  /// is infinite if a face is flipped
  double symmetric_dirichlet_energy = 0.;
  /// the faces of the surface that are too thin to say how they should lie
  std::size_t faces_without_shape = 0;
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_LAYOUT_QUALITY_H
