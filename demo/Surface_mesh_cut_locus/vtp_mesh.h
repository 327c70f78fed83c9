// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_VTP_MESH_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_VTP_MESH_H

#include "Input_mesh.h"
#include "file_checks.h"

// Points and polygons of a file of VTK whose arrays are text, as the program writes it. Throws `std::runtime_error` with the
// cause if it is another one, or damaged.
Polygon_soup read_VTP(const Mesh_file& file);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_VTP_MESH_H
