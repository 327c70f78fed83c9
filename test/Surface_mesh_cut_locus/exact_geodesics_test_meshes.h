// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef EXACT_GEODESICS_TEST_MESHES_H
#define EXACT_GEODESICS_TEST_MESHES_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_point_search.h>
#include <CGAL/Cut_loci/geodesics/geodesic_path_tracing.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Meshes made in code, as dense arrays, and what the tests of the exact geodesics do with them.
namespace test_meshes {

using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::Indexed_location;
using CGAL::Cut_loci::null_index;
using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;
using Point = Mesh::Point;
using Geodesics = CGAL::Cut_loci::internal::Exact_geodesic_propagation;
using Options = CGAL::Cut_loci::internal::Exact_geodesic_options;
using Path_tracing = CGAL::Cut_loci::internal::Geodesic_path_tracing;
using Point_search = CGAL::Cut_loci::internal::Geodesic_point_search;
using Found_point = CGAL::Cut_loci::internal::Geodesic_query;

constexpr double pi = 3.14159265358979323846;

inline double distance(const Point& p, const Point& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

/// links the halfedges, and removes vertices that are on no face
inline Mesh make_mesh(const std::vector<Point>& points, const std::vector<Mesh::Triangle>& triangles)
{
  Mesh mesh;
  std::vector<Index> number(points.size(), null_index);
  for(const Mesh::Triangle& t : triangles)
    for(Index v : t)
      number[v] = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(number[v] == 0)
    {
      number[v] = mesh.number_of_vertices();
      mesh.points.push_back(points[v]);
    }
  for(const Mesh::Triangle& t : triangles)
    mesh.triangles.push_back({{number[t[0]], number[t[1]], number[t[2]]}});
  std::map<std::pair<Index, Index>, Index> halfedge;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    halfedge[{mesh.source(h), mesh.target(h)}] = h;
  mesh.opposite.assign(mesh.number_of_halfedges(), null_index);
  for(const auto& entry : halfedge)
  {
    const auto other = halfedge.find({entry.first.second, entry.first.first});
    if(other != halfedge.end())
      mesh.opposite[entry.second] = other->second;
  }
  return mesh;
}

/// two triangles, cut from the first corner or from the second
inline void add_square(std::vector<Mesh::Triangle>& triangles, const std::array<Index, 4>& q, bool is_cut_from_first)
{
  triangles.push_back({{q[0], q[1], is_cut_from_first ? q[2] : q[3]}});
  triangles.push_back({{is_cut_from_first ? q[0] : q[1], q[2], q[3]}});
}

/// a grid of nx times ny unit squares, with random diagonals, moved by `place`
template <typename Place>
Mesh grid(Index nx, Index ny, unsigned seed, const Place& place)
{
  std::mt19937 random(seed);
  std::vector<Point> points;
  std::vector<Mesh::Triangle> triangles;
  for(Index i = 0; i <= nx; ++i)
    for(Index j = 0; j <= ny; ++j)
      points.push_back(place(double(i), double(j), random));
  for(Index i = 0; i < nx; ++i)
    for(Index j = 0; j < ny; ++j)
    {
      const Index a = i * (ny + 1) + j, b = a + ny + 1, c = b + 1, d = a + 1;
      add_square(triangles, {{a, b, c, d}}, (random() & 1) != 0);
    }
  return make_mesh(points, triangles);
}

inline Mesh flat_grid(Index nx, Index ny, unsigned seed = 1, double jitter = 0.)
{
  return grid(nx, ny, seed,
              [=](double x, double y, std::mt19937& random)
              {
    std::uniform_real_distribution<double> u(-jitter, jitter);
    // the border stays straight
    const double dx = x > 0. && x < nx ? u(random) : 0., dy = y > 0. && y < ny ? u(random) : 0.;
    return Point{{x + dx, y + dy, 0.}};
  });
}

inline Mesh bumpy_grid(Index nx, Index ny, double height, unsigned seed, double jitter = 0.)
{
  return grid(nx, ny, seed,
              [=](double x, double y, std::mt19937& random)
              {
    std::uniform_real_distribution<double> u(-1., 1.);
    const double dx = jitter * u(random), dy = jitter * u(random), z = height * u(random);
    return Point{{x + dx, y + dy, z}};
  });
}

/// a grid whose opposite sides are joined; `place` maps [0, 1)^2
template <typename Place>
Mesh closed_grid(Index n, Index m, const Place& place)
{
  std::vector<Point> points;
  std::vector<Mesh::Triangle> triangles;
  for(Index i = 0; i < n; ++i)
    for(Index j = 0; j < m; ++j)
      points.push_back(place(double(i) / n, double(j) / m));
  const auto v = [=](Index i, Index j) { return (i % n) * m + j % m; };
  for(Index i = 0; i < n; ++i)
    for(Index j = 0; j < m; ++j)
    {
      triangles.push_back({{v(i, j), v(i + 1, j), v(i + 1, j + 1)}});
      triangles.push_back({{v(i, j), v(i + 1, j + 1), v(i, j + 1)}});
    }
  return make_mesh(points, triangles);
}

inline Mesh torus(Index n, Index m, double jitter = 0., unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-jitter, jitter);
  return closed_grid(n, m,
                     [&](double s, double t)
                     {
    const double a = 2. * pi * (s + u(random) / n), b = 2. * pi * (t + u(random) / m), r = 1. + 0.4 * std::cos(b);
    return Point{{r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)}};
  });
}

/// the surface of [0, size[0]] x [0, size[1]] x [0, size[2]], with cells[i] cells along each axis
inline Mesh box(const std::array<double, 3>& size, const std::array<Index, 3>& cells)
{
  std::map<std::array<Index, 3>, Index> number;
  std::vector<Point> points;
  std::vector<Mesh::Triangle> triangles;
  const auto vertex = [&](const std::array<Index, 3>& c)
  {
    const auto inserted = number.insert({c, Index(points.size())});
    if(inserted.second)
    {
      Point p;
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = size[i] * c[i] / cells[i];
      points.push_back(p);
    }
    return inserted.first->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(Index side = 0; side < 2; ++side)
    {
      // u, v and the outer normal are a right-handed frame
      const std::size_t u = side == 1 ? (axis + 1) % 3 : (axis + 2) % 3, v = 3 - axis - u;
      for(Index i = 0; i < cells[u]; ++i)
        for(Index j = 0; j < cells[v]; ++j)
        {
          const auto corner = [&](Index di, Index dj)
          {
            std::array<Index, 3> c;
            c[axis] = side * cells[axis];
            c[u] = i + di;
            c[v] = j + dj;
            return vertex(c);
          };
          const Index a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          add_square(triangles, {{a, b, c, d}}, ((i + j) % 2) != 0);
        }
    }
  return make_mesh(points, triangles);
}

/// every marked edge gets a vertex at its middle
inline Mesh split_edges(const Mesh& mesh, const std::vector<char>& is_marked)
{
  std::vector<Point> points = mesh.points;
  std::vector<Index> middle(mesh.number_of_halfedges(), null_index);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    if(!is_marked[h])
      continue;
    const Index o = mesh.opposite[h];
    if(o != null_index && middle[o] != null_index)
    {
      middle[h] = middle[o];
      continue;
    }
    middle[h] = Index(points.size());
    const Point &p = mesh.points[mesh.source(h)], &q = mesh.points[mesh.target(h)];
    points.push_back({{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])}});
  }
  std::vector<Mesh::Triangle> triangles;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    // cut the corners between two marked edges off, then cut what is left from its first new vertex
    std::vector<Index> polygon;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index before = middle[Mesh::previous(h)];
      if(before != null_index && middle[h] != null_index)
        triangles.push_back({{before, mesh.source(h), middle[h]}});
      else
        polygon.push_back(mesh.source(h));
      if(middle[h] != null_index)
        polygon.push_back(middle[h]);
    }
    std::size_t first = 0;
    while(first + 1 < polygon.size() && polygon[first] < mesh.number_of_vertices())
      ++first;
    for(std::size_t k = 1; k + 1 < polygon.size(); ++k)
      triangles.push_back(
        {{polygon[first], polygon[(first + k) % polygon.size()], polygon[(first + k + 1) % polygon.size()]}});
  }
  return make_mesh(points, triangles);
}

/// two copies of a mesh with border, glued along the border; `move` gives the points of the second
template <typename Move>
Mesh doubled(const Mesh& open, const Move& move)
{
  const auto mark_border = [](const Mesh& mesh)
  {
    std::vector<char> is_border(mesh.number_of_vertices(), 0);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(mesh.is_border_edge(h))
        is_border[mesh.source(h)] = is_border[mesh.target(h)] = 1;
    return is_border;
  };
  // inner edges from border to border would be the same in both copies
  std::vector<char> is_border = mark_border(open), is_marked(open.number_of_halfedges(), 0);
  for(Index h = 0; h < open.number_of_halfedges(); ++h)
    is_marked[h] = !open.is_border_edge(h) && is_border[open.source(h)] && is_border[open.target(h)];
  const Mesh mesh = split_edges(open, is_marked);
  is_border = mark_border(mesh);
  const Index n = mesh.number_of_vertices();
  std::vector<Point> points = mesh.points;
  std::vector<Mesh::Triangle> triangles = mesh.triangles;
  for(const Point& p : mesh.points)
    points.push_back(move(p));
  const auto second = [&](Index v) { return is_border[v] ? v : v + n; };
  for(const Mesh::Triangle& t : mesh.triangles)
    triangles.push_back({{second(t[0]), second(t[2]), second(t[1])}});
  return make_mesh(points, triangles);
}

/// `sides` triangles around the origin, each in `rings` rings; `rim` gives the end of each ray
template <typename Rim>
Mesh fan(Index sides, Index rings, const Rim& rim)
{
  std::vector<Point> points(1, Point{{0., 0., 0.}});
  std::vector<Mesh::Triangle> triangles;
  for(Index r = 1; r <= rings; ++r)
    for(Index i = 0; i < sides; ++i)
    {
      Point p = rim(i);
      for(double& c : p)
        c *= double(r) / rings;
      points.push_back(p);
    }
  const auto v = [=](Index r, Index i) { return r == 0 ? 0 : 1 + (r - 1) * sides + i % sides; };
  for(Index i = 0; i < sides; ++i)
    for(Index r = 0; r < rings; ++r)
    {
      triangles.push_back({{v(r, i), v(r + 1, i), v(r + 1, i + 1)}});
      if(r > 0)
        triangles.push_back({{v(r, i), v(r + 1, i + 1), v(r, i + 1)}});
    }
  return make_mesh(points, triangles);
}

/// removes faces that have no vertex in common with each other or the border
inline Mesh perforated(const Mesh& mesh, double part, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0., 1.);
  std::vector<char> taken(mesh.number_of_vertices(), 0);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
      taken[mesh.source(h)] = taken[mesh.target(h)] = 1;
  std::vector<Mesh::Triangle> triangles;
  for(const Mesh::Triangle& t : mesh.triangles)
    if(u(random) < part && !taken[t[0]] && !taken[t[1]] && !taken[t[2]])
      taken[t[0]] = taken[t[1]] = taken[t[2]] = 1;
    else
      triangles.push_back(t);
  return make_mesh(mesh.points, triangles);
}

/// every face becomes four, with new vertices on the edges: at their middle, or at a random place of them
inline Mesh subdivided(const Mesh& mesh, double jitter = 0., unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0.5 - jitter, 0.5 + jitter);
  std::vector<Point> points = mesh.points;
  std::vector<Index> middle(mesh.number_of_halfedges());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const Index o = mesh.opposite[h];
    if(o != null_index && o < h)
    {
      middle[h] = middle[o];
      continue;
    }
    middle[h] = Index(points.size());
    const Point &p = mesh.points[mesh.source(h)], &q = mesh.points[mesh.target(h)];
    const double t = u(random);
    points.push_back({{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}});
  }
  std::vector<Mesh::Triangle> triangles;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    const Mesh::Triangle& t = mesh.triangles[f];
    const Index a = middle[3 * f], b = middle[3 * f + 1], c = middle[3 * f + 2];
    triangles.push_back({{t[0], a, c}});
    triangles.push_back({{t[1], b, a}});
    triangles.push_back({{t[2], c, b}});
    triangles.push_back({{a, b, c}});
  }
  return make_mesh(points, triangles);
}

/// the same mesh with other numbers; vertex `v` becomes `number[v]`
inline Mesh renumbered(const Mesh& mesh, unsigned seed, std::vector<Index>& number)
{
  std::mt19937 random(seed);
  number.resize(mesh.number_of_vertices());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    number[v] = v;
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Point> points(mesh.number_of_vertices());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    points[number[v]] = mesh.points[v];
  std::vector<Mesh::Triangle> triangles;
  for(const Mesh::Triangle& t : mesh.triangles)
  {
    const std::size_t i = random() % 3;
    triangles.push_back({{number[t[i]], number[t[(i + 1) % 3]], number[t[(i + 2) % 3]]}});
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return make_mesh(points, triangles);
}

inline Point point(const Mesh& mesh, const Indexed_location& location)
{
  Point p{{0., 0., 0.}};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += location.coordinates[i] * mesh.points[mesh.triangles[location.face][i]][k];
  return p;
}

inline Indexed_location location(Index face, double a, double b, double c)
{
  Indexed_location result;
  result.face = face;
  result.coordinates = {{a, b, c}};
  return result;
}

inline std::vector<Indexed_location> centroids(const Mesh& mesh)
{
  std::vector<Indexed_location> result;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
    result.push_back({f, {{1. / 3., 1. / 3., 1. / 3.}}});
  return result;
}

/// a random point in a face, on an edge, or at a vertex of it, in turn
inline Indexed_location random_location(const Mesh& mesh, std::mt19937& random, unsigned kind)
{
  std::uniform_real_distribution<double> u(0.05, 0.95);
  std::array<double, 3> c = {{u(random), u(random), u(random)}};
  const std::size_t i = random() % 3;
  if(kind % 3 == 1)
    c[i] = 0.;
  else if(kind % 3 == 2)
    c[i] = c[(i + 1) % 3] = 0.;
  const double sum = c[0] + c[1] + c[2];
  return location(Index(random() % mesh.number_of_faces()), c[0] / sum, c[1] / sum, c[2] / sum);
}

/// the faces that contain a location
inline std::set<Index> faces_around(const Mesh& mesh, const Indexed_location& location)
{
  std::set<Index> faces{location.face};
  std::size_t zeros = 0;
  for(double c : location.coordinates)
    zeros += c == 0.;
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = 3 * location.face + i;
    if(zeros == 1 && location.coordinates[(i + 2) % 3] == 0. && !mesh.is_border_edge(h))
      faces.insert(Mesh::face(mesh.opposite[h]));
    if(zeros == 2 && location.coordinates[i] != 0.)
      for(Index f = 0; f < mesh.number_of_faces(); ++f)
        for(Index v : mesh.triangles[f])
          if(v == mesh.triangles[location.face][i])
            faces.insert(f);
  }
  return faces;
}

/// the angle at `p` between the directions to `q` and `r`
inline double angle(const Point& p, const Point& q, const Point& r)
{
  const Point u{{q[0] - p[0], q[1] - p[1], q[2] - p[2]}}, v{{r[0] - p[0], r[1] - p[1], r[2] - p[2]}};
  const Point cross{{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  return std::atan2(distance(cross, {{0., 0., 0.}}), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}

/// what is wrong with a path from `end` of the given length, or nothing
inline std::string defect_of_path(const Geodesics& geodesics, const Mesh& mesh,
                                  const std::vector<Indexed_location>& path, const Point& end, double length)
{
  if(path.empty())
    return "it is empty";
  double scale = 0.;
  for(const Point& p : mesh.points)
    scale = (std::max)(scale, distance(p, mesh.points[0]));
  double sum = 0.;
  for(std::size_t i = 0; i < path.size(); ++i)
  {
    double coordinates = 0.;
    for(double c : path[i].coordinates)
    {
      if(c < 0.)
        return "a point is outside of its face";
      coordinates += c;
    }
    if(std::fabs(coordinates - 1.) > 1e-12)
      return "the coordinates of a point do not add up to one";
    if(i == 0)
      continue;
    const Point p = point(mesh, path[i - 1]), q = point(mesh, path[i]);
    const double step = distance(p, q);
    if(step == 0.)
      return "a point is there twice";
    sum += step;
    const std::set<Index> before = faces_around(mesh, path[i - 1]), after = faces_around(mesh, path[i]);
    std::vector<Index> common;
    std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(common));
    if(common.empty())
      return "a step leaves the surface";
    if(i + 1 == path.size())
      continue;
    // a vertex or an edge is crossed
    std::size_t zeros = 0;
    for(double c : path[i].coordinates)
      zeros += c == 0.;
    const Point r = point(mesh, path[i + 1]);
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * path[i].face + k;
      if(zeros == 2 && path[i].coordinates[k] != 0.)
      {
        const Index v = mesh.source(h);
        const double straight = geodesics.faces().is_border(v) ? pi : 2. * pi;
        if(!geodesics.faces().is_pseudo_source(v) && std::fabs(geodesics.faces().total_angle(v) - straight) > 1e-6)
          return "it goes through a vertex where it should not";
      }
      if(zeros == 1 && path[i].coordinates[(k + 2) % 3] == 0. && step > 1e-6 * scale && distance(q, r) > 1e-6 * scale)
      {
        const Point& t = mesh.points[mesh.target(h)];
        const Point& s = mesh.points[mesh.source(h)];
        // measured from the farther end, where rounding does less
        const Point& far = distance(q, s) > distance(q, t) ? s : t;
        if(std::fabs(angle(q, p, far) + angle(q, r, far) - pi) > 1e-6)
          return "it bends on an edge";
      }
    }
  }
  if(distance(point(mesh, path.front()), end) > 1e-8 * scale)
    return "it does not start at the end asked for";
  if(std::fabs(sum - length) > 1e-9 * (length + 1e-3 * scale))
    return "its length " + std::to_string(sum) + " is not the distance " + std::to_string(length);
  return "";
}

// -- random surfaces, of about `m` by `n` squares ---------------------------------------------------------------------

inline Mesh jittered_grid(Index m, Index n, unsigned seed)
{
  return bumpy_grid(m, n, std::pow(10., -2. + 0.5 * (seed % 6)), seed, 0.05 * (seed % 6));
}

inline Mesh needle_grid(Index m, Index n, unsigned seed)
{
  Mesh mesh = bumpy_grid(m, n, 0.3, seed, 0.2);
  for(Point& p : mesh.points)
    p[seed % 2] *= std::pow(10., -1. - 0.5 * (seed % 5));
  return mesh;
}

inline Mesh perforated_grid(Index m, Index n, unsigned seed)
{
  return perforated(bumpy_grid(m, n, 0.2 * (seed % 4), seed, 0.15), 0.3, seed);
}

inline Mesh jittered_torus(Index m, Index n, unsigned seed)
{
  return torus(m, n, 0.05 * (seed % 6), seed);
}

// of any genus
inline Mesh welded_grids(Index m, Index n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0.3, 0.6);
  return doubled(perforated(bumpy_grid(m, n, 0.2, seed, 0.15), 0.05 * (seed % 4), seed),
                 [&](const Point& p) {
    return Point{{p[0], p[1], p[2] + u(random)}};
  });
}

} // namespace test_meshes

#endif // EXACT_GEODESICS_TEST_MESHES_H
