// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Exact geodesics where the distance is known in closed form: on flat, polyhedral and developable surfaces.

#include "exact_geodesics_test_meshes.h"

#include <gtest/gtest.h>

#include <functional>

namespace test_exact_geodesics_closed_forms {

namespace {

using namespace test_meshes;

constexpr double exact = 1e-12;

/// compares the distances from several sources, of all kinds, at all vertices and centroids
void expect_distances(const Mesh& mesh, const std::function<double(const Point&, const Point&)>& expected,
                      const std::vector<Indexed_location>& sources, double tolerance = exact)
{
  Geodesics geodesics(mesh);
  Options options;
  options.queries = centroids(mesh);
  for(const Indexed_location& source : sources)
  {
    const Point s = point(mesh, source);
    geodesics.run({source}, options);
    double worst = 0., worst_centroid = 0.;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      const double d = expected(s, mesh.points[v]);
      worst = (std::max)(worst, std::fabs(geodesics.distance(v) - d) / (d + 1e-3));
    }
    for(std::size_t i = 0; i < geodesics.number_of_queries(); ++i)
    {
      const double d = expected(s, point(mesh, geodesics.answer(i).location));
      worst_centroid = (std::max)(worst_centroid, std::fabs(geodesics.query_distance(i) - d) / (d + 1e-3));
    }
    EXPECT_LE(worst, tolerance) << "source in face " << source.face;
    EXPECT_LE(worst_centroid, tolerance) << "source in face " << source.face;
  }
}

std::vector<Indexed_location> random_sources(const Mesh& mesh, std::size_t n, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::vector<Indexed_location> sources;
  for(unsigned i = 0; i < n; ++i)
    sources.push_back(random_location(mesh, random, i));
  return sources;
}

/// the distance on a box, as the shortest of all ways to roll it from the face of `s` to the one of `t` over each face
/// at most once: on a convex surface no such unfolding makes a distance too short
class Box_distance
{
public:
  explicit Box_distance(const std::array<double, 3>& size) : size_(size) {}

  double operator()(const Point& s, const Point& t)
  {
    target_ = t;
    best_ = 1e300;
    for(int face = 0; face < 6; ++face)
    {
      const std::size_t axis = std::size_t(face / 2);
      if(std::fabs(s[axis] - (face % 2 ? size_[axis] : 0.)) > 1e-12)
        continue;
      // the images of the axes in the plane, and of the source
      std::array<std::array<double, 2>, 3> image{};
      image[(axis + 1) % 3] = {{1., 0.}};
      image[(axis + 2) % 3] = {{0., 1.}};
      roll(face, image, s, {{0., 0.}}, 1u << face);
    }
    return best_;
  }

private:
  using Image = std::array<double, 2>;

  static Image unfold(const std::array<Image, 3>& image, const Point& from, const Image& at, const Point& p)
  {
    Image result = at;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 2; ++k)
        result[k] += (p[i] - from[i]) * image[i][k];
    return result;
  }

  void roll(int face, const std::array<Image, 3>& image, const Point& from, const Image& at, unsigned visited)
  {
    const std::size_t axis = std::size_t(face / 2);
    if(std::fabs(target_[axis] - (face % 2 ? size_[axis] : 0.)) < 1e-12)
    {
      const Image t = unfold(image, from, at, target_);
      best_ = (std::min)(best_, std::hypot(t[0], t[1]));
    }
    for(int next = 0; next < 6; ++next)
    {
      const std::size_t other = std::size_t(next / 2);
      if(other == axis || (visited & (1u << next)))
        continue;
      // a point of the common edge; behind it the next face leads away from the plane of this one
      Point edge = from;
      edge[axis] = face % 2 ? size_[axis] : 0.;
      edge[other] = next % 2 ? size_[other] : 0.;
      const Image edge_image = unfold(image, from, at, edge);
      std::array<Image, 3> turned = image;
      const double sign = (next % 2 ? 1. : -1.) * (face % 2 ? -1. : 1.);
      turned[axis] = {{sign * image[other][0], sign * image[other][1]}};
      turned[other] = {{0., 0.}};
      roll(next, turned, edge, edge_image, visited | (1u << next));
    }
  }

  std::array<double, 3> size_;
  Point target_{};
  double best_ = 0.;
};

double euclidean(const Point& p, const Point& q)
{
  return distance(p, q);
}

TEST(Closed_forms, plane)
{
  const Mesh regular = flat_grid(23, 17);
  expect_distances(regular, euclidean, random_sources(regular, 12));
  const Mesh jittered = flat_grid(20, 20, 3, 0.3);
  expect_distances(jittered, euclidean, random_sources(jittered, 12));
}

TEST(Closed_forms, plane_from_the_border)
{
  const Mesh mesh = flat_grid(15, 15);
  std::vector<Indexed_location> sources;
  for(Index h = 0; h < mesh.number_of_halfedges(); h += 1)
    if(mesh.is_border_edge(h))
    {
      Indexed_location vertex = location(h / 3, 0., 0., 0.), edge = vertex;
      vertex.coordinates[h % 3] = 1.;
      edge.coordinates[h % 3] = 0.3;
      edge.coordinates[Mesh::next(h) % 3] = 0.7;
      sources.push_back(vertex);
      sources.push_back(edge);
    }
  expect_distances(mesh, euclidean, sources);
}

TEST(Closed_forms, plane_with_needles)
{
  // squeezed to one part in ten thousand, and jittered
  Mesh mesh = flat_grid(20, 20, 5, 0.3);
  for(Point& p : mesh.points)
    p[0] *= 1e-4;
  expect_distances(mesh, euclidean, random_sources(mesh, 9), 1e-9);
}

TEST(Closed_forms, cube_and_box)
{
  for(const Index n : {1u, 2u, 5u, 12u})
  {
    const Mesh cube = box({{1., 1., 1.}}, {{n, n, n}});
    expect_distances(cube, Box_distance(std::array<double, 3>{{1., 1., 1.}}), random_sources(cube, 9));
  }
  const std::array<double, 3> size = {{3., 2., 1.}};
  const Mesh mesh = box(size, {{6, 5, 4}});
  expect_distances(mesh, Box_distance(size), random_sources(mesh, 12));
}

TEST(Closed_forms, subdivided_cube)
{
  Mesh cube = box({{1., 1., 1.}}, {{1, 1, 1}});
  for(unsigned i = 0; i < 4; ++i)
  {
    cube = subdivided(cube, i % 2 ? 0.2 : 0., i);
    expect_distances(cube, Box_distance(std::array<double, 3>{{1., 1., 1.}}), random_sources(cube, 9, i));
  }
}

TEST(Closed_forms, spider_and_fly)
{
  // Dudeney's room of 30 x 12 x 12 feet: the way from one end wall to the other is 40 feet, and crosses five faces
  const Mesh room = box({{30., 12., 12.}}, {{30, 12, 12}});
  Geodesics geodesics(room);
  Index spider = null_index, fly = null_index;
  for(Index v = 0; v < room.number_of_vertices(); ++v)
  {
    if(distance(room.points[v], {{0., 6., 11.}}) < 1e-9)
      spider = v;
    if(distance(room.points[v], {{30., 6., 1.}}) < 1e-9)
      fly = v;
  }
  geodesics.run(spider);
  EXPECT_NEAR(geodesics.distance(fly), 40., 1e-11);
}

TEST(Closed_forms, doubly_covered_disk)
{
  const Index sides = 24;
  const auto rim = [](Index i) { return Point{{std::cos(2. * pi * i / sides), std::sin(2. * pi * i / sides), 0.}}; };
  const Mesh disk = fan(sides, 6, rim);
  const Mesh mesh = doubled(disk, [](const Point& p) { return p; });
  Geodesics geodesics(mesh);
  const auto sheet = [&](Index f) { return f < disk.number_of_faces() ? 0 : 1; };
  for(const Indexed_location& source : random_sources(mesh, 12))
  {
    Options options;
    options.queries = centroids(mesh);
    geodesics.run({source}, options);
    const Point s = point(mesh, source);
    double worst = 0.;
    for(std::size_t i = 0; i < geodesics.number_of_queries(); ++i)
    {
      const Point t = point(mesh, geodesics.answer(i).location);
      double d = distance(s, t);
      if(sheet(geodesics.answer(i).location.face) != sheet(source.face))
      {
        // over the nearest point of each side, by reflection
        d = 1e300;
        for(Index k = 0; k < sides; ++k)
        {
          const Point a = rim(k), b = rim(k + 1);
          const double ux = (b[0] - a[0]), uy = (b[1] - a[1]), l = std::hypot(ux, uy);
          const double xs = ((s[0] - a[0]) * ux + (s[1] - a[1]) * uy) / l,
                       ys = ((s[1] - a[1]) * ux - (s[0] - a[0]) * uy) / l;
          const double xt = ((t[0] - a[0]) * ux + (t[1] - a[1]) * uy) / l,
                       yt = ((t[1] - a[1]) * ux - (t[0] - a[0]) * uy) / l;
          const double x = (std::min)((std::max)(ys + yt > 0. ? (xs * yt + xt * ys) / (ys + yt) : xs, 0.), l);
          d = (std::min)(d, std::hypot(x - xs, ys) + std::hypot(x - xt, yt));
        }
      }
      worst = (std::max)(worst, std::fabs(geodesics.query_distance(i) - d) / d);
    }
    EXPECT_LE(worst, exact);
  }
}

TEST(Closed_forms, cylinder)
{
  const Index sides = 14, rows = 11;
  const double side = 2. * std::sin(pi / sides);
  std::vector<Point> points;
  std::vector<Mesh::Triangle> triangles;
  for(Index i = 0; i < sides; ++i)
    for(Index j = 0; j <= rows; ++j)
      points.push_back({{std::cos(2. * pi * i / sides), std::sin(2. * pi * i / sides), 0.37 * j}});
  const auto v = [=](Index i, Index j) { return (i % sides) * (rows + 1) + j; };
  for(Index i = 0; i < sides; ++i)
    for(Index j = 0; j < rows; ++j)
    {
      triangles.push_back({{v(i, j), v(i + 1, j), v(i + 1, j + 1)}});
      triangles.push_back({{v(i, j), v(i + 1, j + 1), v(i, j + 1)}});
    }
  const Mesh mesh = make_mesh(points, triangles);
  const double perimeter = side * sides;
  const auto unrolled = [=](const Point& p)
  {
    // the point lies on a chord between two corners
    const double a = std::atan2(p[1], p[0]) / (2. * pi) * sides;
    const double corner = std::floor(a);
    const double along = 0.5 + std::tan((a - corner - 0.5) * 2. * pi / sides) / (2. * std::tan(pi / sides));
    return (corner + along) * side;
  };
  expect_distances(
    mesh,
    [=](const Point& p, const Point& q)
    {
    double d = std::fabs(unrolled(p) - unrolled(q));
    d = (std::min)(d, perimeter - d);
    return std::hypot(d, p[2] - q[2]);
    },
    random_sources(mesh, 12));
}

/// the distance on a cone over a polygon, at whose tip the angle may exceed a full turn
void expect_cone(Index sides, const std::function<Point(Index)>& rim)
{
  const Mesh mesh = fan(sides, 7, rim);
  Geodesics geodesics(mesh);
  std::vector<double> start(sides + 1, 0.);
  for(Index i = 0; i < sides; ++i)
    start[i + 1] = start[i] + angle({{0., 0., 0.}}, rim(i), rim(i + 1));
  // polar coordinates of a point of a face
  const Index faces_per_side = mesh.number_of_faces() / sides;
  const auto polar = [&](const Indexed_location& l)
  {
    const Point p = point(mesh, l), o{{0., 0., 0.}};
    const Index i = l.face / faces_per_side;
    const double r = distance(o, p);
    return std::make_pair(r, r > 0. ? start[i] + angle(o, rim(i), p) : 0.);
  };
  for(const Indexed_location& source : random_sources(mesh, 15))
  {
    Options options;
    options.queries = centroids(mesh);
    geodesics.run({source}, options);
    const auto s = polar(source);
    double worst = 0.;
    for(std::size_t i = 0; i < geodesics.number_of_queries(); ++i)
    {
      const auto t = polar(geodesics.answer(i).location);
      double a = std::fabs(s.second - t.second);
      a = (std::min)(a, start[sides] - a);
      const double d = a >= pi ? s.first + t.first
                               : std::hypot(s.first - t.first, 2. * std::sqrt(s.first * t.first) * std::sin(0.5 * a));
      worst = (std::max)(worst, std::fabs(geodesics.query_distance(i) - d) / d);
    }
    EXPECT_LE(worst, exact);
  }
}

TEST(Closed_forms, cone)
{
  for(const double height : {0.2, 1., 4.})
    expect_cone(9, [=](Index i) { return Point{{std::cos(2. * pi * i / 9), std::sin(2. * pi * i / 9), height}}; });
}

TEST(Closed_forms, cone_with_more_than_a_full_turn)
{
  for(const double height : {0.05, 0.5, 1.5})
    expect_cone(10,
                [=](Index i) {
      return Point{{std::cos(2. * pi * i / 10), std::sin(2. * pi * i / 10), i % 2 ? height : -height}};
    });
}

void expect_directions_in_the_plane(const Mesh& mesh, const Geodesics& geodesics, const Point& source)
{
  const auto direction = [&](Index h)
  {
    const Point &p = mesh.points[mesh.source(h)], &q = mesh.points[mesh.target(h)];
    return std::atan2(q[1] - p[1], q[0] - p[0]);
  };
  const auto difference = [](double a, double b) { return std::fabs(std::remainder(a - b, 2. * pi)); };
  const double zero = direction(geodesics.source_halfedge());
  double worst = 0., worst_arrival = 0.;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Point& p = mesh.points[v];
    if(distance(p, source) < 1e-9)
      continue;
    const double a = std::atan2(p[1] - source[1], p[0] - source[0]);
    const double d = geodesics.direction_at_source(v);
    EXPECT_GE(d, 0.);
    EXPECT_LE(d, geodesics.source_angle());
    worst = (std::max)(worst, difference(d + zero, a));
    const auto arrival = geodesics.arrival_direction(v);
    EXPECT_EQ(mesh.source(arrival.halfedge), v);
    EXPECT_GE(arrival.angle, 0.);
    EXPECT_LE(arrival.angle, geodesics.faces().angle(arrival.halfedge));
    worst_arrival = (std::max)(worst_arrival, difference(direction(arrival.halfedge) + arrival.angle, a + pi));
    EXPECT_LE(difference(geodesics.arrival_angle(v) + direction(geodesics.faces().first_halfedge(v)), a + pi), 1e-10);
  }
  EXPECT_LE(worst, 1e-11);
  EXPECT_LE(worst_arrival, 1e-11);
}

// Where vertices are in one line but for a little, paths pass some of them on the other side than their windows do.
TEST(Closed_forms, directions_in_the_plane)
{
  for(double jitter : {0.25, 1e-6, 1e-7, 1e-8})
  {
    const Mesh mesh = flat_grid(14, 14, 2, jitter);
    Geodesics geodesics(mesh);
    Options options;
    options.directions = true;
    std::mt19937 random(3);
    for(unsigned k = 0; k < 30; ++k)
    {
      const Indexed_location source = random_location(mesh, random, k);
      geodesics.run({source}, options);
      expect_directions_in_the_plane(mesh, geodesics, point(mesh, source));
    }
  }
}

/// a square on a slope, divided at points of a few simple coordinates, one after the other: most faces are needles, and
/// many vertices are in one line. Noise makes it flat but for rounding, as decimated models are.
Mesh divided_square(std::size_t divisions, double noise, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Point> points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 0.6, 0.8}}, {{0., 0.6, 0.8}}};
  std::vector<Mesh::Triangle> triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  std::uniform_int_distribution<int> part(1, 2); // so that many are in one line
  for(std::size_t n = 0; n < divisions; ++n)
  {
    const std::size_t f = random() % triangles.size();
    const Mesh::Triangle t = triangles[f];
    const std::array<double, 3> c = {{double(part(random)), double(part(random)), double(part(random))}};
    const double sum = c[0] + c[1] + c[2];
    Point p = {{0., 0., 0.}};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t i = 0; i < 3; ++i)
        p[k] += c[i] / sum * points[t[i]][k];
    p[2] += noise * std::uniform_real_distribution<double>(-1., 1.)(random);
    const Index v = static_cast<Index>(points.size());
    points.push_back(p);
    triangles[f] = {{t[0], t[1], v}};
    triangles.push_back({{t[1], t[2], v}});
    triangles.push_back({{t[2], t[0], v}});
  }
  return make_mesh(points, triangles);
}

TEST(Closed_forms, needles_that_are_flat_but_for_rounding)
{
  for(double noise : {0., 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6})
    for(unsigned seed = 1; seed <= 5; ++seed)
    {
      const Mesh mesh = divided_square(300, noise, seed);
      Geodesics geodesics(mesh);
      for(Index f = 0; f < mesh.number_of_faces(); f += 13)
      {
        const Index source = mesh.triangles[f][0];
        geodesics.run({location(f, 1., 0., 0.)});
        double worst = 0.;
        for(Index v = 0; v < mesh.number_of_vertices(); ++v)
          worst = (std::max)(worst, std::fabs(geodesics.distance(v) - distance(mesh.points[source], mesh.points[v])));
        EXPECT_LE(worst, 1e-9 + 10. * noise) << "noise " << noise << ", seed " << seed << ", source " << source;
      }
    }
}

} // namespace

} // namespace test_exact_geodesics_closed_forms
