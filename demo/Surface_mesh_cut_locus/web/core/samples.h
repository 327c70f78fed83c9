// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_SAMPLES_H
#define SURFACE_MESH_CUT_LOCUS_WEB_SAMPLES_H

#include "../../Mesh.h"

#include <string>

// A surface to try, of about `number_of_faces` faces. Throws `std::invalid_argument` if there is none of this name.
Mesh make_sample(const std::string& name, double number_of_faces);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_SAMPLES_H
