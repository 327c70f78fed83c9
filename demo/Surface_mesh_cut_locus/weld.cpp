// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "weld.h"

#include "Union_find.h"

#include <CGAL/Bbox_3.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace {

using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;
using Vertex_pair = std::pair<std::size_t, std::size_t>;

constexpr double relative_tolerance = 1e-7; // far above the rounding of floats, far below what anybody models

// An edge of a polygon, from corner to corner.
struct Side
{
  std::size_t source, target, polygon;
};

// Those between the same two vertices, one after another.
std::vector<Side> sorted_sides(const Polygons& polygons)
{
  std::vector<Side> sides;
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(std::size_t i = 0; i < polygons[f].size(); ++i)
      sides.push_back({polygons[f][i], polygons[f][(i + 1) % polygons[f].size()], f});
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t)
            {
    return std::make_pair(std::minmax(s.source, s.target), s.polygon) <
           std::make_pair(std::minmax(t.source, t.target), t.polygon);
  });
  return sides;
}

// Calls `visit(begin, end)` for each run of items with the same key.
template <typename Iterator, typename Key, typename Visit>
void for_each_group(Iterator begin, Iterator end, const Key& key, const Visit& visit)
{
  while(begin != end)
  {
    const Iterator next = std::find_if(begin, end, [&](const auto& item) { return key(item) != key(*begin); });
    visit(begin, next);
    begin = next;
  }
}

Vertex_pair ends(const Side& side)
{
  return std::minmax(side.source, side.target);
}

// Unites points that are at most `tolerance` apart. All must be different.
void unite_close(const Points& points, const std::vector<std::size_t>& vertices, double tolerance,
                 curve_measures::Union_find& sets)
{
  using Cell = std::array<std::int64_t, 3>;
  const double size = 4. * tolerance; // most points have all that is close in their own cell
  const auto cell = [&](const Kernel::Point_3& p, const std::array<double, 3>& shift)
  {
    Cell c;
    for(int i = 0; i < 3; ++i)
      c[i] = static_cast<std::int64_t>(std::floor((p[i] + shift[i]) / size));
    return c;
  };
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> grid;
  for(std::size_t v : vertices)
  {
    const Kernel::Point_3& p = points[v];
    const Cell low = cell(p, {{-tolerance, -tolerance, -tolerance}}),
               high = cell(p, {{tolerance, tolerance, tolerance}});
    for(std::int64_t x = low[0]; x <= high[0]; ++x)
      for(std::int64_t y = low[1]; y <= high[1]; ++y)
        for(std::int64_t z = low[2]; z <= high[2]; ++z)
          if(const auto found = grid.find(Cell{{x, y, z}}); found != grid.end())
            for(std::size_t w : found->second)
              if(CGAL::squared_distance(p, points[w]) <= tolerance * tolerance)
                sets.unite(v, w);
    grid[cell(p, {{0., 0., 0.}})].push_back(v);
  }
}

// The place of each end of a side: that of all points close to it, unless a polygon has an edge between two of them. Those
// are different points, however close they are.
std::vector<std::size_t> find_places(const Points& points, const Polygons& polygons, const std::vector<Side>& sides,
                                     double tolerance)
{
  std::vector<std::size_t> vertices;
  for(const Side& side : sides)
    vertices.insert(vertices.end(), {side.source, side.target});
  std::sort(vertices.begin(), vertices.end(),
            [&](std::size_t v, std::size_t w) { return std::make_pair(points[v], v) < std::make_pair(points[w], w); });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  std::vector<std::size_t> same(points.size()), different;
  std::iota(same.begin(), same.end(), std::size_t(0));
  for(std::size_t v : vertices)
  {
    if(different.empty() || points[different.back()] != points[v])
      different.push_back(v);
    same[v] = different.back();
  }
  curve_measures::Union_find close(points.size());
  unite_close(points, different, tolerance, close);

  std::vector<bool> is_split(points.size(), false);
  for(const auto& polygon : polygons)
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const std::size_t v = same[polygon[i]], w = same[polygon[(i + 1) % polygon.size()]];
      if(v != w && close.find(v) == close.find(w))
        is_split[close.find(v)] = true;
    }
  std::vector<std::size_t> place = same;
  for(std::size_t v : vertices)
    if(!is_split[close.find(same[v])])
      place[v] = close.find(same[v]);
  return place;
}

// Which polygons have to be turned around so that neighbors agree.
class Orientations
{
public:
  explicit Orientations(std::size_t n) : parent_(n), size_(n, 1), is_turned_(n, false)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  // Relates two polygons, or returns whether they are related so already.
  bool relate(std::size_t f, std::size_t g, bool is_turned)
  {
    is_turned = is_turned != (go_to_root(f) != go_to_root(g));
    if(f == g)
      return !is_turned;
    if(size_[f] < size_[g])
      std::swap(f, g);
    parent_[g] = f;
    size_[f] += size_[g];
    is_turned_[g] = is_turned;
    return true;
  }

private:
  bool go_to_root(std::size_t& f) const
  {
    bool is_turned = false;
    for(; parent_[f] != f; f = parent_[f])
      is_turned = is_turned != is_turned_[f];
    return is_turned;
  }

  std::vector<std::size_t> parent_, size_;
  std::vector<bool> is_turned_; // relative to the parent
};

// From an edge into its polygon, at a right angle; zero if the polygon is flat.
Kernel::Vector_3 inward(const Side& side, const Polygons& polygons, const Points& points)
{
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  const Kernel::Vector_3 along = points[side.target] - points[side.source];
  for(std::size_t v : polygons[side.polygon])
    sum = sum + (points[v] - points[side.source]);
  const Kernel::Vector_3 across = sum - (sum * along) / along.squared_length() * along;
  const double length = std::sqrt(across.squared_length());
  return length > 0. ? across / length : CGAL::NULL_VECTOR;
}

// Joins the border edges of a soup that lie on each other.
class Welder
{
public:
  Welder(const Points& points, const Polygons& polygons)
    : points_(points), polygons_(polygons), sides_(sorted_sides(polygons)), same_(points.size()),
      orientations_(polygons.size())
  {
    CGAL::Bbox_3 box; // without points that no polygon has
    for(const Side& side : sides_)
      box += points[side.source].bbox();
    const double tolerance =
      relative_tolerance * std::sqrt(std::pow(box.xmax() - box.xmin(), 2) + std::pow(box.ymax() - box.ymin(), 2) +
                                     std::pow(box.zmax() - box.zmin(), 2));
    for_each_group(sides_.begin(), sides_.end(), ends,
                   [&](auto begin, auto end)
                   {
      if(end - begin == 1 && begin->source != begin->target)
        border_.push_back(*begin);
    });
    if(border_.empty() || !(tolerance > 0.))
      return;
    place_ = find_places(points, polygons, border_, tolerance);
    unite_double_triangles();
    std::stable_sort(border_.begin(), border_.end(),
                     [&](const Side& s, const Side& t) { return places(s) < places(t); });
  }

  Weld operator()()
  {
    for(bool turns : {false, true}) // where there is a choice, faces stay as they are
      for_each_pile([&](auto begin, auto end) { join(begin, end, turns); });
    Weld result;
    result.first = classes();
    separate_crowded_edges(result.first);
    for(std::size_t v = 0; v < result.first.size(); ++v)
      result.merged_vertices += result.first[v] != v;
    for_each_pile(
      [&](auto begin, auto end)
      {
      std::vector<Vertex_pair> edges;
      for(auto side = begin; side != end; ++side)
        edges.push_back(std::minmax(result.first[side->source], result.first[side->target]));
      std::sort(edges.begin(), edges.end());
      for_each_group(
        edges.begin(), edges.end(), [](const Vertex_pair& e) { return e; },
        [&](auto first, auto last) { result.open_edges += last - first == 1; });
    });
    return result;
  }

private:
  using Iterator = std::vector<Side>::const_iterator;

  Vertex_pair places(const Side& side) const { return std::minmax(place_[side.source], place_[side.target]); }

  // border edges that lie on each other
  template <typename Visit>
  void for_each_pile(const Visit& visit) const
  {
    if(place_.empty())
      return;
    for_each_group(
      border_.begin(), border_.end(), [&](const Side& s) { return places(s); },
      [&](Iterator begin, Iterator end)
      {
      if(end - begin > 1 && place_[begin->source] != place_[begin->target])
        visit(begin, end);
      });
  }

  // A triangle that shares no side, at the place of another one, is the same: the repair of the soup removes it, and one
  // with two corners at a place.
  void unite_double_triangles()
  {
    std::vector<std::size_t> open_sides(polygons_.size(), 0);
    for(const Side& side : border_)
      ++open_sides[side.polygon];
    std::map<std::vector<std::size_t>, std::size_t> known;
    std::vector<bool> is_double(polygons_.size(), false);
    for(std::size_t f = 0; f < polygons_.size(); ++f)
    {
      if(polygons_[f].size() != 3 || open_sides[f] != 3)
        continue;
      std::vector<std::size_t> places;
      for(std::size_t v : polygons_[f])
        places.push_back(place_[v]);
      std::sort(places.begin(), places.end());
      const auto found = known.emplace(places, f);
      is_double[f] = !found.second || std::adjacent_find(places.begin(), places.end()) != places.end();
      for(std::size_t v : polygons_[f])
        for(std::size_t w : polygons_[found.first->second])
          if(place_[v] == place_[w])
            same_.unite(v, w);
    }
    const auto remove = [&](std::vector<Side>& sides)
    {
      sides.erase(std::remove_if(sides.begin(), sides.end(), [&](const Side& side) { return is_double[side.polygon]; }),
                  sides.end());
    };
    remove(sides_);
    remove(border_);
  }

  void read_orientations()
  {
    is_read_ = true;
    for_each_group(sides_.begin(), sides_.end(), ends,
                   [&](auto begin, auto end)
                   {
      if(end - begin == 2)
        orientations_.relate(begin->polygon, begin[1].polygon, begin->source == begin[1].source);
    });
  }

  void join(Iterator begin, Iterator end, bool turns)
  {
    const Side &s = *begin, &t = *(end - 1);
    const bool is_turned = place_[s.source] == place_[t.source];
    if(end - begin != 2 || s.polygon == t.polygon || is_turned != turns || is_folded(s, t))
      return;
    if(!is_read_)
      read_orientations();
    if(!orientations_.relate(s.polygon, t.polygon, is_turned))
      return;
    same_.unite(s.source, is_turned ? t.source : t.target);
    same_.unite(s.target, is_turned ? t.target : t.source);
  }

  // Whether the polygons lie on each other: then they are two sides of a sheet.
  bool is_folded(const Side& s, const Side& t) const
  {
    constexpr double nearly_one = 1. - 1e-6;
    return inward(s, polygons_, points_) * inward(t, polygons_, points_) > nearly_one;
  }

  std::vector<std::size_t> classes()
  {
    std::vector<std::size_t> first(points_.size()), least(points_.size(), points_.size());
    for(std::size_t v = 0; v < points_.size(); ++v)
    {
      std::size_t& l = least[same_.find(v)];
      l = (std::min)(l, v);
      first[v] = l;
    }
    return first;
  }

  // What is joined at both its ends may come to lie on another edge, with more than two faces at both: there nothing is
  // joined.
  void separate_crowded_edges(std::vector<std::size_t>& first) const
  {
    std::vector<bool> is_joined(first.size(), false), is_crowded(first.size(), false);
    for(std::size_t v = 0; v < first.size(); ++v)
      if(first[v] != v)
        is_joined[first[v]] = true;
    using Edge = std::pair<Vertex_pair, Vertex_pair>; // joined, and in the file
    std::vector<Edge> edges;
    for(const Side& side : sides_)
      if(is_joined[first[side.source]] || is_joined[first[side.target]])
        edges.emplace_back(std::minmax(first[side.source], first[side.target]), ends(side));
    std::sort(edges.begin(), edges.end());
    for_each_group(
      edges.begin(), edges.end(), [](const Edge& e) { return e.first; },
      [&](auto begin, auto end)
      {
      if(end - begin > 2 && begin->second != (end - 1)->second)
        is_crowded[begin->first.first] = is_crowded[begin->first.second] = true;
      });
    for(std::size_t v = 0; v < first.size(); ++v)
      if(is_crowded[first[v]] && first[v] != v)
        first[v] = v;
  }

  const Points& points_;
  const Polygons& polygons_;
  std::vector<Side> sides_, border_;
  std::vector<std::size_t> place_; // empty if there is nothing to join
  curve_measures::Union_find same_;
  Orientations orientations_;
  bool is_read_ = false;
};

} // namespace

double scale_to_unit(const Points& points)
{
  double largest = 0.;
  for(const Kernel::Point_3& p : points)
    for(double x : {p.x(), p.y(), p.z()})
      if(std::isfinite(x))
        largest = (std::max)(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1., (std::min)(-exponent, 1000));
}

Weld weld(const Polygon_soup& soup)
{
  const double scale = scale_to_unit(soup.points);
  Points points;
  for(const Kernel::Point_3& p : soup.points)
    points.emplace_back(p.x() * scale, p.y() * scale, p.z() * scale);
  return Welder(points, soup.polygons)();
}
