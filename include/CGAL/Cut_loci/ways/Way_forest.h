// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_WAY_FOREST_H
#define CGAL_CUT_LOCI_WAYS_WAY_FOREST_H

#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/ways/Rows_of_faces.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>
#include <CGAL/Cut_loci/ways/Way_arrival.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Where a way enters a face: at a length along a halfedge of it, or null.
struct Face_entrance
{
  Index halfedge = null_index;
  double t = 0.;
};

// Which edges ways cross, and where they enter each face.
struct Ways_through_faces
{
  std::vector<unsigned char> is_crossed;
  std::vector<Face_entrance> entrances;
};

// A forest of faces with roots at the sources, whose rows of faces hold short ways to all vertices.
//
// Rows grow by one face after the other, the one first whose far corner is reached by the shortest way. If that is the first
// way to the corner, or the shortest so far, all faces of the row are linked: from then on, they are entered as in this row
// and by no other. Else a row goes on unlinked, for a face that is wrong for its own corner may be right for what is behind:
// where several ways pass a slim face, each to another side. As soon as a face of it has been linked otherwise, it ends.
//
// Given distances only tell which faces to leave to others. As each face is entered in one way, some ways are longer than
// shortest paths, on slim faces by up to one or two mean edges. No shortest path crosses the cut locus: so that is looked for
// among the edges that no way crosses. These hold a tree of all vertices and 2g edges more on a surface of genus g, each
// border loop being one node. Of several sources, no tree of the forest has more than one. O(n log n) if unlinked rows are
// short, which they are.
class Way_forest
{
public:
  Way_forest(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Source_roots& roots,
             const std::vector<double>& distance)
    : mesh_(mesh), connectivity_(connectivity), roots_(roots), distance_(distance), rows_(mesh, distance),
      row_of_face_(mesh.number_of_faces(), null_index), way_(mesh.number_of_vertices(), null_index),
      number_unlinked_(mesh.number_of_halfedges(), 0), seen_in_(mesh.number_of_faces(), null_index),
      is_slow_(mesh.number_of_vertices(), 0)
  {
  }

  void grow(const Progress& progress)
  {
    const std::vector<Index> faces = faces_at_sources();
    for(Index f : faces)
    {
      const Index owner = roots_.owner(f);
      start(f, owner < roots_.points().size() ? &roots_.points()[owner] : nullptr);
    }
    look_at_slopes();
    for(Index f : faces)
      offer_neighbors(row_of_face_[f]);
    for(std::size_t i = 0; !queue_.empty(); ++i)
    {
      progress(i, rows_.size());
      const Index row = queue_.top().second;
      queue_.pop();
      if(row >= first_tip())
        start_at_tip(row - first_tip());
      else if(!collect_unlinked(row))
        continue;
      else if(is_first(row))
        link();
      else
        offer_neighbors(row);
    }
  }

  // What the ways to those vertices cross that are wanted. Other links are of no use, but those between faces at one source.
  template <typename Is_wanted>
  Ways_through_faces ways(const Is_wanted& is_wanted) const
  {
    Ways_through_faces result{at_sources_, std::vector<Face_entrance>(mesh_.number_of_faces())};
    for(Index v = 0; v < way_.size(); ++v)
      for(Index row = is_wanted(v) ? way_[v] : null_index; row != null_index && !rows_.is_root(row);
          row = rows_[row].before)
      {
        Face_entrance& entrance = result.entrances[rows_.face(row)];
        if(entrance.halfedge != null_index)
          break;
        entrance = {rows_[row].entry, rows_.entrance(row)};
        const Index edge = connectivity_.edge_of_halfedge[entrance.halfedge];
        result.is_crossed[edge] = connectivity_.halfedge_of_edge[edge] == entrance.halfedge ? 1 : 2;
      }
    return result;
  }

  // the source from which the way to each vertex comes, or null
  std::vector<Index> nearest_sources() const
  {
    std::vector<Index> result;
    for(Index row : way_)
      result.push_back(row != null_index ? rows_[row].source : null_index);
    return result;
  }

  // lengths of the ways; where there is none, what is given
  std::vector<double> lengths() const
  {
    std::vector<double> result(distance_);
    for(Index v = 0; v < way_.size(); ++v)
      if(way_[v] != null_index)
        result[v] = arrival(way_[v]);
    return result;
  }

  // whether the way to a vertex crosses no face but one at a source
  bool starts_at(Index v) const { return way_[v] != null_index && rows_.is_root(way_[v]); }

  // how the way to a vertex of a distance arrives, if there is one
  Way_arrival arrival_at(Index v, double distance) const
  {
    return way_[v] != null_index ? rows_.arrival(way_[v], distance) : Way_arrival();
  }

private:
  static constexpr double infinity() { return (std::numeric_limits<double>::infinity)(); }

  // in the queue, from this number on, are vertices
  static constexpr Index first_tip() { return null_index / 2; }
  double arrival(Index row) const { return rows_[row].length + rows_[row].late; }
  double first(Index v) const { return way_[v] == null_index ? infinity() : arrival(way_[v]); }
  // by more than rounding
  bool is_first(Index row) const { return arrival(row) < (1. - 1e-9) * first(rows_.corner(row)); }

  // Those at each source that hang together: a tree, as the faces around a loop form a ring. Or one that it has to itself.
  std::vector<Index> faces_at_sources()
  {
    at_sources_.assign(connectivity_.number_of_edges(), 0);
    std::vector<unsigned char> is_inside(at_sources_), is_found(mesh_.number_of_faces(), 0);
    std::vector<unsigned char> has_faces(roots_.number_of_sources(), 0);
    std::vector<Index> result;
    const auto find = [&](Index f)
    {
      is_found[f] = has_faces[roots_.owner(f)] = 1;
      result.push_back(f);
    };
    const auto find_all = [&](Index f)
    {
      find(f);
      for(std::size_t i = result.size() - 1; i < result.size(); ++i)
        for(Index h = 3 * result[i]; h < 3 * result[i] + 3; ++h)
          if(const Index e = connectivity_.edge_of_halfedge[h], o = mesh_.opposite[h]; is_inside[e] && !is_found[o / 3])
          {
            at_sources_[e] = 1;
            find(o / 3);
          }
    };
    for(Index h : roots_.crossings())
      is_inside[connectivity_.edge_of_halfedge[h]] = 1;
    for(Index h : roots_.crossings())
      if(!is_found[h / 3])
        find_all(h / 3);
    for(Index i = 0; i < roots_.number_of_sources(); ++i)
      if(!has_faces[i])
        find_all(roots_.face(i));
    return result;
  }

  // A user's map may be that of another source, or of several: then the given distances rise in all directions from a vertex,
  // also to where ways could come in between its neighbors: for those of an edge, by more than its length together. If no way
  // has come there until all edges at it could have been passed, ways start there. Or its waves may be slower: then it rises
  // by more than the way, and by half more than solvers ever say.
  void look_at_slopes()
  {
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
    {
      double longest = 0., steepest = 0.;
      bool is_tip = way_[v] == null_index;
      const auto rise = [&](Index w) { return distance_[w] - distance_[v]; };
      for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      {
        const Index h = connectivity_.ring_halfedge[k], w = connectivity_.ring_vertex[k];
        const double length = edge_length(mesh_, h);
        longest = (std::max)(longest, length);
        steepest = (std::max)(steepest, std::abs(rise(w) / length));
        if(mesh_.source(h) == v) // not the last one at a border
          is_tip = is_tip && rise(w) + rise(mesh_.source(mesh_.previous(h))) > edge_length(mesh_, mesh_.next(h));
      }
      is_slow_[v] = steepest > 1.5;
      if(is_tip)
        queue_.push({distance_[v] + longest, first_tip() + v});
    }
  }

  void start_at_tip(Index v)
  {
    const auto is_linked = [&](Index h) { return row_of_face_[h / 3] != null_index; };
    const auto ring = connectivity_.ring_halfedge.begin();
    const auto begin = ring + connectivity_.ring_begin[v], end = ring + connectivity_.ring_begin[v + 1];
    if(std::any_of(begin, end, is_linked))
      return;
    Indexed_source tip;
    tip.vertex = v;
    tip.location = location_of_vertex(connectivity_, v);
    for(auto h = begin; h != end; ++h)
      if(mesh_.source(*h) == v) // not the last one at a border
      {
        start(*h / 3, &tip);
        at_sources_[connectivity_.edge_of_halfedge[*h]] = h != begin && !mesh_.is_border_edge(*h);
      }
    for(auto h = begin; h != end; ++h)
      if(mesh_.source(*h) == v)
        offer_neighbors(row_of_face_[*h / 3]);
  }

  // from a part of the border if there is no point
  void start(Index f, const Indexed_source* point)
  {
    const Index root = row_of_face_[f] = rows_.add_root(f, point, roots_.owner(f));
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      start_way(mesh_.source(h), rows_.row_at_source(root, h));
      start_way(mesh_.target(h), rows_.row_at_target(root, h));
    }
  }

  void start_way(Index v, Index row)
  {
    if(arrival(row) < first(v))
      way_[v] = row;
  }

  void offer_neighbors(Index row)
  {
    const Index f = rows_.face(row);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(h != rows_[row].entry && !mesh_.is_border_edge(h) && row_of_face_[mesh_.opposite[h] / 3] == null_index)
        offer(row, h);
  }

  // A row waits for others, as its faces are lost for them: by a quarter of the longest detour to a corner of one that is not
  // linked, compared to known ways. Without that those who come first take too much, and by all of it, many ways bend that
  // need not. But what is longer by more than an edge is no bend: a better row is late, as it enters a face along a long side.
  void offer(Index row, Index h)
  {
    const Index entry = mesh_.opposite[h];
    const bool is_linked = row_of_face_[rows_.face(row)] == row;
    if(!is_linked)
    {
      // three of them at most come across each edge; with two, ways beside fans are longer, and more gain nothing
      if(number_unlinked_[entry] == 3 || is_useless(row, h))
        return;
      ++number_unlinked_[entry];
    }
    Rows_of_faces::Row next = rows_.longer(row, entry);
    const Index v = mesh_.source(mesh_.previous(entry));
    // what comes late stays so, and leaves the corner to another way that comes at once with it
    next.late = (std::max)(rows_[row].late, is_slow_[v] ? (1. + 1e-8) * (distance_[v] - next.length) : 0.);
    const double at = next.length + next.late, known = (std::min)(first(v), (std::max)(0., distance_[v]));
    const double detour = at - known, waits = (std::max)(0.25 * detour, detour - connectivity_.mean_edge_length);
    next.delay = (std::max)(is_linked ? 0. : rows_[row].delay, waits);
    queue_.push({at + next.delay, rows_.add(next)});
  }

  // Whether all points of an edge are reached sooner past its ends: at a distance x from one of them, a way is shorter by no
  // more than 2 x than that to the end.
  bool is_useless(Index row, Index h) const
  {
    const Rows_of_faces::Window seen = rows_.window(row, h);
    return arrival(seen.left) - first(mesh_.target(h)) + arrival(seen.right) - first(mesh_.source(h)) >=
           2. * edge_length(mesh_, h);
  }

  // Sets the faces of a row that are not linked; false if there are none, or one is linked otherwise by now, or there twice.
  bool collect_unlinked(Index row)
  {
    unlinked_.clear();
    const Index name = row;
    for(; row_of_face_[rows_.face(row)] != row; row = rows_[row].before)
    {
      const Index f = rows_.face(row);
      if(row_of_face_[f] != null_index || seen_in_[f] == name)
        return false;
      seen_in_[f] = name;
      unlinked_.push_back(row);
    }
    return !unlinked_.empty();
  }

  void link()
  {
    for(Index row : unlinked_)
    {
      row_of_face_[rows_.face(row)] = row;
      if(is_first(row))
        way_[rows_.corner(row)] = row;
    }
    for(std::size_t i = unlinked_.size(); i-- > 0;)
      offer_neighbors(unlinked_[i]);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Source_roots& roots_;
  const std::vector<double>& distance_;
  Rows_of_faces rows_;
  std::vector<Index> row_of_face_;             // in which it is linked
  std::vector<Index> way_;                     // the row at whose corner the shortest way to each vertex ends
  std::vector<unsigned char> number_unlinked_; // rows that have been offered each halfedge
  std::vector<Index> seen_in_;                 // of the faces: the row in which they were seen last
  std::vector<unsigned char> is_slow_;         // vertices at which the given distances rise by more than the way
  std::vector<unsigned char> at_sources_;      // edges between faces at one source
  std::vector<Index> unlinked_;
  using Item = std::pair<double, Index>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue_;
};

} // namespace internal

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_WAYS_WAY_FOREST_H
