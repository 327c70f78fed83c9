// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What must hold for exact geodesics on any surface.

#include "exact_geodesics_test_meshes.h"

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_bucket_queue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace test_exact_geodesics_properties {

namespace {

using namespace test_meshes;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double exact = 1e-10;

std::vector<Mesh> some_meshes()
{
  std::vector<Mesh> meshes;
  meshes.push_back(bumpy_grid(16, 13, 0.4, 1, 0.2));
  meshes.push_back(perforated(bumpy_grid(20, 20, 0.2, 2, 0.2), 0.15, 3));
  meshes.push_back(torus(24, 12, 0.2, 4));
  meshes.push_back(doubled(perforated(bumpy_grid(14, 14, 0.3, 5), 0.1, 6),
                           [](const Point& p) {
    return Point{{p[0], p[1], p[2] + 0.5}};
  }));
  meshes.push_back(box({{3., 2., 1.}}, {{6, 4, 3}}));
  meshes.push_back(perforated(flat_grid(18, 18, 7), 0.2, 8));
  return meshes;
}

/// those on which hardly any vertex has two shortest paths, and thus one direction each
std::vector<Mesh> meshes_without_ties()
{
  std::vector<Mesh> meshes = some_meshes();
  meshes.resize(4);
  return meshes;
}

double distance_between(Geodesics& geodesics, const Indexed_location& source, const Indexed_location& target)
{
  Options options;
  options.queries.push_back(target);
  geodesics.run({source}, options);
  return geodesics.query_distance(0);
}

TEST(Exact_geodesics, symmetry)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh);
    std::mt19937 random(11);
    for(unsigned i = 0; i < 60; ++i)
    {
      const Indexed_location a = random_location(mesh, random, i), b = random_location(mesh, random, i / 3);
      const double ab = distance_between(geodesics, a, b), ba = distance_between(geodesics, b, a);
      EXPECT_NEAR(ab, ba, exact * ab);
    }
  }
}

TEST(Exact_geodesics, triangle_inequality_and_lower_bound)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh);
    std::mt19937 random(12);
    std::vector<std::vector<double>> distances;
    std::vector<Index> sources;
    for(unsigned i = 0; i < 12; ++i)
    {
      sources.push_back(Index(random() % mesh.number_of_vertices()));
      geodesics.run(sources.back());
      distances.push_back(geodesics.distances());
      EXPECT_EQ(distances[i][sources[i]], 0.);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        EXPECT_GE(distances[i][v], (1. - 1e-12) * distance(mesh.points[sources[i]], mesh.points[v]));
      for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
        EXPECT_LE(distances[i][mesh.source(h)],
                  distances[i][mesh.target(h)] +
                    (1. + exact) * distance(mesh.points[mesh.source(h)], mesh.points[mesh.target(h)]));
    }
    for(std::size_t i = 0; i < sources.size(); ++i)
      for(std::size_t j = 0; j < sources.size(); ++j)
        for(Index v = 0; v < mesh.number_of_vertices(); ++v)
          EXPECT_LE(distances[i][v], (distances[i][sources[j]] + distances[j][v]) * (1. + exact));
  }
}

TEST(Exact_geodesics, paths_are_straight_and_as_long_as_the_distance)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh);
    Path_tracing tracing(geodesics);
    std::mt19937 random(13);
    for(unsigned i = 0; i < 12; ++i)
    {
      Options options;
      for(unsigned k = 0; k < 30; ++k)
        options.queries.push_back(random_location(mesh, random, k));
      std::vector<Indexed_location> sources;
      for(unsigned k = 0; k <= i / 6; ++k)
        sources.push_back(random_location(mesh, random, i + k));
      geodesics.run(sources, options);
      for(Index v = i % 5; v < mesh.number_of_vertices(); v += 5)
      {
        const std::vector<Indexed_location> path = tracing.path_from_query(geodesics.at_vertex(v));
        EXPECT_EQ(defect_of_path(geodesics, mesh, path, mesh.points[v], geodesics.distance(v)), "") << "vertex " << v;
        EXPECT_LE(distance(point(mesh, path.back()), point(mesh, sources[geodesics.nearest_source(v)])), 1e-12);
      }
      for(std::size_t q = 0; q < options.queries.size(); ++q)
      {
        const std::vector<Indexed_location> path = tracing.path_from_query(geodesics.answer(q));
        EXPECT_EQ(defect_of_path(geodesics, mesh, path, point(mesh, options.queries[q]), geodesics.query_distance(q)),
                  "")
          << "query " << q;
      }
    }
  }
}

TEST(Exact_geodesics, path_from_the_source_is_one_point)
{
  const Mesh mesh = bumpy_grid(5, 5, 0.3, 1);
  Geodesics geodesics(mesh);
  geodesics.run(7);
  EXPECT_EQ(Path_tracing(geodesics).path_from_query(geodesics.at_vertex(7)).size(), 1u);
  Options options;
  options.queries.push_back(location(3, 0.2, 0.3, 0.5));
  geodesics.run({location(3, 0.2, 0.3, 0.5)}, options);
  EXPECT_EQ(geodesics.query_distance(0), 0.);
  EXPECT_EQ(Path_tracing(geodesics).path_from_query(geodesics.answer(0)).size(), 1u);
}

TEST(Exact_geodesics, first_and_last_steps_of_paths_have_the_directions_told)
{
  for(const Mesh& mesh : meshes_without_ties())
  {
    Geodesics geodesics(mesh);
    Path_tracing tracing(geodesics);
    std::mt19937 random(14);
    Options options;
    options.directions = true;
    for(unsigned i = 0; i < 10; ++i)
    {
      const Index s = Index(random() % mesh.number_of_vertices());
      geodesics.run(s, options);
      EXPECT_DOUBLE_EQ(geodesics.source_angle(), geodesics.faces().total_angle(s));
      // the angle at a vertex of the step to `to`, of which a face with the vertex is known
      const auto unrolled = [&](Index v, const Point& to, Index f)
      {
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
          if(mesh.source(h) == v)
          {
            const Point& p = mesh.points[v];
            return geodesics.faces().angle_around_source(h) + angle(p, mesh.points[mesh.target(h)], to);
          }
        return -1.;
      };
      const auto difference = [&](Index v, double a, double b)
      {
        const double d = std::fabs(a - b);
        return geodesics.faces().is_border(v) ? d : (std::min)(d, std::fabs(d - geodesics.faces().total_angle(v)));
      };
      for(Index v = 0; v < mesh.number_of_vertices(); v += 3)
      {
        if(v == s)
          continue;
        const std::vector<Indexed_location> path = tracing.path_from_query(geodesics.at_vertex(v));
        ASSERT_GE(path.size(), 2u);
        const auto common = [&](const Indexed_location& a, const Indexed_location& b)
        {
          for(Index f : faces_around(mesh, a))
            if(faces_around(mesh, b).count(f))
              return f;
          return null_index;
        };
        const Indexed_location &second = path[1], &last_but_one = path[path.size() - 2];
        if(distance(point(mesh, second), mesh.points[v]) > 1e-3)
        {
          const double a = unrolled(v, point(mesh, second), common(path[0], second));
          EXPECT_LE(difference(v, geodesics.arrival_angle(v), a), 1e-8);
        }
        if(distance(point(mesh, last_but_one), mesh.points[s]) > 1e-3)
        {
          const double a = unrolled(s, point(mesh, last_but_one), common(path.back(), last_but_one));
          EXPECT_LE(difference(s, geodesics.direction_at_source(v), a), 1e-8);
        }
      }
    }
  }
}

TEST(Exact_geodesics, renumbering)
{
  for(const Mesh& mesh : some_meshes())
  {
    std::vector<Index> number;
    const Mesh other = renumbered(mesh, 15, number);
    Geodesics geodesics(mesh), others(other);
    for(Index s = 0; s < mesh.number_of_vertices(); s += 37)
    {
      geodesics.run(s);
      others.run(number[s]);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        EXPECT_NEAR(geodesics.distance(v), others.distance(number[v]), 1e-13 * geodesics.distance(v));
    }
  }
}

TEST(Exact_geodesics, flat_subdivision)
{
  for(const Mesh& mesh : some_meshes())
  {
    const Mesh fine = subdivided(mesh), uneven = subdivided(mesh, 0.3, 16);
    Geodesics geodesics(mesh), finer(fine), unevenly(uneven);
    for(Index s = 0; s < mesh.number_of_vertices(); s += 29)
    {
      geodesics.run(s);
      finer.run(s);
      unevenly.run(s);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      {
        EXPECT_NEAR(geodesics.distance(v), finer.distance(v), exact * geodesics.distance(v));
        EXPECT_NEAR(geodesics.distance(v), unevenly.distance(v), exact * geodesics.distance(v));
      }
      // each window crosses twice as many faces; what a flat vertex parts is put together again, mostly soon behind it
      EXPECT_LT(finer.number_of_windows(), 2.2 * geodesics.number_of_windows() + fine.number_of_halfedges());
    }
  }
}

TEST(Exact_geodesics, rigid_motion_and_scale)
{
  for(const Mesh& mesh : some_meshes())
  {
    Mesh moved = mesh;
    const double c = std::cos(0.7), s = std::sin(0.7), scale = 1e-3;
    for(Point& p : moved.points)
    {
      const Point q{{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]}};
      p = {{scale * (q[0] + 3.), scale * (c * q[1] - s * q[2] - 2.), scale * (s * q[1] + c * q[2] + 1.)}};
    }
    Geodesics geodesics(mesh), others(moved);
    for(Index source = 0; source < mesh.number_of_vertices(); source += 41)
    {
      geodesics.run(source);
      others.run(source);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        EXPECT_NEAR(geodesics.distance(v), others.distance(v) / scale, exact * geodesics.distance(v));
    }
  }
}

TEST(Exact_geodesics, several_sources_are_the_nearest_of_each)
{
  std::size_t number = 0;
  for(const Mesh& mesh : some_meshes())
  {
    const bool has_directions = number++ < meshes_without_ties().size();
    Geodesics geodesics(mesh);
    std::mt19937 random(17);
    for(unsigned i = 0; i < 8; ++i)
    {
      Options options;
      options.directions = true;
      options.queries = centroids(mesh);
      std::vector<Indexed_location> sources;
      for(unsigned k = 0; k < 2 + i; ++k)
        sources.push_back(random_location(mesh, random, k + i));
      // two in one face
      sources.push_back(sources[0]);
      sources.back().coordinates = {{0.2, 0.3, 0.5}};
      std::vector<double> nearest(mesh.number_of_vertices(), infinity),
        nearest_centroid(mesh.number_of_faces(), infinity);
      std::vector<std::vector<double>> single, directions;
      for(const Indexed_location& source : sources)
      {
        geodesics.run({source}, options);
        single.push_back(geodesics.distances());
        directions.emplace_back();
        for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        {
          nearest[v] = (std::min)(nearest[v], geodesics.distance(v));
          directions.back().push_back(geodesics.distance(v) > 0. ? geodesics.direction_at_source(v) : 0.);
        }
        for(Index f = 0; f < mesh.number_of_faces(); ++f)
          nearest_centroid[f] = (std::min)(nearest_centroid[f], geodesics.query_distance(f));
      }
      geodesics.run(sources, options);
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      {
        EXPECT_NEAR(geodesics.distance(v), nearest[v], exact * nearest[v]);
        const Index n = geodesics.nearest_source(v);
        ASSERT_LT(n, sources.size());
        EXPECT_NEAR(single[n][v], nearest[v], exact * nearest[v]);
        if(has_directions && nearest[v] > 0.)
        {
          const double turn = std::fabs(geodesics.direction_at_source(v) - directions[n][v]);
          if(turn > 1e-9 && std::fabs(turn - geodesics.source_angle(n)) > 1e-9)
            ADD_FAILURE() << "direction of vertex " << v << " off by " << turn;
        }
      }
      for(Index f = 0; f < mesh.number_of_faces(); ++f)
        EXPECT_NEAR(geodesics.query_distance(f), nearest_centroid[f], exact * nearest_centroid[f]);
    }
  }
}

TEST(Exact_geodesics, maximum_distance)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh), bounded(mesh);
    Options options;
    options.queries = centroids(mesh);
    for(Index s = 0; s < mesh.number_of_vertices(); s += 31)
    {
      geodesics.run(s, options);
      const std::size_t windows = geodesics.number_of_windows();
      Options limit = options;
      for(const double d : {0.3, 1.7, 5.2})
      {
        limit.maximum_distance = d;
        bounded.run(s, limit);
        for(Index v = 0; v < mesh.number_of_vertices(); ++v)
          if(std::fabs(geodesics.distance(v) - d) > exact)
          {
            EXPECT_EQ(bounded.distance(v), geodesics.distance(v) < d ? geodesics.distance(v) : infinity);
          }
        for(Index f = 0; f < mesh.number_of_faces(); ++f)
          if(geodesics.query_distance(f) > d + exact)
          {
            EXPECT_EQ(bounded.query_distance(f), infinity);
          }
          else if(geodesics.query_distance(f) < d - exact)
          {
            EXPECT_NEAR(bounded.query_distance(f), geodesics.query_distance(f), exact);
          }
        for(Index f = 0; f < mesh.number_of_faces(); f += 17)
          if(const double found = Point_search(bounded, d)(bounded.answer(f).location).distance;
             geodesics.query_distance(f) > d + exact)
          {
            EXPECT_EQ(found, infinity);
          }
          else if(geodesics.query_distance(f) < d - exact)
          {
            EXPECT_NEAR(found, geodesics.query_distance(f), exact);
          }
        EXPECT_LE(bounded.number_of_windows(), windows);
      }
    }
  }
}

/// a point that is looked for is as far away as the vertex that is put there, on all kinds of meshes
TEST(Exact_geodesics, points_are_vertices_that_are_put_there)
{
  for(const Mesh& mesh : some_meshes())
  {
    std::mt19937 random(3);
    std::vector<Indexed_location> sources;
    Geodesics geodesics(mesh);
    for(unsigned k = 0; k < 3; ++k)
    {
      sources.push_back(random_location(mesh, random, k));
      geodesics.run(sources);
      for(int i = 0; i < 5; ++i)
      {
        const Indexed_location p = random_location(mesh, random, 0);
        std::vector<Point> points = mesh.points;
        std::vector<Mesh::Triangle> triangles = mesh.triangles;
        const Index v = mesh.number_of_vertices();
        const Mesh::Triangle t = triangles[p.face];
        points.push_back(point(mesh, p));
        triangles[p.face] = {{t[0], t[1], v}};
        triangles.push_back({{t[1], t[2], v}});
        triangles.push_back({{t[2], t[0], v}});
        Geodesics of_vertex(make_mesh(points, triangles));
        Options to_sources;
        for(const Indexed_location& source : sources)
          if(source.face != p.face) // which is divided
            to_sources.queries.push_back(source);
        of_vertex.run(v, to_sources);
        double expected = infinity;
        for(std::size_t q = 0; q < of_vertex.number_of_queries(); ++q)
          expected = (std::min)(expected, of_vertex.query_distance(q));
        if(to_sources.queries.size() == sources.size())
        {
          EXPECT_NEAR(Point_search(geodesics)(p).distance, expected, exact * expected);
        }
      }
    }
  }
}

TEST(Exact_geodesics, other_components_are_not_reached)
{
  Mesh mesh = bumpy_grid(6, 6, 0.2, 1);
  const Index vertices = mesh.number_of_vertices(), faces = mesh.number_of_faces();
  std::vector<Point> points = mesh.points;
  std::vector<Mesh::Triangle> triangles = mesh.triangles;
  for(const Point& p : mesh.points)
    points.push_back({{p[0], p[1], p[2] + 5.}});
  for(const Mesh::Triangle& t : mesh.triangles)
    triangles.push_back({{t[0] + vertices, t[1] + vertices, t[2] + vertices}});
  mesh = make_mesh(points, triangles);
  Geodesics geodesics(mesh);
  Options options;
  options.queries = centroids(mesh);
  geodesics.run(3, options);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    EXPECT_EQ(geodesics.is_reached(v), v < vertices);
    EXPECT_EQ(geodesics.distance(v) < infinity, v < vertices);
    EXPECT_EQ(geodesics.nearest_source(v), v < vertices ? 0 : null_index);
    EXPECT_EQ(Path_tracing(geodesics).path_from_query(geodesics.at_vertex(v)).empty(), v >= vertices);
  }
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
  {
    EXPECT_EQ(geodesics.query_distance(f) < infinity, f < faces);
    EXPECT_EQ(Path_tracing(geodesics).path_from_query(geodesics.answer(f)).empty(), f >= faces);
    EXPECT_EQ(Point_search(geodesics)(geodesics.answer(f).location).distance < infinity, f < faces);
  }
}

TEST(Exact_geodesics, the_same_again)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh), other(mesh);
    Options options;
    options.directions = true;
    geodesics.run(5, options);
    const std::vector<double> first = geodesics.distances();
    std::vector<double> directions;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      directions.push_back(v == 5 ? 0. : geodesics.direction_at_source(v));
    geodesics.run({location(2, 0.1, 0.2, 0.7), location(9, 0., 0.2, 0.8)}, options);
    geodesics.run(5);
    EXPECT_EQ(geodesics.distances(), first);
    other.run(5, options);
    EXPECT_EQ(other.distances(), first);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      EXPECT_EQ(v == 5 ? 0. : other.direction_at_source(v), directions[v]);
  }
}

TEST(Exact_geodesics, source_at_a_vertex_is_the_same_in_each_face)
{
  const Mesh mesh = bumpy_grid(8, 8, 0.5, 3);
  Geodesics geodesics(mesh);
  for(Index h = 0; h < mesh.number_of_halfedges(); h += 5)
  {
    geodesics.run(mesh.source(h));
    const std::vector<double> expected = geodesics.distances();
    Indexed_location location;
    location.face = h / 3;
    location.coordinates[h % 3] = 1.;
    geodesics.run({location});
    EXPECT_EQ(geodesics.distances(), expected);
    // as point location leaves it
    location.coordinates[Mesh::next(h) % 3] = -5.6e-17;
    geodesics.run({location});
    EXPECT_EQ(geodesics.distances(), expected);
  }
}

TEST(Exact_geodesics, distance_is_continuous_in_the_source)
{
  const Mesh mesh = bumpy_grid(9, 9, 0.4, 4);
  Geodesics geodesics(mesh);
  for(Index f = 0; f < mesh.number_of_faces(); f += 7)
  {
    geodesics.run(mesh.triangles[f][0]);
    const std::vector<double> expected = geodesics.distances();
    for(double e = 1e-3; e > 1e-17; e *= 0.1)
    {
      for(int k = 0; k < 3; ++k)
      {
        geodesics.run({location(f, 1. - e, k == 0 ? 0. : k == 1 ? e : 0.5 * e, k == 0 ? e : k == 1 ? 0. : 0.5 * e)});
        for(Index v = 0; v < mesh.number_of_vertices(); ++v)
          ASSERT_NEAR(geodesics.distance(v), expected[v], 4. * e + 1e-12) << "face " << f << ", off by " << e;
      }
    }
  }
}

TEST(Exact_geodesics, source_on_an_edge_is_a_vertex_of_the_split_edge)
{
  for(const Mesh& mesh : some_meshes())
  {
    Geodesics geodesics(mesh);
    for(Index h = 2; h < mesh.number_of_halfedges(); h += 97)
    {
      std::vector<char> is_marked(mesh.number_of_halfedges(), 0);
      is_marked[h] = 1;
      if(!mesh.is_border_edge(h))
        is_marked[mesh.opposite[h]] = 1;
      const Mesh split = split_edges(mesh, is_marked);
      Geodesics other(split);
      Indexed_location middle;
      middle.face = h / 3;
      middle.coordinates[h % 3] = middle.coordinates[Mesh::next(h) % 3] = 0.5;
      geodesics.run({middle});
      other.run(mesh.number_of_vertices());
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        EXPECT_NEAR(geodesics.distance(v), other.distance(v), exact * other.distance(v));
    }
  }
}

TEST(Exact_geodesics, bad_input_is_named)
{
  const auto message = [](const Mesh& mesh)
  {
    try
    {
      Geodesics geodesics(mesh);
    }
    catch(const CGAL::Cut_loci::Invalid_input& e)
    {
      return std::string(e.what());
    }
    return std::string();
  };
  const Mesh good = bumpy_grid(4, 4, 0.3, 1);
  EXPECT_EQ(message(good), "");
  Mesh bad = good;
  bad.points[7][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(bad).find("vertex #7 "), std::string::npos) << message(bad);
  bad.points[7][1] = infinity;
  EXPECT_NE(message(bad).find("vertex #7 "), std::string::npos) << message(bad);
  bad = good;
  const Mesh::Triangle& t = good.triangles[9];
  for(std::size_t k = 0; k < 3; ++k)
    bad.points[t[0]][k] = 0.5 * (good.points[t[1]][k] + good.points[t[2]][k]);
  EXPECT_NE(message(bad).find("face #9 "), std::string::npos) << message(bad);
  // two triangles that share one vertex only
  const Mesh bow_tie = make_mesh({{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}, {{-1., 0., 0.}}, {{0., -1., 0.}}},
                                 {{{1, 2, 0}}, {{3, 4, 0}}});
  EXPECT_NE(message(bow_tie).find("vertex #0 "), std::string::npos) << message(bow_tie);
  // two closed surfaces that share one vertex only
  Mesh cubes = box({{1., 1., 1.}}, {{1, 1, 1}});
  std::vector<Point> points = cubes.points;
  std::vector<Mesh::Triangle> triangles = cubes.triangles;
  for(std::size_t v = 1; v < cubes.points.size(); ++v)
    points.push_back({{-cubes.points[v][0], -cubes.points[v][1], cubes.points[v][2]}});
  for(const Mesh::Triangle& c : cubes.triangles)
  {
    Mesh::Triangle copy = c;
    for(Index& v : copy)
      v = v == 0 ? 0 : v + Index(cubes.points.size()) - 1;
    triangles.push_back(copy);
  }
  EXPECT_NE(message(make_mesh(points, triangles)).find("vertex #0 "), std::string::npos);

  Geodesics geodesics(good);
  EXPECT_THROW(geodesics.run(std::vector<Indexed_location>()), std::invalid_argument);
  EXPECT_THROW(geodesics.run(null_index), std::invalid_argument);
  EXPECT_THROW(geodesics.run({location(null_index, 1., 0., 0.)}), std::invalid_argument);
  EXPECT_THROW(geodesics.run({location(0, 0.5, 0., 0.)}), std::invalid_argument);
  EXPECT_THROW(geodesics.run({location(0, 1.5, -0.5, 0.)}), std::invalid_argument);
  EXPECT_THROW(geodesics.run({location(0, infinity, 0., 0.)}), std::invalid_argument);
  geodesics.run(0);
  EXPECT_EQ(geodesics.distance(0), 0.);
}

// Buckets get wider where keys need too many of them, also while some of their items have been taken.
TEST(Geodesic_bucket_queue, takes_items_in_order_however_far_keys_are_apart)
{
  const double width = 1e-3;
  CGAL::Cut_loci::internal::Geodesic_bucket_queue queue(width);
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  for(int run = 0; run < 2; ++run) // it starts with narrow buckets again
  {
    std::vector<double> keys;
    std::vector<unsigned char> is_taken;
    double largest = 0., last = 0.;
    const auto push = [&](double key)
    {
      queue.push(key, static_cast<CGAL::Cut_loci::Index>(keys.size()));
      keys.push_back(key);
      is_taken.push_back(0);
      largest = (std::max)(largest, key);
    };
    for(int i = 0; i < 10; ++i)
      push(10. * unit(engine));
    CGAL::Cut_loci::Index item;
    while(queue.pop(item))
    {
      EXPECT_FALSE(is_taken[item]);
      is_taken[item] = 1;
      const double wide = (std::max)(width, 2. * largest / 65536.); // no bucket is wider
      EXPECT_GE(keys[item], last - wide);
      last = (std::max)(last, keys[item]);
      if(keys.size() < 300)
        push(keys[item] * (1. + unit(engine)));
    }
    EXPECT_EQ(std::count(is_taken.begin(), is_taken.end(), 1), std::ptrdiff_t(keys.size()));
    EXPECT_GT(largest, 1e3); // wider buckets were needed
    queue.clear();
  }
}

} // namespace

} // namespace test_exact_geodesics_properties
