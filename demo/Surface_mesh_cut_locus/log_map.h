// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H

#include "Input_mesh.h"
#include "Options.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Where each vertex is as seen from its nearest source: the distance times the direction in which the shortest path leaves,
// in the plane of the source. The x-axis is the halfedge of the source: of a vertex that of the first face that has it, or on
// the border the one with no face on its right, on an edge that edge, in a face its first one. The y-axis is to the left
// of it. Around a source that is not on the border, angles are scaled so that they add up to 2 pi.
struct Log_map
{
  std::vector<std::size_t> source;          // nearest to each vertex of the mesh that is not isolated, and
  std::vector<std::array<double, 2>> place; // zero where no path leads
};

// Why there is none, or nothing: paths from curves start at no point, and only exact distances come with paths.
std::string cause_of_no_log_map(const Options& options);

// By one more propagation from the sources, which keeps directions.
Log_map log_map(const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_LOG_MAP_H
