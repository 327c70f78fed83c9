// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TOPOLOGY_CHECKER_H
#define CGAL_CUT_LOCI_TOPOLOGY_CHECKER_H

#include "Union_find.h"
#include "test_meshes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Checks what a cut locus must be from the triangles and the set of cut edges alone; shares no code with the library.
namespace topology_checker {

using curve_measures::Union_find;
using test_meshes::Triangle;
using Edge = std::pair<std::size_t, std::size_t>; // the smaller vertex first
using Edges = std::set<Edge>;

inline Edge make_edge(std::size_t a, std::size_t b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

// A component of a surface and how its faces are glued.
class Surface
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  // the edge-connected component of face `seed`
  Surface(const std::vector<Triangle>& triangles, std::size_t seed)
  {
    std::map<Edge, std::vector<std::size_t>> faces_at;
    for(std::size_t f = 0; f < triangles.size(); ++f)
      for(int i = 0; i < 3; ++i)
        faces_at[make_edge(triangles[f][i], triangles[f][(i + 1) % 3])].push_back(f);
    Union_find components(triangles.size());
    for(const auto& e : faces_at)
      for(std::size_t f : e.second)
        components.unite(f, e.second.front());
    for(std::size_t f = 0; f < triangles.size(); ++f)
      if(components.find(f) == components.find(seed))
        faces.push_back(triangles[f]);

    std::map<Edge, std::vector<std::size_t>> halfedges_at;
    for(std::size_t h = 0; h < 3 * faces.size(); ++h)
      halfedges_at[edge(h)].push_back(h);
    opposite.assign(3 * faces.size(), std::size_t(none));
    for(const auto& e : halfedges_at)
    {
      edges.insert(e.first);
      if(e.second.size() == 2)
      {
        opposite[e.second[0]] = e.second[1];
        opposite[e.second[1]] = e.second[0];
      }
      else
        border_edges.insert(e.first);
    }
    for(const Triangle& t : faces)
      vertices.insert(t.begin(), t.end());

    // border loops, by the vertices that border edges join
    for(const Edge& e : border_edges)
      for(std::size_t v : {e.first, e.second})
        if(!loop_of_vertex.count(v))
        {
          std::vector<std::size_t> stack(1, v);
          loop_of_vertex[v] = number_of_loops;
          while(!stack.empty())
          {
            const std::size_t w = stack.back();
            stack.pop_back();
            for(std::size_t h = 0; h < opposite.size(); ++h)
              if(opposite[h] == none && (source(h) == w || target(h) == w))
                for(std::size_t x : {source(h), target(h)})
                  if(loop_of_vertex.emplace(x, number_of_loops).second)
                    stack.push_back(x);
          }
          ++number_of_loops;
        }
  }

  std::size_t source(std::size_t h) const { return faces[h / 3][h % 3]; }
  std::size_t target(std::size_t h) const { return faces[h / 3][(h % 3 + 1) % 3]; }
  Edge edge(std::size_t h) const { return make_edge(source(h), target(h)); }
  long euler_characteristic() const { return long(vertices.size()) - long(edges.size()) + long(faces.size()); }
  long genus() const { return (2 - euler_characteristic() - long(number_of_loops)) / 2; }

  std::vector<Triangle> faces;
  std::vector<std::size_t> opposite; // of halfedge 3 f + i, from corner i of face f
  std::set<std::size_t> vertices;
  Edges edges, border_edges;
  std::map<std::size_t, std::size_t> loop_of_vertex;
  std::size_t number_of_loops = 0;
};

struct Cut
{
  Edges edges;          // edges of the mesh, those on the border included
  std::size_t root = 0; // a vertex, on the cut locus also where that has no edge
};

// The first thing that is wrong for a complement of that many open disks, or an empty string.
inline std::string fault(const Surface& surface, const Cut& cut, std::size_t disks = 1)
{
  std::ostringstream out;
  for(const Edge& e : cut.edges)
    if(!surface.edges.count(e))
    {
      out << "edge " << e.first << " - " << e.second << " is not an edge of the component";
      return out.str();
    }

  // The graph, with each border loop as one node.
  std::map<std::size_t, std::size_t> node;
  const auto node_of = [&](std::size_t v)
  {
    const auto loop = surface.loop_of_vertex.find(v);
    const std::size_t key = loop == surface.loop_of_vertex.end() ? surface.number_of_loops + v : loop->second;
    return node.emplace(key, node.size()).first->second;
  };
  for(const auto& v : surface.loop_of_vertex)
    node_of(v.first);
  node_of(cut.root);
  std::vector<std::pair<std::size_t, std::size_t>> arcs;
  for(const Edge& e : cut.edges)
    if(!surface.border_edges.count(e))
      arcs.emplace_back(node_of(e.first), node_of(e.second));
  Union_find graph(node.size());
  std::size_t components = node.size();
  for(const auto& a : arcs)
    components -= graph.unite(a.first, a.second) ? 1 : 0;
  if(components != 1)
  {
    out << "the graph has " << components << " components";
    return out.str();
  }
  const long cycles = long(arcs.size()) - long(node.size()) + 1;
  if(cycles != 2 * surface.genus() - 1 + long(disks))
  {
    out << "the graph has " << cycles << " independent cycles on a surface of genus " << surface.genus();
    return out.str();
  }

  // The surface cut open: corners of faces are the same vertex if an edge that is not cut joins them.
  const auto is_open = [&](std::size_t h)
  { return surface.opposite[h] == Surface::none || cut.edges.count(surface.edge(h)) != 0; };
  const auto next = [](std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
  const std::size_t nh = surface.opposite.size();
  Union_find corners(nh), faces(surface.faces.size());
  std::size_t parts = surface.faces.size(), open_halfedges = 0;
  long number_of_vertices = long(nh), number_of_edges = 0;
  for(std::size_t h = 0; h < nh; ++h)
  {
    if(is_open(h))
    {
      ++open_halfedges;
      ++number_of_edges;
      continue;
    }
    const std::size_t o = surface.opposite[h];
    if(o < h)
      continue;
    ++number_of_edges;
    parts -= faces.unite(h / 3, o / 3) ? 1 : 0;
    number_of_vertices -= corners.unite(h, next(o)) ? 1 : 0;
    number_of_vertices -= corners.unite(next(h), o) ? 1 : 0;
  }
  if(parts != disks)
  {
    out << "the complement has " << parts << " parts";
    return out.str();
  }
  const long euler = number_of_vertices - number_of_edges + long(surface.faces.size());

  if(open_halfedges == 0)
  {
    // a closed surface without its root
    if(euler != 2)
      out << "the complement of the root alone is not a disk: Euler characteristic " << euler - 1;
    return out.str();
  }
  if(euler != long(disks))
  {
    out << "the surface cut open has Euler characteristic " << euler << " instead of " << disks;
    return out.str();
  }
  if(disks > 1) // a connected surface with a border has at most 1: each part has that
    return out.str();
  std::size_t first = 0, length = 0;
  while(!is_open(first))
    ++first;
  for(std::size_t h = first; length == 0 || h != first; ++length)
  {
    h = next(h);
    while(!is_open(h))
      h = next(surface.opposite[h]);
  }
  if(length != open_halfedges)
    out << "the surface cut open has more than one boundary loop";
  return out.str();
}

// The first way in which the cut passes through the source, or an empty string. `corners` are the vertices whose
// barycentric coordinates are not zero: one, two or three.
inline std::string fault_at_source(const Surface& surface, const Cut& cut, const std::vector<std::size_t>& corners)
{
  if(corners.size() == 1)
  {
    if(cut.root == corners[0])
      return "the source is the root";
    for(const Edge& e : cut.edges)
      if(!surface.border_edges.count(e) && (e.first == corners[0] || e.second == corners[0]))
        return "the source is on the cut locus";
  }
  if(corners.size() == 2 && cut.edges.count(make_edge(corners[0], corners[1])) &&
     !surface.border_edges.count(make_edge(corners[0], corners[1])))
    return "the edge of the source is on the cut locus";
  return std::string();
}

} // namespace topology_checker

#endif // CGAL_CUT_LOCI_TOPOLOGY_CHECKER_H
