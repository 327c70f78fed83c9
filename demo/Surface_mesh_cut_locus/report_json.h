// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_JSON_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_JSON_H

#include "Input_mesh.h"
#include "Mesh.h"
#include "Options.h"

#include <CGAL/Cut_loci/cut_locus_method.h>

#include <nlohmann/json.hpp>

#include <string>

// What the reports on one source and on many have in common.
using Json = nlohmann::ordered_json;

// the vertex, with its number in the file, and the point
void add_farthest(Json& report, const Input_mesh& input, const Cut_locus& cut_locus);
void add_method(Json& report, const Options& options, CGAL::Cut_loci::Curve curve);
void add_parameters(Json& parameters, const Options& options); // null: there is none

// Throws `std::runtime_error` if the file can not be written.
void write_json(const std::string& filename, const Json& json);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_JSON_H
