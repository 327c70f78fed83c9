// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Simplified_mesh.h"

#include <CGAL/Cut_loci/internal/Union_find.h>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

namespace SMS = CGAL::Surface_mesh_simplification;
using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::null_index;
using CGAL::Cut_loci::internal::Union_find;
using Point = Kernel::Point_3;
using Coordinates = std::array<double, 3>;

// Half a pixel, where the unit ball is drawn 2000 pixels wide.
constexpr double hair = 1. / 2000.;

struct Visitor : public SMS::Edge_collapse_visitor_base<Mesh>
{
  // also after edges without length, for which nothing else is called
  void OnCollapsed(const Profile& profile, const Mesh::Vertex_index&) { merged->unite(profile.v0(), profile.v1()); }

  Union_find* merged;
};

// Euler's characteristic and the number of border loops. Collapses do not join components, nor part them: together these
// tell whether a handle or a hole is lost.
std::array<long, 2> topology(const Mesh& mesh)
{
  long loops = 0;
  std::vector<bool> is_done(mesh.num_halfedges(), false);
  for(const Mesh::Halfedge_index start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || is_done[start])
      continue;
    ++loops;
    for(Mesh::Halfedge_index h = start; !is_done[h]; h = mesh.next(h))
      is_done[h] = true;
  }
  return {{long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces()), loops}};
}

// the coordinates of the point of the triangle `t` that is closest to `p`
Coordinates closest_in(const std::array<Point, 3>& t, const Point& p)
{
  const auto u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
  const double uu = u * u, uv = u * v, vv = v * v, uw = u * w, vw = v * w, area = uu * vv - uv * uv;
  const Coordinates inside = {{0., (vv * uw - uv * vw) / area, (uu * vw - uv * uw) / area}};
  if(area > 0. && inside[1] >= 0. && inside[2] >= 0. && inside[1] + inside[2] <= 1.)
    return {{1. - inside[1] - inside[2], inside[1], inside[2]}};
  Coordinates best = {{1., 0., 0.}};
  double least = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 3; ++i)
  {
    const int k = (i + 1) % 3;
    const auto along = t[k] - t[i];
    const double length = along * along;
    const double s = length > 0. ? (std::min)((std::max)(along * (p - t[i]) / length, 0.), 1.) : 0.;
    const double off = CGAL::squared_distance(p, t[i] + s * along);
    if(off < least)
    {
      least = off;
      best = {{0., 0., 0.}};
      best[i] = 1. - s;
      best[k] = s;
    }
  }
  return best;
}

Point at(const std::array<Point, 3>& t, const Coordinates& b)
{
  return CGAL::ORIGIN + (b[0] * (t[0] - CGAL::ORIGIN) + b[1] * (t[1] - CGAL::ORIGIN) + b[2] * (t[2] - CGAL::ORIGIN));
}

std::array<Mesh::Vertex_index, 3> vertices_of(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
}

void sort_out(std::vector<std::uint32_t>& vertices)
{
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

} // namespace

Simplified_mesh::Simplified_mesh(std::vector<float> positions, std::vector<std::uint32_t> triangles,
                                 std::vector<std::uint32_t> component)
  : positions_(std::move(positions)), triangles_(std::move(triangles)), component_(std::move(component)),
    merged_into_(positions_.size() / 3, null_index)
{
  const std::size_t n = positions_.size() / 3;
  faces_of_ = Rows(n,
                   [&](const auto& add)
                   {
    for(std::size_t i = 0; i < triangles_.size(); ++i)
      add(triangles_[i], static_cast<std::uint32_t>(i / 3));
  });
  for(std::size_t v = 0; v < n; ++v)
    if(faces_of_.size(static_cast<Index>(v)) > 0)
      merged_into_[v] = mesh_.add_vertex(point(v));
  for(std::size_t i = 0; i < triangles_.size(); i += 3)
  {
    const auto vertex = [&](std::size_t k) { return Mesh::Vertex_index(merged_into_[triangles_[i + k]]); };
    if(mesh_.add_face(vertex(0), vertex(1), vertex(2)) == Mesh::null_face())
      throw std::runtime_error("the mesh has parts that cannot be put together one face after the other");
    for(std::size_t k = 0; k < 3; ++k)
      edge_length_ += std::sqrt(CGAL::squared_distance(point(triangles_[i + k]), point(triangles_[i + (k + 1) % 3])));
  }
  edge_length_ /= static_cast<double>(triangles_.size());
}

void Simplified_mesh::simplify(std::size_t faces)
{
  const std::array<long, 2> before = topology(mesh_);
  const std::size_t all = mesh_.number_of_faces();
  collapse(faces);
  if(topology(mesh_) != before)
    throw std::runtime_error("the mesh cannot be simplified without losing a handle or a hole");
  if(mesh_.number_of_faces() == all)
    throw std::runtime_error("the mesh cannot be simplified");
  link();
}

// The shortest edges first, so that faces are about as long everywhere: what is resolved of the curve depends on the longest
// ones. Quadrics are closer to the surface, but make long faces, with which branches are lost. Edges are replaced by the vertex
// that keeps the volume (Lindstrom and Turk): with midpoints, in less than half of the time, the curve is two to three times
// as far off. No face is turned over.
void Simplified_mesh::collapse(std::size_t faces)
{
  using Placement = SMS::LindstromTurk_placement<Mesh>;
  Union_find merged(mesh_.number_of_vertices());
  Visitor visitor;
  visitor.merged = &merged;
  // three edges less for two faces
  const std::size_t all = mesh_.number_of_faces();
  const std::size_t edges = mesh_.number_of_edges() - 3 * (all - (std::min)(faces, all)) / 2;
  SMS::edge_collapse(mesh_, SMS::Count_stop_predicate<Mesh>(edges),
                     CGAL::parameters::get_cost(SMS::Edge_length_cost<Mesh>())
                       .get_placement(SMS::Bounded_normal_change_placement<Placement>(Placement()))
                       .visitor(visitor));
  auto set = mesh_.add_property_map<Mesh::Vertex_index, Index>("v:set").first;
  for(const Mesh::Vertex_index v : mesh_.vertices())
    set[v] = merged.find(v);
  mesh_.collect_garbage();
  std::vector<std::uint32_t> number(merged.size(), null_index);
  for(const Mesh::Vertex_index v : mesh_.vertices())
    number[set[v]] = v;
  mesh_.remove_property_map(set);
  for(std::uint32_t& v : merged_into_)
    if(v != null_index)
      v = number[merged.find(v)];
}

// What leads from one mesh to the other.
void Simplified_mesh::link()
{
  merged_ = Rows(mesh_.number_of_vertices(),
                 [&](const auto& add)
                 {
    for(std::size_t v = 0; v < merged_into_.size(); ++v)
      if(merged_into_[v] != null_index)
        add(merged_into_[v], static_cast<std::uint32_t>(v));
  });
  locations_.assign(merged_into_.size(), Location(Mesh::null_face(), {{0., 0., 0.}}));
  for(std::size_t v = 0; v < merged_into_.size(); ++v)
    if(merged_into_[v] != null_index)
      locations_[v] = closest(point(v), {merged_into_[v]});
}

std::vector<std::size_t> Simplified_mesh::components() const
{
  std::vector<std::size_t> result;
  if(component_.empty())
    return result;
  for(const Mesh::Face_index f : mesh_.faces())
  {
    const std::uint32_t one_of_whole = *merged_[vertices_of(mesh_, f)[0]].begin();
    result.push_back(component_[*faces_of_[one_of_whole].begin()]);
  }
  return result;
}

Simplified_mesh::Point Simplified_mesh::point(std::size_t v) const
{
  return {positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]};
}

std::array<Simplified_mesh::Point, 3> Simplified_mesh::corners(std::size_t face) const
{
  return {{point(triangles_[3 * face]), point(triangles_[3 * face + 1]), point(triangles_[3 * face + 2])}};
}

Location Simplified_mesh::locate(std::size_t face, const std::array<double, 3>& coordinates) const
{
  if(face >= triangles_.size() / 3)
    throw std::runtime_error("the mesh has no face #" + std::to_string(face));
  Near near;
  for(std::size_t k = 0; k < 3; ++k)
    near.push_back(merged_into_[triangles_[3 * face + k]]);
  return closest(at(corners(face), coordinates), near);
}

// the place of the simplified mesh closest to `p` in the faces at some of its vertices
Location Simplified_mesh::closest(const Point& p, Near near) const
{
  sort_out(near);
  Location result(Mesh::null_face(), {{1., 0., 0.}});
  double least = std::numeric_limits<double>::infinity();
  for(const std::uint32_t v : near)
    for(const Mesh::Face_index f : mesh_.faces_around_target(mesh_.halfedge(Mesh::Vertex_index(v))))
    {
      if(f == Mesh::null_face())
        continue;
      const auto vertices = vertices_of(mesh_, f);
      const std::array<Point, 3> t = {{mesh_.point(vertices[0]), mesh_.point(vertices[1]), mesh_.point(vertices[2])}};
      const Coordinates b = closest_in(t, p);
      const double off = CGAL::squared_distance(p, at(t, b));
      if(off < least)
      {
        least = off;
        result = Location(f, b);
      }
    }
  return result;
}

std::vector<float> Simplified_mesh::project(const Cut_locus& cut_locus) const
{
  std::vector<float> result;
  const Cut_locus::Graph& graph = cut_locus.graph();
  for(const auto e : CGAL::make_range(edges(graph)))
  {
    // the corners of both faces that the ends name: those of the face between them, too
    Near near;
    const auto ends = {graph[source(e, graph)], graph[target(e, graph)]};
    for(const auto& end : ends)
      for(const Mesh::Vertex_index v : vertices_of(mesh_, end.location.first))
        near.push_back(v);
    sort_out(near);
    const std::array<Point, 2> points = {{ends.begin()[0].point, ends.begin()[1].point}};
    append_projected(points, {{on_whole(points[0], near), on_whole(points[1], near)}}, near, result);
  }
  return result;
}

// A piece is halved until it is within a hair of the surface, or as short as the edges there.
void Simplified_mesh::append_projected(const std::array<Point, 2>& ends, const std::array<Point, 2>& projected,
                                       const Near& near, std::vector<float>& to) const
{
  const Point middle = CGAL::midpoint(ends[0], ends[1]), on_surface = on_whole(middle, near);
  const double off = CGAL::squared_distance(on_surface, CGAL::midpoint(projected[0], projected[1]));
  if(off > hair * hair && CGAL::squared_distance(ends[0], ends[1]) > edge_length_ * edge_length_)
  {
    append_projected({{ends[0], middle}}, {{projected[0], on_surface}}, near, to);
    append_projected({{middle, ends[1]}}, {{on_surface, projected[1]}}, near, to);
    return;
  }
  for(const Point& p : projected)
    for(int k = 0; k < 3; ++k)
      to.push_back(static_cast<float>(p[k]));
}

// The closest point in the faces around the closest of the vertices that were merged into some of the simplified mesh.
Simplified_mesh::Point Simplified_mesh::on_whole(const Point& p, const Near& near) const
{
  std::uint32_t vertex = null_index;
  double least = std::numeric_limits<double>::infinity();
  for(const std::uint32_t to : near)
    for(const std::uint32_t v : merged_[to])
    {
      const double off = CGAL::squared_distance(p, point(v));
      if(off < least)
      {
        least = off;
        vertex = v;
      }
    }
  Point result = point(vertex);
  for(const std::uint32_t f : faces_of_[vertex])
  {
    const std::array<Point, 3> t = corners(f);
    const Point q = at(t, closest_in(t, p));
    const double off = CGAL::squared_distance(p, q);
    if(off < least)
    {
      least = off;
      result = q;
    }
  }
  return result;
}

std::vector<float> Simplified_mesh::interpolate(const std::vector<float>& values) const
{
  std::vector<float> result(locations_.size(), std::numeric_limits<float>::infinity());
  for(std::size_t v = 0; v < locations_.size(); ++v)
  {
    const auto& [face, coordinates] = locations_[v];
    if(face == Mesh::null_face())
      continue;
    const auto vertices = vertices_of(mesh_, face);
    double sum = 0.;
    for(int k = 0; k < 3; ++k)
      sum += coordinates[k] * values[vertices[k]];
    result[v] = static_cast<float>(sum);
  }
  return result;
}

std::vector<std::uint32_t> Simplified_mesh::transfer(const std::vector<std::uint32_t>& values) const
{
  std::vector<std::uint32_t> result(merged_into_.size(), 0);
  for(std::size_t v = 0; v < result.size() && !values.empty(); ++v)
    if(merged_into_[v] != null_index)
      result[v] = values[merged_into_[v]];
  return result;
}
