// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The measures themselves, on curves whose detour is known.

#include "checked_curves.h"
#include "completeness.h"
#include "cut_locus_by_hand.h"
#include "node_distances.h"
#include "surface_test.h"

#include <CGAL/exact_geodesic_distances.h>

namespace test_detour {

namespace {

using namespace surface_test;
using checked_curves::measured;
using curve_measures::measure;
using curve_measures::Measures;
using curve_measures::node_distance_errors;
using Vertex = Mesh::Vertex_index;

// unit squares, n in a row; vertex (n + 1) j + i at (i, j)
Mesh_data square(std::size_t n)
{
  return grid(n + 1, n + 1);
}

Cut_locus::Vertex at_vertex(const Built& built, std::size_t v)
{
  const Mesh& mesh = built.mesh;
  Cut_locus::Vertex result;
  const auto h = halfedge(built.vertices[v], mesh); // its target is the vertex
  const auto face = mesh.is_border(h) ? mesh.face(mesh.opposite(h)) : mesh.face(h);
  result.location.first = face;
  auto k = mesh.halfedge(face);
  for(int i = 0; i < 3; ++i, k = mesh.next(k))
    result.location.second[i] = mesh.source(k) == built.vertices[v] ? 1. : 0.;
  result.mesh_vertex = built.vertices[v];
  result.point = mesh.point(built.vertices[v]);
  return result;
}

// A curve along the points (x, j) of the square, j = first, ..., last. Of a source that is a curve, a vertex is given.
Cut_locus wall(const Built& built, std::size_t n, double x, std::size_t first, std::size_t last,
               const std::vector<std::size_t>& sources)
{
  const Mesh& mesh = built.mesh;
  Cut_locus::Graph graph;
  const std::size_t column = static_cast<std::size_t>(x);
  for(std::size_t j = first; j <= last; ++j)
  {
    Cut_locus::Vertex node = at_vertex(built, (n + 1) * j + column);
    if(x > double(column)) // on the horizontal edge, a side of the face above or, at the top, below
    {
      const std::size_t a = (n + 1) * j + column, f = j < n ? 2 * (n * j + column) : 2 * (n * (j - 1) + column) + 1;
      const double t = x - double(column);
      node.location = built.location<double>(f, j < n ? std::array<double, 3>{{1. - t, t, 0.}}
                                                      : std::array<double, 3>{{0., t, 1. - t}});
      node.mesh_vertex = Mesh::null_vertex();
      node.point = CGAL::ORIGIN + ((1. - t) * (mesh.point(built.vertices[a]) - CGAL::ORIGIN) +
                                   t * (mesh.point(built.vertices[a + 1]) - CGAL::ORIGIN));
    }
    // On the diagonal of the square below, before the next horizontal edge.
    if(x > double(column) && j > first)
    {
      const std::size_t f = 2 * (n * (j - 1) + column);
      const double t = x - double(column);
      Cut_locus::Vertex between = node;
      between.location = built.location<double>(f, {{1. - t, 0., t}});
      between.point = CGAL::Simple_cartesian<double>::Point_3(x, double(j - 1) + t, 0.);
      add_vertex(between, graph);
      add_edge(num_vertices(graph) - 2, num_vertices(graph) - 1, {}, graph);
    }
    add_vertex(node, graph);
    if(j > first)
    {
      Cut_locus::Edge edge;
      if(x == double(column))
        edge.mesh_halfedge = mesh.halfedge(graph[num_vertices(graph) - 2].mesh_vertex, node.mesh_vertex);
      add_edge(num_vertices(graph) - 2, num_vertices(graph) - 1, edge, graph);
    }
  }
  std::vector<Cut_locus::Vertex> at_sources;
  for(const std::size_t v : sources)
    at_sources.push_back(at_vertex(built, v));
  return cut_locus_by_hand<Cut_locus>(graph, at_sources);
}

double mean_length(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

TEST(Detour, Around_the_end_of_a_wall)
{
  // The wall stands on the lower side up to (x, 5), the source is the lower left corner: the way to what it hides leads
  // over its end.
  const std::size_t n = 10;
  const Built built(square(n));
  for(double x : {5., 5.5, 5. + 1e-4, 5. + 1e-7, 6. - 1e-9})
  {
    SCOPED_TRACE(x);
    const Measures m = measured(built.mesh, wall(built, n, x, 0, 5, {0}));
    double longest = 0.;
    for(std::size_t i = 0; i <= n; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        if(double(i) > x + 1e-5 && double(j) * x < 5. * double(i)) // nearer vertices are on the wall, after rounding
          longest = (std::max)(longest, std::hypot(x, 5.) + std::hypot(double(i) - x, 5. - double(j)) -
                                          std::hypot(double(i), double(j)));
    EXPECT_NEAR(m.max * mean_length(built.mesh), longest, 1e-3);
    EXPECT_GT(m.mean, 0.);
    EXPECT_LE(m.p99, m.max);
  }
}

TEST(Detour, Of_two_sources_is_that_to_the_nearest)
{
  // Two corners of the square, and walls from side to side: between them there is none, and beside the middle it is
  // longest on the lower side, from the last vertices before the wall to the other source.
  const std::size_t n = 10;
  const Built built(square(n));
  const std::vector<std::size_t> corners = {0, n};
  for(const double x : {5., 5.5, 7., 7.5, 8.})
  {
    SCOPED_TRACE(x);
    const double last = std::ceil(x) - 1.; // before the wall
    EXPECT_NEAR(measured(built.mesh, wall(built, n, x, 0, n, corners)).max * mean_length(built.mesh),
                2. * last - 10. > 0. ? 2. * last - 10. : 0., 1e-3);
  }
  EXPECT_EQ(measure(built.mesh, wall(built, n, 5., 0, 8, corners)).topology_fault,
            "0 independent cycles on a surface of genus 0");
  EXPECT_EQ(measure(built.mesh, wall(built, n, 5., 0, n, {0, 1})).topology_fault,
            "a part of the complement has no source");
}

TEST(Detour, Of_curves_is_that_to_the_nearest_of_their_points)
{
  // Two sides of the square, or a side and a corner, and walls from side to side.
  const std::size_t n = 10;
  const Built built(square(n));
  std::vector<Edges> sides(2);
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t side = 0; side < 2; ++side)
      sides[side].push_back(built.mesh.edge(
        built.mesh.halfedge(built.vertices[(n + 1) * j + side * n], built.vertices[(n + 1) * (j + 1) + side * n])));
  for(const double x : {5., 5.5, 7., 7.5, 8.})
  {
    SCOPED_TRACE(x);
    const double last = std::ceil(x) - 1.;
    EXPECT_NEAR(measured(built.mesh, wall(built, n, x, 0, n, {0, n}), sides).max * mean_length(built.mesh),
                2. * last - 10. > 0. ? 2. * last - 10. : 0., 1e-3);
  }
  EXPECT_EQ(measure(built.mesh, wall(built, n, 5., 0, 8, {0, n}), sides).topology_fault,
            "the curve has the Euler characteristic 1, and the surface without the sources 0");
  EXPECT_EQ(measure(built.mesh, wall(built, n, 5., 2, 8, {0, n}), sides).topology_fault,
            "the curve has the Euler characteristic 1, and the surface without the sources 0");
  // to the corner from beside the wall, and to the side after it was cut off
  double longest = 0.;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
    {
      const double to_corner = std::hypot(double(i), double(j)), to_side = double(n - i);
      const double after = i < 3 ? to_corner : i > 3 ? to_side : (std::min)(to_corner, to_side);
      longest = (std::max)(longest, after - (std::min)(to_corner, to_side));
    }
  EXPECT_NEAR(measured(built.mesh, wall(built, n, 3., 0, n, {0, n}), {sides[1]}).max * mean_length(built.mesh), longest,
              1e-3);
  EXPECT_GT(longest, 1.);
}

TEST(Detour, Vanishes_on_the_cut_locus_of_a_set)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 1));
  Solver solver(built.mesh, by(Polyhedral_method()));
  solver.set_sources(Vertices{built.vertices[3], built.vertices[77], built.vertices[200]});
  const Measures points = measured(built.mesh, solver.cut_locus());
  EXPECT_LT(points.max, 1e-2);
  EXPECT_NE(measure(built.mesh, solver.cut_locus(params::kept_part(Kept_part::VORONOI))).topology_fault, "");
  EXPECT_GT(measured(built.mesh, solver.cut_locus(mesh_edges)).max, points.max);

  std::vector<Edges> meridian(1); // not all of it
  for(std::size_t j = 0; j < 8; ++j)
    meridian[0].push_back(built.mesh.edge(built.mesh.halfedge(built.vertices[120 + j], built.vertices[121 + j])));
  solver.set_sources(Vertices{built.vertices[3]}, params::source_curves(meridian));
  EXPECT_LT(measured(built.mesh, solver.cut_locus(), meridian).max, 1e-2);
  EXPECT_NE(measure(built.mesh, solver.cut_locus(params::kept_part(Kept_part::MEDIAL)), meridian).topology_fault, "");
}

TEST(Detour, Wrong_topology_is_named)
{
  const std::size_t n = 10;
  const Built built(square(n));
  // apart from the border
  expect_has(measure(built.mesh, wall(built, n, 5., 2, 5, {0})).topology_fault, "2 components");
  // from side to side: what it cuts off would have no distance
  for(double x : {5., 5.5})
  {
    const Measures m = measure(built.mesh, wall(built, n, x, 0, n, {0}));
    expect_has(m.topology_fault, "1 independent cycles");
    EXPECT_EQ(m.measuring_failed, "");
    EXPECT_TRUE(std::isfinite(m.max));
  }
}

// The nodes of the wall say that their distance is 0: what is off is the distance itself.
TEST(Node_distances, Are_compared_with_those_at_their_place)
{
  const std::size_t n = 10;
  const Built built(square(n));
  for(double x : {5., 5.25})
  {
    SCOPED_TRACE(x);
    const Cut_locus lying = wall(built, n, x, 0, 5, {0});
    const curve_measures::Node_distance_errors errors = node_distance_errors(built.mesh, lying);
    EXPECT_NEAR(errors.max * mean_length(built.mesh), std::hypot(x, 5.), 1e-9);
    double sum = 0.;
    for(const auto v : CGAL::make_range(vertices(lying.graph())))
      sum += std::hypot(lying.graph()[v].point.x(), lying.graph()[v].point.y());
    EXPECT_NEAR(errors.mean * mean_length(built.mesh), sum / double(num_vertices(lying.graph())), 1e-9);
  }
}

// A frame of a table: four bars whose edges are not flush.
Mesh_data frame_of_bars()
{
  Mesh_data m;
  m.points = {{{1.245028, 0.322173, 0.553797}}, {{0.712742, 0.290003, 0.553797}}, {{0.712742, 0.322173, 0.553797}},
              {{0.712742, 0.322173, 0.592122}}, {{1.245028, 0.290003, 0.553797}}, {{0.712742, 0.290003, 0.592122}},
              {{0.674417, 0.290003, 0.592122}}, {{0.712742, 0.290003, 1.952052}}, {{0.674417, 0.322173, 1.913727}},
              {{1.245028, 0.290003, 1.913727}}, {{0.712742, 0.290003, 1.913727}}, {{0.674417, 0.290003, 1.913727}},
              {{1.245028, 0.322173, 1.952052}}, {{0.712742, 0.322173, 1.952052}}, {{0.712742, 0.322173, 1.913727}},
              {{0.674417, 0.322173, 0.592122}}, {{1.245028, 0.290003, 1.952052}}, {{1.283353, 0.290003, 0.592122}},
              {{1.283353, 0.322173, 1.913727}}, {{1.283353, 0.322173, 0.592123}}, {{1.283353, 0.290003, 1.913727}},
              {{1.245028, 0.290003, 0.592122}}, {{1.245028, 0.322173, 1.913727}}, {{1.245028, 0.322173, 0.592123}}};
  m.triangles = {{{0, 1, 2}},    {{2, 23, 0}},   {{4, 5, 1}},    {{3, 6, 15}},   {{5, 2, 1}},    {{13, 10, 7}},
                 {{11, 14, 8}},  {{10, 16, 7}},  {{5, 9, 10}},   {{6, 10, 11}},  {{22, 13, 12}}, {{3, 8, 14}},
                 {{23, 14, 22}}, {{7, 12, 13}},  {{8, 6, 11}},   {{17, 18, 20}}, {{18, 23, 22}}, {{9, 17, 20}},
                 {{22, 20, 18}}, {{9, 12, 16}},  {{0, 21, 4}},   {{17, 23, 19}}, {{1, 0, 4}},    {{23, 2, 3}},
                 {{5, 4, 21}},   {{6, 3, 5}},    {{2, 5, 3}},    {{10, 13, 14}}, {{14, 11, 10}}, {{16, 10, 9}},
                 {{9, 5, 21}},   {{10, 6, 5}},   {{13, 22, 14}}, {{8, 3, 15}},   {{14, 23, 3}},  {{12, 7, 16}},
                 {{6, 8, 15}},   {{18, 17, 19}}, {{23, 18, 19}}, {{17, 9, 21}},  {{20, 22, 9}},  {{12, 9, 22}},
                 {{21, 0, 23}},  {{23, 17, 21}}};
  return m;
}

// Paths that pass several corners on a line come from the image of any of them.
TEST(Node_distances, Are_exact_in_faces_with_branches_in_two_corners)
{
  const Built built(frame_of_bars());
  Solver solver(built.mesh);
  for(const Vertex v : built.vertices)
  {
    SCOPED_TRACE(v);
    solver.set_source(v);
    EXPECT_LT(node_distance_errors(built.mesh, solver.cut_locus()).max, 1e-5); // some surfaces are perturbed
  }
}

// Where all changes of a face are on one of its edges, the other two are between the last one and the first.
TEST(Node_distances, Are_exact_in_faces_whose_changes_are_all_on_one_edge)
{
  for(int length : {5, 6})
  {
    std::set<Voxel> ring;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j <= length; ++j)
        if(i % 2 == 0 || j == 0 || j == length)
          ring.insert({{i, j, 0}});
    for(const std::array<double, 3>& scale : {std::array<double, 3>{{1., 1., 1.}}, {{1., 1.3, 0.7}}})
    {
      const Built built(scaled(with_diagonals_at_random(voxel_surface(ring, 1), 4), scale));
      Solver solver(built.mesh);
      for(const Vertex v : built.vertices)
      {
        SCOPED_TRACE(v);
        solver.set_source(v);
        EXPECT_LT(node_distance_errors(built.mesh, solver.cut_locus()).max, 1e-5);
      }
    }
  }
}

// At a saddle to which several paths lead, from a vertex at which they bend too, what lies behind has several for all sources
// nearby. Where they pass the saddle on both sides, and have the same image there, the curve goes on between them.
TEST(Detour, Vanishes_where_paths_with_the_same_image_pass_a_saddle_on_both_sides)
{
  const std::set<Voxel> shapes[] = {
    {{{-2, -1, 0}}, {{-1, -1, 0}}, {{-1, 0, 0}}, {{0, 0, 0}}, {{0, 0, 1}}, {{0, 1, 0}}},
    // from one of its sources a branch goes to a vertex, which is the root of the tree, and comes back
    {{{-1, 0, 0}},
     {{-1, 0, 1}},
     {{-1, 0, 2}},
     {{-1, 2, -1}},
     {{0, 0, -2}},
     {{0, 0, -1}},
     {{0, 0, 0}},
     {{0, 0, 1}},
     {{0, 1, -1}},
     {{0, 2, -1}},
     {{1, 0, -1}},
     {{1, 0, 0}},
     {{1, 1, -1}}}};
  for(const std::set<Voxel>& cubes : shapes)
  {
    const Built built(voxel_surface(cubes, 1));
    Solver solver(built.mesh);
    for(const Vertex v : built.vertices)
    {
      SCOPED_TRACE(v);
      solver.set_source(v);
      EXPECT_LT(measured(built.mesh, solver.cut_locus()).max, 1e-5); // some surfaces are perturbed
    }
  }
}

TEST(Detour, Vanishes_on_the_cut_locus_and_only_there)
{
  const Built built(torus(1., 0.4, 60, 24, 0.2, 3));
  const Mesh& mesh = built.mesh;
  const Vertex source = built.vertices[0], other = built.vertices[15 * 24 + 12];
  Solver cut_loci(mesh);
  cut_loci.set_source(source);
  const auto right = cut_loci.cut_locus(mesh_edges);
  const auto in_faces = cut_loci.cut_locus(through_faces);
  std::vector<double> exact;
  for(const auto* curve : {&right, &in_faces})
  {
    const Measures m = measured(mesh, *curve, exact);
    EXPECT_LT(m.max, 1.);
    EXPECT_LT(m.mean, 0.01);
    EXPECT_LT(node_distance_errors(mesh, *curve).max, 1e-9);
  }
  // the curve of another source, which its distances find
  Mesh copy = mesh;
  auto map = copy.add_property_map<Vertex, double>("v:distance", 0.).first;
  CGAL::exact_geodesic_distances(copy, other, map);
  Solver misled(copy);
  misled.set_source(source, params::vertex_distance_map(map));
  const Measures m = measure(copy, misled.cut_locus(mesh_edges));
  EXPECT_EQ(m.measuring_failed, "");
  EXPECT_GT(m.max, 5.);
  EXPECT_GT(node_distance_errors(copy, misled.cut_locus(mesh_edges)).max, 5.);

  EXPECT_DOUBLE_EQ(curve_measures::completeness(right, right, 0.1), 1.);
  EXPECT_LT(curve_measures::completeness(right, misled.cut_locus(mesh_edges), 0.1), 0.7);
}

TEST(Detour, Source_in_a_face)
{
  const Built built(torus(1., 0.4, 40, 16, 0.2, 3));
  Solver cut_loci(built.mesh);
  cut_loci.set_source(built.location<double>(100, {{0.2, 0.3, 0.5}}));
  for(const auto curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
  {
    EXPECT_LT(measured(built.mesh, cut_loci.cut_locus(params::cut_locus_curve(curve))).max, 1.5);
  }
}

// On faces that are longer than the corridors between branches are wide, centroids are in the wrong cells.
TEST(Detour, Is_short_where_corridors_are_narrower_than_faces_are_long)
{
  const std::vector<Mesh_data> surfaces = {
    scaled(square_with_holes(3, 12), {{1., 7., 1.}}), scaled(perforated_plate(4, 3, 3, 2), {{1., 8., 1.}}),
    with_diagonals_at_random(scaled(plate_with_holes(4, 3, 2), {{1., 6., 1.}}), 5),
    torus_of_rings({24, 24, 5, 24, 24, 5})};
  for(std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const Built built(surfaces[i]);
    Solver solver(built.mesh);
    for(std::size_t k = 0; k < 4; ++k)
    {
      SCOPED_TRACE(std::to_string(i) + " " + std::to_string(k));
      solver.set_source(built.vertices[k * built.vertices.size() / 4]);
      EXPECT_LT(measured(built.mesh, solver.cut_locus(mesh_edges)).max, 1.);
    }
    solver.set_sources(Vertices{built.vertices[1], built.vertices[built.vertices.size() / 2]});
    EXPECT_LT(measured(built.mesh, solver.cut_locus(mesh_edges)).max, 1.);
  }
}

// What the topology demands there leaves the faces that have been drawn, and has to be looked for in others.
TEST(Detour, Is_none_on_rough_plates_with_many_holes)
{
  const std::pair<Mesh_data, std::size_t> cases[] = {{rough(perforated_plate(4, 4, 5, 1), 0.2, 1), 953},
                                                     {rough(perforated_plate(4, 4, 8, 3), 0.2, 3), 4896},
                                                     {rough(perforated_plate(6, 6, 6, 7), 0.1, 7), 11041}};
  for(const auto& [plate, source] : cases)
  {
    SCOPED_TRACE(source);
    const Built built(plate);
    EXPECT_LT(measured(built.mesh, compute_cut_locus(built.mesh, built.vertices[source])).max, 1e-6);
  }
}

// ---- the paper's method: nothing that it joins lies across shortest paths

Measures worst_of_thresholds(const Mesh_data& data, std::size_t source, Filter_policy policy,
                             Curve curve = Curve::MESH_EDGES)
{
  const Built built(data);
  Solver cut_loci(built.mesh, by(Laplacian_method()));
  cut_loci.set_source(built.vertices[source]);
  std::vector<double> exact;
  Measures worst;
  for(double angle : {0., 0.3, 0.7, 1.5})
  {
    SCOPED_TRACE(angle);
    const auto method = by(Laplacian_method().gradient_angle_threshold(angle).filter_policy(policy));
    const Measures m = measured(built.mesh, cut_loci.cut_locus(method.cut_locus_curve(curve)), exact);
    worst.mean = (std::max)(worst.mean, m.mean);
    worst.max = (std::max)(worst.max, m.max);
  }
  return worst;
}

class Laplacian_detour : public ::testing::TestWithParam<Filter_policy>
{
};

INSTANTIATE_TEST_SUITE_P(Policies, Laplacian_detour, ::testing::Values(Filter_policy::PRUNING, Filter_policy::GROWING));

TEST_P(Laplacian_detour, Bumpy_and_noisy_surfaces)
{
  for(const Mesh_data& data :
      {bumpy_sphere(24, 1.2, 1), bumpy_sphere(24, 1.2, 2), rough(bumpy_sphere(24, 0.8, 3), 0.1, 4),
       irregular_bumpy_sphere(30, 0.8, 5), perforated_plate(3, 2, 4, 6), torus(1., 0.4, 60, 24, 0.3, 7)})
    for(std::size_t source : {std::size_t(0), data.points.size() / 3, data.points.size() / 2})
    {
      SCOPED_TRACE(std::to_string(data.points.size()) + " vertices, source " + std::to_string(source));
      const Measures m = worst_of_thresholds(data, source, GetParam());
      EXPECT_LT(m.mean, 0.1);
      EXPECT_LT(m.max, 3.);
    }
}

// From a source on the border, in a corner, and inside: behind a hole, paths around both of its sides meet.
TEST_P(Laplacian_detour, Square_with_holes)
{
  const std::size_t n = 40;
  const auto is_in_hole = [](const Point& p)
  {
    const auto is_near = [&](double x, double y, double r) { return std::hypot(p[0] - x, p[1] - y) < r; };
    return is_near(20.3, 20.2, 6.) || is_near(31., 9., 3.) || is_near(9., 30., 4.);
  };
  for(std::size_t source : {std::size_t(0), 20 * (n + 1), 5 * (n + 1) + 12})
  {
    SCOPED_TRACE(source);
    const Mesh_data data = without_vertices(square(n), is_in_hole);
    const std::size_t v = nearest_vertex(data, square(n).points[source]);
    const Measures m = worst_of_thresholds(data, v, GetParam());
    EXPECT_LT(m.mean, 0.05);
    EXPECT_LT(m.max, 2.);
    EXPECT_LT(worst_of_thresholds(data, v, GetParam(), Curve::THROUGH_FACES).max, 2.);
  }
}

// On slim faces, the distances at the ends of their long edges do not tell where paths cross these: the paths must be
// followed.
TEST(Laplacian_detour_of_slim_faces, Wavy_surface)
{
  for(std::size_t ny : {60, 150})
  {
    const std::size_t nx = 6;
    Mesh_data data;
    for(std::size_t j = 0; j <= ny; ++j)
      for(std::size_t i = 0; i <= nx; ++i)
      {
        const double x = double(i) / double(nx), y = double(j) / double(ny);
        data.points.push_back({{x, y, 0.15 * std::sin(9. * x) * std::sin(11. * y + 1.)}});
      }
    for(std::size_t j = 0; j < ny; ++j)
      for(std::size_t i = 0; i < nx; ++i)
      {
        const std::size_t a = (nx + 1) * j + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
        add_square(data, {{a, b, c, d}}, (i + j) % 2 == 1);
      }
    const Built built(data);
    Solver cut_loci(built.mesh, by(Laplacian_method()));
    double mean = 0., max = 0.;
    for(std::size_t i : {1, 3, 5, 7})
    {
      cut_loci.set_source(built.vertices[i * data.points.size() / 8]);
      const Measures m = measured(built.mesh, cut_loci.cut_locus(mesh_edges));
      mean += 0.25 * m.mean;
      max = (std::max)(max, m.max);
    }
    EXPECT_LT(mean, 0.004); // by distances alone .005 and .011
    EXPECT_LT(max, 0.5);    // .82 and .70
  }
}

// In a fan, a path may arrive at a vertex of the curve along its edges, for all that is known of it: through a face two
// corners of which are on the curve. The smooth curve must not pass there. Else some detours become longer by 1.9 edges;
// so little as one is what the edges of the mesh lose.
TEST(Laplacian_detour_of_slim_faces, Smoothing_beside_fans)
{
  const Mesh mesh = to_surface_mesh(torus_of_rings({3, 7, 50}));
  Solver cut_loci(mesh, by(Laplacian_method()));
  for(unsigned v = 1; v < mesh.number_of_vertices(); v += 3)
  {
    SCOPED_TRACE(v);
    cut_loci.set_source(Vertex(v));
    const auto longest = [&](Curve curve)
    {
      const auto method = by(Laplacian_method().gradient_angle_threshold(0.3));
      return measure(mesh, cut_loci.cut_locus(method.cut_locus_curve(curve))).max;
    };
    EXPECT_LT(longest(Curve::THROUGH_FACES), longest(Curve::MESH_EDGES) + 1.);
  }
}

// An annulus and an open cylinder have the half line opposite to the source.
TEST(Laplacian_with_border, Closed_forms)
{
  const std::size_t n = 48, m = 12;
  const auto make = [&](const auto& point)
  {
    Mesh_data data;
    for(std::size_t j = 0; j <= m; ++j)
      for(std::size_t i = 0; i < n; ++i)
        data.points.push_back(point(2. * pi * (double(i) + 0.5 * double(j % 2)) / n, double(j) / m));
    for(std::size_t j = 0; j < m; ++j)
      for(std::size_t i = 0; i < n; ++i)
      {
        const std::size_t k = (i + 1) % n, a = j * n + i, b = j * n + k, c = a + n, d = b + n;
        add_square(data, {{a, b, d, c}}, j % 2 == 1);
      }
    return data;
  };
  const Mesh_data annulus = make(
    [](double u, double t) {
    return Point{{(1. + 2. * t) * std::cos(u), (1. + 2. * t) * std::sin(u), 0.}};
  });
  const Mesh_data cylinder = make([](double u, double t) { return Point{{std::cos(u), std::sin(u), 1.5 * t}}; });
  for(const Mesh_data& data : {annulus, cylinder})
    for(std::size_t row : {std::size_t(0), m / 2, m}) // on either border, and between: at the angle 0
    {
      SCOPED_TRACE(row);
      const Built built(data);
      Solver cut_loci(built.mesh, by(Laplacian_method()));
      cut_loci.set_source(built.vertices[row * n]);
      const Cut_locus result = cut_loci.cut_locus(mesh_edges);
      EXPECT_LT(measured(built.mesh, result).max, 1.);
      for(auto v : CGAL::make_range(vertices(result.graph())))
      {
        const auto p = result.graph()[v].point;
        const double off = pi - std::abs(std::atan2(p.y(), p.x()));
        EXPECT_LE(off * std::hypot(p.x(), p.y()), 2. * mean_length(built.mesh)) << p;
      }
    }
}

} // namespace

} // namespace test_detour
