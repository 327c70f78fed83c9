// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H

#include "../../Mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

// A surface cut open and laid out in the plane.
struct Atlas
{
  std::vector<std::uint32_t> origin;    // for each vertex of the cut surface the one that it is a copy of
  std::vector<std::uint32_t> triangles; // of vertices of the cut surface
  std::vector<std::uint32_t> border;    // the ends of its border edges
  std::vector<float> uv;                // two coordinates for each vertex, in [-1, 1]
  std::vector<double> numbers;          // flipped faces, part of the area that is moved to other faces, is rigid
};

// Cuts along a cut locus of mesh edges, and flattens as rigidly as possible, or, where that fails or folds, by the
// polar coordinates of the shortest paths. `on_flatten` is called between the two.
Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, const std::function<void()>& on_flatten);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H
