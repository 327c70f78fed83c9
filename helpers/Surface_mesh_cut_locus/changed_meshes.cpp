// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_meshes {

double random_unit(std::mt19937& engine)
{
  return 2. * engine() / 4294967295. - 1.;
}

double mean_edge_length(const Mesh_data& m)
{
  double sum = 0.;
  for(const Triangle& t : m.triangles)
    for(int i = 0; i < 3; ++i)
      sum += norm(m.points[t[i]] - m.points[t[(i + 1) % 3]]);
  return sum / (3. * m.triangles.size());
}

std::size_t nearest_vertex(const std::vector<Point>& points, const Point& p)
{
  std::size_t best = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(norm(points[v] - p) < norm(points[best] - p))
      best = v;
  return best;
}

CGAL::Cut_loci::Indexed_triangle_mesh indexed(const Mesh_data& m)
{
  using CGAL::Cut_loci::Index;
  CGAL::Cut_loci::Indexed_triangle_mesh result;
  result.points = m.points;
  std::map<std::pair<Index, Index>, Index> halfedge;
  for(const Triangle& t : m.triangles)
    result.triangles.push_back({{Index(t[0]), Index(t[1]), Index(t[2])}});
  for(Index h = 0; h < result.number_of_halfedges(); ++h)
    halfedge[{result.source(h), result.target(h)}] = h;
  for(Index h = 0; h < result.number_of_halfedges(); ++h)
  {
    const auto found = halfedge.find({result.target(h), result.source(h)});
    result.opposite.push_back(found == halfedge.end() ? CGAL::Cut_loci::null_index : found->second);
  }
  return result;
}

Mesh_data jittered(Mesh_data m, double amount, unsigned seed, const std::function<Point(const Point&)>& project)
{
  std::vector<double> shortest(m.points.size(), 1e300);
  for(const Triangle& t : m.triangles)
    for(int i = 0; i < 3; ++i)
    {
      const double length = norm(m.points[t[i]] - m.points[t[(i + 1) % 3]]);
      shortest[t[i]] = (std::min)(shortest[t[i]], length);
      shortest[t[(i + 1) % 3]] = (std::min)(shortest[t[(i + 1) % 3]], length);
    }
  std::mt19937 engine(seed);
  for(std::size_t v = 0; v < m.points.size(); ++v)
  {
    for(double& x : m.points[v])
      x += amount * shortest[v] * random_unit(engine);
    m.points[v] = project(m.points[v]);
  }
  return m;
}

Mesh_data rough(Mesh_data m, double amount, unsigned seed)
{
  std::mt19937 engine(seed);
  const double h = mean_edge_length(m);
  for(Point& p : m.points)
    for(double& x : p)
      x += amount * h * random_unit(engine);
  return m;
}

Mesh_data smoothed(Mesh_data m, int times)
{
  for(int t = 0; t < times; ++t)
  {
    std::vector<Point> sum(m.points.size(), Point{{0., 0., 0.}});
    std::vector<double> count(m.points.size(), 0.);
    for(const Triangle& f : m.triangles)
      for(int i = 0; i < 3; ++i)
      {
        sum[f[i]] = sum[f[i]] + m.points[f[(i + 1) % 3]];
        count[f[i]] += 1.;
      }
    for(std::size_t v = 0; v < m.points.size(); ++v)
      if(count[v] > 0.)
        m.points[v] = 0.5 * m.points[v] + (0.5 / count[v]) * sum[v];
  }
  return m;
}

Mesh_data scaled(Mesh_data m, const Point& factors)
{
  for(Point& p : m.points)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] *= factors[i];
  return m;
}

Mesh_data without_isolated_vertices(const Mesh_data& m)
{
  std::vector<std::size_t> index(m.points.size(), m.points.size());
  Mesh_data result;
  for(Triangle t : m.triangles)
  {
    for(std::size_t& v : t)
    {
      if(index[v] == m.points.size())
      {
        index[v] = result.points.size();
        result.points.push_back(m.points[v]);
      }
      v = index[v];
    }
    result.triangles.push_back(t);
  }
  return result;
}

Mesh_data punctured(const Mesh_data& m, const std::vector<Point>& centers, double radius)
{
  Mesh_data result = m;
  const auto is_inside = [&](const Triangle& t)
  {
    return std::any_of(centers.begin(), centers.end(),
                       [&](const Point& c)
                       { return norm((1. / 3.) * (m.points[t[0]] + m.points[t[1]] + m.points[t[2]]) - c) < radius; });
  };
  result.triangles.erase(std::remove_if(result.triangles.begin(), result.triangles.end(), is_inside),
                         result.triangles.end());
  return without_isolated_vertices(result);
}

Mesh_data without_ball(const Mesh_data& m, const Point& center, double radius)
{
  Mesh_data result;
  result.points = m.points;
  for(const Triangle& t : m.triangles)
    if(std::none_of(t.begin(), t.end(), [&](std::size_t v) { return norm(m.points[v] - center) <= radius; }))
      result.triangles.push_back(t);
  return without_isolated_vertices(result);
}

Mesh_data disjoint_union(Mesh_data a, const Mesh_data& b, const Point& by)
{
  const std::size_t offset = a.points.size();
  for(const Point& p : b.points)
    a.points.push_back(p + by);
  for(const Triangle& t : b.triangles)
    a.triangles.push_back({{t[0] + offset, t[1] + offset, t[2] + offset}});
  return a;
}

Mesh_data shuffled(const Mesh_data& m, unsigned seed, std::vector<std::size_t>& new_index)
{
  std::mt19937 engine(seed);
  const auto shuffle = [&](auto& range)
  {
    for(std::size_t i = range.size(); i > 1; --i)
      std::swap(range[i - 1], range[engine() % i]);
  };
  new_index.resize(m.points.size());
  for(std::size_t v = 0; v < new_index.size(); ++v)
    new_index[v] = v;
  shuffle(new_index);
  Mesh_data result;
  result.points.resize(m.points.size());
  for(std::size_t v = 0; v < new_index.size(); ++v)
    result.points[new_index[v]] = m.points[v];
  result.triangles = m.triangles;
  shuffle(result.triangles);
  for(Triangle& t : result.triangles)
  {
    for(std::size_t& v : t)
      v = new_index[v];
    std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
  }
  return result;
}

Mesh_data with_diagonals_at_random(Mesh_data m, unsigned seed)
{
  std::mt19937 engine(seed);
  for(std::size_t f = 0; f + 1 < m.triangles.size(); f += 2)
    if(engine() % 2 == 0)
    {
      const Triangle &t = m.triangles[f], &u = m.triangles[f + 1];
      const std::array<std::size_t, 4> q = {{t[0], t[1], t[2], u[2]}};
      m.triangles[f] = {{q[1], q[2], q[3]}};
      m.triangles[f + 1] = {{q[1], q[3], q[0]}};
    }
  return m;
}

Mesh_data split_in_plane(const Mesh_data& m)
{
  Mesh_data result;
  result.points = m.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
  for(const Triangle& t : m.triangles)
  {
    Triangle c;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      const auto inserted = middle.insert({{(std::min)(a, b), (std::max)(a, b)}, result.points.size()});
      if(inserted.second)
        result.points.push_back(0.5 * (m.points[a] + m.points[b]));
      c[i] = inserted.first->second;
    }
    for(std::size_t i = 0; i < 3; ++i)
      result.triangles.push_back({{t[i], c[i], c[(i + 2) % 3]}});
    result.triangles.push_back(c);
  }
  return result;
}

Mesh_data doubly_covered(const Mesh_data& m)
{
  std::set<std::pair<std::size_t, std::size_t>> halfedges;
  for(const Triangle& t : m.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      halfedges.insert({t[i], t[(i + 1) % 3]});
  std::vector<char> is_border(m.points.size(), 0);
  for(const auto& h : halfedges)
    if(halfedges.count({h.second, h.first}) == 0)
      is_border[h.first] = is_border[h.second] = 1;
  for(const auto& h : halfedges)
    if(is_border[h.first] && is_border[h.second] && halfedges.count({h.second, h.first}) != 0)
      throw std::invalid_argument("an inner edge joins two vertices of the border");
  Mesh_data result = m;
  std::vector<std::size_t> other(m.points.size());
  for(std::size_t v = 0; v < other.size(); ++v)
  {
    other[v] = is_border[v] ? v : result.points.size();
    if(!is_border[v])
      result.points.push_back(m.points[v]);
  }
  for(const Triangle& t : m.triangles)
    result.triangles.push_back({{other[t[0]], other[t[2]], other[t[1]]}});
  return result;
}

} // namespace test_meshes
