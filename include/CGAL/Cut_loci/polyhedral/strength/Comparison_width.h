// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_COMPARISON_WIDTH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_COMPARISON_WIDTH_H

#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Cut_loci::internal {

/*!
 * tells from edge lengths alone how far two shortest paths to the same point get apart.
 *
 * Two paths that part at an angle get no farther apart, at the distance d from there, than 2 d sin(angle / 2), where the
 * curvature is not negative (Toponogov); the same holds back from where they meet. The width is where both are the same.
 * If all that the paths enclose is one vertex, the two are attained there; if it is a half of a sphere, they are too large
 * by a factor of pi / 2. Where the curvature is negative, paths may get farther apart.
 */
class Comparison_width
{
public:
  explicit Comparison_width(const Geodesic_results& geodesics) : geodesics_(geodesics) {}

  /// the two paths lead from the images to the point `p` of face `f`; all in the frame of its first halfedge
  double operator()(Index f, const Plane_point& p, const Image& a, const Image& b) const
  {
    const Geodesic_faces& faces = geodesics_.faces();
    const Face_corners corners = corners_of(faces, f);
    const Parting_angle::Parting where = parting(geodesics_, a, b, p, corners);
    const double length = a.distance(p) - where.distance;
    const double first = chord(where.angle);
    const double last = chord(meeting_angle(a, b, p));
    return first + last > 0. ? length * first * last / (first + last) : 0.;
  }

private:
  // of a circle of radius 1
  static double chord(double angle) { return 2. * std::sin(0.5 * (std::min)(angle, geodesic_pi)); }

  const Geodesic_results& geodesics_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_COMPARISON_WIDTH_H
