// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_DIRECTION_TRUTH_H
#define CGAL_CUT_LOCI_BENCHMARK_DIRECTION_TRUTH_H

#include "accuracy_benchmark.h"
#include "geodesic_shooting.h"

#include <CGAL/Surface_mesh_cut_locus.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace analytic {

// How far the curve of the direction method is from the cut locus of a general source, in mean edge lengths.
struct Shot_errors
{
  double h = 0.;
  double mean = 0., max = 0.; // of the nodes on edges, from where two geodesics meet
  double max_away = 0.;       // of those farther than 4 from the ends
  std::size_t unverified = 0; // nodes near which no two geodesics meet
  std::size_t leaves = 0;
  std::vector<double> ends; // how far each conjugate end of the cut locus is from the nearest leaf
};

// Ends beyond `limit` are not looked for.
template <typename Surface>
Shot_errors shot_errors(const Surface& surface, Mesh mesh, const Point& near_source, double limit)
{
  using namespace CGAL::Cut_loci;
  const Mesh::Vertex_index source_vertex = snap_vertex(mesh, near_source);
  const Point source = mesh.point(source_vertex);
  const auto read = internal::read_triangle_mesh(mesh, mesh.points());
  internal::Direction_solver solver(read.mesh);
  const Index v = get(read.index_of_vertex, source_vertex);
  Indexed_source indexed;
  indexed.vertex = v;
  indexed.location = internal::location_of_vertex(solver.connectivity(), v);
  solver.compute_distance(indexed);
  solver.compute_strengths();
  solver.grow_tree();
  solver.close_cycles();
  const double threshold = solver.default_threshold();

  // The directions at the vertex, as those of the smooth surface: both are known for its edges.
  const internal::Geodesic_faces faces(read.mesh);
  const Index first = faces.first_halfedge(v);
  const auto edge = [&](Index h) { return mesh.point(read.vertices[read.mesh.target(h)]) - source; };
  const Geodesic_shooting<Surface> shooting(surface, source, edge(first));
  std::vector<std::pair<double, double>> table;
  double turned = 0., previous = 0.;
  Index around = first;
  do
  {
    double direction = shooting.direction(edge(around));
    while(direction < previous - 1e-9)
      direction += 2. * pi;
    table.push_back({turned, direction});
    previous = direction;
    turned += faces.angle(around);
    around = faces.next_around_source(around);
  } while(around != first);
  table.push_back({turned, 2. * pi});
  const auto smooth_direction = [&](double direction)
  {
    std::size_t i = 1;
    while(i + 1 < table.size() && direction > table[i].first)
      ++i;
    const double t = (direction - table[i - 1].first) / (table[i].first - table[i - 1].first);
    return table[i - 1].second + t * (table[i].second - table[i - 1].second);
  };

  Shot_errors result;
  result.h = mean_edge_length(mesh);
  const auto position = [&](const Indexed_location& location)
  {
    Vector p = CGAL::NULL_VECTOR;
    for(int i = 0; i < 3; ++i)
      p =
        p + location.coordinates[i] * (mesh.point(read.vertices[read.mesh.triangles[location.face][i]]) - CGAL::ORIGIN);
    return surface.project(CGAL::ORIGIN + p);
  };
  const auto cusps = shooting.cusps(limit);
  const std::vector<Direction_branches::Edge> branches = solver.branches()(threshold);
  const Sub_edge_curve curve =
    place_sub_edges(read.mesh, solver.connectivity(), solver.geometry(), solver.field(), branches);
  for(std::size_t i = 0; i < branches.size(); ++i)
  {
    const Index h = solver.connectivity().halfedge_of_edge[branches[i].edge];
    const Point p = position(curve.graph.nodes[i].location);
    const auto found = shooting.cut_point(p, smooth_direction(solver.field().vertices[read.mesh.source(h)].direction),
                                          smooth_direction(solver.field().vertices[read.mesh.target(h)].direction),
                                          curve.graph.nodes[i].distance);
    double end = (std::numeric_limits<double>::infinity)();
    for(const auto& c : cusps)
      end = (std::min)(end, std::sqrt((c.point - (p - CGAL::ORIGIN)).squared_length()));
    const double error = found ? std::sqrt((found->point - (p - CGAL::ORIGIN)).squared_length()) / result.h : 10.;
    if(error > 3.)
    {
      ++result.unverified;
      continue;
    }
    result.mean += error;
    result.max = (std::max)(result.max, error);
    if(end > 4. * result.h)
      result.max_away = (std::max)(result.max_away, error);
  }
  result.mean /= static_cast<double>((std::max)(branches.size() - result.unverified, std::size_t(1)));

  const Indexed_cut_locus with_ends = solver.filter(threshold, Curve::THROUGH_FACES);
  std::vector<int> degree(with_ends.nodes.size(), 0);
  for(const auto& e : with_ends.edges)
  {
    ++degree[e.source];
    ++degree[e.target];
  }
  std::vector<Point> leaves;
  for(std::size_t i = 0; i < degree.size(); ++i)
    if(degree[i] == 1)
      leaves.push_back(position(with_ends.nodes[i].location));
  result.leaves = leaves.size();
  for(const auto& c : cusps)
  {
    double d = (std::numeric_limits<double>::infinity)();
    for(const Point& p : leaves)
      d = (std::min)(d, std::sqrt((c.point - (p - CGAL::ORIGIN)).squared_length()) / result.h);
    if(d < 12.) // else it is a cusp of the conjugate locus that no shortest path reaches
      result.ends.push_back(d);
  }
  return result;
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_DIRECTION_TRUTH_H
