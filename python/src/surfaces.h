// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_SURFACES_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_SURFACES_H

#include <pybind11/pybind11.h>

// Functions that take a surface and need no cut locus: disks in the plane, unfoldings, and refinement along polylines.
void bind_surfaces(pybind11::module_& m);

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_SURFACES_H
