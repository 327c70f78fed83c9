// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The public class and functions for exact geodesics, on several mesh types.

#include <CGAL/exact_geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace test_exact_geodesics_interface {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename Mesh>
class Exact_geodesics_interface : public ::testing::Test
{
public:
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;
  using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;
  using Face_location = typename Geodesics::Face_location;
  using Point =
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;

  /// the square [0, n]^2 in a grid of n times n cells
  static Mesh square(unsigned n)
  {
    Mesh mesh;
    CGAL::make_grid(
      n, n, mesh, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0.); }, true);
    return mesh;
  }

  static double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

  static Point point(const Mesh& mesh, const Face_location& location)
  {
    const auto h = halfedge(location.first, mesh);
    const auto vpm = get(CGAL::vertex_point, mesh);
    const Point &p = get(vpm, source(h, mesh)), &q = get(vpm, target(h, mesh)),
                &r = get(vpm, target(next(h, mesh), mesh));
    const std::array<double, 3>& c = location.second;
    return Point(c[0] * p.x() + c[1] * q.x() + c[2] * r.x(), c[0] * p.y() + c[1] * q.y() + c[2] * r.y(),
                 c[0] * p.z() + c[1] * q.z() + c[2] * r.z());
  }
};

using Mesh_types = ::testing::Types<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                                    CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>,
                                    CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Exact_geodesics_interface, Mesh_types, );

/// the border as a source, by a loop of its edges or by itself, and the squares at a distance from it
TYPED_TEST(Exact_geodesics_interface, curves_and_isolines)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  using Solver = typename Fixture::Geodesics;
  const TypeParam mesh = Fixture::square(6);
  std::vector<typename boost::graph_traits<TypeParam>::edge_descriptor> loop;
  for(const auto e : CGAL::make_range(edges(mesh)))
    if(is_border(e, mesh))
      loop.push_back(e);
  const auto vpm = get(CGAL::vertex_point, mesh);
  std::map<typename Fixture::vertex_descriptor, double> map;
  CGAL::exact_geodesic_distances(mesh, std::vector<typename Fixture::vertex_descriptor>(),
                                 boost::make_assoc_property_map(map),
                                 CGAL::parameters::source_curves(std::vector<decltype(loop)>{loop}));
  Solver geodesics(mesh);
  geodesics.add_source_border();
  geodesics.set_isolines(true);
  geodesics.compute();
  for(const auto v : CGAL::make_range(vertices(mesh)))
  {
    const double x = CGAL::to_double(get(vpm, v).x()), y = CGAL::to_double(get(vpm, v).y());
    const double expected = (std::min)((std::min)(x, 6. - x), (std::min)(y, 6. - y));
    EXPECT_NEAR(geodesics.distance(v), expected, 1e-13);
    EXPECT_NEAR(map[v], expected, 1e-13);
  }
  std::vector<typename Solver::Isoline> lines;
  geodesics.isolines(std::vector<double>{0.5, 2.}, std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 2u);
  for(const typename Solver::Isoline& line : lines)
  {
    double length = 0.;
    for(std::size_t i = 0; i + 1 < line.locations.size(); ++i)
      length += Fixture::distance(Fixture::point(mesh, line.locations[i]), Fixture::point(mesh, line.locations[i + 1]));
    EXPECT_TRUE(line.is_closed);
    EXPECT_NEAR(length, 24. - 8. * line.level, 1e-4);
  }
}

TYPED_TEST(Exact_geodesics_interface, free_functions)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  const TypeParam mesh = Fixture::square(9);
  const auto vpm = get(CGAL::vertex_point, mesh);
  std::map<typename Fixture::vertex_descriptor, double> map;
  const auto vdm = boost::make_assoc_property_map(map);
  const auto s = *std::next(vertices(mesh).begin(), 17);
  CGAL::exact_geodesic_distances(mesh, s, vdm);
  EXPECT_EQ(map.size(), num_vertices(mesh));
  for(auto v : vertices(mesh))
    EXPECT_NEAR(map[v], Fixture::distance(get(vpm, s), get(vpm, v)), 1e-12);

  const typename Fixture::Face_location location(*std::next(faces(mesh).begin(), 30), {{0.2, 0.5, 0.3}});
  CGAL::exact_geodesic_distances(mesh, location, vdm, CGAL::parameters::default_values());
  for(auto v : vertices(mesh))
    EXPECT_NEAR(map[v], Fixture::distance(Fixture::point(mesh, location), get(vpm, v)), 1e-12);

  const std::vector<typename Fixture::vertex_descriptor> sources = {s, *vertices(mesh).begin()};
  CGAL::exact_geodesic_distances(mesh, sources, vdm);
  for(auto v : vertices(mesh))
    EXPECT_NEAR(map[v],
                (std::min)(Fixture::distance(get(vpm, sources[0]), get(vpm, v)),
                           Fixture::distance(get(vpm, sources[1]), get(vpm, v))),
                1e-12);
  CGAL::exact_geodesic_distances(mesh, std::vector<typename Fixture::Face_location>(1, location), vdm);
  for(auto v : vertices(mesh))
    EXPECT_NEAR(map[v], Fixture::distance(Fixture::point(mesh, location), get(vpm, v)), 1e-12);
}

TYPED_TEST(Exact_geodesics_interface, vertex_point_map)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  const TypeParam mesh = Fixture::square(4);
  std::map<typename Fixture::vertex_descriptor, typename Fixture::Point> points;
  for(auto v : vertices(mesh))
  {
    const auto& p = get(get(CGAL::vertex_point, mesh), v);
    points[v] = typename Fixture::Point(3. * p.x(), 2. * p.y(), 0.);
  }
  std::map<typename Fixture::vertex_descriptor, double> map;
  const auto s = *vertices(mesh).begin();
  CGAL::exact_geodesic_distances(mesh, s, boost::make_assoc_property_map(map),
                                 CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points)));
  for(auto v : vertices(mesh))
    EXPECT_NEAR(map[v], Fixture::distance(points[s], points[v]), 1e-12);
}

TYPED_TEST(Exact_geodesics_interface, everything_asked_for)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  using Location = typename Fixture::Face_location;
  const TypeParam mesh = Fixture::square(7);
  const auto vpm = get(CGAL::vertex_point, mesh);
  typename Fixture::Geodesics geodesics(mesh);
  const auto f = *std::next(faces(mesh).begin(), 40);
  const Location query(f, {{0.6, 0.1, 0.3}});
  geodesics.set_directions(true);
  const auto named = geodesics.add_query(query);
  for(auto s : vertices(mesh))
  {
    geodesics.compute(s);
    const auto zero = geodesics.source_halfedge();
    EXPECT_EQ(source(zero, mesh), s);
    const auto direction = [&](const typename Fixture::Point& p, const typename Fixture::Point& q)
    { return std::atan2(q.y() - p.y(), q.x() - p.x()); };
    const auto along = [&](typename boost::graph_traits<TypeParam>::halfedge_descriptor h)
    { return direction(get(vpm, source(h, mesh)), get(vpm, target(h, mesh))); };
    const auto turn = [](double a, double b) { return std::fabs(std::remainder(a - b, 2. * 3.14159265358979323846)); };
    for(auto v : vertices(mesh))
    {
      EXPECT_EQ(geodesics.nearest_source(v), 0u);
      const double d = geodesics.distance(v);
      EXPECT_NEAR(d, Fixture::distance(get(vpm, s), get(vpm, v)), 1e-12);
      std::vector<Location> path;
      geodesics.shortest_path(v, std::back_inserter(path));
      ASSERT_FALSE(path.empty());
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, path.front()), get(vpm, v)), 1e-12);
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, path.back()), get(vpm, s)), 1e-12);
      double length = 0.;
      for(std::size_t i = 1; i < path.size(); ++i)
        length += Fixture::distance(Fixture::point(mesh, path[i - 1]), Fixture::point(mesh, path[i]));
      EXPECT_NEAR(length, d, 1e-10);
      const auto place = geodesics.logarithmic_map(v);
      EXPECT_NEAR(std::hypot(place[0], place[1]), d, 1e-12);
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, geodesics.exponential_map(place)), get(vpm, v)), 1e-10);
      if(v == s)
        continue;
      EXPECT_LT(turn(geodesics.direction_at_source(v) + along(zero), direction(get(vpm, s), get(vpm, v))), 1e-10);
      const auto arrival = geodesics.arrival_direction(v);
      EXPECT_EQ(source(arrival.first, mesh), v);
      EXPECT_LT(turn(arrival.second + along(arrival.first), direction(get(vpm, v), get(vpm, s))), 1e-10);
    }
    const auto q = Fixture::point(mesh, query);
    EXPECT_NEAR(geodesics.distance(named), Fixture::distance(get(vpm, s), q), 1e-12);
    EXPECT_LT(turn(geodesics.direction_at_source(named) + along(zero), direction(get(vpm, s), q)), 1e-10);
    EXPECT_LT(Fixture::distance(Fixture::point(mesh, geodesics.exponential_map(geodesics.logarithmic_map(named))), q),
              1e-10);
    std::vector<Location> path;
    geodesics.shortest_path(named, std::back_inserter(path));
    ASSERT_FALSE(path.empty());
    EXPECT_LT(Fixture::distance(Fixture::point(mesh, path.front()), q), 1e-12);
    // points that have not been named: in another face, on an edge, at a vertex
    for(const std::array<double, 3>& at : {std::array<double, 3>{{0.2, 0.5, 0.3}}, {{0., 0.4, 0.6}}, {{0., 1., 0.}}})
    {
      const Location other(*std::next(faces(mesh).begin(), 11), at);
      const auto p = Fixture::point(mesh, other);
      const double d = Fixture::distance(get(vpm, s), p);
      EXPECT_NEAR(geodesics.distance(other), d, 1e-12);
      EXPECT_EQ(geodesics.nearest_source(other), 0u);
      path.clear();
      geodesics.shortest_path(other, std::back_inserter(path));
      ASSERT_FALSE(path.empty());
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, path.front()), p), 1e-12);
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, path.back()), get(vpm, s)), 1e-12);
      EXPECT_LT(Fixture::distance(Fixture::point(mesh, geodesics.exponential_map(geodesics.logarithmic_map(other))), p),
                1e-10);
      if(d > 0.)
      {
        EXPECT_LT(turn(geodesics.direction_at_source(other) + along(zero), direction(get(vpm, s), p)), 1e-10);
      }
    }
  }
  geodesics.set_maximum_distance(2.5);
  const auto s = *vertices(mesh).begin();
  geodesics.compute(s);
  for(auto v : vertices(mesh))
  {
    const double d = Fixture::distance(get(vpm, s), get(vpm, v));
    EXPECT_EQ(geodesics.distance(v) < infinity, d <= 2.5);
    std::vector<Location> path;
    geodesics.shortest_path(v, std::back_inserter(path));
    EXPECT_EQ(path.empty(), d > 2.5);
  }
}

TYPED_TEST(Exact_geodesics_interface, bad_sources)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  using Traits = boost::graph_traits<TypeParam>;
  const TypeParam mesh = Fixture::square(3);
  typename Fixture::Geodesics geodesics(mesh);
  const auto f = *faces(mesh).begin();
  EXPECT_THROW(geodesics.compute(), std::invalid_argument);
  EXPECT_THROW(geodesics.compute(Traits::null_vertex()), std::invalid_argument);
  EXPECT_THROW(geodesics.compute(typename Fixture::Face_location(Traits::null_face(), {{1., 0., 0.}})),
               std::invalid_argument);
  EXPECT_THROW(geodesics.compute(typename Fixture::Face_location(f, {{1., 1., 0.}})), std::invalid_argument);
  EXPECT_THROW(geodesics.add_query(typename Fixture::Face_location(f, {{2., -1., 0.}})), std::invalid_argument);
  EXPECT_THROW(geodesics.distance(typename Fixture::Face_location(f, {{1., 0., 0.}})), std::invalid_argument);
  geodesics.compute(*vertices(mesh).begin());
  EXPECT_EQ(geodesics.distance(*vertices(mesh).begin()), 0.);
  EXPECT_THROW(geodesics.distance(typename Fixture::Face_location(f, {{2., -1., 0.}})), std::invalid_argument);
  EXPECT_THROW(geodesics.distance(typename Fixture::Face_location(Traits::null_face(), {{1., 0., 0.}})),
               std::invalid_argument);
}

TYPED_TEST(Exact_geodesics_interface, bad_meshes)
{
  using Fixture = Exact_geodesics_interface<TypeParam>;
  TypeParam mesh;
  EXPECT_THROW(typename Fixture::Geodesics geodesics(mesh), std::invalid_argument);
  mesh = Fixture::square(3);
  const auto f = *std::next(faces(mesh).begin(), 5);
  const auto h = halfedge(f, mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  put(vpm, source(h, mesh), CGAL::midpoint(get(vpm, target(h, mesh)), get(vpm, target(next(h, mesh), mesh))));
  // a face without area is taken: the surface is as flat as it was
  typename Fixture::Geodesics geodesics(mesh);
  const auto v = *vertices(mesh).begin();
  geodesics.compute(v);
  for(const auto w : CGAL::make_range(vertices(mesh)))
  {
    const double straight = std::sqrt(CGAL::to_double(CGAL::squared_distance(get(vpm, v), get(vpm, w))));
    EXPECT_GE(geodesics.distance(w), straight - 1e-12);
    EXPECT_LE(geodesics.distance(w), 1.1 * straight);
  }
  // if no face has an area there is no surface
  for(const auto w : CGAL::make_range(vertices(mesh)))
    put(vpm, w, get(vpm, v));
  try
  {
    typename Fixture::Geodesics none(mesh);
    ADD_FAILURE() << "a mesh without area has been accepted";
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("face #0 "), std::string::npos) << e.what();
  }
}

TEST(Exact_geodesics_surface_mesh, isolated_and_removed_vertices)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Point = Mesh::Point;
  Mesh mesh;
  const auto isolated = mesh.add_vertex(Point(9., 9., 9.)), removed = mesh.add_vertex(Point(8., 8., 8.));
  const auto a = mesh.add_vertex(Point(0., 0., 0.)), b = mesh.add_vertex(Point(3., 0., 0.)),
             c = mesh.add_vertex(Point(0., 4., 0.));
  mesh.add_face(a, b, c);
  mesh.remove_vertex(removed);
  CGAL::Surface_mesh_exact_geodesics<Mesh> geodesics(mesh);
  EXPECT_THROW(geodesics.compute(isolated), std::invalid_argument);
  geodesics.compute(b);
  EXPECT_EQ(geodesics.distance(isolated), infinity);
  auto vdm = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", -1.).first;
  geodesics.distances(vdm);
  EXPECT_EQ(vdm[isolated], infinity);
  EXPECT_EQ(vdm[a], 3.);
  EXPECT_EQ(vdm[b], 0.);
  EXPECT_DOUBLE_EQ(vdm[c], 5.);
  // messages count the vertices in the order of the mesh
  mesh.point(c) = Point(0., infinity, 0.);
  try
  {
    CGAL::Surface_mesh_exact_geodesics<Mesh> other(mesh);
    ADD_FAILURE() << "an infinite coordinate has been accepted";
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("vertex #3 "), std::string::npos) << e.what();
  }
}

} // namespace

} // namespace test_exact_geodesics_interface
