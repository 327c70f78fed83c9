// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "set_source.h"
#include "thresholds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>

namespace {

using Mesh_edges = std::vector<Mesh::Edge_index>;

Kernel::Point_3 to_point(const std::array<double, 3>& p)
{
  return Kernel::Point_3(p[0], p[1], p[2]);
}

constexpr std::size_t no_component = std::size_t(-1);

// at a halfedge to a vertex, or at one of an edge; vertices without a face have none
std::size_t component_at(const Input_mesh& input, Mesh::Halfedge_index h)
{
  const Mesh& mesh = input.mesh;
  return h.is_valid() ? input.component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)] : no_component;
}

std::size_t component_of_vertex(const Input_mesh& input, std::size_t number, const char* option)
{
  const std::size_t component = component_at(input, input.mesh.halfedge(find_vertex(number, input, option)));
  return component == no_component ? input.largest_component : component; // as a source it will be refused
}

std::size_t component_of_point(const Input_mesh& input, const std::array<double, 3>& p)
{
  return input.component[closest_location(input.mesh, to_point(p)).first];
}

// That of the first source, or, if there is none, the largest one.
std::size_t component_of_sources(const Options& options, const Input_mesh& input)
{
  if(!options.sources.empty())
    return component_of_vertex(input, options.sources.front(), "--source");
  if(!options.source_points.empty())
    return component_of_point(input, options.source_points.front());
  if(!options.source_edges.empty())
    return component_of_vertex(input, options.source_edges.front().front(), "--source-edges");
  return input.largest_component;
}

// The vertex that is nearest from the direction given, or else farthest from the center.
Mesh::Vertex_index vertex_of_component(const Options& options, const Input_mesh& input, std::size_t component)
{
  const Mesh& mesh = input.mesh;
  std::vector<Mesh::Vertex_index> vertices;
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(component_at(input, mesh.halfedge(v)) == component)
    {
      vertices.push_back(v);
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
    }
  const Kernel::Vector_3 center = sum / double(vertices.size());
  const auto height = [&](Mesh::Vertex_index v)
  {
    const Kernel::Vector_3 from_center = mesh.point(v) - CGAL::ORIGIN - center;
    return options.from_view ? from_center * (to_point(*options.from_view) - CGAL::ORIGIN)
                             : from_center.squared_length();
  };
  return *std::max_element(vertices.begin(), vertices.end(),
                           [&](Mesh::Vertex_index a, Mesh::Vertex_index b) { return height(a) < height(b); });
}

// For a component without a source: a vertex, or the middle of a face there if the file has one vertex for several components.
void choose_source(Options& options, const Input_mesh& input, std::size_t component)
{
  const Mesh::Vertex_index v = vertex_of_component(options, input, component);
  options.sources = {input.number[v]};
  if(component_of_vertex(input, input.number[v], "--source") == component)
    return;
  const Mesh& mesh = input.mesh;
  const Mesh::Halfedge_index h = mesh.is_border(mesh.halfedge(v)) ? mesh.opposite(mesh.halfedge(v)) : mesh.halfedge(v);
  const Kernel::Point_3 p =
    CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  options.sources.clear();
  options.source_points = {{{p.x(), p.y(), p.z()}}};
}

// Of the component of the other sources, if there are any, or of the largest one.
Mesh_edges border_of_component(const Options& options, const Input_mesh& input)
{
  const Mesh& mesh = input.mesh;
  const std::size_t component = component_of_sources(options, input);
  Mesh_edges result;
  for(const Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e) && component_at(input, mesh.halfedge(e)) == component)
      result.push_back(e);
  if(result.empty())
    throw Usage_error("--source-border: there is no border, or another component of the mesh has it");
  return result;
}

// The edges of the mesh that the lines of the file name, and those of the border, in curves that are connected.
std::vector<Mesh_edges> source_curves(const Options& options, const Input_mesh& input)
{
  const Mesh& mesh = input.mesh;
  std::vector<Mesh::Edge_index> all;
  for(const auto& line : options.source_edges)
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const Mesh::Halfedge_index h =
        mesh.halfedge(find_vertex(line[i], input, "--source-edges"), find_vertex(line[i + 1], input, "--source-edges"));
      if(h == Mesh::null_halfedge())
        throw Usage_error("--source-edges: the mesh has no edge between the vertices " + std::to_string(line[i]) +
                          " and " + std::to_string(line[i + 1]));
      all.push_back(mesh.edge(h));
    }
  if(options.source_border)
  {
    const std::vector<Mesh::Edge_index> border = border_of_component(options, input);
    all.insert(all.end(), border.begin(), border.end());
  }
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> parent;
  const auto find = [&](Mesh::Vertex_index v)
  {
    for(auto p = parent.insert({v, v}).first; p->second != v; p = parent.find(v))
      v = p->second;
    return v;
  };
  for(const Mesh::Edge_index e : all)
    parent[find(mesh.vertex(e, 0))] = find(mesh.vertex(e, 1));
  std::map<Mesh::Vertex_index, std::size_t> number;
  std::vector<Mesh_edges> result;
  for(const Mesh::Edge_index e : all)
  {
    const auto found = number.insert({find(mesh.vertex(e, 0)), result.size()});
    if(found.second)
      result.emplace_back();
    result[found.first->second].push_back(e);
  }
  return result;
}

} // namespace

std::vector<Mesh_edges> set_source(const Options& options, const Input_mesh& input, Cut_locus_solver& solver)
{
  const Mesh& mesh = input.mesh;
  const auto parameters = CGAL::parameters::maximum_relative_error(options.maximum_relative_error.value_or(0.));
  std::vector<Cut_locus_solver::Source> sources;
  for(std::size_t source : options.sources)
    sources.push_back(find_vertex(source, input, "--source"));
  for(const auto& point : options.source_points)
    sources.push_back(closest_location(mesh, to_point(point)));
  if(has_curves(options))
  {
    const std::vector<Mesh_edges> curves = source_curves(options, input);
    solver.set_sources(sources, parameters.source_curves(curves));
    return curves;
  }
  if(!sources.empty())
  {
    solver.set_sources(sources, parameters);
    return {};
  }
  if(options.from_view)
  {
    solver.set_source(vertex_of_component(options, input, input.largest_component), parameters);
    return {};
  }
  // the first one in the order of the file
  const auto is_in_component = [&](Mesh::Vertex_index v)
  { return v != Mesh::null_vertex() && component_at(input, mesh.halfedge(v)) == input.largest_component; };
  solver.set_source(*std::find_if(input.vertex.begin(), input.vertex.end(), is_in_component), parameters);
  return {};
}

std::vector<Options> options_of_components(const Options& options, const Input_mesh& input)
{
  const std::size_t main = component_of_sources(options, input);
  std::vector<Options> of_component(input.component_size.size(), options);
  for(std::size_t c = 0; c < of_component.size(); ++c)
  {
    of_component[c].sources.clear();
    of_component[c].source_points.clear();
    if(c != main)
    {
      of_component[c].source_edges.clear();
      of_component[c].source_border = false;
    }
  }
  for(const std::size_t source : options.sources)
    of_component[component_of_vertex(input, source, "--source")].sources.push_back(source);
  for(const auto& point : options.source_points)
    of_component[component_of_point(input, point)].source_points.push_back(point);
  std::vector<Options> result = {of_component[main]};
  for(std::size_t c = 0; c < of_component.size(); ++c)
  {
    if(c == main || !(input.component_area[c] > 0.))
      continue;
    if(number_of_source_points(of_component[c]) == 0)
      choose_source(of_component[c], input, c);
    result.push_back(std::move(of_component[c]));
  }
  return result;
}

std::string moved_source_points(const Options& options, const Mesh& mesh, const Cut_locus& cut_locus)
{
  std::ostringstream result;
  for(std::size_t i = 0; i < options.source_points.size(); ++i)
  {
    const std::array<double, 3>& given = options.source_points[i];
    const Kernel::Point_3 found = cut_locus.source(options.sources.size() + i).point;
    const double moved = std::sqrt(CGAL::squared_distance(to_point(given), found)), edge = mean_edge_length(mesh);
    if(moved > edge)
      result << std::setprecision(9) << "note: --source-point " << given[0] << ',' << given[1] << ',' << given[2]
             << " is not on the surface: the source is " << std::setprecision(3) << moved << " away, at "
             << std::setprecision(9) << found.x() << ',' << found.y() << ',' << found.z()
             << "; edges have a mean length of " << std::setprecision(3) << edge << '\n';
  }
  return result.str();
}
