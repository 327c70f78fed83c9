// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_UNFOLDING_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_UNFOLDING_H

#include "Mesh.h"

#include <CGAL/Cut_loci/source_unfolding.h>

#include <string>

using Unfolding = CGAL::Cut_loci::Source_unfolding<Mesh, Kernel::Point_3>;

// Writes a net, by the extension: to print (.svg), or as a flat mesh with fold lines (.obj). Throws `std::runtime_error`
// if it can not be written.
void write_unfolding(const std::string& filename, const Unfolding& unfolding);

std::string summary(const Unfolding& unfolding);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_UNFOLDING_H
