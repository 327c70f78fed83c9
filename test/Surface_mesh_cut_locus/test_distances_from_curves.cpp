// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "curve_sources_cases.h"
#include "checked_curves.h"
#include "distance_by_points.h"

#include <CGAL/Cut_loci/injectivity_radius.h>

// The distance of each node of a cut locus of curves is the exact one at its place.
namespace test_distances_from_curves {

namespace {

using namespace curve_sources;
using Curves = std::vector<Edges>;

constexpr double exact = 1e-6; // in units of the mean edge length
constexpr Method methods[] = {Default_method(), Polyhedral_method()};

// -- what is true ------------------------------------------------------------------------------------------------------

double distance_between(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Point nearest_on_edge(const Built& built, Mesh::Edge_index e, const Point& p)
{
  const Point a = to_point(built.mesh.point(built.mesh.vertex(e, 0))),
              b = to_point(built.mesh.point(built.mesh.vertex(e, 1)));
  double along = 0., square = 0.;
  for(std::size_t i = 0; i < 3; ++i)
  {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    square += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double t = std::min(std::max(along / square, 0.), 1.);
  return {{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])}};
}

// -- what must hold ----------------------------------------------------------------------------------------------------

Result cut_locus(const Built& built, const Curves& curves, Method method)
{
  return compute_cut_locus(built.mesh, Vertices(), params::source_curves(curves).cut_locus_method(method));
}

void expect_right_topology(const Built& built, const Result& result, const Curves& curves, const std::string& what)
{
  SCOPED_TRACE(what);
  EXPECT_LE(checked_curves::measured(built.mesh, result, curves).max, exact);
}

// the largest difference, in units of the mean edge length
double largest_error(const Built& built, const Result& result, const Curves& curves)
{
  const Distance_by_points<Built> distance(built, curves);
  double error = 0.;
  for(const auto v : CGAL::make_range(vertices(result.graph())))
  {
    const Result::Vertex& node = result.graph()[v];
    EXPECT_GE(node.distance, 0.);
    error = std::max(error, std::fabs(node.distance - distance(node.location)));
  }
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    error = std::max(error, std::fabs(result.distance(v) - distance(v)));
  return error / mean_edge_length(built.data);
}

void expect_exact(const Mesh_data& data, const std::vector<std::vector<std::size_t>>& paths, const std::string& what)
{
  const Built built(data);
  Curves curves;
  for(const std::vector<std::size_t>& along : paths)
    curves.push_back(path(built, along));
  for(const Method method : methods)
  {
    const Result result = cut_locus(built, curves, method);
    EXPECT_LE(largest_error(built, result, curves), exact) << what;
    expect_right_topology(built, result, curves, what);
  }
}

void expect_no_negative(const Built& built, const Result& result)
{
  for(const auto v : CGAL::make_range(vertices(result.graph())))
    EXPECT_GE(result.graph()[v].distance, 0.);
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    EXPECT_GE(result.distance(v), 0.);
}

// In a plane, the distance from all of the border is that of the nearest of its edges. A node is as near to two points of
// it, or at the border.
void expect_medial_axis(const Mesh_data& data, const std::string& what)
{
  const Built built(data);
  const double h = mean_edge_length(data);
  Curves loops = border_loops(built);
  for(const bool is_reversed : {false, true})
  {
    if(is_reversed)
      std::reverse(loops.begin(), loops.end());
    for(const Method method : methods)
    {
      const Result result = cut_locus(built, loops, method);
      expect_right_topology(built, result, loops, what);
      for(const auto v : CGAL::make_range(vertices(result.graph())))
      {
        const Point p = to_point(result.graph()[v].point);
        std::vector<std::pair<double, Point>> feet;
        for(const Edges& loop : loops)
          for(const Mesh::Edge_index e : loop)
          {
            const Point foot = nearest_on_edge(built, e, p);
            feet.push_back({distance_between(p, foot), foot});
          }
        std::sort(feet.begin(), feet.end());
        EXPECT_NEAR(result.graph()[v].distance, feet[0].first, exact * h) << what;
        const auto is_another = [&](const std::pair<double, Point>& foot)
        { return foot.first <= feet[0].first + 1e-4 * h && distance_between(foot.second, feet[0].second) > 1e-3 * h; };
        EXPECT_TRUE(feet[0].first <= 1e-3 * h || std::any_of(feet.begin(), feet.end(), is_another))
          << what << ": a node at " << p[0] << ' ' << p[1] << " is on no medial axis";
      }
    }
  }
}

// -- surfaces ----------------------------------------------------------------------------------------------------------

// `rings` of `n` trapezoids around a hole, from the radius `inner` to `outer`, times `width` in one direction
Mesh_data ring(std::size_t n, std::size_t rings, double inner, double outer, double width, double turn)
{
  Mesh_data m;
  for(std::size_t i = 0; i <= rings; ++i)
    for(std::size_t k = 0; k < n; ++k)
    {
      const double r = inner + (outer - inner) * double(i) / double(rings);
      const double angle = 2. * pi * (double(k) + turn) / double(n);
      m.points.push_back({{width * r * std::cos(angle), r * std::sin(angle), 0.}});
    }
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t k = 0; k < n; ++k)
    {
      const std::size_t a = i * n + k, b = i * n + (k + 1) % n;
      m.triangles.push_back({{a, b + n, b}});
      m.triangles.push_back({{a, a + n, b + n}});
    }
  return m;
}

// a square of `n` by `n` squares, numbered by columns
Mesh_data grid(std::size_t n)
{
  Mesh_data m;
  for(std::size_t x = 0; x <= n; ++x)
    for(std::size_t y = 0; y <= n; ++y)
      m.points.push_back({{double(x) / double(n), double(y) / double(n), 0.}});
  for(std::size_t x = 0; x < n; ++x)
    for(std::size_t y = 0; y < n; ++y)
    {
      const std::size_t v = x * (n + 1) + y;
      m.triangles.push_back({{v, v + n + 1, v + n + 2}});
      m.triangles.push_back({{v, v + n + 2, v + 1}});
    }
  return m;
}

// the same with heights
Mesh_data hills(std::size_t n, double height, unsigned seed)
{
  Mesh_data m = grid(n);
  std::mt19937 engine(seed);
  for(Point& p : m.points)
  {
    p[0] += 0.1 / double(n) * random_unit(engine);
    p[2] = height * random_unit(engine);
  }
  return m;
}

std::vector<std::size_t> column(std::size_t n, std::size_t x)
{
  std::vector<std::size_t> result;
  for(std::size_t y = 0; y <= n; ++y)
    result.push_back(x * (n + 1) + y);
  return result;
}

} // namespace

// -- tests -------------------------------------------------------------------------------------------------------------

TEST(Distances_from_curves, are_exact_on_the_medial_axis_of_frames)
{
  const double corner = std::sqrt(2.);
  expect_medial_axis(ring(4, 2, corner, 2. * corner, 1., 0.5), "a frame");
  expect_medial_axis(ring(4, 2, corner, 3. * corner, 1.5, 0.5), "a longer one");
  expect_medial_axis(ring(4, 3, corner, 2. * corner, 1., 0.5), "one of three rings");
  expect_medial_axis(ring(4, 1, corner, 2. * corner, 0.7, 0.4), "a parallelogram");
}

TEST(Distances_from_curves, are_exact_on_the_medial_axis_of_rings)
{
  expect_medial_axis(ring(8, 2, 0.5, 1., 1., 0.), "a ring");
  expect_medial_axis(ring(5, 2, 0.3, 1., 1., 0.), "a pentagon");
  expect_medial_axis(ring(12, 3, 0.6, 1., 1.2, 0.2), "an ellipse");
}

TEST(Distances_from_curves, are_exact_on_the_medial_axis_of_plates)
{
  expect_medial_axis(punctured(square(7, 0.1, 1), {{{0.3, 0.3, 0.}}, {{0.7, 0.7, 0.}}}, 0.1), "two holes");
  expect_medial_axis(punctured(square(6, 0.1, 2), {{{0.5, 0.5, 0.}}}, 0.2), "one hole");
  expect_medial_axis(square(5, 0.2, 3), "no hole");
}

TEST(Distances_from_curves, are_the_radius_between_lines)
{
  for(const std::array<std::size_t, 3>& c : {std::array<std::size_t, 3>{{8, 2, 6}}, {{6, 2, 4}}, {{7, 2, 5}}})
  {
    const Built built(grid(c[0]));
    const Curves curves = {path(built, column(c[0], c[1])), path(built, column(c[0], c[2]))};
    const double n = double(c[0]), half = 0.5 * double(c[2] - c[1]) / n;
    for(const Method method : methods)
      EXPECT_NEAR(CGAL::Cut_loci::injectivity_radius(cut_locus(built, curves, method)).distance, half,
                  exact * mean_edge_length(built.data))
        << c[0];
    expect_exact(built.data, {column(c[0], c[1]), column(c[0], c[2])}, "two lines");
  }
}

TEST(Distances_from_curves, are_exact_beside_curves_that_touch_the_border)
{
  // also along three of its vertices, and with all vertices of a face
  expect_exact(grid(4), {{9, 14, 13}, {15, 20, 21}, {17, 11, 10, 16, 22}, {24, 18}, {5, 6, 1, 7, 12}}, "a grid");
  expect_exact(grid(3), {{0, 4, 5, 1}}, "three sides of two faces");
  expect_exact(hills(3, 0.1, 1), {{0, 4, 5, 1}}, "the same with heights");
  expect_exact(hills(4, 0.2, 2), {{0, 6, 12, 18, 24}}, "from corner to corner");
}

TEST(Distances_from_curves, leave_a_point_on_the_border_that_is_one_edge_between_two_ends)
{
  // the surface inside of the curve has a vertex, but that is not on the border
  expect_exact(grid(4), {{1, 6, 11, 16, 17, 18, 13, 8, 3, 4}, {20, 21}}, "at the border");
  expect_exact(grid(3), {{1, 5, 9, 10, 6, 2}}, "without a vertex");
}

TEST(Distances_from_curves, are_exact_beside_zigzags)
{
  expect_exact(grid(5), {{7, 8, 14, 15, 21, 22, 28}}, "a staircase");
  expect_exact(grid(5), {{13, 19, 20, 14, 13}}, "around two faces");
  expect_exact(hills(5, 0.15, 3), {{7, 8, 14, 20, 21, 15}}, "with heights");
  expect_exact(hills(5, 0.3, 4), {{7, 13, 14, 7}, {28, 22, 21}}, "around a face, and another one");
}

TEST(Distances_from_curves, are_exact_beside_paths_by_chance)
{
  for(const unsigned seed : {1u, 2u, 3u})
  {
    const Built closed(ellipsoid(1., 0.8, 0.6, 2, 0.1, seed));
    const Built open(hills(5, 0.2, seed));
    const Curves on_closed = random_curves(closed, 2, 4, seed), on_open = curves_at_border(open, 2, 3, seed);
    for(const Method method : methods)
    {
      EXPECT_LE(largest_error(closed, cut_locus(closed, on_closed, method), on_closed), exact) << seed;
      EXPECT_LE(largest_error(open, cut_locus(open, on_open, method), on_open), exact) << seed;
    }
  }
}

TEST(Distances_from_curves, are_exact_at_vertices_for_the_other_method)
{
  const Built built(hills(10, 0.1, 6));
  const Curves curves = {path(built, {24, 25, 36}), path(built, {84, 85})};
  const Result result = cut_locus(built, curves, Laplacian_method());
  const Distance_by_points<Built> distance(built, curves);
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    EXPECT_NEAR(result.distance(v), distance(v), exact * mean_edge_length(built.data));
}

// thin faces, and some with two corners at one point
TEST(Distances_from_curves, are_never_negative)
{
  Mesh_data folded, sliver;
  folded.points = {{{-0.0003, 0.9998, -0.0001}},
                   {{-1., 0., 0.}},
                   {{0., 0., 0.}},
                   {{0., 0., 0.}},
                   {{-5e-06, 0.263659, 0.735956}},
                   {{9e-05, -0.00036, 0.999953}},
                   {{0., 0., -1.}},
                   {{0., 0.2, 0.6}},
                   {{-0.0003, 0.9998, -0.0001}}};
  folded.triangles = {{{4, 5, 8}}, {{5, 7, 1}}, {{6, 0, 3}}, {{6, 3, 2}},
                      {{6, 2, 1}}, {{5, 1, 2}}, {{5, 4, 7}}, {{1, 0, 6}}};
  sliver.points = {{{0., 0., 0.}},      {{0.00034, 1., 0.}},  {{0.0002, 0.6, 0.}}, {{0.00021, 0.6, 0.}},
                   {{0.0002, 0.5, 0.}}, {{0.0001, 0.04, 0.}}, {{0.0001, 0.4, 0.}}, {{0.00027, 0.8, 0.}}};
  sliver.triangles = {{{4, 2, 5}}, {{0, 3, 7}}, {{2, 1, 7}}, {{2, 4, 1}},
                      {{5, 2, 6}}, {{3, 6, 2}}, {{0, 7, 1}}, {{2, 7, 3}}};
  const Built first(folded), second(sliver);
  for(const Method method : methods)
  {
    expect_no_negative(first, cut_locus(first, {path(first, {8, 5})}, method));
    expect_no_negative(second, cut_locus(second, border_loops(second), method));
  }
}

} // namespace test_distances_from_curves
