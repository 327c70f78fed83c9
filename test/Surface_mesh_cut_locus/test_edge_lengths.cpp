// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Edge lengths alone: those of a mesh in space give its distances and its curve, and surfaces that are given by nothing
// else have the cut loci that are known in closed form. The points of these meshes are at the origin or not finite.

#include "surface_test.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/exact_geodesic_distances.h>

namespace test_edge_lengths {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using namespace surface_test;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Lengths = Mesh::Property_map<Edge, double>;

Lengths no_lengths(Mesh& mesh)
{
  return mesh.add_property_map<Edge, double>("e:length", 0.).first;
}

Lengths lengths_in_space(Mesh& mesh)
{
  Lengths result = no_lengths(mesh);
  for(const Edge e : mesh.edges())
    result[e] = std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return result;
}

void forget_points(Mesh& mesh)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = Point(nan, nan, nan);
}

std::vector<double> distances(const Mesh& mesh, Vertex source)
{
  std::vector<double> result(mesh.number_of_vertices());
  CGAL::exact_geodesic_distances(mesh, source, CGAL::make_property_map(result));
  return result;
}

std::vector<double> distances(const Mesh& mesh, Vertex source, const Lengths& lengths)
{
  std::vector<double> result(mesh.number_of_vertices());
  CGAL::exact_geodesic_distances(mesh, source, CGAL::make_property_map(result), params::edge_length_map(lengths));
  return result;
}

// A surface that is laid out in the plane, in pieces that are not all in the same place: where its corners lie in each
// face, from which the lengths are.
struct Flat_surface
{
  Mesh mesh;
  Lengths lengths;
  std::vector<std::array<std::array<double, 2>, 3>> corners; // of each face, in the order of its vertices

  std::array<double, 2> position(const Location& at) const
  {
    std::array<double, 2> result = {{0., 0.}};
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 2; ++k)
        result[k] += at.second[i] * corners[at.first][i][k];
    return result;
  }

  // the corner at which `halfedge(f, mesh)` starts comes first
  void add_face(const std::array<Vertex, 3>& v, const std::array<std::array<double, 2>, 3>& at)
  {
    const Mesh::Face_index f = mesh.add_face(v[0], v[1], v[2]);
    ASSERT_NE(f, Mesh::null_face());
    corners.emplace_back();
    auto h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      corners.back()[i] = at[static_cast<std::size_t>(std::find(v.begin(), v.end(), mesh.source(h)) - v.begin())];
  }

  void measure()
  {
    lengths = no_lengths(mesh);
    for(const Mesh::Face_index f : mesh.faces())
    {
      auto h = mesh.halfedge(f);
      for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      {
        const auto &p = corners[f][i], &q = corners[f][(i + 1) % 3];
        lengths[mesh.edge(h)] = std::hypot(q[0] - p[0], q[1] - p[1]);
      }
    }
    forget_points(mesh);
  }
};

// The plane modulo the lattice spanned by `a` and `b`, with n^2 vertices.
Flat_surface flat_torus(const std::array<double, 2>& a, const std::array<double, 2>& b, std::size_t n)
{
  Flat_surface torus;
  std::vector<Vertex> v;
  for(std::size_t i = 0; i < n * n; ++i)
    v.push_back(torus.mesh.add_vertex(Point(0., 0., 0.)));
  const auto vertex = [&](std::size_t i, std::size_t j) { return v[(i % n) * n + j % n]; };
  const auto at = [&](std::size_t i, std::size_t j)
  {
    const double s = double(i) / double(n), t = double(j) / double(n);
    return std::array<double, 2>{{s * a[0] + t * b[0], s * a[1] + t * b[1]}};
  };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      torus.add_face({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)}},
                     {{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      torus.add_face({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)}},
                     {{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  torus.measure();
  return torus;
}

// Distances from a point of the plane to all images of another one, in order.
std::vector<double> distances_to_images(const std::array<double, 2>& p, const std::array<double, 2>& source,
                                        const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  std::vector<double> result;
  for(int i = -5; i <= 5; ++i)
    for(int j = -5; j <= 5; ++j)
      result.push_back(std::hypot(p[0] - source[0] - i * a[0] - j * b[0], p[1] - source[1] - i * a[1] - j * b[1]));
  std::sort(result.begin(), result.end());
  return result;
}

// What every point of the cut locus of a flat torus has: two shortest paths, that is, two nearest images of the source.
// Together with the topology, two cycles and a disk around, that makes it the boundary of the polygon of Dirichlet. With
// sources in a lattice spanned by `a` and `b`, these are polygons around all of them, with more cycles.
template <typename Result>
void expect_dirichlet_polygon(const Flat_surface& torus, const Result& result, const std::array<double, 2>& source,
                              const std::array<double, 2>& a, const std::array<double, 2>& b, std::size_t branch_points,
                              double inradius, double circumradius, double length, std::size_t cycles = 2)
{
  const auto& graph = result.graph();
  EXPECT_EQ(num_edges(graph) + 1, num_vertices(graph) + cycles); // one component
  std::size_t number_of_branch_points = 0;
  double nearest = (std::numeric_limits<double>::infinity)(), sum = 0.;
  for(const auto v : CGAL::make_range(vertices(graph)))
  {
    const std::vector<double> images = distances_to_images(torus.position(graph[v].location), source, a, b);
    EXPECT_NEAR(images[0], images[1], 1e-5); // lengths may be changed by some 1e-6
    EXPECT_NEAR(images[0], graph[v].distance, 1e-5);
    EXPECT_GE(degree(v, graph), 2u);
    number_of_branch_points += degree(v, graph) > 2;
    if(degree(v, graph) > 2)
    {
      EXPECT_NEAR(graph[v].distance, circumradius, 1e-5);
    }
    nearest = (std::min)(nearest, graph[v].distance);
  }
  EXPECT_EQ(number_of_branch_points, branch_points);
  EXPECT_NEAR(nearest, inradius, 0.02); // an edge may reach across the middle of a side
  EXPECT_GE(nearest, inradius - 1e-5);
  for(const auto e : CGAL::make_range(edges(graph))) // of the images of its ends, the nearest
    sum += distances_to_images(torus.position(graph[boost::source(e, graph)].location),
                               torus.position(graph[target(e, graph)].location), a, b)[0];
  EXPECT_NEAR(sum, length, 1e-3);
}

TEST(Edge_lengths, of_a_mesh_in_space_give_its_distances_and_its_curve)
{
  for(const Mesh_data& data : {random_convex_polyhedron(60, 1), irregular_bumpy_sphere(6, 0.3, 2),
                               torus(1., 0.4, 16, 10, 0.15, 5), cylinder(1., 14, 5, 0.1, 4)})
  {
    Built built(data);
    const Lengths lengths = lengths_in_space(built.mesh);
    for(const double gap : {0., 0.3})
    {
      const auto np = by(Polyhedral_method().minimum_branch_gap(gap));
      const auto expected = compute_cut_locus(built.mesh, built.vertices[3], np);
      const auto found = compute_cut_locus(built.mesh, built.vertices[3], np.edge_length_map(lengths));
      const auto &p = expected.graph(), &q = found.graph();
      ASSERT_EQ(num_vertices(p), num_vertices(q));
      ASSERT_EQ(num_edges(p), num_edges(q));
      ASSERT_GT(num_edges(p), 0u);
      // in any order, as ties are broken by the last digit
      for(const auto v : CGAL::make_range(vertices(p)))
        EXPECT_TRUE(std::any_of(vertices(q).first, vertices(q).second,
                                [&](std::size_t w)
                                {
          return CGAL::squared_distance(p[v].point, q[w].point) < 1e-14 &&
                 std::fabs(p[v].distance - q[w].distance) < 1e-7 && degree(v, p) == degree(w, q);
        }));
    }
    const std::vector<double> expected = distances(built.mesh, built.vertices[3]);
    forget_points(built.mesh);
    const std::vector<double> found = distances(built.mesh, built.vertices[3], lengths);
    for(std::size_t v = 0; v < found.size(); ++v)
      EXPECT_NEAR(found[v], expected[v], 1e-11);
  }
}

TEST(Edge_lengths, of_a_smooth_mesh_give_its_default_curve_up_to_the_ends_of_branches)
{
  Built built(torus(1., 0.4, 60, 32, 0.2, 7));
  const Lengths lengths = lengths_in_space(built.mesh);
  const auto expected = compute_cut_locus(built.mesh, built.vertices[0], mesh_edges);
  const auto found = compute_cut_locus(built.mesh, built.vertices[0], mesh_edges.edge_length_map(lengths));
  std::size_t in_both = 0;
  for(const auto v : CGAL::make_range(vertices(found.graph())))
    for(const auto w : CGAL::make_range(vertices(expected.graph())))
      in_both += found.graph()[v].mesh_vertex == expected.graph()[w].mesh_vertex;
  EXPECT_EQ(found.genus(), 1u);
  // widths that are found from angles may end a branch some edges earlier or later
  EXPECT_GE(double(in_both), 0.9 * double((std::max)(num_vertices(found.graph()), num_vertices(expected.graph()))));
}

TEST(Edge_lengths, the_unit_of_length_may_be_of_any_size)
{
  Built built(torus(1., 0.4, 16, 10, 0.15, 5));
  Lengths lengths = lengths_in_space(built.mesh);
  const auto expected = compute_cut_locus(built.mesh, built.vertices[3], params::edge_length_map(lengths));
  for(const double unit : {std::ldexp(1., -500), std::ldexp(1., 500)})
  {
    Lengths scaled = built.mesh.add_property_map<Edge, double>("e:scaled", 0.).first;
    for(const Edge e : built.mesh.edges())
      scaled[e] = unit * lengths[e];
    const auto found = compute_cut_locus(built.mesh, built.vertices[3], params::edge_length_map(scaled));
    ASSERT_EQ(num_vertices(found.graph()), num_vertices(expected.graph()));
    for(std::size_t v = 0; v < num_vertices(found.graph()); ++v)
      EXPECT_EQ(found.graph()[v].distance, unit * expected.graph()[v].distance);
  }
}

// of a square lattice a square, of a hexagonal one a hexagon
TEST(Edge_lengths, the_cut_locus_of_a_flat_torus_is_the_boundary_of_a_polygon_of_Dirichlet)
{
  const std::array<double, 2> a = {{1., 0.}};
  for(const bool is_square : {true, false})
  {
    const std::array<double, 2> b = {{is_square ? 0. : -0.5, is_square ? 1. : std::sqrt(0.75)}};
    const Flat_surface torus = flat_torus(a, b, 8);
    const Location source(Mesh::Face_index(37), {{0.23, 0.31, 0.46}});
    const auto found = compute_cut_locus(torus.mesh, source, by(Polyhedral_method()).edge_length_map(torus.lengths));
    expect_dirichlet_polygon(torus, found, torus.position(source), a, b, is_square ? 1 : 2, 0.5,
                             is_square ? std::sqrt(0.5) : 1. / std::sqrt(3.), is_square ? 2. : std::sqrt(3.));
  }
}

// The sources are a lattice of triangles, so that all cells are regular hexagons. They lie in faces, where the mesh does not
// help. There is nothing inside the cells, and all of the cut locus has the sources beside it that are known.
TEST(Edge_lengths, the_cells_of_a_hexagonal_lattice_on_a_flat_torus_are_hexagons)
{
  constexpr std::size_t n = 3, m = 4; // sources each way, and edges from one to the next
  const std::array<double, 2> a = {{1., 0.}}, b = {{-0.5, std::sqrt(0.75)}}; // from one source to the next
  const std::array<double, 2> long_a = {{n * a[0], n * a[1]}}, long_b = {{n * b[0], n * b[1]}};
  const Flat_surface torus = flat_torus(long_a, long_b, n * m);
  std::vector<Location> sources;
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      sources.emplace_back(Mesh::Face_index(static_cast<Mesh::size_type>(2 * (i * m * n * m + j * m))),
                           std::array<double, 3>{{0.23, 0.31, 0.46}});
  for(const Method method : {Method(Default_method()), Method(Polyhedral_method())})
  {
    const auto found =
      compute_cut_locus(torus.mesh, sources, through_faces.cut_locus_method(method).edge_length_map(torus.lengths));
    ASSERT_EQ(found.number_of_sources(), n * n);
    expect_dirichlet_polygon(torus, found, torus.position(sources[0]), a, b, 2 * n * n, 0.5, 1. / std::sqrt(3.),
                             n * n * std::sqrt(3.), n * n + 1);
    const auto& graph = found.graph();
    for(const auto e : CGAL::make_range(edges(graph)))
    {
      EXPECT_NE(graph[e].sources[0], graph[e].sources[1]);
      for(const auto v : {boost::source(e, graph), target(e, graph)})
        for(const std::size_t s : graph[e].sources)
          EXPECT_NEAR(
            distances_to_images(torus.position(graph[v].location), torus.position(sources[s]), long_a, long_b)[0],
            graph[v].distance, 1e-5);
    }
  }
}

TEST(Edge_lengths, distances_on_a_flat_torus_are_those_to_the_nearest_image)
{
  const std::array<double, 2> a = {{1., 0.2}}, b = {{-0.3, 0.7}};
  const Flat_surface torus = flat_torus(a, b, 7);
  const std::vector<double> found = distances(torus.mesh, Vertex(0), torus.lengths);
  for(std::size_t i = 0; i < 7; ++i)
    for(std::size_t j = 0; j < 7; ++j)
    {
      const double s = double(i) / 7., t = double(j) / 7.;
      const auto images = distances_to_images({{s * a[0] + t * b[0], s * a[1] + t * b[1]}}, {{0., 0.}}, a, b);
      EXPECT_NEAR(found[i * 7 + j], images[0], 1e-12);
    }
}

TEST(Edge_lengths, the_logarithmic_map_of_a_flat_torus_is_the_nearest_image)
{
  const std::array<double, 2> a = {{1., 0.2}}, b = {{-0.3, 0.7}};
  const std::size_t n = 7; // odd: no vertex has two nearest images
  const Flat_surface torus = flat_torus(a, b, n);
  Geodesics geodesics(torus.mesh, params::edge_length_map(torus.lengths));
  geodesics.set_directions(true);
  geodesics.compute(Vertex(0));
  const auto image = [&](std::size_t v)
  {
    std::array<double, 2> nearest = {{10., 10.}};
    for(int i = -2; i <= 2; ++i)
      for(int j = -2; j <= 2; ++j)
      {
        const double s = double(v / n) / double(n) + i, t = double(v % n) / double(n) + j;
        const std::array<double, 2> p = {{s * a[0] + t * b[0], s * a[1] + t * b[1]}};
        if(std::hypot(p[0], p[1]) < std::hypot(nearest[0], nearest[1]))
          nearest = p;
      }
    return nearest;
  };
  const std::array<double, 2> axis = image(torus.mesh.target(geodesics.source_halfedge()));
  const double length = std::hypot(axis[0], axis[1]);
  for(std::size_t v = 0; v < n * n; ++v)
  {
    const std::array<double, 2> p = image(v), found = geodesics.logarithmic_map(Vertex(Mesh::size_type(v)));
    EXPECT_NEAR(found[0], (axis[0] * p[0] + axis[1] * p[1]) / length, 1e-12);
    EXPECT_NEAR(found[1], (axis[0] * p[1] - axis[1] * p[0]) / length, 1e-12);
  }
}

// Each side of the unit square is folded at its midpoint and its halves glued: by Alexandrov's theorem the surface of a
// convex polyhedron. It is a square of the side 1 / sqrt(2) covered doubly: its corners are the midpoints, and the
// corners of the unit square are one point in the middle of a side of it, opposite to the center of the unit square.
Flat_surface folded_square(std::size_t n)
{
  Flat_surface result;
  std::vector<std::vector<Vertex>> v(n + 1, std::vector<Vertex>(n + 1));
  const Vertex corner = result.mesh.add_vertex(Point(0., 0., 0.));
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
    {
      const bool on_vertical = i == 0 || i == n, on_horizontal = j == 0 || j == n;
      if(on_vertical && on_horizontal)
        v[i][j] = corner;
      else if(on_vertical && 2 * j > n)
        v[i][j] = v[i][n - j];
      else if(on_horizontal && 2 * i > n)
        v[i][j] = v[n - i][j];
      else
        v[i][j] = result.mesh.add_vertex(Point(0., 0., 0.));
    }
  const auto at = [&](std::size_t i, std::size_t j) {
    return std::array<double, 2>{{double(i) / double(n), double(j) / double(n)}};
  };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      result.add_face({{v[i][j], v[i + 1][j], v[i + 1][j + 1]}}, {{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      result.add_face({{v[i][j], v[i + 1][j + 1], v[i][j + 1]}}, {{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  result.measure();
  return result;
}

TEST(Edge_lengths, the_cut_locus_of_a_gluing_of_Alexandrov_is_that_of_its_polyhedron)
{
  constexpr std::size_t n = 8;
  const Flat_surface square = folded_square(n);
  const Vertex corner(0);
  EXPECT_EQ(square.mesh.number_of_vertices() + square.mesh.number_of_faces(), square.mesh.number_of_edges() + 2);

  // from the corners, which are one flat point: to the center, and to the midpoints
  const std::vector<double> distance = distances(square.mesh, corner, square.lengths);
  EXPECT_NEAR(*std::max_element(distance.begin(), distance.end()), std::sqrt(0.5), 1e-12);

  const auto found = compute_cut_locus(square.mesh, corner, by(Polyhedral_method()).edge_length_map(square.lengths));
  const auto& graph = found.graph();
  EXPECT_EQ(number_of_cycles(found), 0u);
  for(const auto v : CGAL::make_range(vertices(graph)))
  {
    // the middle lines of the unit square, all of whose points are as far from two of its corners
    const std::array<double, 2> p = square.position(graph[v].location);
    EXPECT_NEAR((std::min)(std::fabs(p[0] - 0.5), std::fabs(p[1] - 0.5)), 0., 1e-5);
    EXPECT_NEAR(graph[v].distance, std::hypot((std::min)(p[0], 1. - p[0]), (std::min)(p[1], 1. - p[1])), 1e-5);
    if(degree(v, graph) == 1)
    {
      EXPECT_NEAR(graph[v].distance, 0.5, 1e-5);
    }
  }
  EXPECT_EQ(number_of_leaves(found), 4u); // the four midpoints, where the curvature is
}

TEST(Edge_lengths, the_cut_locus_of_a_doubly_covered_polygon_is_on_the_other_side)
{
  Built built(doubly_covered(square(6)));
  const std::size_t front = square(6).triangles.size();
  const Lengths lengths = lengths_in_space(built.mesh);
  const auto found = compute_cut_locus(built.mesh, built.location<double>(20, {{0.3, 0.45, 0.25}}),
                                       by(Polyhedral_method()).edge_length_map(lengths));
  const auto& graph = found.graph();
  for(const auto v : CGAL::make_range(vertices(graph)))
    EXPECT_TRUE(degree(v, graph) == 1 || graph[v].location.first.idx() >= front);
  EXPECT_EQ(number_of_leaves(found), 4u);
  EXPECT_EQ(number_of_cycles(found), 0u);
}

// Two triangles glued along their sides: the paths to the other side are straight across one of the three sides, so that
// the three segments of the cut locus meet where the images of the source are equally far, and end at the vertices.
TEST(Edge_lengths, the_cut_locus_of_a_doubly_covered_triangle_from_its_incenter_are_the_bisectors)
{
  Mesh mesh;
  std::array<Vertex, 3> v;
  for(Vertex& w : v)
    w = mesh.add_vertex(Point(0., 0., 0.));
  const Mesh::Face_index front = mesh.add_face(v[0], v[1], v[2]);
  ASSERT_NE(mesh.add_face(v[0], v[2], v[1]), Mesh::null_face());
  Lengths lengths = no_lengths(mesh);
  std::array<double, 3> coordinates; // of the incenter: the opposite sides
  auto h = mesh.halfedge(front);
  const std::array<double, 3> sides = {{3., 4., 5.}};
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
  {
    lengths[mesh.edge(h)] = sides[i];
    coordinates[(i + 2) % 3] = sides[i];
  }
  const auto found =
    compute_cut_locus(mesh, Location(front, coordinates), by(Polyhedral_method()).edge_length_map(lengths));
  const auto& graph = found.graph();
  ASSERT_EQ(num_edges(graph), 3u);
  std::vector<double> distance;
  for(const auto w : CGAL::make_range(vertices(graph)))
    distance.push_back(graph[w].distance);
  std::sort(distance.begin(), distance.end());
  // the inradius of the triangle 3, 4, 5 is 1: to the vertices, and twice the inradius to the center of the other side
  EXPECT_NEAR(distance[0], std::sqrt(2.), 1e-5);
  EXPECT_NEAR(distance[1], 2., 1e-5);
  EXPECT_NEAR(distance[2], std::sqrt(5.), 1e-5);
  EXPECT_NEAR(distance[3], std::sqrt(10.), 1e-5);
}

TEST(Edge_lengths, several_sources_in_faces_divide_a_surface_of_lengths)
{
  const std::array<double, 2> a = {{1., 0.}}, b = {{0., 1.}};
  const Flat_surface torus = flat_torus(a, b, 8);
  const std::vector<Location> sources = {Location(Mesh::Face_index(3), {{0.2, 0.3, 0.5}}),
                                         Location(Mesh::Face_index(70), {{0.5, 0.5, 0.}})};
  const auto found = compute_cut_locus(torus.mesh, sources, by(Polyhedral_method()).edge_length_map(torus.lengths));
  const auto& graph = found.graph();
  EXPECT_EQ(num_edges(graph) + 1, num_vertices(graph) + 3); // 2 g - 1 + k cycles
  for(const auto v : CGAL::make_range(vertices(graph)))
  {
    std::vector<double> images;
    for(const Location& source : sources)
      for(const double d : distances_to_images(torus.position(graph[v].location), torus.position(source), a, b))
        images.push_back(d);
    std::sort(images.begin(), images.end());
    EXPECT_NEAR(images[0], images[1], 1e-5);
  }
}

TEST(Edge_lengths, that_no_triangle_has_are_refused_by_the_name_of_the_face)
{
  Built built(torus(1., 0.4, 8, 6));
  Lengths lengths = lengths_in_space(built.mesh);
  const Edge edge = built.mesh.edge(built.mesh.halfedge(built.faces[5]));
  for(const double bad :
      {100., -1., std::numeric_limits<double>::quiet_NaN(), (std::numeric_limits<double>::infinity)()})
  {
    lengths[edge] = bad;
    const std::vector<std::string> messages = {
      message_of([&] { compute_cut_locus(built.mesh, built.vertices[0], params::edge_length_map(lengths)); }),
      message_of([&] { distances(built.mesh, built.vertices[0], lengths); })};
    for(const std::string& message : messages)
    {
      expect_has(message, bad == 100. ? "triangle inequality" : "edge_length_map holds a length");
      expect_has(message, bad == 100. ? "face #" : "the edge between vertex #");
    }
  }
}

TEST(Edge_lengths, are_refused_by_name_where_points_are_needed)
{
  Built built(torus(1., 0.4, 8, 6));
  const Lengths lengths = lengths_in_space(built.mesh);
  const auto by_name = [&](const std::string& message)
  { EXPECT_NE(message.find("edge_length_map is for"), std::string::npos) << message; };
  const std::vector<double> known = distances(built.mesh, built.vertices[0]);
  by_name(message_of(
    [&]
    {
    compute_cut_locus(built.mesh, built.vertices[0],
                      params::edge_length_map(lengths).cut_locus_method(Laplacian_method()));
  }));
  by_name(message_of(
    [&]
    {
    compute_cut_locus(built.mesh, built.vertices[0],
                      params::edge_length_map(lengths).vertex_distance_map(CGAL::make_property_map(known)));
  }));
  by_name(message_of(
    [&]
    {
    compute_cut_locus(built.mesh, built.vertices[0],
                      params::edge_length_map(lengths).geodesic_solver(CGAL::Graph_geodesic_solver()));
  }));
}

} // namespace

} // namespace test_edge_lengths
