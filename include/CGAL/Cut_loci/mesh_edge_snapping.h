// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_MESH_EDGE_SNAPPING_H
#define CGAL_CUT_LOCI_MESH_EDGE_SNAPPING_H

#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>
#include <CGAL/Cut_loci/direction_pruning.h>
#include <CGAL/Cut_loci/direction_tree.h>
#include <CGAL/Cut_loci/internal/Geodesic_fronts.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is the cut locus made of edges of the mesh: each crossing of a `Direction_branches` moves to the nearer end of its
 * edge, and consecutive ones, which are in one face, are joined.
 *
 * Branches that come to lie on each other may enclose faces: weakest edges first, those with different pieces of the
 * complement on their sides are removed, so that it is one open disk again. As for `Direction_branches`, the strength
 * below which each branch is kept is stored, and a threshold is answered in time proportional to the result.
 */
class Mesh_edge_branches
{
public:
  Mesh_edge_branches() = default;

  Mesh_edge_branches(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Direction_geometry& geometry, const Direction_field& field,
                     const Direction_branches& branches, Index farthest)
  {
    const std::vector<Snap> snaps = snap(mesh, connectivity, geometry, field, branches);
    std::vector<Piece> pieces = join(mesh, connectivity, branches, snaps);
    make_complement_connected(mesh, connectivity, pieces);
    number_nodes(mesh, connectivity, field, pieces, snaps, farthest);
    order_edges(mesh, connectivity, pieces, branches, snaps);
  }

  /// the vertex at which the tree of branches starts; one of the cycles, if there are any
  Index root() const { return lone_vertex_; }

  /// the graph at `threshold`, its root first, as `Indexed_cut_locus::nodes` and `edges`
  Indexed_cut_locus operator()(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                               const Direction_field& field, double threshold) const
  {
    std::vector<Index> kept; // branches, from the inside out
    for(Index first : first_branches_)
      if(edges_[first].strength >= threshold)
        kept.push_back(first);
    for(std::size_t i = 0; i < kept.size(); ++i)
      for(Index c = child_begin_[kept[i]]; c < child_begin_[kept[i] + 1]; ++c)
        if(edges_[children_[c]].strength >= threshold)
          kept.push_back(children_[c]);

    // A leaf that is no end of a branch is a step aside.
    std::vector<std::pair<Index, Index>> stays; // outer nodes, with the number of their children
    std::vector<Index> position_of_parent(kept.size(), null_index);
    stays.reserve(kept.size());
    for(Index i : kept)
      stays.push_back({edges_[i].outer, 0});
    std::vector<std::pair<Index, Index>> by_outer;
    by_outer.reserve(kept.size());
    for(std::size_t i = 0; i < kept.size(); ++i)
      by_outer.push_back({edges_[kept[i]].outer, static_cast<Index>(i)});
    std::sort(by_outer.begin(), by_outer.end());
    for(std::size_t i = 0; i < kept.size(); ++i)
    {
      const auto found =
        std::lower_bound(by_outer.begin(), by_outer.end(), std::make_pair(edges_[kept[i]].inner, Index(0)));
      if(found != by_outer.end() && found->first == edges_[kept[i]].inner)
      {
        position_of_parent[i] = found->second;
        ++stays[found->second].second;
      }
    }
    // Snapping makes such steps of one or two edges; what is longer is a branch that has lost its end.
    constexpr Index longest_step = 2;
    std::vector<Index> removed(kept.size(), 0); // how many edges end with this one
    for(std::size_t i = kept.size(); i-- > 0;)
    {
      if(stays[i].second > 0 || is_end(stays[i].first, threshold))
      {
        removed[i] = 0;
        continue;
      }
      ++removed[i];
      const Index p = position_of_parent[i];
      if(p != null_index)
      {
        --stays[p].second;
        removed[p] = (std::max)(removed[p], removed[i]);
      }
    }
    std::vector<unsigned char> is_removed(kept.size(), 0);
    for(std::size_t i = 0; i < kept.size(); ++i)
    {
      const Index p = position_of_parent[i];
      const bool is_continued = p != null_index && removed[p] > longest_step && !is_removed[p];
      is_removed[i] = removed[i] > 0 && removed[i] <= longest_step && !is_continued;
      if(is_continued && removed[i] > 0 && removed[i] + 1 >= removed[p])
        removed[i] = longest_step + 1; // stays with the branch
    }

    std::vector<Index> selected;
    for(Index i = 0; i < number_of_core_edges_; ++i)
      selected.push_back(i);
    for(std::size_t i = 0; i < kept.size(); ++i)
      if(!is_removed[i])
        selected.push_back(kept[i]);
    return graph(mesh, connectivity, field, selected);
  }

private:
  struct Snap
  {
    Index vertex;
    float strength, next_strength; // of the crossing, and of the strongest one that follows it outward
  };
  struct Piece
  {
    Index edge, halfedge;
    float strength;
  };
  struct Edge
  {
    Index outer, inner; // groups: vertices of the graph, and one for each border loop
    Index halfedge;
    float strength; // the largest behind it
  };

  static std::vector<Snap> snap(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                const Direction_geometry& geometry, const Direction_field& field,
                                const Direction_branches& branches)
  {
    const internal::Geodesic_fronts fronts(mesh, connectivity, geometry, field);
    std::vector<Snap> result;
    std::vector<std::pair<Index, Index>> by_outer;
    for(const Direction_branches::Edge& e : branches.edges())
    {
      const internal::Geodesic_fronts::Crossing c = fronts.crossing(e.edge);
      result.push_back({c.part < 0.5 ? mesh.source(c.halfedge) : mesh.target(c.halfedge), e.strength, 0.f});
      by_outer.push_back({e.outer, static_cast<Index>(by_outer.size())});
    }
    const std::size_t core = branches.number_of_core_edges();
    by_outer.erase(by_outer.begin(), by_outer.begin() + static_cast<std::ptrdiff_t>(core));
    std::sort(by_outer.begin(), by_outer.end());
    for(std::size_t i = core; i < result.size(); ++i)
    {
      const Index inner = branches.edges()[i].inner;
      const auto found = std::lower_bound(by_outer.begin(), by_outer.end(), std::make_pair(inner, Index(0)));
      if(found != by_outer.end() && found->first == inner)
        result[found->second].next_strength = (std::max)(result[found->second].next_strength, result[i].strength);
    }
    // a crossing of the cycles is never an end
    for(std::size_t i = 0; i < core; ++i)
      result[i].next_strength = result[i].strength;
    return result;
  }

  static std::vector<Piece> join(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                 const Direction_branches& branches, const std::vector<Snap>& snaps)
  {
    std::vector<std::pair<Index, Index>> by_face;
    for(std::size_t i = 0; i < snaps.size(); ++i)
      for(Index f : {branches.edges()[i].outer, branches.edges()[i].inner})
        if(f < mesh.number_of_faces())
          by_face.push_back({f, static_cast<Index>(i)});
    std::sort(by_face.begin(), by_face.end());

    std::vector<Piece> result;
    const auto add = [&](Index f, const Snap& a, const Snap& b)
    {
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if((mesh.source(h) == a.vertex && mesh.target(h) == b.vertex) ||
           (mesh.source(h) == b.vertex && mesh.target(h) == a.vertex))
          if(!mesh.is_border_edge(h)) // the border counts as a point
            result.push_back({connectivity.edge_of_halfedge[h], h, (std::min)(a.strength, b.strength)});
    };
    for(std::size_t i = 0; i < by_face.size();)
    {
      std::size_t end = i;
      while(end < by_face.size() && by_face[end].first == by_face[i].first)
        ++end;
      const Index f = by_face[i].first;
      const auto at = [&](std::size_t k) { return snaps[by_face[i + k].second]; };
      if(end - i == 2)
        add(f, at(0), at(1));
      else if(end - i == 3)
      {
        // Any two of the three edges join three snaps; the two shorter of them do it best.
        std::array<std::size_t, 3> order = {{0, 1, 2}}; // order[k]: the edge between snaps k and k + 1
        const auto squared_length = [&](std::size_t k)
        {
          using namespace internal;
          const Vector d = mesh.points[at(k).vertex] - mesh.points[at((k + 1) % 3).vertex];
          return dot(d, d);
        };
        std::sort(order.begin(), order.end(),
                  [&](std::size_t j, std::size_t k) { return squared_length(j) < squared_length(k); });
        for(std::size_t k = 0; k < 2; ++k)
          add(f, at(order[k]), at((order[k] + 1) % 3));
      }
      i = end;
    }
    std::sort(result.begin(), result.end(),
              [](const Piece& a, const Piece& b)
              { return a.edge != b.edge ? a.edge < b.edge : a.strength > b.strength; });
    result.erase(
      std::unique(result.begin(), result.end(), [](const Piece& a, const Piece& b) { return a.edge == b.edge; }),
      result.end());
    return result;
  }

  static void make_complement_connected(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                        std::vector<Piece>& pieces)
  {
    std::vector<unsigned char> is_piece(connectivity.number_of_edges(), 0);
    for(const Piece& p : pieces)
      is_piece[p.edge] = 1;
    std::vector<Index> parent(mesh.number_of_faces());
    for(Index f = 0; f < parent.size(); ++f)
      parent[f] = f;
    const auto find = [&](Index f)
    {
      while(parent[f] != f)
        f = parent[f] = parent[parent[f]];
      return f;
    };
    const auto unite = [&](Index h)
    {
      if(mesh.is_border_edge(h))
        return false;
      const Index a = find(h / 3), b = find(mesh.opposite[h] / 3);
      parent[(std::max)(a, b)] = (std::min)(a, b);
      return a != b;
    };
    for(Index e = 0; e < connectivity.number_of_edges(); ++e)
      if(!is_piece[e])
        unite(connectivity.halfedge_of_edge[e]);
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& a, const Piece& b)
              { return a.strength != b.strength ? a.strength < b.strength : a.edge < b.edge; });
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return unite(p.halfedge); }),
                 pieces.end());
  }

  Index group(const Mesh_connectivity& connectivity, Index v) const
  {
    if(connectivity.is_border(v))
      return static_cast<Index>(vertices_.size()) + connectivity.border_loop[v];
    return static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  }

  void number_nodes(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const Direction_field& field, const std::vector<Piece>& pieces, const std::vector<Snap>& snaps,
                    Index farthest)
  {
    lone_vertex_ = snaps.empty() ? farthest : snaps.front().vertex;
    if(snaps.empty() && !connectivity.border_loop.empty())
      // All that is left is the border: its farthest vertex stands for it.
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        if(connectivity.is_border(v) && (!connectivity.is_border(lone_vertex_) ||
                                         field.vertices[v].distance > field.vertices[lone_vertex_].distance))
          lone_vertex_ = v;
    const auto add = [&](Index v)
    {
      if(!connectivity.is_border(v))
        vertices_.push_back(v);
    };
    add(lone_vertex_);
    for(const Piece& p : pieces)
    {
      add(mesh.source(p.halfedge));
      add(mesh.target(p.halfedge));
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  // Leaves fall off, as for the graph of the faces.
  void order_edges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const std::vector<Piece>& pieces, const Direction_branches& branches, const std::vector<Snap>& snaps)
  {
    const Index n = static_cast<Index>(vertices_.size()) + connectivity.number_of_border_loops;
    std::vector<Index> degree(n, 0), exclusive_or(n, 0);
    std::vector<std::array<Index, 2>> ends(pieces.size());
    for(Index i = 0; i < pieces.size(); ++i)
    {
      ends[i] = {
        {group(connectivity, mesh.source(pieces[i].halfedge)), group(connectivity, mesh.target(pieces[i].halfedge))}};
      for(Index g : ends[i])
      {
        ++degree[g];
        exclusive_or[g] ^= i;
      }
    }
    for(Index g = static_cast<Index>(vertices_.size()); g < n; ++g)
      degree[g] += 2;
    if(branches.number_of_core_edges() == 0 && connectivity.number_of_border_loops == 0)
      degree[group(connectivity, lone_vertex_)] += 2; // the root of a tree

    std::vector<Index> stack;
    std::vector<unsigned char> is_branch(pieces.size(), 0);
    std::vector<Edge> peeled;
    std::vector<float> behind(n, 0.f);
    for(Index g = 0; g < n; ++g)
      if(degree[g] == 1)
        stack.push_back(g);
    while(!stack.empty())
    {
      const Index g = stack.back();
      stack.pop_back();
      const Index i = exclusive_or[g], p = ends[i][0] == g ? ends[i][1] : ends[i][0];
      degree[g] = 0;
      is_branch[i] = 1;
      const float strength = (std::max)(behind[g], pieces[i].strength);
      behind[p] = (std::max)(behind[p], strength);
      peeled.push_back({g, p, pieces[i].halfedge, strength});
      exclusive_or[p] ^= i;
      if(--degree[p] == 1)
        stack.push_back(p);
    }
    constexpr float always = (std::numeric_limits<float>::max)();
    for(Index i = 0; i < pieces.size(); ++i)
      if(!is_branch[i])
        edges_.push_back({ends[i][0], ends[i][1], pieces[i].halfedge, always});
    number_of_core_edges_ = static_cast<Index>(edges_.size());
    edges_.insert(edges_.end(), peeled.rbegin(), peeled.rend());

    // children, in compressed rows
    std::vector<Index> position(n, null_index);
    for(Index i = number_of_core_edges_; i < edges_.size(); ++i)
      position[edges_[i].outer] = i;
    child_begin_.assign(edges_.size() + 1, 0);
    for(Index i = number_of_core_edges_; i < edges_.size(); ++i)
      if(position[edges_[i].inner] == null_index)
        first_branches_.push_back(i);
      else
        ++child_begin_[position[edges_[i].inner] + 1];
    for(std::size_t i = 0; i < edges_.size(); ++i)
      child_begin_[i + 1] += child_begin_[i];
    children_.resize(child_begin_.back());
    std::vector<Index> next(child_begin_.begin(), child_begin_.end() - 1);
    for(Index i = number_of_core_edges_; i < edges_.size(); ++i)
      if(position[edges_[i].inner] != null_index)
        children_[next[position[edges_[i].inner]]++] = i;

    for(const Snap& s : snaps)
      if(s.strength > s.next_strength && !connectivity.is_border(s.vertex))
      {
        const Index g = group(connectivity, s.vertex);
        if(g < vertices_.size() && vertices_[g] == s.vertex)
          ends_.push_back({g, s.next_strength, s.strength});
      }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.group < b.group; });
  }

  // whether a branch ends there at this threshold
  bool is_end(Index g, double threshold) const
  {
    for(auto it = std::lower_bound(ends_.begin(), ends_.end(), g, [](const End&e, Index i) { return e.group < i; });
        it != ends_.end() && it->group == g; ++it)
      if(it->next_strength < threshold && it->strength >= threshold)
        return true;
    return false;
  }

  Indexed_cut_locus graph(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                          const Direction_field& field, const std::vector<Index>& selected) const
  {
    Indexed_cut_locus result;
    std::vector<std::array<Index, 2>> ends;
    std::vector<Index> vertices;
    for(Index i : selected)
    {
      const Index h = edges_[i].halfedge;
      ends.push_back({{mesh.source(h), mesh.target(h)}});
      vertices.insert(vertices.end(), ends.back().begin(), ends.back().end());
    }
    if(vertices.empty())
      vertices.push_back(lone_vertex_);
    const Index root = vertices.front();
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    // the root first
    std::rotate(vertices.begin(), std::lower_bound(vertices.begin(), vertices.end(), root), vertices.end());
    std::vector<std::pair<Index, Index>> position;
    for(Index i = 0; i < vertices.size(); ++i)
      position.push_back({vertices[i], i});
    std::sort(position.begin(), position.end());
    const auto node = [&](Index v)
    { return std::lower_bound(position.begin(), position.end(), std::make_pair(v, Index(0)))->second; };
    for(Index v : vertices)
      result.nodes.push_back({internal::location_of_vertex(connectivity, v), v, field.vertices[v].distance});
    for(std::size_t i = 0; i < selected.size(); ++i)
      result.edges.push_back({node(ends[i][0]), node(ends[i][1]), edges_[selected[i]].halfedge,
                              edges_[selected[i]].strength, static_cast<Index>(i)});
    return result;
  }

  struct End
  {
    Index group;
    float next_strength, strength;
  };

  Index lone_vertex_ = null_index;
  std::vector<Index> vertices_; // sorted
  std::vector<Edge> edges_;     // the cycles first, then from the inside out
  Index number_of_core_edges_ = 0;
  std::vector<Index> first_branches_, child_begin_, children_;
  std::vector<End> ends_;
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * continues a branch of a graph of mesh edges along `vertices`, neighbors in their order of which the first is in the
 * graph, as long as they are not in the graph: so its topology stays as it is.
 */
inline void continue_mesh_edges(const Mesh_connectivity& connectivity, const Direction_field& field,
                                const std::vector<Index>& vertices, Indexed_cut_locus& graph)
{
  const auto node_of = [&](Index v)
  {
    for(Index i = 0; i < graph.nodes.size(); ++i)
      if(graph.nodes[i].vertex == v)
        return i;
    return null_index;
  };
  Index node = vertices.empty() ? null_index : node_of(vertices.front());
  for(std::size_t i = 1; i < vertices.size() && node != null_index; ++i)
  {
    const Index v = vertices[i], u = vertices[i - 1];
    if(connectivity.is_border(v) || v == field.source.vertex || node_of(v) != null_index)
      return;
    Index entry = connectivity.ring_begin[u];
    while(entry < connectivity.ring_begin[u + 1] && connectivity.ring_vertex[entry] != v)
      ++entry;
    if(entry == connectivity.ring_begin[u + 1])
      return;
    const Index next = static_cast<Index>(graph.nodes.size());
    float strength = 0.f;
    for(const Indexed_cut_locus::Edge& e : graph.edges)
      if(e.source == node || e.target == node)
        strength = strength == 0.f ? e.strength : (std::min)(strength, e.strength);
    graph.nodes.push_back({internal::location_of_vertex(connectivity, v), v, field.vertices[v].distance});
    graph.edges.push_back(
      {node, next, connectivity.ring_halfedge[entry], strength, static_cast<Index>(graph.edges.size())});
    node = next;
  }
}

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_MESH_EDGE_SNAPPING_H
