// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_ARRAYS_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_ARRAYS_H

#include "Input.h"

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Reads the arrays of a mesh, of any memory layout, without a converted copy of them if their type is a usual one.
// Throws TypeError for arrays of another kind than numbers, or indices, and Invalid_input for what can not be a mesh.
Arrays read_arrays(const pybind11::array& vertices, const pybind11::array& faces);

// One number for each vertex.
std::vector<double> read_vertex_values(const pybind11::array& values, std::size_t number_of_vertices);

// Three lengths for each face.
std::vector<double> read_face_lengths(const pybind11::array& values, std::size_t number_of_faces);

// Any number of rows of some columns; `name` is for messages.
std::vector<double> read_rows(const pybind11::array& values, pybind11::ssize_t columns, const std::string& name);

// An array of the given shape on the memory of `values`, which is not copied. It can not be written to.
template <typename T>
pybind11::array_t<T> to_array(std::vector<T> values, std::vector<pybind11::ssize_t> shape)
{
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = owned->data();
  const pybind11::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  pybind11::array_t<T> result(std::move(shape), data, owner);
  result.attr("setflags")(pybind11::arg("write") = false);
  return result;
}

template <typename T>
pybind11::array_t<T> to_array(std::vector<T> values)
{
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return to_array(std::move(values), {size});
}

template <typename T>
pybind11::array_t<T> to_array(std::vector<T> values, pybind11::ssize_t columns)
{
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return to_array(std::move(values), {size / columns, columns});
}

// Appends the points of all vertices, and the vertices of all faces.
void append_mesh(const Mesh& mesh, std::vector<double>& points, std::vector<std::int64_t>& corners);

// -1 for the null vertex
std::int64_t index_or_none(Mesh::Vertex_index v);

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_ARRAYS_H
