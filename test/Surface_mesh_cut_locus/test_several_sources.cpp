// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "several_sources_cases.h"

#include <CGAL/cut_along_cut_locus.h>

#include <optional>

namespace test_several_sources {

namespace {

using namespace several_sources;

using namespace surface_test;
constexpr Method methods[] = {Default_method(), Polyhedral_method()};

// distances, cells and labels against runs with one source each
void expect_voronoi_diagram(const Built& built, const std::vector<Source>& sources, const Result& result,
                            const std::string& what)
{
  const Distances d(built, sources, result);
  // lengths may have been changed by some millionths, and a curve leaves the cut locus by 1e-4 edges
  const double exact = 1e-9 * diagonal(built), drawn = 4e-4 * mean_edge_length(built.data);
  for(std::size_t v = 0; v < built.vertices.size(); ++v)
  {
    ASSERT_NEAR(result.distance(built.vertices[v]), Distances::least(d.to_vertex, v), exact) << what;
    ASSERT_TRUE(result.nearest_source(built.vertices[v]).has_value()) << what;
    ASSERT_NEAR(d.to_vertex[*result.nearest_source(built.vertices[v])][v], Distances::least(d.to_vertex, v), exact)
      << what;
  }
  // In a few faces, at symmetric places, labels do not fit each other: the curve is good to the size of the face there.
  const auto& graph = result.graph();
  std::size_t number_of_inexact = 0;
  for(const auto e : CGAL::make_range(edges(graph)))
    for(const std::size_t node : {source(e, graph), target(e, graph)})
      for(const std::size_t s : graph[e].sources)
      {
        const double excess = d.to_node[s][node] - Distances::least(d.to_node, node);
        number_of_inexact += !(excess <= drawn);
        ASSERT_LE(excess, mean_edge_length(built.data)) << what;
      }
  EXPECT_LE(number_of_inexact, 4 * num_edges(graph) / 30) << what << ", of " << 4 * num_edges(graph) << " labels";
}

// Two sources may lie on too few faces for a curve of mesh edges. That is said, and there is no other reason to refuse.
void expect_valid_mesh_edges(const Built& built, const Solver& solver, const std::string& what)
{
  try
  {
    EXPECT_EQ(fault_of_mesh_edges(built, solver.cut_locus(mesh_edges)), "") << what;
  }
  catch(const Invalid_input& error)
  {
    EXPECT_NE(std::string(error.what()).find("has no face to itself"), std::string::npos) << what;
  }
}

void expect_all(const Built& built, const std::vector<Source>& sources, Method method, const std::string& what)
{
  Solver solver(built.mesh, by(method));
  solver.set_sources(sources);
  const Result curve = solver.cut_locus(through_faces);
  ASSERT_EQ(curve.number_of_sources(), sources.size()) << what;
  EXPECT_EQ(fault_through_faces(built, curve), "") << what;
  expect_valid_mesh_edges(built, solver, what);
  expect_voronoi_diagram(built, sources, curve, what);
  for(const auto e : CGAL::make_range(edges(curve.graph())))
  {
    ASSERT_TRUE(std::isfinite(curve.graph()[e].strength) && curve.graph()[e].strength <= 2. * pi + 1e-6) << what;
    ASSERT_TRUE(curve.graph()[e].width < 1e3 * diagonal(built)) << what;
  }
}

TEST(Several_sources, have_one_disk_each_and_the_cells_that_single_sources_say)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    unsigned seed = 0;
    for(const std::size_t k : {1, 2, 5, 30})
      for(const Method method : methods)
        expect_all(built, random_sources(built, k, ++seed), method,
                   m.name + ", " + name_of(method) + ", " + std::to_string(k) + " sources");
  }
}

TEST(Several_sources, may_be_a_hundred_in_any_place)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    expect_all(built, random_sources(built, 100, 7), Default_method(), m.name + ", 100 sources");
  }
}

// -- places where rules could end --------------------------------------------------------------------------------------

TEST(Several_sources, may_be_as_close_as_the_mesh_has_places)
{
  std::vector<Named_mesh> all = meshes();
  all.push_back({"plate of cubes", plate_with_holes(3, 1, 1)});
  for(const Named_mesh& m : all)
  {
    const Built built(m.data);
    for(const Named_sources& c : close_sources(built))
      for(const Method method : methods)
        expect_all(built, c.sources, method, m.name + ", " + name_of(method) + ", " + c.name);
  }
}

TEST(Several_sources, may_be_on_the_border)
{
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    std::vector<Source> sources;
    for(const Mesh::Halfedge_index h : built.mesh.halfedges())
      if(built.mesh.is_border(h) && sources.size() < 12)
      {
        const Mesh::Halfedge_index o = built.mesh.opposite(h);
        std::array<double, 3> c = {{0., 0., 0.}};
        Mesh::Halfedge_index g = built.mesh.halfedge(built.mesh.face(o));
        for(std::size_t k = 0; k < 3; ++k, g = built.mesh.next(g))
          c[k] = g == o ? 0.3 : g == built.mesh.next(o) ? 0.7 : 0.;
        if(sources.size() % 3 == 0)
          sources.push_back(Location(built.mesh.face(o), c));
        else
          sources.push_back(built.mesh.source(h));
      }
    if(!sources.empty())
      for(const Method method : methods)
        expect_all(built, sources, method, m.name + ", " + name_of(method));
  }
}

TEST(Several_sources, may_be_all_vertices)
{
  for(const Mesh_data& data : {icosahedron(), cube(2), square(4)})
  {
    const Built built(data);
    const std::vector<Source> sources(built.vertices.begin(), built.vertices.end());
    for(const Method method : methods)
      expect_all(built, sources, method, name_of(method));
  }
}

TEST(Several_sources, in_symmetric_places_have_one_disk_each)
{
  const Built holes(square_with_holes(1, 3)), box(cuboid({{2., 1., 1.}}, 2)), ring(annulus(0.4, 1., 16, 3));
  for(const Built* built : {&holes, &box, &ring})
    for(const Method method : methods)
    {
      const std::size_t n = built->vertices.size();
      Solver solver(built->mesh, by(method));
      for(const auto& pair : {std::make_pair(std::size_t(0), n - 1), std::make_pair(n / 4, 3 * n / 4)})
      {
        solver.set_sources(std::vector<Source>{built->vertices[pair.first], built->vertices[pair.second]});
        EXPECT_EQ(fault_through_faces(*built, solver.cut_locus(through_faces)), "");
        expect_valid_mesh_edges(*built, solver, name_of(method));
      }
    }
}

// Three edges of the diagram come to a vertex within rounding, and are none of each other's.
TEST(Several_sources, nearly_in_symmetric_places_have_one_disk_each)
{
  const Built octahedron(surface_test::octahedron());
  for(unsigned seed = 0; seed < 1500; ++seed)
  {
    std::mt19937 engine(seed);
    const double size = std::pow(10., -10. + 4. * random_unit(engine)), shift = random_unit(engine);
    std::vector<Source> sources;
    for(const std::size_t f : {0, 1, 2, 3}) // around a vertex
      if(f != seed % 5)
      {
        std::array<double, 3> c = {{0.25 + 0.1 * shift, 0.35 - 0.1 * shift, 0.}};
        for(double& x : c)
          x += size * random_unit(engine);
        c[2] = 1. - c[0] - c[1];
        sources.push_back(Location(octahedron.faces[f], c));
      }
    for(const Method method : methods)
    {
      Solver solver(octahedron.mesh, by(method));
      solver.set_sources(sources);
      EXPECT_EQ(fault_through_faces(octahedron, solver.cut_locus(through_faces)), "")
        << name_of(method) << ", seed " << seed;
    }
  }
}

// -- closed forms ------------------------------------------------------------------------------------------------------

// the points of the Voronoi diagram, each with the sources beside it
std::vector<std::pair<Point, std::array<std::size_t, 2>>> voronoi_points(const Result& result)
{
  std::vector<std::pair<Point, std::array<std::size_t, 2>>> points;
  const auto& graph = result.graph();
  for(const auto e : CGAL::make_range(edges(graph)))
    if(graph[e].sources[0] != graph[e].sources[1])
      for(const auto v : {source(e, graph), target(e, graph)})
        points.push_back({{{graph[v].point.x(), graph[v].point.y(), graph[v].point.z()}}, graph[e].sources});
  return points;
}

TEST(Several_sources, have_a_straight_bisector_on_a_plate)
{
  const Built built(square(9, 0.2, 5));
  for(const Method method : methods)
  {
    const std::size_t a = nearest_vertex(built.data, {{0.2, 0.3, 0.}}),
                      b = nearest_vertex(built.data, {{0.7, 0.6, 0.}});
    Solver solver(built.mesh, by(method));
    solver.set_sources(Vertices{built.vertices[a], built.vertices[b]});
    const Result result = solver.cut_locus(through_faces);
    const Point p = built.data.points[a], q = built.data.points[b];
    const auto points = voronoi_points(result);
    ASSERT_FALSE(points.empty());
    for(const auto& x : points)
      EXPECT_NEAR(norm(x.first - p), norm(x.first - q), 1e-9);
    EXPECT_EQ(num_edges(result.graph()), points.size() / 2) << "a plate has no other cut locus";
    // from the side y = 0 or x = 1 to the side y = 1 or x = 0
    const Point m = 0.5 * (p + q), d = {{q[1] - p[1], p[0] - q[0], 0.}};
    double low = -1e9, high = 1e9;
    for(std::size_t i = 0; i < 2; ++i)
    {
      low = (std::max)(low, (std::min)(-m[i] / d[i], (1. - m[i]) / d[i]));
      high = (std::min)(high, (std::max)(-m[i] / d[i], (1. - m[i]) / d[i]));
    }
    EXPECT_NEAR(length(result), (high - low) * norm(d), 1e-9);
  }
}

// of the unit square with two sides, unrolled over each of its edges
double distance_on_doubly_covered_square(const Point& source, const Point& p, bool is_other_side)
{
  if(!is_other_side)
    return norm(p - source);
  return (std::min)({norm(Point{{-p[0], p[1], 0.}} - source), norm(Point{{2. - p[0], p[1], 0.}} - source),
                     norm(Point{{p[0], -p[1], 0.}} - source), norm(Point{{p[0], 2. - p[1], 0.}} - source)});
}

TEST(Several_sources, have_the_known_diagram_on_a_doubly_covered_square)
{
  const Mesh_data front = square(8), data = doubly_covered(front);
  const Built built(data);
  std::vector<Source> sources;
  std::vector<Point> points;
  for(const Point& p : {Point{{0.25, 0.31, 0.}}, Point{{0.6, 0.7, 0.}}, Point{{0.8, 0.2, 0.}}})
  {
    const std::size_t v = nearest_vertex(front, p);
    sources.push_back(built.vertices[v]);
    points.push_back(data.points[v]);
  }
  for(const Method method : methods)
  {
    Solver solver(built.mesh, by(method));
    solver.set_sources(sources);
    const Result result = solver.cut_locus(through_faces);
    const auto& graph = result.graph();
    std::size_t number_on_back = 0;
    for(const auto e : CGAL::make_range(edges(graph)))
      for(const auto v : {source(e, graph), target(e, graph)})
      {
        const bool is_back = std::size_t(graph[v].location.first) >= front.triangles.size();
        number_on_back += is_back;
        const Point x = {{graph[v].point.x(), graph[v].point.y(), 0.}};
        std::vector<double> d;
        for(const Point& s : points)
          d.push_back(distance_on_doubly_covered_square(s, x, is_back));
        for(const std::size_t s : graph[e].sources)
          EXPECT_NEAR(d[s], *std::min_element(d.begin(), d.end()), 1e-8);
      }
    EXPECT_GT(number_on_back, 0u);
  }
}

TEST(Several_sources, have_the_known_diagram_on_a_cylinder)
{
  constexpr std::size_t nu = 24;
  const Built built(cylinder(2., nu, 8, 0., 0));
  const double girth = nu * 2. * std::sin(pi / nu); // that of the prism
  const auto unrolled = [&](const Point& p)
  {
    // along the chords
    const double u = std::atan2(p[1], p[0]) * nu / (2. * pi), k = std::floor(u), angle = 2. * pi / nu;
    const Point a = {{std::cos(k * angle), std::sin(k * angle), 0.}};
    return Point{{k * girth / nu + norm(Point{{p[0], p[1], 0.}} - a), p[2], 0.}};
  };
  const std::vector<std::size_t> at = {nu + 3, 4 * nu + 10, 6 * nu + 20};
  std::vector<Source> sources;
  for(const std::size_t v : at)
    sources.push_back(built.vertices[v]);
  for(const Method method : methods)
  {
    Solver solver(built.mesh, by(method));
    solver.set_sources(sources);
    for(const auto& x : voronoi_points(solver.cut_locus(through_faces)))
    {
      std::vector<double> d;
      for(const std::size_t v : at)
      {
        d.push_back(1e9);
        for(const double turn : {-1., 0., 1.})
          d.back() = (std::min)(
            d.back(), norm(unrolled(x.first) + Point{{turn * girth, 0., 0.}} - unrolled(built.data.points[v])));
      }
      for(const std::size_t s : x.second)
        EXPECT_NEAR(d[s], *std::min_element(d.begin(), d.end()), 1e-8)
          << "at " << x.first[0] << ' ' << x.first[1] << ' ' << x.first[2];
    }
  }
}

TEST(Several_sources, have_a_great_circle_on_a_sphere)
{
  double previous = 1.;
  for(const std::size_t n : {8, 16, 32})
  {
    const Built built(jittered_sphere(n, 0.1, 2));
    const std::size_t a = nearest_vertex(built.data, {{1., 0.2, 0.1}}),
                      b = nearest_vertex(built.data, {{-0.1, 1., 0.3}});
    const Point normal = normalized(built.data.points[a] - built.data.points[b]);
    double most = 0.;
    for(const auto& x :
        voronoi_points(compute_cut_locus(built.mesh, Vertices{built.vertices[a], built.vertices[b]}, through_faces)))
      most = (std::max)(most, std::fabs(dot(x.first, normal)));
    EXPECT_LT(most, 0.1 * mean_edge_length(built.data)) << n;
    EXPECT_LT(most, 0.7 * previous) << n;
    previous = most;
  }
}

// Each edge of the Voronoi diagram of points of a sphere is on the great circle that is equally far from its two, and its
// corners are the points opposite to each other on which such circles meet.
TEST(Several_sources, have_great_circles_between_each_two_on_a_sphere)
{
  for(const std::size_t k : {3, 4, 7})
  {
    const Built built(jittered_sphere(32, 0.1, 2));
    const double h = mean_edge_length(built.data);
    std::mt19937 engine(unsigned(17 * k));
    std::vector<std::size_t> at;
    Vertices sources;
    while(sources.size() < k)
    {
      const std::size_t v = engine() % built.data.points.size();
      bool is_far = true; // from the others
      for(const std::size_t w : at)
        is_far = is_far && norm(built.data.points[v] - built.data.points[w]) > 6. * h;
      if(!is_far)
        continue;
      at.push_back(v);
      sources.push_back(built.vertices[v]);
    }
    const Result result = compute_cut_locus(built.mesh, sources, through_faces.kept_part(Kept_part::VORONOI));
    for(const auto& x : voronoi_points(result))
    {
      const Point &p = built.data.points[at[x.second[0]]], &q = built.data.points[at[x.second[1]]];
      EXPECT_LT(std::fabs(dot(x.first, normalized(p - q))), 0.2 * h) << k;
      for(const std::size_t v : at) // no other one is nearer
        EXPECT_GT(norm(x.first - built.data.points[v]), norm(x.first - p) - 0.2 * h) << k;
    }
    std::size_t number_of_corners = 0;
    for(const auto v : CGAL::make_range(vertices(result.graph())))
      number_of_corners += degree(v, result.graph()) > 2;
    EXPECT_EQ(number_of_corners, 2 * k - 4) << k; // by Euler's formula, as three cells meet in each
  }
}

// -- the interface -----------------------------------------------------------------------------------------------------

TEST(Several_sources, no_threshold_removes_what_is_between_two)
{
  const Built built(bumpy_sphere(10, 0.5, 3));
  Solver solver(built.mesh);
  solver.set_sources(random_sources(built, 6, 3));
  for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
  {
    const auto number = [&](const Result& result) { return voronoi_points(result).size() / 2; };
    const std::size_t all =
      number(solver.cut_locus(by(Default_method().minimum_branch_width(0.1)).cut_locus_curve(curve)));
    EXPECT_GT(all, 0u);
    const Result strong =
      solver.cut_locus(by(Default_method().minimum_branch_width(1.).minimum_branch_edges(100)).cut_locus_curve(curve));
    EXPECT_EQ(number(strong), all);
    EXPECT_EQ(2 * num_edges(strong.graph()), voronoi_points(strong).size()) << "there is no branch left";
    const Result voronoi = solver.cut_locus(params::cut_locus_curve(curve).kept_part(Kept_part::VORONOI));
    EXPECT_EQ(number(voronoi), all);
    EXPECT_EQ(num_edges(voronoi.graph()), all);
  }
}

TEST(Several_sources, leave_edges_of_the_voronoi_diagram_alone_if_asked_for)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 4));
  const std::vector<Source> sources = random_sources(built, 3, 1);
  for(const Method method : methods)
    for(const Curve curve : {Curve::MESH_EDGES, Curve::THROUGH_FACES})
    {
      const auto np = by(method).cut_locus_curve(curve);
      const Result all = compute_cut_locus(built.mesh, sources, np),
                   voronoi = compute_cut_locus(built.mesh, sources, np.kept_part(Kept_part::VORONOI));
      EXPECT_EQ(2 * num_edges(voronoi.graph()), voronoi_points(all).size());
      EXPECT_LT(num_edges(voronoi.graph()), num_edges(all.graph()));
      for(const auto v : CGAL::make_range(vertices(voronoi.graph())))
        EXPECT_GT(out_degree(v, voronoi.graph()), 1u) << "on a closed surface it has no ends";
      const Result none = compute_cut_locus(built.mesh, built.vertices[0], np.kept_part(Kept_part::VORONOI));
      EXPECT_EQ(num_edges(none.graph()), 0u);
      EXPECT_EQ(num_vertices(none.graph()), 1u);
    }
}

TEST(Several_sources, one_of_them_is_a_source_as_ever)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 4));
  const Location location(built.faces[40], {{0.2, 0.3, 0.5}});
  for(const Method method : methods)
  {
    const auto np = through_faces.cut_locus_method(method);
    const Result one = compute_cut_locus(built.mesh, location, np),
                 set = compute_cut_locus(built.mesh, std::vector<Location>{location}, np);
    ASSERT_EQ(num_vertices(one.graph()), num_vertices(set.graph()));
    ASSERT_EQ(num_edges(one.graph()), num_edges(set.graph()));
    for(std::size_t v = 0; v < num_vertices(one.graph()); ++v)
      EXPECT_EQ(one.graph()[v].point, set.graph()[v].point);
    EXPECT_EQ(set.number_of_sources(), 1u);
    for(const Mesh::Vertex_index v : built.vertices)
      EXPECT_EQ(set.nearest_source(v), std::optional<std::size_t>(0));
  }
}

TEST(Several_sources, are_numbered_in_their_order)
{
  const Built built(sphere(5));
  const std::vector<Source> sources = random_sources(built, 5, 2);
  const Result result = compute_cut_locus(built.mesh, sources);
  ASSERT_EQ(result.number_of_sources(), 5u);
  for(std::size_t i = 0; i < 5; ++i)
  {
    if(std::holds_alternative<Mesh::Vertex_index>(sources[i]))
    {
      EXPECT_EQ(result.source(i).mesh_vertex, std::get<Mesh::Vertex_index>(sources[i]));
      EXPECT_EQ(result.nearest_source(result.source(i).mesh_vertex), i);
    }
    else
      EXPECT_EQ(result.source(i).location.first, std::get<Location>(sources[i]).first);
  }
}

TEST(Several_sources, that_can_not_be_used_are_refused_by_their_numbers)
{
  const Built built(disjoint_union(sphere(3), torus(1., 0.4, 12, 8), {{5., 0., 0.}}));
  const auto& v = built.vertices;
  const auto message = [&](const std::vector<Source>& sources)
  { return message_of([&] { Solver(built.mesh).set_sources(sources); }); };
  EXPECT_EQ(message({v[0], v[5]}), "nothing was thrown");
  expect_has(message({}), "is empty");
  expect_has(message({v[0], v[5], v[0]}), "sources 0 and 2 are at the same point");
  expect_has(message({v[0], v[1], v.back()}), "sources 0 and 2 are in different components");
  expect_has(message({v[0], Mesh::null_vertex()}), "source 1: ");

  // the same point of an edge, named by both of its faces
  const Mesh::Halfedge_index h = built.mesh.halfedge(v[3]), o = built.mesh.opposite(h);
  const auto on = [&](Mesh::Halfedge_index g, double t)
  {
    Location result(built.mesh.face(g), {{0., 0., 0.}});
    Mesh::Halfedge_index k = built.mesh.halfedge(result.first);
    for(double& c : result.second)
    {
      c = k == g ? 1. - t : k == built.mesh.next(g) ? t : 0.;
      k = built.mesh.next(k);
    }
    return result;
  };
  expect_has(message({on(h, 0.25), on(o, 0.75)}), "at the same point");
  expect_has(message({on(h, 1.), v[3]}), "at the same point");
  EXPECT_EQ(message({on(h, 0.25), on(o, 0.25)}), "nothing was thrown");
  // and nearly so
  expect_has(message({on(h, 0.25), on(o, 0.75 - 1e-8)}), "sources 0 and 1 are closer to each other than 1e-5");
  expect_has(message({on(h, 1. - 1e-6), v[3]}), "closer to each other than 1e-5");
  EXPECT_EQ(message({on(h, 0.25), on(o, 0.75 - 1e-4)}), "nothing was thrown");
  expect_words(
    [&] {
    compute_cut_locus(built.mesh, std::vector<Source>{on(h, 0.3), on(h, 0.5), on(h, 0.7)}, mesh_edges);
    },
    {"has no face to itself"});
}

TEST(Several_sources, are_not_cut_open_to_one_disk)
{
  Built built(sphere(4));
  const Result result = compute_cut_locus(built.mesh, Vertices{built.vertices[0], built.vertices[9]});
  Mesh disk;
  expect_words([&] { CGAL::cut_along_cut_locus(built.mesh, result, disk); }, {"several sources"});
}

TEST(Several_sources, lie_in_a_component_and_all_else_is_unreached)
{
  const Built built(disjoint_union(sphere(4), torus(1., 0.4, 12, 8), {{5., 0., 0.}}));
  const std::size_t first = sphere(4).points.size();
  const Result result = compute_cut_locus(built.mesh, Vertices{built.vertices[first + 3], built.vertices[first + 50]});
  EXPECT_EQ(result.genus(), 1u);
  for(std::size_t v = 0; v < built.vertices.size(); ++v)
  {
    EXPECT_EQ(result.nearest_source(built.vertices[v]).has_value(), v >= first);
    EXPECT_EQ(std::isfinite(result.distance(built.vertices[v])), v >= first);
  }
}

} // namespace

} // namespace test_several_sources
