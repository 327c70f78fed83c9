// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MERGED_NODES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MERGED_NODES_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// tells which nodes of a tree are one: where more pieces than two meet, or at a vertex, pieces of no length may be between
/// them.
class Merged_nodes
{
public:
  Merged_nodes(const Exact_tree& tree, const std::vector<Tree_branches::Edge>& kept, const Progress& progress)
    : mesh_(tree.mesh()), tree_(tree)
  {
    const std::vector<Tree_graph::Node>& nodes = tree_.graph().nodes;
    merged_.assign(nodes.size(), null_index);
    vertex_.resize(nodes.size());
    for(Index i = 0; i < nodes.size(); ++i)
    {
      progress(i, nodes.size());
      vertex_[i] = nodes[i].vertex;
    }
    is_nothing_.assign(tree_.graph().edges.size(), 0);
    for(const Tree_branches::Edge& b : kept)
      if(has_no_length(b.edge))
        is_nothing_[b.edge] = merge(representative(b.outer), representative(b.inner));
    fold(kept);
  }

  Index representative(Index i) const
  {
    while(merged_[i] != null_index)
      i = merged_[i];
    return i;
  }

  /// the vertex at which a node is, or what has been merged into it
  Index vertex(Index i) const { return vertex_[i]; }
  /// whether each edge is within a node, or beside another one
  const std::vector<unsigned char>& is_nothing() const { return is_nothing_; }

  /// of several nodes at a point, the one that is at a vertex or on an edge says so for all
  int rank(Index i) const
  {
    return vertex_[i] != null_index ? 2 : tree_.graph().nodes[i].halfedge != null_index ? 1 : 0;
  }

  /// in the frame of the first halfedge of the face
  Plane_point position(Index i, Index f) const
  {
    const Tree_graph::Node& n = tree_.graph().nodes[i];
    if(n.face == f)
      return n.point;
    return across(tree_.geodesics().faces(), n.halfedge, n.t);
  }

private:
  /// Branches that are nearer to a vertex than it is known where they are, and come from one point: pieces between the same
  /// two places are one, that with the largest gap, or none if they are a way there and back.
  void fold(const std::vector<Tree_branches::Edge>& kept)
  {
    std::vector<Index> degree(tree_.graph().nodes.size(), 0);
    for(const Tree_branches::Edge& b : kept)
      if(!is_nothing_[b.edge])
        for(Index i : tree_.graph().edges[b.edge].nodes)
          ++degree[representative(i)];
    std::map<std::pair<Index, Index>, Index> edge_to; // from a node, to a vertex
    for(const Tree_branches::Edge& b : kept)
      for(const bool is_outer : {false, true})
      {
        const Index from = representative(is_outer ? b.inner : b.outer),
                    to = representative(is_outer ? b.outer : b.inner);
        if(is_nothing_[b.edge] || from == to || vertex_[to] == null_index)
          continue;
        Index& other = edge_to.insert({{from, vertex_[to]}, b.edge}).first->second;
        const Tree_graph::Edge &e = tree_.graph().edges[b.edge], &o = tree_.graph().edges[other];
        if(other == b.edge || is_nothing_[other] || e.face != o.face)
          continue;
        const Index end = representative(representative(o.nodes[0]) == from ? o.nodes[1] : o.nodes[0]);
        const Index degree_of_both = degree[end] + degree[to];
        if(end == to || !merge(end, to))
          continue;
        const bool is_way_back = degree[from] == 2;
        degree[from] -= is_way_back ? 2 : 1;
        degree[representative(to)] = degree_of_both - (is_way_back ? 2 : 1);
        is_nothing_[e.gap > o.gap || is_way_back ? other : b.edge] = 1;
        if(is_way_back)
        {
          is_nothing_[b.edge] = 1;
          merged_[from] = representative(to); // it may be the root
        }
        else if(e.gap > o.gap)
          other = b.edge;
      }
  }

  /// Makes one node of two, unless its place would be in no common face with what is joined to either.
  bool merge(Index i, Index j)
  {
    if(i == j)
      return true;
    if(rank(i) < rank(j))
      std::swap(i, j);
    const Tree_graph::Node &a = tree_.graph().nodes[i], &b = tree_.graph().nodes[j];
    if(rank(i) == 2 && (rank(j) == 2 ? vertex_[i] != vertex_[j] : !is_beside(b, vertex_[i])))
      return false;
    if(rank(i) == 1 && rank(j) == 1 && a.halfedge != b.halfedge)
    {
      // at the vertex between two edges, but at none of the border: what passes there does not end there
      const Index v = common_vertex(a.halfedge, b.halfedge);
      if(v == null_index || !is_at(a, v) || !is_at(b, v))
        return false;
      vertex_[i] = v;
    }
    merged_[j] = i;
    return true;
  }

  /// whether a node is on an edge or in a face of the mesh at a vertex
  bool is_beside(const Tree_graph::Node& n, Index v) const
  {
    if(n.halfedge != null_index)
      return mesh_.source(n.halfedge) == v || mesh_.target(n.halfedge) == v;
    const std::array<Index, 3>& t = mesh_.triangles[n.face];
    return std::find(t.begin(), t.end(), v) != t.end();
  }

  /// whether a node on an edge is at its end: the edges of a thin face are next to each other elsewhere, too
  bool is_at(const Tree_graph::Node& n, Index v) const
  {
    constexpr double accuracy = 1e-6; // of nodes, in lengths of the edge
    const double length = tree_.geodesics().faces().length(n.halfedge);
    return (mesh_.source(n.halfedge) == v ? n.t : length - n.t) <= accuracy * length;
  }

  /// of two edges, if it is not on the border
  Index common_vertex(Index h, Index g) const
  {
    for(Index v : {mesh_.source(h), mesh_.target(h)})
      if((mesh_.source(g) == v || mesh_.target(g) == v) && !tree_.connectivity().is_border(v))
        return v;
    return null_index;
  }

  bool has_no_length(Index edge) const
  {
    const Tree_graph::Edge& e = tree_.graph().edges[edge];
    if(e.is_virtual)
      return false;
    const Plane_point p = position(e.nodes[0], e.face), q = position(e.nodes[1], e.face);
    const double size = tree_.geodesics().faces().length(3 * e.face) + tree_.geodesics().faces().length(3 * e.face + 1);
    const double least = 1e-8 * size; // some ten times the accuracy of windows
    return squared_distance(q, p) <= least * least;
  }

  const Indexed_triangle_mesh& mesh_;
  const Exact_tree& tree_;
  std::vector<Index> merged_, vertex_;    // of nodes
  std::vector<unsigned char> is_nothing_; // edges
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_MERGED_NODES_H
