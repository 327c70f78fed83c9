// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_LIMITS_H
#define CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_LIMITS_H

#include <CGAL/Cut_loci/graph/Curve_network.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/crossing_edges.h>
#include <CGAL/Cut_loci/laplacian/Sides_of_arrival.h>
#include <CGAL/Cut_loci/laplacian/Steepest_descent.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Local_geodesics.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// How far the nodes of a graph of mesh edges may move.
//
// The graph stays what it is, up to homotopy, if each node stays in the faces around its vertex, the segments between
// neighbors in those around both, and these are disks. If segments do not meet either, its complement stays an open
// disk. And no shortest path may be crossed that was not before: a vertex stays on the side where its path arrives.
class Smoothing_limits
{
public:
  // the places of a chain that an edge of the smoothed graph joins
  struct Span
  {
    Index chain, from, to;
  };

  Smoothing_limits(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                   const std::vector<double>& distance, const Indexed_cut_locus& input, const Curve_network& network,
                   const std::vector<Index>& source_of_face)
    : mesh_(mesh), connectivity_(connectivity), input_(input), network_(network), source_of_face_(source_of_face),
      geodesics_(mesh, connectivity), sides_(mesh, connectivity, distance, input, network),
      descent_(mesh, connectivity, distance)
  {
    for(Index node = 0; node < input.nodes.size(); ++node)
      forbidden_.push_back(sides_.faces(node));
  }

  // in the faces around its own vertex, not between that and the path that arrives there, and in none of a source
  bool may_be_at(Index node, const Indexed_location& x) const
  {
    if(is_at_source(x, x))
      return false;
    bool result = false;
    const std::vector<Index>& forbidden = forbidden_[node];
    geodesics_.for_each_common_face(x, x,
                                    [&](Index f)
                                    {
      result = result || (has_corner(f, vertex_of_node(node)) &&
                          std::find(forbidden.begin(), forbidden.end(), f) == forbidden.end());
    });
    return result;
  }

  // The edges of a smoothed graph that are where they must not be.
  std::vector<Index> misplaced(const Indexed_cut_locus& graph, const std::vector<Span>& spans,
                               const std::vector<Indexed_location>& location) const
  {
    std::vector<Index> result = crossing_edges(geodesics_, graph);
    add_touching_edges(graph, result);
    add_slipped_edges(graph, spans, location, result);
    for(Index e = 0; e < graph.edges.size() && !source_of_face_.empty(); ++e)
      if(is_at_source(graph.nodes[graph.edges[e].source].location, graph.nodes[graph.edges[e].target].location))
        result.push_back(e);
    add_edges_across_paths(graph, result);
    return result;
  }

private:
  using Leg = Sides_of_arrival::Leg;

  struct Piece
  {
    Index face, edge;
  };

  // whether a segment is inside the faces of a source, and not on their boundary
  bool is_at_source(const Indexed_location& a, const Indexed_location& b) const
  {
    if(source_of_face_.empty())
      return false;
    bool is_first = true, result = false;
    Index source = null_index;
    geodesics_.for_each_common_face(a, b,
                                    [&](Index f)
                                    {
      result = source_of_face_[f] != null_index && (is_first || (result && source_of_face_[f] == source));
      source = source_of_face_[f];
      is_first = false;
    });
    return result;
  }

  Index vertex_of_node(Index node) const { return input_.nodes[node].vertex; }

  bool has_corner(Index f, Index v) const
  {
    const Indexed_triangle_mesh::Triangle& t = mesh_.triangles[f];
    return t[0] == v || t[1] == v || t[2] == v;
  }

  // A point of the mesh as numbers that its faces agree on, rounded: points that are closer than that are as good as
  // one for whoever cuts along the curve.
  std::array<Index, 4> key_of(const Indexed_location& x) const
  {
    constexpr double resolution = 1 << 16;
    const auto rounded = [&](double c) { return static_cast<Index>(std::lround(c * resolution)); };
    std::array<Index, 3> c;
    for(int i = 0; i < 3; ++i)
      c[i] = rounded(x.coordinates[i]);
    for(Index i = 0; i < 3; ++i)
      if(c[(i + 1) % 3] == 0 && c[(i + 2) % 3] == 0)
        return {{0, mesh_.triangles[x.face][i], 0, 0}};
    for(Index i = 0; i < 3; ++i)
      if(c[(i + 2) % 3] == 0)
      {
        const Index h = 3 * x.face + i, edge = connectivity_.edge_of_halfedge[h];
        return {{1, edge, connectivity_.halfedge_of_edge[edge] == h ? c[i] : c[(i + 1) % 3], 0}};
      }
    return {{2, x.face, c[0], c[1]}};
  }

  // The edges at nodes that have come to lie on another one, or on the border.
  void add_touching_edges(const Indexed_cut_locus& graph, std::vector<Index>& edges) const
  {
    std::map<std::array<Index, 4>, Index> first;
    std::vector<bool> is_touching(graph.nodes.size(), false);
    for(Index i = 0; i < graph.nodes.size(); ++i)
    {
      const auto key = key_of(graph.nodes[i].location);
      const auto inserted = first.insert({key, i});
      if(!inserted.second)
        is_touching[i] = is_touching[inserted.first->second] = true;
      if(key[0] == 1 && mesh_.is_border_edge(connectivity_.halfedge_of_edge[key[1]]))
        is_touching[i] = true;
      if(key[0] == 0 && connectivity_.is_border(key[1]) && network_.node_of_vertex(key[1]) == null_index)
        is_touching[i] = true;
    }
    add_edges_at(graph, is_touching, edges);
  }

  static void add_edges_at(const Indexed_cut_locus& graph, const std::vector<bool>& is_marked,
                           std::vector<Index>& edges)
  {
    for(Index e = 0; e < graph.edges.size(); ++e)
      if(is_marked[graph.edges[e].source] || is_marked[graph.edges[e].target])
        edges.push_back(e);
  }

  void add_slipped_edges(const Indexed_cut_locus& graph, const std::vector<Span>& spans,
                         const std::vector<Indexed_location>& location, std::vector<Index>& edges) const
  {
    for(Index first = 0, end; first < graph.edges.size(); first = end)
    {
      const Span& span = spans[first];
      const auto is_same = [&](const Span& s) { return s.chain == span.chain && s.from == span.from; };
      for(end = first + 1; end < graph.edges.size() && is_same(spans[end]);)
        ++end;
      const std::vector<Index>& nodes = network_.chains[span.chain].nodes;
      bool is_safe = is_around_own_vertex(location, nodes[span.from]) &&
                     is_around_own_vertex(location, nodes[span.to]) && has_disk_around(span);
      for(Index e = first; e < end; ++e)
        is_safe = is_safe && is_around(span, graph.nodes[graph.edges[e].source].location,
                                       graph.nodes[graph.edges[e].target].location);
      for(Index e = first; e < end && !is_safe; ++e)
        edges.push_back(e);
    }
  }

  bool is_around_own_vertex(const std::vector<Indexed_location>& location, Index node) const
  {
    bool result = false;
    geodesics_.for_each_common_face(location[node], location[node],
                                    [&](Index f) { result = result || has_corner(f, vertex_of_node(node)); });
    return result;
  }

  // whether a segment is in the faces around the vertices of a span
  bool is_around(const Span& span, const Indexed_location& a, const Indexed_location& b) const
  {
    bool result = false;
    geodesics_.for_each_common_face(a, b,
                                    [&](Index f)
                                    {
      for(Index place = span.from; place <= span.to; ++place)
        result = result || has_corner(f, vertex_of_node(network_.chains[span.chain].nodes[place]));
    });
    return result;
  }

  // The faces around the vertices of a span, which are connected, form a disk if their Euler characteristic is one.
  bool has_disk_around(const Span& span) const
  {
    std::set<Index> faces, edges, vertices;
    for(Index place = span.from; place <= span.to; ++place)
    {
      const Index v = vertex_of_node(network_.chains[span.chain].nodes[place]);
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
        if(mesh_.source(connectivity_.ring_halfedge[k]) == v)
          faces.insert(connectivity_.ring_halfedge[k] / 3);
    }
    for(Index f : faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        edges.insert(connectivity_.edge_of_halfedge[h]);
        vertices.insert(mesh_.source(h));
      }
    return vertices.size() + faces.size() == edges.size() + 1;
  }

  // The edges that cut a vertex next to them off from where its shortest path arrives.
  void add_edges_across_paths(const Indexed_cut_locus& graph, std::vector<Index>& edges) const
  {
    std::vector<Piece> pieces;
    for(Index e = 0; e < graph.edges.size(); ++e)
      geodesics_.for_each_common_face(graph.nodes[graph.edges[e].source].location,
                                      graph.nodes[graph.edges[e].target].location,
                                      [&](Index f) {
        pieces.push_back({f, e});
      });
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& s, const Piece& t) { return s.face != t.face ? s.face < t.face : s.edge < t.edge; });
    std::map<Index, std::vector<Index>> nodes_on; // edges of the mesh
    for(Index i = 0; i < graph.nodes.size(); ++i)
    {
      const Index h = edge_of(graph.nodes[i].location);
      if(h != null_index)
        nodes_on[connectivity_.edge_of_halfedge[h]].push_back(i);
    }
    std::set<Index> vertices;
    for(const Piece& p : pieces)
      vertices.insert(mesh_.triangles[p.face].begin(), mesh_.triangles[p.face].end());

    std::vector<bool> is_across(graph.nodes.size(), false);
    for(Index v : vertices)
    {
      const Index node = network_.node_of_vertex(v);
      if(node != null_index)
      {
        add_edges_across(graph, pieces, sides_.leg(node), edges);
        continue;
      }
      const Steepest_descent::Outflow out = descent_.outflow(v);
      if(out.halfedge == null_index)
        continue;
      if(!out.is_along)
      {
        add_edges_across(graph, pieces, {mesh_.next(out.halfedge), out.place}, edges);
        continue;
      }
      const auto found = nodes_on.find(connectivity_.edge_of_halfedge[out.halfedge]);
      if(found != nodes_on.end() && found->second.size() % 2 == 1)
        for(Index i : found->second)
          is_across[i] = true;
    }
    add_edges_at(graph, is_across, edges);
  }

  void add_edges_across(const Indexed_cut_locus& graph, const std::vector<Piece>& pieces, const Leg& leg,
                        std::vector<Index>& edges) const
  {
    if(leg.halfedge == null_index)
      return;
    const Index f = leg.halfedge / 3, i = leg.halfedge % 3;
    // two of the barycentric coordinates: an affine map keeps crossings
    const Planar_vector foot = {{1. - leg.place, leg.place}}, along = {{-foot[0], -foot[1]}};
    const auto place = [&](Index node) -> Planar_vector
    {
      const auto c = geodesics_.in_face(graph.nodes[node].location, f).coordinates;
      return {{c[i], c[(i + 1) % 3]}};
    };
    const std::size_t before = edges.size();
    for(auto p = std::lower_bound(pieces.begin(), pieces.end(), f, [](const Piece&s, Index g) { return s.face < g; });
        p != pieces.end() && p->face == f; ++p)
    {
      const Planar_vector a = place(graph.edges[p->edge].source), b = place(graph.edges[p->edge].target);
      if(cross(along, a - foot) * cross(along, b - foot) < 0. &&
         cross(b - a, foot - a) * cross(b - a, {{-a[0], -a[1]}}) < 0.)
        edges.push_back(p->edge);
    }
    if((edges.size() - before) % 2 == 0)
      edges.resize(before);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Indexed_cut_locus& input_;
  const Curve_network& network_;
  const std::vector<Index>& source_of_face_; // the source at a face, or null; empty if they are not known
  Local_geodesics geodesics_;
  Sides_of_arrival sides_;
  Steepest_descent descent_;
  std::vector<std::vector<Index>> forbidden_; // for each node, the faces from which its vertex must not be cut off
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_SMOOTHING_LIMITS_H
