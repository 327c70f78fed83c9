// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H

#include "charts.h"

#include <string>

// Lays a disk flat. Throws `std::runtime_error` if it can not be flattened. Not for "logmap".
void flatten(Chart& chart, const std::string& parameterization);

// The same for the chart of a source, which "logmap" needs.
void flatten(const Mesh& mesh, const Cut_locus& cut_locus, Chart& chart, const std::string& parameterization);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H
