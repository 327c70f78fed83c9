// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_INPUT_MESH_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_INPUT_MESH_H

#include "Mesh.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// What a file has: vertices, and faces as their numbers.
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals; // at the points, if a scene has them
  std::vector<std::vector<std::size_t>> polygons;
};

// What outputs take from a file that they keep as it is.
struct File_content
{
  Polygon_soup soup;
  std::string obj; // the text of an OBJ file
};

// What has been done to a soup to make a mesh of triangles of it.
struct Repairs
{
  std::size_t merged_vertices = 0;     // at the place of another one, both on a border
  std::size_t removed_faces = 0;       // twice in the file, or of less than three vertices
  std::size_t reversed_faces = 0;      // so that neighbors agree
  std::size_t duplicated_vertices = 0; // where the surface is not manifold
  std::size_t triangulated_faces = 0;
  std::size_t unused_vertices = 0; // dropped
  std::size_t open_edges = 0;      // of the border, left though they lie on each other

  bool is_empty() const;
};

// "3 faces triangulated, 1 ...", or nothing
std::string description(const Repairs& repairs);

// What may be done: nothing; all but to join border edges that lie on each other; all.
enum class Repair { NONE, ORIENT, WELD };

// A mesh of triangles and the way back to the file. It is moved only: a copy would have the numbers of the other mesh.
struct Input_mesh
{
  Input_mesh() = default;
  Input_mesh(Input_mesh&&) = default;
  Input_mesh& operator=(Input_mesh&&) = default;

  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, std::size_t> number =
    mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:number", 0).first; // in the file
  std::vector<Mesh::Vertex_index> vertex; // one for each number, or null if there is none left
  std::vector<std::size_t> polygon;       // of the file, of which each face is a part
  std::vector<bool> is_added;             // for each edge of the mesh: whether it is none of the file, as a diagonal is
  std::vector<std::size_t> component;     // of each face, connected by edges
  std::vector<std::size_t> component_size; // number of faces
  std::vector<double> component_area;
  std::size_t largest_component = 0; // by area
  Repairs repairs;
};

// whether an edge of the curve follows one of the mesh that is none of the file
bool is_added(const Cut_locus::Edge& edge, const Input_mesh& input);

std::size_t component_of_source(const Input_mesh& input, const Cut_locus& cut_locus);

struct Needs_repair : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// `format` is empty, or one of `input_formats()` without its dot; `content` may be null. Throws `Needs_repair` if it is not
// allowed, or `std::runtime_error` with the cause if the file has no surface.
Input_mesh read_mesh(const std::string& filename, Repair repair, const std::string& format = "",
                     File_content* content = nullptr);

// A mesh of the file as it is. `name` is for messages.
Input_mesh make_mesh(const Polygon_soup& soup, Repair repair, const std::string& name);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_INPUT_MESH_H
