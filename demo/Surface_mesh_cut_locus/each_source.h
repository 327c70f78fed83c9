// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_EACH_SOURCE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_EACH_SOURCE_H

#include "Input_mesh.h"
#include "Options.h"
#include "Progress.h"
#include "solvers.h"

// Computes a cut locus for each source of a file, or for one part of them, and writes a line of JSON for each. Returns
// whether all of them were found; one that was not has the cause in its line.
bool compute_each_source(const Options& options, const Input_mesh& input, Cut_locus_solver& solver, Progress& progress);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_EACH_SOURCE_H
