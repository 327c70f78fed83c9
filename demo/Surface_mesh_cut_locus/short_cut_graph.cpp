// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace {

constexpr double infinite_length = (std::numeric_limits<double>::infinity)();

struct Cut_graph
{
  double length = 0.;
  std::vector<Mesh::Vertex_index> vertices;
};

double length(const Mesh& mesh, Mesh::Edge_index e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

// The shortest loops from `base` that cut the mesh open: each goes over an edge that is neither in a tree of shortest
// paths nor crossed by a spanning tree of the faces, which takes the edges of the longest loops.
Cut_graph shortest_loops(const Mesh& mesh, Mesh::Vertex_index base, const std::vector<bool>& is_in_component)
{
  std::vector<double> distance(mesh.number_of_vertices(), infinite_length);
  std::vector<Mesh::Halfedge_index> from(mesh.number_of_vertices(), Mesh::null_halfedge()); // halfedge towards it
  using Entry = std::pair<double, Mesh::Vertex_index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  distance[base] = 0.;
  queue.push({0., base});
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    if(top.first > distance[top.second])
      continue;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(top.second)))
    {
      const Mesh::Vertex_index v = mesh.source(h);
      const double d = top.first + length(mesh, mesh.edge(h));
      if(d < distance[v])
      {
        distance[v] = d;
        from[v] = mesh.opposite(h);
        queue.push({d, v});
      }
    }
  }

  std::vector<std::pair<double, Mesh::Edge_index>> loops;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Vertex_index u = mesh.vertex(e, 0), v = mesh.vertex(e, 1);
    if(!is_in_component[mesh.face(mesh.halfedge(e))] || (from[u] != Mesh::null_halfedge() && mesh.edge(from[u]) == e) ||
       (from[v] != Mesh::null_halfedge() && mesh.edge(from[v]) == e))
      continue;
    loops.push_back({distance[u] + distance[v] + length(mesh, e), e});
  }
  std::sort(loops.begin(), loops.end(), std::greater<std::pair<double, Mesh::Edge_index>>());
  std::vector<std::size_t> parent(mesh.number_of_faces());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto find = [&](std::size_t f)
  {
    while(parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  Cut_graph result;
  std::vector<bool> is_taken(mesh.number_of_vertices(), false);
  for(const auto& loop : loops)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(loop.second);
    const std::size_t f = find(mesh.face(h)), g = find(mesh.face(mesh.opposite(h)));
    parent[f] = g;
    if(f != g)
      continue;
    result.length += length(mesh, loop.second);
    for(Mesh::Vertex_index v : {mesh.source(h), mesh.target(h)})
      while(!is_taken[v])
      {
        is_taken[v] = true;
        result.vertices.push_back(v);
        if(from[v] == Mesh::null_halfedge())
          break;
        result.length += length(mesh, mesh.edge(from[v]));
        v = mesh.source(from[v]);
      }
  }
  return result;
}

} // namespace

std::optional<double> distance_to_short_cut_graph(const Mesh& mesh, const Cut_locus& cut_locus)
{
  if(cut_locus.genus() == 0 || cut_locus.number_of_border_loops() > 0)
    return std::nullopt;
  std::vector<bool> is_in_component(mesh.number_of_faces(), false);
  std::vector<Mesh::Vertex_index> component;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(std::isfinite(cut_locus.distance(v)))
    {
      component.push_back(v);
      for(Mesh::Face_index f : mesh.faces_around_target(mesh.halfedge(v)))
        is_in_component[f] = true;
    }
  constexpr std::size_t trials = 16;
  Cut_graph best;
  best.length = infinite_length;
  for(std::size_t i = 0; i < trials; ++i)
  {
    Cut_graph graph = shortest_loops(mesh, component[i * component.size() / trials], is_in_component);
    if(graph.length < best.length)
      best = std::move(graph);
  }
  double result = infinite_length;
  for(Mesh::Vertex_index v : best.vertices)
    result = (std::min)(result, cut_locus.distance(v));
  return result;
}
