// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_WELD_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_WELD_H

#include "Input_mesh.h"

#include <cstddef>
#include <vector>

// Which vertices of a file are the same one: files repeat them for each face, at hard edges and along the seams of textures.
struct Weld
{
  std::vector<std::size_t> first;  // for each vertex the least one that is the same
  std::size_t merged_vertices = 0; // those that are not the least
  std::size_t open_edges = 0;      // border edges that lie on others, and stay apart
};

// Joins border edges that lie on each other, two by two, up to 1e-7 of the diagonal of the bounding box. Where more than
// two are at one place, or the faces of the two lie on each other as the sides of a sheet do, or their surface would not be
// orientable, nothing tells what belongs together: these stay apart, as what touches in a vertex does.
Weld weld(const Polygon_soup& soup);

// A power of two: the coordinates are as exact afterwards, and their products do not leave the range of numbers.
double scale_to_unit(const std::vector<Kernel::Point_3>& points);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_WELD_H
