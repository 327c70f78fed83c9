// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H

#include "Places.h"

#include <cstdint>
#include <vector>

// A surface cut open and laid out in the plane.
struct Atlas
{
  Places places;                        // of the vertices of the cut surface
  std::vector<std::uint32_t> triangles; // of vertices of the cut surface
  std::vector<std::uint32_t> faces;     // for each of them the face of the mesh that it is a part of
  std::vector<std::uint32_t> border;    // the ends of its border edges
  std::vector<float> uv;                // two coordinates for each vertex, in [-1, 1]
  // flipped faces, overlapping ones, the part of the sheets that they cover, the part of the area that is moved to other
  // faces, whether it is injective, the number of sheets
  std::vector<double> numbers;
};

// Injectively, of one source or the cells of several and of curves side by side, or by distances and directions from one
// source that is a point.
enum class Layout { INJECTIVE, CELLS, LOGARITHMIC };

// Cuts along a cut locus, and lays it flat. Faces through which the cut locus runs are split. Tells the page how far it is.
Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, Layout layout);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_ATLAS_H
