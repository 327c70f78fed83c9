// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_CURVE_DISTANCE_H
#define CGAL_CUT_LOCI_BENCHMARK_CURVE_DISTANCE_H

#include "analytic_surfaces.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace analytic {

template <typename Cut_locus>
Polylines segments_of(const Cut_locus& cut_locus)
{
  Polylines result;
  const auto& g = cut_locus.graph();
  for(auto e : CGAL::make_range(edges(g)))
    result.push_back({g[source(e, g)].point, g[target(e, g)].point});
  if(result.empty())
    result.push_back({g[cut_locus.root()].point});
  return result;
}

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for(Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

struct Deviation
{
  double mean = 0., max = 0.;
};

// Cuts the polylines into pieces no longer than `step` and returns the points between.
inline std::vector<Point> sampled(const Polylines& curves, double step)
{
  std::vector<Point> result;
  for(const std::vector<Point>& c : curves)
  {
    if(!c.empty())
      result.push_back(c.front());
    for(std::size_t i = 1; i < c.size(); ++i)
    {
      const double length = std::sqrt(CGAL::squared_distance(c[i - 1], c[i]));
      const int n = (std::max)(1, static_cast<int>(std::ceil(length / step)));
      for(int k = 1; k <= n; ++k)
        result.push_back(c[i - 1] + (double(k) / n) * (c[i] - c[i - 1]));
    }
  }
  return result;
}

// The distances of points of `from`, `step` apart, to the curves `to`.
inline std::vector<double> distances(const std::vector<Point>& from, const Polylines& to)
{
  using Segment = Kernel::Segment_3;
  using Primitive = CGAL::AABB_segment_primitive<Kernel, std::vector<Segment>::iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  std::vector<Segment> segments;
  std::vector<Point> isolated;
  for(const std::vector<Point>& c : to)
  {
    if(c.size() == 1)
      isolated.push_back(c.front());
    for(std::size_t i = 1; i < c.size(); ++i)
      if(c[i] != c[i - 1])
        segments.emplace_back(c[i - 1], c[i]);
  }
  Tree tree(segments.begin(), segments.end());
  std::vector<double> result;
  result.reserve(from.size());
  for(const Point& p : from)
  {
    double d = segments.empty() ? (std::numeric_limits<double>::infinity)() : tree.squared_distance(p);
    for(const Point& q : isolated)
      d = (std::min)(d, CGAL::squared_distance(p, q));
    result.push_back(std::sqrt(d));
  }
  return result;
}

inline Deviation deviation(const Polylines& from, const Polylines& to, double step)
{
  const std::vector<double> d = distances(sampled(from, step), to);
  Deviation result;
  for(double x : d)
  {
    result.mean += x / static_cast<double>(d.size());
    result.max = (std::max)(result.max, x);
  }
  return result;
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_CURVE_DISTANCE_H
