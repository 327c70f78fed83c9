// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/refine_along_polylines.h>

// Isolines: where they are known in closed form, and that they bound what is nearer on random surfaces.

namespace test_isolines {

namespace {

using namespace surface_test;
using Isoline = Geodesics::Isoline;
using Isolines = std::vector<Isoline>;

double largest_distance(const Mesh& mesh, const Geodesics& geodesics)
{
  double result = 0.;
  for(const Mesh::Vertex_index v : mesh.vertices())
    result = std::max(result, geodesics.distance(v));
  return result;
}

/// some between zero and the largest distance, and exactly those of vertices
std::vector<double> levels_and_vertices(const Mesh& mesh, const Geodesics& geodesics)
{
  std::set<double> result;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(geodesics.distance(v) > 0.)
      result.insert(geodesics.distance(v));
  const double largest = largest_distance(mesh, geodesics);
  for(int k = 1; k <= 25; ++k)
    result.insert(largest * k / 25.);
  return {result.begin(), result.end()};
}

struct Geodesics_with_isolines : Geodesics
{
  explicit Geodesics_with_isolines(const Mesh& mesh) : Geodesics(mesh) { set_isolines(true); }
};

Isolines isolines(const Geodesics& geodesics, const std::vector<double>& levels, double deviation)
{
  Isolines result;
  geodesics.isolines(levels, std::back_inserter(result), deviation);
  return result;
}

/// vertices are at the level, closed lines end where they begin, others on the border
void expect_right_places(const Mesh& mesh, Geodesics& geodesics, const Isolines& lines, double tolerance)
{
  geodesics.clear_queries();
  std::vector<double> expected;
  for(const Isoline& line : lines)
  {
    ASSERT_GE(line.locations.size(), 2u);
    const Kernel::Point_3 first = point(mesh, line.locations.front()), last = point(mesh, line.locations.back());
    if(line.is_closed)
      EXPECT_EQ(first, last);
    else
      for(const Location& end : {line.locations.front(), line.locations.back()})
      {
        bool is_on_border = false;
        Mesh::Halfedge_index h = mesh.halfedge(end.first);
        for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
          is_on_border = is_on_border || (end.second[(i + 2) % 3] == 0. && mesh.is_border(mesh.edge(h)));
        EXPECT_TRUE(is_on_border) << "level " << line.level;
      }
    for(const Location& location : line.locations)
    {
      geodesics.add_query(location);
      expected.push_back(line.level);
    }
  }
  geodesics.compute();
  for(std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(geodesics.distance(Geodesics::Query{i}), expected[i], tolerance) << "vertex " << i;
  geodesics.clear_queries();
}

void expect_closed(const Mesh& mesh, const Isolines& lines)
{
  for(const Isoline& line : lines)
    EXPECT_TRUE(line.is_closed || !CGAL::is_closed(mesh)) << "level " << line.level;
}

/// consecutive vertices are in one face: a point of an edge or a vertex is in several
void expect_connected(const Mesh& mesh, const Isolines& lines)
{
  const auto faces_at = [&](const Location& at)
  {
    std::set<Mesh::Face_index> result = {at.first};
    Mesh::Halfedge_index h = mesh.halfedge(at.first);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      if(at.second[(i + 2) % 3] == 0.)
        result.insert(mesh.face(mesh.opposite(h)));
    return result;
  };
  for(const Isoline& line : lines)
    for(std::size_t i = 0; i + 1 < line.locations.size(); ++i)
    {
      const std::set<Mesh::Face_index> here = faces_at(line.locations[i]), there = faces_at(line.locations[i + 1]);
      EXPECT_TRUE(std::any_of(here.begin(), here.end(),
                              [&](Mesh::Face_index f) { return f != Mesh::null_face() && there.count(f) != 0; }))
        << "level " << line.level << ", vertex " << i << " of " << line.locations.size();
    }
}

/// what is farther than a level has no part in its isolines
void expect_same_within(const Mesh& mesh, Geodesics& geodesics, const Isolines& lines,
                        const std::vector<double>& levels, double deviation)
{
  for(const double level : levels)
  {
    geodesics.set_maximum_distance(level);
    geodesics.compute();
    double expected = 0., found = 0.;
    for(const Isoline& line : lines)
      expected += line.level == level ? length(mesh, line.locations) : 0.;
    for(const Isoline& line : isolines(geodesics, {level}, deviation))
      found += length(mesh, line.locations);
    EXPECT_NEAR(found, expected, deviation) << "level " << level; // the arcs may be divided elsewhere
  }
  geodesics.set_maximum_distance(std::numeric_limits<double>::infinity());
  geodesics.compute();
}

// ---- closed forms

TEST(Isolines, of_a_plane_are_circles)
{
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    const Built built(square(9, 0.3, seed));
    const Mesh& mesh = built.mesh;
    std::mt19937 random(seed);
    Geodesics_with_isolines geodesics(mesh);
    const Location source(Mesh::Face_index(static_cast<Mesh::size_type>(mesh.number_of_faces() / 2 + seed)),
                          {{0.2, 0.3, 0.5}});
    geodesics.compute(source);
    const Kernel::Point_3 center = point(mesh, source);
    const double inner = std::min(std::min(center.x(), 1. - center.x()), std::min(center.y(), 1. - center.y()));
    const double deviation = 1e-6;
    const std::vector<double> levels = {1e-5, 0.3 * inner, 0.99 * inner, 1.1 * inner, 0.6};
    const Isolines lines = isolines(geodesics, levels, deviation);
    expect_right_places(mesh, geodesics, lines, 1e-9);
    expect_connected(mesh, lines);
    expect_same_within(mesh, geodesics, lines, levels, deviation);
    for(std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(std::count_if(lines.begin(), lines.end(), [&](const Isoline& l) { return l.level == levels[k]; }), 1);
      EXPECT_TRUE(lines[k].is_closed);
      EXPECT_LE(length(mesh, lines[k].locations), 2. * pi * levels[k] + 1e-12);
      EXPECT_GE(length(mesh, lines[k].locations), 2. * pi * (levels[k] - deviation));
    }
    for(const Isoline& line : lines)
    {
      EXPECT_EQ(line.is_closed, line.level < inner);
      double area = 0.;
      for(std::size_t i = 0; i + 1 < line.locations.size(); ++i)
      {
        const Kernel::Point_3 p = point(mesh, line.locations[i]), q = point(mesh, line.locations[i + 1]);
        EXPECT_GE(distance(CGAL::midpoint(p, q), center), line.level - deviation - 1e-12);
        area += (p.x() - center.x()) * (q.y() - center.y()) - (p.y() - center.y()) * (q.x() - center.x());
      }
      EXPECT_GT(area, 0.) << "what is nearer is on the left";
    }
  }
}

/// levels that vertices and tangents of edges have exactly
TEST(Isolines, through_vertices_are_whole)
{
  const Built built(grid(12, 12));
  const Mesh& mesh = built.mesh;
  const std::size_t middle = nearest_vertex(built.data, {{6., 6., 0.}});
  Geodesics_with_isolines geodesics(mesh);
  geodesics.compute(built.vertices[middle]);
  std::vector<double> levels;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(geodesics.distance(v) > 0. && geodesics.distance(v) < 4.99)
      levels.push_back(geodesics.distance(v));
  for(int i = 1; i < 12; ++i)
    levels.push_back(i * std::sqrt(0.125)); // how far diagonals are
  const Isolines lines = isolines(geodesics, levels, 1e-4);
  EXPECT_EQ(lines.size(), levels.size());
  for(const Isoline& line : lines)
    EXPECT_TRUE(line.is_closed) << line.level;
  expect_right_places(mesh, geodesics, lines, 1e-9);
}

/// a prism without its ends, on `n` sides of the length 1, with `m` rows
Mesh_data prism(std::size_t n, std::size_t m, unsigned seed)
{
  Mesh_data result;
  const double radius = 0.5 / std::sin(pi / double(n));
  for(std::size_t k = 0; k <= m; ++k)
    for(std::size_t i = 0; i < n; ++i)
      result.points.push_back({{radius * std::cos(2. * pi * double(i) / double(n)),
                                radius * std::sin(2. * pi * double(i) / double(n)), double(k)}});
  for(std::size_t k = 0; k < m; ++k)
    for(std::size_t i = 0; i < n; ++i)
      add_square(result, {{k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n, (k + 1) * n + i}});
  return with_diagonals_at_random(result, seed);
}

TEST(Isolines, of_a_cylinder_part_behind_it)
{
  const std::size_t n = 8, m = 20;
  const Built built(prism(n, m, 3));
  Geodesics_with_isolines geodesics(built.mesh);
  geodesics.compute(built.vertices[n * m / 2]);
  const std::vector<double> levels = {1., 3.9, 4.1, 7.3};
  const Isolines lines = isolines(geodesics, levels, 1e-7);
  expect_right_places(built.mesh, geodesics, lines, 1e-9);
  std::map<double, std::vector<double>> lengths;
  for(const Isoline& line : lines)
  {
    EXPECT_TRUE(line.is_closed);
    lengths[line.level].push_back(length(built.mesh, line.locations));
  }
  for(const double level : levels)
    if(level < 0.5 * double(n))
    {
      ASSERT_EQ(lengths[level].size(), 1u);
      EXPECT_NEAR(lengths[level][0], 2. * pi * level, 1e-5);
    }
    else
    {
      ASSERT_EQ(lengths[level].size(), 2u);
      for(const double found : lengths[level])
        EXPECT_NEAR(found, 2. * level * std::asin(0.5 * double(n) / level), 1e-5);
    }
}

/// around the tip, from a sharp cone to one of more than a full turn
TEST(Isolines, of_a_cone_are_as_long_as_its_angle)
{
  for(const double height : {3., 1., 0.2, -1.}) // below 0: a saddle
  {
    Mesh_data data;
    data.points.push_back({{0., 0., 0.}});
    const std::size_t n = 10;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double z = height > 0. ? height : (i % 2 == 0 ? 1. : -1.);
      data.points.push_back(
        {{std::cos(2. * pi * double(i) / double(n)), std::sin(2. * pi * double(i) / double(n)), z}});
      data.triangles.push_back({{0, 1 + i, 1 + (i + 1) % n}});
    }
    const Built built(data);
    Geodesics_with_isolines geodesics(built.mesh);
    geodesics.compute(built.vertices[0]);
    const Isolines lines = isolines(geodesics, {0.4}, 1e-7);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_NEAR(length(built.mesh, lines[0].locations), 0.4 * geodesics.source_angle(), 1e-5);
    expect_right_places(built.mesh, geodesics, lines, 1e-12);
  }
}

/// in largest distances
constexpr double rounding = 1e-9;

/// from the border of a square, they are squares
TEST(Isolines, of_the_border_of_a_square_are_squares)
{
  const Built built(square(7, 0.3, 2));
  Geodesics_with_isolines geodesics(built.mesh);
  geodesics.add_source_border();
  geodesics.compute();
  const Isolines lines = isolines(geodesics, {0.01, 0.2, 0.43}, 1e-6);
  ASSERT_EQ(lines.size(), 3u);
  for(const Isoline& line : lines)
  {
    EXPECT_TRUE(line.is_closed);
    EXPECT_NEAR(length(built.mesh, line.locations), 4. - 8. * line.level, 1e-4);
  }
  expect_right_places(built.mesh, geodesics, lines, rounding);
}

/// from both ends of a prism, at the distances of its rings of vertices
TEST(Isolines, of_the_border_of_a_cylinder_go_around)
{
  const std::size_t n = 12, m = 9;
  const Built built(prism(n, m, 5));
  Geodesics_with_isolines geodesics(built.mesh);
  geodesics.add_source_border();
  geodesics.compute();
  std::vector<double> levels;
  for(const Mesh::Vertex_index v : built.mesh.vertices())
    if(geodesics.distance(v) > 0.)
      levels.push_back(geodesics.distance(v));
  const Isolines lines = isolines(geodesics, levels, 1e-3);
  EXPECT_EQ(lines.size(), 2 * levels.size());
  for(const Isoline& line : lines)
  {
    EXPECT_TRUE(line.is_closed);
    EXPECT_NEAR(length(built.mesh, line.locations), double(n), 0.01);
  }
  expect_right_places(built.mesh, geodesics, lines, rounding);
}

// ---- random surfaces

Mesh_data random_surface(unsigned seed)
{
  switch(seed % 6)
  {
  case 0:
    return random_convex_polyhedron(10 + seed, seed);
  case 1:
    return irregular_bumpy_sphere(4 + seed % 3, 0.5, seed);
  case 2:
    return torus(2., 0.7, 9, 6, 0.3, seed);
  case 3:
    return without_ball(bumpy_sphere(5, 0.4, seed), {{0., 0., 1.}}, 0.6);
  case 4:
    return rough(cube(3), 0.4, seed);
  default:
    return scaled(bumpy_sphere(5, 0.5, seed), {{1., 1., 0.1}});
  }
}

/// the Euler characteristic of what is nearer than each level among the points that divide each side of a face into `n`
std::vector<long> characteristics_by_samples(const Mesh& mesh, Geodesics& geodesics, const std::vector<double>& levels,
                                             int n)
{
  using Key = std::array<long, 3>;
  std::map<Key, std::size_t> number; // of a point: by its vertex, edge or face
  const auto query = [&](Mesh::Face_index f, int i, int j)
  {
    const std::array<int, 3> c = {{n - i - j, i, j}};
    std::array<Mesh::Vertex_index, 3> v;
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
      v[k] = mesh.source(h);
    Key key = {{-1 - long(f), i, j}};
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      if(c[k] == n)
        key = {{long(v[k]), long(v[k]), 0}};
      else if(c[k] == 0 && c[a] > 0 && c[b] > 0)
        key = v[a] < v[b] ? Key{{long(v[a]), long(v[b]), c[b]}} : Key{{long(v[b]), long(v[a]), c[a]}};
    }
    const auto added = number.insert({key, number.size()});
    if(added.second)
      geodesics.add_query(Location(f, {{double(c[0]) / n, double(c[1]) / n, double(c[2]) / n}}));
    return added.first->second;
  };
  std::vector<std::array<std::size_t, 3>> triangles;
  geodesics.clear_queries();
  for(const Mesh::Face_index f : mesh.faces())
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j)
      {
        triangles.push_back({{query(f, i, j), query(f, i + 1, j), query(f, i, j + 1)}});
        if(i + j + 1 < n)
          triangles.push_back({{query(f, i + 1, j), query(f, i + 1, j + 1), query(f, i, j + 1)}});
      }
  geodesics.compute();
  std::vector<long> result;
  for(const double level : levels)
  {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    const auto is_nearer = [&](std::size_t i) { return geodesics.distance(Geodesics::Query{i}) < level; };
    long sum = 0;
    for(std::size_t i = 0; i < number.size(); ++i)
      sum += is_nearer(i);
    for(const auto& t : triangles)
    {
      sum += is_nearer(t[0]) && is_nearer(t[1]) && is_nearer(t[2]);
      for(std::size_t k = 0; k < 3; ++k)
        if(is_nearer(t[k]) && is_nearer(t[(k + 1) % 3]))
          edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
    }
    result.push_back(sum - long(edges.size()));
  }
  geodesics.clear_queries();
  return result;
}

/// The surface is divided along the isolines: on the two sides of each edge of them are a nearer face and one that is not,
/// elsewhere two of a kind. Returns the Euler characteristic of the nearer part.
long characteristic_by_isolines(const Mesh& mesh, const Isolines& lines, const std::vector<Location>& sources,
                                double level, double deviation)
{
  std::vector<std::vector<Location>> polylines;
  for(const Isoline& line : lines)
    polylines.push_back(line.locations);
  Mesh refined;
  std::set<Mesh::Edge_index> on_line;
  if(polylines.empty())
    refined = mesh;
  else
    for(const auto& part : CGAL::refine_along_polylines(mesh, polylines, refined, params::snapping_tolerance(1e-6)))
      on_line.insert(part.begin(), part.end());
  // a face is nearer if what is on the left of a line is, and so on across all other edges
  std::map<Mesh::Face_index, int> part_of;
  std::vector<double> farthest; // distance from the level, by part
  Geodesics geodesics(refined);
  for(const Mesh::Face_index f : refined.faces())
    geodesics.add_query(Location(f, {{1. / 3., 1. / 3., 1. / 3.}}));
  for(const Location& source : sources)
  {
    const Kernel::Point_3 p = point(mesh, source);
    geodesics.add_source(*std::min_element(refined.vertices().begin(), refined.vertices().end(),
                                           [&](auto v, auto w) {
      return CGAL::has_smaller_distance_to_point(p, refined.point(v), refined.point(w));
    }));
  }
  geodesics.compute();
  std::vector<Mesh::Face_index> stack;
  for(const Mesh::Face_index first : refined.faces())
  {
    if(part_of.count(first) != 0)
      continue;
    const int part = int(farthest.size());
    farthest.push_back(0.);
    stack.push_back(first);
    part_of[first] = part;
    while(!stack.empty())
    {
      const Mesh::Face_index f = stack.back();
      stack.pop_back();
      const double d = geodesics.distance(Geodesics::Query{f.idx()}) - level;
      if(std::fabs(d) > 2. * deviation)
      {
        EXPECT_GE(d * farthest[std::size_t(part)], 0.) << "a part on both sides";
      }
      if(std::fabs(d) > std::fabs(farthest[std::size_t(part)]))
        farthest[std::size_t(part)] = d;
      for(const Mesh::Halfedge_index h : refined.halfedges_around_face(refined.halfedge(f)))
      {
        const Mesh::Face_index g = refined.face(refined.opposite(h));
        if(g != Mesh::null_face() && on_line.count(refined.edge(h)) == 0 && part_of.insert({g, part}).second)
          stack.push_back(g);
      }
    }
  }
  const auto is_nearer = [&](Mesh::Face_index f) { return farthest[std::size_t(part_of[f])] < 0.; };
  std::set<Mesh::Vertex_index> vertices;
  std::set<Mesh::Edge_index> edges;
  long faces = 0;
  for(const Mesh::Edge_index e : on_line)
    if(!refined.is_border(e))
    {
      EXPECT_NE(is_nearer(refined.face(refined.halfedge(e, 0))), is_nearer(refined.face(refined.halfedge(e, 1))));
    }
  for(const Mesh::Face_index f : refined.faces())
    if(is_nearer(f))
    {
      ++faces;
      for(const Mesh::Halfedge_index h : refined.halfedges_around_face(refined.halfedge(f)))
      {
        vertices.insert(refined.source(h));
        edges.insert(refined.edge(h));
      }
    }
  return long(vertices.size()) - long(edges.size()) + faces;
}

/// the least distance that the fronts know of a point, from two windows of an edge that leave out what is between 0.5 and 0.5 + gap
double distance_behind_a_gap(double gap, double further)
{
  namespace internal = CGAL::Cut_loci::internal;
  const auto mesh = indexed(Mesh_data{{{{0., 0., 0.}}, {{1., 0., 0.}}, {{0.5, 1., 0.}}}, {{{0, 1, 2}}}});
  internal::Exact_geodesic_propagation geodesics(mesh);
  geodesics.run({Indexed_location{0, {{1., 0., 0.}}}}, {});
  const std::vector<internal::Crossing_window> windows = {{0, false, 0., 0.5, 0.5, -1., 0.},
                                                          {0, false, 0.5 + gap, 1., 0.5, -1., further}};
  double result = std::numeric_limits<double>::infinity();
  for(const internal::Geodesic_front& front : internal::Geodesic_fronts(geodesics, windows).in_face(0))
    if(front.image.y < 0.)
      result = std::min(result, front.distance({0.5 + gap, 0.5}));
  return result;
}

TEST(Isolines, what_windows_know_alike_between_them_is_seen)
{
  EXPECT_NEAR(distance_behind_a_gap(1e-4, 0.), 1.5, 1e-8);
  EXPECT_EQ(distance_behind_a_gap(1e-4, 1e-6), std::numeric_limits<double>::infinity());
}

TEST(Isolines, bound_what_is_nearer_on_random_surfaces)
{
  int compared = 0, unsure = 0;
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(random_surface(seed));
    const Mesh& mesh = built.mesh;
    std::mt19937 random(seed);
    Geodesics_with_isolines geodesics(mesh);
    std::vector<Location> sources;
    for(unsigned i = 0; i < 1 + seed % 4 / 2; ++i)
    {
      Location source = random_location(mesh, random);
      source.second = {{1., 0., 0.}}; // so that divided surfaces have it
      sources.push_back(source);
      geodesics.add_source(source);
    }
    geodesics.compute();
    const double largest = largest_distance(mesh, geodesics), deviation = 1e-5 * largest;
    for(const double share : {0.15, 0.5, 0.8, 0.95})
    {
      const double level = share * largest;
      const Isolines lines = isolines(geodesics, {level}, deviation);
      expect_closed(mesh, lines);
      expect_connected(mesh, lines);
      expect_right_places(mesh, geodesics, lines, 1e-9 * largest);
      // between samples, ridges and valleys are torn: what changes with them, or the level, is not the truth
      const double apart = 0.01 * largest;
      const std::vector<double> about = {level - apart, level, level + apart};
      std::vector<long> sampled = characteristics_by_samples(mesh, geodesics, about, 12);
      for(const long c : characteristics_by_samples(mesh, geodesics, about, 24))
        sampled.push_back(c);
      if(std::count(sampled.begin(), sampled.end(), sampled[0]) < 6)
      {
        ++unsure;
        continue;
      }
      ++compared;
      EXPECT_EQ(characteristic_by_isolines(mesh, lines, sources, level, deviation), sampled[0]) << "level " << level;
    }
  }
  EXPECT_GT(compared, 2 * unsure);
}

void expect_whole(const Mesh& mesh, Geodesics& geodesics)
{
  const double largest = largest_distance(mesh, geodesics);
  const Isolines lines = isolines(geodesics, levels_and_vertices(mesh, geodesics), 1e-3 * largest);
  expect_closed(mesh, lines);
  expect_connected(mesh, lines);
  expect_right_places(mesh, geodesics, lines, rounding * largest);
}

/// sources in faces, on edges and at vertices, several of them, and many levels
TEST(Isolines, are_whole_on_random_surfaces)
{
  for(unsigned seed = 0; seed < 36; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(random_surface(seed));
    std::mt19937 random(seed);
    Geodesics_with_isolines geodesics(built.mesh);
    for(unsigned i = 0; i < 1 + seed % 4; ++i)
      geodesics.add_source(random_location(built.mesh, random));
    geodesics.compute();
    expect_whole(built.mesh, geodesics);
  }
}

/// curves that turn anywhere and cross themselves, and points beside them
TEST(Isolines, of_curves_are_whole_on_random_surfaces)
{
  for(unsigned seed = 0; seed < 36; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(random_surface(seed));
    const Mesh& mesh = built.mesh;
    std::mt19937 random(seed);
    Geodesics_with_isolines geodesics(mesh);
    Edges curve;
    Mesh::Halfedge_index h(static_cast<Mesh::size_type>(random() % mesh.number_of_halfedges()));
    for(std::size_t length = 1 + random() % 6; curve.size() < length; h = mesh.opposite(mesh.next(h)))
      curve.push_back(mesh.edge(h));
    geodesics.add_source_curve(curve);
    if(seed % 3 == 0)
      geodesics.add_source(random_location(mesh, random));
    geodesics.compute();
    expect_whole(mesh, geodesics);
  }
}

/// where isolines pass through vertices, touch edges, and meet ridges along edges, at the levels of all vertices
TEST(Isolines, are_whole_on_symmetric_surfaces)
{
  for(const Mesh_data& data : {icosahedron(), sphere(4), cube(1), cube(4), box(1, 2, 3, 2), l_shape(3),
                               torus(2., 1., 12, 8), sphere_of_squares(4)})
    for(int k = 0; k < 4; ++k)
    {
      SCOPED_TRACE(std::to_string(data.points.size()) + " vertices, sources " + std::to_string(k));
      const Built built(data);
      Geodesics_with_isolines geodesics(built.mesh);
      const Mesh::Face_index f(static_cast<Mesh::size_type>(built.mesh.number_of_faces() / 3));
      if(k % 2 == 0)
        geodesics.add_source(built.vertices[0]);
      if(k == 1)
        geodesics.add_source(Location(f, {{1. / 3., 1. / 3., 1. / 3.}}));
      if(k == 2)
        geodesics.add_source(built.vertices[built.vertices.size() / 2]);
      if(k == 3)
        geodesics.add_source(Location(f, {{0.5, 0.5, 0.}}));
      geodesics.compute();
      expect_whole(built.mesh, geodesics);
    }
}

TEST(Isolines, are_refused_where_there_are_none)
{
  const Built built(icosahedron());
  Geodesics geodesics(built.mesh);
  Isolines lines;
  const auto expect_error = [](const std::string& text, const std::function<void()>& call)
  { refusals::expect_words(call, {text}); };
  const auto write = [&](double level) { geodesics.isolines(std::vector<double>{level}, std::back_inserter(lines)); };
  expect_error("compute() comes before", [&] { write(0.1); });
  geodesics.compute(built.vertices[0]);
  expect_error("set_isolines() comes before compute()", [&] { write(0.1); });
  geodesics.set_isolines(true);
  geodesics.set_maximum_relative_error(0.01);
  expect_error("need exact distances", [&] { geodesics.compute(built.vertices[0]); });
  geodesics.set_maximum_relative_error(0.);
  geodesics.set_maximum_distance(0.5);
  geodesics.compute(built.vertices[0]);
  for(const double level : {0., -1., std::nan(""), 0.6, std::numeric_limits<double>::infinity()})
    expect_error("no isoline of the level", [&] { write(level); });
  expect_error("deviation must be positive", [&] { isolines(geodesics, {0.3}, 0.); });
  EXPECT_TRUE(lines.empty());
  write(0.5);
  EXPECT_EQ(lines.size(), 1u);
  geodesics.set_maximum_distance(std::numeric_limits<double>::infinity());
  geodesics.compute(built.vertices[0]);
  write(100.);
  EXPECT_EQ(lines.size(), 1u);
}

} // namespace

} // namespace test_isolines
