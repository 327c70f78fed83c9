// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"

#include "../../arap.h"

#include <CGAL/Surface_mesh_exact_geodesics.h>
#include <CGAL/cut_along_cut_locus.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace {

using Origin_map = Mesh::Property_map<Mesh::Vertex_index, Mesh::Vertex_index>;

// How far from a seam, in edges, the curve of mesh edges may be off the cut locus: there shortest paths may come from
// the wrong side of the seam, and directions are taken from farther inside.
constexpr int doubtful_edges = 2;

// How many edges each vertex is away from the border, up to `doubtful_edges`.
std::vector<int> edges_to_border(const Mesh& disk)
{
  std::vector<int> result(disk.number_of_vertices(), doubtful_edges + 1);
  for(Mesh::Vertex_index v : disk.vertices())
    if(disk.is_border(v))
      result[v] = 0;
  for(int step = 1; step <= doubtful_edges; ++step)
    for(Mesh::Edge_index e : disk.edges())
    {
      const Mesh::Vertex_index v = disk.vertex(e, 0), w = disk.vertex(e, 1);
      for(const auto& [from, to] : {std::make_pair(v, w), std::make_pair(w, v)})
        if(result[from] == step - 1)
          result[to] = (std::min)(result[to], step);
    }
  return result;
}

// The first layout: each vertex at its distance from the source, in the direction in which the shortest path to it
// starts.
Points_2 exponential_map(const Mesh& mesh, const Location& source, const Mesh& disk, Origin_map origin)
{
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics(mesh);
  geodesics.add_source(source);
  geodesics.set_directions(true);
  geodesics.compute();
  const double turn = 2. * CGAL_PI / geodesics.source_angle();

  const std::vector<int> level = edges_to_border(disk);
  Points_2 direction(disk.number_of_vertices(), {{0., 0.}});
  std::vector<bool> is_known(disk.number_of_vertices(), false);
  for(Mesh::Vertex_index v : disk.vertices())
    if(level[v] > doubtful_edges && geodesics.distance(origin[v]) > 0.)
    {
      const double angle = turn * geodesics.direction_at_source(origin[v]);
      direction[v] = {{std::cos(angle), std::sin(angle)}};
      is_known[v] = true;
    }
  // Narrow tongues between seams may be wholly unknown: then they are filled from their roots.
  std::vector<Mesh::Vertex_index> found;
  do
  {
    found.clear();
    for(Mesh::Vertex_index v : disk.vertices())
    {
      if(is_known[v])
        continue;
      std::array<double, 2> sum = {{0., 0.}};
      for(Mesh::Vertex_index w : disk.vertices_around_target(disk.halfedge(v)))
        if(is_known[w])
          for(int k = 0; k < 2; ++k)
            sum[k] += direction[w][k];
      const double norm = std::hypot(sum[0], sum[1]);
      if(!(norm > 1e-9))
        continue;
      direction[v] = {{sum[0] / norm, sum[1] / norm}};
      found.push_back(v);
    }
    for(Mesh::Vertex_index v : found)
      is_known[v] = true;
  } while(!found.empty());

  Points_2 plane(disk.number_of_vertices());
  for(Mesh::Vertex_index v : disk.vertices())
    for(int k = 0; k < 2; ++k)
      plane[v][k] = geodesics.distance(origin[v]) * direction[v][k];
  return plane;
}

double twice_area(const Points_2& plane, const std::array<std::uint32_t, 3>& t)
{
  const auto &p = plane[t[0]], &q = plane[t[1]], &r = plane[t[2]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// Moves and scales the layout into the square [-1, 1] x [-1, 1].
void fit(Points_2& plane)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low = {{infinity, infinity}}, high = {{-infinity, -infinity}};
  for(const auto& p : plane)
    for(int k = 0; k < 2; ++k)
    {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  const double scale = 2. / (std::max)(high[0] - low[0], high[1] - low[1]);
  for(auto& p : plane)
    for(int k = 0; k < 2; ++k)
      p[k] = scale * (p[k] - (low[k] + high[k]) / 2.);
}

std::size_t number_of_flips(const Triangles& triangles, const Points_2& plane)
{
  return std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) { return !(twice_area(plane, t) > 0.); });
}

// The part of the area that is moved to other faces.
double area_change(const Mesh& disk, const Triangles& triangles, const Points_2& plane)
{
  double flat_area = 0., area = 0.;
  std::vector<std::array<double, 2>> areas;
  for(const auto& t : triangles)
  {
    const auto p = [&](int i) { return disk.point(Mesh::Vertex_index(t[i])); };
    areas.push_back({{std::fabs(twice_area(plane, t)) / 2., std::sqrt(CGAL::squared_area(p(0), p(1), p(2)))}});
    flat_area += areas.back()[0];
    area += areas.back()[1];
  }
  double result = 0.;
  for(const std::array<double, 2>& a : areas)
    result += std::fabs(a[0] / flat_area - a[1] / area);
  return result;
}

} // namespace

Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, const std::function<void()>& on_flatten)
{
  Mesh disk;
  Origin_map origin = disk.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  CGAL::cut_along_cut_locus(mesh, cut_locus, disk, CGAL::parameters::vertex_to_vertex_map(origin));

  on_flatten();
  Points_3 points;
  Triangles triangles;
  for(Mesh::Vertex_index v : disk.vertices())
    points.push_back({{disk.point(v).x(), disk.point(v).y(), disk.point(v).z()}});
  for(Mesh::Face_index f : disk.faces())
  {
    const Mesh::Halfedge_index h = disk.halfedge(f);
    triangles.push_back({{disk.source(h), disk.target(h), disk.target(disk.next(h))}});
  }
  const Points_2 polar = exponential_map(mesh, cut_locus.source().location, disk, origin);
  Points_2 plane = polar;
  constexpr double tolerance = 1e-3; // what comes after it is not seen
  const bool is_flat = flatten_as_rigidly_as_possible(points, triangles, plane, tolerance);
  // A surface that closes around a short cut does not lie flat without being stretched, and rather folds.
  const bool is_rigid = is_flat && number_of_flips(triangles, plane) <= number_of_flips(triangles, polar);
  if(!is_rigid)
    plane = polar;
  fit(plane);

  Atlas atlas;
  atlas.numbers = {double(number_of_flips(triangles, plane)), area_change(disk, triangles, plane), double(is_rigid)};
  for(Mesh::Vertex_index v : disk.vertices())
  {
    atlas.origin.push_back(origin[v]);
    for(double x : plane[v])
      atlas.uv.push_back(static_cast<float>(x));
  }
  for(const auto& t : triangles)
    atlas.triangles.insert(atlas.triangles.end(), t.begin(), t.end());
  for(Mesh::Halfedge_index h : disk.halfedges())
    if(disk.is_border(h))
      for(Mesh::Vertex_index v : {disk.source(h), disk.target(h)})
        atlas.border.push_back(v);
  return atlas;
}
