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

// Sets the sources that are asked for, or, if there are none, the first vertex of the largest component, or the nearest one
// in the direction given.
// Returns those that are curves. Throws `Usage_error` if there is no such vertex or edge.
std::vector<std::vector<Mesh::Edge_index>> set_source(const Options& options, const Input_mesh& input,
                                                      Cut_locus_solver& solver);

// The options for each component that has an area, with the sources in it: the first one is that of the first source. A
// component without a source gets the vertex that is farthest from its center, or that is nearest in the direction given.
std::vector<Options> options_of_components(const Options& options, const Input_mesh& input);

// A line for each point that is farther from the surface than an edge is long, on average.
std::string moved_source_points(const Options& options, const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SET_SOURCE_H
