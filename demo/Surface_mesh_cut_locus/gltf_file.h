// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_GLTF_FILE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_GLTF_FILE_H

#include "atlas.h"

#include <iosfwd>
#include <string>

// glTF 2.0 in one binary file: the triangles of all charts with a texture, a PNG file, and the normals of the mesh's file, if it has
// any and no face is split.
void write_glb(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const File_content& content,
               const std::string& texture);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_GLTF_FILE_H
