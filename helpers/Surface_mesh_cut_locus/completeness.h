// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_COMPLETENESS_H
#define CGAL_CUT_LOCI_HELPERS_COMPLETENESS_H

#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

// The counterpart of the detour: how much of what should be there has been found.
namespace curve_measures {

namespace internal {

using Vector = std::array<double, 3>;

template <typename Curve, typename Vertex>
Vector point_of(const Curve& curve, Vertex v)
{
  const auto& p = curve.graph()[v].point;
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

inline double distance(const Vector& p, const Vector& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

// Calls `use(point, length)` for the middles of pieces of length up to `step`.
template <typename Function>
void sample(const Vector& p, const Vector& q, double step, const Function& use)
{
  const double length = distance(p, q);
  const auto n = static_cast<std::size_t>(std::ceil(length / step));
  for(std::size_t i = 0; i < n; ++i)
  {
    const double t = (double(i) + 0.5) / double(n);
    use(Vector{{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}}, length / double(n));
  }
}

// Points in cubes of a given side, found by a point that is at most that far.
class Point_grid
{
public:
  explicit Point_grid(double side) : side_(side) {}

  void insert(const Vector& p) { cubes_[key(p, {{0, 0, 0}})].push_back(p); }

  bool has_neighbor(const Vector& p) const
  {
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          const auto found = cubes_.find(key(p, {{x, y, z}}));
          if(found != cubes_.end())
            for(const Vector& q : found->second)
              if(distance(p, q) <= side_)
                return true;
        }
    return false;
  }

private:
  // Cubes that share a key by overflow cost time, and nothing else.
  std::uint64_t key(const Vector& p, const std::array<int, 3>& step) const
  {
    std::uint64_t result = 0;
    for(int i = 0; i < 3; ++i)
      result = result * 2097143 + static_cast<std::uint64_t>(std::int64_t(std::floor(p[i] / side_)) + step[i]);
    return result;
  }

  double side_;
  std::unordered_map<std::uint64_t, std::vector<Vector>> cubes_;
};

} // namespace internal

/*
 * returns the share of the length of the edges of `trusted`, those for which `is_wanted(edge)` with its properties, within
 * `reach` of `curve`; 1 if there are none. Distances are taken through space.
 */
template <typename Trusted, typename Curve, typename Is_wanted>
double completeness(const Trusted& trusted, const Is_wanted& is_wanted, const Curve& curve, double reach)
{
  const double step = reach / 10.;
  internal::Point_grid grid(reach);
  for(auto v : CGAL::make_range(vertices(curve.graph())))
    grid.insert(internal::point_of(curve, v));
  for(auto e : CGAL::make_range(edges(curve.graph())))
    internal::sample(internal::point_of(curve, source(e, curve.graph())),
                     internal::point_of(curve, target(e, curve.graph())), step,
                     [&](const internal::Vector& p, double) { grid.insert(p); });
  double all = 0., found = 0.;
  for(auto e : CGAL::make_range(edges(trusted.graph())))
    if(is_wanted(trusted.graph()[e]))
      internal::sample(internal::point_of(trusted, source(e, trusted.graph())),
                       internal::point_of(trusted, target(e, trusted.graph())), step,
                       [&](const internal::Vector& p, double length)
                       {
        all += length;
        found += grid.has_neighbor(p) ? length : 0.;
      });
  return all > 0. ? found / all : 1.;
}

/// of all edges
template <typename Trusted, typename Curve>
double completeness(const Trusted& trusted, const Curve& curve, double reach)
{
  return completeness(
    trusted, [](const auto&) { return true; }, curve, reach);
}

} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_COMPLETENESS_H
