// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_SHORT_BRANCHES_H
#define CGAL_CUT_LOCI_GRAPH_SHORT_BRANCHES_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci {
namespace internal {

// A graph on a mesh as a core - its cycles, what has to stay, and what joins these - and the trees that hang on it. A part
// that else would have no core has its first node.
class Hanging_trees
{
public:
  struct Twig
  {
    Index edge, outer, inner; // an edge of the graph; its ends, of which the inner one is nearer to the core
    Index parent;             // the twig at the inner end, or null_index at the core
    double length;
  };

  // `face` is that of each edge; of edges of the mesh it may be empty. `stays` tells of each node whether it has to stay; if
  // it is empty, the border loops are what has to, each of which counts as one point.
  Hanging_trees(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                const Indexed_cut_locus& graph, const std::vector<Index>& face, const std::vector<unsigned char>& stays)
  {
    const Index n = static_cast<Index>(graph.nodes.size());
    const Index number_of_points = n + (stays.empty() ? connectivity.number_of_border_loops : 0);
    const auto point_of = [&](Index node)
    {
      const Index loop = stays.empty() ? border_loop(mesh, connectivity, graph.nodes[node]) : null_index;
      return loop == null_index ? node : n + loop;
    };
    const auto ends = [&](Index e) -> Edges_left::Nodes {
      return {{point_of(graph.edges[e].source), point_of(graph.edges[e].target)}};
    };
    Edges_left left(number_of_points, graph.edges.size(), ends);
    Union_find parts(number_of_points);
    std::vector<unsigned char> has_core(number_of_points, 0);
    std::vector<Index> in_core;
    for(Index p = 0; p < number_of_points; ++p)
      if(p >= n || (!stays.empty() && stays[p]))
        in_core.push_back(p);
    for(Index p : in_core)
      left.keep(p);
    for(Index e = 0; e < graph.edges.size(); ++e)
      if(!parts.unite(ends(e)[0], ends(e)[1]))
        in_core.push_back(ends(e)[0]);
    for(Index p : in_core)
      has_core[parts.find(p)] = 1;
    for(Index p = 0; p < n; ++p)
      if(!std::exchange(has_core[parts.find(p)], 1))
        left.keep(p);

    std::vector<Index> twig_at(number_of_points, null_index);
    left.peel(ends,
              [&](Index e, Index p)
              {
      twig_at[p] = static_cast<Index>(twigs_.size());
      const Index h = graph.edges[e].halfedge;
      const double l = h != null_index ? edge_length(mesh, h) : length(mesh, graph, graph.edges[e], face[e]);
      twigs_.push_back({e, p, Edges_left::other(ends(e), p), null_index, l});
      return true;
    });
    for(Twig& t : twigs_)
      t.parent = twig_at[t.inner];
  }

  // from the outside in: each after those that hang on it
  const std::vector<Twig>& twigs() const { return twigs_; }

  // the border loop that a node is on, or null_index
  static Index border_loop(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                           const Indexed_cut_locus::Node& node)
  {
    if(node.vertex != null_index)
      return connectivity.is_border(node.vertex) ? connectivity.border_loop[node.vertex] : null_index;
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * node.location.face + i;
      if(node.location.coordinates[(i + 2) % 3] == 0. && mesh.is_border_edge(h))
        return connectivity.border_loop[mesh.source(h)];
    }
    return null_index;
  }

private:
  // of a segment through a face, laid out in the plane: lengths may be all that there is
  static double length(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& graph,
                       const Indexed_cut_locus::Edge& e, Index face)
  {
    const std::array<Planar_vector, 3> corners = {
      {{{0., 0.}}, {{edge_length(mesh, 3 * face), 0.}}, apex(mesh, 3 * face)}};
    const auto position = [&](const Indexed_location& location)
    {
      Planar_vector result = {{0., 0.}};
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          if(mesh.triangles[location.face][i] == mesh.triangles[face][j])
            result = result + location.coordinates[i] * corners[j];
      return result;
    };
    return norm(position(graph.nodes[e.source].location) - position(graph.nodes[e.target].location));
  }

  std::vector<Twig> twigs_;
};

} // namespace internal

/*
 * tells for each edge of a graph whether it belongs to a branch of fewer than `minimum_edges` edges or one that is shorter
 * than `minimum_length`. Where branches meet, the longest one continues and the others end; at the cycles and at what has
 * to stay, which are never removed, all of them end. Time is nearly linear.
 *
 * @param face that each edge runs through; it may be empty if they are edges of the mesh
 * @param stays whether each node has to stay, with what joins it to others; if it is empty, the border has to, as far as
 *        the graph meets it, and else the first node of a tree
 */
inline std::vector<unsigned char> short_branches(const Indexed_triangle_mesh& mesh,
                                                 const Mesh_connectivity& connectivity, const Indexed_cut_locus& graph,
                                                 const std::vector<Index>& face, Index minimum_edges,
                                                 double minimum_length, const std::vector<unsigned char>& stays)
{
  std::vector<unsigned char> result(graph.edges.size(), 0);
  const internal::Hanging_trees trees(mesh, connectivity, graph, face, stays);
  const auto& twigs = trees.twigs();
  struct Height
  {
    double length = 0.;
    Index edges = 0;
  };
  std::vector<Height> branch(twigs.size());
  std::vector<Index> continuation(twigs.size(), null_index); // the twig that continues each one outward
  for(std::size_t i = 0; i < twigs.size(); ++i)
  {
    const Height behind = continuation[i] == null_index ? Height() : branch[continuation[i]];
    branch[i] = {behind.length + twigs[i].length, behind.edges + 1};
    const Index p = twigs[i].parent;
    if(p != null_index && (continuation[p] == null_index || branch[i].length > branch[continuation[p]].length))
      continuation[p] = static_cast<Index>(i);
  }
  for(std::size_t i = twigs.size(); i-- > 0;)
  {
    const Index p = twigs[i].parent;
    const bool ends = p == null_index || continuation[p] != i;
    const bool is_short = branch[i].edges < minimum_edges || branch[i].length < minimum_length;
    result[twigs[i].edge] = (ends && is_short) || (p != null_index && result[twigs[p].edge] != 0);
  }
  return result;
}

// removes edges from a graph, and the nodes that have no edge then. If all edges are removed, one node stays: the first
// one, or one on the border, if there is any.
inline void remove_edges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                         Indexed_cut_locus& graph, const std::vector<unsigned char>& is_removed)
{
  std::vector<Index> new_node(graph.nodes.size(), null_index);
  std::vector<Indexed_cut_locus::Edge> edges;
  for(std::size_t i = 0; i < graph.edges.size(); ++i)
    if(!is_removed[i])
    {
      edges.push_back(graph.edges[i]);
      new_node[graph.edges[i].source] = new_node[graph.edges[i].target] = 0;
    }
  if(edges.empty())
  {
    const auto on_border = std::find_if(graph.nodes.begin(), graph.nodes.end(),
                                        [&](const Indexed_cut_locus::Node& node) {
      return internal::Hanging_trees::border_loop(mesh, connectivity, node) != null_index;
    });
    new_node[on_border == graph.nodes.end() ? 0 : static_cast<std::size_t>(on_border - graph.nodes.begin())] = 0;
  }
  Index size = 0;
  for(Index i = 0; i < graph.nodes.size(); ++i)
    if(new_node[i] != null_index)
    {
      graph.nodes[size] = graph.nodes[i];
      new_node[i] = size++;
    }
  graph.nodes.resize(size);
  for(Indexed_cut_locus::Edge& e : edges)
  {
    e.source = new_node[e.source];
    e.target = new_node[e.target];
  }
  graph.edges = std::move(edges);
}

// removes what `short_branches()` tells.
inline void remove_short_branches(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                  const std::vector<Index>& face, Index minimum_edges, double minimum_length,
                                  Indexed_cut_locus& graph, const std::vector<unsigned char>& stays = {})
{
  if(!graph.edges.empty() && (minimum_edges > 1 || minimum_length > 0.))
    remove_edges(mesh, connectivity, graph,
                 short_branches(mesh, connectivity, graph, face, minimum_edges, minimum_length, stays));
}

// removes the part of the cut locus of several sources that is not asked for
inline void remove_other_parts(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Kept_part part,
                               Indexed_cut_locus& graph)
{
  if(part == Kept_part::ALL)
    return;
  std::vector<unsigned char> is_removed;
  for(const Indexed_cut_locus::Edge& e : graph.edges)
    is_removed.push_back((e.sources[0] == e.sources[1]) == (part == Kept_part::VORONOI));
  remove_edges(mesh, connectivity, graph, is_removed);
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_GRAPH_SHORT_BRANCHES_H
