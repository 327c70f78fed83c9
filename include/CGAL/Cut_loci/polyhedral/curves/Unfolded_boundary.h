// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_BOUNDARY_H
#define CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_BOUNDARY_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/internal/Compressed_rows.h>
#include <CGAL/Cut_loci/polyhedral/joining/Tree_graph.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// says that the cut locus of this source can not be followed; that of a source close by may be.
struct Unfolding_failure : Invalid_input
{
  Unfolding_failure()
    : Invalid_input(Cause::TOO_INACCURATE,
                    "the cut locus of this source is not found accurately enough to cut the surface along it: too many "
                    "shortest paths to some points are equally long up to rounding, or some faces are too thin; try "
                    "another source")
  {
  }
};

/// is a point of the surface as the source sees it: the distance, and the direction in which the path there starts.
struct Polar_point
{
  double radius = 0., angle = 0.;
};

/*!
 * walks around what is left of a polyhedron without its cut locus: along both sides of each piece of the cut locus, and
 * along the border, with the surface on the left.
 *
 * All paths must be straight. Then a piece is a segment, and each side of it has the image from which paths reach it.
 */
class Unfolded_boundary
{
public:
  struct Side
  {
    std::array<Index, 2> nodes;      // from, to
    std::array<Polar_point, 2> ends; // the same as seen from this side
    double length;
    Index twin; // the other side of the piece, or null on the border
  };

  /// is where the cut locus crosses an edge of the mesh, as seen from the parts of the edge before and behind it.
  struct Crossing
  {
    Index edge;
    double t; // along `halfedge_of_edge` of the connectivity
    Index node;
    Polar_point before, behind;
  };

  std::vector<Indexed_cut_locus::Node> nodes; ///< those of the graph of the tree, then border vertices
  std::vector<Side> sides;
  std::vector<Index> order;        ///< the sides, once around counterclockwise
  std::vector<Crossing> crossings; ///< edge by edge

  Unfolded_boundary(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const Geodesic_results& geodesics, const Exact_tree& tree)
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics), tree_(tree)
  {
    for(const Tree_graph::Node& n : tree.graph().nodes)
      nodes.push_back(located(n));
    add_tree_sides();
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b)
              { return std::tie(a.edge, a.t, a.node) < std::tie(b.edge, b.t, b.node); });
    add_border_sides();
    contract();
    follow();
  }

  Polar_point polar(Index v) const
  {
    if(geodesics_.source_vertex(0) == v)
      return {0., 0.};
    return {geodesics_.distance(v), geodesics_.direction_at_source(v)};
  }

private:
  [[noreturn]] static void fail() { throw Unfolding_failure(); }

  // -- nodes -----------------------------------------------------------------------------------------------------------

  Indexed_cut_locus::Node located(const Tree_graph::Node& n) const
  {
    if(n.vertex != null_index)
      return {location_of_vertex(connectivity_, n.vertex), n.vertex, n.distance};
    Indexed_location result;
    if(n.face == null_index) // stands for a border loop
      return {result, null_index, n.distance};
    result = {n.face, coordinates_in(tree_.ridges().layout(n.face), n.point)};
    if(n.halfedge != null_index)
      result.coordinates[(n.halfedge + 2) % 3] = 0.;
    normalize(result.coordinates);
    return {result, null_index, n.distance};
  }

  /// in the frame of the first halfedge of the face
  Plane_point position(const Tree_graph::Node& n, Index f) const
  {
    if(n.face == f)
      return n.point;
    const Index o = n.halfedge != null_index ? mesh_.opposite[n.halfedge] : null_index;
    if(o != null_index && o / 3 == f)
      return across(geodesics_.faces(), n.halfedge, n.t);
    for(std::size_t i = 0; i < 3; ++i)
      if(mesh_.triangles[f][i] == n.vertex)
        return tree_.ridges().layout(f)[i];
    fail();
  }

  // -- sides -----------------------------------------------------------------------------------------------------------

  /// a point of face `f`, reached from an image
  Polar_point polar(Index f, const Image& image, const Plane_point& p) const
  {
    if(!geodesics_.is_source(image.origin))
      fail();
    return {image.distance(p), image.direction_to(p, tree_.ridges().layout(f))};
  }

  void add_tree_sides()
  {
    const Tree_graph& graph = tree_.graph();
    std::vector<Index> crossing(nodes.size(), null_index);
    for(const Tree_graph::Edge& e : graph.edges)
    {
      if(e.is_virtual)
        continue;
      if(e.piece == null_index)
        fail();
      // the first image is on the left of the way from the first node to the second
      const Ridges::Piece& piece = tree_.ridges().piece(e.piece);
      const Plane_point p = position(graph.nodes[e.nodes[0]], e.face), q = position(graph.nodes[e.nodes[1]], e.face);
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      const Index i = static_cast<Index>(sides.size());
      sides.push_back({{{e.nodes[0], e.nodes[1]}},
                       {{polar(e.face, piece.images[0], p), polar(e.face, piece.images[0], q)}},
                       length,
                       i + 1});
      sides.push_back({{{e.nodes[1], e.nodes[0]}},
                       {{polar(e.face, piece.images[1], q), polar(e.face, piece.images[1], p)}},
                       length,
                       i});
      for(Index k = 0; k < 2; ++k)
        if(graph.nodes[e.nodes[k]].halfedge != null_index && graph.nodes[e.nodes[k]].halfedge / 3 == e.face)
          add_crossing(e.nodes[k], sides[i + k].ends[0], sides[i + 1 - k].ends[1]);
    }
  }

  /// `out` is on the side that leads into the face of the halfedge, and has the begin of the halfedge on its left
  void add_crossing(Index node, const Polar_point& out, const Polar_point& in)
  {
    const Tree_graph::Node& n = tree_.graph().nodes[node];
    const Index e = connectivity_.edge_of_halfedge[n.halfedge];
    if(connectivity_.halfedge_of_edge[e] == n.halfedge)
      crossings.push_back({e, n.t, node, out, in});
    else
      crossings.push_back({e, geodesics_.faces().length(n.halfedge) - n.t, node, in, out});
  }

  /// the parts of border edges between the ends of the cut locus on them
  void add_border_sides()
  {
    if(connectivity_.number_of_border_loops == 0)
      return;
    std::vector<Index> node_of_vertex(mesh_.number_of_vertices(), null_index);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(connectivity_.is_border(v))
      {
        node_of_vertex[v] = static_cast<Index>(nodes.size());
        nodes.push_back({location_of_vertex(connectivity_, v), v, geodesics_.distance(v)});
      }
    std::size_t next = 0;
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      const Index h = connectivity_.halfedge_of_edge[e];
      const auto begin = crossings.begin() + static_cast<std::ptrdiff_t>(next);
      while(next < crossings.size() && crossings[next].edge == e)
        ++next;
      if(!mesh_.is_border_edge(h))
        continue;
      Index node = node_of_vertex[mesh_.source(h)];
      Polar_point from = polar(mesh_.source(h));
      double t = 0.;
      for(auto c = begin; c != crossings.begin() + static_cast<std::ptrdiff_t>(next); ++c)
      {
        sides.push_back({{{node, c->node}}, {{from, c->before}}, c->t - t, null_index});
        node = c->node;
        from = c->behind;
        t = c->t;
      }
      const Index v = mesh_.target(h);
      sides.push_back({{{node, node_of_vertex[v]}}, {{from, polar(v)}}, geodesics_.faces().length(h) - t, null_index});
    }
  }

  // -- sides of no length ----------------------------------------------------------------------------------------------

  /// Where more than three pieces meet, or the cut locus goes through a vertex, sides of no length may lie in between, in
  /// any order: they are left out, and their ends become one. So do all that are at one vertex.
  void contract()
  {
    const double least = 1e-10 * connectivity_.mean_edge_length; // below the accuracy of what is left
    std::vector<Index> parent(nodes.size()), number(sides.size(), null_index);
    for(Index i = 0; i < parent.size(); ++i)
      parent[i] = i;
    const auto root = [&](Index i)
    {
      while(parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    std::vector<Index> at_vertex(mesh_.number_of_vertices(), null_index);
    for(Index i = 0; i < nodes.size(); ++i)
      if(nodes[i].vertex != null_index)
      {
        Index& first = at_vertex[nodes[i].vertex];
        first = first != null_index ? first : i;
        parent[i] = first;
      }
    std::size_t size = 0;
    for(std::size_t s = 0; s < sides.size(); ++s)
    {
      if(sides[s].length > least)
      {
        number[s] = static_cast<Index>(size);
        sides[size++] = sides[s];
        continue;
      }
      // one that is at a vertex says so for all
      const Index i = root(sides[s].nodes[0]), j = root(sides[s].nodes[1]);
      if(nodes[i].vertex != null_index)
        parent[j] = i;
      else
        parent[i] = j;
    }
    sides.resize(size);
    for(Side& side : sides)
    {
      for(Index& i : side.nodes)
        i = root(i);
      side.twin = side.twin != null_index ? number[side.twin] : null_index;
    }
  }

  // -- the way around --------------------------------------------------------------------------------------------------

  void follow()
  {
    std::array<Compressed_rows<Index>, 2> at; // the sides that start, and those that end, at each node
    for(std::size_t end : {0, 1})
    {
      const auto enumerate = [&](const auto& add)
      {
        for(Index i = 0; i < sides.size(); ++i)
          add(sides[i].nodes[end], i);
      };
      at[end] = Compressed_rows<Index>(nodes.size(), enumerate);
    }
    next_.assign(sides.size(), null_index);
    for(Index i = 0; i < nodes.size(); ++i)
    {
      if(at[0].size(i) != at[1].size(i))
        fail();
      join({at[1][i].begin(), at[1][i].end()}, {at[0][i].begin(), at[0][i].end()});
    }
    for(Index i = 0; order.size() < sides.size(); i = next_[i])
    {
      if(i == null_index || (i == 0 && !order.empty()))
        fail();
      order.push_back(i);
    }
    if(!order.empty() && next_[order.back()] != 0)
      fail();
  }

  bool is_on_border(Index side) const { return sides[side].twin == null_index; }

  /// Each side goes on with the one of the same surface. At the end of a branch, that is its other side; at the border,
  /// the cut locus and the border alternate; else it is the one that starts in the same direction from the source.
  void join(const std::vector<Index>& in, const std::vector<Index>& out)
  {
    if(in.size() == 1)
    {
      next_[in[0]] = out[0];
      return;
    }
    struct Pair
    {
      double difference;
      Index in, out;
    };
    std::vector<Pair> pairs;
    for(Index i : in)
      for(Index o : out)
        if(sides[i].twin != o && !(is_on_border(i) && is_on_border(o)))
          pairs.push_back(
            {std::fabs(std::remainder(sides[i].ends[1].angle - sides[o].ends[0].angle, full_angle())), i, o});
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b)
              { return std::tie(a.difference, a.in, a.out) < std::tie(b.difference, b.in, b.out); });
    std::vector<Index> is_used;
    for(const Pair& p : pairs)
      if(next_[p.in] == null_index && std::find(is_used.begin(), is_used.end(), p.out) == is_used.end())
      {
        next_[p.in] = p.out;
        is_used.push_back(p.out);
      }
  }

  double full_angle() const { return geodesics_.is_source_on_border() ? 4. * geodesic_pi : geodesics_.source_angle(); }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_results& geodesics_;
  const Exact_tree& tree_;
  std::vector<Index> next_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_CURVES_UNFOLDED_BOUNDARY_H
