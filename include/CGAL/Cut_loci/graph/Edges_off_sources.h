// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_EDGES_OFF_SOURCES_H
#define CGAL_CUT_LOCI_GRAPH_EDGES_OFF_SOURCES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * numbers what counts as one node of a graph of mesh edges: each border loop that is not all source, each one that is,
 * and each vertex inside, in this order.
 *
 * An arc of a loop that is a source is a point on that node: edges that end there separate what is on their two sides, as
 * those to the rest of the loop do. At a loop that is a source, a single edge separates nothing.
 */
class Nodes_with_sources
{
public:
  Nodes_with_sources(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                     const Source_parts& parts)
    : mesh_(mesh), connectivity_(connectivity), parts_(parts), has_rest_(parts.loops_with_rest(connectivity))
  {
  }

  Index number_of_loops() const { return connectivity_.number_of_border_loops; }
  Index size() const { return number_of_loops() + parts_.size() + mesh_.number_of_vertices(); }

  Index node(Index v) const
  {
    if(!connectivity_.is_border(v))
      return number_of_loops() + parts_.size() + v;
    const Index loop = connectivity_.border_loop[v];
    return has_rest_[loop] ? loop : number_of_loops() + parts_.part(v);
  }
  std::array<Index, 2> ends(Index halfedge) const
  {
    return {{node(mesh_.source(halfedge)), node(mesh_.target(halfedge))}};
  }
  /// whether an edge has an end at a source on the border
  bool is_at_source(Index halfedge) const
  {
    return parts_.is_at_source(mesh_.source(halfedge)) || parts_.is_at_source(mesh_.target(halfedge));
  }
  /// whether a node is a border loop that is a source
  bool is_source(Index node) const { return node >= number_of_loops() && node < number_of_loops() + parts_.size(); }
  /// whether a node is a border loop with a vertex to which a curve may go
  bool is_border(Index node) const { return node < number_of_loops() && has_rest_[node]; }
  /// the vertex of a node inside, or null
  Index vertex(Index node) const
  {
    const Index first = number_of_loops() + parts_.size();
    return node >= first ? node - first : null_index;
  }

private:
  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Source_parts& parts_;
  std::vector<unsigned char> has_rest_;
};

/*!
 * tells which edges of a graph of mesh edges stay if those at parts of the border that are sources are left out.
 *
 * With `Nodes_with_sources`, the graph is what it has to be. What hangs together at such a node alone is
 * separated by corridors that no curve of mesh edges passes: one of these pieces stays, which is the one with cycles or
 * a part of the border, if there is any. Where that would leave the wrong topology, it is an error.
 */
class Edges_off_sources
{
public:
  /// @param halfedges of the edges
  /// @param remedy what a user can do, for the message
  Edges_off_sources(const Nodes_with_sources& nodes, const std::vector<Index>& halfedges, const std::string& remedy)
    : nodes_(nodes), halfedges_(halfedges), remedy_(remedy), pieces_(nodes.size()), groups_(nodes.size()),
      is_dropped_(halfedges.size(), 0)
  {
    if(!meets_source())
      return;
    unite();
    measure_pieces();
    choose_pieces();
    for(std::size_t i = 0; i < halfedges.size(); ++i)
    {
      const Index node = nodes_.ends(halfedges[i])[0];
      is_dropped_[i] = nodes_.is_at_source(halfedges[i]) || best_[groups_.find(node)] != pieces_.find(node);
      number_at_sources_ += nodes_.is_at_source(halfedges[i]);
    }
  }

  const std::vector<unsigned char>& is_dropped() const { return is_dropped_; }
  Index number_at_sources() const { return number_at_sources_; }

private:
  struct Piece
  {
    Index nodes = 0, edges = 0;
    bool has_border = false;
    bool has_to_stay() const { return edges >= nodes || has_border; }
  };

  bool meets_source() const
  {
    for(Index h : halfedges_)
      if(nodes_.is_at_source(h))
        return true;
    return false;
  }

  /// into pieces without the edges at sources, and groups with them
  void unite()
  {
    for(Index h : halfedges_)
      if(!nodes_.is_at_source(h))
      {
        pieces_.unite(nodes_.ends(h)[0], nodes_.ends(h)[1]);
        groups_.unite(nodes_.ends(h)[0], nodes_.ends(h)[1]);
      }
    for(Index h : halfedges_)
      if(nodes_.is_at_source(h) && !groups_.unite(nodes_.ends(h)[0], nodes_.ends(h)[1]))
        throw_no_way();
  }

  void measure_pieces()
  {
    piece_.resize(nodes_.size());
    for(Index i = 0; i < nodes_.size(); ++i)
    {
      ++piece_[pieces_.find(i)].nodes;
      piece_[pieces_.find(i)].has_border |= nodes_.is_border(i);
    }
    for(Index h : halfedges_)
      if(!nodes_.is_at_source(h))
        ++piece_[pieces_.find(nodes_.ends(h)[0])].edges;
  }

  /// of each group the one that stays
  void choose_pieces()
  {
    best_.assign(nodes_.size(), null_index);
    for(Index i = 0; i < nodes_.size(); ++i)
    {
      if(pieces_.find(i) != i || nodes_.is_source(i))
        continue;
      Index& other = best_[groups_.find(i)];
      if(other != null_index && piece_[other].has_to_stay() && piece_[i].has_to_stay())
        throw_no_way();
      if(other == null_index || (piece_[i].has_to_stay() && !piece_[other].has_to_stay()) ||
         (piece_[i].has_to_stay() == piece_[other].has_to_stay() && piece_[i].edges > piece_[other].edges))
        other = i;
    }
  }

  [[noreturn]] void throw_no_way() const
  {
    throw Invalid_input(
      Cause::NO_FACE_AT_SOURCE,
      "there is a corridor beside a source, or between two, without a vertex inside: no curve of mesh edges passes "
      "it, and the mesh has to be refined there; or " +
        remedy_);
  }

  const Nodes_with_sources& nodes_;
  const std::vector<Index>& halfedges_;
  const std::string remedy_;
  Union_find pieces_, groups_;
  std::vector<Piece> piece_;
  std::vector<Index> best_;
  std::vector<unsigned char> is_dropped_; // edges
  Index number_at_sources_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_EDGES_OFF_SOURCES_H
