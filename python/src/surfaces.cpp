// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surfaces.h"

#include "Input.h"
#include "arrays.h"

#include <CGAL/Cut_loci/flatten_disk.h>
#include <CGAL/Cut_loci/source_unfolding.h>
#include <CGAL/refine_along_polylines.h>

#include <pybind11/stl.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;
using namespace pybind11::literals;
namespace loci = CGAL::Cut_loci;

namespace {

py::array flatten_disk(const Mesh_handle& handle)
{
  std::vector<double> plane(2 * handle.mesh->number_of_vertices(), 0.);
  {
    const py::gil_scoped_release no_gil;
    Mesh disk = *handle.mesh; // of its own, for a property
    const auto uv = disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    loci::flatten_disk(disk, uv);
    for(const Mesh::Vertex_index v : disk.vertices())
    {
      plane[2 * v.idx()] = uv[v].x();
      plane[2 * v.idx() + 1] = uv[v].y();
    }
  }
  return to_array(std::move(plane), 2);
}

// in the order of `LayoutQuality`
py::tuple layout_quality(const Mesh_handle& handle, const py::array& uv)
{
  const std::vector<double> plane = read_rows(uv, 2, "uv");
  if(plane.size() != 2 * handle.mesh->number_of_vertices())
    throw loci::Invalid_input(loci::Cause::INVALID_PARAMETER, "uv must have one row for each of the " +
                                                                std::to_string(handle.mesh->number_of_vertices()) +
                                                                " vertices, and not " +
                                                                std::to_string(plane.size() / 2));
  const auto place_of = [&](Mesh::Vertex_index v)
  { return Kernel::Point_2(plane[2 * v.idx()], plane[2 * v.idx() + 1]); };
  loci::Layout_quality q;
  {
    const py::gil_scoped_release no_gil;
    q = loci::layout_quality(*handle.mesh,
                             boost::make_function_property_map<Mesh::Vertex_index, Kernel::Point_2>(place_of));
  }
  return py::make_tuple(q.flipped_faces, q.is_injective, q.overlapping_faces, q.overlap, q.area_distortion,
                        q.angle_distortion, q.symmetric_dirichlet_energy, q.faces_without_shape);
}

// the corners, the edge that each edge is glued to, the points of the surface at the corners, and the fold lines
py::tuple source_unfolding(const Mesh_handle& handle, const Source_numbers& numbers)
{
  std::vector<double> corners, points, folds;
  std::vector<std::int64_t> glued_to;
  bool is_source_moved = false;
  {
    const py::gil_scoped_release no_gil;
    const Source source = read_sources(*handle.mesh, {numbers}).front();
    const auto unfolding = std::visit([&](const auto& s) { return loci::source_unfolding(*handle.mesh, s); }, source);
    is_source_moved = unfolding.is_source_moved;
    for(const auto& corner : unfolding.corners)
    {
      corners.insert(corners.end(), {corner.point.x(), corner.point.y()});
      glued_to.push_back(corner.glued_to == unfolding.no_edge ? -1 : std::int64_t(corner.glued_to));
      const Kernel::Point_3& p = unfolding.vertices[corner.vertex].point;
      points.insert(points.end(), {p.x(), p.y(), p.z()});
    }
    for(const auto& fold : unfolding.fold_lines)
      folds.insert(folds.end(), {fold.source.x(), fold.source.y(), fold.target.x(), fold.target.y()});
  }
  const auto number_of_folds = static_cast<py::ssize_t>(folds.size() / 4);
  return py::make_tuple(to_array(std::move(corners), 2), to_array(std::move(glued_to)), to_array(std::move(points), 3),
                        to_array(std::move(folds), {number_of_folds, 2, 2}), is_source_moved);
}

// vertices, faces, the edges of each curve, and the vertices and faces of the surface that they come from
py::tuple refine_along_polylines(const Mesh_handle& handle, const std::vector<std::vector<Source_numbers>>& numbers)
{
  std::vector<double> points;
  std::vector<std::int64_t> corners, vertex, face;
  std::vector<std::vector<std::int64_t>> curves;
  {
    const py::gil_scoped_release no_gil;
    const Mesh& mesh = *handle.mesh;
    std::vector<std::vector<Location>> polylines;
    for(const std::vector<Source_numbers>& line : numbers)
    {
      polylines.emplace_back();
      for(const Source& at : read_sources(mesh, line))
        polylines.back().push_back(std::get<Location>(at));
    }
    Mesh refined;
    const auto origin = refined.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
    const auto face_origin = refined.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
    for(const auto& part : CGAL::refine_along_polylines(
          mesh, polylines, refined, CGAL::parameters::vertex_to_vertex_map(origin).face_to_face_map(face_origin)))
    {
      curves.emplace_back();
      for(const Mesh::Edge_index e : part)
        for(int end : {0, 1})
          curves.back().push_back(refined.vertex(e, end).idx());
    }
    append_mesh(refined, points, corners);
    for(const Mesh::Vertex_index v : refined.vertices())
      vertex.push_back(index_or_none(origin[v]));
    for(const Mesh::Face_index f : refined.faces())
      face.push_back(face_origin[f].idx());
  }
  py::list edges;
  for(std::vector<std::int64_t>& ends : curves)
    edges.append(to_array(std::move(ends), 2));
  return py::make_tuple(to_array(std::move(points), 3), to_array(std::move(corners), 3), edges,
                        to_array(std::move(vertex)), to_array(std::move(face)));
}

} // namespace

void bind_surfaces(py::module_& m)
{
  m.def("flatten_disk", &flatten_disk, "mesh"_a);
  m.def("layout_quality", &layout_quality, "mesh"_a, "uv"_a);
  m.def("source_unfolding", &source_unfolding, "mesh"_a, "source"_a);
  m.def("refine_along_polylines", &refine_along_polylines, "mesh"_a, "polylines"_a);
}
