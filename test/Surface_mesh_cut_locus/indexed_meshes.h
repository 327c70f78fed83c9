// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_INDEXED_MESHES_H
#define CGAL_CUT_LOCI_TEST_INDEXED_MESHES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace indexed_meshes {

using CGAL::Cut_loci::Index;
using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;

inline double pi()
{
  return std::acos(-1.);
}

inline Mesh glued(std::vector<Mesh::Point> points, std::vector<Mesh::Triangle> triangles)
{
  Mesh mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  std::map<std::pair<Index, Index>, Index> halfedge;
  mesh.opposite.assign(mesh.number_of_halfedges(), CGAL::Cut_loci::null_index);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    halfedge[{mesh.source(h), mesh.target(h)}] = h;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const auto found = halfedge.find({mesh.target(h), mesh.source(h)});
    if(found != halfedge.end())
      mesh.opposite[h] = found->second;
  }
  return mesh;
}

// nx x ny vertices at integer coordinates; squares are cut from their lowest to their highest corner
inline Mesh grid(Index nx, Index ny)
{
  std::vector<Mesh::Point> points;
  std::vector<Mesh::Triangle> triangles;
  for(Index y = 0; y < ny; ++y)
    for(Index x = 0; x < nx; ++x)
      points.push_back({{double(x), double(y), 0.}});
  for(Index y = 0; y + 1 < ny; ++y)
    for(Index x = 0; x + 1 < nx; ++x)
    {
      const Index a = y * nx + x, b = a + 1, c = b + nx, d = a + nx;
      triangles.push_back({{a, b, c}});
      triangles.push_back({{a, c, d}});
    }
  return glued(points, triangles);
}

// radii 1 and `r`; vertex `i * n + j` at the angles 2 pi i / m around the axis and 2 pi j / n around the tube; the
// triangles of the rows are shifted, and so nearly equilateral for m / n = 1 / r
inline Mesh torus(Index m, Index n, double r = 0.4)
{
  std::vector<Mesh::Point> points;
  std::vector<Mesh::Triangle> triangles;
  for(Index i = 0; i < m; ++i)
    for(Index j = 0; j < n; ++j)
    {
      const double u = 2. * pi() * i / m, w = 2. * pi() * j / n, radius = 1. + r * std::cos(w);
      points.push_back({{radius * std::cos(u), radius * std::sin(u), r * std::sin(w)}});
    }
  for(Index i = 0; i < m; ++i)
    for(Index j = 0; j < n; ++j)
    {
      const Index k = (i + 1) % m, l = (j + 1) % n;
      const Index a = i * n + j, b = k * n + j, c = k * n + l, d = i * n + l;
      if((i + j) % 2 == 0)
      {
        triangles.push_back({{a, b, c}});
        triangles.push_back({{a, c, d}});
      }
      else
      {
        triangles.push_back({{a, b, d}});
        triangles.push_back({{b, c, d}});
      }
    }
  return glued(points, triangles);
}

// the faces of a cube as grids of n x n squares, blown up to the radius that `radius` gives in each direction
template <typename Radius>
Mesh star_shape(Index n, const Radius& radius)
{
  std::vector<Mesh::Point> points;
  std::vector<Mesh::Triangle> triangles;
  std::map<std::array<int, 3>, Index> index;
  const int m = static_cast<int>(n);
  const auto vertex = [&](const std::array<int, 3>& c)
  {
    const auto inserted = index.insert({c, static_cast<Index>(points.size())});
    if(inserted.second)
    {
      Mesh::Point p;
      for(int i = 0; i < 3; ++i) // equal angles: squares of similar size all over the sphere
        p[i] = std::tan((double(c[i]) / m) * pi() / 4.);
      const double length = CGAL::Cut_loci::internal::norm(p);
      for(double& x : p)
        x /= length;
      const double s = radius(p);
      for(double& x : p)
        x *= s;
      points.push_back(p);
    }
    return inserted.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side : {-1, 1})
      for(int i = -m; i < m; i += 2)
        for(int j = -m; j < m; j += 2)
        {
          std::array<Index, 4> q;
          for(int k = 0; k < 4; ++k)
          {
            std::array<int, 3> c;
            c[axis] = side * m;
            c[(axis + 1) % 3] = i + (k == 1 || k == 2 ? 2 : 0);
            c[(axis + 2) % 3] = j + (k >= 2 ? 2 : 0);
            q[k] = vertex(c);
          }
          if(side < 0)
            std::swap(q[1], q[3]);
          triangles.push_back({{q[0], q[1], q[2]}});
          triangles.push_back({{q[0], q[2], q[3]}});
        }
  return glued(points, triangles);
}

// A torus of eight rings, with so many vertices as given, one after the other: with fans of slim faces between them.
inline Mesh torus_of_rings(const std::vector<Index>& numbers)
{
  const Index rings = 8;
  std::vector<Mesh::Point> points;
  std::vector<Mesh::Triangle> triangles;
  std::vector<Index> first;
  const auto number = [&](Index k) { return numbers[k % numbers.size()]; };
  for(Index k = 0; k < rings; ++k)
  {
    const double t = 2. * pi() * k / rings, r = 3. + 1.2 * std::cos(t);
    first.push_back(static_cast<Index>(points.size()));
    for(Index i = 0; i < number(k); ++i)
    {
      const double u = 2. * pi() * i / number(k);
      points.push_back({{r * std::cos(u), r * std::sin(u), std::sin(t)}});
    }
  }
  for(Index k = 0; k < rings; ++k)
  {
    const Index next = (k + 1) % rings, a = number(k), b = number(next);
    for(Index i = 0, j = 0; i < a || j < b;)
    {
      const Index p = first[k] + i % a, q = first[next] + j % b;
      if(j >= b || (i < a && (i + 1) * b <= (j + 1) * a))
        triangles.push_back({{p, first[k] + ++i % a, q}});
      else
        triangles.push_back({{p, first[next] + ++j % b, q}});
    }
  }
  return glued(points, triangles);
}

inline Mesh sphere(Index n)
{
  return star_shape(n, [](const Mesh::Point&) { return 1.; });
}

// with hills, valleys and many saddles
inline Mesh bumpy_sphere(Index n)
{
  return star_shape(n, [](const Mesh::Point& p)
                    { return 1. + 0.15 * std::sin(5. * p[0] + 1.) * std::sin(6. * p[1] + 2.) * std::sin(4. * p[2]); });
}

// a closed surface of triangles a hundred times as long as wide
inline Mesh needles(Index n)
{
  Mesh mesh = sphere(n);
  for(Mesh::Point& p : mesh.points)
    p[2] *= 100.;
  return mesh;
}

inline Mesh two_copies(const Mesh& mesh)
{
  std::vector<Mesh::Point> points = mesh.points;
  std::vector<Mesh::Triangle> triangles = mesh.triangles;
  points.insert(points.end(), mesh.points.begin(), mesh.points.end());
  for(const Mesh::Triangle& t : mesh.triangles)
  {
    const Index n = mesh.number_of_vertices();
    triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
  }
  return glued(points, triangles);
}

} // namespace indexed_meshes

#endif // CGAL_CUT_LOCI_TEST_INDEXED_MESHES_H
