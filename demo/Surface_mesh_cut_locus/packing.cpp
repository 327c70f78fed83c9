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
#include <utility>

namespace {

constexpr double infinite_height = std::numeric_limits<double>::infinity();
constexpr std::size_t packing_columns =
  static_cast<std::size_t>(1. / margin_of_packing); // so that one of them is a margin

// How low and high a chart is in each column, and in one beside it on each side.
struct Outline
{
  std::vector<double> low, high;

  Outline(const Chart& chart, double width)
    : low(static_cast<std::size_t>(chart.size[0] / width) + 3, infinite_height), high(low.size(), -infinite_height)
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

  // That of the chart after half a turn.
  Outline turned(double height) const
  {
    Outline result = *this;
    for(std::size_t i = 0; i < low.size(); ++i)
    {
      result.low[i] = height - high[low.size() - 1 - i];
      result.high[i] = height - low[low.size() - 1 - i];
    }
    return result;
  }

  static UV to_UV(const Chart& chart, Mesh::Vertex_index v)
  {
    return {{(std::max)(chart.uv[v].x(), 0.), chart.uv[v].y()}}; // rounding may leave it
  }
};

// The lowest place above what is there; infinite if the outline is too wide.
std::pair<double, std::size_t> lowest_place(const Outline& outline, const std::vector<double>& top, double margin)
{
  std::pair<double, std::size_t> best(infinite_height, 0);
  for(std::size_t column = 0; column + outline.low.size() <= packing_columns; ++column)
  {
    double y = 0.;
    for(std::size_t k = 0; k < outline.low.size(); ++k)
      y = (std::max)(y, top[column + k] + margin - outline.low[k]);
    best = (std::min)(best, std::make_pair(y, column));
  }
  return best;
}

// Nothing if the charts do not go into a square of this side.
std::optional<Packing> packing_in(const Charts& charts, const std::vector<std::size_t>& order, double side)
{
  const double margin = side * margin_of_packing;
  std::vector<double> top(packing_columns, 0.);
  Packing result{std::vector<Packing::Place>(charts.size()), side};
  for(const std::size_t i : order)
  {
    const double height = charts[i]->size[1];
    const Outline upright(*charts[i], margin), turned = upright.turned(height);
    const auto at = lowest_place(upright, top, margin), at_turned = lowest_place(turned, top, margin);
    const bool is_turned = at_turned.first < at.first;
    const auto& [y, column] = is_turned ? at_turned : at;
    if(!(y + height + margin <= side))
      return std::nullopt;
    // an outline ends within a column, on the right, or, after half a turn, on the left
    const double right = double(column + upright.low.size() - 1) * margin;
    result.places[i] = {{{is_turned ? right - charts[i]->size[0] : double(column + 1) * margin, y}}, is_turned};
    for(std::size_t k = 0; k < upright.low.size(); ++k)
      top[column + k] = y + (is_turned ? turned : upright).high[k];
  }
  return result;
}

} // namespace

UV Packing::operator()(const Chart& chart, const Place& place, Mesh::Vertex_index v) const
{
  UV result;
  for(int i = 0; i < 2; ++i)
    result[i] = (place.corner[i] + (place.is_turned ? chart.size[i] - chart.uv[v][i] : chart.uv[v][i])) / side;
  return result;
}

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
