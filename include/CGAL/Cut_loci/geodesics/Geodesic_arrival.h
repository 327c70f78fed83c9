// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_ARRIVAL_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_ARRIVAL_H

#include <CGAL/Cut_loci/Index.h>

namespace CGAL::Cut_loci::internal {

/// is the end of a shortest path: its last straight piece, in the frame of a halfedge of the face in which it ends.
struct Geodesic_arrival
{
  double x = 0., y = 0.;         // the image of the (pseudo-)source
  double sigma = 0., turn = 0.;  // as in `Geodesic_window`
  Index halfedge = null_index;   // of the frame
  Index origin = null_index;     // as in `Geodesic_window`
  bool crosses_halfedge = false; // else the image lies in the face itself
  double rate = 1., error = 0.;  // as in `Geodesic_window`
};

/// is the direction of a shortest path at its end: an angle from a halfedge that leaves the end, counterclockwise.
struct Geodesic_arrival_direction
{
  Index halfedge;
  double angle;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_ARRIVAL_H
