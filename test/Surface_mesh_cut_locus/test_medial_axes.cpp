// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The medial axis of a border reaches its corners, and has no branches to the vertices that a smooth outline is made of.

#include "surface_test.h"
#include "curve_sources_cases.h"

namespace test_medial_axes {

namespace {

using namespace curve_sources;
using Outline = std::vector<std::array<double, 2>>;

// A region that is seen from the origin, in rings, turned and lifted by `height` at each point.
Mesh_data inside(
  const Outline& outline, std::size_t rings, double turn = 0.,
  const std::function<double(double, double)>& height = [](double, double) { return 0.; })
{
  Mesh_data m;
  const auto add = [&](double x, double y)
  {
    m.points.push_back(
      {{std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, height(x, y)}});
  };
  add(0., 0.);
  for(std::size_t k = 1; k <= rings; ++k)
    for(const auto& p : outline)
      add(p[0] * double(k) / double(rings), p[1] * double(k) / double(rings));
  const std::size_t n = outline.size();
  const auto at = [n](std::size_t k, std::size_t j) { return 1 + (k - 1) * n + j % n; };
  for(std::size_t j = 0; j < n; ++j)
    m.triangles.push_back({{0, at(1, j), at(1, j + 1)}});
  for(std::size_t k = 1; k < rings; ++k)
    for(std::size_t j = 0; j < n; ++j)
    {
      m.triangles.push_back({{at(k, j), at(k + 1, j), at(k + 1, j + 1)}});
      m.triangles.push_back({{at(k, j), at(k + 1, j + 1), at(k, j + 1)}});
    }
  return m;
}

Outline polygon(const Outline& corners, std::size_t edges_of_side)
{
  Outline result;
  for(std::size_t i = 0; i < corners.size(); ++i)
    for(std::size_t k = 0; k < edges_of_side; ++k)
    {
      const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const double t = double(k) / double(edges_of_side);
      result.push_back({{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])}});
    }
  return result;
}

Outline round(std::size_t n, const std::function<double(double)>& radius)
{
  Outline result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double u = 2. * pi * double(i) / double(n), r = radius(u);
    result.push_back({{r * std::cos(u), r * std::sin(u)}});
  }
  return result;
}

Outline noisy(Outline outline, double amount, unsigned seed)
{
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0., amount);
  for(auto& p : outline)
    for(double& x : p)
      x += normal(engine);
  return outline;
}

// A square of n by n half edges, from `begin` on, with the edges of a union jack; coordinates have six digits behind the point.
Mesh_data union_jacks(int n, double begin, double step)
{
  Mesh_data m;
  std::vector<std::vector<std::size_t>> number(std::size_t(n) + 1, std::vector<std::size_t>(std::size_t(n) + 1));
  const auto rounded = [&](int a) { return std::round(1e6 * (begin + step * a)) / 1e6; };
  for(int a = 0; a <= n; ++a)
    for(int b = a % 2; b <= n; b += 2)
    {
      number[a][b] = m.points.size();
      m.points.push_back({{rounded(a), rounded(b), 0.}});
    }
  const auto add = [&](const std::array<std::array<int, 2>, 3>& corners)
  {
    if(std::all_of(corners.begin(), corners.end(),
                   [n](const auto& c) { return c[0] >= 0 && c[0] <= n && c[1] >= 0 && c[1] <= n; }))
      m.triangles.push_back({{number[corners[0][0]][corners[0][1]], number[corners[1][0]][corners[1][1]],
                              number[corners[2][0]][corners[2][1]]}});
  };
  for(int a = 0; a <= n; ++a)
    for(int b = 1 - a % 2; b <= n; b += 2) // the middle of an edge
    {
      const std::array<int, 2> left = {{a - 1, b}}, right = {{a + 1, b}}, up = {{a, b + 1}}, down = {{a, b - 1}};
      if(b % 2 == 0 ? b % 4 == 0 : a % 4 != 0)
      {
        add({{left, right, up}});
        add({{right, left, down}});
      }
      else
      {
        add({{down, up, left}});
        add({{up, down, right}});
      }
    }
  return m;
}

Result medial_axis(const Mesh_data& data)
{
  const Built built(data);
  return compute_cut_locus(built.mesh, Vertices(), params::source_border(true));
}

// at the corners, and nowhere else
void expect_tips_at_corners(const Mesh_data& data, std::size_t number, const std::string& name)
{
  const Result axis = medial_axis(data);
  EXPECT_EQ(number_of_leaves(axis), number) << name;
  for(const auto v : CGAL::make_range(vertices(axis.graph())))
  {
    if(degree(v, axis.graph()) == 1)
    {
      EXPECT_LT(axis.graph()[v].distance, 1e-5) << name;
    }
  }
}

void expect_tips(const Mesh_data& data, std::size_t number, const std::string& name)
{
  EXPECT_EQ(number_of_leaves(medial_axis(data)), number) << name;
}

TEST(Medial_axes, of_rectangles_have_four_tips_however_they_are_divided_and_turned)
{
  const Outline corners = {{{-2., -1.}}, {{2., -1.}}, {{2., 1.}}, {{-2., 1.}}};
  for(std::size_t n : {1, 2, 7, 30})
    for(double turn : {0., 0.3, 1.1})
      expect_tips_at_corners(inside(polygon(corners, n), 6, turn), 4, std::to_string(n));
  for(std::size_t n : {4, 9, 20})
    expect_tips_at_corners(square(n, 0.2, unsigned(n)), 4, "square " + std::to_string(n));
  // sides that are not quite straight
  for(double noise : {1e-5, 1e-3, 1e-2})
    for(unsigned seed : {1, 2, 3})
      expect_tips_at_corners(inside(noisy(polygon(corners, 20), 0.1 * noise, seed), 8), 4, std::to_string(noise));
}

// The axis runs along edges and through vertices, but for rounding: in three of these, there are gaps between windows at ends of
// edges, which show what is behind.
TEST(Medial_axes, of_squares_whose_coordinates_are_rounded_have_four_tips)
{
  const auto expect_four_tips = [](const Mesh_data& data)
  {
    const Built built(data);
    std::vector<Edges> border(1);
    for(const Mesh::Edge_index e : built.mesh.edges())
      if(built.mesh.is_border(e))
        border[0].push_back(e);
    EXPECT_EQ(number_of_leaves(compute_cut_locus(built.mesh, Vertices(), params::source_curves(border))), 4u);
  };
  expect_four_tips(union_jacks(12, -0.9681535195910175, 0.09022943229912081));
  expect_four_tips(union_jacks(12, -0.1379633835207268, 0.0633577607283677));
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> begin(-1., 0.), step(0.02, 0.1);
  for(int i = 0; i < 40; ++i)
  {
    const double from = begin(engine), by = step(engine);
    SCOPED_TRACE(i);
    expect_four_tips(union_jacks(8 + 4 * (i % 3), from, by));
  }
}

TEST(Medial_axes, of_an_l_have_five_tips)
{
  const Outline corners = {{{-0.3, -0.3}}, {{2., -0.3}}, {{2., 0.7}}, {{0.7, 0.7}}, {{0.7, 2.}}, {{-0.3, 2.}}};
  for(std::size_t n : {1, 3, 10})
    for(double turn : {0., 0.7})
      expect_tips_at_corners(inside(polygon(corners, n), 6, turn), 5, std::to_string(n));
}

// From a dozen corners on, an outline stands for a smooth one, whose axis is a point.
TEST(Medial_axes, of_regular_polygons_have_corners_or_are_a_point)
{
  for(std::size_t n : {3, 4, 5, 6, 7, 8, 9, 12, 13, 16, 17, 25, 40, 100, 200})
    for(std::size_t edges : {1, 3})
    {
      const Mesh_data data = inside(polygon(round(n, [](double) { return 1.; }), edges), 6, 0.1 * double(n));
      if(n < 12)
        expect_tips_at_corners(data, n, std::to_string(n));
      else
        expect_tips(data, 0, std::to_string(n));
    }
}

TEST(Medial_axes, of_noisy_outlines_are_those_of_the_smooth_ones)
{
  for(std::size_t n : {60, 200})
    for(double noise : {0., 0.03, 0.1, 0.2}) // of an edge
      for(unsigned seed : {1, 2, 3})
      {
        const std::string name = std::to_string(n) + ", " + std::to_string(noise) + ", " + std::to_string(seed);
        const double amount = noise * 2. * pi / double(n);
        expect_tips(inside(noisy(round(n, [](double) { return 1.; }), amount, seed), 8), 0, "circle " + name);
        expect_tips(inside(noisy(round(n, [](double u) { return 1. / std::hypot(0.5 * std::cos(u), std::sin(u)); }),
                                 0.3 * amount, seed),
                           8),
                    2, "ellipse " + name);
      }
  for(std::size_t n : {120, 300})
    expect_tips(inside(round(n, [](double u) { return 1. + 0.25 * std::cos(5. * u); }), 10), 5, "flower");
}

TEST(Medial_axes, of_smooth_outlines_with_corners_have_these)
{
  for(std::size_t n : {20, 60, 200})
  {
    Outline half_disk = polygon({{{-1., -0.4}}, {{1., -0.4}}}, n / 2);
    half_disk.resize(n / 2);
    for(std::size_t i = 0; i < n; ++i)
      half_disk.push_back({{std::cos(pi * double(i) / double(n)), std::sin(pi * double(i) / double(n)) - 0.4}});
    expect_tips_at_corners(inside(half_disk, 8), 2, "half a disk");
  }
}

TEST(Medial_axes, of_curved_patches_are_those_of_flat_ones)
{
  const auto dome = [](double x, double y) { return std::sqrt((std::max)(0., 1. - x * x - y * y)); };
  for(std::size_t n : {8, 16, 32, 64})
  {
    // a hemisphere, by rings of equal distance
    Mesh_data data = inside(round(n, [](double) { return 1.; }), n / 3 + 1);
    for(Point& p : data.points)
    {
      const double r = std::hypot(p[0], p[1]), s = r > 0. ? std::sin(0.5 * pi * r) / r : 0.;
      p = {{s * p[0], s * p[1], std::cos(0.5 * pi * r)}};
    }
    expect_tips(data, 0, "hemisphere " + std::to_string(n));
  }
  const Outline corners = {{{-0.6, -0.4}}, {{0.6, -0.4}}, {{0.6, 0.4}}, {{-0.6, 0.4}}};
  for(std::size_t n : {6, 15})
    expect_tips_at_corners(inside(polygon(corners, n), 8, 0.2, dome), 4, "dome");
}

} // namespace

} // namespace test_medial_axes
