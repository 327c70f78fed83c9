// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SET_SOURCE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SET_SOURCE_H

#include "Input_mesh.h"
#include "Options.h"
#include "solvers.h"

#include <string>
#include <vector>

// Sets the sources that are asked for, or, if there are none, the first vertex of the largest component.
// Returns those that are curves. Throws `Usage_error` if there is no such vertex or edge.
std::vector<std::vector<Mesh::Edge_index>> set_source(const Options& options, const Input_mesh& input,
                                                      Cut_locus_solver& solver);

// A line for each point that is farther from the surface than an edge is long, on average.
std::string moved_source_points(const Options& options, const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SET_SOURCE_H
