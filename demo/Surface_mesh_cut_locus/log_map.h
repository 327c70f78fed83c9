// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H

#include "Input_mesh.h"
#include "Options.h"

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <memory>
#include <string>

using Log_map = CGAL::Surface_mesh_exact_geodesics<Mesh>;

// Why there is none, or nothing: paths from curves start at no point, and only exact distances come with paths.
std::string cause_of_no_log_map(const Options& options);

// By one more propagation from the sources, which keeps directions. Paths to points with several shortest ones may come from
// another source than that of the cut locus.
std::unique_ptr<Log_map> log_map(const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H
