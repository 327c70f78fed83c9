// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "mesh_data_of.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

namespace test_meshes {

Mesh_data convex_hull(const std::vector<Point>& corners)
{
  using Hull_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Hull = CGAL::Surface_mesh<Hull_point>;
  std::vector<Hull_point> points;
  for(const Point& p : corners)
    points.push_back(Hull_point(p[0], p[1], p[2]));
  Hull hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  // in an order that does not depend on the hull's
  std::map<Hull_point, std::size_t> index;
  Mesh_data m;
  for(const Hull_point& p : points)
  {
    index[p] = m.points.size();
    m.points.push_back({{p.x(), p.y(), p.z()}});
  }
  for(Hull::Face_index f : hull.faces())
  {
    const Hull::Halfedge_index h = hull.halfedge(f);
    Triangle t = {{index.at(hull.point(hull.source(h))), index.at(hull.point(hull.target(h))),
                   index.at(hull.point(hull.target(hull.next(h))))}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    m.triangles.push_back(t);
  }
  std::sort(m.triangles.begin(), m.triangles.end());
  return without_isolated_vertices(m);
}

Mesh_data random_convex_polyhedron(std::size_t vertices, unsigned seed, const Point& half_axes)
{
  std::mt19937 engine(seed);
  std::vector<Point> points;
  while(points.size() < vertices)
  {
    Point p = {{0., 0., 0.}};
    for(double& x : p)
      x = random_unit(engine);
    if(norm(p) > 1. || norm(p) < 0.1)
      continue;
    p = normalized(p);
    points.push_back({{half_axes[0] * p[0], half_axes[1] * p[1], half_axes[2] * p[2]}});
  }
  return convex_hull(points);
}

Mesh_data remeshed(const Mesh_data& m, double length)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  for(const Point& p : m.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const Triangle& t : m.triangles)
    CGAL::Euler::add_face(
      std::array<Mesh::Vertex_index, 3>{{Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2])}},
      mesh);
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh,
                                                     CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return mesh_data_of(mesh);
}

Mesh_data remeshed(const Mesh_data& m)
{
  return remeshed(m, mean_edge_length(m));
}

} // namespace test_meshes
