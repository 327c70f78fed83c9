// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_BRANCH_FILTER_H
#define CGAL_CUT_LOCI_LAPLACIAN_BRANCH_FILTER_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*
 * selects the cut locus from a tree of candidates and the part of the cut locus that the homology demands.
 *
 * That part is a graph which cuts the surface into one open disk. The tree hangs on it, so removing vertices of
 * degree 1 from the union keeps the disk, and the filter does nothing else: it keeps the demanded part, the branches
 * that pass the thresholds and are not short, and the root, from which a surface with a border allows it to cut a weak
 * end. The answer to both policies is stored with each vertex, the largest strength below it and the smallest above, so
 * that a new threshold costs time in proportion to the size of the result.
 */
class Branch_filter
{
public:
  /// an edge of the result, from a vertex to the next one on the way to the root
  struct Edge
  {
    Index vertex, parent;
    Index halfedge;
    float strength; ///< of the branch: the largest gradient angle found on it from here to its tips
  };
  struct Result
  {
    std::vector<Index> vertices; ///< the root first, or where that has been cut off, the vertex after it
    std::vector<Edge> edges;     ///< the generators last
  };

  Branch_filter() = default;

  /*!
   * @param tree the candidates
   * @param spanning_tree a spanning tree of the mesh with the same root, and
   * @param generators halfedges of the edges that cut the surface to a disk together with it
   * @param gradient_angle, laplacian the two strengths of each vertex; the latter in units of the inverse of the mean
   *        edge length, negative where gradients converge
   * @param joins_loop whether each border loop is joined to the cut locus, which those are not that are sources; all are
   *        if it is empty
   */
  Branch_filter(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Spanning_tree& tree,
                const Spanning_tree& spanning_tree, const std::vector<Index>& generators,
                const std::vector<float>& gradient_angle, const std::vector<float>& laplacian,
                const internal::Progress& progress = {}, const std::vector<unsigned char>& joins_loop = {})
    : root_(tree.root), generators_(generators), is_kept_(tree.parent.size(), false)
  {
    keep_homology(mesh, connectivity, spanning_tree, joins_loop);
    const Spanning_tree joined = join(connectivity, tree, spanning_tree);
    progress(0.3);
    link(connectivity, joined);
    progress(0.7);
    accumulate(connectivity, joined, gradient_angle, laplacian);
  }

  Result operator()(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const Branch_thresholds& thresholds) const
  {
    const std::vector<Strength>& strength = thresholds.policy == Filter_policy::PRUNING ? below_ : above_;
    Result result;
    std::vector<Index> parent_position(1, null_index);
    result.vertices.push_back(root_);
    for(std::size_t i = 0; i < result.vertices.size(); ++i) // grows on the way
      for(const Child& child : children_[result.vertices[i]])
      {
        const Index w = child.vertex;
        if(!is_kept_[w] &&
           !(strength[w].gradient_angle >= thresholds.gradient_angle && strength[w].laplacian >= thresholds.laplacian))
          continue;
        result.vertices.push_back(w);
        result.edges.push_back({w, result.vertices[i], child.halfedge, below_[w].gradient_angle});
        parent_position.push_back(static_cast<Index>(i));
      }
    if(!only_joins_.empty())
      remove_needless_joins(parent_position, result);
    if(thresholds.minimum_edges > 1 || thresholds.minimum_length > 0.)
      remove_short_branches(mesh, connectivity, thresholds, parent_position, result);
    if(!own_.empty())
      trim_root(mesh, thresholds, result);
    add_generators(mesh, result);
    return result;
  }

  /// the result as a graph, without distances
  static Indexed_cut_locus mesh_edge_graph(const Mesh_connectivity& connectivity, const Result& filtered)
  {
    Indexed_cut_locus result;
    result.nodes.resize(filtered.vertices.size());
    // The vertices of the result are few: a search in a sorted copy costs no table over the mesh.
    std::vector<std::pair<Index, Index>> position(filtered.vertices.size());
    for(Index i = 0; i < filtered.vertices.size(); ++i)
    {
      const Index v = filtered.vertices[i];
      result.nodes[i] = {internal::location_of_vertex(connectivity, v), v, 0.};
      position[i] = {v, i};
    }
    std::sort(position.begin(), position.end());
    const auto node = [&](Index v)
    { return std::lower_bound(position.begin(), position.end(), std::make_pair(v, Index(0)))->second; };
    result.edges.reserve(filtered.edges.size());
    for(const Edge& e : filtered.edges)
      result.edges.push_back(
        {node(e.vertex), node(e.parent), e.halfedge, e.strength, static_cast<Index>(result.edges.size())});
    return result;
  }

  /*!
   * gives the edge to `v` from the child with the largest gradient angle on its branch, which is none that is kept at any
   * threshold; false if there is no other.
   */
  bool strongest_child(Index v, Edge& edge) const
  {
    Index best = null_index;
    for(const Child& child : children_[v])
      if(!is_kept_[child.vertex] &&
         (best == null_index || below_[child.vertex].gradient_angle > below_[best].gradient_angle))
      {
        best = child.vertex;
        edge = {best, v, child.halfedge, below_[best].gradient_angle};
      }
    return best != null_index;
  }

private:
  struct Child
  {
    Index vertex, halfedge;
  };
  struct Strength
  {
    float gradient_angle, laplacian;
  };

  void link(const Mesh_connectivity& connectivity, const Spanning_tree& tree)
  {
    const auto enumerate = [&](const auto& add)
    {
      for(Index v : tree.order)
        if(v != root_)
          add(tree.parent[v], {v, connectivity.ring_halfedge[tree.parent_entry[v]]});
    };
    children_ = internal::Compressed_rows<Child>(tree.parent.size(), enumerate);
  }

  void keep_homology(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Spanning_tree& tree, const std::vector<unsigned char>& joins_loop)
  {
    const auto keep_path = [&](Index v)
    {
      for(; v != root_ && !is_kept_[v]; v = tree.parent[v])
        is_kept_[v] = true;
    };
    is_kept_[root_] = true;
    for(Index h : generators_)
    {
      keep_path(mesh.source(h));
      keep_path(mesh.target(h));
    }
    std::vector<bool> loop_is_joined(connectivity.number_of_border_loops, false);
    for(Index i = 0; i < joins_loop.size(); ++i)
      loop_is_joined[i] = !joins_loop[i];
    if(connectivity.number_of_border_loops > 0)
      for(Index v : tree.order) // the first vertex of a loop in this order is where the tree enters it
        if(connectivity.is_border(v) && !loop_is_joined[connectivity.border_loop[v]])
        {
          loop_is_joined[connectivity.border_loop[v]] = true;
          keep_path(v);
        }
  }

  // The kept paths and the border loops of the spanning tree, and the candidates hanging on them. A loop that
  // candidates entered at another place than the spanning tree would be on a cycle.
  Spanning_tree join(const Mesh_connectivity& connectivity, const Spanning_tree& tree,
                     const Spanning_tree& spanning_tree) const
  {
    const auto is_fixed = [&](Index v) { return is_kept_[v] || connectivity.is_border(v); };
    Spanning_tree result = tree;
    result.order.clear();
    for(Index v : spanning_tree.order)
      if(is_fixed(v))
      {
        result.order.push_back(v);
        result.parent[v] = spanning_tree.parent[v];
        result.parent_entry[v] = spanning_tree.parent_entry[v];
      }
    for(Index v : tree.order)
      if(!is_fixed(v))
        result.order.push_back(v);
    return result;
  }

  void accumulate(const Mesh_connectivity& connectivity, const Spanning_tree& tree,
                  const std::vector<float>& gradient_angle, const std::vector<float>& laplacian)
  {
    const float infinity = (std::numeric_limits<float>::infinity)();
    below_.resize(tree.parent.size());
    above_.resize(tree.parent.size());
    if(connectivity.number_of_border_loops > 0)
      only_joins_.resize(tree.parent.size());
    for(Index v : tree.order)
      if(connectivity.is_border(v)) // joins branches that reach the border, and is none itself
      {
        only_joins_[v] = true;
        below_[v] = {-infinity, -infinity};
        above_[v] = {infinity, infinity};
      }
      else
        below_[v] = above_[v] = {gradient_angle[v], -laplacian[v]};
    if(connectivity.number_of_border_loops > 0)
      own_ = above_;
    for(std::size_t i = tree.order.size(); i-- > 1;)
    {
      const Strength& s = below_[tree.order[i]];
      Strength& p = below_[tree.parent[tree.order[i]]];
      p.gradient_angle = (std::max)(p.gradient_angle, s.gradient_angle);
      p.laplacian = (std::max)(p.laplacian, s.laplacian);
    }
    for(Index v : tree.order)
    {
      if(is_kept_[v] || is_kept_[tree.parent[v]])
        continue; // growth starts anew from what is kept at any threshold
      const Strength& p = above_[tree.parent[v]];
      above_[v].gradient_angle = (std::min)(above_[v].gradient_angle, p.gradient_angle);
      above_[v].laplacian = (std::min)(above_[v].laplacian, p.laplacian);
    }
  }

  // Border vertices from which no branch goes on.
  void remove_needless_joins(std::vector<Index>& parent_position, Result& result) const
  {
    const std::size_t n = result.vertices.size();
    std::vector<bool> is_needed(n, false);
    for(std::size_t i = n; i-- > 1;)
    {
      const Index v = result.vertices[i];
      if(is_kept_[v] || !only_joins_[v])
        is_needed[i] = true;
      if(is_needed[i])
        is_needed[parent_position[i]] = true;
    }
    leave(is_needed, parent_position, result);
  }

  // Takes out the vertices that are not marked, on which hang none that are; not the root.
  static void leave(const std::vector<bool>& is_marked, std::vector<Index>& parent_position, Result& result)
  {
    std::vector<Index> new_position(is_marked.size(), 0);
    std::size_t size = 1;
    for(std::size_t i = 1; i < is_marked.size(); ++i)
      if(is_marked[i])
      {
        new_position[i] = static_cast<Index>(size);
        result.vertices[size] = result.vertices[i];
        result.edges[size - 1] = result.edges[i - 1];
        parent_position[size++] = new_position[parent_position[i]];
      }
    result.vertices.resize(size);
    result.edges.resize(size - 1);
    parent_position.resize(size);
  }

  // With a border the root is a guess: the way from there to the border is kept to join them, and shortened to what passes
  // the thresholds, as any branch from its tip.
  void trim_root(const Indexed_triangle_mesh& mesh, const Branch_thresholds& thresholds, Result& result) const
  {
    const auto is_at_generator = [&](Index v)
    {
      return std::any_of(generators_.begin(), generators_.end(),
                         [&](Index h) { return mesh.source(h) == v || mesh.target(h) == v; });
    };
    std::size_t n = 0;
    for(; n < result.edges.size(); ++n)
    {
      const Index v = result.vertices[n]; // the others hang on it
      const bool has_one_child = n + 1 == result.edges.size() || result.edges[n + 1].parent != v;
      const bool is_strong =
        own_[v].gradient_angle >= thresholds.gradient_angle && own_[v].laplacian >= thresholds.laplacian;
      if(only_joins_[v] || is_strong || !has_one_child || is_at_generator(v))
        break;
    }
    const auto end = static_cast<std::ptrdiff_t>(n);
    result.vertices.erase(result.vertices.begin(), result.vertices.begin() + end);
    result.edges.erase(result.edges.begin(), result.edges.begin() + end);
  }

  void remove_short_branches(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                             const Branch_thresholds& thresholds, std::vector<Index>& parent_position,
                             Result& result) const
  {
    Result whole = result;
    add_generators(mesh, whole);
    Indexed_cut_locus graph = mesh_edge_graph(connectivity, whole);
    std::vector<unsigned char> stays;
    for(Index v : result.vertices)
      stays.push_back(is_kept_[v]);
    Cut_loci::remove_short_branches(mesh, connectivity, {}, thresholds.minimum_edges, thresholds.minimum_length, graph,
                                    stays);
    std::vector<bool> is_left(result.vertices.size(), false);
    std::size_t i = 0;
    for(const Indexed_cut_locus::Node& node : graph.nodes) // in the same order
    {
      for(; result.vertices[i] != node.vertex; ++i)
        ;
      is_left[i] = true;
    }
    leave(is_left, parent_position, result);
  }

  void add_generators(const Indexed_triangle_mesh& mesh, Result& result) const
  {
    for(Index h : generators_)
      result.edges.push_back({mesh.source(h), mesh.target(h), h, (std::numeric_limits<float>::max)()});
  }

  Index root_ = null_index;
  std::vector<Index> generators_;
  std::vector<bool> is_kept_;    // part of the homology, at any threshold
  std::vector<bool> only_joins_; // border vertices; empty if there are none
  internal::Compressed_rows<Child> children_;
  std::vector<Strength> own_;   // of each vertex; empty if there is no border
  std::vector<Strength> below_; // the largest strength in the subtree of each vertex
  std::vector<Strength> above_; // the smallest on the way to what is kept at any threshold
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_BRANCH_FILTER_H
