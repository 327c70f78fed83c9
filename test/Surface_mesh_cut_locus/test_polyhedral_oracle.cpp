// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The oracle that other tests ask for the shortest paths of polyhedra, where these are known.

#include "polyhedral_oracle.h"
#include "test_meshes.h"

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_polyhedral_oracle {

namespace {

using namespace polyhedral_oracle;
using test_meshes::Mesh_data;
using test_meshes::Point;

constexpr double exact = 1e-12;

Point point_at(const Mesh& mesh, const Indexed_location& l)
{
  Point p = {{0., 0., 0.}};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += l.coordinates[i] * mesh.points[mesh.triangles[l.face][i]][k];
  return p;
}

// A face that contains `p` and whose normal is `side`; the coordinates of `p` in it.
Indexed_location locate(const Mesh& mesh, const Point& p, const Point& side)
{
  using namespace test_meshes;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    const auto corner = [&](std::size_t i) { return mesh.points[mesh.triangles[f][i % 3]]; };
    const Point n = cross(corner(1) - corner(0), corner(2) - corner(0));
    if(dot(n, side) < 0.99 * norm(n) || std::fabs(dot(n, p - corner(0))) > 1e-12 * norm(n))
      continue;
    Indexed_location result;
    result.face = f;
    double least = 1.;
    for(std::size_t i = 0; i < 3; ++i)
    {
      double c = dot(cross(corner(i + 2) - corner(i + 1), p - corner(i + 1)), n) / dot(n, n);
      if(std::fabs(c) < 1e-14)
        c = 0.;
      result.coordinates[i] = c;
      least = (std::min)(least, c);
    }
    if(least >= 0.)
      return result;
  }
  ADD_FAILURE() << "no face at " << p[0] << " " << p[1] << " " << p[2];
  return Indexed_location();
}

void expect_arrivals(const Polyhedral_oracle& oracle, const Indexed_location& location, std::size_t number,
                     double distance)
{
  const std::vector<Arrival> arrivals = oracle.shortest_arrivals(location);
  EXPECT_EQ(arrivals.size(), number);
  for(const Arrival& a : arrivals)
    EXPECT_NEAR(a.distance, distance, exact);
}

const Point up = {{0., 0., 1.}}, down = {{0., 0., -1.}};

long euler_characteristic(const Mesh& mesh)
{
  long halves = 0; // of edges
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    halves += mesh.is_border_edge(h) ? 2 : 1;
  return long(mesh.number_of_vertices()) - halves / 2 + long(mesh.number_of_faces());
}

TEST(Polyhedra, are_what_their_names_say)
{
  using namespace test_meshes;
  const Mesh_data hull = random_convex_polyhedron(500, 3, {{1., 0.8, 0.3}});
  EXPECT_EQ(hull.triangles.size(), 996u);
  EXPECT_EQ(random_convex_polyhedron(500, 3, {{1., 0.8, 0.3}}).triangles, hull.triangles);
  EXPECT_EQ(euler_characteristic(indexed(hull)), 2);
  EXPECT_EQ(cube(2).triangles.size(), 48u);
  EXPECT_EQ(euler_characteristic(indexed(cuboid({{3., 2., 1.}}, 2))), 2);
  EXPECT_EQ(euler_characteristic(indexed(l_shape(1))), 2);
  EXPECT_EQ(euler_characteristic(indexed(plate_with_holes(7, 8, 1))), 2 - 2 * 56);
  EXPECT_EQ(plate_with_holes(7, 8, 1).triangles.size(), 1372u);
  EXPECT_EQ(euler_characteristic(indexed(square_with_holes(2, 2))), 1 - 4);
  EXPECT_EQ(euler_characteristic(indexed(saddle(4, 0.3))), 1);
  EXPECT_EQ(euler_characteristic(indexed(annulus(0.3, 1., 12, 2))), 0);
  EXPECT_EQ(euler_characteristic(indexed(doubly_covered(square(4)))), 2);
  EXPECT_THROW(doubly_covered(square(5)), std::invalid_argument);
  const Mesh_data split = split_in_plane(cube(1));
  EXPECT_EQ(split.triangles.size(), 48u);
  EXPECT_EQ(euler_characteristic(indexed(split)), 2);
}

// From the middle of the floor, four ways lead up the walls: the diagonals of the ceiling and the vertical edges are
// where two of them are equal.
TEST(Polyhedral_oracle, cube)
{
  for(int n : {1, 2, 3})
  {
    SCOPED_TRACE(n);
    const Mesh mesh = indexed(test_meshes::cube(n));
    const Polyhedral_oracle oracle(mesh, locate(mesh, {{0.5, 0.5, 0.}}, down));
    const auto on_ceiling = [&](double x, double y) { return locate(mesh, {{0.5 + x, 0.5 + y, 1.}}, up); };
    expect_arrivals(oracle, on_ceiling(0., 0.), 4, 2.);
    for(double x : {0.05, 0.23, 0.41})
    {
      for(double sx : {-1., 1.})
        for(double sy : {-1., 1.})
          expect_arrivals(oracle, on_ceiling(sx * x, sy * x), 2, std::hypot(2. - x, x));
      expect_arrivals(oracle, on_ceiling(x, 0.5 * x), 1, std::hypot(2. - x, 0.5 * x));
      expect_arrivals(oracle, on_ceiling(-0.3 * x, x), 1, std::hypot(2. - x, 0.3 * x));
      expect_arrivals(oracle, locate(mesh, {{0., 0., x}}, {{-1., 0., 0.}}), 2, std::hypot(0.5 + x, 0.5));
      expect_arrivals(oracle, locate(mesh, {{0., 0.01, x}}, {{-1., 0., 0.}}), 1, std::hypot(0.5 + x, 0.49));
    }
    expect_arrivals(oracle, on_ceiling(0.5, 0.5), 2, std::hypot(1.5, 0.5));
    expect_arrivals(oracle, locate(mesh, {{0., 0., 0.}}, down), 1, std::sqrt(0.5)); // a leaf
  }
}

TEST(Polyhedral_oracle, doubly_covered_square)
{
  for(std::size_t n : {4, 6, 10})
  {
    SCOPED_TRACE(n);
    const Mesh mesh = indexed(test_meshes::doubly_covered(test_meshes::square(n)));
    const Polyhedral_oracle oracle(mesh, locate(mesh, {{0.5, 0.5, 0.}}, up));
    const auto below = [&](double x, double y) { return locate(mesh, {{0.5 + x, 0.5 + y, 0.}}, down); };
    expect_arrivals(oracle, below(0., 0.), 4, 1.);
    for(double x : {0.03, 0.21, 0.47})
    {
      expect_arrivals(oracle, below(x, x), 2, std::hypot(1. - x, x));
      expect_arrivals(oracle, below(-x, x), 2, std::hypot(1. - x, x));
      expect_arrivals(oracle, below(x, 0.9 * x), 1, std::hypot(1. - x, 0.9 * x));
    }
  }
}

TEST(Polyhedral_oracle, paths_bend_at_a_saddle)
{
  for(int n : {1, 2, 3})
  {
    const Mesh mesh = indexed(test_meshes::l_shape(n));
    const Polyhedral_oracle oracle(mesh, locate(mesh, {{1.7, 0.9, 1.}}, up));
    const std::vector<Arrival> arrivals = oracle.shortest_arrivals(locate(mesh, {{0.9, 1.7, 1.}}, up));
    ASSERT_EQ(arrivals.size(), 1u);
    EXPECT_NEAR(arrivals[0].distance, 2. * std::sqrt(0.5), exact);
    ASSERT_NE(arrivals[0].root, null_index);
    EXPECT_EQ(mesh.points[arrivals[0].root], (Point{{1., 1., 1.}}));
    EXPECT_NEAR(arrivals[0].root_distance, std::sqrt(0.5), exact);
  }
}

TEST(Polyhedral_oracle, paths_bend_at_a_border)
{
  for(int n : {1, 2, 3})
  {
    SCOPED_TRACE(n);
    const Mesh mesh = indexed(test_meshes::square_with_holes(1, n));
    const Polyhedral_oracle oracle(mesh, locate(mesh, {{1.5, 0.25, 0.}}, up));
    const double length = 2. * std::hypot(0.5, 0.75) + 1.;
    const std::vector<Arrival> arrivals = oracle.shortest_arrivals(locate(mesh, {{1.5, 2.75, 0.}}, up));
    ASSERT_EQ(arrivals.size(), 2u);
    for(const Arrival& a : arrivals)
    {
      EXPECT_NEAR(a.distance, length, exact);
      ASSERT_NE(a.root, null_index);
      EXPECT_EQ(mesh.points[a.root][1], 2.);
    }
    expect_arrivals(oracle, locate(mesh, {{1.6, 2.75, 0.}}, up), 1, std::hypot(0.5, 0.75) + 1. + std::hypot(0.4, 0.75));
    expect_arrivals(oracle, locate(mesh, {{1.5, 2., 0.}}, up), 2, std::hypot(0.5, 0.75) + 1.5); // on the hole
  }
}

// Around a cylinder: the line opposite to the source.
TEST(Polyhedral_oracle, open_prism)
{
  const Mesh mesh = indexed(test_meshes::cylinder(2., 8, 3, 0., 0));
  const double side = 2. * std::sin(pi / 8.);
  const auto on_edge = [&](Index column, double z)
  {
    const double angle = 2. * pi * column / 8.;
    return locate(mesh, {{std::cos(angle), std::sin(angle), z}},
                  {{std::cos(angle + pi / 8.), std::sin(angle + pi / 8.), 0.}});
  };
  const Polyhedral_oracle oracle(mesh, on_edge(0, 0.3));
  for(double z : {0., 0.1, 0.9, 2.})
  {
    expect_arrivals(oracle, on_edge(4, z), 2, std::hypot(4. * side, z - 0.3));
    expect_arrivals(oracle, on_edge(3, z), 1, std::hypot(3. * side, z - 0.3));
  }
}

TEST(Polyhedral_oracle, surface_mesh)
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point_3> tm;
  const Mesh_data data = test_meshes::square_with_holes(1, 2);
  for(const Point& p : data.points)
    tm.add_vertex(Point_3(p[0], p[1], p[2]));
  for(const test_meshes::Triangle& t : data.triangles)
    tm.add_face(CGAL::SM_Vertex_index(t[0]), CGAL::SM_Vertex_index(t[1]), CGAL::SM_Vertex_index(t[2]));
  const Mesh mesh = indexed_mesh(tm), same = indexed(data);
  ASSERT_EQ(mesh.triangles.size(), same.triangles.size());
  const std::array<double, 3> c = {{0.2, 0.3, 0.5}};
  const auto location = [&](unsigned f) { return indexed_location(std::make_pair(CGAL::SM_Face_index(f), c)); };
  for(unsigned f = 1; f < mesh.number_of_faces(); ++f)
  {
    const auto h = tm.halfedge(CGAL::SM_Face_index(f));
    EXPECT_EQ(mesh.triangles[f][0], Index(tm.source(h)));
    const auto arrivals = shortest_arrivals(mesh, location(0), location(f));
    ASSERT_FALSE(arrivals.empty());
    EXPECT_GT(arrivals[0].distance, 0.);
  }
}

std::vector<std::pair<std::string, Mesh>> surfaces()
{
  using namespace test_meshes;
  return {{"convex", indexed(random_convex_polyhedron(150, 1))},
          {"flat convex", indexed(random_convex_polyhedron(100, 2, {{1., 0.8, 0.1}}))},
          {"cuboid", indexed(cuboid({{1., 0.7, 0.3}}, 3))},
          {"L", indexed(l_shape(2))},
          {"genus 3", indexed(plate_with_holes(3, 1, 1))},
          {"torus", indexed(torus(1., 0.4, 14, 9, 0.2, 3))},
          {"bumpy", indexed(bumpy_sphere(4, 0.3, 5))},
          {"holes", indexed(square_with_holes(2, 1))},
          {"saddle", indexed(saddle(7, 0.5, 0.2, 1))},
          {"annulus", indexed(annulus(0.3, 1., 14, 3))},
          {"split torus", indexed(split_in_plane(torus(1., 0.4, 9, 6, 0.2, 3)))}};
}

Indexed_location random_location(const Mesh& mesh, std::mt19937& engine, unsigned kind)
{
  Indexed_location result;
  result.face = Index(engine() % mesh.number_of_faces());
  double sum = 0.;
  for(double& c : result.coordinates)
    sum += c = 1.1 + test_meshes::random_unit(engine);
  const std::size_t i = engine() % 3;
  if(kind % 3 == 1) // on an edge
  {
    sum -= result.coordinates[i];
    result.coordinates[i] = 0.;
  }
  for(double& c : result.coordinates)
    c /= sum;
  if(kind % 3 == 2) // at a vertex
  {
    result.coordinates = {{0., 0., 0.}};
    result.coordinates[i] = 1.;
  }
  return result;
}

TEST(Polyhedral_oracle, distances_are_those_of_the_package)
{
  for(const auto& surface : surfaces())
    for(unsigned kind = 0; kind < 6; ++kind)
    {
      SCOPED_TRACE(surface.first + ", source " + std::to_string(kind));
      const Mesh& mesh = surface.second;
      std::mt19937 engine(kind);
      const Indexed_location source = random_location(mesh, engine, kind);
      const Polyhedral_oracle oracle(mesh, source);
      CGAL::Cut_loci::internal::Exact_geodesic_options options;
      for(unsigned i = 0; i < 30; ++i)
        options.queries.push_back(random_location(mesh, engine, i));
      CGAL::Cut_loci::internal::Exact_geodesic_propagation geodesics(mesh);
      geodesics.run({source}, options);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        EXPECT_NEAR(oracle.distance(v), geodesics.distance(v), 1e-11) << v;
      for(std::size_t i = 0; i < options.queries.size(); ++i)
      {
        const std::vector<Arrival> arrivals = oracle.shortest_arrivals(options.queries[i]);
        ASSERT_FALSE(arrivals.empty()) << i;
        EXPECT_NEAR(arrivals[0].distance, geodesics.query_distance(i), 1e-11) << i;
        if(i % 3 == 0 && kind % 3 == 0) // in general position
        {
          EXPECT_EQ(arrivals.size(), 1u) << i;
        }
      }
    }
}

// where the last straight piece of the path starts, as seen from the face
Point image(const Mesh& mesh, const Indexed_location& l, const Arrival& a)
{
  using namespace test_meshes;
  const auto& t = mesh.triangles[l.face];
  const Point x = normalized(mesh.points[t[1]] - mesh.points[t[0]]);
  const Point n = normalized(cross(x, mesh.points[t[2]] - mesh.points[t[0]])), y = cross(n, x);
  const double length = a.distance - a.root_distance;
  return point_at(mesh, l) + length * std::cos(a.direction) * x + length * std::sin(a.direction) * y;
}

// Between two points of a face with different paths there is one with both.
TEST(Polyhedral_oracle, two_paths_arrive_on_the_cut_locus)
{
  using namespace test_meshes;
  for(const auto& surface : surfaces())
  {
    SCOPED_TRACE(surface.first);
    const Mesh& mesh = surface.second;
    std::mt19937 engine(7);
    const Polyhedral_oracle oracle(mesh, random_location(mesh, engine, 0));
    int found = 0;
    for(int i = 0; i < 300 && found < 10; ++i)
    {
      Indexed_location p = random_location(mesh, engine, 0), q = random_location(mesh, engine, 0);
      q.face = p.face;
      const auto image_of = [&](const Indexed_location& l)
      { return image(mesh, l, oracle.shortest_arrivals(l).front()); };
      Point image_p = image_of(p), image_q = image_of(q);
      if(norm(image_p - image_q) < 0.05)
        continue;
      Indexed_location middle = p;
      for(int k = 0; k < 48; ++k)
      {
        for(std::size_t c = 0; c < 3; ++c)
          middle.coordinates[c] = 0.5 * (p.coordinates[c] + q.coordinates[c]);
        const Point m = image_of(middle);
        if(norm(m - image_p) < 1e-9)
          p = middle;
        else
        {
          q = middle;
          image_q = m;
        }
      }
      const Point m = point_at(mesh, middle);
      if(norm(cross(image_p - m, image_q - m)) < 1e-6)
        continue; // they come in one line, one straight on and one from a vertex where it bends
      ++found;
      const std::vector<Arrival> arrivals = oracle.shortest_arrivals(middle, 1e-9);
      EXPECT_GE(arrivals.size(), 2u);
    }
    EXPECT_TRUE(found >= 3 || surface.first == "saddle") << found; // which need not have any
  }
}

} // namespace

} // namespace test_polyhedral_oracle
