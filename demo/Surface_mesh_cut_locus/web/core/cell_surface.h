// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_CELL_SURFACE_H
#define SURFACE_MESH_CUT_LOCUS_WEB_CELL_SURFACE_H

#include "Places.h"

#include <cstdint>
#include <vector>

// A surface divided into the cells of its sources exactly where the curve between them runs: faces that it crosses are
// split, and cells share no vertices, so each vertex has one source.
struct Cell_surface
{
  static constexpr std::uint32_t none = 0xffffffff; // where no path leads from a source

  Places places;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> source; // of each vertex
};

Cell_surface make_cell_surface(const Mesh& mesh, const Cut_locus& between_sources);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_CELL_SURFACE_H
