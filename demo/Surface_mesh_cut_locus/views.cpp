// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "views.h"
#include "Renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace picture {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int width_of_trial = 160;

// What can be seen from a direction.
struct Trial
{
  View view;
  double elevation = 0.;        // in radians above the horizon
  double coverage = 0.;         // pixels
  double front = 0., back = 0.; // whether and how well the two points are seen, in [0, 1]
  std::vector<double> samples;  // the same for points on the polylines
};

std::vector<Vector> sample_polylines(const Scene& scene)
{
  constexpr std::size_t most = 2000;
  std::size_t number = 0;
  for(const Polyline& polyline : scene.polylines)
    number += polyline.points.size();
  const std::size_t step = 1 + number / most;
  std::vector<Vector> samples;
  std::size_t i = 0;
  for(const Polyline& polyline : scene.polylines)
    for(const Vector& p : polyline.points)
      if(i++ % step == 0)
        samples.push_back(p);
  return samples;
}

// The mean normal around a point of the surface.
Vector normal_at(const Scene& scene, const Vector& p)
{
  double radius = std::numeric_limits<double>::infinity();
  for(const auto& t : scene.triangles)
    radius = (std::min)(radius, length((1. / 3.) * (scene.points[t[0]] + scene.points[t[1]] + scene.points[t[2]]) - p));
  Vector sum = {{0., 0., 0.}};
  for(const auto& t : scene.triangles)
  {
    const Vector &a = scene.points[t[0]], &b = scene.points[t[1]], &c = scene.points[t[2]];
    if(length((1. / 3.) * (a + b + c) - p) <= 3. * radius)
      sum = sum + cross(b - a, c - a);
  }
  return normalized(sum);
}

// Seen at a slant of 60 degrees, a point is seen well.
double how_well_seen(const Vector& normal, const View& view)
{
  return (std::min)(1., 2. * (std::max)(0., dot(normal, view.toward)));
}

Vector triangle_normal(const Scene& scene, std::uint32_t triangle)
{
  const auto& t = scene.triangles[triangle];
  return normalized(cross(scene.points[t[1]] - scene.points[t[0]], scene.points[t[2]] - scene.points[t[0]]));
}

} // namespace

View look_from(const Vector& toward, const Vector& up)
{
  View view;
  view.toward = normalized(toward);
  Vector right = cross(up, view.toward);
  if(length(right) < 1e-6 * length(up)) // from above or below: any other axis is up
    right = cross(std::abs(view.toward[1]) < 0.5 ? Vector{{0., 1., 0.}} : Vector{{0., 0., -1.}}, view.toward);
  view.right = normalized(right);
  view.up = cross(view.toward, view.right);
  return view;
}

Vector guess_up(const Scene& scene)
{
  constexpr double flat = 0.5;
  Vector low = scene.points.front(), high = low;
  for(const Vector& p : scene.points)
    for(int i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  const Vector size = high - low;
  const int shortest = static_cast<int>(std::min_element(size.begin(), size.end()) - size.begin());
  Vector up = {{0., 1., 0.}};
  if(size[shortest] < flat * (std::min)(size[(shortest + 1) % 3], size[(shortest + 2) % 3]))
  {
    up = {{0., 0., 0.}};
    up[shortest] = 1.;
  }
  return up;
}

std::vector<View> choose_two_views(const Scene& scene, const Vector& front, const Vector& back)
{
  const Vector up = guess_up(scene);
  const Vector front_normal = normal_at(scene, front), back_normal = normal_at(scene, back);
  const std::vector<Vector> samples = sample_polylines(scene);
  const View level = look_from(std::abs(up[2]) > 0.5 ? Vector{{1., 0., 0.}} : Vector{{0., 0., 1.}}, up);

  std::vector<Trial> trials;
  double largest_coverage = 0.;
  for(const double elevation : {-35., -10., 10., 30., 50.})
    for(int azimuth = 0; azimuth < 360; azimuth += 15)
    {
      const double e = elevation * pi / 180., a = azimuth * pi / 180.;
      Trial trial;
      trial.elevation = e;
      trial.view =
        look_from(std::cos(e) * (std::cos(a) * level.toward + std::sin(a) * level.right) + std::sin(e) * up, up);
      std::vector<Frame> frames = make_frames(scene, {trial.view}, width_of_trial);
      if(frames.empty())
        return {trial.view, look_from(-1. * trial.view.toward, up)};
      const Depth_buffer buffer(scene, frames.front());
      // in the same unit for all, whatever the scale of the frame
      trial.coverage = buffer.number_of_covered_pixels() / (frames.front().scale * frames.front().scale);
      largest_coverage = (std::max)(largest_coverage, trial.coverage);
      const auto shown = [&](const Vector& p, const Vector& normal)
      { return buffer.is_visible(p) ? how_well_seen(normal, trial.view) : 0.; };
      trial.front = shown(front, front_normal);
      trial.back = shown(back, back_normal);
      for(const Vector& p : samples)
      {
        const int column = static_cast<int>(buffer.frame().x(p)), row = static_cast<int>(buffer.frame().y(p));
        const std::uint32_t triangle = buffer.triangle(column, row);
        trial.samples.push_back(triangle == Depth_buffer::no_triangle ? 0.
                                                                      : shown(p, triangle_normal(scene, triangle)));
      }
      trials.push_back(std::move(trial));
    }

  // A little from above is how things are usually looked at.
  const auto habit = [](double elevation) { return -0.5 * std::abs(elevation - pi / 8.); };
  const auto best = [&](const auto& score)
  {
    return *std::max_element(trials.begin(), trials.end(),
                             [&](const Trial& s, const Trial& t) { return score(s) < score(t); });
  };
  const double number_of_samples = static_cast<double>((std::max)(std::size_t(1), samples.size()));
  const Trial first = best(
    [&](const Trial& t)
    {
    const double seen = std::accumulate(t.samples.begin(), t.samples.end(), 0.);
    return t.coverage / largest_coverage + 2. * t.front + habit(t.elevation) + 0.4 * seen / number_of_samples;
  });
  const Trial second = best(
    [&](const Trial& t)
    {
    double added = 0., seen = 0.;
    for(std::size_t i = 0; i < samples.size(); ++i)
    {
      added += (std::max)(0., t.samples[i] - first.samples[i]);
      seen += t.samples[i];
    }
    const double opposite = -dot(t.view.toward, first.view.toward);
    return t.coverage / largest_coverage + t.back + habit(t.elevation) + 1.5 * (std::min)(0.4, opposite) +
           (1.5 * added + 0.5 * seen) / number_of_samples;
  });
  return {first.view, second.view};
}

} // namespace picture
