// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "arrays.h"

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/Invalid_input.h>

#include <cstdint>
#include <limits>
#include <string>

namespace py = pybind11;
using CGAL::Cut_loci::Cause;
using CGAL::Cut_loci::Invalid_input;

namespace {

std::string shape_of(const py::array& array)
{
  std::string result = "(";
  for(py::ssize_t i = 0; i < array.ndim(); ++i)
    result += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return result + (array.ndim() == 1 ? ",)" : ")");
}

void check_rows_of_three(const py::array& array, const char* name)
{
  if(array.ndim() == 2 && array.shape(1) > 3 && std::string(name) == "the faces")
    throw Invalid_input(Cause::NO_TRIANGLE,
                        "the faces have the shape " + shape_of(array) +
                          ": all must be triangles. F = np.concatenate([F[:, [0, k, k + 1]] for k in range(1, " +
                          std::to_string(array.shape(1) - 1) +
                          ")]) divides faces that are convex; where rows begin with "
                          "the number 3 of their vertices, as in VTK's arrays, F[:, 1:] leaves it out");
  if(array.ndim() != 2 || array.shape(1) != 3)
    throw Invalid_input(Cause::NO_TRIANGLE,
                        std::string(name) + " must be an array of the shape (n, 3), and not " + shape_of(array));
}

std::string type_of(const py::array& array)
{
  return py::str(static_cast<py::object>(array.dtype()));
}

// Of the type, also in the order of its bytes, and where the processor can read it.
template <typename T>
bool is_readable_as(const py::array& array)
{
  return py::isinstance<py::array_t<T>>(array) && array.attr("flags").attr("aligned").cast<bool>();
}

template <typename T>
std::vector<Kernel::Point_3> read_points(const py::array& array)
{
  const auto p = py::reinterpret_borrow<py::array_t<T>>(array).template unchecked<2>();
  std::vector<Kernel::Point_3> result;
  result.reserve(static_cast<std::size_t>(p.shape(0)));
  for(py::ssize_t i = 0; i < p.shape(0); ++i)
    result.emplace_back(double(p(i, 0)), double(p(i, 1)), double(p(i, 2)));
  return result;
}

template <typename T>
std::vector<std::array<std::uint32_t, 3>> read_faces(const py::array& array, std::size_t number_of_vertices)
{
  const auto f = py::reinterpret_borrow<py::array_t<T>>(array).template unchecked<2>();
  std::vector<std::array<std::uint32_t, 3>> result(static_cast<std::size_t>(f.shape(0)));
  for(py::ssize_t i = 0; i < f.shape(0); ++i)
    for(py::ssize_t k = 0; k < 3; ++k)
    {
      const T v = f(i, k);
      if(static_cast<std::uint64_t>(v) >= number_of_vertices) // or negative
        throw Invalid_input(Cause::NO_TRIANGLE, "face #" + std::to_string(i) + " has the vertex #" + std::to_string(v) +
                                                  ": the mesh has " + std::to_string(number_of_vertices) + " vertices");
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(v);
    }
  return result;
}

std::vector<double> read_numbers(const py::array& values, const std::string& name)
{
  const char kind = values.dtype().kind();
  if(kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error("the " + name + " must be real numbers, and not of the type " + type_of(values));
  const py::array_t<double, py::array::c_style | py::array::forcecast> converted(values);
  return std::vector<double>(converted.data(), converted.data() + converted.size());
}

} // namespace

Arrays read_arrays(const py::array& vertices, const py::array& faces)
{
  check_rows_of_three(vertices, "the vertices");
  check_rows_of_three(faces, "the faces");
  const char kind = vertices.dtype().kind();
  if(kind != 'f' && kind != 'i' && kind != 'u')
    throw py::type_error("the vertices must be real numbers, and not of the type " + type_of(vertices));
  if(faces.dtype().kind() != 'i' && faces.dtype().kind() != 'u')
    throw py::type_error("the faces must be whole numbers, and not of the type " + type_of(faces));
  constexpr auto most = static_cast<py::ssize_t>(std::numeric_limits<std::uint32_t>::max() / 8);
  if(vertices.shape(0) > most || faces.shape(0) > most)
    throw Invalid_input(Cause::INVALID_PARAMETER,
                        "a mesh has no more than " + std::to_string(most) + " vertices and faces");

  Arrays result;
  if(is_readable_as<double>(vertices))
    result.points = read_points<double>(vertices);
  else if(is_readable_as<float>(vertices))
    result.points = read_points<float>(vertices);
  else
    result.points = read_points<double>(py::array_t<double, py::array::forcecast>(vertices));

  const std::size_t n = result.points.size();
  if(is_readable_as<std::int64_t>(faces))
    result.faces = read_faces<std::int64_t>(faces, n);
  else if(is_readable_as<std::int32_t>(faces))
    result.faces = read_faces<std::int32_t>(faces, n);
  else if(is_readable_as<std::uint32_t>(faces))
    result.faces = read_faces<std::uint32_t>(faces, n);
  else if(is_readable_as<std::uint64_t>(faces))
    result.faces = read_faces<std::uint64_t>(faces, n);
  else
    result.faces = read_faces<std::int64_t>(py::array_t<std::int64_t, py::array::forcecast>(faces), n);
  return result;
}

std::vector<double> read_vertex_values(const py::array& values, std::size_t number_of_vertices)
{
  if(values.ndim() != 1 || static_cast<std::size_t>(values.shape(0)) != number_of_vertices)
    throw Invalid_input(Cause::INVALID_DISTANCE, "the distances must be an array of the shape (" +
                                                   std::to_string(number_of_vertices) + ",), and not " +
                                                   shape_of(values));
  return read_numbers(values, "distances");
}

std::vector<double> read_face_lengths(const py::array& values, std::size_t number_of_faces)
{
  if(values.ndim() != 2 || static_cast<std::size_t>(values.shape(0)) != number_of_faces || values.shape(1) != 3)
    throw Invalid_input(Cause::INVALID_DISTANCE, "the edge lengths must be an array of the shape (" +
                                                   std::to_string(number_of_faces) + ", 3), and not " +
                                                   shape_of(values));
  return read_numbers(values, "edge lengths");
}

std::vector<double> read_rows(const py::array& values, py::ssize_t columns, const std::string& name)
{
  if(values.ndim() != 2 || values.shape(1) != columns)
    throw Invalid_input(Cause::INVALID_PARAMETER, "the " + name + " must be an array of the shape (n, " +
                                                    std::to_string(columns) + "), and not " + shape_of(values));
  return read_numbers(values, name);
}

void append_mesh(const Mesh& mesh, std::vector<double>& points, std::vector<std::int64_t>& corners)
{
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    points.insert(points.end(), {p.x(), p.y(), p.z()});
  }
  for(const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    for(const Mesh::Vertex_index v : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
      corners.push_back(v.idx());
  }
}

std::int64_t index_or_none(Mesh::Vertex_index v)
{
  return v == Mesh::null_vertex() ? -1 : std::int64_t(v.idx());
}
