// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H
#define CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H

#include <CGAL/Cut_loci/Index.h>

namespace CGAL::Cut_loci {

// tells how a way arrives at a vertex: through which face, from which direction, and how far its last straight piece
// goes back.
struct Way_arrival
{
  Index halfedge = null_index; ///< leaves the vertex, in the face through which the way comes; null if there is none
  double angle = 0.;           ///< from there counterclockwise to the way
  double straight = 0.;        ///< length of the last straight piece
  double length = 0.;          ///< of the whole way
  double error = 0.;           ///< by which the way is longer or shorter than given
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_WAYS_WAY_ARRIVAL_H
