// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_SNAPPING_OF_CURVES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_SNAPPING_OF_CURVES_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/Invalid_input.h>

#include <cmath>

namespace CGAL::Cut_loci::internal {

// The accuracy of a curve through the faces is some hundredths of an edge: a grid of 256 moves it by less.
constexpr double default_snapping_of_curves = 1. / 256.;

inline Index resolution_of(double tolerance)
{
  constexpr double least = 1. / (1 << 20); // the square of its reciprocal is far below what rounding errors spoil
  if(!(tolerance >= least && tolerance <= 0.5))
    throw Invalid_input(Cause::INVALID_PARAMETER, "the snapping tolerance must be from 2^-20 to 0.5");
  return static_cast<Index>(std::lround(1. / tolerance));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_SNAPPING_OF_CURVES_H
