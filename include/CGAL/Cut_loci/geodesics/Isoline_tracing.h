// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H
#define CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H

#include <CGAL/Cut_loci/geodesics/Geodesic_fronts.h>
#include <CGAL/Cut_loci/geodesics/Isoline_arcs.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// is an isoline, with what is nearer on its left; if it is closed, it ends where it begins.
struct Indexed_isoline
{
  std::vector<Indexed_location> locations;
  bool is_closed;
};

/*!
 * finds isolines of exact distances, one level after the other.
 *
 * What is nearer on an edge is found once, from all fronts in its two faces, and begins at its vertices if these are nearer; so
 * isolines enter and leave each face equally often. There, the begins and ends of arcs and these crossings of edges are joined,
 * the nearest pairs first, until none is left: an isoline is closed, or leads from border to border, whatever rounding does.
 */
class Isoline_tracing
{
public:
  Isoline_tracing(const Exact_geodesic_propagation& geodesics, const std::vector<Crossing_window>& windows)
    : geodesics_(geodesics), faces_(geodesics.faces()), fronts_(geodesics, windows)
  {
  }

  /// the segments deviate from the arcs by `deviation` at most
  std::vector<Indexed_isoline> operator()(double level, double deviation)
  {
    level_ = level;
    pieces_.clear();
    nearer_.clear();
    tokens_.clear();
    std::vector<Index> faces;
    for(Index f = 0; f < faces_.number_of_faces(); ++f)
      if(may_meet(f))
      {
        faces.push_back(f);
        add_nearer(f);
      }
    cross_edges();
    for(Index f : faces)
      add_arcs(f, deviation);
    join();
    return chains();
  }

private:
  /// a crossing of an edge, or an arc in a face
  struct Piece
  {
    std::vector<Indexed_location> locations;
    double length;
    std::size_t next = none;
    double gap = 0.; // between it and the next
  };
  /// a part of an edge, by its smaller halfedge, that is nearer than the level
  struct Nearer
  {
    Index halfedge;
    double begin, end; // shares of it
  };
  /// an isoline comes to `at` along a piece, or goes on from there
  struct Token
  {
    Indexed_location at;
    std::size_t piece;
    bool is_head;
  };

  bool is_nearer(Index v) const { return geodesics_.distance(v) < level_; }

  /// distances change by no more than the way; those of vertices behind the maximum distance are infinite
  bool may_meet(Index f) const
  {
    double least = (std::numeric_limits<double>::infinity)(), largest = 0., longest = 0.;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      least = (std::min)(least, geodesics_.distance(faces_.source(h)));
      largest = (std::max)(largest, geodesics_.distance(faces_.source(h)));
      longest = (std::max)(longest, faces_.length(h));
    }
    return (least - longest < level_ || std::isinf(least)) && level_ <= (std::max)(largest, least + longest);
  }

  void add_nearer(Index f)
  {
    const std::array<Plane_point, 3> corners = fronts_.corners(f);
    for(const Geodesic_front& front : fronts_.in_face(f))
      for(Index h = 3 * f; h < 3 * f + 3 && front.may_reach(level_); ++h)
      {
        const Plane_point &p = corners[h % 3], along = minus(corners[(h + 1) % 3], p);
        // what is along an edge does not reach it
        const double level = front.is_parallel ? level_ - fronts_.rounding() : level_;
        std::array<double, 2> part = front.seen_chord(p, along, level - front.sigma);
        part = {{(std::max)(part[0], 0.), (std::min)(part[1], 1.)}};
        if(part[0] < part[1])
          add_nearer(h, part);
      }
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      for(Index end : {0, 1})
        if(is_nearer(end == 0 ? faces_.source(h) : faces_.target(h)))
          add_nearer(h, {{double(end), double(end)}});
  }

  void add_nearer(Index h, const std::array<double, 2>& part)
  {
    const Index o = faces_.opposite(h);
    nearer_.push_back(o < h ? Nearer{o, 1. - part[1], 1. - part[0]} : Nearer{h, part[0], part[1]});
  }

  /// where what parts cover together begins and ends
  void cross_edges()
  {
    std::sort(nearer_.begin(), nearer_.end(),
              [](const Nearer& a, const Nearer& b)
              { return a.halfedge != b.halfedge ? a.halfedge < b.halfedge : a.begin < b.begin; });
    for(std::size_t i = 0; i < nearer_.size();)
    {
      const Index h = nearer_[i].halfedge;
      bool is_begun = is_nearer(faces_.source(h));
      while(i < nearer_.size() && nearer_[i].halfedge == h)
      {
        if(!is_begun)
          cross_edge(h, nearer_[i].begin, true);
        is_begun = false;
        double end = nearer_[i].end;
        for(++i; i < nearer_.size() && nearer_[i].halfedge == h && nearer_[i].begin <= end; ++i)
          end = (std::max)(end, nearer_[i].end);
        const bool is_last = i == nearer_.size() || nearer_[i].halfedge != h;
        if(!is_last || !is_nearer(faces_.target(h)))
          cross_edge(h, end, false);
      }
    }
  }

  /// the isoline leaves the face of `h` where what is nearer begins
  void cross_edge(Index h, double t, bool leaves)
  {
    const Indexed_location at = location_on(h, t);
    tokens_.push_back({at, pieces_.size(), !leaves});
    if(const Index o = faces_.opposite(h); o != null_index)
      tokens_.push_back({across(h, o, at), pieces_.size(), leaves});
    pieces_.push_back({{at}, 0.});
  }

  void add_arcs(Index f, double deviation)
  {
    const std::array<Plane_point, 3> corners = fronts_.corners(f);
    const std::vector<Geodesic_front> fronts = fronts_.in_face(f);
    const Isoline_arcs found(fronts, corners, level_, fronts_.rounding());
    for(const Isoline_arc& arc : found.arcs())
    {
      Piece piece{sampled(f, corners, fronts[arc.front], arc, deviation),
                  fronts[arc.front].length(arc.begin, arc.end, level_ - fronts[arc.front].sigma)};
      tokens_.push_back({piece.locations.front(), pieces_.size(), false});
      tokens_.push_back({piece.locations.back(), pieces_.size(), true});
      pieces_.push_back(std::move(piece));
    }
  }

  std::vector<Indexed_location> sampled(Index f, const std::array<Plane_point, 3>& corners, const Geodesic_front& front,
                                        const Isoline_arc& arc, double deviation) const
  {
    const double r = level_ - front.sigma, angle = arc.end - arc.begin;
    // an arc of the angle a is r (1 - cos(a / 2)) from its chord; at least three segments make a circle
    const double step = 2. * std::acos((std::max)(1. - deviation / r, 0.5));
    const std::size_t n = front.is_parallel ? 1 : static_cast<std::size_t>((std::max)(std::ceil(angle / step), 1.));
    std::vector<Indexed_location> result;
    for(std::size_t i = 0; i <= n; ++i)
    {
      result.push_back(located(f, corners, front.point(arc.begin + angle * (double(i) / double(n)), r)));
      snap(result.back(), 0.);
    }
    return result;
  }

  static Indexed_location located(Index f, const std::array<Plane_point, 3>& corners, const Plane_point& p)
  {
    Indexed_location result;
    result.face = f;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_point &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
      result.coordinates[i] = cross(minus(b, a), minus(p, a)) / cross(minus(b, a), minus(corners[i], a));
    }
    return result;
  }

  void join()
  {
    const auto face = [](const Token& token) { return token.at.face; };
    std::stable_sort(tokens_.begin(), tokens_.end(), [&](const Token& a, const Token& b) { return face(a) < face(b); });
    for(auto begin = tokens_.cbegin(); begin != tokens_.cend();)
    {
      const auto end = std::find_if(begin, tokens_.cend(), [&](const Token& t) { return face(t) != face(*begin); });
      join(begin, end);
      begin = end;
    }
  }

  /// the pieces that come and go in a face
  void join(std::vector<Token>::const_iterator first, std::vector<Token>::const_iterator last)
  {
    struct Pair
    {
      double distance;
      std::size_t head, tail;
    };
    std::vector<Pair> pairs;
    for(auto head = first; head != last; ++head)
      for(auto tail = first; tail != last; ++tail)
        if(head->is_head && !tail->is_head)
          pairs.push_back({distance(head->at, tail->at), head->piece, tail->piece});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.distance < q.distance; });
    std::vector<std::size_t> taken;
    for(const Pair& p : pairs)
      if(pieces_[p.head].next == none && std::find(taken.begin(), taken.end(), p.tail) == taken.end())
      {
        pieces_[p.head].next = p.tail;
        pieces_[p.head].gap = p.distance;
        taken.push_back(p.tail);
      }
  }

  double distance(const Indexed_location& a, const Indexed_location& b) const
  {
    const Plane_point p = faces_.in_frame(3 * a.face, a.coordinates), q = faces_.in_frame(3 * a.face, b.coordinates);
    return std::hypot(p.x - q.x, p.y - q.y);
  }

  std::vector<Indexed_isoline> chains() const
  {
    std::vector<unsigned char> has_previous(pieces_.size(), 0), is_done(pieces_.size(), 0);
    for(const Piece& piece : pieces_)
      if(piece.next != none)
        has_previous[piece.next] = 1;
    std::vector<Indexed_isoline> result;
    for(bool is_closed : {false, true})
      for(std::size_t first = 0; first < pieces_.size(); ++first)
      {
        if(is_done[first] || (!is_closed && has_previous[first]))
          continue;
        Indexed_isoline line{{}, is_closed};
        double length = 0., gaps = 0.;
        for(std::size_t i = first; i != none && !is_done[i]; i = pieces_[i].next)
        {
          is_done[i] = 1;
          length += pieces_[i].length;
          gaps += pieces_[i].gap;
          append(pieces_[i], line.locations);
        }
        // where rounding leaves a gap between windows, a bit of a front behind them shows through, as wide as the gap
        if(length < (std::max)(2. * gaps, 4. * geodesic_cover * faces_.mean_edge_length()))
          continue;
        if(is_closed)
          line.locations.push_back(line.locations.front());
        result.push_back(std::move(line));
      }
    return result;
  }

  /// of points that two pieces have, one is enough: crossings have theirs, and an arc its end where another arc follows
  void append(const Piece& piece, std::vector<Indexed_location>& line) const
  {
    const bool is_crossing = piece.locations.size() == 1;
    const bool keeps_end = is_crossing || pieces_[piece.next].locations.size() > 1;
    line.insert(line.end(), piece.locations.begin() + !is_crossing, piece.locations.end() - !keeps_end);
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  const Geodesic_fronts fronts_;
  double level_ = 0.;
  std::vector<Piece> pieces_; // crossings first
  std::vector<Nearer> nearer_;
  std::vector<Token> tokens_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H
