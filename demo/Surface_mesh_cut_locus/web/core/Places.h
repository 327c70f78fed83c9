// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_PLACES_H
#define SURFACE_MESH_CUT_LOCUS_WEB_PLACES_H

#include "../../Mesh.h"

#include <cstdint>
#include <vector>

// Where the vertices of a surface are whose faces are parts of those of a mesh: for each, three vertices of a face of the
// mesh, and their weights. A copy of a vertex of the mesh gives all the weight to the first one.
struct Places
{
  void append_vertex(Mesh::Vertex_index v);
  void append_point(const Mesh& mesh, Mesh::Face_index face, const Kernel::Point_3& point);

  std::vector<std::uint32_t> parents;
  std::vector<float> weights;
};

#endif // SURFACE_MESH_CUT_LOCUS_WEB_PLACES_H
