// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Polyhedron_3.h>

#include <type_traits>

namespace test_bad_input {

// What can not be used is refused with a message that names it, in release builds, too; what is merely odd gives a cut
// locus. Nothing loops, crashes or returns NaN.

using namespace surface_test;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Mesh_data tetrahedron()
{
  Mesh_data data;
  data.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}};
  data.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
  return data;
}

// valid from vertices, faces and edges, at several thresholds, and all numbers in the results are finite
void expect_sound_from_everywhere(const Mesh_data& data, std::size_t number_of_faces = 20)
{
  const Built built(data);
  Solver by_laplacian(built.mesh, by(Laplacian_method())), by_direction(built.mesh);
  const auto expect_finite = [](const Solver::Result& result)
  {
    for(const auto v : CGAL::make_range(vertices(result.graph())))
    {
      EXPECT_TRUE(std::isfinite(result.graph()[v].distance));
      for(int i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isfinite(result.graph()[v].point[i]));
    }
    for(const auto e : CGAL::make_range(edges(result.graph())))
      EXPECT_FALSE(std::isnan(result.graph()[e].strength));
  };
  const auto expect_sound = [&](const auto& source, std::size_t face, const std::vector<std::size_t>& corners)
  {
    by_laplacian.set_source(source);
    for(double angle : {0., 0.5, 3.14})
      for(auto policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
      {
        const auto np = by(Laplacian_method().gradient_angle_threshold(angle).filter_policy(policy));
        const auto result = by_laplacian.cut_locus(np.cut_locus_curve(Curve::MESH_EDGES));
        EXPECT_EQ(fault_of(built, result, face, corners), "") << "source in face " << face;
        expect_finite(result);
        expect_finite(by_laplacian.cut_locus(np));
      }
    by_direction.set_source(source);
    for(double width : {1., 0.1, 0.})
      for(std::size_t edges : {0, 4})
      {
        const auto np = by(Default_method().minimum_branch_width(width).minimum_branch_edges(edges));
        const auto result = by_direction.cut_locus(np.cut_locus_curve(Curve::MESH_EDGES));
        EXPECT_EQ(fault_of(built, result, face, corners, Default_method()), "") << "source in face " << face;
        expect_finite(result);
        expect_finite(by_direction.cut_locus(np.cut_locus_curve(Curve::THROUGH_FACES)));
      }
  };
  for(std::size_t f = 0; f < data.triangles.size(); f += 1 + data.triangles.size() / number_of_faces)
  {
    const Triangle& t = data.triangles[f];
    expect_sound(built.vertices[t[0]], f, {t[0]});
    expect_sound(built.location<double>(f, {{0.3, 0.3, 0.4}}), f, {t[0], t[1], t[2]});
    expect_sound(built.location<double>(f, {{0.5, 0.5, 0.}}), f, {t[0], t[1]});
  }
}

} // namespace

TEST(Bad_input, an_empty_mesh_is_refused)
{
  const Mesh empty;
  expect_refused([&] { Solver solver(empty); }, Cause::EMPTY_MESH, {"empty", "no vertices"});
  expect_refused([&] { compute_cut_locus(empty, Mesh::Vertex_index(0)); }, Cause::EMPTY_MESH, {"empty", "no vertices"});
  const Polyhedron polyhedron;
  expect_refused([&] { CGAL::Surface_mesh_cut_locus<Polyhedron> solver(polyhedron); }, Cause::EMPTY_MESH,
                 {"empty", "no vertices"});
}

TEST(Bad_input, a_mesh_without_faces_is_refused)
{
  Mesh mesh;
  const auto v = mesh.add_vertex(Kernel::Point_3(0., 0., 0.));
  expect_refused([&] { compute_cut_locus(mesh, v); }, Cause::EMPTY_MESH, {"no faces"});
}

TEST(Bad_input, a_face_that_is_not_a_triangle_is_refused_by_its_position_and_number_of_sides)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(const Point& p :
      std::vector<Point>{{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 1., 0.}}, {{0., 1., 0.}}, {{2., 0.5, 0.}}})
    v.push_back(mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
  mesh.add_face(v[1], v[4], v[2]);
  mesh.add_face(v[0], v[1], v[2], v[3]);
  expect_refused([&] { compute_cut_locus(mesh, v[0]); }, Cause::NO_TRIANGLE, {"face #1", "4 sides", "triangle"});
}

TEST(Bad_input, a_null_source_is_refused)
{
  const Built built(octahedron());
  expect_refused([&] { compute_cut_locus(built.mesh, Built::Traits::null_vertex()); }, Cause::INVALID_SOURCE,
                 {"source", "null"});
  Solver::Face_location location;
  location.first = Built::Traits::null_face();
  location.second = {{1., 0., 0.}};
  expect_refused([&] { compute_cut_locus(built.mesh, location); }, Cause::INVALID_SOURCE,
                 {"face of the source", "null"});
}

TEST(Bad_input, an_isolated_source_is_refused)
{
  Mesh_data data = octahedron();
  data.points.insert(data.points.begin() + 2, {{5., 5., 5.}});
  for(Triangle& t : data.triangles)
    for(std::size_t& v : t)
      v += v >= 2 ? 1 : 0;
  const Built built(data);
  expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[2]); }, Cause::INVALID_SOURCE,
                 {"source", "isolated"});
}

TEST(Bad_input, a_source_that_is_not_in_the_mesh_is_refused)
{
  const Built_mesh_with_garbage<Mesh> built(octahedron());
  // removed elements in front and behind, and numbers past the end
  const Mesh::size_type nv = built.mesh.num_vertices(), nf = built.mesh.num_faces();
  for(Mesh::size_type v : {Mesh::size_type(0), nv - 1, nv, Mesh::size_type(1000000000)})
    expect_refused([&] { compute_cut_locus(built.mesh, Mesh::Vertex_index(v)); }, Cause::INVALID_SOURCE,
                   {"source", "not a vertex of the mesh"});
  for(Mesh::size_type f : {Mesh::size_type(0), nf - 1, nf, Mesh::size_type(1000000000)})
    expect_refused(
      [&]
      {
      Solver::Face_location location;
      location.first = Mesh::Face_index(f);
      location.second = {{0.2, 0.3, 0.5}};
      compute_cut_locus(built.mesh, location, mesh_edges);
      },
      Cause::INVALID_SOURCE, {"face of the source", "not a face of the mesh"});
}

TEST(Bad_input, barycentric_coordinates_that_are_no_point_of_the_face_are_refused)
{
  const Built built(octahedron());
  const auto compute = [&](double a, double b, double c) {
    return [=, &built] { compute_cut_locus(built.mesh, Solver::Face_location(built.faces[0], {{a, b, c}})); };
  };
  expect_refused(compute(not_a_number, 0.5, 0.5), Cause::INVALID_SOURCE, {"barycentric coordinate", "not finite"});
  expect_refused(compute(infinity, 0.5, 0.5), Cause::INVALID_SOURCE, {"barycentric coordinate", "not finite"});
  expect_refused(compute(-0.1, 0.6, 0.5), Cause::INVALID_SOURCE, {"barycentric coordinate", "negative"});
  expect_refused(compute(0., 0., 0.), Cause::INVALID_SOURCE, {"barycentric coordinates", "zero"});
  EXPECT_EQ(message_of(compute(2., 3., 5.)), "nothing was thrown") << "coordinates are normalized";
  expect_refused(compute(1e308, 1e308, 1e308), Cause::INVALID_SOURCE, {"barycentric coordinates", "not finite"});
}

TEST(Bad_input, a_coordinate_that_is_not_finite_is_refused_by_its_vertex)
{
  for(double bad : {not_a_number, infinity, -infinity})
    for(int axis : {0, 1, 2})
    {
      Mesh_data data = octahedron();
      data.points[4][axis] = bad;
      const Built built(data);
      expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0]); }, Cause::INVALID_COORDINATE,
                     {"vertex #4", "not finite"});
    }
}

TEST(Bad_input, a_surface_without_area_is_refused_by_a_face)
{
  Mesh_data all_in_one = octahedron();
  for(Point& p : all_in_one.points)
    p = {{1., 2., 3.}};
  const Built built(all_in_one);
  for(Method method : {Method(Default_method()), Method(Laplacian_method())})
    expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0], by(method)); }, Cause::FACE_WITHOUT_AREA,
                   {"face #0", "(vertices ", "no area"});
}

TEST(Bad_input, a_face_without_area_in_another_component_does_no_harm)
{
  Mesh_data flat = tetrahedron();
  for(Point& p : flat.points)
    p = {{p[0], 0., 0.}};
  const Mesh_data data = disjoint_union(flat, octahedron(), {{5., 0., 0.}});
  const Built built(data);
  EXPECT_EQ(fault_of(built, compute_cut_locus(built.mesh, built.vertices[5], mesh_edges), 4, {5}, Default_method()),
            "");
  expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0]); }, Cause::FACE_WITHOUT_AREA,
                 {"face #0", "no area"});
  // positions are those in the whole mesh
  const Built other(disjoint_union(octahedron(), flat, {{5., 0., 0.}}));
  expect_refused([&] { compute_cut_locus(other.mesh, other.vertices[6]); }, Cause::FACE_WITHOUT_AREA,
                 {"face #8", "no area"});
}

TEST(Bad_input, a_vertex_where_two_fans_of_one_component_meet_is_refused_by_its_position)
{
  // an annulus pinched: two vertices of its borders, far from each other on the surface, are one
  Mesh_data data = cylinder(1., 8, 3, 0., 0);
  data.points[0] = 0.5 * (data.points[0] + data.points[28]);
  for(Triangle& t : data.triangles)
    for(std::size_t& v : t)
      if(v == 28)
        v = 0;
  data = without_isolated_vertices(data);
  const Built built(data);
  const std::size_t pinched = data.triangles.front()[0];
  expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[9]); }, Cause::NON_MANIFOLD,
                 {"vertex #" + std::to_string(pinched), "not manifold"});
}

TEST(Bad_input, components_that_touch_in_a_vertex_are_surfaces_of_their_own)
{
  // vertex 0 of the first octahedron and vertex 1 of the second are at (1, 0, 0), and made one
  const Mesh_data data = disjoint_union(octahedron(), octahedron(), {{2., 0., 0.}});
  Built built(data);
  const Mesh::Vertex_index kept = built.vertices[0], replaced = built.vertices[7];
  const std::vector<Mesh::Halfedge_index> around(CGAL::halfedges_around_target(replaced, built.mesh).begin(),
                                                 CGAL::halfedges_around_target(replaced, built.mesh).end());
  for(Mesh::Halfedge_index h : around)
    built.mesh.set_target(h, kept);
  built.mesh.remove_vertex(replaced);
  for(Triangle& t : built.data.triangles)
    for(std::size_t& v : t)
      v = v == 7 ? 0 : v;
  for(std::size_t f : {0, 15})
    for(std::size_t v : built.data.triangles[f])
    {
      const auto result = compute_cut_locus(built.mesh, built.vertices[v], mesh_edges);
      const std::size_t seed = v == 0 ? 0 : f; // the vertex itself belongs to the component that its halfedge is in
      EXPECT_EQ(fault_of(built, result, seed, {v}, Default_method()), "") << v;
      EXPECT_EQ(result.genus(), 0u);
    }
}

TEST(Bad_input, thresholds_that_are_not_in_their_range_are_refused)
{
  const Built built(octahedron());
  const auto expect = [&](const Method& method, const std::vector<std::string>& words)
  {
    Solver solver(built.mesh,
                  by(std::visit([](const auto& m) { return Method(std::decay_t<decltype(m)>()); }, method)));
    solver.set_source(built.vertices[0]);
    expect_refused([&] { solver.cut_locus(by(method)); }, Cause::INVALID_PARAMETER, words);
    EXPECT_EQ(message_of([&] { solver.cut_locus(); }), "nothing was thrown") << "the source was lost";
  };
  Solver solver(built.mesh);
  expect_refused([&] { solver.cut_locus(); }, Cause::NO_SOURCE, {"no source", "set_source()"});
  for(double angle : {not_a_number, -0.1, 3.15})
    expect(Laplacian_method().gradient_angle_threshold(angle), {"gradient angle", "from 0 to pi"});
  expect(Laplacian_method().laplacian_threshold(not_a_number), {"Laplacian", "not a number"});
  for(double length : {not_a_number, -1.})
  {
    expect(Laplacian_method().minimum_branch_length(length), {"minimum length", "not negative"});
    expect(Default_method().minimum_branch_length(length), {"minimum length", "not negative"});
  }
  expect(Laplacian_method().minimum_branch_edges(-1), {"minimum_branch_edges", "negative"});
  expect(Laplacian_method().number_of_iterations(-1), {"number_of_iterations", "negative"});
  expect(Laplacian_method().number_of_iterations(0), {"number_of_iterations", "Curve::MESH_EDGES"});
  expect(Default_method().minimum_branch_width(not_a_number), {"minimum width", "not negative"});
  expect(Default_method().minimum_branch_width(1.1), {"minimum width", "no larger than 1"});
  expect(Polyhedral_method().minimum_branch_gap(4.), {"minimum gap", "from 0 to pi"});
}

TEST(Bad_input, another_method_than_the_one_in_force_is_refused_with_what_to_do)
{
  const Built built(octahedron());
  const auto expect_other = [&](Solver& solver, const Method& other, const std::vector<std::string>& words)
  {
    solver.set_source(built.vertices[0]);
    expect_refused([&] { solver.cut_locus(by(other)); }, Cause::PARAMETER_OF_OTHER_METHOD, words);
    EXPECT_EQ(message_of([&] { solver.cut_locus(); }), "nothing was thrown") << "the source was lost";
  };
  Solver by_default(built.mesh), laplacian(built.mesh, by(Laplacian_method()));
  expect_other(by_default, Laplacian_method().gradient_angle_threshold(0.3),
               {"Cut_loci::Laplacian_method()", "Cut_loci::Default_method", "constructor"});
  expect_other(by_default, Polyhedral_method(), {"Cut_loci::Polyhedral_method()", "constructor"});
  expect_other(laplacian, Default_method().minimum_branch_width(0.1), {"Cut_loci::Default_method()", "constructor"});
  expect_other(laplacian, Laplacian_method().laplacian_operator(CGAL::Cut_loci::Laplacian_operator::COTANGENT),
               {"Laplacian operator", "constructor"});
}

TEST(Bad_input, options_of_the_constructor_are_those_of_each_cut_locus)
{
  const Built built(ellipsoid(1., 0.8, 0.6, 8, 0.2, 1));
  for(const Method& method :
      {Method(Default_method().minimum_branch_width(0.9)), Method(Laplacian_method().gradient_angle_threshold(3.1))})
  {
    Solver solver(built.mesh, by(method));
    solver.set_source(built.vertices[5]);
    const std::size_t few = num_edges(solver.cut_locus().graph());
    EXPECT_EQ(num_edges(compute_cut_locus(built.mesh, built.vertices[5], by(method)).graph()), few);
    const Method plain = std::visit([](const auto& m) { return Method(std::decay_t<decltype(m)>()); }, method);
    EXPECT_GT(num_edges(solver.cut_locus(by(plain)).graph()), few);
    EXPECT_EQ(num_edges(solver.cut_locus().graph()), few) << "it is not remembered";
  }
}

TEST(Bad_input, the_largest_minimum_number_of_edges_removes_more_than_any_smaller_one)
{
  const Built built(ellipsoid(1., 0.8, 0.6, 8, 0.2, 1));
  for(Method method : {Method(Laplacian_method()), Method(Default_method())})
  {
    Solver solver(built.mesh, by(method));
    solver.set_source(built.vertices[0]);
    for(const auto& np : {mesh_edges, through_faces})
    {
      const auto edges_left = [&](long minimum)
      {
        return num_edges(solver
                           .cut_locus(np.cut_locus_method(
                             std::visit([&](auto m) -> Method { return m.minimum_branch_edges(minimum); }, method)))
                           .graph());
      };
      EXPECT_LT(edges_left(1000), edges_left(0));
      EXPECT_EQ(edges_left(1L << 32), edges_left(1000));
      EXPECT_EQ(edges_left((std::numeric_limits<long>::max)()), edges_left(1000));
    }
  }
}

TEST(Bad_input, distances_that_are_none_are_refused_by_their_vertex)
{
  const Built built(octahedron());
  const std::string too_long = "longer than all edges together", none = "not a finite number";
  for(const auto& [bad, what] :
      {std::make_pair(not_a_number, none), {infinity, none}, {-1e-3, "negative"}, {1e38, too_long}, {1e300, too_long}})
  {
    auto distance = get(CGAL::dynamic_vertex_property_t<double>(), built.mesh);
    for(std::size_t v = 0; v < built.vertices.size(); ++v)
      put(distance, built.vertices[v], v == 4 ? bad : double(v));
    const auto np = params::vertex_distance_map(distance);
    expect_refused([&] { compute_cut_locus(built.mesh, built.vertices[0], np); }, Cause::INVALID_DISTANCE,
                   {"distance map", what, "vertex #4"});
  }
}

TEST(Bad_input, a_solver_can_be_used_again_after_it_has_refused_a_source)
{
  const Built built(octahedron());
  Solver solver(built.mesh);
  solver.set_source(built.vertices[0]);
  const auto edges_before = cut_of(built, solver.cut_locus(mesh_edges)).edges;
  EXPECT_THROW(solver.set_source(Built::Traits::null_vertex()), Invalid_input);
  solver.set_source(built.vertices[0]);
  EXPECT_EQ(cut_of(built, solver.cut_locus(mesh_edges)).edges, edges_before);
}

TEST(Odd_input, the_smallest_meshes_have_cut_loci)
{
  Mesh_data triangle;
  triangle.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}};
  triangle.triangles = {{{0, 1, 2}}};
  Mesh_data pillow = triangle; // two faces glued along all three edges
  pillow.triangles.push_back({{0, 2, 1}});
  for(const Mesh_data& data :
      {tetrahedron(), octahedron(), triangle, pillow, square(1), icosahedron(), box(1, 1, 1, 1)})
    expect_sound_from_everywhere(data);
}

TEST(Odd_input, needles_have_cut_loci)
{
  for(double length : {1e2, 1e4, 1e6})
  {
    Mesh_data needle = tetrahedron(), plate = jittered_sphere(4, 0.2, 1), strip = square(6, 0.2, 2);
    for(Point& p : needle.points)
      p[0] *= (std::min)(length, 1e5);
    for(Point& p : plate.points)
      p[2] /= length;
    for(Point& p : strip.points)
      p[1] *= length;
    // windows go around the needle as often as it is longer than wide, and take their time
    expect_sound_from_everywhere(needle, length > 1e4 ? 1 : 20);
    expect_sound_from_everywhere(plate);
    expect_sound_from_everywhere(strip);
  }
}

TEST(Odd_input, regular_meshes_where_all_distances_are_tied_have_cut_loci)
{
  for(const Mesh_data& data :
      {sphere(4), torus(1., 0.4, 16, 8), box(2, 2, 2, 2), square(6), capsule(1., 8, 8), cylinder(1., 8, 4, 0., 0)})
    expect_sound_from_everywhere(data);
}

TEST(Odd_input, a_spike_and_coordinates_far_from_the_origin_do_no_harm)
{
  Mesh_data spike = jittered_sphere(4, 0.2, 1);
  spike.points[3] = 1e4 * spike.points[3];
  Mesh_data far = jittered_sphere(4, 0.2, 1);
  for(Point& p : far.points)
    p = p + Point{{1e8, -1e8, 1e8}};
  expect_sound_from_everywhere(spike, 4); // the paths to its faces are that many
  expect_sound_from_everywhere(far);
}

TEST(Odd_input, units_of_any_size_do_no_harm)
{
  const Mesh_data sphere = jittered_sphere(4, 0.2, 1); // without ties, which rounding would decide
  const Built built(sphere);
  for(Method method : {Method(Laplacian_method()), Method(Default_method()), Method(Polyhedral_method())})
  {
    const auto np = by(method);
    const auto expected = compute_cut_locus(built.mesh, built.vertices[0], np.cut_locus_curve(Curve::MESH_EDGES));
    for(double scale : {1e-150, 1e-79, 1e-20, 1e38, 1e77, 1e150})
    {
      Mesh_data data = sphere;
      for(Point& p : data.points)
        p = scale * p;
      const Built scaled(data);
      const auto result = compute_cut_locus(scaled.mesh, scaled.vertices[0], np.cut_locus_curve(Curve::MESH_EDGES));
      EXPECT_EQ(num_edges(result.graph()), num_edges(expected.graph())) << scale;
      EXPECT_NEAR(result.distance(scaled.vertices[7]) / scale, expected.distance(built.vertices[7]), 1e-12) << scale;
    }
  }
}

} // namespace test_bad_input
