// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H

#include <array>
#include <cstdint>
#include <vector>

using Points_2 = std::vector<std::array<double, 2>>;
using Points_3 = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Makes a flat mesh as rigid as possible: the squared differences to the best rotation of each face, weighted by the
// cotangents of its angles, fall in each iteration [Liu, Zhang, Xu, Gotsman, Gortler: A local/global approach to mesh
// parameterization, 2008], until they fall by no more than `tolerance` of their sum. `points` are in space, `plane`
// holds the start and the result. Returns whether it has succeeded.
//
// CGAL's `ARAP_parameterizer_3` does the same, but starts from mean value coordinates in a circle. A disk with seams for
// a border is far from a circle: it ends with flipped faces and a border that crosses itself, which is an error there
// (`ERROR_NON_CONVEX_BORDER`). It also factors its matrix anew in each iteration.
bool flatten_as_rigidly_as_possible(const Points_3& points, const Triangles& triangles, Points_2& plane,
                                    double tolerance);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H
