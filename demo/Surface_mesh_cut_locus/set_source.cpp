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

using Edges = std::vector<Mesh::Edge_index>;

Kernel::Point_3 to_point(const std::array<double, 3>& p)
{
  return Kernel::Point_3(p[0], p[1], p[2]);
}

// Of the component of the other sources, if there are any, or of the largest one.
Edges border_of_component(const Options& options, const Input_mesh& input, const Edges& curves)
{
  const Mesh& mesh = input.mesh;
  const auto component_at = [&](Mesh::Halfedge_index h)
  { return input.component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]; };
  std::size_t component = input.largest_component;
  if(!options.sources.empty())
    component = component_at(mesh.halfedge(find_vertex(options.sources.front(), input, "--source")));
  else if(!options.source_points.empty())
    component = input.component[closest_location(mesh, to_point(options.source_points.front())).first];
  else if(!curves.empty())
    component = component_at(mesh.halfedge(curves.front()));
  Edges result;
  for(const Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e) && component_at(mesh.halfedge(e)) == component)
      result.push_back(e);
  if(result.empty())
    throw Usage_error("--source-border: there is no border, or another component of the mesh has it");
  return result;
}

// The edges of the mesh that the lines of the file name, and those of the border, in curves that are connected.
std::vector<Edges> source_curves(const Options& options, const Input_mesh& input)
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
    const std::vector<Mesh::Edge_index> border = border_of_component(options, input, all);
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
  std::vector<Edges> result;
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

std::vector<Edges> set_source(const Options& options, const Input_mesh& input, Cut_locus_solver& solver)
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
    const std::vector<Edges> curves = source_curves(options, input);
    solver.set_sources(sources, parameters.source_curves(curves));
    return curves;
  }
  if(!sources.empty())
  {
    solver.set_sources(sources, parameters);
    return {};
  }
  // the first one in the order of the file
  const auto is_in_component = [&](Mesh::Vertex_index v)
  {
    if(v == Mesh::null_vertex())
      return false;
    const Mesh::Halfedge_index h = mesh.halfedge(v); // on the border if there is one
    const Mesh::Face_index f = h.is_valid() ? mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h) : Mesh::null_face();
    return f != Mesh::null_face() && input.component[f] == input.largest_component;
  };
  solver.set_source(*std::find_if(input.vertex.begin(), input.vertex.end(), is_in_component), parameters);
  return {};
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
