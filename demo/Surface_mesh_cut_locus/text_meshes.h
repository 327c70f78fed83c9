// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_TEXT_MESHES_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_TEXT_MESHES_H

#include "Input_mesh.h"

#include <string>

// Read files as most programs write them, in about a tenth of the time that streams take, and to the same bits: one
// vertex or face in a line, and no more but what CGAL's readers skip. They return false, and leave it to these readers
// wherever anything is otherwise: so what is allowed, and what is said of a damaged file, does not depend on them.

// @param text a file whose vertices have three coordinates and no attributes
bool read_plain_OFF(const std::string& text, Polygon_soup& soup);
bool read_plain_OBJ(const std::string& text, Polygon_soup& soup);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_TEXT_MESHES_H
