// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input_mesh.h"
#include "weld.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <unordered_set>
#include <utility>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Points = std::vector<Kernel::Point_3>;
using Polygon = std::vector<std::size_t>;
using Polygons = std::vector<Polygon>;
using Vertex_pair = std::pair<std::size_t, std::size_t>;
// the exact predicates are for polygons that are nearly flat, or nearly of no area
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon_numbers = Mesh::Property_map<Mesh::Face_index, std::size_t>;
constexpr std::size_t no_polygon = std::size_t(-1);
using Exact_points = Mesh::Property_map<Mesh::Vertex_index, Exact_kernel::Point_3>;

Vertex_pair edge_of(std::size_t a, std::size_t b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

template <typename Visit>
void for_each_edge(const Polygon& polygon, const Visit& visit)
{
  for(std::size_t i = 0; i < polygon.size(); ++i)
    visit(polygon[i], polygon[(i + 1) % polygon.size()]);
}

void check_numbers(const Polygon_soup& soup, const std::string& name)
{
  if(soup.points.empty())
    throw std::runtime_error("'" + name + "': there are no vertices in it");
  if(soup.polygons.empty())
    throw std::runtime_error("'" + name + "': there are no faces in it");
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    for(std::size_t v : soup.polygons[f])
    {
      if(v >= soup.points.size())
        throw std::runtime_error("'" + name + "': face #" + std::to_string(f) +
                                 " refers to a vertex that does not exist");
      const Kernel::Point_3& p = soup.points[v];
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        throw std::runtime_error("'" + name + "': vertex #" + std::to_string(v) +
                                 " has a coordinate that is not finite");
    }
}

bool has_vertex_twice(Polygon polygon)
{
  std::sort(polygon.begin(), polygon.end());
  return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
}

// The parts of a polygon that do not meet themselves: where it comes back to a vertex, it has gone around one.
Polygons simple_parts(const Polygon& polygon)
{
  Polygons parts;
  Polygon open;
  for(std::size_t v : polygon)
  {
    const auto loop = std::find(open.begin(), open.end(), v);
    if(open.end() - loop > 2)
      parts.emplace_back(loop, open.end());
    open.erase(loop, open.end());
    open.push_back(v);
  }
  if(open.size() > 2)
    parts.push_back(open);
  return parts;
}

// The same for polygons that have the same sides.
Polygon sorted_sides(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if(polygon.back() < polygon[1])
    std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

struct Orientation_counter : PMP::Default_orientation_visitor
{
  explicit Orientation_counter(Repairs& counted) : repairs(&counted) {}
  void polygon_orientation_reversed(std::size_t) { ++repairs->reversed_faces; }
  Repairs* repairs;
};

// Diagonals from one corner: what is left for polygons that meet themselves.
void triangulate_as_fan(Mesh::Face_index f, Mesh& mesh)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  while(!CGAL::is_triangle(h, mesh))
    CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
}

// Seen along its normal, as CGAL triangulates it: one that is not simple spoils the mesh.
bool is_simple(Mesh::Face_index f, const Mesh& mesh, const Exact_points& points)
{
  const Exact_kernel::Vector_3 normal =
    PMP::compute_face_normal(f, mesh, CGAL::parameters::vertex_point_map(points).geom_traits(Exact_kernel()));
  if(normal == CGAL::NULL_VECTOR)
    return false;
  std::vector<Exact_kernel::Point_3> corners;
  for(Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    corners.push_back(points[v]);
  return CGAL::is_simple_2(corners.begin(), corners.end(), CGAL::Projection_traits_3<Exact_kernel>(normal));
}

// Gives the triangles inside of the edges of a polygon its number. New faces have none.
void set_polygon(const std::vector<Mesh::Halfedge_index>& edges, std::size_t number, const Mesh& mesh,
                 Polygon_numbers polygon)
{
  std::vector<Mesh::Face_index> faces;
  const auto add = [&](Mesh::Halfedge_index h)
  {
    polygon[mesh.face(h)] = number;
    faces.push_back(mesh.face(h));
  };
  std::for_each(edges.begin(), edges.end(), add);
  while(!faces.empty())
  {
    const Mesh::Face_index f = faces.back();
    faces.pop_back();
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      if(const Mesh::Halfedge_index o = mesh.opposite(h); !mesh.is_border(o) && polygon[mesh.face(o)] == no_polygon)
        add(o);
  }
}

std::size_t triangulate(Mesh& mesh, Polygon_numbers polygon)
{
  std::vector<Mesh::Face_index> polygons;
  for(Mesh::Face_index f : mesh.faces())
    if(!CGAL::is_triangle(mesh.halfedge(f), mesh))
      polygons.push_back(f);
  if(polygons.empty())
    return 0;
  const double scale = scale_to_unit({mesh.points().begin(), mesh.points().end()});
  Exact_points points = mesh.add_property_map<Mesh::Vertex_index, Exact_kernel::Point_3>("v:scaled").first;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    points[v] = {p.x() * scale, p.y() * scale, p.z() * scale};
  }
  for(Mesh::Face_index f : polygons)
  {
    const std::size_t number = polygon[f];
    const auto around = CGAL::halfedges_around_face(mesh.halfedge(f), mesh);
    const std::vector<Mesh::Halfedge_index> edges(around.begin(), around.end());
    if(!(is_simple(f, mesh, points) &&
         PMP::triangulate_face(f, mesh, CGAL::parameters::vertex_point_map(points).geom_traits(Exact_kernel()))))
      triangulate_as_fan(f, mesh);
    set_polygon(edges, number, mesh, polygon);
  }
  mesh.remove_property_map(points);
  return polygons.size();
}

// Makes `polygons` those of a mesh, in their order. Vertices that get new ones keep the numbers in `number`, and polygons
// in `polygon`. What is a mesh already, as a polygon with two sides, is left as it is.
void repair_soup(std::vector<std::size_t>& number, Polygons& polygons, std::vector<std::size_t>& polygon,
                 Repairs& repairs)
{
  if(PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return;
  Polygons kept;
  std::set<Polygon> known;
  std::vector<std::size_t> origin;
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(const Polygon& part : simple_parts(polygons[f]))
      if(known.insert(sorted_sides(part)).second)
      {
        kept.push_back(part);
        origin.push_back(f);
      }
  repairs.removed_faces = polygons.size() - (std::min)(polygons.size(), kept.size());
  polygons = std::move(kept);
  polygon = std::move(origin);
  if(PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return;
  const std::size_t vertices = number.size();
  PMP::orient_polygon_soup(number, polygons, CGAL::parameters::visitor(Orientation_counter(repairs)));
  repairs.duplicated_vertices = number.size() - vertices;
}

Mesh::Vertex_index add_vertex(Input_mesh& input, std::size_t number, const Kernel::Point_3& p)
{
  const Mesh::Vertex_index v = input.mesh.add_vertex(p);
  input.number[v] = number;
  if(input.vertex[number] == Mesh::null_vertex())
    input.vertex[number] = v;
  return v;
}

// In the order of the file; new vertices come last, and those without a polygon are left out.
void add_polygons(const Points& points, const std::vector<std::size_t>& number, const Polygons& polygons,
                  Input_mesh& input)
{
  std::vector<bool> is_used(number.size(), false);
  for(const Polygon& polygon : polygons)
    for(std::size_t v : polygon)
      is_used[v] = true;
  std::vector<Mesh::Vertex_index> vertex(number.size());
  for(std::size_t v = 0; v < number.size(); ++v)
    if(is_used[v])
      vertex[v] = add_vertex(input, number[v], points[number[v]]);
  std::vector<Mesh::Vertex_index> corners;
  for(const Polygon& polygon : polygons)
  {
    corners.clear();
    for(std::size_t v : polygon)
      corners.push_back(vertex[v]);
    input.mesh.add_face(corners);
  }
}

void find_added_edges(Input_mesh& input, const Polygons& polygons, const std::vector<std::size_t>& first)
{
  std::unordered_set<Vertex_pair, boost::hash<Vertex_pair>> edges;
  for(const Polygon& polygon : polygons)
    for_each_edge(polygon, [&](std::size_t a, std::size_t b) { edges.insert(edge_of(first[a], first[b])); });
  for(Mesh::Edge_index e : input.mesh.edges())
    input.is_added[e] =
      edges.count(edge_of(input.number[input.mesh.vertex(e, 0)], input.number[input.mesh.vertex(e, 1)])) == 0;
}

void find_components(Input_mesh& input)
{
  auto component = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  input.component_size.resize(PMP::connected_components(input.mesh, component));
  std::vector<double>& area = input.component_area;
  area.assign(input.component_size.size(), 0.);
  for(Mesh::Face_index f : input.mesh.faces())
  {
    input.component.push_back(component[f]);
    ++input.component_size[component[f]];
    area[component[f]] += PMP::face_area(f, input.mesh);
  }
  input.largest_component = static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
  input.mesh.remove_property_map(component);
}

// Whether the faces of each vertex form one fan. Several that end at borders follow each other around a vertex of a
// `Surface_mesh`; others are not met.
bool has_manifold_vertices(const Mesh& mesh)
{
  std::size_t corners = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    std::size_t borders = 0;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh))
      ++(mesh.is_border(h) ? borders : corners);
    if(borders > 1)
      return false;
  }
  return corners == 3 * std::size_t(mesh.number_of_faces());
}

// The mesh without repairs, or `fault`: what keeps the soup from being one of triangles.
Input_mesh mesh_as_it_is(const Polygon_soup& soup, std::string& fault)
{
  Input_mesh input;
  input.mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()),
                     static_cast<Mesh::size_type>(3 * soup.polygons.size()),
                     static_cast<Mesh::size_type>(soup.polygons.size()));
  input.vertex.resize(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    add_vertex(input, v, soup.points[v]);
  for(std::size_t f = 0; f < soup.polygons.size() && fault.empty(); ++f)
  {
    const Polygon& t = soup.polygons[f];
    const std::string face = "face #" + std::to_string(f);
    if(t.size() != 3)
      fault = face + " has " + std::to_string(t.size()) + " sides; all must be triangles";
    else if(has_vertex_twice(t))
      fault = face + " has a vertex twice";
    else if(input.mesh.add_face(input.vertex[t[0]], input.vertex[t[1]], input.vertex[t[2]]) == Mesh::null_face())
      fault = "an edge belongs to more than two faces, or to two of opposite orientation, as one of " + face + " does";
  }
  if(fault.empty() && !has_manifold_vertices(input.mesh))
    fault = "there is a vertex that is not manifold: its faces form several fans";
  input.is_added.assign(input.mesh.number_of_edges(), false);
  input.polygon.resize(soup.polygons.size());
  std::iota(input.polygon.begin(), input.polygon.end(), std::size_t(0));
  return input;
}

bool has_border(const Mesh& mesh)
{
  return std::any_of(mesh.halfedges().begin(), mesh.halfedges().end(),
                     [&](Mesh::Halfedge_index h) { return mesh.is_border(h); });
}

Input_mesh repaired_mesh(const Polygon_soup& soup, const Weld& welded)
{
  const std::vector<std::size_t>& first = welded.first;
  Input_mesh input;
  input.vertex.resize(soup.points.size());
  std::vector<bool> is_used(soup.points.size(), false);
  Polygons polygons = soup.polygons;
  for(Polygon& polygon : polygons)
    for(std::size_t& v : polygon)
    {
      is_used[v] = true;
      v = first[v];
    }
  input.repairs.merged_vertices = welded.merged_vertices;
  input.repairs.unused_vertices = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));

  std::vector<std::size_t> number(soup.points.size());
  std::iota(number.begin(), number.end(), std::size_t(0));
  std::vector<std::size_t> polygon(polygons.size());
  std::iota(polygon.begin(), polygon.end(), std::size_t(0));
  repair_soup(number, polygons, polygon, input.repairs);
  add_polygons(soup.points, number, polygons, input);
  Polygon_numbers of_face = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:polygon", no_polygon).first;
  for(const Mesh::Face_index f : input.mesh.faces())
    of_face[f] = polygon[f];
  input.repairs.triangulated_faces = triangulate(input.mesh, of_face);
  input.polygon.assign(of_face.begin(), of_face.end());
  input.mesh.remove_property_map(of_face);
  for(std::size_t v = 0; v < first.size(); ++v)
    input.vertex[v] = input.vertex[first[v]];
  input.is_added.assign(input.mesh.number_of_edges(), false);
  if(input.repairs.triangulated_faces > 0)
    find_added_edges(input, soup.polygons, first);
  return input;
}

} // namespace

bool Repairs::is_empty() const
{
  return description(*this).empty();
}

std::string description(const Repairs& repairs)
{
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* several)
  {
    if(count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + (count == 1 ? one : several);
  };
  add(repairs.triangulated_faces, "polygon triangulated", "polygons triangulated");
  add(repairs.merged_vertices, "border vertex merged with another one at its place",
      "border vertices merged with others at their places");
  add(repairs.reversed_faces, "face reversed", "faces reversed");
  add(repairs.duplicated_vertices, "vertex added where the surface was not manifold",
      "vertices added where the surface was not manifold");
  add(repairs.removed_faces, "face removed that was double or had a vertex twice",
      "faces removed that were double or had a vertex twice");
  add(repairs.unused_vertices, "unused vertex dropped", "unused vertices dropped");
  add(repairs.open_edges, "border edge left open that lies on another one",
      "border edges left open that lie on each other");
  return text;
}

bool is_added(const Cut_locus::Edge& edge, const Input_mesh& input)
{
  return edge.mesh_halfedge != Mesh::null_halfedge() && input.is_added[input.mesh.edge(edge.mesh_halfedge)];
}

std::size_t component_of_source(const Input_mesh& input, const Cut_locus& cut_locus)
{
  return input.component[cut_locus.source().location.first];
}

Input_mesh make_mesh(const Polygon_soup& soup, Repair repair, const std::string& name)
{
  check_numbers(soup, name);
  std::string fault;
  Input_mesh input = mesh_as_it_is(soup, fault);
  if(repair == Repair::NONE && !fault.empty())
    throw Needs_repair("'" + name + "': " + fault);
  Weld welded;
  if(repair == Repair::WELD && (!fault.empty() || has_border(input.mesh)))
    welded = weld(soup);
  else
  {
    welded.first.resize(soup.points.size());
    std::iota(welded.first.begin(), welded.first.end(), std::size_t(0));
  }
  if(repair != Repair::NONE && (!fault.empty() || welded.merged_vertices > 0))
    input = repaired_mesh(soup, welded);
  input.repairs.open_edges = welded.open_edges;
  const auto is_flat = [&](Mesh::Face_index f) { return PMP::is_degenerate_triangle_face(f, input.mesh); };
  if(std::all_of(input.mesh.faces().begin(), input.mesh.faces().end(), is_flat))
    throw std::runtime_error("'" + name + "': no face of it has an area");
  find_components(input);
  return input;
}
