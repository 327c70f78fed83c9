// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_FACE_CELLS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_FACE_CELLS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/ways/Way_forest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * divides the faces that a part of a `Tree_graph` runs through into cells, and tells to which of them each face belongs:
 * to the one that a way enters, or else to that which holds the centroid.
 *
 * A cell touches the boundary of its face in parts between two nodes of the graph, on edges or in corners. Part `i`
 * starts at node `i`, in counterclockwise order.
 */
class Face_cells
{
public:
  /// @param entrances of the ways to the faces; there may be more of these
  Face_cells(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Geodesic_faces& faces,
             const Tree_graph& graph, const std::vector<Tree_branches::Edge>& kept,
             const std::vector<Face_entrance>& entrances, const Progress& progress = {})
    : mesh_(mesh), connectivity_(connectivity), faces_(faces), graph_(graph), entrances_(entrances)
  {
    sort_nodes(kept);
    progress(0.2);
    sort_edges(kept, progress.part(0.2, 0.4));
    const Progress dividing = progress.part(0.4, 1.);
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      dividing(f, mesh.number_of_faces());
      if(edges_.size(f) > 0)
        divide(f);
    }
  }

  /// on an edge of the mesh
  Index number_of_nodes(Index e) const { return nodes_.size(e); }

  /// the edges of the graph in a face
  Compressed_rows<Index>::Row edges(Index f) const { return edges_[f]; }

  /// whether nothing divides a face
  bool is_whole(Index f) const { return part_begin_[f] == null_index; }

  /// whether the face of `h` belongs to the cell that touches interval `k` of `h`, counted along the halfedge of smaller
  /// index
  bool holds_face(Index h, Index k) const
  {
    const Index f = h / 3;
    if(part_begin_[f] == null_index)
      return true;
    const Index e = connectivity_.edge_of_halfedge[h], m = nodes_.size(e);
    Index before = 0, all = 0; // nodes of the face before this edge
    for(Index g = 3 * f; g < 3 * f + 3; ++g)
    {
      const Index d = connectivity_.edge_of_halfedge[g], n = nodes_.size(d);
      const Index in_corner = has_node(f, g % 3);
      before += g < h ? in_corner + n : g == h ? in_corner : 0;
      all += in_corner + n;
    }
    if(all == 0)
      return true;
    const Index along = connectivity_.halfedge_of_edge[e] == h ? k : m - k; // nodes of this edge before the interval
    return holds_[part_begin_[f] + (before + along + all - 1) % all];
  }

private:
  void sort_nodes(const std::vector<Tree_branches::Edge>& kept)
  {
    std::vector<unsigned char> is_found(graph_.nodes.size(), 0);
    std::vector<Index> found;
    for(const Tree_branches::Edge& b : kept)
      for(Index i : graph_.edges[b.edge].nodes)
        if(graph_.nodes[i].halfedge != null_index && !is_found[i])
        {
          is_found[i] = 1;
          found.push_back(i);
        }
    const auto enumerate = [&](const auto& add)
    {
      for(Index i : found)
        add(connectivity_.edge_of_halfedge[graph_.nodes[i].halfedge], i);
    };
    nodes_ = Compressed_rows<Index>(connectivity_.number_of_edges(), enumerate);
    nodes_.sort_each(
      [&](Index a, Index b)
      {
      const Tree_graph::Node &p = graph_.nodes[a], &q = graph_.nodes[b];
      return std::tie(p.t, p.crossing, a) < std::tie(q.t, q.crossing, b);
    });
  }

  void sort_edges(const std::vector<Tree_branches::Edge>& kept, const Progress& progress)
  {
    std::vector<Index> order;
    for(const Tree_branches::Edge& b : kept)
      if(!graph_.edges[b.edge].is_virtual)
        order.push_back(b.edge);
    progress(0.4);
    std::sort(order.begin(), order.end());
    progress(0.7);
    const auto enumerate = [&](const auto& add)
    {
      for(Index e : order) // by face, and in a face by index
        add(graph_.edges[e].face, e);
    };
    edges_ = Compressed_rows<Index>(mesh_.number_of_faces(), enumerate);
    part_begin_.assign(mesh_.number_of_faces(), null_index);
    corners_with_nodes_.assign(mesh_.number_of_faces(), 0);
  }

  bool has_node(Index f, Index corner) const { return (corners_with_nodes_[f] >> corner & 1) != 0; }

  /// the nodes on the boundary of the face, counterclockwise; in a corner the first one stands for all
  void walk_around(Index f)
  {
    around_.clear();
    in_corner_ = {{null_index, null_index, null_index}};
    for(Index e : edges_[f])
      for(Index k : graph_.edges[e].nodes)
        for(Index corner = 0; corner < 3; ++corner)
          if(is_in_corner(k, f, corner) && in_corner_[corner] == null_index)
            in_corner_[corner] = k;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if(in_corner_[h % 3] != null_index)
      {
        around_.push_back(in_corner_[h % 3]);
        corners_with_nodes_[f] |= static_cast<unsigned char>(1 << h % 3);
      }
      const Index e = connectivity_.edge_of_halfedge[h];
      around_.insert(around_.end(), nodes_[e].begin(), nodes_[e].end());
      if(connectivity_.halfedge_of_edge[e] != h)
        std::reverse(around_.end() - nodes_.size(e), around_.end());
    }
  }

  bool is_in_corner(Index i, Index f, Index corner) const
  {
    const Tree_graph::Node& n = graph_.nodes[i];
    return n.halfedge == null_index && n.vertex != null_index && n.vertex == mesh_.triangles[f][corner];
  }

  Plane_point position(Index f, Index i) const
  {
    for(Index corner = 0; corner < 3; ++corner)
      if(in_corner_[corner] == i)
        return corners_[corner];
    const Tree_graph::Node& n = graph_.nodes[i];
    if(n.face == f)
      return n.point;
    return across(faces_, n.halfedge, n.t);
  }

  void divide(Index f)
  {
    corners_ = corners_of(faces_, f);
    walk_around(f);
    const std::size_t n = around_.size();
    find_trees(f);
    part_begin_[f] = static_cast<Index>(holds_.size());
    holds_.resize(holds_.size() + n, false);
    if(n == 0)
      return;
    // the part that a way enters, or the centroid sees, and those of the same cell
    const bool is_entered = f < entrances_.size() && entrances_[f].halfedge != null_index;
    std::size_t part = is_entered ? part_entered(entrances_[f]) : part_seen(f);
    std::vector<unsigned char>& is_done = is_done_;
    is_done.assign(n, 0);
    while(!is_done[part])
    {
      is_done[part] = 1;
      holds_[part_begin_[f] + part] = true;
      const std::size_t end = part + 1 < n ? part + 1 : 0;
      part = end;
      do
        part = part > 0 ? part - 1 : n - 1;
      while(tree_[part] != tree_[end]);
    }
  }

  /// which nodes on the boundary are joined within the face
  void find_trees(Index f)
  {
    local_.clear();
    for(Index e : edges_[f])
      for(Index k : graph_.edges[e].nodes)
        local_.push_back(k);
    local_.insert(local_.end(), around_.begin(), around_.end());
    std::sort(local_.begin(), local_.end());
    local_.erase(std::unique(local_.begin(), local_.end()), local_.end());
    const auto number = [&](Index k)
    { return static_cast<std::size_t>(std::lower_bound(local_.begin(), local_.end(), k) - local_.begin()); };
    parent_.resize(local_.size());
    for(std::size_t i = 0; i < parent_.size(); ++i)
      parent_[i] = i;
    const auto root = [&](std::size_t i)
    {
      while(parent_[i] != i)
        i = parent_[i];
      return i;
    };
    for(Index i : edges_[f])
    {
      const Tree_graph::Edge& e = graph_.edges[i];
      parent_[root(number(e.nodes[0]))] = root(number(e.nodes[1]));
      for(Index k : e.nodes)
        for(Index corner = 0; corner < 3; ++corner)
          if(is_in_corner(k, f, corner))
            parent_[root(number(k))] = root(number(in_corner_[corner]));
    }
    tree_.resize(around_.size());
    for(std::size_t i = 0; i < around_.size(); ++i)
      tree_[i] = root(number(around_[i]));
  }

  /// the part after the last node before the entrance
  std::size_t part_entered(const Face_entrance& entrance) const
  {
    const Index f = entrance.halfedge / 3;
    const auto is_before = [&](Index i)
    {
      const Index h = halfedge_in(f, i);
      const Tree_graph::Node& n = graph_.nodes[i];
      if(h != entrance.halfedge || n.halfedge == null_index) // those in corners are at the beginning of theirs
        return h <= entrance.halfedge;
      return (n.halfedge == h ? n.t : faces_.length(h) - n.t) < entrance.t;
    };
    const auto first_after = std::find_if_not(around_.begin(), around_.end(), is_before);
    return (static_cast<std::size_t>(first_after - around_.begin()) + around_.size() - 1) % around_.size();
  }

  /// the part with a point from which the straight way to the centroid crosses the graph least often; where pieces end in
  /// a corner that may be several, of which some have no length
  std::size_t part_seen(Index f)
  {
    const Plane_point c{(corners_[0].x + corners_[1].x + corners_[2].x) / 3.,
                        (corners_[0].y + corners_[1].y + corners_[2].y) / 3.};
    std::size_t best = 0, least = (std::numeric_limits<std::size_t>::max)();
    double longest = 0.;
    for(std::size_t i = 0; i < around_.size(); ++i)
    {
      const Segment part = longest_segment(f, i);
      const Plane_point p{0.5 * (part.from.x + part.to.x), 0.5 * (part.from.y + part.to.y)};
      std::size_t number = 0;
      for(Index k : edges_[f])
      {
        if(number > least)
          break;
        const Tree_graph::Edge& e = graph_.edges[k];
        number += separates(position(f, e.nodes[0]), position(f, e.nodes[1]), p, c);
      }
      if(number < least || (number == least && part.length() > longest))
      {
        least = number;
        longest = part.length();
        best = i;
      }
    }
    return best;
  }

  /// whether the piece from `a` to `b` is between `p` and `c`; what runs along an edge is before the points of that
  static bool separates(const Plane_point& a, const Plane_point& b, const Plane_point& p, const Plane_point& c)
  {
    constexpr double rounding = 1e-9;
    const double of_c = cross(a, b, c), of_p = cross(a, b, p);
    const bool is_behind = of_c > 0. ? of_p <= rounding * of_c : of_p >= rounding * of_c;
    return is_behind && (cross(c, p, a) > 0.) != (cross(c, p, b) > 0.);
  }

  struct Segment
  {
    Plane_point from, to;

    double length() const { return std::hypot(to.x - from.x, to.y - from.y); }
  };

  /// of part `i` of the boundary, which goes from a node to the next one, around corners
  Segment longest_segment(Index f, std::size_t i) const
  {
    const bool is_last = i + 1 == around_.size();
    const Index here = around_[i], next = around_[is_last ? 0 : i + 1];
    const Index first = halfedge_in(f, here) % 3, last = halfedge_in(f, next) % 3;
    if(first == last && !is_last)
      return {position(f, here), position(f, next)};
    Segment result{position(f, here), corners_[(first + 1) % 3]};
    const auto see = [&](const Segment& s)
    {
      if(s.length() > result.length())
        result = s;
    };
    for(Index k = (first + 1) % 3; k != last; k = (k + 1) % 3)
      see({corners_[k], corners_[(k + 1) % 3]});
    see({corners_[last], position(f, next)});
    return result;
  }

  /// that it is on, or starts at if it is in a corner
  Index halfedge_in(Index f, Index i) const
  {
    for(Index corner = 0; corner < 3; ++corner)
      if(in_corner_[corner] == i)
        return 3 * f + corner;
    const Index h = graph_.nodes[i].halfedge;
    return h / 3 == f ? h : mesh_.opposite[h];
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_faces& faces_;
  const Tree_graph& graph_;
  const std::vector<Face_entrance>& entrances_;
  Compressed_rows<Index> nodes_, edges_; // by edge and face of the mesh
  std::vector<Index> part_begin_;
  std::vector<unsigned char> corners_with_nodes_; // by face, a bit each
  std::vector<bool> holds_;                       // by part of a face: whether the face belongs to its cell

  // of the face in work
  Face_corners corners_;
  std::array<Index, 3> in_corner_; // nodes
  std::vector<Index> around_, local_;
  std::vector<std::size_t> parent_, tree_;
  std::vector<unsigned char> is_done_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_FACE_CELLS_H
