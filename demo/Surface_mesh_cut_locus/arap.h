// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H

#include <array>
#include <cstddef>
#include <vector>

// Makes a flat mesh as rigid as possible: the squared differences to the best rotation of each face, weighted by the
// cotangents of its angles, fall in each iteration [Liu, Zhang, Xu, Gotsman, Gortler: A local/global approach to mesh
// parameterization, 2008]. `points` are in space, `plane` holds the start and the result. Returns whether it has
// succeeded.
bool flatten_as_rigidly_as_possible(const std::vector<std::array<double, 3> >& points,
                                    const std::vector<std::array<std::size_t, 3> >& faces,
                                    std::vector<std::array<double, 2> >& plane);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_ARAP_H
