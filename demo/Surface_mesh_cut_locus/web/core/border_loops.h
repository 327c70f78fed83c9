// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_BORDER_LOOPS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_BORDER_LOOPS_H

#include "../../Mesh.h"

#include <cstdint>
#include <vector>

using Edge_curve = std::vector<Mesh::Edge_index>;

// The border of one component of a mesh, a curve for each loop: that of a face, or, if it is null, the one with the most
// faces among those that have a border. The components of the faces may be left out if there is one. Throws if there is
// no border.
std::vector<Edge_curve> border_loops(const Mesh& mesh, const std::vector<std::uint32_t>& component_of_face,
                                     Mesh::Face_index face);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_BORDER_LOOPS_H
