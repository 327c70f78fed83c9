// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cases that all mesh types must pass. A test program defines `Mesh_types`, a list of `Built_mesh` and its like,
// and includes this file.

#ifndef CGAL_CUT_LOCI_CUT_LOCUS_CASES_H
#define CGAL_CUT_LOCI_CUT_LOCUS_CASES_H

#include "built_mesh.h"

#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_cut_locus.h>

#include <gtest/gtest.h>

#include <limits>
#include <variant>

using namespace test_meshes;
using CGAL::Cut_loci::Curve;
using CGAL::Cut_loci::Default_method;
using CGAL::Cut_loci::Filter_policy;
using CGAL::Cut_loci::Laplacian_method;
using CGAL::Cut_loci::Method;
using CGAL::Cut_loci::Polyhedral_method;

constexpr Method both_methods[] = {Laplacian_method(), Default_method()};

using Reference_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

template <typename Built>
class Cut_locus_test : public ::testing::Test
{
public:
  using Mesh = typename Built::Mesh;
  using Solver = CGAL::Surface_mesh_cut_locus<Mesh>;
  using Result = typename Solver::Result;
  using FT = typename Solver::FT;
  using Location = typename Solver::Face_location;

  // the source's neighborhood, for the checks
  struct Place
  {
    std::size_t face;
    std::vector<std::size_t> corners;
  };

  static Place at_vertex(const Mesh_data& data, std::size_t v)
  {
    std::size_t f = 0;
    while(std::find(data.triangles[f].begin(), data.triangles[f].end(), v) == data.triangles[f].end())
      ++f;
    return {f, {v}};
  }

  static void expect_valid(const Built& built, const Result& result, const Place& place, Method method,
                           const std::string& what = "")
  {
    EXPECT_EQ(fault_of(built, result, place.face, place.corners, method), "")
      << name_of(method) << ", " << what << ", " << built.data.triangles.size() << " faces, source in face "
      << place.face;
  }

  // at many thresholds of each kind
  static void expect_valid_at_all_thresholds(const Built& built, const Solver& solver, const Place& place)
  {
    namespace params = CGAL::parameters;
    if(std::holds_alternative<Default_method>(solver.method()))
    {
      for(double width : {0.5, 0.2, 0.1, 0.05, 0.01, 0.})
        for(std::size_t edges : {0, 3, 10})
          for(double length : {0., 0.05, 0.3})
          {
            const auto np = params::cut_locus_method(
              Default_method().minimum_branch_width(width).minimum_branch_edges(edges).minimum_branch_length(length));
            const Result result = solver.cut_locus(np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
            expect_valid(built, result, place, Default_method(),
                         "width " + std::to_string(width) + ", " + std::to_string(edges) + " edges, length " +
                           std::to_string(length));
            if(result.number_of_border_loops() > 0)
              continue;
            const Result curve = solver.cut_locus(np.cut_locus_curve(Curve::THROUGH_FACES));
            EXPECT_EQ(num_edges(curve.graph()) + 1 - num_vertices(curve.graph()), 2 * curve.genus())
              << "cycles of the curve";
          }
      return;
    }
    for(Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
    {
      for(double angle : {0., 0.05, 0.2, 0.5, 1., 2., 3., pi})
        for(std::size_t edges : {0, 3, 10})
          expect_valid(
            built,
            solver.cut_locus(mesh_edges.cut_locus_method(
              Laplacian_method().gradient_angle_threshold(angle).filter_policy(policy).minimum_branch_edges(edges))),
            place, Laplacian_method(), "angle " + std::to_string(angle) + ", " + std::to_string(edges) + " edges");
      for(double laplacian : {-1e9, -0.1, 0., 0.1, 0.5, 2., 1e9})
        expect_valid(built,
                     solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method()
                                                                    .laplacian_threshold(laplacian)
                                                                    .gradient_angle_threshold(0.)
                                                                    .filter_policy(policy)
                                                                    .minimum_branch_length(0.05))),
                     place, Laplacian_method(), "Laplacian " + std::to_string(laplacian));
    }
  }
};

TYPED_TEST_SUITE(Cut_locus_test, Mesh_types);

TYPED_TEST(Cut_locus_test, is_a_graph_with_two_cycles_per_handle_and_a_disk_as_complement_at_every_threshold)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const std::vector<std::pair<Mesh_data, long>> cases = {{icosahedron(), 0},
                                                         {jittered_sphere(6, 0.2, 1), 0},
                                                         {ellipsoid(1., 0.8, 0.6, 7, 0.2, 2), 0},
                                                         {capsule(2., 16, 14), 0},
                                                         {box(3, 2, 1, 3), 0},
                                                         {bumpy_sphere(8, 0.5, 3), 0},
                                                         {torus(1., 0.4, 24, 12, 0.2, 4), 1},
                                                         {torus(1., 0.4, 16, 8), 1},
                                                         {perforated_plate(2, 1, 2, 5), 2},
                                                         {perforated_plate(3, 1, 2, 6), 3},
                                                         {perforated_plate(4, 3, 1, 7), 12}};
  unsigned seed = 0;
  for(const auto& c : cases)
  {
    const TypeParam built(c.first);
    EXPECT_EQ(topology_checker::Surface(c.first.triangles, 0).genus(), c.second);
    ++seed;
    for(Method method : both_methods)
    {
      typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
      std::mt19937 engine(seed);
      for(int i = 0; i < 2; ++i)
      {
        const std::size_t v = engine() % c.first.points.size();
        solver.set_source(built.vertices[v]);
        Fixture::expect_valid_at_all_thresholds(built, solver, Fixture::at_vertex(c.first, v));
      }
    }
  }
}

TYPED_TEST(Cut_locus_test, keeps_the_root_alone_or_the_homology_where_the_threshold_removes_all_else)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data ball = jittered_sphere(5, 0.2, 1);
  const TypeParam sphere(ball);
  for(Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
  {
    const auto cut_locus = CGAL::compute_cut_locus(
      sphere.mesh, sphere.vertices[3],
      mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(pi).filter_policy(policy)));
    EXPECT_EQ(num_vertices(cut_locus.graph()), 1u);
    EXPECT_EQ(num_edges(cut_locus.graph()), 0u);
    EXPECT_EQ(cut_locus.graph()[cut_locus.root()].mesh_vertex, cut_locus.farthest_vertex());
    Fixture::expect_valid(sphere, cut_locus, Fixture::at_vertex(ball, 3), Laplacian_method());
  }
  const auto point = CGAL::compute_cut_locus(sphere.mesh, sphere.vertices[3],
                                             mesh_edges.cut_locus_method(Default_method().minimum_branch_width(1.)));
  EXPECT_EQ(num_vertices(point.graph()), 1u);
  EXPECT_EQ(num_edges(point.graph()), 0u);
  Fixture::expect_valid(sphere, point, Fixture::at_vertex(ball, 3), Default_method());

  const Mesh_data ring = torus(1., 0.4, 20, 10, 0.2, 2);
  const TypeParam built(ring);
  const auto expect_cycles_alone = [](const auto& cut_locus)
  {
    EXPECT_EQ(num_edges(cut_locus.graph()), num_vertices(cut_locus.graph()) + 1);
    std::size_t leaves = 0;
    for(const auto v : CGAL::make_range(vertices(cut_locus.graph())))
      leaves += out_degree(v, cut_locus.graph()) == 1 && v != cut_locus.root() ? 1 : 0;
    EXPECT_EQ(leaves, 0u);
  };
  expect_cycles_alone(CGAL::compute_cut_locus(
    built.mesh, built.vertices[0], mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(pi))));
  expect_cycles_alone(CGAL::compute_cut_locus(built.mesh, built.vertices[0],
                                              mesh_edges.cut_locus_method(Default_method().minimum_branch_width(1.))));
}

TYPED_TEST(Cut_locus_test, can_have_its_source_inside_a_face_or_on_an_edge)
{
  using Fixture = Cut_locus_test<TypeParam>;
  for(const Mesh_data& data : {jittered_sphere(6, 0.2, 1), torus(1., 0.4, 20, 10, 0.2, 2), perforated_plate(2, 1, 2, 5),
                               punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}}, 0.35)})
  {
    const TypeParam built(data);
    for(Method method : both_methods)
    {
      typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
      for(std::size_t f : {std::size_t(5), data.triangles.size() / 2})
      {
        const Triangle& t = data.triangles[f];
        solver.set_source(built.template location<typename Fixture::FT>(f, {{0.2, 0.5, 0.3}}));
        Fixture::expect_valid_at_all_thresholds(built, solver, {f, {t[0], t[1], t[2]}});
        solver.set_source(built.template location<typename Fixture::FT>(f, {{0., 0.4, 0.6}}));
        Fixture::expect_valid_at_all_thresholds(built, solver, {f, {t[1], t[2]}});
      }
    }
  }
}

TYPED_TEST(Cut_locus_test, reports_the_source_as_it_was_given)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = jittered_sphere(4, 0.2, 1);
  const TypeParam built(data);
  typename Fixture::Solver solver(built.mesh);
  const std::size_t f = 11;
  const auto location = built.template location<typename Fixture::FT>(f, {{0.2, 0.5, 0.3}});
  solver.set_source(location);
  const auto source = solver.cut_locus(mesh_edges).source();
  EXPECT_EQ(source.location.first, location.first);
  Point expected = {{0., 0., 0.}};
  for(int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(CGAL::to_double(source.location.second[i]), CGAL::to_double(location.second[i]), 1e-12);
    expected = expected + (i == 0 ? 0.2 : i == 1 ? 0.5 : 0.3) * built.data.points[data.triangles[f][i]];
  }
  EXPECT_TRUE(source.mesh_vertex == TypeParam::Traits::null_vertex());
  for(int i = 0; i < 3; ++i)
    EXPECT_NEAR(CGAL::to_double(source.point[i]), expected[i], 1e-14);
  EXPECT_EQ(source.distance, 0.);
  solver.set_source(built.vertices[7]);
  EXPECT_TRUE(solver.cut_locus(mesh_edges).source().mesh_vertex == built.vertices[7]);
  EXPECT_EQ(solver.cut_locus(mesh_edges).source().distance, 0.);
}

TYPED_TEST(Cut_locus_test, a_source_at_the_corner_of_a_face_is_that_vertex)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = ellipsoid(1., 0.8, 0.6, 5, 0.2, 1);
  const TypeParam built(data);
  const std::size_t f = 20;
  for(int corner = 0; corner < 3; ++corner)
    for(double noise : {0., 3e-17, -5.6e-17})
    {
      std::array<double, 3> coordinates = {{noise, noise, noise}};
      coordinates[corner] = 1.;
      for(Method method : both_methods)
      {
        const auto np = CGAL::parameters::cut_locus_method(method);
        const auto expected = CGAL::compute_cut_locus(built.mesh, built.vertices[data.triangles[f][corner]],
                                                      np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
        const auto found =
          CGAL::compute_cut_locus(built.mesh, built.template location<typename Fixture::FT>(f, coordinates),
                                  np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
        EXPECT_EQ(cut_of(built, found).edges, cut_of(built, expected).edges);
        EXPECT_EQ(cut_of(built, found).root, cut_of(built, expected).root);
        EXPECT_EQ(found.distance(built.vertices[data.triangles[f][corner]]), 0.);
        EXPECT_TRUE(found.source().mesh_vertex == expected.source().mesh_vertex);
      }
    }
}

TYPED_TEST(Cut_locus_test, runs_through_the_faces_unless_edges_of_the_mesh_are_asked_for)
{
  const TypeParam built(torus(1., 0.4, 20, 10, 0.2, 2));
  const auto null = TypeParam::Traits::null_vertex();
  for(Method method : {Method(Laplacian_method()), Method(Default_method()), Method(Polyhedral_method())})
    for(std::size_t k : {1, 3})
    {
      typename Cut_locus_test<TypeParam>::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
      std::vector<typename TypeParam::vertex_descriptor> sources;
      for(std::size_t i = 0; i < k; ++i)
        sources.push_back(built.vertices[3 + 60 * i]);
      solver.set_sources(sources);
      const auto in_faces = [&](const auto& np)
      {
        const auto cut_locus = solver.cut_locus(np);
        std::size_t result = 0;
        for(const auto v : CGAL::make_range(vertices(cut_locus.graph())))
          result += cut_locus.graph()[v].mesh_vertex == null;
        return result;
      };
      EXPECT_GT(in_faces(CGAL::parameters::default_values()), 20u) << name_of(method) << ", " << k;
      EXPECT_EQ(in_faces(mesh_edges), 0u) << name_of(method) << ", " << k;
    }
}

TYPED_TEST(Cut_locus_test, marks_the_edges_of_the_mesh_that_it_follows_and_no_others)
{
  const Mesh_data data = torus(1., 0.4, 20, 10, 0.2, 2);
  const TypeParam built(data);
  for(Method method : both_methods)
  {
    typename Cut_locus_test<TypeParam>::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
    solver.set_source(built.vertices[0]);
    const topology_checker::Edges expected = cut_of(built, solver.cut_locus(mesh_edges)).edges;
    EXPECT_GT(expected.size(), 10u);
    auto is_constrained = get(CGAL::dynamic_edge_property_t<bool>(), built.mesh);
    for(const auto e : CGAL::make_range(edges(built.mesh)))
      put(is_constrained, e, false);
    solver.cut_locus(mesh_edges.edge_is_constrained_map(is_constrained));
    topology_checker::Edges marked;
    for(const auto e : CGAL::make_range(edges(built.mesh)))
      if(get(is_constrained, e))
        marked.insert(
          topology_checker::make_edge(built.index(source(e, built.mesh)), built.index(target(e, built.mesh))));
    EXPECT_EQ(marked, expected) << name_of(method);
    try // a curve through the faces has none
    {
      solver.cut_locus(CGAL::parameters::edge_is_constrained_map(is_constrained));
      ADD_FAILURE() << "the map would be of another curve than the result";
    }
    catch(const CGAL::Cut_loci::Invalid_input& error)
    {
      EXPECT_NE(std::string(error.what()).find("cut_locus_curve(Cut_loci::Curve::MESH_EDGES)"), std::string::npos)
        << error.what();
    }
  }
}

TYPED_TEST(Cut_locus_test, vertices_and_edges_of_the_graph_know_where_they_are_on_the_mesh)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = torus(1., 0.4, 20, 10, 0.2, 2);
  const TypeParam built(data);
  for(Method method : both_methods)
  {
    typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
    solver.set_source(built.vertices[3]);
    const auto cut_locus = solver.cut_locus(mesh_edges);
    const auto& graph = cut_locus.graph();
    const auto vpm = get(CGAL::vertex_point, built.mesh);
    for(const auto v : CGAL::make_range(vertices(graph)))
    {
      EXPECT_TRUE(graph[v].point == get(vpm, graph[v].mesh_vertex));
      EXPECT_EQ(graph[v].distance, cut_locus.distance(graph[v].mesh_vertex));
      // the location is the corner of a face that has the vertex
      auto h = halfedge(graph[v].location.first, built.mesh);
      double sum = 0.;
      for(int i = 0; i < 3; ++i, h = next(h, built.mesh))
      {
        const double c = CGAL::to_double(graph[v].location.second[i]);
        sum += c;
        EXPECT_EQ(c, source(h, built.mesh) == graph[v].mesh_vertex ? 1. : 0.);
      }
      EXPECT_EQ(sum, 1.);
    }
    for(const auto e : CGAL::make_range(edges(graph)))
    {
      const auto h = graph[e].mesh_halfedge;
      EXPECT_EQ(topology_checker::make_edge(built.index(source(h, built.mesh)), built.index(target(h, built.mesh))),
                topology_checker::make_edge(built.index(graph[source(e, graph)].mesh_vertex),
                                            built.index(graph[target(e, graph)].mesh_vertex)));
      EXPECT_FALSE(graph[e].is_on_border);
      EXPECT_FALSE(std::isnan(graph[e].strength));
    }
  }
}

TYPED_TEST(Cut_locus_test, of_distances_that_the_user_has_is_that_of_the_solver_that_made_them)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = torus(1., 0.4, 20, 10, 0.2, 2);
  const TypeParam built(data);
  typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(Laplacian_method()));
  solver.set_source(built.vertices[5]);
  const auto expected = solver.cut_locus(mesh_edges);
  auto distance = get(CGAL::dynamic_vertex_property_t<double>(), built.mesh);
  for(const auto v : CGAL::make_range(vertices(built.mesh)))
    put(distance, v, expected.distance(v));
  const auto found = CGAL::compute_cut_locus(built.mesh, built.vertices[5], mesh_edges.vertex_distance_map(distance));
  EXPECT_EQ(cut_of(built, found).edges, cut_of(built, expected).edges);
  EXPECT_EQ(found.distance(built.vertices[77]), expected.distance(built.vertices[77]));

  try
  {
    CGAL::compute_cut_locus(built.mesh, built.vertices[5],
                            mesh_edges.vertex_distance_map(distance).cut_locus_method(Default_method()));
    ADD_FAILURE() << "the exact tree needs paths";
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    EXPECT_NE(std::string(error.what()).find("Cut_loci::Laplacian_method"), std::string::npos) << error.what();
  }
}

TYPED_TEST(Cut_locus_test, follows_the_distances_of_each_source_in_its_choice_of_a_method)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = torus(1., 0.4, 20, 10, 0.2, 2);
  const TypeParam built(data);
  const auto edges_by = [&](Method method)
  {
    return cut_of(built, CGAL::compute_cut_locus(built.mesh, built.vertices[5], mesh_edges.cut_locus_method(method)))
      .edges;
  };
  typename Fixture::Solver solver(built.mesh);
  EXPECT_TRUE(std::holds_alternative<Default_method>(solver.method()));
  solver.set_source(built.vertices[5]);
  EXPECT_TRUE(std::holds_alternative<Default_method>(solver.method()));
  const auto first = solver.cut_locus(mesh_edges);
  EXPECT_EQ(cut_of(built, first).edges, edges_by(Default_method()));
  auto distance = get(CGAL::dynamic_vertex_property_t<double>(), built.mesh);
  for(const auto v : CGAL::make_range(vertices(built.mesh)))
    put(distance, v, first.distance(v));
  solver.set_source(built.vertices[5], CGAL::parameters::vertex_distance_map(distance));
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(solver.method()));
  EXPECT_EQ(cut_of(built, solver.cut_locus(mesh_edges)).edges, edges_by(Laplacian_method()));
  solver.set_source(built.vertices[5]);
  EXPECT_TRUE(std::holds_alternative<Default_method>(solver.method()));
  EXPECT_EQ(cut_of(built, solver.cut_locus(mesh_edges)).edges, edges_by(Default_method()));
}

TYPED_TEST(Cut_locus_test, is_a_cut_locus_by_its_topology_even_for_distances_that_are_nonsense)
{
  using Fixture = Cut_locus_test<TypeParam>;
  for(const Mesh_data& data : {icosahedron(), jittered_sphere(5, 0.2, 1), torus(1., 0.4, 14, 8, 0.2, 2),
                               perforated_plate(3, 1, 1, 3), square(6, 0.2, 4), cylinder(1., 8, 4, 0.2, 5),
                               punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}, {{-1., 0., 0.}}}, 0.4)})
  {
    const TypeParam built(data);
    {
      typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(Laplacian_method()));
      auto distance = get(CGAL::dynamic_vertex_property_t<double>(), built.mesh);
      for(unsigned seed = 0; seed < 4; ++seed)
      {
        std::mt19937 engine(seed);
        bool is_first = true; // the same number everywhere is refused
        for(const auto v : CGAL::make_range(vertices(built.mesh)))
        {
          put(distance, v,
              seed == 0   ? (is_first ? 1. : 0.)
              : seed == 1 ? double(engine() % 3)
                          : 1. + random_unit(engine));
          is_first = false;
        }
        const std::size_t v = engine() % data.points.size(), f = engine() % data.triangles.size();
        if(seed == 3)
          put(distance, built.vertices[v], 5.);
        solver.set_source(built.vertices[v], CGAL::parameters::vertex_distance_map(distance));
        Fixture::expect_valid_at_all_thresholds(built, solver, Fixture::at_vertex(data, v));
        const Triangle& t = data.triangles[f];
        solver.set_source(built.template location<typename Fixture::FT>(f, {{0.5, 0.5, 0.}}),
                          CGAL::parameters::vertex_distance_map(distance));
        Fixture::expect_valid_at_all_thresholds(built, solver, {f, {t[0], t[1]}});
      }
    }
  }
}

TYPED_TEST(Cut_locus_test, takes_the_points_from_the_users_vertex_point_map)
{
  using Kernel_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const Mesh_data data = ellipsoid(1., 0.8, 0.6, 6, 0.2, 1);
  const TypeParam right(data);
  Mesh_data collapsed = data;
  for(Point& p : collapsed.points)
    p = {{0., 0., 0.}};
  const TypeParam wrong(collapsed);
  auto points = get(CGAL::dynamic_vertex_property_t<Kernel_point>(), wrong.mesh);
  for(std::size_t v = 0; v < data.points.size(); ++v)
  {
    const Point& p = right.data.points[v];
    put(points, wrong.vertices[v], Kernel_point(p[0], p[1], p[2]));
  }
  const auto expected = CGAL::compute_cut_locus(right.mesh, right.vertices[5], mesh_edges);
  const auto found = CGAL::compute_cut_locus(wrong.mesh, wrong.vertices[5], mesh_edges.vertex_point_map(points));
  EXPECT_EQ(cut_of(wrong, found).edges, cut_of(right, expected).edges);
  EXPECT_TRUE(found.source().point == get(points, wrong.vertices[5]));
}

TYPED_TEST(Cut_locus_test, is_the_same_on_every_mesh_type)
{
  for(const Mesh_data& data : {jittered_sphere(7, 0.2, 1), torus(1., 0.4, 20, 10, 0.2, 2), perforated_plate(2, 1, 2, 5),
                               bumpy_sphere(8, 0.5, 3), punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}}, 0.35)})
  {
    const TypeParam built(data);
    const Built_mesh<Reference_mesh> reference(built.data);
    for(Method method : both_methods)
    {
      const auto with_method = CGAL::parameters::cut_locus_method(method);
      CGAL::Surface_mesh_cut_locus<typename TypeParam::Mesh> solver(built.mesh, with_method);
      CGAL::Surface_mesh_cut_locus<Reference_mesh> reference_solver(reference.mesh, with_method);
      solver.set_source(built.vertices[4]);
      reference_solver.set_source(reference.vertices[4]);
      const auto expect_same = [&](const auto& np)
      {
        const auto expected = reference_solver.cut_locus(np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
        const auto found = solver.cut_locus(np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
        EXPECT_EQ(cut_of(built, found).edges, cut_of(reference, expected).edges) << name_of(method);
        EXPECT_EQ(built.index(found.farthest_vertex()), reference.index(expected.farthest_vertex()));
      };
      if(std::holds_alternative<Laplacian_method>(method))
        for(double angle : {0., 0.1, 0.5, 2.})
          expect_same(CGAL::parameters::cut_locus_method(Laplacian_method().gradient_angle_threshold(angle)));
      else
        for(double width : {0.2, 0.05, 0.})
          expect_same(CGAL::parameters::cut_locus_method(Default_method().minimum_branch_width(width)));
    }
  }
}

TYPED_TEST(Cut_locus_test, does_not_depend_on_the_numbering)
{
  for(const Mesh_data& data :
      {jittered_sphere(7, 0.2, 1), torus(1., 0.4, 20, 10, 0.2, 2), perforated_plate(2, 1, 2, 5)})
  {
    const TypeParam built(data);
    const auto np = CGAL::parameters::cut_locus_method(Laplacian_method());
    const auto expected = cut_of(built, CGAL::compute_cut_locus(built.mesh, built.vertices[4],
                                                                np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)))
                            .edges;
    // The curve by the other method: along edges of the mesh, it may go round a face on either side.
    const auto in_faces = CGAL::parameters::cut_locus_method(Default_method()).cut_locus_curve(Curve::THROUGH_FACES);
    const auto curve =
      CGAL::Cut_loci::compute_statistics(CGAL::compute_cut_locus(built.mesh, built.vertices[4], in_faces));
    for(unsigned seed = 0; seed < 2; ++seed)
    {
      std::vector<std::size_t> new_index;
      const TypeParam other(shuffled(data, seed, new_index));
      topology_checker::Edges renamed;
      for(const auto& e : expected)
        renamed.insert(topology_checker::make_edge(new_index[e.first], new_index[e.second]));
      EXPECT_EQ(cut_of(other, CGAL::compute_cut_locus(other.mesh, other.vertices[new_index[4]],
                                                      np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)))
                  .edges,
                renamed);
      const auto other_curve =
        CGAL::Cut_loci::compute_statistics(CGAL::compute_cut_locus(other.mesh, other.vertices[new_index[4]], in_faces));
      EXPECT_EQ(other_curve.edges, curve.edges);
      EXPECT_EQ(other_curve.leaves, curve.leaves);
    }
  }
}

TYPED_TEST(Cut_locus_test, does_not_depend_on_the_unit_of_length)
{
  namespace params = CGAL::parameters;
  const Mesh_data data = ellipsoid(1., 0.8, 0.6, 7, 0.2, 1);
  const TypeParam built(data);
  const auto expect_same = [&](const auto& np)
  {
    const auto expected = cut_of(built, CGAL::compute_cut_locus(built.mesh, built.vertices[4],
                                                                np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)))
                            .edges;
    EXPECT_GT(expected.size(), 3u);
    for(double scale : {std::ldexp(1., -20), std::ldexp(1., 20)}) // by a power of two, rounding is the same
    {
      Mesh_data scaled = data;
      for(Point& p : scaled.points)
        p = scale * p;
      const TypeParam other(scaled);
      EXPECT_EQ(cut_of(other, CGAL::compute_cut_locus(other.mesh, other.vertices[4],
                                                      np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)))
                  .edges,
                expected);
    }
  };
  expect_same(params::cut_locus_method(
    Laplacian_method().gradient_angle_threshold(0.2).laplacian_threshold(0.1).minimum_branch_length(0.1)));
  expect_same(params::cut_locus_method(Default_method().minimum_branch_width(0.05).minimum_branch_length(0.1)));
}

TYPED_TEST(Cut_locus_test, is_the_same_each_time_and_does_not_remember_the_source_before)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const TypeParam built(torus(1., 0.4, 20, 10, 0.2, 2));
  for(Method method : both_methods)
  {
    typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
    solver.set_source(built.vertices[4]);
    const auto first = solver.cut_locus(mesh_edges);
    const auto first_cut = cut_of(built, first);
    const double first_distance = first.distance(built.vertices[90]);
    solver.set_source(built.vertices[50]);
    EXPECT_NE(cut_of(built, solver.cut_locus(mesh_edges)).edges, first_cut.edges);
    EXPECT_EQ(first.distance(built.vertices[90]), first_distance) << "a result is a value of its own";
    solver.set_source(built.vertices[4]);
    EXPECT_EQ(cut_of(built, solver.cut_locus(mesh_edges)).edges, first_cut.edges);
  }
}

TYPED_TEST(Cut_locus_test, named_parameters_chain_in_any_order_with_those_of_cgal)
{
  namespace params = CGAL::parameters;
  const TypeParam built(jittered_sphere(5, 0.2, 1));
  auto is_constrained = get(CGAL::dynamic_edge_property_t<bool>(), built.mesh);
  const auto vpm = get(CGAL::vertex_point, built.mesh);
  const CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct> heat;
  const auto first = CGAL::compute_cut_locus(
    built.mesh, built.vertices[4],
    mesh_edges.vertex_point_map(vpm)
      .geodesic_solver(heat)
      .edge_is_constrained_map(is_constrained)
      .cut_locus_method(Laplacian_method().gradient_angle_threshold(0.2).minimum_branch_edges(1)));
  const auto second = CGAL::compute_cut_locus(
    built.mesh, built.vertices[4],
    mesh_edges.cut_locus_method(Laplacian_method().minimum_branch_edges(1).gradient_angle_threshold(0.2))
      .edge_is_constrained_map(is_constrained)
      .geodesic_solver(heat)
      .vertex_point_map(vpm));
  const auto other_solver = CGAL::compute_cut_locus(
    built.mesh, built.vertices[4],
    mesh_edges.cut_locus_method(Laplacian_method().minimum_branch_edges(1).gradient_angle_threshold(0.2)));
  EXPECT_EQ(cut_of(built, first).edges, cut_of(built, second).edges);
  EXPECT_NE(first.distance(built.vertices[20]), other_solver.distance(built.vertices[20])) << "the solver was not used";
}

TYPED_TEST(Cut_locus_test, lies_in_the_component_of_the_source_and_leaves_the_others_at_infinity)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data ball = jittered_sphere(5, 0.2, 1), ring = torus(1., 0.4, 16, 8, 0.2, 2);
  const Mesh_data data = disjoint_union(ball, ring, {{4., 0., 0.}});
  const TypeParam built(data);
  for(Method method : both_methods)
  {
    const auto np = CGAL::parameters::cut_locus_method(method);
    typename Fixture::Solver solver(built.mesh, np);
    for(std::size_t v : {std::size_t(3), ball.points.size() + 3, std::size_t(7)})
    {
      solver.set_source(built.vertices[v]);
      Fixture::expect_valid_at_all_thresholds(built, solver, Fixture::at_vertex(data, v));
      const auto cut_locus = solver.cut_locus(mesh_edges);
      const bool in_ball = v < ball.points.size();
      EXPECT_EQ(cut_locus.genus(), in_ball ? 0u : 1u);
      for(std::size_t w = 0; w < data.points.size(); ++w)
        EXPECT_EQ(std::isinf(cut_locus.distance(built.vertices[w])), in_ball != (w < ball.points.size()));
      // the other component does not change anything, but for the numbers of the vertices
      const TypeParam alone(in_ball ? ball : ring);
      const std::size_t offset = in_ball ? 0 : ball.points.size();
      topology_checker::Edges expected;
      for(const auto& e : cut_of(alone, CGAL::compute_cut_locus(alone.mesh, alone.vertices[v - offset],
                                                                np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)))
                            .edges)
        expected.insert(topology_checker::make_edge(e.first + offset, e.second + offset));
      EXPECT_EQ(cut_of(built, cut_locus).edges, expected);
    }
    solver.set_source(built.template location<typename Fixture::FT>(ball.triangles.size() + 9, {{0.2, 0.3, 0.5}}));
    const Triangle& t = data.triangles[ball.triangles.size() + 9];
    Fixture::expect_valid_at_all_thresholds(built, solver, {ball.triangles.size() + 9, {t[0], t[1], t[2]}});
  }
}

TYPED_TEST(Cut_locus_test, ignores_isolated_vertices)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data ball = jittered_sphere(5, 0.2, 1);
  Mesh_data data = ball;
  // one in front, one behind
  data.points.insert(data.points.begin(), {{9., 9., 9.}});
  data.points.push_back({{std::numeric_limits<double>::quiet_NaN(), 0., 0.}});
  for(Triangle& t : data.triangles)
    for(std::size_t& v : t)
      ++v;
  const TypeParam built(data), alone(ball);
  for(Method method : both_methods)
  {
    const auto np = CGAL::parameters::cut_locus_method(method);
    const auto found =
      CGAL::compute_cut_locus(built.mesh, built.vertices[5], np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
    const auto expected =
      CGAL::compute_cut_locus(alone.mesh, alone.vertices[4], np.cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));
    Fixture::expect_valid(built, found, Fixture::at_vertex(data, 5), method);
    EXPECT_TRUE(std::isinf(found.distance(built.vertices.front())));
    EXPECT_TRUE(std::isinf(found.distance(built.vertices.back())));
    topology_checker::Edges shifted;
    for(const auto& e : cut_of(alone, expected).edges)
      shifted.insert({e.first + 1, e.second + 1});
    EXPECT_EQ(cut_of(built, found).edges, shifted);
  }
}

TYPED_TEST(Cut_locus_test, on_a_surface_with_boundary_joins_each_border_loop_once)
{
  using Fixture = Cut_locus_test<TypeParam>;
  for(const Mesh_data& data :
      {square(8, 0.2, 1), cylinder(2., 12, 8, 0.2, 2), punctured(square(12, 0.2, 3), {{{0.5, 0.5, 0.}}}, 0.2),
       punctured(jittered_sphere(9, 0.2, 3), {{{1., 0., 0.}}, {{-1., 0., 0.}}, {{0., 0., 1.}}}, 0.35),
       punctured(torus(1., 0.4, 24, 14, 0.2, 4), {{{-1.4, 0., 0.}}, {{0., 1.4, 0.}}}, 0.3)})
  {
    const TypeParam built(data);
    const topology_checker::Surface surface(data.triangles, 0);
    EXPECT_GT(surface.number_of_loops, 0u);
    for(Method method : both_methods)
    {
      typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(method));
      for(std::size_t v = 0; v < data.points.size(); v += data.points.size() / 5) // on the border and inside
      {
        solver.set_source(built.vertices[v]);
        Fixture::expect_valid_at_all_thresholds(built, solver, Fixture::at_vertex(data, v));
        const auto cut_locus =
          std::holds_alternative<Laplacian_method>(method)
            ? solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(0.)))
            : solver.cut_locus(mesh_edges.cut_locus_method(Default_method().minimum_branch_width(0.)));
        const auto& graph = cut_locus.graph();
        for(const auto e : CGAL::make_range(edges(graph)))
          EXPECT_EQ(graph[e].is_on_border, surface.border_edges.count(topology_checker::make_edge(
                                             built.index(graph[source(e, graph)].mesh_vertex),
                                             built.index(graph[target(e, graph)].mesh_vertex))) != 0);
      }
    }
  }
}

TYPED_TEST(Cut_locus_test, is_found_with_the_cotangent_laplacian_too)
{
  using Fixture = Cut_locus_test<TypeParam>;
  const Mesh_data data = torus(1., 0.4, 24, 12);
  const TypeParam built(data);
  typename Fixture::Solver solver(built.mesh, CGAL::parameters::cut_locus_method(Laplacian_method().laplacian_operator(
                                                CGAL::Cut_loci::Laplacian_operator::COTANGENT)));
  solver.set_source(built.vertices[0]);
  Fixture::expect_valid_at_all_thresholds(built, solver, Fixture::at_vertex(data, 0));
}

TYPED_TEST(Cut_locus_test, of_the_torus_holds_the_opposite_meridian_and_the_inner_equator)
{
  // vertices lie on both curves, and so do the paths of the tree at a threshold that only they pass
  const std::size_t nu = 48, nw = 24;
  const Mesh_data data = torus(1., 0.4, nu, nw);
  const TypeParam built(data);
  for(Method method : both_methods)
  {
    const auto cut_locus = CGAL::compute_cut_locus(built.mesh, built.vertices[0], mesh_edges.cut_locus_method(method));
    std::set<std::size_t> on_it;
    for(const auto& e : cut_of(built, cut_locus).edges)
      on_it.insert({e.first, e.second});
    const double h = mean_edge_length(data);
    const auto distance_to_it = [&](std::size_t v)
    {
      double result = std::numeric_limits<double>::infinity();
      for(std::size_t w : on_it)
        result = (std::min)(result, norm(data.points[v] - data.points[w]));
      return result;
    };
    for(std::size_t w = 0; w < nw; ++w)
      EXPECT_LT(distance_to_it(nu / 2 * nw + w), 3. * h) << "on the opposite meridian";
    for(std::size_t u = 0; u < nu; ++u)
      EXPECT_LT(distance_to_it(u * nw + nw / 2), 3. * h) << "on the inner equator";
  }
}

#endif // CGAL_CUT_LOCI_CUT_LOCUS_CASES_H
