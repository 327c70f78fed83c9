// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_FLATTEN_H
#define SURFACE_MESH_CUT_LOCUS_WEB_FLATTEN_H

#include <array>
#include <cstdint>
#include <vector>

using Points_2 = std::vector<std::array<double, 2>>;
using Points_3 = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Lays a disk out in the plane as rigidly as possible, from a first layout `plane`, by the local/global iteration of
// Liu, Zhang, Xu, Gotsman and Gortler, "A Local/Global Approach to Mesh Parameterization" (2008). False if the linear
// system cannot be solved.
//
// CGAL's ARAP parameterizer does the same, but starts from mean value coordinates, whose iterative solver does not
// converge on large disks with a border as long as a cut locus, and factors its matrix anew for each right hand side.
bool flatten_as_rigidly_as_possible(const Points_3& points, const Triangles& triangles, Points_2& plane);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_FLATTEN_H
