// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_OBJ_FILE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_OBJ_FILE_H

#include "atlas.h"

#include <iosfwd>

// The polygons of the file, or, if faces are split, triangles; with texture coordinates.
void write_plain_obj(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup);

// The text of the OBJ file that was read, with other texture coordinates: all else is that of the file.
void write_kept_obj(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const File_content& content);

// Those of a file.
Corner_normals normals_of_file(const File_content& content);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_OBJ_FILE_H
