// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H
#define CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H

#include <CGAL/Cut_loci/geodesics/Geodesic_fronts.h>
#include <CGAL/Cut_loci/geodesics/Isoline_arcs.h>
#include <CGAL/Cut_loci/geodesics/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// is an isoline, with what is nearer on its left; if it is closed, it ends where it begins.
struct Indexed_isoline
{
  std::vector<Indexed_location> locations;
  bool is_closed;
};

/*!
 * finds isolines of exact distances, one level after the other.
 *
 * The arcs of each face are joined: inside, the end of one to the begin of another that is next to it; on edges, in the order
 * along the edge, so that an isoline is closed, or ends at the border, whatever rounding does.
 */
class Isoline_tracing
{
public:
  Isoline_tracing(const Exact_geodesic_propagation& geodesics, const std::vector<Crossing_window>& windows)
    : geodesics_(geodesics), faces_(geodesics.faces()), fronts_(geodesics, windows)
  {
    // what rounding leaves unknown of the distances
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
      if(geodesics_.is_reached(v))
        largest_ = (std::max)(largest_, geodesics_.distance(v));
    constexpr double few_roundings = 64. * std::numeric_limits<double>::epsilon();
    rounding_ = few_roundings * (largest_ + faces_.mean_edge_length());
  }

  /// the segments deviate from the arcs by `deviation` at most
  std::vector<Indexed_isoline> operator()(double level, double deviation)
  {
    level_ = off_vertices(level);
    arcs_.clear();
    next_.clear();
    length_.clear();
    gap_.clear();
    crossings_.clear();
    lone_.clear();
    for(Index f = 0; f < faces_.number_of_faces(); ++f)
      if(may_meet(f))
        add_face(f, deviation);
    for(auto& crossing : crossings_)
      join(crossing.second);
    for(auto& crossing : crossings_)
      join_rest(crossing.first, crossing.second);
    return chains();
  }

private:
  struct End
  {
    std::size_t arc;
    double place; // along the edge
  };
  struct Crossing
  {
    std::vector<End> ends, begins; // of arcs that leave the face of the halfedge, and those that go on behind it
  };

  /// A level within rounding of the distance of a vertex, as in grids, may pass on either side of it: it is moved into the
  /// widest gap between such distances that is near, by an amount that nobody sees.
  double off_vertices(double level) const
  {
    const double near = 1e-10 * largest_;
    std::vector<double> distances = {level - near, level + near};
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
      if(std::fabs(geodesics_.distance(v) - level) < near)
        distances.push_back(geodesics_.distance(v));
    if(distances.size() == 2)
      return level;
    std::sort(distances.begin(), distances.end());
    std::size_t best = 1;
    for(std::size_t i = 2; i < distances.size(); ++i)
      if(distances[i] - distances[i - 1] > distances[best] - distances[best - 1])
        best = i;
    return 0.5 * (distances[best - 1] + distances[best]);
  }

  /// distances change by no more than the way
  bool may_meet(Index f) const
  {
    double least = (std::numeric_limits<double>::infinity)(), longest = 0.;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      least = (std::min)(least, geodesics_.distance(faces_.source(h)));
      longest = (std::max)(longest, faces_.length(h));
    }
    return least - longest < level_ && level_ < least + longest;
  }

  void add_face(Index f, double deviation)
  {
    const std::array<Plane_point, 3> corners = fronts_.corners(f);
    const std::vector<Geodesic_front> fronts = fronts_.in_face(f);
    const Isoline_arcs found(fronts, corners, level_, rounding_);
    std::vector<Inner_end> ends, begins;
    for(const Isoline_arc& arc : found.arcs())
    {
      const double length = (level_ - fronts[arc.front].sigma) * (arc.end - arc.begin);
      if(arc.edge[0] == arc.edge[1] && length < 4. * rounding_)
        continue; // between an edge and a ray along it
      const std::size_t number = arcs_.size();
      arcs_.push_back(sampled(f, corners, fronts[arc.front], arc, deviation));
      next_.push_back(none);
      length_.push_back(length);
      gap_.push_back(0.);
      for(std::size_t k = 0; k < 2; ++k)
        if(arc.edge[k] == Isoline_arc::inside)
          (k == 0 ? begins : ends).push_back({number, arc.p[k]});
        else
          cross_edge(3 * f + static_cast<Index>(arc.edge[k]), {number, 0.}, arc.p[k],
                     corners[static_cast<std::size_t>(arc.edge[k])], k == 0);
    }
    join_inside(f, ends, begins);
  }

  std::vector<Indexed_location> sampled(Index f, const std::array<Plane_point, 3>& corners, const Geodesic_front& front,
                                        const Isoline_arc& arc, double deviation) const
  {
    const double r = level_ - front.sigma, angle = arc.end - arc.begin;
    // an arc of the angle a is r (1 - cos(a / 2)) from its chord; at least three segments make a circle
    const double step = 2. * std::acos((std::max)(1. - deviation / r, 0.5));
    const std::size_t n = static_cast<std::size_t>((std::max)(std::ceil(angle / step), 1.));
    std::vector<Indexed_location> result;
    for(std::size_t i = 0; i <= n; ++i)
    {
      const Plane_point p = i == 0   ? arc.p[0]
                            : i == n ? arc.p[1]
                                     : front.point(arc.begin + angle * double(i) / double(n), r);
      result.push_back(located(f, corners, p));
      for(std::size_t k = 0; k < 2; ++k)
        if(i == k * n && arc.edge[k] != Isoline_arc::inside)
          result.back().coordinates[static_cast<std::size_t>(arc.edge[k] + 2) % 3] = 0.;
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

  struct Inner_end
  {
    std::size_t arc;
    Plane_point p;
  };

  /// ends with begins, the nearest pairs first
  void join_inside(Index f, const std::vector<Inner_end>& ends, const std::vector<Inner_end>& begins)
  {
    struct Pair
    {
      double distance;
      std::size_t end, begin;
    };
    std::vector<Pair> pairs;
    for(const Inner_end& e : ends)
      for(const Inner_end& b : begins)
        pairs.push_back({std::hypot(e.p.x - b.p.x, e.p.y - b.p.y), e.arc, b.arc});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.distance < q.distance; });
    std::vector<std::size_t> taken;
    for(const Pair& p : pairs)
      if(next_[p.end] == none && std::find(taken.begin(), taken.end(), p.begin) == taken.end())
      {
        next_[p.end] = p.begin;
        gap_[p.end] = p.distance;
        taken.push_back(p.begin);
      }
    for(const Inner_end& e : ends)
      if(next_[e.arc] == none)
        lone_[f].ends.push_back({e.arc, 0.});
    for(const Inner_end& b : begins)
      if(std::find(taken.begin(), taken.end(), b.arc) == taken.end())
        lone_[f].begins.push_back({b.arc, 0.});
  }

  void cross_edge(Index h, End end, const Plane_point& p, const Plane_point& corner, bool begins)
  {
    const Index o = faces_.opposite(h);
    if(o == null_index)
      return;
    const double t = std::hypot(p.x - corner.x, p.y - corner.y);
    // by the halfedge that the isoline crosses from its face
    if(begins)
    {
      end.place = faces_.length(h) - t;
      crossings_[o].begins.push_back(end);
    }
    else
    {
      end.place = t;
      crossings_[h].ends.push_back(end);
    }
  }

  /// arcs on the two sides of an edge in their order; if rounding has seen more on one side, those next to each other
  void join(Crossing& crossing)
  {
    std::vector<End>&ends = crossing.ends, &begins = crossing.begins;
    const auto before = [](const End& a, const End& b) { return a.place < b.place; };
    std::sort(ends.begin(), ends.end(), before);
    std::sort(begins.begin(), begins.end(), before);
    std::vector<End>&more = ends.size() > begins.size() ? ends : begins,
    &less = ends.size() > begins.size() ? begins : ends;
    std::vector<End> rest;
    while(more.size() > less.size())
    {
      const auto worst = std::max_element(
        more.begin(), more.end(), [&](const End& a, const End& b) { return distance(a, less) < distance(b, less); });
      rest.push_back(*worst);
      more.erase(worst);
    }
    for(std::size_t i = 0; i < ends.size(); ++i)
      next_[ends[i].arc] = begins[i].arc;
    ends.clear();
    begins.clear();
    more = rest;
  }

  static double distance(const End& end, const std::vector<End>& others)
  {
    double result = (std::numeric_limits<double>::infinity)();
    for(const End& other : others)
      result = (std::min)(result, std::fabs(end.place - other.place));
    return result;
  }

  /// where an arc touches an edge, and rounding sees it behind the edge from one side only; or a ridge runs along the edge,
  /// so that it sees one side of it in the wrong face
  void join_rest(Index h, Crossing& crossing)
  {
    const Index o = faces_.opposite(h);
    for(std::vector<End>* begins : {&crossings_[o].begins, &lone_[o / 3].begins})
      join_any(crossing.ends, *begins);
    join_any(lone_[h / 3].ends, crossing.begins);
  }

  void join_any(std::vector<End>& ends, std::vector<End>& begins)
  {
    while(!ends.empty() && !begins.empty())
    {
      next_[ends.back().arc] = begins.back().arc;
      ends.pop_back();
      begins.pop_back();
    }
  }

  std::vector<Indexed_isoline> chains() const
  {
    std::vector<unsigned char> has_previous(arcs_.size(), 0), is_done(arcs_.size(), 0);
    for(std::size_t n : next_)
      if(n != none)
        has_previous[n] = 1;
    std::vector<Indexed_isoline> result;
    for(bool is_closed : {false, true})
      for(std::size_t first = 0; first < arcs_.size(); ++first)
      {
        if(is_done[first] || (!is_closed && has_previous[first]))
          continue;
        Indexed_isoline line{{arcs_[first].front()}, is_closed};
        double length = 0., gaps = 0.;
        for(std::size_t i = first; i != none && !is_done[i]; i = next_[i])
        {
          is_done[i] = 1;
          length += length_[i];
          gaps += gap_[i];
          line.locations.insert(line.locations.end(), arcs_[i].begin() + 1, arcs_[i].end());
        }
        // where rounding leaves a gap between windows, a bit of a front behind them shows through, as wide as the gap
        if(length < (std::max)(2. * gaps, 4. * geodesic_cover * faces_.mean_edge_length()))
          continue;
        if(is_closed)
          line.locations.back() = line.locations.front();
        result.push_back(std::move(line));
      }
    return result;
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const Exact_geodesic_propagation& geodesics_;
  const Geodesic_faces& faces_;
  const Geodesic_fronts fronts_;
  double largest_ = 0., rounding_ = 0., level_ = 0.;
  std::vector<std::vector<Indexed_location>> arcs_;
  std::vector<std::size_t> next_;       // of each arc
  std::vector<double> length_, gap_;    // of each arc, and between it and the next
  std::map<Index, Crossing> crossings_; // by halfedge
  std::map<Index, Crossing> lone_;      // by face: inside of it, and next to no other
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_GEODESICS_ISOLINE_TRACING_H
