// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Result.h"
#include "arrays.h"

#include "../../demo/Surface_mesh_cut_locus/flatten.h"

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/geodesic_loop.h>
#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/voronoi_neighbors.h>
#include <CGAL/refine_along_cut_locus.h>

#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace py = pybind11;
using namespace pybind11::literals;
namespace loci = CGAL::Cut_loci;

namespace {

template <typename Value, typename Function>
std::vector<Value> of_points(const Result& result, int columns, const Function& append)
{
  const Cut_locus::Graph& graph = result.cut_locus.graph();
  std::vector<Value> values;
  values.reserve(columns * num_vertices(graph));
  for(const auto v : CGAL::make_range(vertices(graph)))
    append(values, graph[v]);
  return values;
}

template <typename Value, typename Function>
std::vector<Value> of_edges(const Result& result, int columns, const Function& append)
{
  const Cut_locus::Graph& graph = result.cut_locus.graph();
  std::vector<Value> values;
  values.reserve(columns * num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph)))
    append(values, e, graph);
  return values;
}

template <typename Value, typename Function>
std::vector<Value> of_sources(const Result& result, const Function& append)
{
  std::vector<Value> values;
  for(std::size_t i = 0; i < result.cut_locus.number_of_sources(); ++i)
    append(values, result.cut_locus.source(i));
  return values;
}

void append_point(std::vector<double>& to, const Kernel::Point_3& p)
{
  to.insert(to.end(), {p.x(), p.y(), p.z()});
}

void append_point_of(std::vector<double>& to, const Cut_locus::Vertex& v)
{
  append_point(to, v.point);
}

void append_face_of(std::vector<std::int64_t>& to, const Cut_locus::Vertex& v)
{
  to.push_back(v.location.first.idx());
}

void append_coordinates_of(std::vector<double>& to, const Cut_locus::Vertex& v)
{
  to.insert(to.end(), v.location.second.begin(), v.location.second.end());
}

void append_mesh_vertex_of(std::vector<std::int64_t>& to, const Cut_locus::Vertex& v)
{
  to.push_back(index_or_none(v.mesh_vertex));
}

const char* status_name(loci::Cut_locus_status status)
{
  return status == loci::Cut_locus_status::BRANCHES    ? "branches"
         : status == loci::Cut_locus_status::ONE_POINT ? "one point"
                                                       : "only a border";
}

// vertices, faces, their places in the plane, and the vertices and faces of the surface that they come from
py::tuple disk_of(const Result& result, const std::optional<std::string>& parameterization)
{
  std::vector<double> points, plane;
  std::vector<std::int64_t> corners, vertex, face;
  {
    const py::gil_scoped_release no_gil;
    const std::unique_ptr<Chart> chart = chart_of_source(*result.mesh, result.cut_locus);
    if(parameterization)
      flatten(*result.mesh, result.cut_locus, *chart, *parameterization);
    append_mesh(chart->disk, points, corners);
    for(const Mesh::Vertex_index v : chart->disk.vertices())
    {
      plane.insert(plane.end(), {chart->uv[v].x(), chart->uv[v].y()});
      vertex.push_back(chart->vertices[v] == loci::null_index ? -1 : std::int64_t(chart->vertices[v]));
    }
    face.assign(chart->faces.begin(), chart->faces.end());
  }
  return py::make_tuple(to_array(std::move(points), 3), to_array(std::move(corners), 3), to_array(std::move(plane), 2),
                        to_array(std::move(vertex)), to_array(std::move(face)));
}

// vertices, faces, the source whose cell each face is in, and the vertices and faces of the surface that they come from
py::tuple cells_of(const Result& result)
{
  std::vector<double> points;
  std::vector<std::int64_t> corners, source, vertex, face;
  {
    const py::gil_scoped_release no_gil;
    Mesh refined;
    const auto origin = refined.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
    const auto face_origin = refined.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
    const auto cell = refined.add_property_map<Mesh::Face_index, std::size_t>("f:cell").first;
    CGAL::refine_along_cut_locus(*result.mesh, result.cut_locus, refined,
                                 CGAL::parameters::snapping_tolerance(1. / (1 << 20)) // as areas are measured
                                   .vertex_to_vertex_map(origin)
                                   .face_to_face_map(face_origin),
                                 CGAL::parameters::face_patch_map(cell));
    append_mesh(refined, points, corners);
    for(const Mesh::Vertex_index v : refined.vertices())
      vertex.push_back(index_or_none(origin[v]));
    for(const Mesh::Face_index f : refined.faces())
    {
      face.push_back(face_origin[f].idx());
      source.push_back(cell[f] == loci::no_source ? -1 : std::int64_t(cell[f]));
    }
  }
  return py::make_tuple(to_array(std::move(points), 3), to_array(std::move(corners), 3), to_array(std::move(source)),
                        to_array(std::move(vertex)), to_array(std::move(face)));
}

} // namespace

void bind_result(py::module_& m)
{
  py::class_<Result>(m, "Result")
    .def("points", [](const Result& r) { return to_array(of_points<double>(r, 3, append_point_of), 3); })
    .def("faces", [](const Result& r) { return to_array(of_points<std::int64_t>(r, 1, append_face_of)); })
    .def("barycentric", [](const Result& r) { return to_array(of_points<double>(r, 3, append_coordinates_of), 3); })
    .def("mesh_vertices",
         [](const Result& r) { return to_array(of_points<std::int64_t>(r, 1, append_mesh_vertex_of)); })
    .def("distances", [](const Result& r)
         { return to_array(of_points<double>(r, 1, [](auto& to, const auto& v) { to.push_back(v.distance); })); })
    .def("edges",
         [](const Result& r)
         {
    return to_array(of_edges<std::int64_t>(r, 2,
                                           [](auto& to, const auto& e, const auto& graph)
                                           {
      to.push_back(std::int64_t(source(e, graph)));
      to.push_back(std::int64_t(target(e, graph)));
                    }),
                    2);
    })
    .def("strengths",
         [](const Result& r)
         {
    return to_array(
      of_edges<double>(r, 1, [](auto& to, const auto& e, const auto& graph) { to.push_back(graph[e].strength); }));
    })
    .def("widths",
         [](const Result& r)
         {
    return to_array(
      of_edges<double>(r, 1, [](auto& to, const auto& e, const auto& graph) { to.push_back(graph[e].width); }));
    })
    .def("edge_sources",
         [](const Result& r)
         {
    return to_array(of_edges<std::int64_t>(r, 2,
                                           [](auto& to, const auto& e, const auto& graph)
                                           {
      for(const std::size_t s : graph[e].sources)
        to.push_back(std::int64_t(s));
                    }),
                    2);
    })
    .def("is_on_border",
         [](const Result& r)
         {
    return to_array(of_edges<std::uint8_t>(
      r, 1, [](auto& to, const auto& e, const auto& graph) { to.push_back(graph[e].is_on_border); }));
    })
    .def("cell_neighbors",
         [](const Result& r)
         {
    std::vector<std::int64_t> pairs;
    std::vector<double> lengths;
    for(const loci::Voronoi_neighbors& neighbors : loci::voronoi_neighbors(r.cut_locus))
    {
      pairs.insert(pairs.end(), neighbors.sources.begin(), neighbors.sources.end());
      lengths.push_back(neighbors.length);
    }
    return py::make_tuple(to_array(std::move(pairs), 2), to_array(std::move(lengths)));
    })
    .def("polylines",
         [](const Result& r)
         {
    py::list result;
    for(const auto& chain : loci::internal::maximal_chains(r.cut_locus.graph()))
      result.append(to_array(std::vector<std::int64_t>(chain.vertices.begin(), chain.vertices.end())));
    return result;
    })
    .def("source_points", [](const Result& r) { return to_array(of_sources<double>(r, append_point_of), 3); })
    .def("source_faces", [](const Result& r) { return to_array(of_sources<std::int64_t>(r, append_face_of)); })
    .def("source_barycentric",
         [](const Result& r) { return to_array(of_sources<double>(r, append_coordinates_of), 3); })
    .def("vertex_distances",
         [](const Result& r)
         {
    std::vector<double> values;
    values.reserve(r.mesh->number_of_vertices());
    for(const Mesh::Vertex_index v : r.mesh->vertices())
      values.push_back(r.cut_locus.distance(v));
    return to_array(std::move(values));
    })
    .def("nearest_sources",
         [](const Result& r)
         {
    std::vector<std::int64_t> values;
    values.reserve(r.mesh->number_of_vertices());
    for(const Mesh::Vertex_index v : r.mesh->vertices())
    {
      const std::optional<std::size_t> nearest = r.cut_locus.nearest_source(v);
      values.push_back(nearest ? std::int64_t(*nearest) : -1);
    }
    return to_array(std::move(values));
    })
    .def("nearest",
         [](const Result& r)
         {
    const auto nearest = loci::injectivity_radius(r.cut_locus);
    std::vector<double> point;
    append_point(point, nearest.point);
    return py::make_tuple(nearest.distance, to_array(std::move(point)), nearest.lower_bound);
    })
    .def_property_readonly("status", [](const Result& r) { return status_name(r.statistics.status); })
    .def_property_readonly("components", [](const Result& r) { return r.statistics.components; })
    .def_property_readonly("cycles", [](const Result& r) { return r.statistics.cycles; })
    .def_property_readonly("leaves", [](const Result& r) { return r.statistics.leaves; })
    .def_property_readonly("branchings", [](const Result& r) { return r.statistics.branchings; })
    .def_property_readonly("length", [](const Result& r) { return r.statistics.length; })
    .def_property_readonly("narrow_corridors", [](const Result& r) { return r.statistics.narrow_corridors; })
    .def_property_readonly("one_of_several", [](const Result& r) { return r.statistics.is_one_of_several; })
    .def_property_readonly("genus", [](const Result& r) { return r.cut_locus.genus(); })
    .def_property_readonly("border_loops", [](const Result& r) { return r.cut_locus.number_of_border_loops(); })
    .def_property_readonly("farthest_vertex", [](const Result& r) { return r.cut_locus.farthest_vertex().idx(); })
    .def("cell_areas", [](const Result& r) { return to_array(loci::voronoi_cell_areas(*r.mesh, r.cut_locus)); })
    .def("cells", &cells_of)
    .def("geodesic_loop",
         [](const Result& r)
         {
    std::vector<double> points;
    for(const Kernel::Point_3& p : loci::geodesic_loop(*r.mesh, r.cut_locus))
      append_point(points, p);
    return to_array(std::move(points), 3);
    })
    .def("cut_open", &disk_of, "parameterization"_a)
    .def(
      "write",
      [](const Result& r, const std::string& filename) { return CGAL::IO::write_cut_locus(filename, r.cut_locus); },
      "filename"_a, py::call_guard<py::gil_scoped_release>());
}
