// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_INPUT_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_INPUT_H

#include "../../demo/Surface_mesh_cut_locus/Mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

// Vertices and faces as they were given: the indices are in the range of the vertices.
struct Arrays
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

// Vertex and face of the mesh have the indices of the arrays, and barycentric coordinates their order: halfedge(f) starts
// at the first vertex of the face. Throws Invalid_input if they are not those of a mesh.
std::shared_ptr<const Mesh> make_mesh(const Arrays& arrays);

// Python holds this, as it has no const objects.
struct Mesh_handle
{
  std::shared_ptr<const Mesh> mesh;
};

// What the program makes of a file: border edges that lie on each other are joined, faces turned so that neighbors agree.
// `vertex` has the new number of each vertex, or -1 if no face has it. Throws Invalid_input if there is no surface.
struct Welded
{
  Arrays arrays;
  std::vector<std::int64_t> vertex;
};
Welded weld(const Arrays& arrays);

// How many vertices on borders lie at the places of others that `weld()` would join them with.
std::size_t number_of_weldable_vertices(const Mesh& mesh);

// A vertex, or a face and barycentric coordinates, by numbers that may be wrong.
using Source_numbers = std::variant<std::int64_t, std::pair<std::int64_t, std::array<double, 3>>>;
using Source = std::variant<Mesh::Vertex_index, Location>;

// Throws Invalid_input if there is no such vertex or face.
std::vector<Source> read_sources(const Mesh& mesh, const std::vector<Source_numbers>& numbers);

// Curves along edges of the mesh, each by the pairs of vertices that its edges join.
using Curve_numbers = std::vector<std::array<std::int64_t, 2>>;
using Source_curve = std::vector<Mesh::Edge_index>;

// Throws Invalid_input if there is no such edge.
std::vector<Source_curve> read_curves(const Mesh& mesh, const std::vector<Curve_numbers>& numbers);

// The length of each edge of the mesh, by its index. Those of a face, of which the argument has three, are in the order of
// its edges, from that between its first two vertices on. Throws Invalid_input if two faces do not agree.
std::vector<double> lengths_of_edges(const Mesh& mesh, const std::vector<double>& of_faces);

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_INPUT_H
