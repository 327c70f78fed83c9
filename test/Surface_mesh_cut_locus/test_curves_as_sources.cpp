// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "curve_sources_cases.h"
#include "detour.h"

#include <CGAL/Polygon_2.h>
#include <CGAL/create_straight_skeleton_2.h>

namespace test_curves_as_sources {

namespace {

using namespace curve_sources;

using namespace surface_test;
constexpr Method methods[] = {Default_method(), Polyhedral_method()};
constexpr Method all_methods[] = {Default_method(), Polyhedral_method(), Laplacian_method()};
// by which distances to an edge may be too short, in units of its length, and what moving its ends by 1e-5 adds
constexpr double accuracy = 1. / 65536. + 1e-4;

// -- closed forms ------------------------------------------------------------------------------------------------------

TEST(Curves_as_sources, the_border_of_a_rectangle_has_its_medial_axis)
{
  for(const double width : {1., 2., 3.7})
    for(const std::size_t n : {4, 9, 16})
      for(const double jitter : {0., 0.2})
      {
        const Built built(rectangle(width, n, jitter, 3));
        const Result result = of_border(built, Polyhedral_method());
        const double h = mean_edge_length(built.data);
        const auto& graph = result.graph();
        std::size_t number_of_inexact = 0;
        for(const auto v : CGAL::make_range(vertices(graph)))
        {
          const Point p = to_point(graph[v].point);
          EXPECT_NEAR(graph[v].distance, (std::min)({p[0], width - p[0], p[1], 1. - p[1]}), width / n);
          number_of_inexact += !(excess_of_second_side(p, width) <= accuracy * h * width);
        }
        EXPECT_EQ(number_of_inexact, 0u) << width << ' ' << n << ' ' << jitter;
        EXPECT_NEAR(length(result), width - 1. + 2. * std::sqrt(2.), 1e-3 * h) << width << ' ' << n << ' ' << jitter;
        EXPECT_EQ(number_of_leaves(result), 4u) << "the corners";
        expect_topology(built, border_loops(built), result, "rectangle");
      }
}

// of an annulus of `nr` rows of `nu` points
void close_hole(Mesh_data& m, std::size_t nu, std::size_t nr)
{
  m.points.push_back({{0., 0., 0.}});
  for(std::size_t u = 0; u < nu; ++u)
    m.triangles.push_back({{nr * nu + u, nr * nu + (u + 1) % nu, m.points.size() - 1}});
}

TEST(Curves_as_sources, the_border_of_a_convex_polygon_has_its_straight_skeleton)
{
  // a disk with straight sides: the vertices of each third of a ring are put on a chord
  for(const std::size_t sides : {3, 5, 8})
  {
    Mesh_data m = annulus(0.02, 1., 6 * sides, 9);
    close_hole(m, 6 * sides, 9);
    CGAL::Polygon_2<Kernel> polygon;
    const auto corner = [&](std::size_t i)
    {
      const double angle = 2. * pi * (double(i % sides) + 0.2 * std::sin(3. * double(i % sides))) / double(sides);
      return Point{{std::cos(angle), 0.8 * std::sin(angle), 0.}};
    };
    for(std::size_t i = 0; i < sides; ++i)
      polygon.push_back(Kernel::Point_2(corner(i)[0], corner(i)[1]));
    for(std::size_t k = 0; k <= 9; ++k)
      for(std::size_t u = 0; u < 6 * sides; ++u)
      {
        const double share = double(u % 6) / 6.;
        const Point side = (1. - share) * corner(u / 6) + share * corner(u / 6 + 1);
        const double r = norm(m.points[k * 6 * sides + u]);
        m.points[k * 6 * sides + u] = r * side + (1. - r) * (0.11 * r) * Point{{0.3, 0.7, 0.}};
      }
    const Built built(m);
    const Result result = of_border(built, Polyhedral_method());
    const auto skeleton = CGAL::create_interior_straight_skeleton_2(polygon.vertices_begin(), polygon.vertices_end());
    double expected = 0.;
    for(auto h = skeleton->halfedges_begin(); h != skeleton->halfedges_end(); ++h)
      if(h->is_bisector())
        expected += 0.5 * std::sqrt(CGAL::squared_distance(h->vertex()->point(), h->opposite()->vertex()->point()));
    EXPECT_NEAR(length(result), expected, 1e-3 * mean_edge_length(m)) << sides;
    EXPECT_EQ(number_of_leaves(result), sides);
    for(auto v = skeleton->vertices_begin(); v != skeleton->vertices_end(); ++v)
    {
      double nearest = 1.;
      for(const auto x : CGAL::make_range(vertices(result.graph())))
        nearest =
          (std::min)(nearest, norm(to_point(result.graph()[x].point) - Point{{v->point().x(), v->point().y(), 0.}}));
      EXPECT_LT(nearest, 1e-3 * mean_edge_length(m)) << sides;
    }
    expect_topology(built, border_loops(built), result, "polygon");
  }
}

TEST(Curves_as_sources, the_border_of_an_ellipse_has_a_segment_between_its_centers_of_curvature)
{
  constexpr double a = 1.5, b = 1.;
  double previous = 1.;
  for(const std::size_t n : {16, 32, 64})
  {
    Mesh_data m = annulus(1. / double(n), 1., 6 * n, n);
    close_hole(m, 6 * n, n);
    for(Point& p : m.points)
      p = {{a * p[0] + 0.003 * p[1] * p[0], b * p[1], 0.}};
    for(std::size_t u = 0; u < 6 * n; ++u) // the border is the ellipse
      m.points[u] = {{a * std::cos(pi * double(u) / double(3 * n)), b * std::sin(pi * double(u) / double(3 * n)), 0.}};
    const Built built(m);
    const Result result = of_border(built, Default_method());
    double off = 0., low = 1., high = -1.;
    for(const auto v : CGAL::make_range(vertices(result.graph())))
    {
      const Point p = to_point(result.graph()[v].point);
      off = (std::max)(off, std::fabs(p[1]));
      low = (std::min)(low, p[0]);
      high = (std::max)(high, p[0]);
    }
    const double end = (a * a - b * b) / a, h = pi / double(3 * n);
    EXPECT_LT(off, 0.5 * h) << n;
    // the tips are cut where paths are three edges apart
    const double error = (std::max)(std::fabs(high - end), std::fabs(low + end));
    EXPECT_LT(error, previous) << n;
    EXPECT_LT(error, 0.2) << n;
    previous = error;
    expect_topology(built, border_loops(built), result, "ellipse");
  }
}

// Both borders are polygons: what is between them is off by no more than their corners.
TEST(Curves_as_sources, the_borders_of_a_ring_have_the_circle_between_them)
{
  for(const std::size_t nu : {12, 60, 91})
    for(const std::size_t nr : {4, 12, 13}) // with the circle along edges, or not
      for(const Method method : {Method(Default_method()), Method(Polyhedral_method())})
      {
        SCOPED_TRACE(testing::Message() << nu << " by " << nr
                                        << (std::holds_alternative<Default_method>(method) ? "" : ", polyhedral"));
        const Built built(annulus(0.5, 1.5, nu, nr));
        const Result result = of_border(built, method);
        EXPECT_EQ(result.number_of_sources(), 2u);
        const double sagitta = 1.5 * (1. - std::cos(pi / double(nu)));
        const auto& graph = result.graph();
        for(const auto e : CGAL::make_range(edges(graph)))
        {
          const bool is_between = graph[e].sources == (std::array<std::size_t, 2>{{0, 1}});
          EXPECT_TRUE(is_between || std::holds_alternative<Polyhedral_method>(method))
            << "the corners have branches, too";
          for(const auto v : {source(e, graph), target(e, graph)})
            if(is_between)
            {
              EXPECT_NEAR(norm(to_point(graph[v].point)), 1., sagitta);
              EXPECT_NEAR(graph[v].distance, 0.5, sagitta);
            }
        }
        expect_topology(built, border_loops(built), result, "ring");
      }
}

TEST(Curves_as_sources, parallel_lines_on_a_cylinder_have_the_lines_between_them)
{
  constexpr std::size_t nu = 24, nz = 10;
  const Built built(cylinder(2., nu, nz, 0., 0));
  std::vector<Edges> lines;
  for(const std::size_t u : {2, 11})
  {
    std::vector<std::size_t> along;
    for(std::size_t k = 0; k <= nz; ++k)
      along.push_back(k * nu + u);
    lines.push_back(path(built, along));
  }
  for(const Method method : methods)
  {
    const Result result = of_curves(built, {}, lines, method);
    EXPECT_NEAR(length(result), 2. * 2., 1e-3);
    const auto& graph = result.graph();
    for(const auto v : CGAL::make_range(vertices(graph)))
    {
      // in units of the sides of the prism; between two vertices of it the middle of a chord
      const double u = std::fmod(std::atan2(graph[v].point.y(), graph[v].point.x()) * nu / (2. * pi) + nu, double(nu));
      EXPECT_LT((std::min)(std::fabs(u - 6.5), std::fabs(u - 18.5)), 1e-3) << u;
    }
    for(const auto e : CGAL::make_range(edges(graph)))
      EXPECT_EQ(graph[e].sources, (std::array<std::size_t, 2>{{0, 1}}));
    expect_topology(built, lines, result, "lines");
  }
}

TEST(Curves_as_sources, a_circle_on_a_sphere_has_its_two_centers)
{
  for(const std::size_t n : {16, 32, 64})
  {
    const Built built(sphere_with_circle(2 * n, n));
    const std::vector<Edges> curves = {path(built, circle(2 * n, n / 4, 0, 2 * n))};
    const Result result = of_curves(built, {}, curves, Default_method());
    expect_topology(built, curves, result, "circle");
    double off = 0.;
    bool has_north = false, has_south = false;
    for(const auto v : CGAL::make_range(vertices(result.graph())))
    {
      const Point p = to_point(result.graph()[v].point);
      off = (std::max)(off, std::hypot(p[0], p[1]));
      (p[2] > 0. ? has_north : has_south) = true;
      EXPECT_NEAR(result.graph()[v].distance, p[2] > 0. ? 0.25 * pi : 0.75 * pi, off + 2. / double(n));
    }
    EXPECT_TRUE(has_north && has_south) << n;
    EXPECT_LT(off, 0.01 / double(n)) << "all of the circle is at the same distance from the center";
  }
}

// -- invariants --------------------------------------------------------------------------------------------------------

TEST(Curves_as_sources, leave_what_shrinks_to_the_curve)
{
  for(std::size_t i = 0; i < surfaces().size(); ++i)
  {
    const Built built(surfaces()[i]);
    for(const std::size_t k : {1, 2, 5})
      for(const Method method : methods)
      {
        const std::vector<Edges> curves = random_curves(built, k, 5, unsigned(10 * i + k));
        const std::string what =
          "surface " + std::to_string(i) + ", " + std::to_string(k) + " curves, " + name_of(method);
        expect_topology(built, curves, of_curves(built, {}, curves, method), what);
      }
  }
}

TEST(Curves_as_sources, leave_a_point_where_all_branches_are_weak)
{
  const Built built(sphere_with_circle(24, 12));
  Edges triangle;
  for(const Mesh::Halfedge_index h : built.mesh.halfedges_around_face(built.mesh.halfedge(built.faces[100])))
    triangle.push_back(built.mesh.edge(h));
  const Result result = of_curves(built, {}, {triangle}, Default_method());
  std::size_t number_inside = 0;
  for(const auto v : CGAL::make_range(vertices(result.graph())))
    number_inside += result.graph()[v].location.first == built.faces[100];
  EXPECT_EQ(number_inside, 1u);
  expect_topology(built, {triangle}, result, "a triangle");
}

// The distance to a curve from that to points of it which are no farther apart than s: too long by s / 2 at most.
TEST(Curves_as_sources, have_the_distances_and_cells_that_points_on_them_say)
{
  const std::vector<Mesh_data> surfaces = {ellipsoid(1., 0.8, 0.6, 10, 0.2, 1), torus(1., 0.4, 28, 14, 0.2, 2),
                                           saddle(12, 0.6, 0.2, 5)};
  constexpr std::size_t parts = 16;
  for(std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const Built built(surfaces[i]);
    const std::vector<Edges> curves = random_curves(built, 3, 4, unsigned(i));
    const Result result = of_curves(built, {}, curves, Default_method());
    Geodesics exact(built.mesh);
    std::vector<std::vector<double>> sampled;
    double longest = 0.;
    for(const Edges& curve : curves)
    {
      exact.clear_sources();
      for(const Mesh::Edge_index e : curve)
        for(std::size_t part = 0; part <= parts; ++part)
        {
          const double s = double(part) / double(parts);
          Mesh::Halfedge_index h = built.mesh.halfedge(e, 0);
          h = built.mesh.is_border(h) ? built.mesh.opposite(h) : h;
          longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(built.mesh.point(built.mesh.source(h)),
                                                                         built.mesh.point(built.mesh.target(h)))));
          Solver::Face_location at = {built.mesh.face(h), {{0., 0., 0.}}};
          Mesh::Halfedge_index g = built.mesh.halfedge(at.first);
          for(std::size_t k = 0; k < 3; ++k, g = built.mesh.next(g))
            at.second[k] = g == h ? 1. - s : g == built.mesh.next(h) ? s : 0.;
          exact.add_source(at);
        }
      exact.compute();
      sampled.emplace_back();
      for(const Mesh::Vertex_index v : built.vertices)
        sampled.back().push_back(exact.distance(v));
    }
    const double half = 0.5 * longest / parts, error = accuracy * longest;
    for(std::size_t v = 0; v < built.vertices.size(); ++v)
    {
      double least = sampled[0][v];
      for(const auto& d : sampled)
        least = (std::min)(least, d[v]);
      const double d = result.distance(built.vertices[v]);
      ASSERT_LE(d, least + error) << i;
      ASSERT_GE(d, least - half - error) << i;
      ASSERT_LE(sampled[*result.nearest_source(built.vertices[v])][v], d + half + error) << i;
    }
  }
}

TEST(Curves_as_sources, and_points_mix_with_the_points_first)
{
  const Built built(square(12, 0.2, 4));
  const std::vector<Edges> border = border_loops(built);
  const std::size_t center = nearest_vertex(built.data, {{0.5, 0.5, 0.}});
  const Point c = built.data.points[center];
  for(const Method method : methods)
  {
    const Result result = of_curves(built, {built.vertices[center]}, border, method);
    EXPECT_EQ(result.number_of_sources(), 2u);
    EXPECT_EQ(result.source(0).mesh_vertex, built.vertices[center]);
    EXPECT_EQ(*result.nearest_source(built.vertices[center]), 0u);
    EXPECT_EQ(*result.nearest_source(built.vertices[0]), 1u);
    const auto& graph = result.graph();
    for(const auto e : CGAL::make_range(edges(graph)))
      for(const auto v : {source(e, graph), target(e, graph)})
      {
        const Point p = to_point(graph[v].point);
        const double d = (std::min)({p[0], 1. - p[0], p[1], 1. - p[1]});
        if(graph[e].sources[0] == graph[e].sources[1])
          continue;
        EXPECT_NEAR(norm(p - c), d, 4e-4 * mean_edge_length(built.data)) << "four parabolas";
      }
    expect_topology(built, border, result, name_of(method));
    const auto part = [&](Kept_part kept)
    {
      return compute_cut_locus(built.mesh, Vertices{built.vertices[center]},
                               params::source_border(true).cut_locus_method(method).kept_part(kept));
    };
    const Result diagram = part(Kept_part::VORONOI), rest = part(Kept_part::MEDIAL);
    for(const auto e : CGAL::make_range(edges(diagram.graph())))
      EXPECT_NE(diagram.graph()[e].sources[0], diagram.graph()[e].sources[1]);
    for(const auto v : CGAL::make_range(vertices(diagram.graph())))
      EXPECT_EQ(degree(v, diagram.graph()), 2u) << "the corners are branches in the cell of the border";

    for(const auto e : CGAL::make_range(edges(rest.graph())))
      EXPECT_EQ(rest.graph()[e].sources[0], rest.graph()[e].sources[1]);
    EXPECT_EQ(num_edges(diagram.graph()) + num_edges(rest.graph()), num_edges(graph));
  }
}

// -- edges of the mesh -------------------------------------------------------------------------------------------------

TEST(Mesh_edges_beside_curves, leave_what_shrinks_to_the_curve)
{
  std::size_t number_of_refused = 0, number = 0;
  for(std::size_t i = 0; i < surfaces().size(); ++i)
  {
    const Built built(surfaces()[i]);
    for(const std::size_t k : {1, 2, 5})
      for(unsigned seed = 0; seed < 3; ++seed)
        for(const Method method : methods)
        {
          const std::vector<Edges> curves = random_curves(built, k, 5, unsigned(10 * i + k + 100 * seed));
          const std::string what =
            "surface " + std::to_string(i) + ", " + std::to_string(k) + " curves, " + name_of(method);
          ++number;
          number_of_refused += !has_mesh_edges(built, {}, curves, method, what);
        }
  }
  EXPECT_LE(number_of_refused, number / 4) << "where a curve coils up, there are corridors without a vertex";
}

// a curve of mesh edges is there, and the one through the faces
void expect_both_curves(const Built& built, const Vertices& points, const std::vector<Edges>& curves, Method method)
{
  EXPECT_TRUE(has_mesh_edges(built, points, curves, method, name_of(method)));
  expect_topology(built, curves, of_curves(built, points, curves, method), name_of(method));
}

TEST(Mesh_edges_beside_curves, may_be_beside_loops_and_the_border)
{
  const std::size_t nu = 28, nw = 14;
  const Built built(torus(1., 0.4, nu, nw)), ball(sphere_with_circle(24, 12)), plate(square(12, 0.2, 4));
  ASSERT_NE(built.mesh.halfedge(built.vertices[0], built.vertices[1]), Mesh::null_halfedge());
  ASSERT_NE(built.mesh.halfedge(built.vertices[0], built.vertices[nw]), Mesh::null_halfedge());
  const Vertices center = {plate.vertices[nearest_vertex(plate.data, {{0.5, 0.5, 0.}})]};
  for(const Method method : all_methods)
  {
    for(const std::vector<Edges>& curves : curves_of_torus(built, nu, nw))
      expect_both_curves(built, {}, curves, method);
    expect_both_curves(ball, {}, {path(ball, circle(24, 3, 0, 24)), path(ball, circle(24, 8, 0, 24))}, method);
    for(const Mesh_data& data :
        {square(7, 0.2, 1), cylinder(1., 14, 5, 0.1, 4), annulus(0.5, 1.5, 24, 6), square_with_holes(2, 4),
         punctured(torus(1., 0.4, 30, 16, 0.1, 2), {{{1.4, 0., 0.}}, {{-1., 0., 0.4}}}, 0.25)})
    {
      const Built with_border(data);
      expect_both_curves(with_border, {}, border_loops(with_border), method);
    }
    expect_both_curves(plate, center, border_loops(plate), method);
  }
}

TEST(Mesh_edges_beside_curves, may_be_beside_curves_that_touch_the_border)
{
  for(const Method method : all_methods)
  {
    std::size_t number_of_refused = 0, number = 0;
    for(const Mesh_data& data : {square(14, 0.2, 6), cylinder(2., 24, 12, 0.2, 7), annulus(0.5, 1.5, 40, 12)})
    {
      const Built built(data);
      for(unsigned seed = 0; seed < 8; ++seed)
      {
        const std::vector<Edges> curves = curves_at_border(built, 3, 6, seed);
        const std::string what = "seed " + std::to_string(seed) + ", " + name_of(method);
        const bool is_there = has_mesh_edges(built, {}, curves, method, what);
        ++number;
        number_of_refused += !is_there;
        // LAPLACIAN starts with edges of the mesh
        if(is_there || !std::holds_alternative<Laplacian_method>(method))
          expect_topology(built, curves, of_curves(built, {}, curves, method), what);
      }
    }
    EXPECT_LE(number_of_refused, number / 4) << "where a curve runs beside the border";
  }
}

TEST(Mesh_edges_beside_curves, are_between_two_sides_of_a_rectangle)
{
  const std::size_t n = 12;
  const Built built(rectangle(2., n, 0., 1));
  const std::vector<Edges> sides = {side_of_square(built, n, true), side_of_square(built, n, false)};
  for(const Method method : all_methods)
  {
    ASSERT_TRUE(has_mesh_edges(built, {}, sides, method, "sides"));
    EXPECT_EQ(num_edges(of_curves(built, {}, sides, method, Curve::MESH_EDGES).graph()), n) << "a line";
    for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      const Result result = of_curves(built, {}, sides, method, curve);
      expect_topology(built, sides, result, "sides");
      EXPECT_NEAR(length(result), 2., 1e-6);
      for(const auto v : CGAL::make_range(vertices(result.graph())))
        EXPECT_NEAR(result.graph()[v].point.y(), 0.5, curve == Curve::MESH_EDGES ? 1e-9 : 1e-6);
    }
  }
}

TEST(Mesh_edges_beside_curves, name_the_sources_that_are_one_edge_apart)
{
  const std::size_t n = 12;
  const Built built(rectangle(2., n, 0., 1));
  const auto at = [&](double i, double j) {
    return nearest_vertex(built.data, {{2. * i / double(n), j / double(n), 0.}});
  };
  const Edges left = path(built, {at(3, 0), at(4, 0), at(5, 0)}), right = path(built, {at(6, 0), at(7, 0)});
  const Edges around = path(built, {at(5, 0), at(5, 1), at(6, 1), at(6, 0)});
  const Edges elsewhere = path(built, {at(3, 6), at(4, 6)});
  const std::vector<std::pair<std::vector<Edges>, std::string>> cases = {
    {{left, right}, "sources 0 and 1 are"},
    {{elsewhere, left, right}, "sources 1 and 2 are"},
    {{elsewhere, around}, "two ends of source 1 are"}};
  for(const Method method : all_methods)
    for(const auto& c : cases)
      expect_refused([&] { of_curves(built, {}, c.first, method, Curve::MESH_EDGES); }, Cause::NO_FACE_AT_SOURCE,
                     {c.second, "Curve::THROUGH_FACES"});
}

TEST(Mesh_edges_beside_curves, follow_the_medial_axis_of_a_rectangle)
{
  for(const std::size_t n : {9, 16, 32})
    for(const double width : {1., 2.})
      for(const Method method : methods)
      {
        const Built built(rectangle(width, n, 0.2, 3));
        const Result result = of_border(built, method, Curve::MESH_EDGES);
        EXPECT_LT(measured(built.mesh, result, border_loops(built)).max, 0.05) << n << ' ' << width;
        EXPECT_EQ(result.number_of_narrow_corridors(), 0u);
        EXPECT_GT(num_edges(result.graph()), 0u);
        for(const auto v : CGAL::make_range(vertices(result.graph())))
          // the axis passes the faces at the vertex: so two sides are as near, up to twice the way to it
          EXPECT_LT(excess_of_second_side(to_point(result.graph()[v].point), width), 2. * width / double(n))
            << n << ' ' << width;
      }
}

TEST(Mesh_edges_beside_curves, are_the_centers_of_a_circle_on_a_sphere)
{
  for(const std::size_t n : {16, 32})
    for(const Method method : {Method(Default_method()), Method(Laplacian_method())})
    {
      const Built built(sphere_with_circle(2 * n, n));
      const std::vector<Edges> curves = {path(built, circle(2 * n, n / 4, 0, 2 * n))};
      const Result result = of_curves(built, {}, curves, method, Curve::MESH_EDGES);
      EXPECT_EQ(num_edges(result.graph()), 0u);
      ASSERT_EQ(num_vertices(result.graph()), 2u);
      for(const auto v : CGAL::make_range(vertices(result.graph())))
        EXPECT_EQ(std::fabs(result.graph()[v].point.z()), 1.) << "a pole";
      EXPECT_LT(measured(built.mesh, result, curves).max, 1e-6);
    }
}

// All of an arc of the equator is at the same distance from the poles, and its ends are from the meridian opposite to its
// middle, which the cut locus is.
TEST(Mesh_edges_beside_curves, follow_a_meridian_opposite_to_an_arc_on_a_sphere)
{
  for(const std::size_t n : {16, 32})
  {
    const Built built(sphere_with_circle(2 * n, n));
    const std::vector<Edges> curves = {path(built, circle(2 * n, n / 2, 0, n / 2))};
    const Result result = compute_cut_locus(built.mesh, Vertices(), mesh_edges.source_curves(curves));
    EXPECT_EQ(num_edges(result.graph()), n) << "from pole to pole";
    const Point from = built.data.points[circle(2 * n, n / 2, 0, 0)[0]];
    const double middle = std::atan2(from[1], from[0]) + 0.25 * pi;
    for(const auto v : CGAL::make_range(vertices(result.graph())))
    {
      const Point p = to_point(result.graph()[v].point);
      EXPECT_LT(std::fabs(p[0] * std::sin(middle) - p[1] * std::cos(middle)), pi / double(n)) << n;
      EXPECT_LT(p[0] * std::cos(middle) + p[1] * std::sin(middle), 1e-9) << n;
    }
    EXPECT_LT(measured(built.mesh, result, curves).max, 1e-6);
  }
}

TEST(Mesh_edges_beside_curves, have_the_parts_that_are_asked_for)
{
  const Built built(square_with_holes(2, 6));
  Solver solver(built.mesh);
  solver.set_sources(Vertices(), params::source_border(true));
  const Result all = solver.cut_locus(mesh_edges), voronoi = solver.cut_locus(mesh_edges.kept_part(Kept_part::VORONOI)),
               medial = solver.cut_locus(mesh_edges.kept_part(Kept_part::MEDIAL));
  EXPECT_GT(num_edges(voronoi.graph()), 0u);
  EXPECT_EQ(num_edges(voronoi.graph()) + num_edges(medial.graph()), num_edges(all.graph()));
  for(const auto e : CGAL::make_range(edges(voronoi.graph())))
    EXPECT_NE(voronoi.graph()[e].sources[0], voronoi.graph()[e].sources[1]);
  std::map<Mesh::Edge_index, bool> marks;
  solver.cut_locus(mesh_edges.edge_is_constrained_map(boost::make_assoc_property_map(marks)));
  EXPECT_EQ(marks.size(), num_edges(all.graph()));
}

TEST(Mesh_edges_beside_curves, are_refused_where_there_is_no_way)
{
  // two lines one face apart all around a cylinder
  const std::size_t nu = 14;
  const Built built(cylinder(1., nu, 5, 0., 0));
  std::vector<Edges> lines;
  for(const std::size_t k : {2, 3})
  {
    std::vector<std::size_t> along;
    for(std::size_t u = 0; u <= nu; ++u)
      along.push_back(k * nu + u % nu);
    lines.push_back(path(built, along));
  }
  EXPECT_FALSE(has_mesh_edges(built, {}, lines, Default_method(), "lines"));
}

// -- the interface -----------------------------------------------------------------------------------------------------

TEST(Curves_as_sources, that_can_not_be_used_are_refused)
{
  const Built built(square(6));
  const Edges first = path(built, {8, 9, 10}), second = path(built, {10, 11}), apart = path(built, {22, 23});
  Edges parts = first;
  parts.insert(parts.end(), apart.begin(), apart.end());
  const auto compute = [&](const Vertices& points, const std::vector<Edges>& curves)
  { of_curves(built, points, curves, Default_method()); };
  expect_refused(
    [&] {
    compute({}, {first, second});
    },
    Cause::SAME_SOURCES, {"sources 0 and 1 have a vertex in common"});
  expect_refused([&] { compute({built.vertices[9]}, {first}); }, Cause::SAME_SOURCES,
                 {"sources 0 and 1 have a point in common"});
  expect_refused([&] { compute({}, {first, Edges()}); }, Cause::NO_SOURCE, {"source curve 1: it has no edges"});
  expect_refused([&] { compute({}, {parts}); }, Cause::INVALID_SOURCE, {"source curve 0: it is not connected"});
  expect_refused([&] { compute({}, {}); }, Cause::NO_SOURCE, {"the range of sources is empty"});
  expect_refused([&] { compute_cut_locus(Built(sphere(4)).mesh, Vertices(), params::source_border(true)); },
                 Cause::NO_SOURCE, {"no border"});
  Solver solver(built.mesh);
  expect_refused(
    [&]
    { solver.set_sources(Vertices(), params::source_curves(std::vector<Edges>{first}).maximum_relative_error(0.01)); },
    Cause::INVALID_PARAMETER, {"exact distances"});
  solver.set_sources(Vertices(), params::source_curves(std::vector<Edges>{first}));
  EXPECT_NO_THROW(solver.cut_locus(mesh_edges.cut_locus_method(Default_method().minimum_branch_edges(3))));
  expect_refused([&] { solver.cut_locus(by(Default_method().minimum_branch_edges(3))); }, Cause::INVALID_PARAMETER,
                 {"minimum_branch_edges"});
}

TEST(Curves_as_sources, are_forgotten_by_the_next_source)
{
  const Built built(square(10, 0.2, 1));
  Solver solver(built.mesh, by(Polyhedral_method()));
  const Vertices two = {built.vertices[12], built.vertices[80]};
  solver.set_sources(two);
  const double alone = length(solver.cut_locus());
  solver.set_sources(two, params::source_border(true));
  EXPECT_GT(length(solver.cut_locus()), 1.5 * alone);
  solver.set_sources(two);
  EXPECT_EQ(length(solver.cut_locus()), alone);
}

} // namespace

} // namespace test_curves_as_sources
