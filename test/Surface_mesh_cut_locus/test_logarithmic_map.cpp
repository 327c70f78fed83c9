// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>

// The logarithmic map: where it is known in closed form, and as the inverse of the exponential map.

namespace test_logarithmic_map {

namespace {

using namespace surface_test;
using Halfedge = Mesh::Halfedge_index;
using Place = std::array<double, 2>;

Point point(const Mesh& mesh, const Location& location)
{
  const Kernel::Point_3 p = CGAL::Polygon_mesh_processing::construct_point(location, mesh);
  return {{p.x(), p.y(), p.z()}};
}

Point point(const Mesh& mesh, Mesh::Vertex_index v)
{
  return {{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}};
}

/// in a face, on an edge or at a vertex, in turn
Location random_location(const Mesh& mesh, std::mt19937& random, unsigned k)
{
  std::uniform_real_distribution<double> uniform(0.1, 1.);
  const Mesh::Face_index f(static_cast<Mesh::size_type>(random() % mesh.number_of_faces()));
  std::array<double, 3> c = {{uniform(random), k % 3 < 2 ? uniform(random) : 0., k % 3 < 1 ? uniform(random) : 0.}};
  std::rotate(c.begin(), c.begin() + random() % 3, c.end());
  return {f, (1. / (c[0] + c[1] + c[2])) * c};
}

/// seen from a point of the plane, with an x-axis from there in the direction of another one
Place seen_from(const Place& source, const Place& on_axis, const Place& p)
{
  const double x = on_axis[0] - source[0], y = on_axis[1] - source[1], length = std::hypot(x, y);
  const double dx = p[0] - source[0], dy = p[1] - source[1];
  return {{(x * dx + y * dy) / length, (x * dy - y * dx) / length}};
}

void expect_near(const Place& found, const Place& expected, double tolerance)
{
  EXPECT_NEAR(found[0], expected[0], tolerance);
  EXPECT_NEAR(found[1], expected[1], tolerance);
}

// ---- closed forms

/// inside, on the border and at its corners, from several sources, all of which have their own frame
TEST(Logarithmic_map, is_the_plane)
{
  const Built built(square(12, 0.3, 7));
  const Mesh& mesh = built.mesh;
  Geodesics geodesics(mesh);
  geodesics.set_directions(true);
  std::mt19937 random(3);
  std::vector<Location> queries;
  for(unsigned k = 0; k < 30; ++k)
  {
    queries.push_back(random_location(mesh, random, k));
    geodesics.add_query(queries.back());
  }
  const auto flat = [](const Point& p) { return Place{{p[0], p[1]}}; };
  for(unsigned k = 0; k < 60; ++k)
  {
    std::vector<Location> sources;
    geodesics.clear_sources();
    for(unsigned i = 0; i < 1 + k % 4; ++i)
    {
      sources.push_back(random_location(mesh, random, k + i));
      geodesics.add_source(sources.back());
    }
    geodesics.compute();
    const auto expected = [&](std::size_t i, const Point& p)
    {
      const Halfedge axis = geodesics.source_halfedge(i);
      const Place s = flat(point(mesh, sources[i])), from = flat(point(mesh, mesh.source(axis))),
                  to = flat(point(mesh, mesh.target(axis)));
      return seen_from(s, {{s[0] + to[0] - from[0], s[1] + to[1] - from[1]}}, flat(p));
    };
    for(const auto v : mesh.vertices())
    {
      const Place found = geodesics.logarithmic_map(v), polar = geodesics.polar_coordinates(v);
      expect_near(found, expected(geodesics.nearest_source(v), point(mesh, v)), 1e-9);
      EXPECT_EQ(polar[0], geodesics.distance(v));
      expect_near({{polar[0] * std::cos(polar[1]), polar[0] * std::sin(polar[1])}}, found, 1e-12);
    }
    for(std::size_t q = 0; q < queries.size(); ++q)
    {
      const std::size_t i = geodesics.nearest_source(Geodesics::Query{q});
      EXPECT_NEAR(geodesics.distance(Geodesics::Query{q}), norm(point(mesh, queries[q]) - point(mesh, sources[i])),
                  1e-9);
      expect_near(geodesics.logarithmic_map(Geodesics::Query{q}), expected(i, point(mesh, queries[q])), 1e-9);
      EXPECT_EQ(geodesics.polar_coordinates(Geodesics::Query{q})[0], geodesics.distance(Geodesics::Query{q}));
    }
  }
}

/// around the origin: vertex `1 + ring * turns.size() + k` is in the direction `k`, at the distance `ring + 1`
Mesh_data cone(const std::vector<Point>& directions, std::size_t rings)
{
  Mesh_data result;
  result.points.push_back({{0., 0., 0.}});
  const std::size_t n = directions.size();
  for(std::size_t ring = 1; ring <= rings; ++ring)
    for(std::size_t k = 0; k < n; ++k)
    {
      result.points.push_back(double(ring) * normalized(directions[k]));
      const std::size_t next = (k + 1) % n, a = 1 + (ring - 1) * n + k, b = 1 + (ring - 1) * n + next;
      if(ring == 1)
        result.triangles.push_back({{0, a, b}});
      else
        result.triangles.insert(result.triangles.end(), {{{a, b, a - n}}, {{b, b - n, a - n}}});
    }
  return result;
}

/// from the apex, around which angles are scaled, and from beside it
void expect_cone(const std::vector<Point>& directions)
{
  const std::size_t n = directions.size(), rings = 3;
  const Built built(cone(directions, rings));
  std::vector<double> angle = {0.}; // at the apex, up to each direction
  for(std::size_t k = 0; k < n; ++k)
  {
    const Point a = directions[k], b = directions[(k + 1) % n];
    angle.push_back(angle.back() + std::atan2(norm(cross(a, b)), dot(a, b)));
  }
  Geodesics geodesics(built.mesh);
  geodesics.set_directions(true);
  geodesics.compute(built.vertices[0]);
  EXPECT_NEAR(geodesics.source_angle(), angle.back(), 1e-12);
  const std::size_t axis = built.index(built.mesh.target(geodesics.source_halfedge())) - 1;
  for(std::size_t v = 1; v < built.vertices.size(); ++v)
  {
    const double r = 1. + double((v - 1) / n), a = 2. * pi * (angle[(v - 1) % n] - angle[axis]) / angle.back();
    expect_near(geodesics.logarithmic_map(built.vertices[v]), {{r * std::cos(a), r * std::sin(a)}}, 1e-12);
  }

  for(std::size_t k = 0; k < n; ++k)
  {
    geodesics.compute(built.vertices[1 + n + k]);
    const Place apex = geodesics.logarithmic_map(built.vertices[0]);
    EXPECT_NEAR(std::hypot(apex[0], apex[1]), 2., 1e-12);
    for(std::size_t v = 1; v < built.vertices.size(); ++v)
    {
      const double r = 1. + double((v - 1) / n);
      double apart = angle[(v - 1) % n] - angle[k]; // around the apex, the shorter way
      apart -= angle.back() * std::round(apart / angle.back());
      // laid flat with the apex at the origin; what paths reach by the apex is behind it
      const Place place = {{r * std::cos(apart), r * std::sin(apart)}};
      const Place expected = seen_from({{2., 0.}}, {{0., 0.}}, std::fabs(apart) < pi ? place : Place{{-r, 0.}});
      expect_near(seen_from({{0., 0.}}, apex, geodesics.logarithmic_map(built.vertices[v])), expected, 1e-9);
    }
  }
}

TEST(Logarithmic_map, is_a_cone_laid_flat)
{
  std::vector<Point> convex, saddle;
  for(double a : {0., 0.4, 1.3, 1.9, 2.8, 3.3, 4.1, 5.2, 5.8})
    convex.push_back({{0.6 * std::cos(a), 0.6 * std::sin(a), -0.8}});
  for(int k = 0; k < 11; ++k)
    saddle.push_back({{std::cos(2. * pi * k / 11), std::sin(2. * pi * k / 11), k % 2 ? 0.8 : -0.8}});
  expect_cone(convex);
  expect_cone(saddle);
}

/// a prism without its ends on `n` sides of the length 1, an odd number, so that no vertex is opposite to another one
TEST(Logarithmic_map, is_a_cylinder_unrolled)
{
  const std::size_t n = 11, rows = 9;
  Mesh_data prism;
  for(std::size_t k = 0; k < rows; ++k)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double a = 2. * pi * double(i) / double(n), radius = 0.5 / std::sin(pi / double(n));
      prism.points.push_back({{radius * std::cos(a), radius * std::sin(a), 0.7 * double(k)}});
      const std::size_t v = k * n + i, next = k * n + (i + 1) % n;
      if(k + 1 < rows)
        prism.triangles.insert(prism.triangles.end(), {{{v, next, next + n}}, {{v, next + n, v + n}}});
    }
  const Built built(prism);
  Geodesics geodesics(built.mesh);
  geodesics.set_directions(true);
  for(std::size_t source = n; source < (rows - 1) * n; ++source)
  {
    geodesics.compute(built.vertices[source]);
    const auto unrolled = [&](std::size_t v)
    {
      const double around = double(v % n) - double(source % n);
      return Place{{around - double(n) * std::round(around / double(n)), 0.7 * (double(v / n) - double(source / n))}};
    };
    const Place axis = unrolled(built.index(built.mesh.target(geodesics.source_halfedge())));
    for(std::size_t v = 0; v < prism.points.size(); ++v)
      expect_near(geodesics.logarithmic_map(built.vertices[v]), seen_from({{0., 0.}}, axis, unrolled(v)), 1e-12);
  }
}

// ---- the exponential map

/// whether the path meets a vertex on its way, where it may bend
bool meets_vertex(const std::vector<Location>& path)
{
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
    if(*std::max_element(path[i].second.begin(), path[i].second.end()) > 1. - 1e-9)
      return true;
  return false;
}

/// returns how many points are reached by straight paths
std::size_t expect_walks_to_end(const Mesh_data& data, unsigned seed)
{
  const Built built(data);
  const Mesh& mesh = built.mesh;
  Geodesics geodesics(mesh);
  geodesics.set_directions(true);
  std::mt19937 random(seed);
  std::vector<Location> queries;
  for(unsigned k = 0; k < 20; ++k)
  {
    queries.push_back(random_location(mesh, random, k));
    geodesics.add_query(queries.back());
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double diagonal = norm(Point{{box.x_span(), box.y_span(), box.z_span()}});
  std::size_t number = 0;
  for(unsigned k = 0; k < 9; ++k)
  {
    const std::vector<Location> sources = {random_location(mesh, random, k), random_location(mesh, random, k + 1)};
    geodesics.clear_sources();
    for(std::size_t i = 0; i < 1 + k % 2; ++i)
      geodesics.add_source(sources[i]);
    geodesics.compute();
    const auto check = [&](const Place& place, std::size_t i, const Point& end)
    {
      ++number;
      EXPECT_LE(norm(point(mesh, geodesics.exponential_map(place, i)) - end), 1e-9 * diagonal)
        << "seed " << seed << ", " << k;
    };
    for(const auto v : mesh.vertices())
    {
      std::vector<Location> path;
      geodesics.shortest_path(v, std::back_inserter(path));
      if(!meets_vertex(path))
        check(geodesics.logarithmic_map(v), geodesics.nearest_source(v), point(mesh, v));
    }
    for(std::size_t q = 0; q < queries.size(); ++q)
    {
      std::vector<Location> path;
      geodesics.shortest_path(Geodesics::Query{q}, std::back_inserter(path));
      if(!meets_vertex(path))
        check(geodesics.logarithmic_map(Geodesics::Query{q}), geodesics.nearest_source(Geodesics::Query{q}),
              point(mesh, queries[q]));
    }
  }
  return number;
}

TEST(Exponential_map, is_the_inverse)
{
  // on convex polyhedra all paths are straight
  for(unsigned seed = 1; seed <= 15; ++seed)
  {
    const Mesh_data data = random_convex_polyhedron(10 + 15 * seed, seed, {{1., 0.2 + 0.1 * seed, 0.5}});
    EXPECT_EQ(expect_walks_to_end(data, seed), 9 * (data.points.size() + 20));
  }
  for(unsigned seed = 1; seed <= 10; ++seed)
  {
    EXPECT_GT(expect_walks_to_end(rough(bumpy_sphere(6, 0.3, seed), 0.05, seed), seed), 1000u);
    EXPECT_GT(expect_walks_to_end(torus(1., 0.4, 18, 10, 0.2, seed), seed), 500u);
    EXPECT_GT(expect_walks_to_end(saddle(12, 0.3, 0.2, seed), seed), 500u); // with a border
  }
}

/// once or twice around four sides of the unit cube, and behind the cut locus
TEST(Exponential_map, goes_around_a_cube)
{
  const Built built(cube(5));
  Geodesics geodesics(built.mesh);
  const double around = 4.;
  for(std::size_t f = 0; f < built.faces.size(); f += 7)
  {
    const Location source(built.faces[f], {{0.2, 0.5, 0.3}});
    geodesics.compute(source);
    const Point p = point(built.mesh, source);
    const Halfedge axis = geodesics.source_halfedge();
    const Point edge = point(built.mesh, built.mesh.target(axis)) - point(built.mesh, built.mesh.source(axis));
    // the x-axis, turned to be parallel to a side if it is a diagonal
    const bool is_diagonal = std::count(edge.begin(), edge.end(), 0.) < 2;
    for(int quarter = 0; quarter < 4; ++quarter)
    {
      const double a = 0.5 * pi * quarter + (is_diagonal ? 0.25 * pi : 0.);
      for(double times : {1., 2.})
        EXPECT_LE(norm(point(built.mesh, geodesics.exponential_map(
                                           {{times * around * std::cos(a), times * around * std::sin(a)}})) -
                       p),
                  1e-9 * around);
    }
  }
}

/// in a square; directions in the angles of a grid meet vertices of a regular one, and run along edges
void expect_ends_at_border(double jitter, double offset)
{
  const double size = 1.;
  const Built built(square(6, jitter, 3));
  const Mesh& mesh = built.mesh;
  Geodesics geodesics(mesh);
  std::mt19937 random(5);
  for(unsigned k = 0; k < 90; ++k)
  {
    const Location source = random_location(mesh, random, k);
    geodesics.compute(source);
    const Halfedge axis = geodesics.source_halfedge();
    const Point s = point(mesh, source),
                x = normalized(point(mesh, mesh.target(axis)) - point(mesh, mesh.source(axis)));
    for(int n = 0; n < 24; ++n)
    {
      const double a = 2. * pi * (n + offset) / 24.;
      const Point d = std::cos(a) * x + std::sin(a) * Point{{-x[1], x[0], 0.}};
      double way = 2. * size; // until the border
      for(std::size_t c = 0; c < 2; ++c)
        if(std::fabs(d[c]) > 1e-12) // else along the border
          way = (std::min)(way, ((d[c] > 0. ? size : 0.) - s[c]) / d[c]);
      const Point end = point(mesh, geodesics.exponential_map({{2. * size * std::cos(a), 2. * size * std::sin(a)}}));
      EXPECT_LE(norm(end - (s + (std::max)(way, 0.) * d)), 1e-9 * size)
        << jitter << " " << offset << " " << k << " " << n;
    }
  }
}

TEST(Exponential_map, ends_at_the_border)
{
  for(const double jitter : {0., 0.2})
    for(const double offset : {0., 0.3})
      expect_ends_at_border(jitter, offset);
}

/// along edges, from one vertex to the next, all of which are curved: it goes on, on some side
TEST(Exponential_map, ends_though_it_meets_vertices)
{
  for(const Mesh_data& data : {icosahedron(), cube(2), saddle(4, 0.3)})
  {
    const Built built(data);
    Geodesics geodesics(built.mesh);
    geodesics.set_directions(true);
    for(const auto v : built.vertices)
    {
      geodesics.compute(v);
      for(const auto w : built.vertices)
      {
        const Place place = geodesics.logarithmic_map(w);
        const Location end = geodesics.exponential_map({{100. * place[0], 100. * place[1]}});
        EXPECT_NEAR(end.second[0] + end.second[1] + end.second[2], 1., 1e-12);
        EXPECT_GE(*std::min_element(end.second.begin(), end.second.end()), 0.);
      }
    }
  }
}

TEST(Exponential_map, of_what_is_no_place)
{
  const Built built(icosahedron());
  Geodesics geodesics(built.mesh);
  EXPECT_THROW(geodesics.exponential_map({{0., 0.}}), Invalid_input);
  geodesics.compute(built.vertices[2]);
  EXPECT_LE(norm(point(built.mesh, geodesics.exponential_map({{0., 0.}})) - built.data.points[2]), 1e-15);
  EXPECT_THROW(geodesics.exponential_map({{0., 0.}}, 1), Invalid_input);
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e30})
    EXPECT_THROW(geodesics.exponential_map({{x, 1.}}), Invalid_input);
}

// ---- what has no place

TEST(Logarithmic_map, of_sources_and_what_is_not_reached)
{
  const std::size_t n = icosahedron().points.size();
  const Built built(disjoint_union(icosahedron(), icosahedron(), {{5., 0., 0.}}));
  Geodesics geodesics(built.mesh);
  geodesics.set_directions(true);
  const Location centroid(built.faces.front(), {{1. / 3., 1. / 3., 1. / 3.}});
  geodesics.add_query({built.faces.back(), centroid.second});
  geodesics.add_query(centroid);
  geodesics.compute(built.vertices[0]);
  EXPECT_EQ(geodesics.logarithmic_map(built.vertices[0]), (Place{{0., 0.}}));
  EXPECT_EQ(geodesics.polar_coordinates(built.vertices[0]), (Place{{0., 0.}}));
  const auto expect_unreached = [](const Place& place, const Place& polar)
  { EXPECT_TRUE(std::isnan(place[0]) && std::isnan(place[1]) && std::isinf(polar[0]) && std::isnan(polar[1])); };
  for(std::size_t v = n; v < 2 * n; ++v)
    expect_unreached(geodesics.logarithmic_map(built.vertices[v]), geodesics.polar_coordinates(built.vertices[v]));
  expect_unreached(geodesics.logarithmic_map(Geodesics::Query{0}), geodesics.polar_coordinates(Geodesics::Query{0}));
  geodesics.compute(centroid);
  EXPECT_EQ(geodesics.logarithmic_map(Geodesics::Query{1}), (Place{{0., 0.}}));
  geodesics.set_maximum_distance(0.1);
  geodesics.compute(built.vertices[0]);
  expect_unreached(geodesics.logarithmic_map(built.vertices[1]), geodesics.polar_coordinates(built.vertices[1]));
}

TEST(Logarithmic_map, needs_directions)
{
  const Built built(icosahedron());
  Geodesics geodesics(built.mesh);
  const auto v = built.vertices[5];
  EXPECT_THROW(geodesics.logarithmic_map(v), Invalid_input);
  geodesics.compute(built.vertices[0]);
  EXPECT_THROW(geodesics.logarithmic_map(v), Invalid_input);
  EXPECT_THROW(geodesics.polar_coordinates(built.vertices[0]), Invalid_input);
  EXPECT_THROW(geodesics.direction_at_source(v), Invalid_input);
  geodesics.set_directions(true); // for what is computed from now on
  EXPECT_THROW(geodesics.logarithmic_map(v), Invalid_input);
  geodesics.compute();
  EXPECT_NO_THROW(geodesics.logarithmic_map(v));
  EXPECT_THROW(geodesics.logarithmic_map(Geodesics::Query{0}), Invalid_input);
}

/// products of lengths leave the range of numbers
TEST(Logarithmic_map, is_in_any_unit_of_length)
{
  const Mesh_data data = bumpy_sphere(4, 0.2, 5);
  const Built built(data);
  Geodesics geodesics(built.mesh);
  geodesics.set_directions(true);
  geodesics.set_maximum_distance(1.5);
  geodesics.compute(built.vertices[3]);
  for(const int exponent : {-600, 600})
  {
    const double unit = std::ldexp(1., exponent);
    const Built other(scaled(data, {{unit, unit, unit}}));
    Geodesics in_unit(other.mesh);
    in_unit.set_directions(true);
    in_unit.set_maximum_distance(1.5 * unit);
    in_unit.compute(other.vertices[3]);
    for(std::size_t v = 0; v < built.vertices.size(); ++v)
    {
      EXPECT_EQ(in_unit.distance(other.vertices[v]), unit * geodesics.distance(built.vertices[v]));
      const Place place = geodesics.logarithmic_map(built.vertices[v]),
                  found = in_unit.logarithmic_map(other.vertices[v]);
      EXPECT_EQ(std::isnan(place[0]), std::isnan(found[0]));
      if(!std::isnan(place[0]))
        expect_near({{found[0] / unit, found[1] / unit}}, place, 0.);
    }
  }
}

} // namespace

} // namespace test_logarithmic_map
