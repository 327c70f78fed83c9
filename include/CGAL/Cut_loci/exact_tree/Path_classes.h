// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_PATH_CLASSES_H
#define CGAL_CUT_LOCI_EXACT_TREE_PATH_CLASSES_H

#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_path_tracing.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * tells around what the shortest paths to two neighboring vertices lead, however small the angle between them.
 *
 * With the edge between its ends, two such paths are a closed curve. If it leads around a handle, or has some of the
 * marks on each of its sides, such as holes and parts of the cut locus that are known, the cut locus crosses the edge on
 * its way from one to the other. That is a matter of homology modulo 2: chains of edges between the marks, and around the
 * handles, tell by how often the curve crosses them. Each chain is a random number of 64 bits, and a set of them the
 * exclusive or of these. They follow a spanning tree of edges, and those around handles
 * one edge more, which is not in a tree dual to the rest either \cgalCite{cgal:ew-gohhb-05}.
 *
 * Where a chain passes a vertex, it is pushed a little to one side: each corner has the set of chains to be crossed on the
 * way around the vertex from its first corner. So chains and paths may meet in vertices and run along the same edges.
 *
 * Paths are traced back to the next vertex only; so the time is the number of vertices times that of the faces that the
 * last straight piece of a path crosses.
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

  void grow_tree()
  {
    to_root_.assign(mesh_.number_of_vertices(), null_index);
    order_.assign(1, mesh_.triangles[0][0]);
    for(std::size_t i = 0; i < order_.size(); ++i)
      for(Index k = connectivity_.ring_begin[order_[i]]; k < connectivity_.ring_begin[order_[i] + 1]; ++k)
      {
        const Index v = connectivity_.ring_vertex[k];
        if(to_root_[v] != null_index || v == order_[0])
          continue;
        to_root_[v] = connectivity_.ring_halfedge[k];
        order_.push_back(v);
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
    if(mark.t > 0.)
      parts_[connectivity_.edge_of_halfedge[mark.halfedge]].push_back({chain, mark});
  }

  /// the edges that neither the tree has nor the one dual to the rest
  void add_handles()
  {
    std::vector<unsigned char> is_in_tree(connectivity_.number_of_edges(), 0);
    for(std::size_t i = 1; i < order_.size(); ++i)
      is_in_tree[connectivity_.edge_of_halfedge[to_root_[order_[i]]]] = 1;
    Union_find faces(std::size_t(mesh_.number_of_faces()) + connectivity_.number_of_border_loops);
    for(Index e = 0; e < connectivity_.number_of_edges(); ++e)
    {
      const Index h = connectivity_.halfedge_of_edge[e], o = mesh_.opposite[h];
      const Index beside =
        o != null_index ? o / 3 : mesh_.number_of_faces() + connectivity_.border_loop[mesh_.source(h)];
      if(!is_in_tree[e] && !faces.unite(h / 3, beside))
        chains_[e] ^= add_chain(mesh_.source(h), mesh_.target(h));
    }
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
    const auto parts = parts_.find(edge);
    for(std::size_t i = 0; parts != parts_.end() && i < parts->second.size(); ++i)
      if(mesh_.source(parts->second[i].mark.halfedge) == v)
        result ^= parts->second[i].chain;
    return result;
  }

  /// through an edge at the length `t` from the source of the halfedge
  Chains chains_at(Index h, double t) const
  {
    const Index edge = connectivity_.edge_of_halfedge[h];
    Chains result = chains_[edge];
    const auto parts = parts_.find(edge);
    for(std::size_t i = 0; parts != parts_.end() && i < parts->second.size(); ++i)
    {
      const Mark& mark = parts->second[i].mark;
      if((mark.halfedge == h ? t : geodesics_.faces().length(h) - t) < mark.t)
        result ^= parts->second[i].chain;
    }
    return result;
  }

  // -- paths -----------------------------------------------------------------------------------------------------------

  void find_paths()
  {
    path_.assign(mesh_.number_of_vertices(), 0);
    is_lost_.assign(mesh_.number_of_vertices(), 0);
    std::iota(order_.begin(), order_.end(), Index(0));
    std::sort(order_.begin(), order_.end(),
              [this](Index a, Index b) { return geodesics_.distance(a) < geodesics_.distance(b); });
    Geodesic_path_tracing tracing(geodesics_);
    for(Index v : order_)
    {
      if(!(geodesics_.distance(v) > 0.))
        continue;
      Index begin = null_index;
      const std::vector<Indexed_location>& piece = tracing.last_piece(v, begin);
      for(std::size_t i = 0; i + 1 < piece.size() && !is_lost_[v]; ++i)
        add_step(v, piece[i], piece[i + 1]);
      if(begin != null_index && geodesics_.distance(begin) < geodesics_.distance(v))
      {
        path_[v] ^= path_[begin];
        is_lost_[v] |= is_lost_[begin];
      }
    }
  }

  /// through one face, or along an edge
  void add_step(Index v, const Indexed_location& from, const Indexed_location& to)
  {
    const Index a = vertex_at(from), b = vertex_at(to);
    if(a != null_index && b != null_index)
    {
      const Index h = halfedge_between(a, b);
      is_lost_[v] = h == null_index;
      path_[v] ^= h != null_index ? along_edge(h) : 0;
      return;
    }
    if(a != null_index)
      leave_or_reach(v, a, to);
    if(b != null_index)
      leave_or_reach(v, b, from);
    const Index h = halfedge_at(to);
    if(b == null_index && h != null_index)
      path_[v] ^= chains_at(h, to.coordinates[(h + 1) % 3] * geodesics_.faces().length(h));
  }

  /// the vertex `a`, in the face in which both are
  void leave_or_reach(Index v, Index a, const Indexed_location& other)
  {
    const Index h = halfedge_at(other), o = h != null_index ? mesh_.opposite[h] : null_index;
    Index corner = corner_of(a, other.face);
    if(corner == null_index && o != null_index)
      corner = corner_of(a, o / 3);
    is_lost_[v] |= corner == null_index;
    path_[v] ^= corner != null_index ? at_corner_[corner] : 0;
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

  Index vertex_at(const Indexed_location& p) const
  {
    for(Index i = 0; i < 3; ++i)
      if(p.coordinates[(i + 1) % 3] == 0. && p.coordinates[(i + 2) % 3] == 0.)
        return mesh_.triangles[p.face][i];
    return null_index;
  }

  /// a halfedge of the edge that a point lies on which is no vertex, or null
  static Index halfedge_at(const Indexed_location& p)
  {
    for(Index i = 0; i < 3; ++i)
      if(p.coordinates[(i + 2) % 3] == 0.)
        return 3 * p.face + i;
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
  std::vector<Index> order_;                           // of the vertices: from the root of the tree, later by distance
  std::vector<Index> to_root_;                         // by vertex: a halfedge of the edge of the tree
  std::vector<Chains> chains_;                         // through each edge
  std::unordered_map<Index, std::vector<Part>> parts_; // of edges on which chains end
  std::vector<Chains> ends_;                           // at each vertex
  std::vector<Chains> at_corner_;                      // by halfedge, at its source
  std::vector<Chains> path_;                           // to each vertex
  std::vector<unsigned char> is_lost_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_PATH_CLASSES_H
