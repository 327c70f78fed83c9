// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "curve_sources_cases.h"
#include "distance_by_points.h"

#include <CGAL/exact_geodesic_distances.h>

// Exact distances, nearest sources and paths from curves and borders, by the public class.

namespace test_exact_geodesics_of_curves {

namespace {

using refusals::expect_words;
using namespace curve_sources;

// of the longest edge: what dense points on curves are off by
constexpr double exact = 1e-9;

/// a walk along edges at random, which may meet itself
Edges walk(const Mesh& mesh, std::size_t length, std::mt19937& random)
{
  Edges result;
  Mesh::Halfedge_index h(static_cast<Mesh::size_type>(random() % mesh.number_of_halfedges()));
  while(result.size() < length)
  {
    result.push_back(mesh.edge(h));
    for(unsigned turns = 1 + random() % 4; turns > 0; --turns)
      h = mesh.opposite(mesh.next(h));
    h = mesh.opposite(h);
  }
  return result;
}

/// whether a location is on one of the edges
bool is_on(const Mesh& mesh, const Edges& edges, const Location& at)
{
  Mesh::Halfedge_index h = mesh.halfedge(at.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    if(at.second[(i + 2) % 3] < 1e-9 && std::find(edges.begin(), edges.end(), mesh.edge(h)) != edges.end())
      return true;
  // at a vertex of one in another face
  h = mesh.halfedge(at.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    if(at.second[i] > 1. - 1e-9)
      for(const Mesh::Halfedge_index g : mesh.halfedges_around_target(mesh.opposite(h)))
        if(std::find(edges.begin(), edges.end(), mesh.edge(g)) != edges.end())
          return true;
  return false;
}

struct Sources
{
  std::vector<Location> points;
  std::vector<Edges> curves;
};

/// all that the class finds, against waves that start at the targets
void expect_right(const Built& built, const Sources& sources, unsigned seed)
{
  const Mesh& mesh = built.mesh;
  const double scale = longest_edge(mesh);
  Geodesics geodesics(mesh);
  for(const Edges& curve : sources.curves)
    geodesics.add_source_curve(curve);
  for(const Location& point : sources.points)
    geodesics.add_source(point);
  std::mt19937 random(seed);
  std::vector<Location> queries;
  for(int i = 0; i < 12; ++i)
  {
    queries.push_back(random_location(mesh, random));
    geodesics.add_query(queries.back());
  }
  geodesics.compute();
  ASSERT_EQ(geodesics.number_of_sources(), sources.points.size() + sources.curves.size());
  std::vector<Distance_by_points<Built>> of_curve;
  for(const Edges& curve : sources.curves)
    of_curve.emplace_back(built, std::vector<Edges>{curve});
  Geodesics back(mesh);
  for(const Location& point : sources.points)
    back.add_query(point);
  const auto expect = [&](const auto& target, double found, std::size_t nearest, const std::vector<Location>& path)
  {
    std::vector<double> expected;
    back.compute(target);
    for(std::size_t i = 0; i < sources.points.size(); ++i)
      expected.push_back(back.distance(Geodesics::Query{i}));
    for(const Distance_by_points<Built>& distance : of_curve)
      expected.push_back(distance(target));
    const double least = *std::min_element(expected.begin(), expected.end());
    EXPECT_NEAR(found, least, exact * scale);
    ASSERT_LT(nearest, expected.size());
    EXPECT_NEAR(expected[nearest], least, exact * scale);
    ASSERT_FALSE(path.empty());
    EXPECT_NEAR(length(mesh, path), found, exact * scale);
    if(nearest >= sources.points.size())
    {
      EXPECT_TRUE(is_on(mesh, sources.curves[nearest - sources.points.size()], path.back()));
    }
  };
  for(std::size_t i = 0; i < queries.size(); ++i)
  {
    std::vector<Location> path;
    geodesics.shortest_path(Geodesics::Query{i}, std::back_inserter(path));
    expect(queries[i], geodesics.distance(Geodesics::Query{i}), geodesics.nearest_source(Geodesics::Query{i}), path);
    path.clear();
    geodesics.shortest_path(queries[i], std::back_inserter(path));
    expect(queries[i], geodesics.distance(queries[i]), geodesics.nearest_source(queries[i]), path);
  }
  for(int i = 0; i < 8; ++i)
  {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices()));
    std::vector<Location> path;
    geodesics.shortest_path(v, std::back_inserter(path));
    expect(v, geodesics.distance(v), geodesics.nearest_source(v), path);
  }
}

TEST(Exact_geodesics_of_curves, agree_with_dense_points_on_random_surfaces)
{
  for(unsigned seed = 0; seed < 24; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh_data data = seed % 4 == 0   ? random_convex_polyhedron(12 + seed, seed)
                           : seed % 4 == 1 ? irregular_bumpy_sphere(5, 0.4, seed)
                           : seed % 4 == 2 ? torus(2., 0.7, 9, 6, 0.3, seed)
                                           : without_ball(bumpy_sphere(6, 0.3, seed), {{0., 0., 1.}}, 0.6);
    const Built built(data);
    std::mt19937 random(seed);
    Sources sources;
    for(unsigned i = 0; i < 1 + seed % 3; ++i)
      sources.curves.push_back(walk(built.mesh, 1 + random() % 6, random));
    for(unsigned i = 0; i < seed % 5 / 2; ++i)
      sources.points.push_back(random_location(built.mesh, random));
    expect_right(built, sources, seed);
  }
}

TEST(Exact_geodesics_of_curves, with_the_border_are_those_of_its_loops)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const Built built(without_ball(without_ball(bumpy_sphere(7, 0.3, seed), {{0., 0., 1.}}, 0.6), {{1., 0., 0.}}, 0.4));
    expect_right(built, {{}, border_loops(built)}, seed);
    std::map<Mesh::Vertex_index, double> all, of_loops;
    CGAL::exact_geodesic_distances(built.mesh, Vertices(), boost::make_assoc_property_map(all),
                                   params::source_border(true));
    CGAL::exact_geodesic_distances(built.mesh, Vertices(), boost::make_assoc_property_map(of_loops),
                                   params::source_curves(border_loops(built)));
    EXPECT_EQ(all, of_loops);
  }
}

/// in a square, the nearest of the sides; and a maximum distance takes nothing else away
TEST(Exact_geodesics_of_curves, of_a_square_are_those_to_its_sides)
{
  const Built built(square(9, 0.3, 4));
  Geodesics geodesics(built.mesh);
  geodesics.add_source_border();
  for(const Mesh::Face_index f : built.mesh.faces())
    geodesics.add_query(Location(f, {{1. / 3., 1. / 3., 1. / 3.}}));
  for(const double most : {std::numeric_limits<double>::infinity(), 0.21, 0.})
  {
    geodesics.set_maximum_distance(most);
    geodesics.compute();
    const auto expect = [&](double x, double y, double found)
    {
      const double d = std::min(std::min(x, 1. - x), std::min(y, 1. - y));
      if(d > most)
        EXPECT_EQ(found, std::numeric_limits<double>::infinity());
      else
        EXPECT_NEAR(found, d, 1e-7);
    };
    for(const Mesh::Vertex_index v : built.mesh.vertices())
      expect(built.mesh.point(v).x(), built.mesh.point(v).y(), geodesics.distance(v));
    for(const Mesh::Face_index f : built.mesh.faces())
    {
      const auto p =
        CGAL::Polygon_mesh_processing::construct_point(Location(f, {{1. / 3., 1. / 3., 1. / 3.}}), built.mesh);
      expect(p.x(), p.y(), geodesics.distance(Geodesics::Query{f.idx()}));
    }
  }
}

/// the same curve twice, and curves that cross, are as good as one; what comes after has no curves left
TEST(Exact_geodesics_of_curves, may_meet)
{
  const Built built(bumpy_sphere(8, 0.3, 5));
  std::mt19937 random(7);
  const Edges curve = walk(built.mesh, 12, random);
  Geodesics geodesics(built.mesh), whole(built.mesh);
  whole.add_source_curve(curve);
  whole.compute();
  geodesics.add_source_curve(curve);
  geodesics.add_source_curve(curve);
  for(const Mesh::Edge_index e : curve)
    geodesics.add_source_curve(Edges{e});
  geodesics.compute();
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    EXPECT_NEAR(geodesics.distance(v), whole.distance(v), 1e-12);
  const Mesh::Vertex_index first(0);
  geodesics.set_directions(true);
  geodesics.compute(first);
  whole.clear_sources();
  whole.compute(first);
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    EXPECT_EQ(geodesics.distance(v), whole.distance(v));
  EXPECT_NO_THROW(geodesics.exponential_map({{0.1, 0.2}}));
}

TEST(Exact_geodesics_of_curves, are_refused_where_they_make_no_sense)
{
  const Built built(icosahedron());
  Geodesics geodesics(built.mesh);
  const Edges edges(built.mesh.edges().begin(), built.mesh.edges().end());
  expect_words([&] { geodesics.add_source_curve(Edges()); }, {"source curve 0: it has no edges"});
  expect_words([&] { geodesics.add_source_border(); }, {"no border"});
  EXPECT_EQ(geodesics.number_of_sources(), 0u);
  const auto are_apart = [&](Mesh::Edge_index e)
  {
    for(int i = 0; i < 2; ++i)
      for(int k = 0; k < 2; ++k)
        if(built.mesh.vertex(e, i) == built.mesh.vertex(edges.front(), k))
          return false;
    return true;
  };
  const Edges apart = {edges.front(), *std::find_if(edges.begin(), edges.end(), are_apart)};
  expect_words([&] { geodesics.add_source_curve(apart); }, {"source curve 0: it is not connected"});
  geodesics.add_source(Mesh::Vertex_index(0));
  geodesics.add_source_curve(Edges{edges.back()});
  geodesics.set_directions(true);
  expect_words([&] { geodesics.compute(); }, {"leave out the curves"});
  expect_words([&] { geodesics.distance(Mesh::Vertex_index(0)); }, {"nothing has been computed"});
  geodesics.set_directions(false);
  geodesics.set_maximum_relative_error(0.01);
  expect_words([&] { geodesics.compute(); }, {"leave out the curves"});
  geodesics.set_maximum_relative_error(0.);
  geodesics.compute();
  EXPECT_GT(geodesics.source_angle(0), 0.);
  expect_words([&] { geodesics.source_angle(1); }, {"no source 1 that is a point"});
  expect_words([&] { geodesics.source_halfedge(1); }, {"no source 1 that is a point"});
  expect_words([&] { geodesics.exponential_map({{0., 0.}}, 1); }, {"no source 1 that is a point"});
}

} // namespace

} // namespace test_exact_geodesics_of_curves
