// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_TREE_CURVE_H
#define CGAL_CUT_LOCI_EXACT_TREE_TREE_CURVE_H

#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/exact_tree/Exact_tree.h>
#include <CGAL/Cut_loci/exact_tree/Image_bisector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// turns the edges of an `Exact_tree` that are left into a curve through the faces.
class Tree_curve
{
public:
  Tree_curve(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
             const Exact_geodesic_propagation& geodesics, Exact_tree& tree)
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), tree_(tree)
  {
  }

  /// @param farthest what is left if nothing else is
  Indexed_cut_locus operator()(const std::vector<Tree_branches::Edge>& kept, Index farthest) const
  {
    Indexed_cut_locus result;
    number_.clear();
    const Index root = tree_.branches().root();
    contract(kept);
    result.nodes.reserve(kept.size() + 1);
    result.edges.reserve(kept.size());
    if(root != null_index && tree_.graph().nodes[root].face != null_index)
      node(root, result); // it comes first
    for(std::size_t i = 0; i < kept.size(); ++i)
      if(!is_nothing_[i])
        add(kept[i], result);
    if(result.edges.empty())
      result.nodes.assign(1, lone_node(farthest));
    return result;
  }

private:
  /// a point that is left: on the border if there is one, as all of a curve is joined to it
  Indexed_cut_locus::Node lone_node(Index v) const
  {
    if(connectivity_.number_of_border_loops > 0)
      for(v = 0; !connectivity_.is_border(v);)
        ++v;
    return {location_of_vertex(connectivity_, v), v, geodesics_.distance(v)};
  }

  /// Where more pieces than two meet, or at a vertex, pieces of no length may be between them: they become one node.
  void contract(const std::vector<Tree_branches::Edge>& kept) const
  {
    merged_.clear();
    is_nothing_.resize(kept.size());
    for(std::size_t k = 0; k < kept.size(); ++k)
    {
      is_nothing_[k] = is_nothing(kept[k].edge);
      if(is_nothing_[k])
      {
        Index i = representative(kept[k].outer), j = representative(kept[k].inner);
        if(i == j)
          continue;
        if(rank(i) < rank(j))
          std::swap(i, j);
        merged_[j] = i;
      }
    }
  }

  /// of several nodes at a point, the one that is at a vertex or on an edge says so for all
  int rank(Index i) const
  {
    const Tree_graph::Node& n = tree_.graph().nodes[i];
    return n.vertex != null_index ? 2 : n.halfedge != null_index ? 1 : 0;
  }

  Index representative(Index i) const
  {
    for(auto found = merged_.find(i); found != merged_.end(); found = merged_.find(i))
      i = found->second;
    return i;
  }

  bool is_nothing(Index edge) const
  {
    const Tree_graph::Edge& e = tree_.graph().edges[edge];
    if(e.is_virtual)
      return false;
    const Plane_point p = position(e.nodes[0], e.face), q = position(e.nodes[1], e.face);
    const double size = geodesics_.faces().length(3 * e.face) + geodesics_.faces().length(3 * e.face + 1);
    const double least = 1e-8 * size; // some ten times the accuracy of windows
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) <= least * least;
  }

  /// in the frame of the first halfedge of the face
  Plane_point position(Index i, Index f) const
  {
    const Tree_graph::Node& n = tree_.graph().nodes[i];
    if(n.face == f)
      return n.point;
    const Index o = mesh_.opposite[n.halfedge];
    const double s = 1. - n.t / geodesics_.faces().length(n.halfedge);
    const std::array<Plane_point, 3> c = tree_.ridges().layout(f);
    const Plane_point &p = c[o % 3], &q = c[(o + 1) % 3];
    return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)};
  }

  Index node(Index i, Indexed_cut_locus& graph) const
  {
    i = representative(i);
    const auto inserted = number_.insert({i, static_cast<Index>(graph.nodes.size())});
    if(inserted.second)
    {
      const Tree_graph::Node& n = tree_.graph().nodes[i];
      graph.nodes.push_back(
        {n.vertex != null_index ? location_of_vertex(connectivity_, n.vertex) : location(n), n.vertex, n.distance});
    }
    return inserted.first->second;
  }

  Indexed_location location(const Tree_graph::Node& n) const
  {
    if(n.halfedge == null_index)
      return location(n.face, n.point);
    Indexed_location result;
    result.face = n.halfedge / 3;
    const double s = n.t / geodesics_.faces().length(n.halfedge);
    result.coordinates[n.halfedge % 3] = 1. - s;
    result.coordinates[(n.halfedge + 1) % 3] = s;
    return result;
  }

  /// a point of a face, in the frame of its first halfedge
  Indexed_location location(Index f, const Plane_point& p) const
  {
    const std::array<Plane_point, 3> t = tree_.ridges().layout(f);
    const double third = p.y / t[2].y, second = (p.x - third * t[2].x) / t[1].x;
    Indexed_location result;
    result.face = f;
    result.coordinates = {{(std::max)(1. - second - third, 0.), (std::max)(second, 0.), (std::max)(third, 0.)}};
    double sum = 0.;
    for(double c : result.coordinates)
      sum += c;
    for(double& c : result.coordinates)
      c /= sum;
    return result;
  }

  void add(const Tree_branches::Edge& b, Indexed_cut_locus& result) const
  {
    const Tree_graph::Edge& e = tree_.graph().edges[b.edge];
    if(e.is_virtual)
      return;
    const Index first = node(e.nodes[0], result), last = node(e.nodes[1], result);
    between_.clear();
    if(e.piece != null_index)
    {
      // chords leave a hyperbola by at most this share of an edge of the mesh
      const double tolerance = 1e-4 * connectivity_.mean_edge_length;
      const Ridges::Piece& piece = tree_.ridges().piece(e.piece);
      sample_bisector(piece.images[0], piece.images[1], tree_.ridges().piece_end(e.piece, 0),
                      tree_.ridges().piece_end(e.piece, 1), tolerance, between_);
    }
    const float width = static_cast<float>(tree_.width(b.edge));
    Index previous = first;
    for(const Plane_point& p : between_)
    {
      const Index next = static_cast<Index>(result.nodes.size());
      result.nodes.push_back({location(e.face, p), null_index, tree_.ridges().piece(e.piece).images[0].distance(p)});
      add_segment(previous, next, e, width, result);
      previous = next;
    }
    add_segment(previous, last, e, width, result);
  }

  void add_segment(Index i, Index j, const Tree_graph::Edge& e, float width, Indexed_cut_locus& result) const
  {
    Indexed_cut_locus::Edge edge{i, j, mesh_edge(result.nodes[i].vertex, result.nodes[j].vertex, e.face),
                                 static_cast<float>(e.gap), 0};
    edge.width = width;
    result.edges.push_back(edge);
  }

  /// the edge of the face between two of its vertices, if they are such
  Index mesh_edge(Index u, Index v, Index f) const
  {
    if(u != null_index && v != null_index)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if((mesh_.source(h) == u && mesh_.target(h) == v) || (mesh_.source(h) == v && mesh_.target(h) == u))
          return h;
    return null_index;
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Exact_geodesic_propagation& geodesics_;
  Exact_tree& tree_;
  mutable std::unordered_map<Index, Index> number_, merged_; // of nodes
  mutable std::vector<unsigned char> is_nothing_;            // of the edges that are kept
  mutable std::vector<Plane_point> between_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_TREE_CURVE_H
