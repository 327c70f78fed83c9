// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H

#include "Mesh.h"

#include <string>

// A surface cut open along its cut locus, and laid flat. It is not copied: the maps refer to the mesh.
struct Flat_disk
{
  using Origin_map = Mesh::Property_map<Mesh::Vertex_index, Mesh::Vertex_index>;
  using Face_origin_map = Mesh::Property_map<Mesh::Face_index, Mesh::Face_index>;
  using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

  Flat_disk();
  Flat_disk(const Flat_disk&) = delete;
  Flat_disk& operator=(const Flat_disk&) = delete;

  Mesh mesh;
  Origin_map origin;           // the vertex of the surface, or `null_vertex()` if it was added
  Face_origin_map face_origin; // the face that it is a part of
  UV_map uv;
};

// Along the edges of the cut locus, or straight through the faces, as it runs. `disk` must be empty; `uv` stays at zero.
void cut_open(const Mesh& mesh, const Cut_locus& cut_locus, Flat_disk& disk);

// Throws `std::runtime_error` if the surface can not be flattened. Not for "logmap".
void flatten(Mesh& disk, Flat_disk::UV_map uv, const std::string& parameterization);

// The same for the disk that `cut_open()` gives, whose source is known.
void flatten(const Mesh& mesh, const Cut_locus& cut_locus, Flat_disk& disk, const std::string& parameterization);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_FLATTEN_H
