// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_MESHES_H
#define CGAL_CUT_LOCI_TEST_MESHES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Generators of test surfaces, as plain arrays.
namespace test_meshes {

using Point = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

constexpr double pi = 3.14159265358979323846;

struct Mesh_data
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

inline Point operator+(const Point& a, const Point& b)
{
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
inline Point operator-(const Point& a, const Point& b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline Point operator*(double s, const Point& a)
{
  return {{s * a[0], s * a[1], s * a[2]}};
}
inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Point& a)
{
  return std::sqrt(dot(a, a));
}
inline Point normalized(const Point& a)
{
  return (1. / norm(a)) * a;
}
inline Point cross(const Point& a, const Point& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

// uniform in [-1, 1]; std::uniform_real_distribution differs between standard libraries
inline double random_unit(std::mt19937& engine)
{
  return 2. * engine() / 4294967295. - 1.;
}

inline double mean_edge_length(const Mesh_data& m)
{
  double sum = 0.;
  for(const Triangle& t : m.triangles)
    for(int i = 0; i < 3; ++i)
      sum += norm(m.points[t[i]] - m.points[t[(i + 1) % 3]]);
  return sum / (3. * m.triangles.size());
}

// Moves each vertex by up to `amount` of its shortest edge in each coordinate, then by `project` back to the surface.
template <typename Projection>
Mesh_data jittered(Mesh_data m, double amount, unsigned seed, const Projection& project)
{
  std::vector<double> shortest(m.points.size(), 1e300);
  for(const Triangle& t : m.triangles)
    for(int i = 0; i < 3; ++i)
    {
      const double length = norm(m.points[t[i]] - m.points[t[(i + 1) % 3]]);
      shortest[t[i]] = (std::min)(shortest[t[i]], length);
      shortest[t[(i + 1) % 3]] = (std::min)(shortest[t[(i + 1) % 3]], length);
    }
  std::mt19937 engine(seed);
  for(std::size_t v = 0; v < m.points.size(); ++v)
  {
    for(double& x : m.points[v])
      x += amount * shortest[v] * random_unit(engine);
    m.points[v] = project(m.points[v]);
  }
  return m;
}

inline Mesh_data icosahedron()
{
  const double a = (1. + std::sqrt(5.)) / 2.;
  Mesh_data m;
  m.points = {{{-1, a, 0}},  {{1, a, 0}},  {{-1, -a, 0}}, {{1, -a, 0}}, {{0, -1, a}},  {{0, 1, a}},
              {{0, -1, -a}}, {{0, 1, -a}}, {{a, 0, -1}},  {{a, 0, 1}},  {{-a, 0, -1}}, {{-a, 0, 1}}};
  for(Point& p : m.points)
    p = normalized(p);
  m.triangles = {{{0, 11, 5}},  {{0, 5, 1}},  {{0, 1, 7}},  {{0, 7, 10}}, {{0, 10, 11}}, {{1, 5, 9}}, {{5, 11, 4}},
                 {{11, 10, 2}}, {{10, 7, 6}}, {{7, 1, 8}},  {{3, 9, 4}},  {{3, 4, 2}},   {{3, 2, 6}}, {{3, 6, 8}},
                 {{3, 8, 9}},   {{4, 9, 5}},  {{2, 4, 11}}, {{6, 2, 10}}, {{8, 6, 7}},   {{9, 8, 1}}};
  return m;
}

// each edge divided in `n`, projected to the unit sphere: 20 n^2 faces
inline Mesh_data sphere(std::size_t n)
{
  const Mesh_data base = icosahedron();
  Mesh_data m;
  std::map<std::array<std::pair<std::size_t, std::size_t>, 3>, std::size_t> index;
  for(const Triangle& t : base.triangles)
  {
    const auto vertex = [&](std::size_t i, std::size_t j)
    {
      // the integer weights of the corners name the point, whichever of its faces asks
      std::array<std::pair<std::size_t, std::size_t>, 3> key = {{{t[0], n - i - j}, {t[1], i}, {t[2], j}}};
      for(auto& k : key)
        if(k.second == 0)
          k.first = 12;
      std::sort(key.begin(), key.end());
      const auto inserted = index.emplace(key, m.points.size());
      if(inserted.second)
        m.points.push_back(normalized(double(n - i - j) * base.points[t[0]] + double(i) * base.points[t[1]] +
                                      double(j) * base.points[t[2]]));
      return inserted.first->second;
    };
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; i + j < n; ++j)
      {
        m.triangles.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)}});
        if(i + j + 2 <= n)
          m.triangles.push_back({{vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}});
      }
  }
  return m;
}

inline Mesh_data jittered_sphere(std::size_t n, double amount, unsigned seed)
{
  return jittered(sphere(n), amount, seed, [](const Point& p) { return normalized(p); });
}

inline Mesh_data ellipsoid(double a, double b, double c, std::size_t n, double amount, unsigned seed)
{
  Mesh_data m = jittered_sphere(n, amount, seed);
  for(Point& p : m.points)
    p = {{a * p[0], b * p[1], c * p[2]}};
  return m;
}

// Draws random waves on the unit sphere, the same ones on each mesh of it.
inline Mesh_data bumpy(Mesh_data m, double height, unsigned seed)
{
  std::mt19937 engine(seed + 1);
  std::array<Point, 8> wave;
  for(Point& w : wave)
    w = {{6. * random_unit(engine), 6. * random_unit(engine), 6. * random_unit(engine)}};
  for(Point& p : m.points)
  {
    double r = 1.;
    for(std::size_t i = 0; i < wave.size(); ++i)
      r += height / wave.size() * std::sin(dot(wave[i], p) + double(i));
    p = r * p;
  }
  return m;
}

inline Mesh_data bumpy_sphere(std::size_t n, double height, unsigned seed)
{
  return bumpy(jittered_sphere(n, 0.15, seed), height, seed);
}

// The unit sphere with a bell of some height and width (of its Gaussian, in radians) in the direction of `top`.
inline Mesh_data sphere_with_bump(std::size_t n, const Point& top, double height, double width)
{
  Mesh_data m = sphere(n);
  for(Point& p : m.points)
  {
    const double angle = std::atan2(norm(cross(p, top)), dot(p, top));
    p = (1. + height * std::exp(-0.5 * angle * angle / (width * width))) * p;
  }
  return m;
}

// The same surface with each vertex moved at random by up to `amount` of the mean edge length, in each coordinate.
inline Mesh_data rough(Mesh_data m, double amount, unsigned seed)
{
  std::mt19937 engine(seed);
  const double h = mean_edge_length(m);
  for(Point& p : m.points)
    for(double& x : p)
      x += amount * h * random_unit(engine);
  return m;
}

// Rings of `nu` vertices between two poles.
template <typename Profile>
Mesh_data surface_of_revolution(std::size_t nu, std::size_t nt, const Profile& profile)
{
  Mesh_data m;
  const auto vertex = [&](std::size_t t, std::size_t u) { return 1 + (t - 1) * nu + u % nu; };
  m.points.push_back({{0., 0., profile(0.)[1]}});
  for(std::size_t t = 1; t < nt; ++t)
    for(std::size_t u = 0; u < nu; ++u)
    {
      const std::array<double, 2> rz = profile(double(t) / nt);
      const double phi = 2. * pi * (u + 0.5 * (t % 2)) / nu;
      m.points.push_back({{rz[0] * std::cos(phi), rz[0] * std::sin(phi), rz[1]}});
    }
  const std::size_t last = m.points.size();
  m.points.push_back({{0., 0., profile(1.)[1]}});
  for(std::size_t u = 0; u < nu; ++u)
  {
    m.triangles.push_back({{0, vertex(1, u + 1), vertex(1, u)}});
    m.triangles.push_back({{last, vertex(nt - 1, u), vertex(nt - 1, u + 1)}});
    for(std::size_t t = 1; t + 1 < nt; ++t)
    {
      const std::size_t a = vertex(t, u), b = vertex(t, u + 1), c = vertex(t + 1, u), d = vertex(t + 1, u + 1);
      if(t % 2 == 0)
      {
        m.triangles.push_back({{a, b, c}});
        m.triangles.push_back({{b, d, c}});
      }
      else
      {
        m.triangles.push_back({{a, d, c}});
        m.triangles.push_back({{a, b, d}});
      }
    }
  }
  return m;
}

// A bumpy sphere whose faces are slim, of all sizes, and crowded at two poles.
inline Mesh_data irregular_bumpy_sphere(std::size_t n, double height, unsigned seed)
{
  const Mesh_data rings = surface_of_revolution(3 * n, n,
                                                [](double t) {
    return std::array<double, 2>{{std::sin(pi * t), -std::cos(pi * t)}};
  });
  return bumpy(jittered(rings, 0.35, seed, [](const Point& p) { return normalized(p); }), height, seed);
}

// a cylinder of radius 1 from z = -half_length to half_length, closed by hemispheres
inline Mesh_data capsule(double half_length, std::size_t nu, std::size_t nt)
{
  return surface_of_revolution(nu, nt,
                               [=](double t)
                               {
    const double s = t * (pi + 2. * half_length); // arc length from the lower pole
    if(s < pi / 2.)
      return std::array<double, 2>{{std::sin(s), -half_length - std::cos(s)}};
    if(s < pi / 2. + 2. * half_length)
      return std::array<double, 2>{{1., s - pi / 2. - half_length}};
    return std::array<double, 2>{{std::sin(s - 2. * half_length), half_length - std::cos(s - 2. * half_length)}};
  });
}

inline Point torus_point(double R, double r, double u, double w)
{
  return {{(R + r * std::cos(w)) * std::cos(u), (R + r * std::cos(w)) * std::sin(u), r * std::sin(w)}};
}

// torus of revolution, vertex 0 at (u, w) = (0, 0) on the outer equator; `amount` of the grid step is the jitter
inline Mesh_data torus(double R, double r, std::size_t nu, std::size_t nw, double amount = 0., unsigned seed = 0)
{
  Mesh_data m;
  std::mt19937 engine(seed);
  const auto vertex = [&](std::size_t u, std::size_t w) { return (u % nu) * nw + w % nw; };
  for(std::size_t u = 0; u < nu; ++u)
    for(std::size_t w = 0; w < nw; ++w)
    {
      double ju = amount * random_unit(engine), jw = amount * random_unit(engine);
      if(u == 0 && w == 0)
        ju = jw = 0.;
      m.points.push_back(torus_point(R, r, 2. * pi * (double(u) + ju) / nu, 2. * pi * (double(w) + jw) / nw));
      const std::size_t a = vertex(u, w), b = vertex(u + 1, w), c = vertex(u + 1, w + 1), d = vertex(u, w + 1);
      if(amount > 0. && engine() % 2)
      {
        m.triangles.push_back({{a, b, d}});
        m.triangles.push_back({{b, c, d}});
      }
      else
      {
        m.triangles.push_back({{a, b, c}});
        m.triangles.push_back({{a, c, d}});
      }
    }
  return m;
}

using Voxel = std::array<int, 3>;

// The boundary of a union of unit cubes, each side divided in `n` x `n` squares. Manifold if no two cubes touch in an
// edge or a vertex alone.
inline Mesh_data voxel_surface(const std::set<Voxel>& voxels, int n)
{
  Mesh_data m;
  std::map<Voxel, std::size_t> index;
  const auto vertex = [&](const Voxel& p)
  {
    const auto inserted = index.emplace(p, m.points.size());
    if(inserted.second)
      m.points.push_back({{double(p[0]) / n, double(p[1]) / n, double(p[2]) / n}});
    return inserted.first->second;
  };
  for(const Voxel& voxel : voxels)
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
      {
        Voxel neighbor = voxel;
        neighbor[axis] += side == 0 ? -1 : 1;
        if(voxels.count(neighbor))
          continue;
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            const auto corner = [&](int di, int dj)
            {
              Voxel p;
              p[axis] = n * (voxel[axis] + side);
              p[(axis + 1) % 3] = n * voxel[(axis + 1) % 3] + i + di;
              p[(axis + 2) % 3] = n * voxel[(axis + 2) % 3] + j + dj;
              return vertex(p);
            };
            std::array<std::size_t, 4> q = {{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}};
            if(side == 0)
              std::swap(q[1], q[3]);
            if((i + j) % 2 == 0)
              std::rotate(q.begin(), q.begin() + 1, q.end());
            m.triangles.push_back({{q[0], q[1], q[2]}});
            m.triangles.push_back({{q[0], q[2], q[3]}});
          }
      }
  return m;
}

inline Mesh_data box(int x, int y, int z, int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < x; ++i)
    for(int j = 0; j < y; ++j)
      for(int k = 0; k < z; ++k)
        voxels.insert({{i, j, k}});
  return voxel_surface(voxels, n);
}

// Moves each vertex to the mean of its neighbors, some times: rounds off the corners of voxels.
inline Mesh_data smoothed(Mesh_data m, int times)
{
  for(int t = 0; t < times; ++t)
  {
    std::vector<Point> sum(m.points.size(), Point{{0., 0., 0.}});
    std::vector<double> count(m.points.size(), 0.);
    for(const Triangle& f : m.triangles)
      for(int i = 0; i < 3; ++i)
      {
        sum[f[i]] = sum[f[i]] + m.points[f[(i + 1) % 3]];
        count[f[i]] += 1.;
      }
    for(std::size_t v = 0; v < m.points.size(); ++v)
      if(count[v] > 0.)
        m.points[v] = 0.5 * m.points[v] + (0.5 / count[v]) * sum[v];
  }
  return m;
}

// A plate with `holes_x` times `holes_y` square holes: a closed surface whose genus is their number.
inline Mesh_data perforated_plate(int holes_x, int holes_y, int n, unsigned seed)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 2 * holes_x + 1; ++i)
    for(int j = 0; j < 2 * holes_y + 1; ++j)
      if(i % 2 == 0 || j % 2 == 0)
        voxels.insert({{i, j, 0}});
  return jittered(smoothed(voxel_surface(voxels, n), 3), 0.1, seed, [](const Point& p) { return p; });
}

// The same with all edges rounded off.
inline Mesh_data rounded_plate(int holes_x, int holes_y, int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 2 * holes_x + 1; ++i)
    for(int j = 0; j < 2 * holes_y + 1; ++j)
      if(i % 2 == 0 || j % 2 == 0)
        voxels.insert({{i, j, 0}});
  return smoothed(voxel_surface(voxels, n), n * n / 2);
}

// The unit square in the plane z = 0, triangulated irregularly; its border is kept straight.
inline Mesh_data square(std::size_t n, double amount = 0., unsigned seed = 0)
{
  Mesh_data m;
  std::mt19937 engine(seed);
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
    {
      const double x = amount * random_unit(engine), y = amount * random_unit(engine);
      m.points.push_back(
        {{(double(i) + (i > 0 && i < n ? x : 0.)) / n, (double(j) + (j > 0 && j < n ? y : 0.)) / n, 0.}});
    }
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      if(amount > 0. ? engine() % 2 != 0 : (i + j) % 2 != 0)
      {
        m.triangles.push_back({{a, b, d}});
        m.triangles.push_back({{b, c, d}});
      }
      else
      {
        m.triangles.push_back({{a, b, c}});
        m.triangles.push_back({{a, c, d}});
      }
    }
  return m;
}

// an open cylinder of radius 1
inline Mesh_data cylinder(double height, std::size_t nu, std::size_t nz, double amount, unsigned seed)
{
  Mesh_data m;
  std::mt19937 engine(seed);
  for(std::size_t k = 0; k <= nz; ++k)
    for(std::size_t u = 0; u < nu; ++u)
    {
      const double ju = amount * random_unit(engine), jz = amount * random_unit(engine);
      const double phi = 2. * pi * (double(u) + ju) / nu;
      m.points.push_back(
        {{std::cos(phi), std::sin(phi), height * (double(k) + (k > 0 && k < nz ? jz : 0.)) / double(nz)}});
    }
  for(std::size_t k = 0; k < nz; ++k)
    for(std::size_t u = 0; u < nu; ++u)
    {
      const std::size_t a = k * nu + u, b = k * nu + (u + 1) % nu, c = b + nu, d = a + nu;
      m.triangles.push_back({{a, b, c}});
      m.triangles.push_back({{a, c, d}});
    }
  return m;
}

// Drops the vertices that no face has.
inline Mesh_data without_isolated_vertices(const Mesh_data& m)
{
  std::vector<std::size_t> index(m.points.size(), m.points.size());
  Mesh_data result;
  for(Triangle t : m.triangles)
  {
    for(std::size_t& v : t)
    {
      if(index[v] == m.points.size())
      {
        index[v] = result.points.size();
        result.points.push_back(m.points[v]);
      }
      v = index[v];
    }
    result.triangles.push_back(t);
  }
  return result;
}

// Takes the faces out whose centroid lies in one of the balls, which must be wide enough apart to leave a manifold.
inline Mesh_data punctured(const Mesh_data& m, const std::vector<Point>& centers, double radius)
{
  Mesh_data result = m;
  const auto is_inside = [&](const Triangle& t)
  {
    return std::any_of(centers.begin(), centers.end(),
                       [&](const Point& c)
                       { return norm((1. / 3.) * (m.points[t[0]] + m.points[t[1]] + m.points[t[2]]) - c) < radius; });
  };
  result.triangles.erase(std::remove_if(result.triangles.begin(), result.triangles.end(), is_inside),
                         result.triangles.end());
  return without_isolated_vertices(result);
}

// Both, one after the other, the second one moved.
inline Mesh_data disjoint_union(Mesh_data a, const Mesh_data& b, const Point& by)
{
  const std::size_t offset = a.points.size();
  for(const Point& p : b.points)
    a.points.push_back(p + by);
  for(const Triangle& t : b.triangles)
    a.triangles.push_back({{t[0] + offset, t[1] + offset, t[2] + offset}});
  return a;
}

// The same surface with vertices and faces in another order, and each face from another corner. `new_index` tells where
// each vertex went.
inline Mesh_data shuffled(const Mesh_data& m, unsigned seed, std::vector<std::size_t>& new_index)
{
  std::mt19937 engine(seed);
  const auto shuffle = [&](auto& range)
  {
    for(std::size_t i = range.size(); i > 1; --i)
      std::swap(range[i - 1], range[engine() % i]);
  };
  new_index.resize(m.points.size());
  for(std::size_t v = 0; v < new_index.size(); ++v)
    new_index[v] = v;
  shuffle(new_index);
  Mesh_data result;
  result.points.resize(m.points.size());
  for(std::size_t v = 0; v < new_index.size(); ++v)
    result.points[new_index[v]] = m.points[v];
  result.triangles = m.triangles;
  shuffle(result.triangles);
  for(Triangle& t : result.triangles)
  {
    for(std::size_t& v : t)
      v = new_index[v];
    std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
  }
  return result;
}

// A mesh of two components.
inline Mesh_data two_tori()
{
  Mesh_data result = torus(1., 0.4, 24, 12, 0.2, 1);
  const Mesh_data other = torus(1., 0.5, 20, 12, 0.2, 2);
  const std::size_t n = result.points.size();
  for(const Point& p : other.points)
    result.points.push_back({{p[0] + 5., p[1], p[2]}});
  for(const Triangle& t : other.triangles)
    result.triangles.push_back({{t[0] + n, t[1] + n, t[2] + n}});
  return result;
}

// The position of the vertex nearest to `p`.
inline std::size_t nearest_vertex(const Mesh_data& m, const Point& p)
{
  std::size_t best = 0;
  for(std::size_t v = 0; v < m.points.size(); ++v)
    if(norm(m.points[v] - p) < norm(m.points[best] - p))
      best = v;
  return best;
}

// The mesh as the stages of the library take it.
inline CGAL::Cut_loci::Indexed_triangle_mesh indexed(const Mesh_data& m)
{
  using CGAL::Cut_loci::Index;
  CGAL::Cut_loci::Indexed_triangle_mesh result;
  result.points = m.points;
  std::map<std::pair<Index, Index>, Index> halfedge;
  for(const Triangle& t : m.triangles)
    result.triangles.push_back({{Index(t[0]), Index(t[1]), Index(t[2])}});
  for(Index h = 0; h < result.number_of_halfedges(); ++h)
    halfedge[{result.source(h), result.target(h)}] = h;
  for(Index h = 0; h < result.number_of_halfedges(); ++h)
  {
    const auto found = halfedge.find({result.target(h), result.source(h)});
    result.opposite.push_back(found == halfedge.end() ? CGAL::Cut_loci::null_index : found->second);
  }
  return result;
}

} // namespace test_meshes

#endif // CGAL_CUT_LOCI_TEST_MESHES_H
