// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_H

#include <CGAL/Cut_loci/internal/Edges_left.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridges.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is the cut locus of the polyhedron as a graph of points and the pieces between them, without what the topology alone
 * had added.
 */
class Tree_graph
{
public:
  struct Node
  {
    Index face = null_index;
    Plane_point point = {0., 0.}; // in the frame of the first halfedge of the face
    Index halfedge = null_index;  // of the edge of the mesh it is on, if any
    double t = 0.;                // the position on it
    Index vertex = null_index;    // of the mesh it is at, if any
    Index crossing = null_index;  // see `Label_changes`
    Index loop = null_index;      // the border loop it stands for, or lies on
    double distance = 0.;         // to the source
  };

  struct Edge
  {
    std::array<Index, 2> nodes;
    Index face = null_index;                 // that it runs through
    Index piece = null_index;                // of `Ridges`
    double gap = 0.;                         // at its wider end
    bool is_virtual = false;                 // joins a point on the border to the node of the border loop; in no face
    std::array<Index, 2> sources = {{0, 0}}; // on its two sides, the smaller one first

    bool is_between_sources() const { return sources[0] != sources[1]; }
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;

  Tree_graph(const Ridges& ridges, Index number_of_loops) : ridges_(ridges), number_of_loops_(number_of_loops) {}

  /// border loops have the first nodes
  Index number_of_loops() const { return number_of_loops_; }

  /// whether all of the graph comes from labels, and nothing had to be added or left out for the topology
  bool is_sure() const
  {
    return number_of_open == 0 && ridges_.number_of_doubtful() == 0 &&
           std::all_of(edges.begin(), edges.end(), [](const Edge& e) { return e.piece != null_index || e.is_virtual; });
  }

  /// removes the branches on which the paths to no point have the angle that they need
  void drop_weak_branches(const Branch_strength& least, const Progress& progress = {})
  {
    Edges_left left = edges_left(progress.part(0., 0.3));
    std::vector<unsigned char> is_weak(edges.size()), is_removed(edges.size(), 0);
    for(Index e = 0; e < edges.size(); ++e) // in the order of memory, which leaves are not in
      is_weak[e] = !can_be(e, least);
    left.peel(
      nodes_of_edges(), [&](Index e, Index) { return (is_removed[e] = is_weak[e]) != 0; }, progress.part(0.3, 0.8));
    remove(is_removed, progress.part(0.8, 1.));
  }

  /// the edges that are left when branches fall off, from the leaves inward, up to their outermost strong edges. No edge has
  /// to be known as the root.
  ///
  /// @param is_strong tells it of an edge and the leaf that it falls off from
  template <typename Is_strong>
  std::vector<Index> strong_branches(const Is_strong& is_strong, const Progress& progress = {}) const
  {
    Edges_left left = edges_left(progress.part(0., 0.3));
    std::vector<unsigned char> is_removed(edges.size(), 0);
    left.peel(
      nodes_of_edges(), [&](Index e, Index leaf) { return (is_removed[e] = !is_strong(e, leaf)) != 0; },
      progress.part(0.3, 1.));
    std::vector<Index> result;
    for(Index e = 0; e < edges.size(); ++e)
      if(!is_removed[e])
        result.push_back(e);
    return result;
  }

  /// whether the paths to an edge part or meet at the angle that this strength needs: past saddles, paths that part at a
  /// small angle may get far apart, and meet at a larger one
  bool can_be(Index e, const Branch_strength& least) const
  {
    const double farther = (std::max)(nodes[edges[e].nodes[0]].distance, nodes[edges[e].nodes[1]].distance);
    const double angle = least.least_angle(farther);
    return edges[e].gap >= angle || (edges[e].piece != null_index && ridges_.meeting_angle(edges[e].piece) >= angle);
  }

  /// removes the edges from a leaf at a vertex of the mesh up to the first node at which others meet, or the border
  void remove_branch_to(Index vertex)
  {
    Edges_left left = edges_left();
    std::vector<unsigned char> is_removed(edges.size(), 0);
    for(Index i = 0; i < nodes.size(); ++i)
      if(nodes[i].vertex == vertex)
        left.peel_from(i, nodes_of_edges(), [&](Index e, Index) { return (is_removed[e] = 1) != 0; });
    remove(is_removed);
  }

  void remove(const std::vector<unsigned char>& is_removed, const Progress& progress = {})
  {
    std::size_t size = 0;
    for(std::size_t e = 0; e < edges.size(); ++e)
    {
      progress(e, edges.size());
      if(!is_removed[e])
        edges[size++] = edges[e];
    }
    edges.resize(size);
  }

  /// the nodes of no edge, but for border loops
  void drop_lone_nodes()
  {
    std::vector<Index> number(nodes.size(), null_index);
    for(const Edge& e : edges)
      for(Index i : e.nodes)
        number[i] = 0;
    Index size = 0;
    for(Index i = 0; i < nodes.size(); ++i)
      if(number[i] != null_index || i < number_of_loops_)
      {
        number[i] = size;
        nodes[size++] = nodes[i];
      }
    nodes.resize(size);
    for(Edge& e : edges)
      for(Index& i : e.nodes)
        i = number[i];
  }

  Index number_of_open = 0; ///< crossings at which the graph is not closed

private:
  struct Nodes_of_edges
  {
    const std::vector<Edge>& edges;
    const std::array<Index, 2>& operator()(Index e) const { return edges[e].nodes; }
  };
  Nodes_of_edges nodes_of_edges() const { return {edges}; }

  /// border loops are no leaves
  Edges_left edges_left(const Progress& progress = {}) const
  {
    Edges_left result(nodes.size(), edges.size(), nodes_of_edges(), progress);
    for(Index i = 0; i < number_of_loops_; ++i)
      result.keep(i);
    return result;
  }

  const Ridges& ridges_;
  Index number_of_loops_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_JOINING_TREE_GRAPH_H
