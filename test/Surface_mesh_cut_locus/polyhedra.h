// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_POLYHEDRA_H
#define CGAL_CUT_LOCI_TEST_POLYHEDRA_H

#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// Polyhedra, with and without border, on which shortest paths are straight, bend, or pass flat vertices. Cubes with
// divided faces are `box()`, cylinders `cylinder()`, in test_meshes.h.
namespace test_meshes {

inline Mesh_data scaled(Mesh_data m, const Point& factors)
{
  for(Point& p : m.points)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] *= factors[i];
  return m;
}

// the hull of random points of an ellipsoid: 2 * vertices - 4 faces, no two of them coplanar
inline Mesh_data random_convex_polyhedron(std::size_t vertices, unsigned seed, const Point& half_axes = {{1., 1., 1.}})
{
  using Hull_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Hull = CGAL::Surface_mesh<Hull_point>;
  std::mt19937 engine(seed);
  std::vector<Hull_point> points;
  while(points.size() < vertices)
  {
    Point p = {{0., 0., 0.}};
    for(double& x : p)
      x = random_unit(engine);
    if(norm(p) > 1. || norm(p) < 0.1)
      continue;
    p = normalized(p);
    points.push_back(Hull_point(half_axes[0] * p[0], half_axes[1] * p[1], half_axes[2] * p[2]));
  }
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

// the unit cube: 12 n^2 faces
inline Mesh_data cube(int n)
{
  return box(1, 1, 1, n);
}

inline Mesh_data cuboid(const Point& size, int n)
{
  return scaled(cube(n), size);
}

// Three unit cubes around the edge x = y = 1, both ends of which are saddles of 450 degrees.
inline Mesh_data l_shape(int n)
{
  return voxel_surface({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, n);
}

// Two bars of 5 x 1 x 1 cubes across each other: the four edges at which they meet bend paths.
inline Mesh_data cross_shape(int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 5; ++i)
  {
    voxels.insert({{i, 2, 0}});
    voxels.insert({{2, i, 0}});
  }
  return voxel_surface(voxels, n);
}

// Faces that come in pairs, with a square in common, get the other diagonal of it, each pair by chance.
inline Mesh_data with_diagonals_at_random(Mesh_data m, unsigned seed)
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

// Flat, with `holes_x` times `holes_y` square holes: a closed surface whose genus is their number. 7 x 8 holes have
// 1372 n^2 faces.
inline Mesh_data plate_with_holes(int holes_x, int holes_y, int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 2 * holes_x + 1; ++i)
    for(int j = 0; j < 2 * holes_y + 1; ++j)
      if(i % 2 == 0 || j % 2 == 0)
        voxels.insert({{i, j, 0}});
  return voxel_surface(voxels, n);
}

// The square [0, 2 k + 1]^2 without `k` x `k` unit squares: each loop of the border but the outer one bends paths. Each
// unit square is divided in n x n.
inline Mesh_data square_with_holes(int k, int n)
{
  const int cells = 2 * k + 1;
  Mesh_data m;
  for(int i = 0; i <= cells * n; ++i)
    for(int j = 0; j <= cells * n; ++j)
      m.points.push_back({{double(i) / n, double(j) / n, 0.}});
  const auto vertex = [&](int i, int j) { return std::size_t(i * (cells * n + 1) + j); };
  for(int i = 0; i < cells * n; ++i)
    for(int j = 0; j < cells * n; ++j)
    {
      if((i / n) % 2 == 1 && (j / n) % 2 == 1)
        continue;
      std::array<std::size_t, 4> q = {{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}};
      if((i + j) % 2 == 0)
        std::rotate(q.begin(), q.begin() + 1, q.end());
      m.triangles.push_back({{q[0], q[1], q[2]}});
      m.triangles.push_back({{q[0], q[2], q[3]}});
    }
  return without_isolated_vertices(m);
}

// the graph of z = height (x^2 - y^2) over [-1, 1]^2
inline Mesh_data saddle(std::size_t n, double height, double jitter = 0., unsigned seed = 0)
{
  Mesh_data m = square(n, jitter, seed);
  for(Point& p : m.points)
  {
    const double x = 2. * p[0] - 1., y = 2. * p[1] - 1.;
    p = {{x, y, height * (x * x - y * y)}};
  }
  return m;
}

// a flat ring, whose inner border bends paths and whose outer one does not
inline Mesh_data annulus(double inner, double outer, std::size_t nu, std::size_t nr)
{
  Mesh_data m = cylinder(1., nu, nr, 0., 0);
  for(Point& p : m.points)
  {
    const double r = outer + (inner - outer) * p[2];
    p = {{r * p[0], r * p[1], 0.}};
  }
  return m;
}

// Every face becomes four in its plane.
inline Mesh_data split_in_plane(const Mesh_data& m)
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

// Both sides of a surface with border, glued along it. No inner edge may join two vertices of the border: `square(n)`
// has none for even n from 4 on.
inline Mesh_data doubly_covered(const Mesh_data& m)
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

/// how a flat face with many corners is triangulated: by diagonals from one of them, by a zigzag, from its center
enum class Flat_face { FAN, ZIGZAG, STAR };

/// a cylinder of `n` flat sides, closed by two flat faces; the vertices of its rims come first, below and above
inline Mesh_data closed_cylinder(std::size_t n, double height, Flat_face caps)
{
  Mesh_data m;
  for(double z : {0., height})
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2. * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(n);
      m.points.push_back({{std::cos(angle), std::sin(angle), z}});
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    m.triangles.push_back({{i, j, n + j}});
    m.triangles.push_back({{i, n + j, n + i}});
  }
  for(bool is_above : {false, true})
  {
    const std::size_t first = is_above ? n : 0, center = m.points.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) // counterclockwise from above
    {
      m.triangles.push_back(is_above ? Triangle{{a, b, c}} : Triangle{{a, c, b}});
    };
    if(caps == Flat_face::STAR)
      m.points.push_back({{0., 0., is_above ? height : 0.}});
    for(std::size_t i = 0; i < n && caps == Flat_face::STAR; ++i)
      add(center, first + i, first + (i + 1) % n);
    for(std::size_t i = 1; i + 1 < n && caps == Flat_face::FAN; ++i)
      add(first, first + i, first + i + 1);
    for(std::size_t low = 0, high = n - 1; high - low > 1 && caps == Flat_face::ZIGZAG;)
    {
      const bool is_low_next = low + high == n - 1;
      add(first + low, first + (is_low_next ? low + 1 : high - 1), first + high);
      low += is_low_next ? 1 : 0;
      high -= is_low_next ? 0 : 1;
    }
  }
  return m;
}

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_TEST_POLYHEDRA_H
