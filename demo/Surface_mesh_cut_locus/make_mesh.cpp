// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/functional/hash.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <unordered_set>
#include <utility>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Points = std::vector<Kernel::Point_3>;
using Polygon = std::vector<std::size_t>;
using Polygons = std::vector<Polygon>;
using Vertex_pair = std::pair<std::size_t, std::size_t>;
// the exact predicates are for faces that are nearly flat, or nearly of no area
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;

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

// As the library decides which faces can be laid flat, with a reserve.
bool has_area(const Kernel::Point_3& p, const Kernel::Point_3& q, const Kernel::Point_3& r)
{
  const Kernel::Vector_3 a = q - p, b = r - p, c = r - q;
  const auto largest = [](const Kernel::Vector_3& v) {
    return (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  };
  const double scale = (std::max)({largest(a), largest(b), largest(c)});
  if(!(scale > 0.))
    return false;
  const double area = std::sqrt(CGAL::cross_product(a / scale, b / scale).squared_length());
  return area > 1e-12;
}

std::vector<Vertex_pair> border_edges(const Polygons& polygons)
{
  std::vector<Vertex_pair> edges, border;
  for(const Polygon& polygon : polygons)
    for_each_edge(polygon, [&](std::size_t a, std::size_t b) { edges.push_back(edge_of(a, b)); });
  std::sort(edges.begin(), edges.end());
  for(std::size_t i = 0, end = 0; i < edges.size(); i = end)
  {
    for(end = i; end < edges.size() && edges[end] == edges[i];)
      ++end;
    if(end == i + 1)
      border.push_back(edges[i]);
  }
  return border;
}

// A file may repeat the vertices for each face, as STL does. Where faces share edges, a border is meant to be one.
bool share_no_edge(const Polygons& polygons, const std::vector<Vertex_pair>& border)
{
  std::size_t number_of_sides = 0;
  for(const Polygon& polygon : polygons)
    number_of_sides += polygon.size();
  return polygons.size() > 1 && border.size() == number_of_sides;
}

// The least of the vertices that stand for the same one, as the ends of border edges at the same place do. What only
// touches in a vertex stays apart.
std::vector<std::size_t> join_borders(const Points& points, const std::vector<Vertex_pair>& border)
{
  std::map<Kernel::Point_3, std::size_t, Kernel::Less_xyz_3> vertex_at;
  std::map<Vertex_pair, Vertex_pair> edge_at;
  boost::vector_property_map<std::size_t> rank, parent;
  boost::disjoint_sets<decltype(rank), decltype(parent)> same(rank, parent);
  for(std::size_t v = 0; v < points.size(); ++v)
    same.make_set(v);
  for(const Vertex_pair& edge : border)
  {
    const auto place = [&](std::size_t v) { return vertex_at.emplace(points[v], v).first->second; };
    const Vertex_pair places = {place(edge.first), place(edge.second)};
    if(places.first == places.second)
      continue;
    const bool is_reversed = places.first > places.second;
    const Vertex_pair ordered = is_reversed ? Vertex_pair(edge.second, edge.first) : edge;
    const Vertex_pair other = edge_at.emplace(edge_of(places.first, places.second), ordered).first->second;
    same.union_set(ordered.first, other.first);
    same.union_set(ordered.second, other.second);
  }
  std::vector<std::size_t> first(points.size()), least(points.size(), points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    std::size_t& l = least[same.find_set(v)];
    l = (std::min)(l, v);
    first[v] = l;
  }
  return first;
}

// Lets CGAL repair a soup whose "points" are the numbers of the vertices: so these survive, and which vertices are
// the same has been decided before.
struct Number_traits
{
  using Less_xyz_3 = std::less<std::size_t>;
  using Equal_3 = std::equal_to<std::size_t>;
  Less_xyz_3 less_xyz_3_object() const { return Less_xyz_3(); }
  Equal_3 equal_3_object() const { return Equal_3(); }
};

struct Orientation_counter : PMP::Default_orientation_visitor
{
  explicit Orientation_counter(Repairs& counted) : repairs(&counted) {}
  void polygon_orientation_reversed(std::size_t) { ++repairs->reversed_faces; }
  Repairs* repairs;
};

// A power of two: the coordinates are as exact afterwards, and their products do not leave the range of numbers.
double scale_to_unit(const Points& points)
{
  double largest = 0.;
  for(const Kernel::Point_3& p : points)
    for(double x : {p.x(), p.y(), p.z()})
      if(std::isfinite(x))
        largest = (std::max)(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1., -exponent);
}

// Diagonals from one corner: what is left for polygons that meet themselves.
void triangulate_as_fan(Exact_mesh::Face_index f, Exact_mesh& mesh)
{
  const Exact_mesh::Halfedge_index h = mesh.halfedge(f);
  while(!CGAL::is_triangle(h, mesh))
    CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
}

// Seen along its normal, as CGAL triangulates it: one that is not simple spoils the mesh.
bool is_simple(Exact_mesh::Face_index f, const Exact_mesh& mesh)
{
  const Exact_kernel::Vector_3 normal = PMP::compute_face_normal(f, mesh);
  if(normal == CGAL::NULL_VECTOR)
    return false;
  std::vector<Exact_kernel::Point_3> corners;
  for(Exact_mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    corners.push_back(mesh.point(v));
  return CGAL::is_simple_2(corners.begin(), corners.end(), CGAL::Projection_traits_3<Exact_kernel>(normal));
}

void triangulate(Exact_mesh& mesh, Repairs& repairs)
{
  std::vector<Exact_mesh::Face_index> polygons;
  for(Exact_mesh::Face_index f : mesh.faces())
    if(!CGAL::is_triangle(mesh.halfedge(f), mesh))
      polygons.push_back(f);
  repairs.triangulated_faces = polygons.size();
  for(Exact_mesh::Face_index f : polygons)
    if(!(is_simple(f, mesh) && PMP::triangulate_face(f, mesh)))
      triangulate_as_fan(f, mesh);
}

bool has_flat_face(const Polygon_soup& soup)
{
  return std::any_of(soup.polygons.begin(), soup.polygons.end(),
                     [&](const Polygon& t)
                     { return !has_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]); });
}

// Makes `polygons` those of a mesh. Vertices that get new ones keep the numbers in `number`. What is a mesh already, as a
// polygon with two sides, is left as it is.
void repair_soup(std::vector<std::size_t>& number, Polygons& polygons, Repairs& repairs)
{
  if(PMP::is_polygon_soup_a_polygon_mesh(polygons))
  {
    PMP::remove_isolated_points_in_polygon_soup(number, polygons);
    return;
  }
  const std::size_t faces = polygons.size();
  PMP::repair_polygon_soup(number, polygons, CGAL::parameters::geom_traits(Number_traits()));
  repairs.removed_faces = faces - (std::min)(faces, polygons.size()); // one that touches itself becomes several
  if(PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return;
  const std::size_t vertices = number.size();
  PMP::orient_polygon_soup(number, polygons, CGAL::parameters::visitor(Orientation_counter(repairs)));
  repairs.duplicated_vertices = number.size() - vertices;
}

Exact_mesh exact_mesh(const Points& points, const std::vector<std::size_t>& number, const Polygons& polygons)
{
  Exact_mesh mesh;
  const double scale = scale_to_unit(points);
  for(std::size_t n : number)
    mesh.add_vertex({points[n].x() * scale, points[n].y() * scale, points[n].z() * scale});
  std::vector<Exact_mesh::Vertex_index> corners;
  for(const Polygon& polygon : polygons)
  {
    corners.clear();
    for(std::size_t v : polygon)
      corners.emplace_back(static_cast<Exact_mesh::size_type>(v));
    mesh.add_face(corners);
  }
  return mesh;
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
  for(Mesh::Face_index f : input.mesh.faces())
  {
    input.component.push_back(component[f]);
    ++input.component_size[component[f]];
  }
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
  for(const Kernel::Point_3& p : soup.points)
  {
    input.number.push_back(input.number.size());
    input.vertex.push_back(input.mesh.add_vertex(p));
  }
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
  return input;
}

std::vector<Vertex_pair> border_edges(const Mesh& mesh)
{
  std::vector<Vertex_pair> border;
  for(Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e))
      border.emplace_back(mesh.vertex(e, 0), mesh.vertex(e, 1));
  return border;
}

Input_mesh repaired_mesh(const Polygon_soup& soup, const std::vector<std::size_t>& first)
{
  Input_mesh input;
  std::vector<bool> is_used(soup.points.size(), false);
  for(const Polygon& polygon : soup.polygons)
    for(std::size_t v : polygon)
      is_used[v] = true;
  for(std::size_t v = 0; v < first.size(); ++v)
    input.repairs.merged_vertices += first[v] != v;
  input.repairs.unused_vertices = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));

  std::vector<std::size_t> number(soup.points.size());
  std::iota(number.begin(), number.end(), std::size_t(0));
  Polygons polygons = soup.polygons;
  for(Polygon& polygon : polygons)
    for(std::size_t& v : polygon)
      v = first[v];
  repair_soup(number, polygons, input.repairs);
  Exact_mesh mesh = exact_mesh(soup.points, number, polygons);
  triangulate(mesh, input.repairs);
  const auto point = [&](Exact_mesh::Vertex_index v) { return soup.points[number[v]]; };
  const auto is_flat = [&](Exact_mesh::Face_index f)
  {
    const Exact_mesh::Halfedge_index h = mesh.halfedge(f);
    return !has_area(point(mesh.source(h)), point(mesh.target(h)), point(mesh.target(mesh.next(h))));
  };
  input.repairs.flat_faces = static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(), is_flat));
  if(input.repairs.flat_faces > 0)
    PMP::remove_degenerate_faces(mesh);

  // vertices that have lost their faces are left behind
  input.vertex.assign(soup.points.size(), Mesh::null_vertex());
  PMP::remove_isolated_vertices(mesh);
  CGAL::copy_face_graph(mesh, input.mesh,
                        CGAL::parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator(
                          [&](const std::pair<Exact_mesh::Vertex_index, Mesh::Vertex_index>& copied)
                          {
    const std::size_t n = number[copied.first];
    input.number.resize(copied.second + std::size_t(1));
    input.number[copied.second] = n;
    if(input.vertex[n] == Mesh::null_vertex())
      input.vertex[n] = copied.second;
                        })));
  for(Mesh::Vertex_index v : input.mesh.vertices()) // not those of the scaled copy
    input.mesh.point(v) = soup.points[input.number[v]];
  for(std::size_t v = 0; v < first.size(); ++v)
    input.vertex[v] = input.vertex[first[v]];
  input.is_added.assign(input.mesh.number_of_edges(), false);
  if(input.repairs.triangulated_faces > 0 || input.repairs.flat_faces > 0)
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
  add(repairs.flat_faces, "flat face removed", "flat faces removed");
  add(repairs.unused_vertices, "unused vertex dropped", "unused vertices dropped");
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

Input_mesh make_mesh(const Polygon_soup& soup, bool may_repair, const std::string& name)
{
  check_numbers(soup, name);
  std::string fault;
  Input_mesh input = mesh_as_it_is(soup, fault);
  if(!may_repair && !fault.empty())
    throw Needs_repair("'" + name + "': " + fault);
  if(may_repair)
  {
    std::vector<Vertex_pair> border = fault.empty() ? border_edges(input.mesh) : border_edges(soup.polygons);
    if(!share_no_edge(soup.polygons, border))
      border.clear();
    const std::vector<std::size_t> first = join_borders(soup.points, border);
    bool is_joined = false;
    for(std::size_t v = 0; v < first.size(); ++v)
      is_joined = is_joined || first[v] != v;
    if(!fault.empty() || is_joined || has_flat_face(soup))
      input = repaired_mesh(soup, first);
  }
  if(input.mesh.number_of_faces() == 0)
    throw std::runtime_error("'" + name + "': no face of it has an area");
  find_components(input);
  return input;
}
