// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "output.h"
#include "Renderer.h"
#include "output_file.h"
#include "picture_files.h"
#include "report_json.h"
#include "views.h"

#include <CGAL/Cut_loci/IO/write_cut_locus.h>
#include <CGAL/Cut_loci/extract_polylines.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace {

constexpr int width_of_view = 900;
using Curves = std::vector<std::vector<Mesh::Edge_index>>;

constexpr picture::Color cut_locus_color = {0.80, 0.05, 0.16}, source_color = {0.08, 0.33, 0.80},
                         farthest_color = {0.98, 0.62, 0.05};

struct Format
{
  const char* extension;
  const char* description;
  void (*write_picture)(std::ostream&, const std::vector<picture::Rendered_view>&); // null: the library writes it
};

const Format formats[] = {
  {".polylines.txt", "CGAL's format for polylines", nullptr},
  {".obj", "Wavefront, lines", nullptr},
  {".vtp", "VTK, with distances, and with strength, width, enclosed curvature and sources of edges", nullptr},
  {".ply", "PLY, vertices and edges with the same", nullptr},
  {".json", "the graph, with the same, and the sources", nullptr},
  {".png", "picture from two sides, of several sources with colored cells", picture::write_png},
  {".svg", "the same, vector graphics", picture::write_svg},
};

const Format* find_format(const std::string& filename)
{
  for(const Format& format : formats)
  {
    const std::string extension = format.extension;
    if(filename.size() > extension.size() &&
       filename.compare(filename.size() - extension.size(), extension.size(), extension) == 0)
      return &format;
  }
  return nullptr;
}

picture::Vector to_vector(const Kernel::Point_3& p)
{
  return {{p.x(), p.y(), p.z()}};
}

// Light colors that differ from those beside them, however many there are: hues by the golden ratio.
picture::Color color_of_cell(std::size_t source)
{
  if(source == CGAL::Cut_loci::no_source)
    return {0.8, 0.8, 0.8};
  constexpr double golden = 0.6180339887498949, least = 0.62;
  const double hue = 6. * std::fmod(0.1 + golden * double(source), 1.);
  const auto channel = [&](double shift)
  {
    const double t = std::fmod(hue + shift, 6.);
    return least + (1. - least) * (std::max)(0., (std::min)({t, 4. - t, 1.}));
  };
  return {channel(2.), channel(0.), channel(4.)};
}

void add_cells(const Cells& cells, picture::Scene& scene)
{
  scene.points = cells.mesh.points;
  scene.values = cells.distance;
  for(std::size_t f = 0; f < cells.source.size(); ++f)
  {
    const auto& t = cells.mesh.triangles[f];
    scene.triangles.push_back({{t[0], t[1], t[2]}});
    scene.colors.push_back(color_of_cell(cells.source[f]));
  }
}

void add_mesh(const Mesh& mesh, const Cut_locus& cut_locus, picture::Scene& scene)
{
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    scene.points.push_back(to_vector(mesh.point(v)));
    scene.values.push_back(cut_locus.distance(v));
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    scene.triangles.push_back({{mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()}});
  }
}

picture::Scene make_scene(const Cut_locus& cut_locus, const Mesh& mesh, const Curves& source_curves,
                          const std::optional<Cells>& cells)
{
  picture::Scene scene;
  if(cells)
    add_cells(*cells, scene);
  else
    add_mesh(mesh, cut_locus, scene);
  for(const auto& points : CGAL::Cut_loci::extract_polylines(cut_locus))
  {
    scene.polylines.emplace_back();
    scene.polylines.back().color = cut_locus_color;
    for(const Kernel::Point_3& p : points)
      scene.polylines.back().points.push_back(to_vector(p));
  }
  for(const std::vector<Mesh::Edge_index>& curve : source_curves)
    for(const Mesh::Edge_index e : curve)
    {
      scene.polylines.emplace_back();
      scene.polylines.back().color = source_color;
      for(unsigned int i = 0; i < 2; ++i)
        scene.polylines.back().points.push_back(to_vector(mesh.point(mesh.vertex(e, i))));
    }
  scene.dots.push_back({to_vector(mesh.point(cut_locus.farthest_vertex())), farthest_color, 7.});
  for(std::size_t i = cut_locus.number_of_sources(); i-- > 0;) // views are chosen by the last one
    scene.dots.push_back({to_vector(cut_locus.source(i).point), source_color, 9.});
  return scene;
}

std::vector<picture::Rendered_view> draw(const Cut_locus& cut_locus, const Mesh& mesh, const Curves& source_curves,
                                         const std::optional<Cells>& cells,
                                         const std::optional<picture::Vector>& toward)
{
  const picture::Scene scene = make_scene(cut_locus, mesh, source_curves, cells);
  const std::vector<picture::View> views =
    toward ? std::vector<picture::View>{picture::look_from(*toward, picture::guess_up(scene))}
           : picture::choose_two_views(scene, scene.dots.back().point, scene.dots.front().point);
  std::vector<picture::Rendered_view> rendered;
  for(const picture::Frame& frame : picture::make_frames(scene, views, width_of_view))
    rendered.push_back(picture::render(scene, frame));
  return rendered;
}

bool has_added_edges(const Input_mesh& input)
{
  return std::find(input.is_added.begin(), input.is_added.end(), true) != input.is_added.end();
}

// Marks the edges of the curve that follow edges that are none of the file.
auto marks(const Cut_locus& cut_locus, const Input_mesh& input)
{
  const Cut_locus::Graph& graph = cut_locus.graph();
  return CGAL::parameters::edge_is_constrained_map(
    boost::make_function_property_map<boost::graph_traits<Cut_locus::Graph>::edge_descriptor>(
      [&](const auto& e) { return is_added(graph[e], input); }));
}

// Arrays have the names that they have in PLY and VTP files.
template <typename Edge_marks>
void write_graph(std::ostream& os, const Cut_locus& cut_locus, const Input_mesh& input, const Edge_marks& is_marked)
{
  const Cut_locus::Graph& graph = cut_locus.graph();
  Json of_vertices, of_edges, sources = Json::array();
  for(const char* name : {"point", "distance"})
    of_vertices[name] = Json::array();
  for(const auto v : CGAL::make_range(vertices(graph)))
  {
    of_vertices["point"].push_back(to_vector(graph[v].point));
    of_vertices["distance"].push_back(graph[v].distance);
  }
  of_edges["vertices"] = Json::array();
  for(const auto& e : CGAL::make_range(edges(graph)))
    of_edges["vertices"].push_back({source(e, graph), target(e, graph)});
  CGAL::Cut_loci::internal::for_each_edge_array(graph, is_marked,
                                                [&](const char* name, const auto& value_of)
                                                {
    of_edges[name] = Json::array();
    for(const auto& e : CGAL::make_range(edges(graph)))
      of_edges[name].push_back(value_of(e));
  });
  for(std::size_t i = 0; i < cut_locus.number_of_sources(); ++i)
  {
    const Cut_locus::Vertex& at = cut_locus.source(i);
    sources.push_back({{"point", to_vector(at.point)},
                       {"vertex", at.mesh_vertex == Mesh::null_vertex() ? Json() : Json(input.number[at.mesh_vertex])},
                       {"is_curve", cut_locus.is_curve(i)}});
  }
  os << Json({{"vertices", of_vertices}, {"edges", of_edges}, {"sources", sources}}) << '\n';
}

template <typename NamedParameters>
void write_curve(std::ostream& os, const std::string& extension, const Cut_locus& cut_locus, const Input_mesh& input,
                 const NamedParameters& np)
{
  if(extension == ".json")
    write_graph(os, cut_locus, input, CGAL::Cut_loci::internal::edge_marks(np));
  else if(extension == ".obj")
    CGAL::IO::write_OBJ(os, cut_locus, np);
  else if(extension == ".ply")
    CGAL::IO::write_PLY(os, cut_locus, np);
  else if(extension == ".vtp")
    CGAL::IO::write_VTP(os, cut_locus, np);
  else
    CGAL::IO::write_polylines(os, cut_locus, np);
}

} // namespace

bool is_output_name(const std::string& filename)
{
  return find_format(filename) != nullptr;
}

bool is_picture_name(const std::string& filename)
{
  const Format* const format = find_format(filename);
  return format != nullptr && format->write_picture != nullptr;
}

std::string output_extensions()
{
  std::string result;
  for(const Format& format : formats)
    result += std::string(" ") + format.extension;
  return result;
}

std::string output_descriptions()
{
  std::string result;
  for(const Format& format : formats)
    result += std::string(result.empty() ? "  " : "\n  ") + format.extension + ": " + format.description;
  return result;
}

void write_outputs(const std::vector<std::string>& filenames, const Cut_locus& cut_locus, const Input_mesh& input,
                   const Curves& source_curves, const std::optional<Cells>& cells,
                   const std::optional<std::array<double, 3>>& view)
{
  std::vector<picture::Rendered_view> views; // drawn once for all pictures
  for(const std::string& filename : filenames)
  {
    const Format* const format = find_format(filename);
    if(format->write_picture == nullptr)
      write_file(filename,
                 [&](std::ostream& os)
                 {
        if(has_added_edges(input))
          write_curve(os, format->extension, cut_locus, input, marks(cut_locus, input));
        else
          write_curve(os, format->extension, cut_locus, input, CGAL::parameters::default_values());
      });
    else
    {
      if(views.empty())
        views = draw(cut_locus, input.mesh, source_curves, cells, view);
      write_file(filename, [&](std::ostream& os) { format->write_picture(os, views); });
    }
  }
}

void write_edges(const std::string& filename, const Cut_locus& cut_locus, const Input_mesh& input)
{
  const auto number =
    boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) { return input.number[v]; });
  write_file(filename, [&](std::ostream& os)
             { CGAL::IO::write_edges(os, cut_locus, input.mesh, marks(cut_locus, input).vertex_index_map(number)); });
}
