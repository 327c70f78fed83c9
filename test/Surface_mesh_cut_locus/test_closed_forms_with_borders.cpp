// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Surfaces with borders whose cut loci are known: by the default method and by the paper's.

#include "surface_test.h"
#include "checked_curves.h"

#include <CGAL/Cut_loci/statistics.h>

namespace test_closed_forms_with_borders {

namespace {

using namespace surface_test;
using Plane_point = std::array<double, 2>;

double distance(const Plane_point& p, const Plane_point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

Plane_point point_of(const Cut_locus& cut_locus, Cut_locus::vertex_descriptor v)
{
  const auto& p = cut_locus.graph()[v].point;
  return {{p.x(), p.y()}};
}

// unit squares, n x n, the origin in the middle; along the x-axis for |x| < half, the squares above have vertices of
// their own
Mesh_data square_with_slit(int n, int half)
{
  Mesh_data m;
  std::vector<std::size_t> above;
  const int c = n / 2;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      m.points.push_back({{double(i - c), double(j - c), 0.}});
  for(int i = 0; i <= n; ++i)
  {
    const bool is_slit = std::abs(i - c) < half;
    above.push_back(is_slit ? m.points.size() : std::size_t((n + 1) * c + i));
    if(is_slit)
      m.points.push_back({{double(i - c), 0., 0.}});
  }
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const auto at = [&](int x, int y) { return y == c && j == c ? above[x] : std::size_t((n + 1) * y + x); };
      add_square(m, {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}}, (i + j) % 2 == 0);
    }
  return m;
}

// between the circle of radius `r` around `hole` and that of radius 1 around the origin
Mesh_data disk_with_hole(std::size_t n, std::size_t m, const Plane_point& hole, double r)
{
  Mesh_data data;
  for(std::size_t j = 0; j <= m; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double u = 2. * pi * (double(i) + 0.5 * double(j % 2)) / n, t = double(j) / m, radius = r + t * (1. - r);
      data.points.push_back(
        {{(1. - t) * hole[0] + radius * std::cos(u), (1. - t) * hole[1] + radius * std::sin(u), 0.}});
    }
  for(std::size_t j = 0; j < m; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t k = (i + 1) % n, a = j * n + i, b = j * n + k, c = a + n, d = b + n;
      add_square(data, {{a, b, d, c}}, j % 2 == 1);
    }
  return data;
}

class Closed_form_with_border : public ::testing::TestWithParam<Method>
{
protected:
  // Calls `check(cut_locus, h)` for the cut loci of both kinds of curves, whose topology and detour are right.
  template <typename Check>
  static void for_both_curves(const Mesh_data& data, std::size_t source, const Check& check)
  {
    const Built built(data);
    Solver solver(built.mesh, by(GetParam()));
    solver.set_source(built.vertices[source]);
    for(Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      SCOPED_TRACE(curve == Curve::MESH_EDGES ? "edges" : "faces");
      const Cut_locus result = solver.cut_locus(params::cut_locus_curve(curve));
      EXPECT_LT(checked_curves::measured(built.mesh, result).max, 1.);
      check(result, mean_edge_length(data));
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, Closed_form_with_border, ::testing::Values(Default_method(), Laplacian_method()));

// A hemisphere is convex: the only point with several shortest paths is opposite to a source on its border.
TEST_P(Closed_form_with_border, Hemisphere)
{
  const Mesh_data sphere = surface_of_revolution(48, 24,
                                                 [](double t) {
    return std::array<double, 2>{{std::sin(pi * t), -std::cos(pi * t)}};
  });
  const Mesh_data hemisphere = without_vertices(sphere, [](const Point& p) { return p[2] < -1e-9; });
  for(const Point& p : {Point{{0., 0., 1.}}, Point{{std::sin(0.7), 0., std::cos(0.7)}}, Point{{0., 1., 0.}}})
  {
    SCOPED_TRACE(p[2]);
    for_both_curves(hemisphere, nearest_vertex(hemisphere, p),
                    [&](const Cut_locus& cut_locus, double h)
                    {
      if(p[2] > 0.)
      {
        EXPECT_EQ(num_edges(cut_locus.graph()), 0u);
        EXPECT_EQ(CGAL::Cut_loci::compute_statistics(cut_locus).status,
                  CGAL::Cut_loci::Cut_locus_status::ONLY_A_BORDER);
      }
      else if(num_edges(cut_locus.graph()) > 0) // around that point, where many paths come close to each other
        for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
        {
          const auto q = cut_locus.graph()[v].point;
          EXPECT_LE(norm(Point{{q.x(), q.y(), q.z()}} + p), 3. * h) << q;
        }
    });
  }
}

// Behind a slit, ways around both of its ends are equal on a branch of a hyperbola.
TEST_P(Closed_form_with_border, Plane_with_slit)
{
  const int n = 40, half = 12;
  const Mesh_data data = square_with_slit(n, half);
  const Plane_point a = {{-double(half), 0.}}, b = {{double(half), 0.}};
  for(const Plane_point& s : {Plane_point{{0., -9.}}, Plane_point{{5., -8.}}, Plane_point{{-3., -15.}}})
  {
    SCOPED_TRACE(s[0]);
    for_both_curves(data, nearest_vertex(data, {{s[0], s[1], 0.}}),
                    [&](const Cut_locus& cut_locus, double h)
                    {
      double highest = 0.;
      for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
      {
        const Plane_point p = point_of(cut_locus, v);
        EXPECT_GE(p[1], 0.) << "before the slit there is nothing";
        highest = (std::max)(highest, p[1]);
        // the difference grows by less than 2 with the way
        const double difference = distance(s, a) + distance(a, p) - distance(s, b) - distance(b, p);
        EXPECT_LE(std::abs(difference), 2. * h) << p[0] << " " << p[1];
      }
      EXPECT_EQ(highest, double(n / 2)) << "it leads from the slit to the border";
    });
  }
}

// Behind a round hole it is the half line away from the source.
TEST_P(Closed_form_with_border, Disk_with_hole)
{
  const Plane_point hole = {{0.2, 0.1}};
  const double r = 0.25;
  const Mesh_data data = disk_with_hole(64, 16, hole, r);
  for(const Plane_point& p : {Plane_point{{-0.5, 0.3}}, Plane_point{{0.6, -0.5}}, Plane_point{{0., 1.}}})
  {
    SCOPED_TRACE(p[0]);
    const std::size_t source = nearest_vertex(data, {{p[0], p[1], 0.}});
    const Plane_point s = {{data.points[source][0], data.points[source][1]}};
    const double way = distance(s, hole);
    const Plane_point on = {{(hole[0] - s[0]) / way, (hole[1] - s[1]) / way}};
    for_both_curves(data, source,
                    [&](const Cut_locus& cut_locus, double h)
                    {
      double farthest = 0.;
      for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
      {
        const Plane_point q = point_of(cut_locus, v);
        const double along = (q[0] - s[0]) * on[0] + (q[1] - s[1]) * on[1];
        const double off = std::abs((q[0] - s[0]) * on[1] - (q[1] - s[1]) * on[0]);
        EXPECT_GT(along, way) << "it is behind the hole";
        EXPECT_LE(off, 1.5 * h) << q[0] << " " << q[1];
        farthest = (std::max)(farthest, std::hypot(q[0], q[1]));
      }
      EXPECT_GT(farthest, 0.99) << "it leads to the border";
    });
  }
}

} // namespace

} // namespace test_closed_forms_with_borders
