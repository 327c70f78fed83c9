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
#include <unordered_map>
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

// The trees as branches: where several meet, the longest one continues and the others end, and all of them at the core. Of
// those that are equally long it is the one that has the lower node.
struct Ending_branches
{
  std::vector<Index> first;     // their innermost twigs; the longest branch first, so that each hangs on one before it
  std::vector<double> length;   // from the inner end of each twig to the tip
  std::vector<Index> continued; // the next twig outward

  explicit Ending_branches(const std::vector<Hanging_trees::Twig>& twigs)
    : length(twigs.size(), 0.), continued(twigs.size(), null_index)
  {
    const auto is_before = [&](Index i, Index j)
    { return std::make_pair(-length[i], twigs[i].outer) < std::make_pair(-length[j], twigs[j].outer); };
    for(Index i = 0; i < twigs.size(); ++i)
    {
      length[i] = twigs[i].length + (continued[i] == null_index ? 0. : length[continued[i]]);
      const Index p = twigs[i].parent;
      if(p != null_index && (continued[p] == null_index || is_before(i, continued[p])))
        continued[p] = i;
    }
    for(Index i = 0; i < twigs.size(); ++i)
      if(const Index p = twigs[i].parent; p == null_index || continued[p] != i)
        first.push_back(i);
    std::sort(first.begin(), first.end(), is_before);
  }
};

// How many edges of the mesh lead from a vertex to the nearest of some others, which are added one after the other; at most
// a number of them, up to which they are counted.
class Vertices_around
{
public:
  Vertices_around(const Mesh_connectivity& connectivity, Index most) : connectivity_(connectivity), most_(most) {}

  Index number_of_edges_to(Index v) const
  {
    const auto found = number_.find(v);
    return found == number_.end() ? most_ : found->second;
  }

  void add(const std::vector<Index>& vertices)
  {
    std::vector<Index> front, next;
    for(Index v : vertices)
      visit(v, 0, front);
    for(Index n = 1; n < most_ && !front.empty(); ++n)
    {
      next.clear();
      for(Index u : front)
        for(Index k = connectivity_.ring_begin[u]; k < connectivity_.ring_begin[u + 1]; ++k)
          visit(connectivity_.ring_vertex[k], n, next);
      front.swap(next);
    }
  }

private:
  void visit(Index v, Index n, std::vector<Index>& front)
  {
    const auto inserted = number_.emplace(v, n);
    if(!inserted.second && inserted.first->second <= n)
      return;
    inserted.first->second = n;
    front.push_back(v);
  }

  const Mesh_connectivity& connectivity_;
  Index most_;
  std::unordered_map<Index, Index> number_; // of what is nearer
};

// what trees hang on, in a graph of mesh edges
inline std::vector<Index> vertices_of_core(const Indexed_cut_locus& graph,
                                           const std::vector<Hanging_trees::Twig>& twigs)
{
  std::vector<unsigned char> hangs(graph.nodes.size(), 0);
  for(const Hanging_trees::Twig& t : twigs)
    hangs[t.outer] = 1;
  std::vector<Index> result;
  for(std::size_t i = 0; i < hangs.size(); ++i)
    if(!hangs[i])
      result.push_back(graph.nodes[i].vertex);
  return result;
}

} // namespace internal

/*
 * tells for each edge of a graph whether it belongs to a branch that is too short. Where branches meet, the longest one
 * continues and the others end; at the cycles and at what has to stay, which are never removed, all of them end.
 *
 * One is too short if it is shorter than `minimum_length` or has fewer than `minimum_edges` edges. If these are edges of
 * the mesh, they are those by which it leads away from longer ones: beside the cut locus gradients differ as they do on it,
 * so that what runs along it is none, however long it is. Time is nearly linear for a small number.
 *
 * @param face that each edge runs through; it is empty if they are edges of the mesh
 * @param stays whether each node has to stay, with what joins it to others; if it is empty, the border has to, as far as
 *        the graph meets it, and else the first node of a tree
 */
inline std::vector<unsigned char> short_branches(const Indexed_triangle_mesh& mesh,
                                                 const Mesh_connectivity& connectivity, const Indexed_cut_locus& graph,
                                                 const std::vector<Index>& face, Index minimum_edges,
                                                 double minimum_length, const std::vector<unsigned char>& stays)
{
  using namespace internal;
  const Hanging_trees trees(mesh, connectivity, graph, face, stays);
  const auto& twigs = trees.twigs();
  const Ending_branches branches(twigs);
  std::vector<unsigned char> result(graph.edges.size(), 0);
  for(const Hanging_trees::Twig& t : twigs)
    result[t.edge] = 1; // until it is found to be long enough
  Vertices_around longer(connectivity, minimum_edges);
  if(face.empty())
    longer.add(vertices_of_core(graph, twigs));
  for(const Index first : branches.first)
  {
    const Index p = twigs[first].parent;
    if((p != null_index && result[twigs[p].edge] != 0) || branches.length[first] < minimum_length)
      continue;
    Index number = 0;
    std::vector<Index> vertices;
    for(Index i = first; i != null_index; i = branches.continued[i])
    {
      vertices.push_back(graph.nodes[twigs[i].outer].vertex);
      number = face.empty() ? (std::max)(number, longer.number_of_edges_to(vertices.back())) : number + 1;
    }
    if(number < minimum_edges)
      continue;
    for(Index i = first; i != null_index; i = branches.continued[i])
      result[twigs[i].edge] = 0;
    if(face.empty())
      longer.add(vertices);
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
