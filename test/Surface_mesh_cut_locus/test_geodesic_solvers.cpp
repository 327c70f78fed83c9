// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

namespace test_geodesic_solvers {

// The geodesic solvers against closed forms and each other, and solvers that a user writes.

using namespace surface_test;
using Direct_heat = CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>;
using Intrinsic_heat = CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Intrinsic_Delaunay>;

namespace {

Indexed_source location(Index face, const std::array<double, 3>& coordinates)
{
  return {{face, coordinates}, null_index};
}

Point point_of(const Indexed_triangle_mesh& mesh, const Indexed_source& source)
{
  return CGAL::Cut_loci::internal::position(mesh, source.location);
}

template <typename Solver>
std::vector<double> distances(Solver solver, const Indexed_triangle_mesh& mesh, const Indexed_source& source)
{
  std::vector<double> result;
  solver.set_mesh(mesh);
  solver.compute_distances(source, result);
  return result;
}

// the largest difference, in units of `unit`
double largest_error(const std::vector<double>& d, const std::function<double(std::size_t)>& truth, double unit)
{
  double result = 0.;
  for(std::size_t v = 0; v < d.size(); ++v)
    result = (std::max)(result, std::abs(d[v] - truth(v)) / unit);
  return result;
}

double great_circle(const Point& p, const Point& q)
{
  return std::atan2(norm(cross(p, q)), dot(p, q));
}

// two flat strips glued along both sides: two edges join each pair of vertices opposite to each other
Indexed_triangle_mesh two_sided_strip(Index n)
{
  Indexed_triangle_mesh mesh;
  for(Index k = 0; k <= n; ++k)
    for(Index u = 0; u < 2; ++u)
      mesh.points.push_back({{double(u), double(k), 0.}});
  enum Kind { RING, SIDE, DIAGONAL };
  std::map<std::array<Index, 3>, Index> first_halfedge;
  const auto add = [&](Index a, Index b, Index c, const std::array<std::array<Index, 3>, 3>& names)
  {
    mesh.triangles.push_back({{a, b, c}});
    for(const auto& name : names)
    {
      const Index h = static_cast<Index>(mesh.opposite.size());
      const auto inserted = first_halfedge.emplace(name, h);
      mesh.opposite.push_back(inserted.second ? null_index : inserted.first->second);
      if(!inserted.second)
        mesh.opposite[inserted.first->second] = h;
    }
  };
  for(Index k = 0; k < n; ++k)
    for(Index u = 0; u < 2; ++u)
    {
      const Index a = 2 * k + u, b = 2 * k + 1 - u, c = b + 2, d = a + 2;
      add(a, b, c, {{{{RING, k, u}}, {{SIDE, k, 1 - u}}, {{DIAGONAL, k, u}}}});
      add(a, c, d, {{{{DIAGONAL, k, u}}, {{RING, k + 1, u}}, {{SIDE, k, u}}}});
    }
  return mesh;
}

// straight lines in space: no geodesics, but a solver by its interface
struct Euclidean_solver
{
  struct Log
  {
    int meshes = 0, sources = 0;
  };
  std::shared_ptr<Log> log = std::make_shared<Log>();
  const Indexed_triangle_mesh* mesh = nullptr;
  std::size_t missing = 0;

  void set_mesh(const Indexed_triangle_mesh& m)
  {
    mesh = &m;
    ++log->meshes;
  }

  void compute_distances(const Indexed_source& source, std::vector<double>& d)
  {
    ++log->sources;
    d.clear();
    for(const Point& p : mesh->points)
      d.push_back(norm(p - point_of(*mesh, source)));
    d.resize(d.size() - missing);
  }
};

void expect_consistent(const Indexed_triangle_mesh& mesh)
{
  ASSERT_EQ(mesh.opposite.size(), mesh.number_of_halfedges());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    if(mesh.is_border_edge(h))
      continue;
    const Index o = mesh.opposite[h];
    ASSERT_LT(o, mesh.number_of_halfedges());
    EXPECT_NE(o, h);
    EXPECT_EQ(mesh.opposite[o], h);
    EXPECT_EQ(mesh.source(o), mesh.target(h));
    EXPECT_EQ(mesh.target(o), mesh.source(h));
  }
}

double area(const Indexed_triangle_mesh& mesh)
{
  double sum = 0.;
  for(const auto& t : mesh.triangles)
    sum += 0.5 * norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
  return sum;
}

Index border_size(const Indexed_triangle_mesh& mesh)
{
  return static_cast<Index>(std::count(mesh.opposite.begin(), mesh.opposite.end(), null_index));
}

} // namespace

TEST(Shortest_path_geodesic_solver, is_exact_on_a_convex_piece_of_the_plane_from_any_source)
{
  const Indexed_triangle_mesh mesh = indexed(square(8, 0.3, 1));
  Index border_face = 0, border_side = 0;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
    {
      border_face = h / 3;
      border_side = h % 3;
    }
  std::array<double, 3> on_border = {{0., 0., 0.}};
  on_border[border_side] = 0.3;
  on_border[(border_side + 1) % 3] = 0.7;
  for(const Indexed_source& source : {at_vertex(mesh, 0), at_vertex(mesh, 40), location(50, {{0.2, 0.5, 0.3}}),
                                      location(50, {{0.5, 0., 0.5}}), location(border_face, on_border)})
  {
    const Point p = point_of(mesh, source);
    EXPECT_LT(largest_error(
                distances(CGAL::Shortest_path_geodesic_solver(), mesh, source),
                [&](std::size_t v) { return norm(mesh.points[v] - p); }, 1.),
              1e-7);
  }
}

TEST(Shortest_path_geodesic_solver, converges_with_order_two_to_great_circles)
{
  std::vector<double> h, error;
  for(std::size_t n : {4, 8, 16})
  {
    const Mesh_data data = jittered_sphere(n, 0.15, 2);
    const Indexed_triangle_mesh mesh = indexed(data);
    h.push_back(mean_edge_length(data));
    error.push_back(largest_error(
      distances(CGAL::Shortest_path_geodesic_solver(), mesh, at_vertex(mesh, 0)),
      [&](std::size_t v) { return great_circle(data.points[0], data.points[v]); }, 1.));
  }
  for(std::size_t i = 1; i < h.size(); ++i)
    EXPECT_GT(std::log(error[i - 1] / error[i]) / std::log(h[i - 1] / h[i]), 1.7);
}

template <typename Solver>
class Heat_method_test : public ::testing::Test
{
};
using Heat_solvers = ::testing::Types<Direct_heat, Intrinsic_heat>;
TYPED_TEST_SUITE(Heat_method_test, Heat_solvers);

TYPED_TEST(Heat_method_test, comes_closer_to_great_circles_with_an_error_below_one_edge)
{
  double previous = 0.;
  for(std::size_t n : {8, 16, 32})
  {
    const Mesh_data data = jittered_sphere(n, 0.15, 2);
    const Indexed_triangle_mesh mesh = indexed(data);
    const double h = mean_edge_length(data);
    const double error = largest_error(
      distances(TypeParam(), mesh, at_vertex(mesh, 0)),
      [&](std::size_t v) { return great_circle(data.points[0], data.points[v]); }, 1.);
    this->RecordProperty("error_in_h_" + std::to_string(n), std::to_string(error / h));
    EXPECT_LT(error, h);
    if(previous > 0.) // slower than h: 0.25 h, 0.33 h, 0.54 h
    {
      EXPECT_LT(error, previous);
    }
    previous = error;
  }
}

TYPED_TEST(Heat_method_test, takes_sources_inside_faces_and_on_edges)
{
  const Mesh_data data = jittered_sphere(12, 0.15, 2);
  const Indexed_triangle_mesh mesh = indexed(data);
  const double h = mean_edge_length(data);
  for(const Indexed_source& source :
      {location(7, {{0.3, 0.3, 0.4}}), location(100, {{0.6, 0.4, 0.}}), location(500, {{0., 0.5, 0.5}})})
  {
    const std::vector<double> d = distances(TypeParam(), mesh, source);
    ASSERT_EQ(d.size(), data.points.size());
    const Point p = normalized(point_of(mesh, source));
    EXPECT_LT(largest_error(
                d, [&](std::size_t v) { return great_circle(p, data.points[v]); }, h),
              1.);
  }
}

TYPED_TEST(Heat_method_test, can_be_asked_again_for_other_sources)
{
  const Indexed_triangle_mesh mesh = indexed(jittered_sphere(6, 0.15, 2));
  TypeParam solver;
  solver.set_mesh(mesh);
  std::vector<double> first, other, inside, again;
  solver.compute_distances(at_vertex(mesh, 3), first);
  solver.compute_distances(at_vertex(mesh, 60), other);
  solver.compute_distances(location(5, {{0.3, 0.3, 0.4}}), inside);
  solver.compute_distances(at_vertex(mesh, 3), again);
  EXPECT_NE(first, other);
  EXPECT_EQ(first, again);
}

TEST(Insert_vertex, keeps_the_surface_and_puts_the_vertex_where_it_was_asked_for)
{
  for(const Mesh_data& data : {jittered_sphere(3, 0.2, 1), square(3, 0.2, 2), cylinder(1., 6, 2, 0.1, 3)})
  {
    const Indexed_triangle_mesh mesh = indexed(data);
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
      for(const std::array<double, 3>& c :
          std::vector<std::array<double, 3>>{{{0.2, 0.3, 0.5}}, {{0., 0.3, 0.7}}, {{0.3, 0., 0.7}}, {{0.3, 0.7, 0.}}})
      {
        const Indexed_source source = location(f, c);
        Indexed_triangle_mesh refined = mesh;
        CGAL::Cut_loci::internal::insert_vertex_into(refined, source.location);
        expect_consistent(refined);
        const Index v = mesh.number_of_vertices();
        ASSERT_EQ(refined.number_of_vertices(), v + 1);
        EXPECT_LT(norm(refined.points[v] - point_of(mesh, source)), 1e-14);
        EXPECT_NEAR(area(refined), area(mesh), 1e-12);

        const bool is_on_edge = c[0] == 0. || c[1] == 0. || c[2] == 0.;
        const Index side = 3 * f + (c[0] == 0. ? 1 : c[1] == 0. ? 2 : 0);
        const bool is_on_border = is_on_edge && mesh.is_border_edge(side);
        EXPECT_EQ(refined.number_of_faces(), mesh.number_of_faces() + (is_on_border ? 1 : 2));
        EXPECT_EQ(border_size(refined), border_size(mesh) + (is_on_border ? 1 : 0));

        const Mesh_connectivity before(mesh), after(refined);
        ASSERT_TRUE(after.first_non_manifold.empty());
        EXPECT_EQ(after.valence(v), is_on_border || !is_on_edge ? 3u : 4u);
        EXPECT_EQ(after.is_border(v), is_on_border);
        EXPECT_EQ(after.genus(refined), before.genus(mesh));
        EXPECT_EQ(after.number_of_border_loops, before.number_of_border_loops);
      }
  }
}

TEST(Surface_mesh_copy, is_a_valid_mesh_with_the_same_numbering)
{
  for(const Mesh_data& data :
      {jittered_sphere(3, 0.2, 1), square(3, 0.2, 2), cylinder(1., 6, 2, 0.1, 3), perforated_plate(2, 1, 1, 4)})
  {
    const Indexed_triangle_mesh mesh = indexed(data);
    const auto copy = CGAL::Cut_loci::internal::surface_mesh_copy(mesh);
    EXPECT_TRUE(copy.is_valid(false));
    EXPECT_TRUE(CGAL::is_triangle_mesh(copy));
    ASSERT_EQ(copy.number_of_faces(), mesh.number_of_faces());
    EXPECT_EQ(copy.number_of_vertices(), mesh.number_of_vertices());
    for(Mesh::Face_index f : copy.faces())
    {
      Mesh::Halfedge_index h = copy.halfedge(f);
      for(int i = 0; i < 3; ++i, h = copy.next(h))
        EXPECT_EQ(Index(copy.source(h)), mesh.triangles[f][i]);
    }
  }
}

TEST(Surface_mesh_copy, of_a_surface_with_two_edges_between_the_same_vertices_can_be_solved_on)
{
  const Indexed_triangle_mesh mesh = two_sided_strip(6);
  expect_consistent(mesh);
  const auto copy = CGAL::Cut_loci::internal::surface_mesh_copy(mesh);
  EXPECT_TRUE(copy.is_valid(false));
  // both strips are flat: the distance is that in the plane
  EXPECT_LT(largest_error(
              distances(CGAL::Shortest_path_geodesic_solver(), mesh, at_vertex(mesh, 0)),
              [&](std::size_t v) { return norm(mesh.points[v] - mesh.points[0]); }, 1.),
            1e-7);
  const auto cut_locus = compute_cut_locus(copy, Mesh::Vertex_index(4));
  EXPECT_EQ(cut_locus.genus(), 0u);
  EXPECT_EQ(cut_locus.number_of_border_loops(), 2u);
  for(Mesh::Vertex_index v : copy.vertices())
    EXPECT_TRUE(std::isfinite(cut_locus.distance(v)));
}

TEST(Geodesic_solver, can_be_written_by_the_user)
{
  const Mesh_data data = jittered_sphere(5, 0.2, 1);
  const Built built(data);
  const Euclidean_solver euclidean;
  Solver solver(built.mesh, params::geodesic_solver(euclidean));
  for(std::size_t v : {3, 70})
  {
    solver.set_source(built.vertices[v]);
    const auto result = solver.cut_locus(mesh_edges);
    EXPECT_EQ(fault_of(built, result, 0, {v}), "");
    for(std::size_t w = 0; w < data.points.size(); ++w)
      EXPECT_EQ(result.distance(built.vertices[w]), norm(data.points[w] - data.points[v]));
  }
  EXPECT_EQ(euclidean.log->meshes, 1) << "the mesh is set once";
  EXPECT_EQ(euclidean.log->sources, 2);
}

TEST(Geodesic_solver, chooses_the_method_for_its_distances)
{
  const Built built(jittered_sphere(5, 0.2, 1));
  const auto method_with = [&](const auto& geodesic_solver)
  { return Solver(built.mesh, params::geodesic_solver(geodesic_solver)).method(); };
  EXPECT_TRUE(std::holds_alternative<Default_method>(Solver(built.mesh).method()));
  EXPECT_TRUE(std::holds_alternative<Default_method>(method_with(CGAL::Exact_geodesic_solver())));
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(method_with(CGAL::Shortest_path_geodesic_solver())));
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(method_with(CGAL::Heat_method_geodesic_solver<>())));
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(method_with(CGAL::Graph_geodesic_solver())));
  EXPECT_TRUE(std::holds_alternative<Laplacian_method>(method_with(Euclidean_solver())));
}

TEST(Geodesic_solver, gets_the_component_of_the_source_alone)
{
  const Mesh_data ball = jittered_sphere(3, 0.2, 1);
  const Built built(disjoint_union(ball, ball, {{4., 0., 0.}}));
  const Euclidean_solver euclidean;
  Solver solver(built.mesh, params::geodesic_solver(euclidean));
  for(std::size_t v : {std::size_t(0), ball.points.size(), std::size_t(5)})
  {
    solver.set_source(built.vertices[v]);
    EXPECT_NEAR(solver.cut_locus().distance(built.vertices[v]), 0., 1e-15);
  }
  EXPECT_EQ(euclidean.log->meshes, 2);
}

TEST(Geodesic_solver, that_returns_too_few_distances_is_refused)
{
  const Built built(icosahedron());
  Euclidean_solver euclidean;
  euclidean.missing = 2;
  expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0], params::geodesic_solver(euclidean)); },
                 Cause::INVALID_DISTANCE, {"the geodesic solver returned 10 distances for 12 vertices"});
}

namespace {

struct Counting_visitor : public CGAL::Cut_loci::Default_visitor
{
  std::vector<CGAL::Cut_loci::Stage> started, ended;
  void start_stage(CGAL::Cut_loci::Stage s) { started.push_back(s); }
  void end_stage(CGAL::Cut_loci::Stage s) { ended.push_back(s); }
};

} // namespace

TEST(Visitor, is_told_of_each_stage_and_keeps_its_state_by_reference)
{
  using CGAL::Cut_loci::Stage;
  const Built built(jittered_sphere(3, 0.2, 1));
  Counting_visitor visitor;
  Solver solver(built.mesh, params::visitor(std::ref(visitor)));
  solver.set_source(built.vertices[0]);
  solver.cut_locus();
  visitor.started.clear();
  visitor.ended.clear();
  solver.set_source(built.vertices[1]);
  EXPECT_EQ(visitor.started, (std::vector<Stage>{Stage::DISTANCE, Stage::STRENGTH, Stage::TREE, Stage::HOMOLOGY}))
    << "the mesh is not preprocessed again";
  solver.cut_locus();
  EXPECT_EQ(visitor.started.back(), Stage::FILTER);
  EXPECT_EQ(visitor.started, visitor.ended);
  visitor.started.clear();
  solver.cut_locus(by(Default_method().minimum_branch_width(0.3)));
  EXPECT_EQ(visitor.started, std::vector<Stage>{Stage::FILTER}) << "a new threshold runs nothing else";
}

} // namespace test_geodesic_solvers
