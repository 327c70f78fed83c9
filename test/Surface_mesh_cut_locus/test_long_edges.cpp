// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Where faces are as long as a machine part, the method of the Laplacian divides them.

#include "canceling_visitor.h"
#include "checked_curves.h"
#include "node_distances.h"
#include "result_numbers.h"
#include "surface_test.h"

#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/exact_geodesic_distances.h>
#include <CGAL/property_map.h>

namespace test_long_edges {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::Stage;
using CGAL::Cut_loci::internal::Divided_mesh;

// A square plate through which a round hole is drilled, of 24 sides in 12 rows: all else are faces as long as the plate, or that
// reach from its corners to the hole. The first vertices are on that.
Mesh_data drilled_plate()
{
  const std::size_t n = 24, rows = 12;
  const double outer = 10., step = 0.2;
  Mesh_data result;
  const auto at = [&](std::size_t j, std::size_t i) { return j * n + i % n; };
  const auto corner = [&](std::size_t j, std::size_t i) { return (rows + 1) * n + 4 * j + i % 4; };
  for(std::size_t j = 0; j <= rows; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2. * pi * double(i) / double(n);
      result.points.push_back({{std::cos(angle), std::sin(angle), double(j) * step}});
    }
  for(const double z : {0., double(rows) * step})
    for(const std::array<double, 2>& c : {std::array<double, 2>{{1., 1.}}, {{-1., 1.}}, {{-1., -1.}}, {{1., -1.}}})
      result.points.push_back({{outer * c[0], outer * c[1], z}});
  auto& t = result.triangles;
  for(std::size_t i = 0; i < n; ++i)
  {
    for(std::size_t j = 0; j < rows; ++j)
    {
      t.push_back({{at(j, i), at(j + 1, i), at(j, i + 1)}});
      t.push_back({{at(j, i + 1), at(j + 1, i), at(j + 1, i + 1)}});
    }
    t.push_back({{at(rows, i), corner(1, 4 * i / n), at(rows, i + 1)}});
    t.push_back({{at(0, i + 1), corner(0, 4 * i / n), at(0, i)}});
  }
  for(std::size_t k = 0; k < 4; ++k)
  {
    t.push_back({{at(rows, (k + 1) * n / 4), corner(1, k), corner(1, k + 1)}});
    t.push_back({{at(0, (k + 1) * n / 4), corner(0, k + 1), corner(0, k)}});
    t.push_back({{corner(0, k), corner(0, k + 1), corner(1, k + 1)}});
    t.push_back({{corner(0, k), corner(1, k + 1), corner(1, k)}});
  }
  return result;
}

TEST(Long_edges, are_halved)
{
  const Indexed_triangle_mesh mesh = indexed(drilled_plate());
  const double longest = 6. * Mesh_connectivity(mesh).mean_edge_length;
  const Divided_mesh divided(mesh, {}, longest);
  EXPECT_GT(divided.mesh().number_of_vertices(), mesh.number_of_vertices());
  EXPECT_LT(divided.mesh().number_of_vertices(), 2 * mesh.number_of_vertices());
  for(Index h = 0; h < divided.mesh().number_of_halfedges(); ++h)
    EXPECT_LE(CGAL::Cut_loci::internal::edge_length(divided.mesh(), h), longest);

  std::vector<Indexed_source> points;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
    for(const std::array<double, 3>& x :
        {std::array<double, 3>{{0.2, 0.3, 0.5}}, {{0., 0.3, 0.7}}, {{0., 1., 0.}}}) // inside, on an edge, at a vertex
      points.push_back({{f, x}, null_index});
  const std::vector<Indexed_source> there = divided.divided(points);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(norm(CGAL::Cut_loci::internal::position(mesh, points[i].location) -
                     CGAL::Cut_loci::internal::position(divided.mesh(), there[i].location)),
                0., 1e-12);

  const Divided_mesh few(mesh, {}, 1e-3 * longest);
  EXPECT_EQ(few.mesh().number_of_vertices(), 2 * mesh.number_of_vertices()) << "there are no more";
}

// Without that, nodes are off by up to two mean edges, and .15 in the mean.
TEST(Long_edges, have_nodes_where_they_should_be)
{
  const Built built(drilled_plate());
  for(const std::size_t v : {0, 30, 150, 310})
  {
    SCOPED_TRACE(v);
    Solver solver(built.mesh, by(Laplacian_method()));
    solver.set_source(built.vertices[v]);
    const Result through_faces = solver.cut_locus();
    EXPECT_LT(checked_curves::measured(built.mesh, through_faces).max, 0.1);
    const auto error = curve_measures::node_distance_errors(built.mesh, through_faces);
    EXPECT_LT(error.mean, 0.05);
    EXPECT_LT(error.max, 0.5);

    const Result edges = solver.cut_locus(params::cut_locus_curve(Curve::MESH_EDGES));
    for(const auto e : CGAL::make_range(boost::edges(edges.graph())))
      EXPECT_NE(edges.graph()[e].mesh_halfedge, Mesh::null_halfedge());
    EXPECT_LT(checked_curves::measured(built.mesh, edges).max, 1.);

    // distances that are given say nothing of what is between vertices, and the result is another one
    std::map<Mesh::Vertex_index, double> map;
    for(const Mesh::Vertex_index w : built.vertices)
      map[w] = through_faces.distance(w);
    solver.set_source(built.vertices[v], params::vertex_distance_map(boost::make_assoc_property_map(map)));
    const Result of_map = solver.cut_locus();
    checked_curves::measured(built.mesh, of_map);
    EXPECT_NE(num_vertices(of_map.graph()), num_vertices(through_faces.graph()));
  }
}

// Mesh edges are found on the mesh itself, as with distances that are given, whether the other curve was asked for before or
// not, in a copy, and after it has been left.
TEST(Long_edges, are_not_divided_for_curves_of_mesh_edges)
{
  const Built built(drilled_plate());
  const auto edges_of = [](const Solver& solver)
  { return result_numbers(solver.cut_locus(params::cut_locus_curve(Curve::MESH_EDGES))); };
  Canceling_visitor visitor(Stage::FILTER, 0);
  Solver solver(built.mesh, by(Laplacian_method()).visitor(std::ref(visitor)));
  solver.set_source(built.vertices[30]);
  const std::vector<double> through_faces = result_numbers(solver.cut_locus());
  visitor = Canceling_visitor(Stage::FILTER, 0);
  const std::vector<double> edges = edges_of(solver);
  const std::size_t last = visitor.number;
  EXPECT_GT(last, 5u);
  EXPECT_EQ(edges_of(solver), edges);
  EXPECT_LT(visitor.number, last + 5) << "once per source";
  Solver copy(solver);
  copy.set_source(built.vertices[30]);
  EXPECT_EQ(edges_of(copy), edges);
  EXPECT_EQ(result_numbers(solver.cut_locus()), through_faces);

  for(std::size_t at : {std::size_t(1), (last + 1) / 2, last})
  {
    SCOPED_TRACE(at);
    Solver left(built.mesh, by(Laplacian_method()).visitor(std::ref(visitor)));
    left.set_source(built.vertices[30]);
    visitor = Canceling_visitor(Stage::FILTER, at);
    EXPECT_THROW(edges_of(left), Canceled);
    visitor = Canceling_visitor(Stage::FILTER, 0);
    EXPECT_EQ(result_numbers(left.cut_locus()), through_faces);
    EXPECT_EQ(edges_of(left), edges);
  }

  std::map<Mesh::Vertex_index, double> map;
  const Result result = solver.cut_locus();
  for(const Mesh::Vertex_index w : built.vertices)
    map[w] = result.distance(w);
  solver.set_source(built.vertices[30], params::vertex_distance_map(boost::make_assoc_property_map(map)));
  EXPECT_EQ(edges_of(solver), edges);
  EXPECT_NE(result_numbers(solver.cut_locus()), through_faces);
}

TEST(Long_edges, are_divided_for_sources_of_all_kinds)
{
  const Built built(drilled_plate());
  Solver solver(built.mesh, by(Laplacian_method()));
  const std::size_t at_corner = built.faces.size() - 1;
  const std::vector<Location> points = {built.location<double>(at_corner, {{0.2, 0.3, 0.5}}),
                                        built.location<double>(at_corner - 4, {{0.2, 0.3, 0.5}}),
                                        built.location<double>(100, {{0.2, 0.3, 0.5}})};
  solver.set_source(points[0]);
  checked_curves::measured(built.mesh, solver.cut_locus());
  solver.set_sources(points);
  checked_curves::measured(built.mesh, solver.cut_locus());

  // an edge as long as the plate, and one of the hole
  const Mesh& mesh = built.mesh;
  const auto edge_of = [&](std::size_t v, std::size_t w)
  { return mesh.edge(mesh.halfedge(built.vertices[v], built.vertices[w])); };
  const std::vector<Edges> curves = {{edge_of(312, 313)}, {edge_of(150, 151), edge_of(151, 152)}};
  solver.set_sources(Vertices(), params::source_curves(curves));
  const Result result = solver.cut_locus();
  checked_curves::expect_topology(built, curves, result, "curves");
  EXPECT_LT(curve_measures::node_distance_errors(mesh, result, curves).mean, 0.05);
}

} // namespace

} // namespace test_long_edges
