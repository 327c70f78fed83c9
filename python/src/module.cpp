// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Exclusive.h"
#include "Geodesics.h"
#include "Input.h"
#include "Progress.h"
#include "Result.h"
#include "arrays.h"
#include "solvers.h"
#include "surfaces.h"

#include <CGAL/Cut_loci/Invalid_input.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <exception>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;
using namespace pybind11::literals;
namespace loci = CGAL::Cut_loci;

namespace {

Mesh_handle read_mesh(const py::array& vertices, const py::array& faces)
{
  const Arrays arrays = read_arrays(vertices, faces); // with the GIL: the arrays must not change
  const py::gil_scoped_release no_gil;
  return {make_mesh(arrays)};
}

py::tuple weld_arrays(const py::array& vertices, const py::array& faces)
{
  const Arrays arrays = read_arrays(vertices, faces);
  Welded welded;
  {
    const py::gil_scoped_release no_gil;
    welded = weld(arrays);
  }
  std::vector<double> coordinates;
  for(const Kernel::Point_3& p : welded.arrays.points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  std::vector<std::int64_t> corners;
  for(const auto& face : welded.arrays.faces)
    corners.insert(corners.end(), face.begin(), face.end());
  return py::make_tuple(to_array(std::move(coordinates), 3), to_array(std::move(corners), 3),
                        to_array(std::move(welded.vertex)));
}

// A solver with the mesh that it refers to.
struct Computation
{
  Computation(std::shared_ptr<const Mesh> m, const py::object& function)
    : mesh(std::move(m)), progress(std::make_shared<Progress>(function))
  {
  }
  // for another thread: see the copy constructor of the solver
  explicit Computation(const Computation& other, const Solver& of_other)
    : mesh(other.mesh), progress(other.progress), is_copy(true), solver(std::make_unique<Solver>(of_other))
  {
  }

  template <typename Function>
  void run(const Function& function)
  {
    if(is_copy) // several use the progress, which must have no function
      exclusive.run(function);
    else
      exclusive.run([&] { progress->watch(function); });
  }

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<Progress> progress;
  bool is_copy = false;
  std::unique_ptr<Solver> solver;
  Exclusive exclusive;
};

py::tuple path_tuple(const Geodesic_path& path)
{
  return py::make_tuple(to_array(path.points, 3), to_array(path.faces), to_array(path.coordinates, 3));
}

// in the order of `Cut_loci::Method`
enum class Method_name { DEFAULT, POLYHEDRAL, LAPLACIAN };

loci::Method method_of(Method_name name)
{
  switch(name)
  {
  case Method_name::DEFAULT:
    return loci::Default_method();
  case Method_name::POLYHEDRAL:
    return loci::Polyhedral_method();
  default:
    return loci::Laplacian_method();
  }
}

// The library names its parameters and functions as in C++.
std::string in_python(std::string message)
{
  const std::pair<const char*, const char*> words[] = {
    {"cut_locus_method(Cut_loci::Laplacian_method())", "method=\"laplacian\""},
    {"cut_locus_method(Cut_loci::Default_method())", "method=\"default\""},
    {"cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)", "curve=\"faces\""},
    {"cut_locus_curve(Cut_loci::Curve::MESH_EDGES)", "curve=\"edges\""},
    {"Cut_loci::Laplacian_method", "\"laplacian\""},
    {"Cut_loci::Default_method", "\"default\""},
    {"Cut_loci::Polyhedral_method", "\"polyhedral\""},
    {"Cut_loci::Curve::THROUGH_FACES", "\"faces\""},
    {"Cut_loci::Curve::MESH_EDGES", "\"edges\""},
    {"heat method with Heat_method_3::Intrinsic_Delaunay", "method of solver=\"heat\""},
    {"Heat_method_geodesic_solver<Heat_method_3::Direct>", "solver=\"heat-direct\""},
    {"the default solver", "solver=\"exact\""},
    {" (CGAL::convex_hull_3() makes one); to flatten others see CGAL::cut_along_cut_locus()",
     "; others are flattened by cut_open()"},
    {"cut it open first, as CGAL::cut_along_cut_locus() does", "cut it open first, as cut_open() does"},
    {"set_directions() comes before compute()", "compute() takes directions=True"},
    {"set_isolines() comes before compute()", "compute() takes isolines=True"},
    {"geodesic_solver", "solver"},
    {"edge_length_map", "edge_lengths"},
    {"vertex_distance_map", "distances"},
    {"the vertex distance map holds", "the distances hold"},
    {"cut_locus_curve", "curve"}};
  for(const auto& [cpp, python] : words)
  {
    const std::string from = cpp;
    for(std::size_t at = message.find(from); at != std::string::npos; at = message.find(from, at))
      message.replace(at, from.size(), python);
  }
  return message;
}

// The causes of `Invalid_input`, with their names in Python.
void add_causes(py::module_& m)
{
  using loci::Cause;
  py::enum_<Cause> causes(m, "Cause", "What is wrong with an input: InvalidInput.cause.");
  causes.attr("__module__") = "cut_locus";
  for(const auto& [name, cause] : std::initializer_list<std::pair<const char*, Cause>>{
        {"OTHER", Cause::OTHER},
        {"EMPTY_MESH", Cause::EMPTY_MESH},
        {"NO_TRIANGLE", Cause::NO_TRIANGLE},
        {"INVALID_COORDINATE", Cause::INVALID_COORDINATE},
        {"FACE_WITHOUT_AREA", Cause::FACE_WITHOUT_AREA},
        {"NON_MANIFOLD", Cause::NON_MANIFOLD},
        {"NO_SOURCE", Cause::NO_SOURCE},
        {"INVALID_SOURCE", Cause::INVALID_SOURCE},
        {"SAME_SOURCES", Cause::SAME_SOURCES},
        {"SOURCES_APART", Cause::SOURCES_APART},
        {"NO_FACE_AT_SOURCE", Cause::NO_FACE_AT_SOURCE},
        {"INVALID_DISTANCE", Cause::INVALID_DISTANCE},
        {"INVALID_PARAMETER", Cause::INVALID_PARAMETER},
        {"PARAMETER_OF_OTHER_METHOD", Cause::PARAMETER_OF_OTHER_METHOD},
        {"INVALID_CUT_LOCUS", Cause::INVALID_CUT_LOCUS},
        {"NOT_CONVEX", Cause::NOT_CONVEX},
        {"NO_DISK", Cause::NO_DISK},
        {"TOO_INACCURATE", Cause::TOO_INACCURATE}})
    causes.value(name, cause);
}

} // namespace

PYBIND11_MODULE(_core, m)
{
  m.doc() = "The C++ part of the package cut_locus; what is public has no underscore in that package.";

  // never destroyed: a static object would be, after the interpreter
  static auto& invalid_input = *new py::exception<loci::Invalid_input>(m, "InvalidInput", PyExc_ValueError);
  invalid_input.attr("__module__") = "cut_locus";
  invalid_input.attr("__doc__") =
    "The mesh, the source or a parameter can not be used. The message names the cause and the element; cause, a Cause, "
    "is the same for programs.";
  add_causes(m);
  invalid_input.attr("cause") = py::cast(loci::Cause::INVALID_PARAMETER); // of those raised in Python
  py::register_exception_translator(
    [](std::exception_ptr p)
    {
    try
    {
      if(p)
        std::rethrow_exception(p);
    }
    catch(const loci::Invalid_input& error)
    {
      const std::string way_out = error.cause() == loci::Cause::NON_MANIFOLD
                                    ? ". cut_locus.weld(vertices, faces) makes a mesh of such faces"
                                    : "";
      const py::object raised = py::object(invalid_input)(in_python(error.what()) + way_out);
      raised.attr("cause") = py::cast(error.cause());
      PyErr_SetObject(invalid_input.ptr(), raised.ptr());
    }
  });

  py::class_<Mesh_handle>(m, "Mesh")
    .def(py::init(&read_mesh), "vertices"_a, "faces"_a)
    .def_property_readonly("number_of_vertices",
                           [](const Mesh_handle& handle) { return handle.mesh->number_of_vertices(); })
    .def_property_readonly("number_of_faces", [](const Mesh_handle& handle) { return handle.mesh->number_of_faces(); })
    .def_property_readonly("number_of_weldable_vertices",
                           [](const Mesh_handle& handle) { return number_of_weldable_vertices(*handle.mesh); });
  m.def("weld", &weld_arrays, "vertices"_a, "faces"_a);

  py::enum_<Method_name>(m, "Method")
    .value("default", Method_name::DEFAULT)
    .value("polyhedral", Method_name::POLYHEDRAL)
    .value("laplacian", Method_name::LAPLACIAN);
  py::enum_<loci::Curve>(m, "Curve").value("edges", loci::Curve::MESH_EDGES).value("faces", loci::Curve::THROUGH_FACES);
  py::enum_<loci::Filter_policy>(m, "FilterPolicy")
    .value("prune", loci::Filter_policy::PRUNING)
    .value("grow", loci::Filter_policy::GROWING);
  py::enum_<loci::Laplacian_operator>(m, "LaplacianOperator")
    .value("quadratic-fit", loci::Laplacian_operator::QUADRATIC_FIT)
    .value("cotangent", loci::Laplacian_operator::COTANGENT);

  m.attr("solver_names") = py::make_tuple("exact", "cgal-exact", "heat", "heat-direct", "graph");

  py::class_<Computation>(m, "Computation")
    .def(py::init(
           [](const Mesh_handle& mesh, const std::string& solver, std::optional<Method_name> name,
              std::optional<loci::Laplacian_operator> laplacian_operator, const std::optional<py::array>& edge_lengths,
              const py::object& progress)
           {
    auto result = std::make_unique<Computation>(mesh.mesh, progress);
    std::vector<double> lengths;
    if(edge_lengths)
      lengths = lengths_of_edges(*mesh.mesh, read_face_lengths(*edge_lengths, mesh.mesh->number_of_faces()));
    result->run(
      [&]
      {
      const auto method = name ? std::optional<loci::Method>(method_of(*name)) : std::nullopt;
      result->solver = make_solver(solver, method, laplacian_operator, lengths, *result->mesh, *result->progress);
    });
    return result;
    }),
         "mesh"_a, "solver"_a, "method"_a, "laplacian_operator"_a, "edge_lengths"_a, "progress"_a)
    .def(
      "prepare",
      [](Computation& c, const std::vector<Source_numbers>& numbers, double snapping_tolerance)
      {
    c.run(
      [&]
      { c.solver->prepare(read_sources(*c.mesh, numbers), CGAL::parameters::snapping_tolerance(snapping_tolerance)); });
      },
      "sources"_a, "snapping_tolerance"_a)
    .def("copy",
         [](Computation& c) { return c.exclusive.run([&] { return std::make_unique<Computation>(c, *c.solver); }); })
    .def(
      "set_sources",
      [](Computation& c, const std::vector<Source_numbers>& numbers, bool is_set,
         const std::vector<Curve_numbers>& curves, bool border, double snapping_tolerance,
         double maximum_relative_error, const std::optional<py::array>& values)
      {
    std::optional<std::vector<double>> distances;
    if(values)
      distances = read_vertex_values(*values, c.mesh->number_of_vertices());
    c.run(
      [&]
      {
      const std::vector<Source> sources = read_sources(*c.mesh, numbers);
      const Source_parameters parameters = {snapping_tolerance, maximum_relative_error, read_curves(*c.mesh, curves),
                                            border, std::move(distances)};
      if(is_set || parameters.has_curves())
        set_sources(*c.solver, sources, parameters);
      else
        set_source(*c.solver, sources.front(), parameters);
    });
      },
      "sources"_a, "is_set"_a, "curves"_a, "border"_a, "snapping_tolerance"_a, "maximum_relative_error"_a,
      "distances"_a)
    .def(
      "cut_locus",
      [](Computation& c, std::optional<double> minimum_branch_width, std::optional<double> minimum_branch_gap,
         std::optional<double> minimum_branch_curvature, std::optional<double> gradient_angle_threshold,
         std::optional<double> laplacian_threshold, std::optional<loci::Filter_policy> filter_policy,
         std::optional<long> minimum_branch_edges, std::optional<long> number_of_iterations,
         std::optional<double> minimum_branch_length, std::optional<loci::Curve> curve, std::optional<bool> voronoi,
         std::optional<bool> medial)
      {
    const Thresholds thresholds = {minimum_branch_width,
                                   minimum_branch_gap,
                                   minimum_branch_curvature,
                                   gradient_angle_threshold,
                                   laplacian_threshold,
                                   filter_policy,
                                   minimum_branch_edges,
                                   number_of_iterations,
                                   minimum_branch_length,
                                   curve,
                                   voronoi,
                                   medial};
    std::unique_ptr<Result> result;
    c.run([&] { result = std::make_unique<Result>(c.mesh, compute_cut_locus(*c.solver, thresholds)); });
    return result;
      },
      py::kw_only(), "minimum_branch_width"_a, "minimum_branch_gap"_a, "minimum_branch_curvature"_a,
      "gradient_angle_threshold"_a, "laplacian_threshold"_a, "filter_policy"_a, "minimum_branch_edges"_a,
      "number_of_iterations"_a, "minimum_branch_length"_a, "curve"_a, "voronoi"_a, "medial"_a)
    // they wait for what runs, as it may change them
    .def_property_readonly("method",
                           [](Computation& c) {
    return c.exclusive.run([&] { return static_cast<Method_name>(c.solver->method().index()); });
    })
    .def_property_readonly("gradient_angle_threshold",
                           [](Computation&) { return loci::Laplacian_method().gradient_angle_threshold(); })
    .def_property_readonly("minimum_branch_width", [](Computation& c)
                           { return c.exclusive.run([&] { return c.solver->minimum_branch_width(); }); })
    .def_property_readonly("minimum_branch_curvature", [](Computation& c)
                           { return c.exclusive.run([&] { return c.solver->minimum_branch_curvature(); }); });

  bind_result(m);
  bind_surfaces(m);

  struct Shared_geodesics
  {
    Shared_geodesics(const Mesh_handle& mesh, const std::vector<bool>& excluded) : geodesics(mesh.mesh, excluded) {}
    Geodesics geodesics;
    Exclusive exclusive;
  };
  py::class_<Shared_geodesics>(m, "Geodesics")
    .def(py::init<const Mesh_handle&, const std::vector<bool>&>(), "mesh"_a, "excluded"_a,
         py::call_guard<py::gil_scoped_release>())
    .def(
      "compute",
      [](Shared_geodesics& s, const std::vector<Source_numbers>& sources, const std::vector<Curve_numbers>& curves,
         bool border, const std::vector<Source_numbers>& targets, double error, double maximum_distance,
         bool directions, bool isolines)
      {
    s.exclusive.run(
      [&]
      {
      std::vector<Location> locations;
      for(const Source& target : read_sources(s.geodesics.mesh(), targets))
        locations.push_back(std::get<Location>(target));
      const Mesh& mesh = s.geodesics.mesh();
      s.geodesics.compute({read_sources(mesh, sources), read_curves(mesh, curves), border}, locations,
                          {error, maximum_distance, directions, isolines});
    });
      },
      "sources"_a, "curves"_a, "border"_a, "targets"_a, "error"_a, "maximum_distance"_a, "directions"_a, "isolines"_a)
    .def(
      "exponential_map",
      [](Shared_geodesics& s, const py::array& places, std::size_t source)
      {
    const std::vector<double> numbers = read_rows(places, 2, "places");
    return path_tuple(s.exclusive.run([&] { return s.geodesics.exponential_map(numbers, source); }));
      },
      "places"_a, "source"_a)
    .def(
      "isolines",
      [](Shared_geodesics& s, const std::vector<double>& levels, std::optional<double> maximum_deviation)
      {
    py::list result;
    for(Geodesics::Isoline& line : s.exclusive.run([&] { return s.geodesics.isolines(levels, maximum_deviation); }))
      result.append(py::make_tuple(line.level, line.is_closed) + path_tuple(line.path));
    return result;
      },
      "levels"_a, "maximum_deviation"_a)
    .def("distances",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.distances(); })); })
    .def("errors", [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.errors(); })); })
    .def("nearest_sources",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.nearest_sources(); })); })
    .def("target_distances",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.target_distances(); })); })
    .def("target_nearest_sources", [](Shared_geodesics& s)
         { return to_array(s.exclusive.run([&] { return s.geodesics.target_nearest_sources(); })); })
    .def("log_map",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.log_map(); }), 2); })
    .def("target_log_map",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.target_log_map(); }), 2); })
    .def("arrival_directions", [](Shared_geodesics& s)
         { return to_array(s.exclusive.run([&] { return s.geodesics.arrival_directions(); }), 3); })
    .def("source_axes",
         [](Shared_geodesics& s) { return to_array(s.exclusive.run([&] { return s.geodesics.source_axes(); }), 2); })
    .def(
      "find",
      [](Shared_geodesics& s, const std::vector<std::int64_t>& faces, const py::array& barycentric)
      {
    const std::vector<double> c = read_rows(barycentric, 3, "barycentric");
    std::vector<Location> points;
    if(3 * faces.size() != c.size())
      throw loci::Invalid_input(loci::Cause::INVALID_PARAMETER,
                                "there must be a face for each row of barycentric coordinates");
    for(std::size_t i = 0; i < faces.size(); ++i)
      points.push_back(std::get<Location>(
        read_sources(s.geodesics.mesh(), {std::pair{faces[i], std::array{c[3 * i], c[3 * i + 1], c[3 * i + 2]}}})
          .front()));
    Geodesics::Found found = s.exclusive.run([&] { return s.geodesics.find(points); });
    py::object places = py::none();
    if(found.log_map.size() == 2 * points.size() && !points.empty())
      places = to_array(std::move(found.log_map), 2);
    return py::make_tuple(to_array(std::move(found.distances)), to_array(std::move(found.nearest_sources)), places);
      },
      "faces"_a, "barycentric"_a)
    .def(
      "path_from",
      [](Shared_geodesics& s, const Source_numbers& target)
      {
    const Source point = read_sources(s.geodesics.mesh(), {target}).front();
    return path_tuple(s.exclusive.run([&] { return s.geodesics.path_from(point); }));
      },
      "target"_a)
    .def(
      "path_from_target",
      [](Shared_geodesics& s, std::size_t target)
      { return path_tuple(s.exclusive.run([&] { return s.geodesics.path_from_target(target); })); },
      "target"_a);
}
