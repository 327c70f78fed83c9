// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "paths.h"

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

struct Paths::Geodesics : CGAL::Surface_mesh_exact_geodesics<Mesh>
{
  using CGAL::Surface_mesh_exact_geodesics<Mesh>::Surface_mesh_exact_geodesics;
};

namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

constexpr int ring_size = 12; // cut loci have branchings of three paths, rarely of more

std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {{mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))}};
}

Point point_at(const Mesh& mesh, const Location& location)
{
  const auto [a, b, c] = corners(mesh, location.first);
  return a + location.second[1] * (b - a) + location.second[2] * (c - a);
}

double height(const Mesh& mesh, Mesh::Face_index f, int corner)
{
  const auto p = corners(mesh, f);
  const Point &a = p[(corner + 1) % 3], &b = p[(corner + 2) % 3];
  return 2. * std::sqrt(CGAL::squared_area(p[0], p[1], p[2]) / CGAL::squared_distance(a, b));
}

// Points of the face around one of its points, as far as `radius`, or as the face goes.
void add_ring(const Mesh& mesh, const Location& center, double radius, std::vector<Location>& ring)
{
  const auto p = corners(mesh, center.first);
  const Vector u = p[1] - p[0], v = p[2] - p[0];
  const Vector x = u / std::sqrt(u.squared_length());
  Vector y = v - (v * x) * x;
  y = y / std::sqrt(y.squared_length());
  for(int i = 0; i < ring_size; ++i)
  {
    const double angle = 2. * CGAL_PI * (i + .5) / ring_size;
    const Vector step = radius * std::cos(angle) * x + radius * std::sin(angle) * y;
    const double c = (step * y) / (v * y), b = (step * x - c * (v * x)) / (u * x);
    const std::array<double, 3> change = {{-b - c, b, c}};
    double part = 1.;
    for(int k = 0; k < 3; ++k)
      if(change[k] < 0.)
        part = (std::min)(part, -center.second[k] / change[k]);
    if(!(part > 1e-6))
      continue;
    Location location = center;
    for(int k = 0; k < 3; ++k)
      location.second[k] = (std::max)(0., center.second[k] + part * change[k]);
    ring.push_back(location);
  }
}

// The point itself, then those around it, also across an edge that is near.
std::vector<Location> neighborhood(const Mesh& mesh, const Location& center, double radius)
{
  std::vector<Location> result = {center};
  add_ring(mesh, center, radius, result);
  Mesh::Halfedge_index h = mesh.halfedge(center.first);
  for(int k = 0; k < 3; ++k, h = mesh.next(h))
  {
    // the halfedge from corner k to the next one is opposite to corner k + 2
    if(center.second[(k + 2) % 3] * height(mesh, center.first, (k + 2) % 3) > radius)
      continue;
    const Mesh::Halfedge_index opposite = mesh.opposite(h);
    if(mesh.is_border(opposite))
      continue;
    const double a = center.second[k], b = center.second[(k + 1) % 3];
    if(!(a + b > 0.))
      continue;
    const Mesh::Face_index f = mesh.face(opposite);
    int first = 0; // the corner of f at which `opposite` starts, which is corner k + 1 here
    for(Mesh::Halfedge_index g = mesh.halfedge(f); g != opposite; g = mesh.next(g))
      ++first;
    Location location(f, {{0., 0., 0.}});
    const double inward = (std::min)(.3, radius / height(mesh, f, (first + 2) % 3));
    location.second[first] = (1. - inward) * b / (a + b);
    location.second[(first + 1) % 3] = (1. - inward) * a / (a + b);
    location.second[(first + 2) % 3] = inward;
    result.push_back(location);
  }
  return result;
}

double squared_distance(const Point& p, const std::vector<Point>& line)
{
  double result = CGAL::squared_distance(p, line.front());
  for(std::size_t i = 1; i < line.size(); ++i)
    result = (std::min)(result, CGAL::squared_distance(p, Kernel::Segment_3(line[i - 1], line[i])));
  return result;
}

// how far apart two lines get
double separation(const std::vector<Point>& line, const std::vector<Point>& other)
{
  double result = 0.;
  for(const Point& p : line)
    result = (std::max)(result, squared_distance(p, other));
  return std::sqrt(result);
}

} // namespace

Paths::Paths(const Mesh& mesh) : mesh_(mesh), geodesics_(std::make_unique<Geodesics>(mesh)) {}

Paths::~Paths() = default;

std::vector<Paths::Path> Paths::find(const std::vector<Location>& sources, const Location& end, double radius)
{
  geodesics_->clear_sources();
  for(const Location& source : sources)
    geodesics_->add_source(source);
  geodesics_->clear_queries();
  const std::vector<Location> ends = neighborhood(mesh_, end, radius);
  for(const Location& location : ends)
    geodesics_->add_query(location);
  geodesics_->compute();

  const Point target = point_at(mesh_, end);
  std::vector<Path> paths;
  for(std::size_t i = 0; i < ends.size(); ++i)
  {
    if(!std::isfinite(geodesics_->distance(Geodesics::Query{i})))
      continue;
    Path path;
    std::vector<Location> locations;
    geodesics_->shortest_path(Geodesics::Query{i}, std::back_inserter(locations));
    path.points.push_back(target);
    for(const Location& location : locations)
      path.points.push_back(point_at(mesh_, location));
    path.length = geodesics_->distance(Geodesics::Query{i}) + std::sqrt(CGAL::squared_distance(target, path.points[1]));
    paths.push_back(std::move(path));
  }
  std::sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.length < b.length; });

  // Neighbors are about as far apart as their ends; what is much farther apart goes another way.
  std::vector<Path> result;
  for(Path& path : paths)
  {
    if(path.length > paths.front().length + 2. * radius)
      continue;
    const bool is_new = std::all_of(result.begin(), result.end(),
                                    [&](const Path& other) {
      return (std::max)(separation(path.points, other.points), separation(other.points, path.points)) > 8. * radius;
    });
    if(is_new)
      result.push_back(std::move(path));
  }
  return result;
}
