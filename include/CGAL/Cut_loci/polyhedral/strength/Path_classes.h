// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_PATH_CLASSES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_PATH_CLASSES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/geodesic_path_tracing.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells around what the shortest paths to two neighboring vertices lead, however small the angle between them.
 *
 * With the edge between its ends, two such paths are a closed curve. If it leads around a handle, or has some of the
 * marks on each of its sides, such as holes and parts of the cut locus that are known, the cut locus crosses the edge on
 * its way from one to the other. That is a matter of homology modulo 2: chains of edges between the marks, and around the
 * handles, tell by how often the curve crosses them. Each chain is a random number of 64 bits, and a set of chains the
 * exclusive or of theirs. Chains follow a spanning tree of edges; one around a handle has one edge more, which neither this
 * tree has nor one of the dual graph without it \cgalCite{cgal:ew-gohhb-05}.
 *
 * Where a chain passes a vertex, it is pushed a little to one side: each corner has the set of chains to be crossed on the
 * way around the vertex from its first corner. So chains and paths may meet in vertices and run along the same edges.
 *
 * Chains keep as far from the sources as they can. Paths are traced back to the next vertex only, and no nearer than chains
 * get: so the time is the number of vertices that are farther times that of the faces that paths cross there.
 */
class Path_classes
{
public:
  /// is a point of something that paths may separate from other things: of a border loop, or of an edge that nothing else
  /// crosses there.
  struct Mark
  {
    Index halfedge;
    double t; // on it, from its source, which it is if this is zero
  };

  Path_classes(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
               const Exact_geodesic_propagation& geodesics, const std::vector<Mark>& marks)
    : mesh_(mesh), connectivity_(connectivity), geodesics_(geodesics)
  {
    find_chains(marks);
    find_least_distance();
    find_corners();
    find_paths();
  }

  /// whether the paths to the ends of an edge from the same source, with it, separate marks or lead around a handle; also
  /// if one of them cannot be traced
  bool separates(Index h) const
  {
    const Index u = mesh_.source(h), v = mesh_.target(h);
    if(geodesics_.nearest_source(u) != geodesics_.nearest_source(v))
      return false;
    return is_lost_[u] || is_lost_[v] || (path_[u] ^ path_[v] ^ along_edge(h)) != 0;
  }

private:
  using Chains = std::uint64_t; // a set of them

  // -- chains ----------------------------------------------------------------------------------------------------------

  void find_chains(const std::vector<Mark>& marks)
  {
    chains_.assign(connectivity_.number_of_edges(), 0);
    has_parts_.assign(connectivity_.number_of_edges(), 0);
    grow_tree();
    ends_.assign(mesh_.number_of_vertices(), 0);
    for(std::size_t i = 1; i < marks.size(); ++i)
    {
      const Chains chain = add_chain(mesh_.source(marks[0].halfedge), mesh_.source(marks[i].halfedge));
      extend(chain, marks[0]);
      extend(chain, marks[i]);
    }
    add_handles();
    for(std::size_t i = order_.size(); i-- > 1;)
    {
      const Index v = order_[i], h = to_root_[v];
      chains_[connectivity_.edge_of_halfedge[h]] ^= ends_[v];
      ends_[mesh_.source(h) == v ? mesh_.target(h) : mesh_.source(h)] ^= ends_[v];
    }
  }

  /// from vertex to vertex, the farthest one first of those that have been reached: what leads from one to another in the
  /// tree is nowhere nearer than it has to be
  void grow_tree()
  {
    to_root_.assign(mesh_.number_of_vertices(), null_index);
    using Reached = std::pair<double, Index>;
    std::priority_queue<Reached> reached;
    const Index root = mesh_.triangles[0][0];
    reached.push({geodesics_.distance(root), root});
    while(!reached.empty())
    {
      const Index u = reached.top().second;
      reached.pop();
      order_.push_back(u);
      for(Index k = connectivity_.ring_begin[u]; k < connectivity_.ring_begin[u + 1]; ++k)
      {
        const Index v = connectivity_.ring_vertex[k];
        if(to_root_[v] != null_index || v == root)
          continue;
        to_root_[v] = connectivity_.ring_halfedge[k];
        reached.push({geodesics_.distance(v), v});
      }
    }
  }

  Chains add_chain(Index from, Index to)
  {
    const Chains chain = random_();
    ends_[from] ^= chain;
    ends_[to] ^= chain;
    return chain;
  }

  /// from the source of the halfedge up to the mark
  void extend(Chains chain, const Mark& mark)
  {
    const Index edge = connectivity_.edge_of_halfedge[mark.halfedge];
    if(mark.t > 0.)
      parts_[edge].push_back({chain, mark});
    has_parts_[edge] |= mark.t > 0.;
  }

  /// the edges that neither the tree has nor the one dual to the rest, which has those first that the tree has come to last
  void add_handles()
  {
    if(connectivity_.genus(mesh_) == 0)
      return;
    std::vector<Index> position(mesh_.number_of_vertices());
    for(Index i = 0; i < order_.size(); ++i)
      position[order_[i]] = i;
    Union_find faces(std::size_t(mesh_.number_of_faces()) + connectivity_.number_of_border_loops);
    for(std::size_t i = order_.size(); i-- > 1;)
      for(Index v = order_[i], k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      {
        const Index e = connectivity_.ring_edge(k), h = connectivity_.halfedge_of_edge[e], o = mesh_.opposite[h];
        if(position[connectivity_.ring_vertex[k]] > i || e == connectivity_.edge_of_halfedge[to_root_[v]])
          continue;
        const Index beside =
          o != null_index ? o / 3 : mesh_.number_of_faces() + connectivity_.border_loop[mesh_.source(h)];
        if(!faces.unite(h / 3, beside))
          chains_[e] ^= add_chain(mesh_.source(h), mesh_.target(h));
      }
  }

  /// of all chains from the sources, or less: where a chain runs along a path, rounding must not leave out its vertices
  void find_least_distance()
  {
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      const Index h = connectivity_.halfedge_of_edge[e];
      const double ends = geodesics_.distance(mesh_.source(h)) + geodesics_.distance(mesh_.target(h));
      if(chains_[e] != 0 || has_parts_[e])
        least_distance_ = (std::min)(least_distance_, 0.5 * (ends - geodesics_.faces().length(h)));
    }
    least_distance_ *= 1. - geodesic_cover;
  }

  /// from the first corner of each vertex around it
  void find_corners()
  {
    at_corner_.assign(mesh_.number_of_halfedges(), 0);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
    {
      const Index begin = connectivity_.ring_begin[v];
      Chains crossed = 0;
      for(Index k = begin; k < connectivity_.ring_begin[v + 1]; ++k)
      {
        if(k > begin)
          crossed ^= chains_at(connectivity_.ring_edge(k), v);
        if(mesh_.source(connectivity_.ring_halfedge[k]) == v)
          at_corner_[connectivity_.ring_halfedge[k]] = crossed;
      }
    }
  }

  /// through an edge beside one of its ends
  Chains chains_at(Index edge, Index v) const
  {
    Chains result = chains_[edge];
    if(has_parts_[edge])
      for(const Part& part : parts_.at(edge))
        if(mesh_.source(part.mark.halfedge) == v)
          result ^= part.chain;
    return result;
  }

  /// through an edge at the length `t` from the source of the halfedge
  Chains chains_at(Index h, double t) const
  {
    const Index edge = connectivity_.edge_of_halfedge[h];
    Chains result = chains_[edge];
    if(has_parts_[edge])
      for(const Part& part : parts_.at(edge))
        if((part.mark.halfedge == h ? t : geodesics_.faces().length(h) - t) < part.mark.t)
          result ^= part.chain;
    return result;
  }

  // -- paths -----------------------------------------------------------------------------------------------------------

  void find_paths()
  {
    path_.assign(mesh_.number_of_vertices(), 0);
    is_lost_.assign(mesh_.number_of_vertices(), 0);
    std::vector<Index> order; // paths to the vertices at which others start come first
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(geodesics_.distance(v) > 0. && geodesics_.distance(v) >= least_distance_)
        order.push_back(v);
    std::sort(order.begin(), order.end(),
              [this](Index a, Index b) { return geodesics_.distance(a) < geodesics_.distance(b); });
    Geodesic_path_tracing tracing(geodesics_);
    for(Index v : order)
    {
      Index begin = null_index;
      const std::vector<Indexed_location>& piece = tracing.last_piece(v, least_distance_, begin);
      for(std::size_t i = 0; i + 1 < piece.size() && !is_lost_[v]; ++i)
        add_step(v, piece[i], piece[i + 1], begin == null_index && i + 2 == piece.size());
      if(begin != null_index && geodesics_.distance(begin) < geodesics_.distance(v))
      {
        path_[v] ^= path_[begin];
        is_lost_[v] |= is_lost_[begin];
      }
    }
  }

  /// through one face, or along an edge
  void add_step(Index v, const Indexed_location& from, const Indexed_location& to, bool ends_at_source)
  {
    const Index a = vertex_of(mesh_, from), b = vertex_of(mesh_, to);
    if(a != null_index && b != null_index)
    {
      const Index h = halfedge_between(a, b);
      is_lost_[v] = h == null_index;
      path_[v] ^= h != null_index ? along_edge(h) : 0;
      return;
    }
    const Index h = edge_of(to);
    if(a == null_index && b == null_index && h != null_index && !ends_at_source)
    {
      path_[v] ^= chains_at(h, to.coordinates[(h + 1) % 3] * geodesics_.faces().length(h));
      return;
    }
    // a source on an edge is taken to be on one side of it
    const Index side = h != null_index ? (std::min)(h, mesh_.opposite[h]) / 3 : to.face;
    const Index face = common_face(from, to, side);
    is_lost_[v] |= face == null_index;
    if(is_lost_[v])
      return;
    for(Index end : {a, b})
      if(end != null_index)
        path_[v] ^= at_corner_[corner_of(end, face)];
    if(h != null_index && (!ends_at_source || face != side))
      path_[v] ^= chains_at(h, to.coordinates[(h + 1) % 3] * geodesics_.faces().length(h));
  }

  /// one in which, or on the boundary of which, both points are: `first`, if possible; no two vertices
  Index common_face(const Indexed_location& p, const Indexed_location& q, Index first) const
  {
    Index result = null_index;
    for_each_common_face(mesh_, connectivity_, p, q,
                         [&](Index f) { result = result == null_index || f == first ? f : result; });
    return result;
  }

  /// beside it, in the face of the halfedge
  Chains along_edge(Index h) const { return at_corner_[h] ^ at_corner_[Indexed_triangle_mesh::next(h)]; }

  Index halfedge_between(Index a, Index b) const
  {
    for(Index k = connectivity_.ring_begin[a]; k < connectivity_.ring_begin[a + 1]; ++k)
      if(connectivity_.ring_vertex[k] == b)
        return connectivity_.ring_halfedge[k];
    return null_index;
  }

  Index corner_of(Index v, Index f) const
  {
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(mesh_.source(h) == v)
        return h;
    return null_index;
  }

  // of an edge
  struct Part
  {
    Chains chain;
    Mark mark; // at its end
  };

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Exact_geodesic_propagation& geodesics_;
  std::mt19937_64 random_;
  std::vector<Index> order_;                           // of the vertices, from the root of the tree
  std::vector<Index> to_root_;                         // by vertex: a halfedge of the edge of the tree
  std::vector<Chains> chains_;                         // through each edge
  std::vector<unsigned char> has_parts_;               // by edge, whether chains end on it
  std::unordered_map<Index, std::vector<Part>> parts_; // of those
  std::vector<Chains> ends_;                           // at each vertex
  std::vector<Chains> at_corner_;                      // by halfedge, at its source
  std::vector<Chains> path_;                           // to each vertex
  std::vector<unsigned char> is_lost_;
  double least_distance_ = (std::numeric_limits<double>::infinity)();
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_PATH_CLASSES_H
