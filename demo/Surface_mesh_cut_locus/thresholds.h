// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_THRESHOLDS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_THRESHOLDS_H

#include "Input_mesh.h"
#include "Options.h"
#include "solvers.h"

#include <CGAL/Cut_loci/cut_locus_method.h>

#include <cstddef>

// The vertex of the mesh with a number of the file. Throws `Usage_error` where `origin` says where the number comes from.
Mesh::Vertex_index find_vertex(std::size_t number, const Input_mesh& input, const std::string& origin = "--source");

// The options with the defaults of the library for the source of `solver`. What they are is not passed to it.
Options fill_in_defaults(Options options, const Cut_locus_solver& solver);

Cut_locus apply_thresholds(const Options& options, const Cut_locus_solver& solver);

// That of several sources, by the curve of all outputs.
Cut_locus voronoi_diagram(const Options& options, const Cut_locus_solver& solver);

// The curve that all outputs are about: that of the library for these options.
CGAL::Cut_loci::Curve curve_of(const Options& options);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_THRESHOLDS_H
