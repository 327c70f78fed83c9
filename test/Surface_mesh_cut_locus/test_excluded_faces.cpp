// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Regions that no path may cross: against meshes without their faces, closed forms, and what paths touch.

#include "surface_test.h"

#include <CGAL/exact_geodesic_distances.h>

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

namespace test_excluded_faces {

namespace {

using namespace surface_test;
using Point = Kernel::Point_3;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Excluded = Mesh::Property_map<Face, bool>;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename FaceMap>
auto without(const FaceMap& excluded)
{
  return params::face_is_excluded_map(excluded);
}

template <typename Grid>
Grid plate(unsigned n)
{
  Grid mesh;
  CGAL::make_grid(
    n, n, mesh, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0.); }, true);
  return mesh;
}

template <typename Grid>
Point center(const Grid& mesh, typename boost::graph_traits<Grid>::face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  return CGAL::centroid(get(vpm, source(h, mesh)), get(vpm, target(h, mesh)), get(vpm, target(next(h, mesh), mesh)));
}

/// balls, or single faces, of a surface
Excluded regions_at_random(Mesh& mesh, unsigned seed)
{
  Excluded excluded = mesh.add_property_map<Face, bool>("f:excluded", false).first;
  std::mt19937 random(seed);
  const auto any_face = [&] { return Face(Mesh::size_type(random() % mesh.number_of_faces())); };
  if(seed % 2 == 0)
    for(std::size_t i = 0; i < mesh.number_of_faces() / 4; ++i)
      excluded[any_face()] = true;
  else
    for(int i = 0; i < 5; ++i)
    {
      const Point middle = center(mesh, any_face());
      for(Face f : mesh.faces())
        if(distance(center(mesh, f), middle) < 0.35)
          excluded[f] = true;
    }
  return excluded;
}

/// the mesh without the faces, and the vertices that stand there for each of its own
struct Mesh_of_rest
{
  Mesh mesh;
  std::map<Vertex, std::vector<Vertex>> copies;

  Mesh_of_rest(const Mesh& whole, const Excluded& excluded) : mesh(whole)
  {
    for(Face f : whole.faces())
      if(excluded[f])
        CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    for(Vertex v : whole.vertices())
      if(!mesh.is_removed(v))
        copies[v] = {v}; // before numbers of removed vertices are used again
    std::vector<std::vector<Vertex>> duplicates;
    CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(
      mesh, params::output_iterator(std::back_inserter(duplicates)));
    for(const std::vector<Vertex>& fans : duplicates)
      copies[fans.front()] = fans;
  }

  double distance(const Geodesics& geodesics, Vertex v) const
  {
    double result = infinity;
    if(const auto found = copies.find(v); found != copies.end())
      for(Vertex copy : found->second)
        result = (std::min)(result, geodesics.distance(copy));
    return result;
  }
};

std::vector<Mesh> surfaces()
{
  std::vector<Mesh> result;
  result.push_back(to_surface_mesh(irregular_bumpy_sphere(5, 0.3, 1)));
  result.push_back(to_surface_mesh(torus(1., 0.4, 24, 12, 0.2, 2)));
  result.push_back(to_surface_mesh(saddle(14, 0.4, 0.2, 3)));
  return result;
}

Location center_location(Face f)
{
  return {f, {{0.25, 0.35, 0.4}}};
}

TEST(Excluded_faces, as_if_they_had_been_removed)
{
  std::size_t touching = 0, unreached = 0;
  for(const Mesh& surface : surfaces())
    for(unsigned seed = 0; seed < 6; ++seed)
    {
      Mesh mesh = surface;
      const Excluded excluded = regions_at_random(mesh, seed);
      const Mesh_of_rest rest(mesh, excluded);
      Geodesics geodesics(mesh, without(excluded)), expected(rest.mesh);
      for(Face f : mesh.faces())
        for(Geodesics* solver : {&geodesics, &expected})
          if(!excluded[f])
            solver->add_query(center_location(f));
      std::size_t number = 0;
      for(Face f : mesh.faces())
      {
        if(excluded[f] || ++number % 40 != 0)
          continue;
        for(Geodesics* solver : {&geodesics, &expected})
          solver->compute(center_location(f));
        std::map<Vertex, double> map;
        geodesics.distances(boost::make_assoc_property_map(map));
        for(Vertex v : mesh.vertices())
        {
          EXPECT_EQ(geodesics.distance(v), rest.distance(expected, v));
          EXPECT_EQ(map[v], geodesics.distance(v));
          unreached += geodesics.distance(v) == infinity;
        }
        Geodesics::Query center{0};
        for(Face g : mesh.faces())
          if(!excluded[g])
          {
            EXPECT_EQ(geodesics.distance(center), expected.distance(center));
            ++center.number;
          }
      }
      for(const auto& copies : rest.copies)
        touching += copies.second.size() > 1;
    }
  EXPECT_GT(touching, 100u);
  EXPECT_GT(unreached, 100u);
}

/// whether a face that is left has both points, and so the segment between them
bool is_in_a_face_left(const Mesh& mesh, const Excluded& excluded, const Location& a, const Location& b)
{
  std::set<Vertex> used;
  for(const Location* location : {&a, &b})
  {
    auto h = mesh.halfedge(location->first);
    for(double c : location->second)
    {
      if(c > 1e-12)
        used.insert(mesh.source(h));
      h = mesh.next(h);
    }
  }
  for(Face f : CGAL::faces_around_target(mesh.halfedge(*used.begin()), mesh))
  {
    if(f == Mesh::null_face() || excluded[f])
      continue;
    const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
    if(std::all_of(used.begin(), used.end(),
                   [&](Vertex v) { return std::find(corners.begin(), corners.end(), v) != corners.end(); }))
      return true;
  }
  return false;
}

TEST(Excluded_faces, no_path_crosses_them)
{
  std::size_t longer = 0;
  for(const Mesh& surface : surfaces())
    for(unsigned seed = 0; seed < 4; ++seed)
    {
      Mesh mesh = surface;
      const Excluded excluded = regions_at_random(mesh, seed);
      const Face f = *std::find_if(mesh.faces().begin(), mesh.faces().end(), [&](Face g) { return !excluded[g]; });
      Geodesics geodesics(mesh, without(excluded)), whole(mesh);
      for(Geodesics* solver : {&geodesics, &whole})
        solver->compute(center_location(f));
      for(Vertex v : mesh.vertices())
      {
        std::vector<Location> path;
        geodesics.shortest_path(v, std::back_inserter(path));
        ASSERT_EQ(path.empty(), geodesics.distance(v) == infinity);
        EXPECT_GE(geodesics.distance(v), (1. - 1e-12) * whole.distance(v));
        longer += geodesics.distance(v) > 1.001 * whole.distance(v);
        if(path.empty())
          continue;
        double length = 0.;
        for(std::size_t i = 0; i + 1 < path.size(); ++i)
        {
          EXPECT_FALSE(excluded[path[i].first]);
          EXPECT_TRUE(is_in_a_face_left(mesh, excluded, path[i], path[i + 1]));
          length += distance(point(mesh, path[i]), point(mesh, path[i + 1]));
        }
        EXPECT_NEAR(length, geodesics.distance(v), 1e-10);
        EXPECT_LT(distance(point(mesh, path.front()), mesh.point(v)), 1e-12);
      }
    }
  EXPECT_GT(longer, 100u);
}

template <typename Grid>
class Excluded_faces_of : public ::testing::Test
{
};
using Mesh_types = ::testing::Types<Mesh, CGAL::Polyhedron_3<Kernel>>;
TYPED_TEST_SUITE(Excluded_faces_of, Mesh_types, );

/// between two points of the plane, around the wall [4, 6] x [0, 7]
double around_wall(const Point& s, const Point& t)
{
  const auto is_free = [](const Point& p, const Point& q)
  {
    // between the sides of the wall, a segment has to be above it
    const double first = (std::max)(4., (std::min)(p.x(), q.x())), last = (std::min)(6., (std::max)(p.x(), q.x()));
    for(double x : {first, last})
      if(first < last && p.y() + (x - p.x()) / (q.x() - p.x()) * (q.y() - p.y()) < 7. - 1e-12)
        return false;
    return true;
  };
  const Point left(4., 7., 0.), right(6., 7., 0.);
  if(is_free(s, t))
    return distance(s, t);
  double result = distance(s, left) + 2. + distance(right, t);
  for(const Point& corner : {left, right})
    if(is_free(s, corner) && is_free(corner, t))
      result = (std::min)(result, distance(s, corner) + distance(corner, t));
  return result;
}

TYPED_TEST(Excluded_faces_of, a_plate_with_a_wall)
{
  using Traits = boost::graph_traits<TypeParam>;
  const TypeParam mesh = plate<TypeParam>(10);
  const auto vpm = get(CGAL::vertex_point, mesh);
  const auto is_wall = [&](typename Traits::face_descriptor f)
  {
    const Point p = center(mesh, f);
    return p.x() > 4. && p.x() < 6. && p.y() < 7.;
  };
  const auto excluded = boost::make_function_property_map<typename Traits::face_descriptor, bool>(is_wall);
  for(const std::size_t number : {0u, 4u, 25u, 79u, 120u})
  {
    const auto s = *std::next(vertices(mesh).begin(), long(number));
    const Point from = get(vpm, s);
    ASSERT_FALSE(from.x() == 5. && from.y() < 7.);
    std::map<typename Traits::vertex_descriptor, double> map;
    CGAL::exact_geodesic_distances(mesh, s, boost::make_assoc_property_map(map), without(excluded));
    ASSERT_EQ(map.size(), num_vertices(mesh));
    for(const auto v : CGAL::make_range(vertices(mesh)))
    {
      const Point to = get(vpm, v);
      if(to.x() == 5. && to.y() < 7.)
        EXPECT_EQ(map[v], infinity);
      else
        EXPECT_NEAR(map[v], around_wall(from, to), 1e-12);
    }
  }
}

TYPED_TEST(Excluded_faces_of, a_wall_that_separates)
{
  using Traits = boost::graph_traits<TypeParam>;
  const TypeParam mesh = plate<TypeParam>(8);
  const auto vpm = get(CGAL::vertex_point, mesh);
  const auto excluded = boost::make_function_property_map<typename Traits::face_descriptor, bool>(
    [&](typename Traits::face_descriptor f) { return std::fabs(center(mesh, f).x() - 4.) < 1.; });
  CGAL::Surface_mesh_exact_geodesics<TypeParam> geodesics(mesh, without(excluded));
  geodesics.set_directions(true);
  const auto s = *vertices(mesh).begin();
  ASSERT_LT(get(vpm, s).x(), 3.);
  geodesics.compute(s);
  for(const auto v : CGAL::make_range(vertices(mesh)))
  {
    const bool is_reached = get(vpm, v).x() <= 3.;
    std::vector<typename CGAL::Surface_mesh_exact_geodesics<TypeParam>::Face_location> path;
    geodesics.shortest_path(v, std::back_inserter(path));
    EXPECT_EQ(path.empty(), !is_reached);
    EXPECT_EQ(std::isnan(geodesics.logarithmic_map(v)[0]), !is_reached);
    if(is_reached)
      EXPECT_NEAR(geodesics.distance(v), distance(get(vpm, s), get(vpm, v)), 1e-12);
    else
      EXPECT_EQ(geodesics.distance(v), infinity);
  }
}

/// the rim is border: a source by itself, or along its edges from either side
TEST(Excluded_faces, the_rim_as_source)
{
  Mesh mesh = plate<Mesh>(9);
  Excluded excluded = mesh.add_property_map<Face, bool>("f:excluded", false).first;
  for(Face f : mesh.faces())
  {
    const Point p = center(mesh, f);
    excluded[f] = p.x() > 3. && p.x() < 6. && p.y() > 3. && p.y() < 6.;
  }
  Edges rim;
  for(const auto e : mesh.edges())
  {
    const Face f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.opposite(mesh.halfedge(e)));
    if(f != Mesh::null_face() && g != Mesh::null_face() && excluded[f] != excluded[g])
      rim.push_back(e);
  }
  Geodesics geodesics(mesh, without(excluded));
  geodesics.add_source_border();
  EXPECT_EQ(geodesics.number_of_sources(), 2u);
  geodesics.compute();
  std::map<Vertex, double> from_rim;
  CGAL::exact_geodesic_distances(mesh, std::vector<Vertex>(), boost::make_assoc_property_map(from_rim),
                                 params::source_curves(std::vector<decltype(rim)>{rim}).face_is_excluded_map(excluded));
  for(Vertex v : mesh.vertices())
  {
    const double x = mesh.point(v).x(), y = mesh.point(v).y();
    const double dx = (std::max)(std::fabs(x - 4.5) - 1.5, 0.), dy = (std::max)(std::fabs(y - 4.5) - 1.5, 0.);
    const double to_rim = std::hypot(dx, dy), to_border = (std::min)((std::min)(x, 9. - x), (std::min)(y, 9. - y));
    const bool is_inside = std::fabs(x - 4.5) < 1. && std::fabs(y - 4.5) < 1.;
    EXPECT_EQ(from_rim[v] == infinity, is_inside);
    EXPECT_EQ(geodesics.distance(v) == infinity, is_inside);
    if(is_inside)
      continue;
    EXPECT_NEAR(from_rim[v], to_rim, 1e-6);
    EXPECT_NEAR(geodesics.distance(v), (std::min)(to_rim, to_border), 1e-6);
  }
}

// Two squares that have one vertex, as the rest between excluded regions, or by themselves.
TEST(Excluded_faces, a_vertex_of_several_fans_is_the_same_with_and_without_them)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for(const Point& p : {Point(0., 0., 0.), Point(1., 0., 0.), Point(1., 1., 0.), Point(0., 1., 0.), Point(2., 1., 0.),
                        Point(2., 2., 0.), Point(1., 2., 0.)})
    v.push_back(mesh.add_vertex(p));
  for(const std::array<int, 3>& t : {std::array<int, 3>{{0, 1, 2}}, {{0, 2, 3}}, {{2, 4, 5}}, {{2, 5, 6}}})
    ASSERT_NE(mesh.add_face(v[t[0]], v[t[1]], v[t[2]]), Mesh::null_face());
  Excluded excluded = mesh.add_property_map<Face, bool>("f:excluded", false).first;
  for(std::size_t number_of_excluded : {0, 1})
  {
    excluded[Face(1)] = number_of_excluded == 1;
    Geodesics geodesics(mesh, without(excluded));
    geodesics.compute(v[1]);
    EXPECT_NEAR(geodesics.distance(v[2]), 1., 1e-12);
    EXPECT_EQ(geodesics.distance(v[5]), infinity);
    expect_words([&] { geodesics.compute(v[2]); }, {"the faces around the source form several fans"});
    Location at_fan(Face(3), {{0., 0., 0.}});
    Mesh::Halfedge_index h = mesh.halfedge(Face(3));
    for(double& coordinate : at_fan.second)
    {
      coordinate = mesh.source(h) == v[2] ? 1. : 0.;
      h = mesh.next(h);
    }
    geodesics.compute(at_fan);
    EXPECT_NEAR(geodesics.distance(v[5]), std::sqrt(2.), 1e-12);
    EXPECT_EQ(geodesics.distance(v[2]), 0.);
    EXPECT_EQ(geodesics.distance(v[0]), infinity);
  }
  EXPECT_EQ(message_of(
              [&]
              {
    Geodesics all(mesh);
    all.compute(v[1]);
  }),
            "nothing was thrown");
}

TEST(Excluded_faces, bad_input)
{
  Mesh mesh = plate<Mesh>(6);
  Excluded excluded = mesh.add_property_map<Face, bool>("f:excluded", true).first;
  expect_words([&] { Geodesics geodesics(mesh, without(excluded)); }, {"all faces of the mesh are excluded"});
  // two squares of cells that touch at (3, 3)
  for(Face f : mesh.faces())
  {
    const Point p = center(mesh, f);
    excluded[f] =
      (p.x() > 1. && p.x() < 3. && p.y() > 1. && p.y() < 3.) || (p.x() > 3. && p.x() < 5. && p.y() > 3. && p.y() < 5.);
  }
  const auto vertex_at = [&](double x, double y)
  {
    return *std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                         [&](Vertex v) { return mesh.point(v) == Point(x, y, 0.); });
  };
  const auto face_at = [&](double x, double y)
  {
    return *std::find_if(mesh.faces().begin(), mesh.faces().end(),
                         [&](Face f) { return distance(center(mesh, f), Point(x, y, 0.)) < 0.4; });
  };
  const Vertex isolated = mesh.add_vertex(Point(9., 9., 9.));
  Geodesics geodesics(mesh, without(excluded));
  const auto message = [&](const auto& source) { return message_of([&] { geodesics.compute(source); }); };
  expect_has(message(vertex_at(2., 2.)), "all faces at the source are excluded");
  expect_has(message(isolated), "isolated vertex");
  expect_has(message(vertex_at(3., 3.)), "the faces around the source form several fans");
  expect_has(message(center_location(face_at(2.5, 2.5))), "in an excluded face");
  expect_words([&] { geodesics.add_query(center_location(face_at(2.5, 2.5))); }, {"in an excluded face"});
  const auto h = mesh.halfedge(vertex_at(2., 2.));
  expect_words([&] { geodesics.add_source_curve(Edges{mesh.edge(h)}); }, {"are excluded"});

  // no way leads between the regions, but the point where they touch has the distance of the nearer side
  geodesics.compute(vertex_at(3., 1.));
  EXPECT_NEAR(geodesics.distance(vertex_at(3., 3.)), 2., 1e-12);
  EXPECT_NEAR(geodesics.distance(vertex_at(2., 3.)), 5., 1e-12);
  geodesics.compute(vertex_at(1., 3.));
  EXPECT_NEAR(geodesics.distance(vertex_at(3., 3.)), 2., 1e-12);
  std::vector<Location> path;
  geodesics.shortest_path(vertex_at(3., 3.), std::back_inserter(path));
  ASSERT_FALSE(path.empty());
  EXPECT_LT(distance(point(mesh, path.back()), Point(1., 3., 0.)), 1e-12);
}

TEST(Excluded_faces, messages_number_faces_as_the_user_does)
{
  Mesh mesh = plate<Mesh>(2);
  Excluded excluded = mesh.add_property_map<Face, bool>("f:excluded", false).first;
  auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1.).first;
  excluded[Face(0)] = excluded[Face(1)] = true;
  const auto is_shared = [&](Mesh::Halfedge_index h)
  {
    const Face f = mesh.face(mesh.opposite(h));
    return f != Mesh::null_face() && !excluded[f];
  };
  for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(Face(5)), mesh))
    if(!is_shared(h))
    {
      length[mesh.edge(h)] = 5.;
      break;
    }
  expect_words([&] { Geodesics geodesics(mesh, without(excluded).edge_length_map(length)); }, {"face #5"});
}

} // namespace

} // namespace test_excluded_faces
