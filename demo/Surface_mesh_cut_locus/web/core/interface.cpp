// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The functions that the page's worker calls. All return 1, or 0 after an error, whose message and cause
// `last_error` and `last_cause` give. Results are read from arrays of the session; their numbers are those in src/arrays.js.

#include "../../Input_mesh.h"
#include "Session.h"
#include "Simplified_mesh.h"
#include "report_stage.h"
#include "samples.h"

#include <CGAL/Cut_loci/Invalid_input.h>

#include <emscripten.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

Session session;
// of a worker that computes previews: its session has the simplified mesh
std::unique_ptr<Simplified_mesh> simplified;
struct Preview
{
  std::vector<float> positions; // of the whole mesh, as are these
  std::vector<std::uint32_t> triangles, component;
  double unit = 1.; // that of the whole mesh
  std::vector<float> segments, distance;
  std::vector<std::uint32_t> nearest_source;
} preview;
Thresholds thresholds;
std::vector<Location> sources;
std::string error, text;
int cause = -1; // of the error, in the order of `CGAL::Cut_loci::Cause`, if the library says it

template <typename Function>
int run(const Function& function)
{
  error.clear();
  cause = -1;
  try
  {
    function();
    return 1;
  }
  catch(const std::bad_alloc&)
  {
    error = "the mesh is too large for the memory that a page can have";
  }
  catch(const CGAL::Cut_loci::Invalid_input& e)
  {
    error = e.what();
    cause = static_cast<int>(e.cause());
  }
  catch(const std::exception& e)
  {
    error = e.what();
  }
  return 0;
}

// Links round coordinates: they sum up to one again.
Location location(unsigned int face, double b0, double b1, double b2)
{
  const double sum = b0 + b1 + b2;
  return {Mesh::Face_index(face), {{b0 / sum, b1 / sum, b2 / sum}}};
}

struct Array
{
  const void* data;
  std::size_t size;
};

template <typename T>
Array array(const std::vector<T>& v)
{
  return {v.data(), v.size()};
}

Array array(int id)
{
  switch(id)
  {
  case 0:
    return array(session.positions);
  case 1:
    return array(session.triangles);
  case 2:
    return array(session.mesh_numbers);
  case 3:
    return array(session.distance);
  case 4:
    return array(session.source_numbers);
  case 5:
    return array(session.laplacian);
  case 6:
    return array(session.gradient);
  case 7:
    return array(session.curves[0].segments);
  case 8:
    return array(session.curves[0].width);
  case 9:
    return array(session.curves[0].gap);
  case 10:
    return array(session.curves[0].numbers);
  case 11:
    return array(session.curves[1].segments);
  case 12:
    return array(session.curves[1].width);
  case 13:
    return array(session.curves[1].gap);
  case 14:
    return array(session.curves[1].numbers);
  case 15:
    return {text.data(), text.size()};
  case 16:
    return array(session.atlas.places.parents);
  case 17:
    return array(session.atlas.triangles);
  case 18:
    return array(session.atlas.border);
  case 19:
    return array(session.atlas.uv);
  case 20:
    return array(session.atlas.numbers);
  case 21:
    return array(session.component);
  case 22:
    return {session.repairs.data(), session.repairs.size()};
  case 23:
    return array(session.path_points);
  case 24:
    return array(session.path_numbers);
  case 25:
    return array(session.border_segments);
  case 26:
    return array(session.nearest_source);
  case 27:
    return array(session.atlas.faces);
  case 28:
    return array(session.atlas.places.weights);
  case 29:
    return array(preview.positions);
  case 30:
    return array(preview.triangles);
  case 31:
    return array(preview.component);
  case 32:
    return array(preview.segments);
  case 33:
    return array(preview.distance);
  case 34:
    return array(preview.nearest_source);
  case 35:
    return array(session.curves[0].distance);
  case 36:
    return array(session.curves[1].distance);
  case 37:
    return array(session.cells.places.parents);
  case 38:
    return array(session.cells.places.weights);
  case 39:
    return array(session.cells.triangles);
  case 40:
    return array(session.cells.source);
  default:
    return {nullptr, 0};
  }
}

} // namespace

EM_JS(void, report_stage_to_page, (int stage, int starts), { Module['onStage'](stage, starts); });
EM_JS(void, report_progress_to_page, (int stage, double share), { Module['onProgress'](stage, share); });

void report_stage(int stage, bool starts)
{
  report_stage_to_page(stage, starts);
}

void report_progress(int stage, double share)
{
  report_progress_to_page(stage, share);
}

void Stage_reporter::start_stage(CGAL::Cut_loci::Stage stage) const
{
  report_stage(static_cast<int>(stage), true);
}
void Stage_reporter::end_stage(CGAL::Cut_loci::Stage stage) const
{
  report_stage(static_cast<int>(stage), false);
}
void Stage_reporter::progress(CGAL::Cut_loci::Stage stage, double share) const
{
  report_progress(static_cast<int>(stage), share);
}

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* last_error()
{
  return error.c_str();
}
EMSCRIPTEN_KEEPALIVE int last_cause()
{
  return cause;
}
EMSCRIPTEN_KEEPALIVE const void* array_data(int id)
{
  return array(id).data;
}
EMSCRIPTEN_KEEPALIVE std::size_t array_size(int id)
{
  return array(id).size;
}

EMSCRIPTEN_KEEPALIVE int load_file(const char* filename)
{
  return run(
    [&]
    {
    Input_mesh input = read_mesh(filename, Repair::WELD);
    const std::string repairs = description(input.repairs);
    session.load(std::move(input.mesh), input.component, repairs);
  });
}

EMSCRIPTEN_KEEPALIVE int load_sample(const char* name, double number_of_faces)
{
  return run([&] { session.load(make_sample(name, number_of_faces)); });
}

EMSCRIPTEN_KEEPALIVE int prepare(const char* solver, const char* method)
{
  return run([&] { session.prepare(solver, method); });
}

EMSCRIPTEN_KEEPALIVE void clear_sources()
{
  sources.clear();
}

EMSCRIPTEN_KEEPALIVE void add_source(unsigned int face, double b0, double b1, double b2)
{
  sources.push_back(location(face, b0, b1, b2));
}

EMSCRIPTEN_KEEPALIVE int set_sources(int with_border, double relative_error)
{
  return run([&] { session.set_sources(sources, with_border != 0, relative_error); });
}

EMSCRIPTEN_KEEPALIVE int find_paths(unsigned int face, double b0, double b1, double b2)
{
  return run([&] { session.find_paths(location(face, b0, b1, b2)); });
}

// What is not a number stands for the default of the library.
EMSCRIPTEN_KEEPALIVE void set_thresholds(double width, int keeps, double angle, double laplacian, double minimum_edges,
                                         double minimum_length, int grows, int smoothing)
{
  thresholds = {width,      static_cast<Kept_part>(keeps),       angle, laplacian, minimum_edges, minimum_length,
                grows != 0, static_cast<unsigned int>(smoothing)};
}

EMSCRIPTEN_KEEPALIVE int compute_curve(int index)
{
  return run([&] { session.compute_curve(static_cast<Session::Curve_index>(index), thresholds); });
}

EMSCRIPTEN_KEEPALIVE int cut_open(int index, int by_logarithmic_map)
{
  return run([&] { session.cut_open(static_cast<Session::Curve_index>(index), thresholds, by_logarithmic_map != 0); });
}

EMSCRIPTEN_KEEPALIVE int divide_into_cells(int index)
{
  return run([&] { session.divide_into_cells(static_cast<Session::Curve_index>(index), thresholds); });
}

EMSCRIPTEN_KEEPALIVE int compute_laplacian()
{
  return run([&] { session.compute_laplacian(); });
}

EMSCRIPTEN_KEEPALIVE int compute_gradient()
{
  return run([&] { session.compute_gradient(); });
}

EMSCRIPTEN_KEEPALIVE int write_curve(int index, const char* format)
{
  return run([&] { text = session.write_curve(static_cast<Session::Curve_index>(index), format); });
}

// Room for the mesh of another worker, in the unit ball, to be written to arrays.
EMSCRIPTEN_KEEPALIVE int resize_mesh(std::size_t positions, std::size_t triangles, std::size_t component)
{
  return run(
    [&]
    {
    preview.positions.resize(positions);
    preview.triangles.resize(triangles);
    preview.component.resize(component);
  });
}

EMSCRIPTEN_KEEPALIVE int take_mesh(double unit)
{
  return run(
    [&]
    {
    simplified.reset();
    preview.unit = unit;
    simplified = std::make_unique<Simplified_mesh>(std::move(preview.positions), std::move(preview.triangles),
                                                   std::move(preview.component));
  });
}

EMSCRIPTEN_KEEPALIVE int simplify(std::size_t faces)
{
  return run(
    [&]
    {
    if(!simplified)
      throw std::runtime_error("there is no mesh to simplify");
    simplified->simplify(faces);
    session.load(simplified->mesh(), simplified->components());
  });
}

EMSCRIPTEN_KEEPALIVE std::size_t number_of_simplified_faces()
{
  return simplified ? simplified->mesh().number_of_faces() : 0;
}

// at a place of the whole mesh
EMSCRIPTEN_KEEPALIVE int add_preview_source(unsigned int face, double b0, double b1, double b2)
{
  return run([&] { sources.push_back(simplified->locate(face, location(face, b0, b1, b2).second)); });
}

// On the whole mesh. Branches that the simplified one does not resolve are left out.
EMSCRIPTEN_KEEPALIVE int compute_preview_curve(int index)
{
  return run(
    [&]
    {
    Thresholds resolved = thresholds;
    resolved.width = (std::max)(thresholds.width, session.default_width());
    const auto curve = static_cast<Session::Curve_index>(index);
    session.compute_curve(curve, resolved);
    preview.segments = simplified->project(session.result(curve));
  });
}

EMSCRIPTEN_KEEPALIVE int compute_preview_distances()
{
  return run(
    [&]
    {
    preview.distance = simplified->interpolate(session.distance);
    for(float& d : preview.distance)
      d *= static_cast<float>(preview.unit);
    preview.nearest_source = simplified->transfer(session.nearest_source);
  });
}

} // extern "C"
