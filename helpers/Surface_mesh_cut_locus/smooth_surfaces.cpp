// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test_meshes {

Mesh_data icosahedron()
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

Mesh_data sphere(std::size_t n)
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

Mesh_data jittered_sphere(std::size_t n, double amount, unsigned seed)
{
  return jittered(sphere(n), amount, seed, [](const Point& p) { return normalized(p); });
}

Mesh_data ellipsoid(double a, double b, double c, std::size_t n, double amount, unsigned seed)
{
  Mesh_data m = jittered_sphere(n, amount, seed);
  for(Point& p : m.points)
    p = {{a * p[0], b * p[1], c * p[2]}};
  return m;
}

Mesh_data bumpy(Mesh_data m, double height, unsigned seed)
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

Mesh_data bumpy_sphere(std::size_t n, double height, unsigned seed)
{
  return bumpy(jittered_sphere(n, 0.15, seed), height, seed);
}

Mesh_data sphere_with_bump(std::size_t n, const Point& top, double height, double width)
{
  Mesh_data m = sphere(n);
  for(Point& p : m.points)
  {
    const double angle = std::atan2(norm(cross(p, top)), dot(p, top));
    p = (1. + height * std::exp(-0.5 * angle * angle / (width * width))) * p;
  }
  return m;
}

Mesh_data surface_of_revolution(std::size_t nu, std::size_t nt,
                                const std::function<std::array<double, 2>(double)>& profile)
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

Mesh_data revolution(std::size_t nu, const std::vector<std::array<double, 2>>& profile)
{
  Mesh_data m;
  std::vector<std::vector<std::size_t>> rows;
  for(const auto& p : profile)
  {
    std::vector<std::size_t> row;
    const std::size_t n = p[0] == 0. ? 1 : nu;
    for(std::size_t i = 0; i < n; ++i)
    {
      row.push_back(m.points.size());
      m.points.push_back({{p[0] * std::cos(2. * pi * i / nu), p[0] * std::sin(2. * pi * i / nu), p[1]}});
    }
    rows.push_back(row);
  }
  for(std::size_t k = 1; k < rows.size(); ++k)
    for(std::size_t i = 0; i < nu; ++i)
    {
      const auto at = [&](std::size_t r, std::size_t j) { return rows[r][rows[r].size() == 1 ? 0 : j % nu]; };
      if(rows[k - 1].size() > 1)
        m.triangles.push_back({{at(k - 1, i), at(k - 1, i + 1), at(k, i + 1)}});
      if(rows[k].size() > 1)
        m.triangles.push_back({{at(k - 1, i), at(k, i + 1), at(k, i)}});
    }
  return m;
}

Mesh_data irregular_bumpy_sphere(std::size_t n, double height, unsigned seed)
{
  const Mesh_data rings = surface_of_revolution(3 * n, n,
                                                [](double t) {
    return std::array<double, 2>{{std::sin(pi * t), -std::cos(pi * t)}};
  });
  return bumpy(jittered(rings, 0.35, seed, [](const Point& p) { return normalized(p); }), height, seed);
}

Mesh_data capsule(double half_length, std::size_t nu, std::size_t nt)
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

Point torus_point(double R, double r, double u, double w)
{
  return {{(R + r * std::cos(w)) * std::cos(u), (R + r * std::cos(w)) * std::sin(u), r * std::sin(w)}};
}

Mesh_data torus(double R, double r, std::size_t nu, std::size_t nw, double amount, unsigned seed)
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
      add_square(m, {{a, b, c, d}}, !(amount > 0. && engine() % 2));
    }
  return m;
}

Mesh_data torus_with_shifted_rows(std::size_t nu, std::size_t nw, double r)
{
  Mesh_data m = torus(1., r, nu, nw);
  m.triangles.clear();
  for(std::size_t i = 0; i < nu; ++i)
    for(std::size_t j = 0; j < nw; ++j)
    {
      const std::size_t k = (i + 1) % nu, l = (j + 1) % nw;
      add_square(m, {{i * nw + j, k * nw + j, k * nw + l, i * nw + l}}, (i + j) % 2 == 0);
    }
  return m;
}

Mesh_data torus_of_rings(const std::vector<std::size_t>& numbers)
{
  const std::size_t rings = 8;
  Mesh_data m;
  std::vector<std::size_t> first;
  const auto number = [&](std::size_t k) { return numbers[k % numbers.size()]; };
  for(std::size_t k = 0; k < rings; ++k)
  {
    const double t = 2. * pi * k / rings, r = 3. + 1.2 * std::cos(t);
    first.push_back(m.points.size());
    for(std::size_t i = 0; i < number(k); ++i)
    {
      const double u = 2. * pi * i / number(k);
      m.points.push_back({{r * std::cos(u), r * std::sin(u), std::sin(t)}});
    }
  }
  for(std::size_t k = 0; k < rings; ++k)
  {
    const std::size_t next = (k + 1) % rings, a = number(k), b = number(next);
    for(std::size_t i = 0, j = 0; i < a || j < b;)
    {
      const std::size_t p = first[k] + i % a, q = first[next] + j % b;
      if(j >= b || (i < a && (i + 1) * b <= (j + 1) * a))
        m.triangles.push_back({{p, first[k] + ++i % a, q}});
      else
        m.triangles.push_back({{p, first[next] + ++j % b, q}});
    }
  }
  return m;
}

Mesh_data two_tori()
{
  return disjoint_union(torus(1., 0.4, 24, 12, 0.2, 1), torus(1., 0.5, 20, 12, 0.2, 2), {{5., 0., 0.}});
}

Mesh_data star_shape(std::size_t n, const std::function<double(const Point&)>& radius)
{
  Mesh_data mesh;
  std::map<std::array<int, 3>, std::size_t> index;
  const int m = static_cast<int>(n);
  const auto vertex = [&](const std::array<int, 3>& c)
  {
    const auto inserted = index.insert({c, mesh.points.size()});
    if(inserted.second)
    {
      Point p;
      for(int i = 0; i < 3; ++i) // equal angles: squares of similar size all over the sphere
        p[i] = std::tan((double(c[i]) / m) * pi / 4.);
      const double length = norm(p);
      for(double& x : p)
        x /= length;
      mesh.points.push_back(radius(p) * p);
    }
    return inserted.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side : {-1, 1})
      for(int i = -m; i < m; i += 2)
        for(int j = -m; j < m; j += 2)
        {
          std::array<std::size_t, 4> q;
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
          add_square(mesh, q);
        }
  return mesh;
}

Mesh_data sphere_of_squares(std::size_t n)
{
  return star_shape(n, [](const Point&) { return 1.; });
}

Mesh_data hilly_sphere(std::size_t n)
{
  return star_shape(n, [](const Point& p)
                    { return 1. + 0.15 * std::sin(5. * p[0] + 1.) * std::sin(6. * p[1] + 2.) * std::sin(4. * p[2]); });
}

Mesh_data needles(std::size_t n)
{
  return scaled(sphere_of_squares(n), {{1., 1., 100.}});
}

Mesh_data grid(std::size_t nx, std::size_t ny)
{
  Mesh_data m;
  for(std::size_t y = 0; y < ny; ++y)
    for(std::size_t x = 0; x < nx; ++x)
      m.points.push_back({{double(x), double(y), 0.}});
  for(std::size_t y = 0; y + 1 < ny; ++y)
    for(std::size_t x = 0; x + 1 < nx; ++x)
    {
      const std::size_t a = y * nx + x;
      add_square(m, {{a, a + 1, a + 1 + nx, a + nx}});
    }
  return m;
}

Mesh_data square(std::size_t n, double amount, unsigned seed)
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
      add_square(m, {{a, b, c, d}}, !(amount > 0. ? engine() % 2 != 0 : (i + j) % 2 != 0));
    }
  return m;
}

Mesh_data saddle(std::size_t n, double height, double jitter, unsigned seed)
{
  Mesh_data m = square(n, jitter, seed);
  for(Point& p : m.points)
  {
    const double x = 2. * p[0] - 1., y = 2. * p[1] - 1.;
    p = {{x, y, height * (x * x - y * y)}};
  }
  return m;
}

Mesh_data cylinder(double height, std::size_t nu, std::size_t nz, double amount, unsigned seed)
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
      add_square(m, {{a, b, c, d}});
    }
  return m;
}

Mesh_data annulus(double inner, double outer, std::size_t nu, std::size_t nr)
{
  Mesh_data m = cylinder(1., nu, nr, 0., 0);
  for(Point& p : m.points)
  {
    const double r = outer + (inner - outer) * p[2];
    p = {{r * p[0], r * p[1], 0.}};
  }
  return m;
}

} // namespace test_meshes
