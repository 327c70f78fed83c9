// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_H

#include "Input_mesh.h"
#include "cells.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

bool is_output_name(const std::string& filename);
std::string output_extensions();   // " .a .b"
std::string output_descriptions(); // a line for each
bool is_picture_name(const std::string& filename);

// Writes a cut locus to each file, in the format of its extension. Pictures look from the direction of `view`, or from
// two sides if there is none, and show sources that are curves, and the cells of several sources, if they are given, in
// colors. Edges that are none of the file are marked. Throws `std::runtime_error` if a file can not be written.
void write_outputs(const std::vector<std::string>& filenames, const Cut_locus& cut_locus, const Input_mesh& input,
                   const std::vector<std::vector<Mesh::Edge_index>>& source_curves, const std::optional<Cells>& cells,
                   const std::optional<std::array<double, 3>>& view);
void write_edges(const std::string& filename, const Cut_locus& cut_locus, const Input_mesh& input);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_H
