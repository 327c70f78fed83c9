// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "packing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t columns = static_cast<std::size_t>(1. / margin_of_packing); // so that one of them is a margin

// How low and high a chart is in each column, and in one beside it on each side.
struct Outline
{
  std::vector<double> low, high;

  Outline(const Chart& chart, double width)
    : low(static_cast<std::size_t>(chart.size[0] / width) + 3, infinity), high(low.size(), -infinity)
  {
    for(const Mesh::Edge_index e : chart.disk.edges())
    {
      UV p = to_UV(chart, chart.disk.vertex(e, 0)), q = to_UV(chart, chart.disk.vertex(e, 1));
      if(p[0] > q[0])
        std::swap(p, q);
      const auto first = static_cast<std::size_t>(p[0] / width), last = static_cast<std::size_t>(q[0] / width);
      const auto height_at = [&](double x) {
        return x <= p[0] ? p[1] : x >= q[0] ? q[1] : p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
      };
      for(std::size_t i = first; i <= last; ++i)
      {
        const auto [a, b] = std::minmax({height_at(double(i) * width), height_at(double(i + 1) * width)});
        for(std::size_t column = i; column <= i + 2; ++column)
        {
          low[column] = (std::min)(low[column], a);
          high[column] = (std::max)(high[column], b);
        }
      }
    }
  }

  static UV to_UV(const Chart& chart, Mesh::Vertex_index v)
  {
    return {{(std::max)(chart.uv[v].x(), 0.), chart.uv[v].y()}}; // rounding may leave it
  }
};

// Nothing if the charts do not go into a square of this side.
std::optional<Packing> packing_in(const Charts& charts, const std::vector<std::size_t>& order, double side)
{
  const double margin = side * margin_of_packing;
  std::vector<double> top(columns, 0.);
  Packing result{std::vector<UV>(charts.size()), side};
  for(const std::size_t i : order)
  {
    const Outline outline(*charts[i], margin);
    const std::size_t width = outline.low.size();
    double best = infinity;
    std::size_t best_column = 0;
    for(std::size_t column = 0; column + width <= columns; ++column)
    {
      double y = 0.;
      for(std::size_t k = 0; k < width; ++k)
        y = (std::max)(y, top[column + k] + margin - outline.low[k]);
      if(y < best)
      {
        best = y;
        best_column = column;
      }
    }
    if(best + charts[i]->size[1] + margin > side)
      return std::nullopt;
    result.corners[i] = {{double(best_column + 1) * margin, best}};
    for(std::size_t k = 0; k < width; ++k)
      top[best_column + k] = best + outline.high[k];
  }
  return result;
}

} // namespace

Packing pack(const Charts& charts)
{
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return charts[a]->size[1] > charts[b]->size[1]; });
  double least = 0.;
  for(const auto& chart : charts)
    least += chart->area;
  least = std::sqrt(least);
  double most = least;
  std::optional<Packing> result;
  for(; !result; most *= 2.)
    result = packing_in(charts, order, most);
  while(result->side - least > 0.5 * margin_of_packing * result->side)
  {
    const double side = 0.5 * (least + result->side);
    if(auto smaller = packing_in(charts, order, side))
      result = std::move(smaller);
    else
      least = side;
  }
  return std::move(*result);
}
