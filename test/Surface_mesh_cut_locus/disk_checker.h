// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DISK_CHECKER_H
#define CGAL_CUT_LOCI_DISK_CHECKER_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Checks that a model of FaceListGraph is one disk by walking over it; shares no code with the library.
namespace disk_checker {

struct Counts
{
  long vertices = 0, edges = 0, faces = 0, border_loops = 0, parts = 0;
  bool has_double_edges = false;
};

template <typename Graph>
Counts count(const Graph& graph)
{
  using Traits = boost::graph_traits<Graph>;
  using Halfedge = typename Traits::halfedge_descriptor;
  Counts result;
  result.vertices = std::distance(vertices(graph).begin(), vertices(graph).end());
  result.faces = std::distance(faces(graph).begin(), faces(graph).end());

  std::map<typename Traits::vertex_descriptor, int> index;
  for(auto v : vertices(graph))
    index.emplace(v, static_cast<int>(index.size()));
  std::set<std::pair<int, int>> ends;
  std::set<Halfedge> seen;
  for(auto f : faces(graph))
    for(Halfedge h : CGAL::halfedges_around_face(halfedge(f, graph), graph))
    {
      const Halfedge o = opposite(h, graph);
      if(CGAL::is_border(o, graph))
      {
        if(seen.insert(o).second)
        {
          ++result.border_loops;
          for(Halfedge k = next(o, graph); k != o; k = next(k, graph))
            seen.insert(k);
        }
      }
      if(seen.insert(h).second)
      {
        seen.insert(o);
        ++result.edges;
        const int a = index.at(source(h, graph)), b = index.at(target(h, graph));
        result.has_double_edges |= !ends.insert(std::minmax(a, b)).second;
      }
    }

  std::set<typename Traits::face_descriptor> reached;
  for(auto seed : faces(graph))
  {
    if(!reached.insert(seed).second)
      continue;
    ++result.parts;
    std::vector<typename Traits::face_descriptor> stack(1, seed);
    while(!stack.empty())
    {
      const auto f = stack.back();
      stack.pop_back();
      for(Halfedge h : CGAL::halfedges_around_face(halfedge(f, graph), graph))
        if(!CGAL::is_border(opposite(h, graph), graph) && reached.insert(face(opposite(h, graph), graph)).second)
          stack.push_back(face(opposite(h, graph), graph));
    }
  }
  return result;
}

// The first thing that is wrong with a disk, or an empty string. In a disk each vertex is on one fan of faces: a vertex
// with several would have to be counted as several for the Euler characteristic of a connected surface with one border
// loop to be 1.
template <typename Graph>
std::string fault(const Graph& graph)
{
  const Counts c = count(graph);
  std::ostringstream out;
  if(c.parts != 1)
    out << c.parts << " parts; ";
  if(c.border_loops != 1)
    out << c.border_loops << " border loops; ";
  if(c.vertices - c.edges + c.faces != 1)
    out << "the Euler characteristic is " << c.vertices - c.edges + c.faces << "; ";
  if(c.has_double_edges)
    out << "two edges have the same ends; ";
  return out.str();
}

} // namespace disk_checker

#endif // CGAL_CUT_LOCI_DISK_CHECKER_H
