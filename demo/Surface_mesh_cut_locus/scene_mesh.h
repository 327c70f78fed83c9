// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_MESH_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_MESH_H

#include "Input_mesh.h"
#include "file_checks.h"

// All meshes of a scene, where its nodes place them. It takes libassimp. Throws `std::runtime_error` with the cause if the
// program is built without it, if the file is damaged, or if it has no mesh.
Polygon_soup read_scene(const Mesh_file& file);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_MESH_H
