// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_DIRECTION_PRUNING_H
#define CGAL_CUT_LOCI_DIRECTION_PRUNING_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_jumps.h>
#include <CGAL/Cut_loci/direction_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * is a `Direction_graph` without its weak branches, in a form that answers to any threshold in time proportional to
 * the result.
 *
 * A branch is judged as a whole. At the threshold `s`, an edge of length `l` and strength `S` scores
 * `l clip(ln(S / s), -1, 1)`, a branch has the value of its edge plus the positive values of the branches behind it,
 * and it is kept if that is positive: no single noisy edge keeps or cuts it. The value falls with `s`, and what is
 * stored is where it becomes zero. The cycles and, if there are border loops, what joins these, are kept at any
 * threshold.
 */
class Direction_branches
{
public:
  struct Edge
  {
    Index edge;         ///< of the mesh
    Index outer, inner; ///< nodes of `Direction_graph`: the outer one is farther from the root
    float strength;     ///< the largest threshold that keeps it
  };

  /// the least threshold: below it there is the noise of a smooth field
  static constexpr double least_threshold() { return 2.; }

  Direction_branches() = default;

  /// @param farthest_face a face at the vertex that is farthest from the source: the root, if nothing is strong
  Direction_branches(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Direction_geometry& geometry, const Direction_jumps& jumps, const Direction_graph& graph,
                     Index farthest_face)
  {
    build(mesh, connectivity, geometry, jumps, graph, farthest_face);
  }

  /// a node that is kept at any threshold
  Index root() const { return root_; }

  /// all edges that some threshold keeps
  const std::vector<Edge>& edges() const { return edges_; }
  /// how many of them, at the begin, every threshold keeps
  std::size_t number_of_core_edges() const { return number_of_core_edges_; }

  /// the edges that are kept: the cycles first, then each after the one that its inner node belongs to
  std::vector<Edge> operator()(double threshold) const
  {
    std::vector<Index> kept;
    for(Index first : first_branches_)
      if(edges_[first].strength >= threshold)
        kept.push_back(first);
    for(std::size_t i = 0; i < kept.size(); ++i) // grows on the way
      for(Index c = child_begin_[kept[i]]; c < child_begin_[kept[i] + 1]; ++c)
        if(edges_[children_[c]].strength >= threshold)
          kept.push_back(children_[c]);
    std::vector<Edge> result(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(number_of_core_edges_));
    for(Index i : kept)
      result.push_back(edges_[i]);
    return result;
  }

private:
  // All nodes in the order in which leaves fall off. What is left are the cycles and the terminals.
  struct Peeling
  {
    std::vector<Index> order, parent_edge, parent;
  };

  static Peeling peel(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                      const Direction_graph& graph, Index terminal)
  {
    const Index n = graph.number_of_nodes;
    struct Incidence
    {
      Index degree = 0, exclusive_or = 0;
    };
    std::vector<Incidence> incidence(n);
    for(Index e : graph.edges)
      for(Index f : graph.nodes(mesh, connectivity, e))
      {
        ++incidence[f].degree;
        incidence[f].exclusive_or ^= e; // with one edge left, this is the edge
      }
    for(Index f = graph.number_of_faces; f < n; ++f)
      incidence[f].degree += 2; // terminals are no leaves
    if(terminal != null_index)
      incidence[terminal].degree += 2;

    Peeling result;
    result.order.reserve(n);
    result.parent_edge.assign(n, null_index);
    result.parent.assign(n, null_index);
    for(Index seed = 0; seed < graph.number_of_faces; ++seed)
      for(Index f = seed; incidence[f].degree == 1;)
      {
        const Index e = incidence[f].exclusive_or;
        const std::array<Index, 2> ends = graph.nodes(mesh, connectivity, e);
        const Index p = ends[0] == f ? ends[1] : ends[0];
        incidence[f].degree = 0;
        --incidence[p].degree;
        incidence[p].exclusive_or ^= e;
        result.order.push_back(f);
        result.parent_edge[f] = e;
        result.parent[f] = p;
        if(p > seed)
          break; // its turn comes
        f = p;
      }
    return result;
  }

  static float score(float length, float log_strength, float log_threshold)
  {
    return length * (std::min)((std::max)(log_strength - log_threshold, -1.f), 1.f);
  }

  /*
   * The root of a tree: a node that as high a threshold as possible keeps. What connects a branch to the root decides
   * on all of it, so that a root on a weak branch would take the strong ones away with it. `enough` is the least value
   * of what is kept: a single strong edge tells nothing. `value` is what is behind each node at the least threshold;
   * null_index, if that is zero everywhere.
   */
  template <typename Log_strength, typename Length>
  static Index strongest_node(const Peeling& peeling, const std::vector<float>& value, const Log_strength& log_strength,
                              const Length& length, float enough)
  {
    struct Step
    {
      Index node, parent; // positions among the nodes that have anything behind them
      float length, log_strength;
    };
    std::vector<Index> nodes, position(value.size(), null_index);
    for(Index f = 0; f < value.size(); ++f)
      if(value[f] > 0.f)
      {
        position[f] = static_cast<Index>(nodes.size());
        nodes.push_back(f);
      }
    std::vector<Step> steps; // the other nodes have nothing behind them at higher thresholds either
    float strongest = static_cast<float>(std::log(least_threshold()));
    for(Index f : peeling.order)
      if(position[peeling.parent[f]] != null_index)
      {
        const Index e = peeling.parent_edge[f];
        steps.push_back({position[f], position[peeling.parent[f]], length(e), log_strength(e)});
        strongest = (std::max)(strongest, steps.back().log_strength);
      }
    std::vector<float> behind(nodes.size());
    const auto best_at = [&](float log_threshold)
    {
      std::fill(behind.begin(), behind.end(), 0.f);
      for(const Step& s : steps)
        behind[s.parent] += (std::max)(0.f, (s.node != null_index ? behind[s.node] : 0.f) +
                                              score(s.length, s.log_strength, log_threshold));
      return std::max_element(behind.begin(), behind.end()) - behind.begin();
    };
    if(nodes.empty())
      return null_index;
    float low = static_cast<float>(std::log(least_threshold())), high = strongest;
    auto best = best_at(low);
    enough = (std::min)(enough, behind[best]);
    while(high - low > 0.05f)
    {
      const float middle = 0.5f * (low + high);
      const auto node = best_at(middle);
      if(behind[node] >= enough)
      {
        low = middle;
        best = node;
      }
      else
        high = middle;
    }
    return nodes[best];
  }

  void build(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
             const Direction_geometry& geometry, const Direction_jumps& jumps, const Direction_graph& graph,
             Index farthest_face)
  {
    const float least = static_cast<float>(std::log(least_threshold()));
    const Index n = graph.number_of_nodes;
    std::vector<float> value(n);
    const auto log_strength = [&](Index e) { return std::log((std::max)(jumps.edges[e].strength, 1e-3f)); };
    const auto length = [&](Index e) { return geometry.length[connectivity.halfedge_of_edge[e]]; };
    const auto accumulate = [&](const Peeling& p)
    {
      std::fill(value.begin(), value.end(), 0.f);
      for(Index f : p.order)
      {
        const Index e = p.parent_edge[f];
        // the sum of the positive values behind it is there already
        const float above = value[f] + score(length(e), log_strength(e), least);
        if(above > 0.f)
          value[p.parent[f]] += above;
        else
          value[f] = -value[f] - 1.f; // marks a branch that is dropped; the root may still be on it
      }
    };
    Peeling peeling = peel(mesh, connectivity, graph, null_index);
    accumulate(peeling);
    if(peeling.order.size() + 1 == n && n == graph.number_of_faces) // a tree without terminals
    {
      for(float& v : value)
        v = v < 0.f ? -v - 1.f : v;
      root_ = strongest_node(peeling, value, log_strength, length, 5.f * static_cast<float>(geometry.mean_edge_length));
      if(root_ == null_index)
        root_ = farthest_face;
      peeling = peel(mesh, connectivity, graph, root_);
      accumulate(peeling);
    }

    // the edges of the cycles and between the terminals
    std::vector<Index> position(n, null_index); // of the edge to the parent
    std::vector<unsigned char> is_peeled_edge(connectivity.number_of_edges(), 0);
    for(Index f : peeling.order)
      is_peeled_edge[peeling.parent_edge[f]] = 1;
    constexpr float always = (std::numeric_limits<float>::max)();
    for(Index e : graph.edges)
      if(!is_peeled_edge[e])
      {
        const std::array<Index, 2> ends = graph.nodes(mesh, connectivity, e);
        edges_.push_back({e, ends[0], ends[1], always});
        if(root_ == null_index)
          root_ = ends[0];
      }
    number_of_core_edges_ = edges_.size();
    if(root_ == null_index && n > graph.number_of_faces)
      root_ = graph.number_of_faces; // one border loop and nothing else

    // the branches that the least threshold keeps, from the inside out
    for(std::size_t i = peeling.order.size(); i-- > 0;)
    {
      const Index f = peeling.order[i], p = peeling.parent[f];
      const bool is_attached = peeling.parent_edge[p] == null_index || position[p] != null_index;
      if(value[f] < 0.f || !is_attached)
        continue;
      position[f] = static_cast<Index>(edges_.size());
      edges_.push_back({peeling.parent_edge[f], f, p, 0.f});
    }
    link(position);
    compute_strengths(position, length, log_strength);
  }

  void link(const std::vector<Index>& position)
  {
    child_begin_.assign(edges_.size() + 1, 0);
    for(std::size_t i = number_of_core_edges_; i < edges_.size(); ++i)
    {
      const Index p = position[edges_[i].inner];
      if(p == null_index)
        first_branches_.push_back(static_cast<Index>(i));
      else
        ++child_begin_[p + 1];
    }
    for(std::size_t i = 0; i < edges_.size(); ++i)
      child_begin_[i + 1] += child_begin_[i];
    children_.resize(child_begin_.back());
    std::vector<Index> next(child_begin_.begin(), child_begin_.end() - 1);
    for(std::size_t i = number_of_core_edges_; i < edges_.size(); ++i)
    {
      const Index p = position[edges_[i].inner];
      if(p != null_index)
        children_[next[p]++] = static_cast<Index>(i);
    }
  }

  // The threshold at which the value of each branch is zero, found between levels a quarter of a unit of the logarithm
  // apart: there the value is almost linear in it.
  template <typename Length, typename Log_strength>
  void compute_strengths(const std::vector<Index>& position, const Length& length, const Log_strength& log_strength)
  {
    constexpr float step = 0.25f;
    const std::size_t m = edges_.size();
    std::vector<float> l(m), s(m), value(m), previous(m, 1.f);
    std::vector<Index> live;
    for(std::size_t i = number_of_core_edges_; i < m; ++i)
    {
      l[i] = length(edges_[i].edge);
      s[i] = log_strength(edges_[i].edge);
      live.push_back(static_cast<Index>(i));
    }
    const float least = static_cast<float>(std::log(least_threshold()));
    for(float level = least; !live.empty(); level += step)
    {
      for(Index i : live)
        value[i] = score(l[i], s[i], level);
      for(std::size_t k = live.size(); k-- > 0;)
      {
        const Index i = live[k], p = position[edges_[i].inner];
        if(value[i] > 0.f && p != null_index)
          value[p] += value[i];
      }
      std::size_t size = 0;
      for(Index i : live)
      {
        if(value[i] > 0.f)
        {
          previous[i] = value[i];
          live[size++] = i;
          continue;
        }
        const float part = previous[i] / (std::max)(previous[i] - value[i], 1e-30f);
        edges_[i].strength = std::exp((std::max)(level - step + part * step, least));
      }
      live.resize(size);
    }
    for(std::size_t i = number_of_core_edges_; i < m; ++i)
    {
      const Index p = position[edges_[i].inner];
      if(p != null_index)
        edges_[i].strength = (std::min)(edges_[i].strength, edges_[p].strength);
    }
  }

  Index root_ = null_index;
  std::size_t number_of_core_edges_ = 0;
  std::vector<Edge> edges_;           // the cycles first, then from the inside out
  std::vector<Index> first_branches_; // those at the cycles, or at the root
  std::vector<Index> child_begin_, children_;
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_DIRECTION_PRUNING_H
