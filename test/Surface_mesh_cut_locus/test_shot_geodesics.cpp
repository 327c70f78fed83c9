// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <optional>

// The logarithmic map against geodesics that are shot here: vectors in space, turned around the edges that they cross, with
// nothing of the package but the mesh.

namespace test_shot_geodesics {

namespace {

using namespace surface_test;
using Halfedge = Mesh::Halfedge_index;
using Coordinates = std::array<double, 3>;

Point point(const Mesh& mesh, Mesh::Vertex_index v)
{
  return {{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}};
}

Point along(const Mesh& mesh, Halfedge h)
{
  return point(mesh, mesh.target(h)) - point(mesh, mesh.source(h));
}

/// of the face of `h`, at a right angle to it and to its left
Point to_the_left(const Mesh& mesh, Halfedge h)
{
  const Point e = normalized(along(mesh, h)), way = along(mesh, mesh.next(h));
  return normalized(way - dot(way, e) * e);
}

/// in `halfedge`'s face, at coordinates that belong to its source, its target and the vertex opposite to it
struct Ray
{
  Halfedge halfedge;
  Coordinates at;
  Point direction;
};

/// the coordinates that change along a vector in the face of `h`, in the order of those of `Ray`
Coordinates rates(const Mesh& mesh, Halfedge h, const Point& direction)
{
  const Point e = along(mesh, h), left = to_the_left(mesh, h), way = along(mesh, mesh.next(h));
  const double apex = dot(direction, left) / dot(way, left),
               target = (dot(direction, e) - apex * dot(e + way, e)) / dot(e, e);
  return {{-target - apex, target, apex}};
}

Location location(const Mesh& mesh, const Ray& ray)
{
  Location result(mesh.face(ray.halfedge), ray.at);
  for(Halfedge h = mesh.halfedge(result.first); h != ray.halfedge; h = mesh.next(h))
    std::rotate(result.second.begin(), result.second.begin() + 2, result.second.end());
  return result;
}

/// nothing if it ends at the border
std::optional<Location> shot(const Mesh& mesh, Ray ray, double length)
{
  while(true)
  {
    const Coordinates rate = rates(mesh, ray.halfedge, ray.direction);
    double way = length;
    std::size_t zero = 3; // the first coordinate to become zero
    for(std::size_t i = 0; i < 3; ++i)
      if(rate[i] < 0. && ray.at[i] / -rate[i] < way)
      {
        way = ray.at[i] / -rate[i];
        zero = i;
      }
    for(std::size_t i = 0; i < 3; ++i)
      ray.at[i] += way * rate[i];
    if(zero == 3)
      return location(mesh, ray);
    length -= way;
    // the side opposite to the vertex `zero`, from `before` to `after`
    const std::size_t before = (zero + 1) % 3, after = (zero + 2) % 3;
    Halfedge h = ray.halfedge;
    for(std::size_t i = 0; i < before; ++i)
      h = mesh.next(h);
    const Halfedge o = mesh.opposite(h);
    if(mesh.is_border(o))
      return std::nullopt;
    const Point e = normalized(along(mesh, o));
    const double straight = dot(ray.direction, e);
    ray = {o,
           {{ray.at[after], ray.at[before], 0.}},
           straight * e + std::sqrt(1. - straight * straight) * to_the_left(mesh, o)};
  }
}

/// the angle between two sides of a face, which start at the source of `h`
double corner_angle(const Mesh& mesh, Halfedge h)
{
  const Point e = along(mesh, h), f = -1. * along(mesh, mesh.prev(h));
  return std::atan2(norm(cross(e, f)), dot(e, f));
}

/// into the direction of the angle `turn` from `halfedge`, which leaves the vertex: angles are scaled to a full turn
Ray ray_from_vertex(const Mesh& mesh, Halfedge halfedge, double turn)
{
  std::vector<Halfedge> around; // counterclockwise
  double total = 0.;
  for(Halfedge h = halfedge; around.empty() || h != halfedge; h = mesh.opposite(mesh.prev(h)))
  {
    around.push_back(h);
    total += corner_angle(mesh, h);
  }
  double angle = turn / (2. * pi) * total;
  std::size_t i = 0;
  for(; i + 1 < around.size() && angle > corner_angle(mesh, around[i]); ++i)
    angle -= corner_angle(mesh, around[i]);
  const Halfedge h = around[i];
  return {h, {{1., 0., 0.}}, std::cos(angle) * normalized(along(mesh, h)) + std::sin(angle) * to_the_left(mesh, h)};
}

/// the same from a point of an edge, or of the face of `halfedge` if that has it
Ray ray_from_point(const Mesh& mesh, Halfedge halfedge, const Coordinates& at, double turn)
{
  const bool is_on_other_side = at[2] == 0. && turn > pi;
  const Halfedge h = is_on_other_side ? mesh.opposite(halfedge) : halfedge;
  const double angle = is_on_other_side ? turn - pi : turn;
  return {h, is_on_other_side ? Coordinates{{at[1], at[0], 0.}} : at,
          std::cos(angle) * normalized(along(mesh, h)) + std::sin(angle) * to_the_left(mesh, h)};
}

struct Counts
{
  std::size_t shots = 0, shortest = 0;
};

/// What is shot for a way and no farther than that is a shortest path: the logarithmic map of its end has its length and its
/// direction. All others are longer than the distance.
void expect_shots_are_found(const Mesh_data& data, unsigned seed, Counts& counts)
{
  const Built built(data);
  const Mesh& mesh = built.mesh;
  Geodesics geodesics(mesh);
  geodesics.set_directions(true);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.1, 1.), share(0., 1.);
  for(int k = 0; k < 6; ++k)
  {
    const Halfedge side(static_cast<Mesh::size_type>(random() % mesh.number_of_halfedges()));
    if(mesh.is_border(side) || mesh.is_border(mesh.opposite(side)) || mesh.is_border(mesh.source(side)))
      continue;
    Coordinates at = {{uniform(random), k % 3 > 0 ? uniform(random) : 0., k % 3 > 1 ? uniform(random) : 0.}};
    at = (1. / (at[0] + at[1] + at[2])) * at;
    geodesics.clear_queries();
    geodesics.compute(location(mesh, {side, at, {}}));
    const Halfedge axis = geodesics.source_halfedge();
    if(k % 3 > 0) // in the order of the axis
      for(Halfedge h = side; h != axis; h = mesh.next(h))
      {
        if(k % 3 == 1)
        {
          ASSERT_EQ(mesh.opposite(h), axis);
          std::swap(at[0], at[1]);
          break;
        }
        std::rotate(at.begin(), at.begin() + 1, at.end());
      }
    double farthest = 0.;
    for(const auto v : mesh.vertices())
      farthest = (std::max)(farthest, geodesics.distance(v));

    std::vector<std::array<double, 2>> polar;
    while(polar.size() < 100)
    {
      const double length = farthest * share(random), turn = 2. * pi * share(random);
      const Ray ray = k % 3 == 0 ? ray_from_vertex(mesh, axis, turn) : ray_from_point(mesh, axis, at, turn);
      const std::optional<Location> end = shot(mesh, ray, length);
      if(!end)
        continue;
      polar.push_back({{length, turn}});
      geodesics.add_query(*end);
    }
    geodesics.compute();
    for(std::size_t q = 0; q < polar.size(); ++q)
    {
      const double length = polar[q][0], turn = polar[q][1], tolerance = 1e-9 * length;
      EXPECT_LE(geodesics.distance(Geodesics::Query{q}), length + tolerance) << "seed " << seed << ", " << k;
      ++counts.shots;
      if(geodesics.distance(Geodesics::Query{q}) < length - tolerance)
        continue;
      ++counts.shortest;
      const auto place = geodesics.logarithmic_map(Geodesics::Query{q});
      EXPECT_NEAR(place[0], length * std::cos(turn), tolerance) << "seed " << seed << ", " << k;
      EXPECT_NEAR(place[1], length * std::sin(turn), tolerance) << "seed " << seed << ", " << k;
    }
  }
}

TEST(Shot_geodesics, are_found_by_the_logarithmic_map)
{
  Counts counts;
  for(unsigned seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_shots_are_found(random_convex_polyhedron(20 + 20 * seed, seed, {{1., 0.3 + 0.1 * seed, 0.6}}), seed, counts);
    expect_shots_are_found(rough(bumpy_sphere(6, 0.3, seed), 0.05, seed), seed, counts);
    expect_shots_are_found(torus(1., 0.4, 18, 10, 0.2, seed), seed, counts);
    expect_shots_are_found(saddle(12, 0.3, 0.2, seed), seed, counts); // with a border
  }
  EXPECT_GE(counts.shots, 10000u);
  EXPECT_GE(counts.shortest, counts.shots / 3);
  RecordProperty("shots", int(counts.shots));
  RecordProperty("shortest", int(counts.shortest));
}

} // namespace

} // namespace test_shot_geodesics
