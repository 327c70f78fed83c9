// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Source unfoldings of convex polyhedra with faces that have no area: the polygon is that of the polyhedron without them.

#include "surface_test.h"

#include <CGAL/Cut_loci/source_unfolding.h>

namespace test_unfolding_flat_faces {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using namespace surface_test;
using Unfolding = CGAL::Cut_loci::Source_unfolding<Mesh, Point>;

/*
 * An edge becomes a hole: on each of its sides there are points on it, which divide the face there. What is in between is
 * a polygon that is flat; it is divided in any way, so that its faces have their points in any order.
 */
class Edge_with_flat_faces
{
public:
  Edge_with_flat_faces(Mesh_data& m, std::size_t face, std::size_t corner, std::mt19937& engine)
    : mesh_(m), engine_(engine)
  {
    const std::size_t a = m.triangles[face][corner], b = m.triangles[face][(corner + 1) % 3];
    std::size_t other = 0, other_corner = 0;
    for(std::size_t g = 0; g < m.triangles.size(); ++g)
      for(std::size_t i = 0; i < 3; ++i)
        if(m.triangles[g][i] == b && m.triangles[g][(i + 1) % 3] == a)
        {
          other = g;
          other_corner = i;
        }
    const std::vector<std::size_t> left = divide(face, corner), right = divide(other, other_corner);
    // counterclockwise, between the faces: from b back to a along the first, and to b along the second one
    std::vector<std::size_t> around = {b};
    around.insert(around.end(), left.rbegin(), left.rend());
    around.push_back(a);
    around.insert(around.end(), right.rbegin(), right.rend());
    fill(around);
  }

private:
  /// points on an edge of a face, and the fan that this becomes
  std::vector<std::size_t> divide(std::size_t face, std::size_t corner)
  {
    using test_meshes::operator*, test_meshes::operator+;
    const Triangle t = mesh_.triangles[face];
    const std::size_t a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
    std::set<double> shares;
    for(std::size_t n = 1 + engine_() % 3; shares.size() < n;)
      shares.insert(static_cast<double>(engine_() % 21) / 20.); // often the same on both sides, or an end
    std::vector<std::size_t> result, chain = {a};
    for(double s : shares)
    {
      result.push_back(mesh_.points.size());
      // the same point, seen from the other end
      mesh_.points.push_back(a < b ? (1. - s) * mesh_.points[a] + s * mesh_.points[b]
                                   : s * mesh_.points[b] + (1. - s) * mesh_.points[a]);
    }
    chain.insert(chain.end(), result.begin(), result.end());
    chain.push_back(b);
    mesh_.triangles[face] = {{chain[0], chain[1], c}};
    for(std::size_t i = 1; i + 1 < chain.size(); ++i)
      mesh_.triangles.push_back({{chain[i], chain[i + 1], c}});
    return result;
  }

  /// a polygon by triangles at random
  void fill(const std::vector<std::size_t>& around)
  {
    if(around.size() < 3)
      return;
    const std::size_t k = 1 + engine_() % (around.size() - 2);
    mesh_.triangles.push_back({{around.front(), around[k], around.back()}});
    fill({around.begin(), around.begin() + static_cast<std::ptrdiff_t>(k) + 1});
    fill({around.begin() + static_cast<std::ptrdiff_t>(k), around.end()});
  }

  Mesh_data& mesh_;
  std::mt19937& engine_;
};

/// some edges, also such of faces that have become flat
Mesh_data with_flat_faces(Mesh_data m, std::size_t number, unsigned seed)
{
  using test_meshes::operator-, test_meshes::norm;
  std::mt19937 engine(seed);
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::size_t face = engine() % m.triangles.size(), corner = engine() % 3;
    const Triangle& t = m.triangles[face];
    // of shorter ones, rounding would make angles of more than a full turn
    if(norm(m.points[t[corner]] - m.points[t[(corner + 1) % 3]]) > 0.05)
      Edge_with_flat_faces(m, face, corner, engine);
  }
  return m;
}

/// is what a polygon is up to a turn: without corners at which it goes straight on, the distance of each one to the
/// source, and to the next one.
std::vector<std::array<double, 2>> outline(const Unfolding& u)
{
  std::vector<Unfolding::Point_2> corners;
  const std::size_t n = u.corners.size();
  double size = 0.;
  for(const auto& c : u.corners)
    size = (std::max)(size, std::hypot(c.point.x(), c.point.y()));
  for(std::size_t i = 0; i < n; ++i)
  {
    const auto &p = u.corners[(i + n - 1) % n].point, &q = u.corners[i].point, &r = u.corners[(i + 1) % n].point;
    const auto a = q - p, b = r - q;
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
    if(std::fabs(turn) > 1e-6)
      corners.push_back(q);
  }
  std::vector<std::array<double, 2>> result;
  for(std::size_t i = 0; i < corners.size(); ++i)
  {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    result.push_back({{std::hypot(p.x(), p.y()) / size, std::hypot(q.x() - p.x(), q.y() - p.y()) / size}});
  }
  return result;
}

/// the largest difference of two outlines, which start anywhere
double difference(const std::vector<std::array<double, 2>>& a, const std::vector<std::array<double, 2>>& b)
{
  if(a.size() != b.size())
    return 1.;
  double least = 1.;
  for(std::size_t shift = 0; shift < a.size(); ++shift)
  {
    double most = 0.;
    for(std::size_t i = 0; i < a.size(); ++i)
      for(std::size_t k : {0, 1})
        most = (std::max)(most, std::fabs(a[i][k] - b[(i + shift) % b.size()][k]));
    least = (std::min)(least, most);
  }
  return least;
}

double area(const Unfolding& u)
{
  double result = 0.;
  for(std::size_t i = 0; i < u.corners.size(); ++i)
  {
    const auto &p = u.corners[i].point, &q = u.corners[(i + 1) % u.corners.size()].point;
    const double twice = p.x() * q.y() - p.y() * q.x();
    EXPECT_GE(twice, -1e-9) << "not star-shaped";
    result += 0.5 * twice;
  }
  return result;
}

double area(const Mesh_data& m)
{
  using test_meshes::operator-, test_meshes::cross, test_meshes::norm;
  double result = 0.;
  for(const Triangle& t : m.triangles)
    result += 0.5 * norm(cross(m.points[t[1]] - m.points[t[0]], m.points[t[2]] - m.points[t[0]]));
  return result;
}

/// `weight` is of the vertices in the order of the data, where that of CGAL starts with the halfedge of the face
Location location(const Built& built, Mesh::Face_index f, const std::array<double, 3>& weight)
{
  Location result(f, {{0., 0., 0.}});
  auto h = built.mesh.halfedge(f);
  for(double& c : result.second)
  {
    const Triangle& t = built.data.triangles[f];
    for(std::size_t i = 0; i < 3; ++i)
      if(built.vertices[t[i]] == built.mesh.source(h))
        c = weight[i];
    h = built.mesh.next(h);
  }
  return result;
}

struct Counts
{
  int runs = 0, moved = 0;
};

template <typename Source>
void compare(const Built& clean, const Source& in_clean, const Built& flat, const Source& in_flat, Counts& counts)
{
  const Unfolding expected = CGAL::Cut_loci::source_unfolding(clean.mesh, in_clean);
  const Unfolding found = CGAL::Cut_loci::source_unfolding(flat.mesh, in_flat);
  EXPECT_NEAR(area(found), area(clean.data), 1e-9 * area(clean.data));
  const bool is_moved = expected.is_source_moved || found.is_source_moved;
  if(!is_moved) // which is by a part of a face, and leaves short edges
  {
    EXPECT_LT(difference(outline(found), outline(expected)), 1e-9);
  }
  ++counts.runs;
  counts.moved += is_moved;
  for(const auto& c : found.vertices)
  {
    EXPECT_TRUE(flat.mesh.is_valid(c.location.first));
    double sum = 0.;
    for(double x : c.location.second)
    {
      EXPECT_GE(x, -1e-9);
      sum += x;
    }
    EXPECT_NEAR(sum, 1., 1e-9);
  }
  // fold lines lie on the edges that they name, and no two on each other
  double length_of_folds = 0., expected_length = 0.;
  for(const auto& f : found.fold_lines)
    length_of_folds += std::fabs(f.angle) > 1e-6 ? std::sqrt(CGAL::squared_distance(f.source, f.target)) : 0.;
  for(const auto& f : expected.fold_lines)
    expected_length += std::fabs(f.angle) > 1e-6 ? std::sqrt(CGAL::squared_distance(f.source, f.target)) : 0.;
  EXPECT_NEAR(length_of_folds, expected_length, is_moved ? 1e-3 : 1e-8);
}

std::vector<std::pair<std::string, Mesh_data>> convex_polyhedra(unsigned seed)
{
  return {{"sphere", test_meshes::random_convex_polyhedron(6 + 2 * seed, seed)},
          {"ellipsoid", test_meshes::random_convex_polyhedron(30, seed, {{1., 0.6, 0.3}})},
          {"divided", test_meshes::split_in_plane(random_convex_polyhedron(4 + seed, seed))}};
}

TEST(Unfolding_flat_faces, change_nothing_seen_from_vertices_and_from_faces)
{
  Counts counts;
  for(unsigned seed = 1; seed <= 8; ++seed)
    for(const auto& [name, data] : convex_polyhedra(seed))
      for(std::size_t number : {1, 3, 8, 60})
      {
        const Built clean(data), flat(with_flat_faces(data, number, 7 * seed));
        for(std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t v = k * data.points.size() / 3;
          SCOPED_TRACE(name + ' ' + std::to_string(seed) + ", " + std::to_string(number) + " edges, vertex " +
                       std::to_string(v));
          compare(clean, clean.vertices[v], flat, flat.vertices[v], counts);
        }
        for(std::size_t f = 0; f < data.triangles.size(); f += 1 + data.triangles.size() / 3)
          if(flat.data.triangles[f] == data.triangles[f])
          {
            SCOPED_TRACE(name + ' ' + std::to_string(seed) + ", " + std::to_string(number) + " edges, face " +
                         std::to_string(f));
            const Location at(Mesh::Face_index(static_cast<Mesh::size_type>(f)), {{0.2, 0.5, 0.3}});
            compare(clean, at, flat, at, counts);
          }
      }
  RecordProperty("runs", counts.runs);
  RecordProperty("moved", counts.moved);
  EXPECT_LT(counts.moved, counts.runs / 4);
}

// The source is in a flat face, or a vertex that only these have: it is on an edge of the surface.
TEST(Unfolding_flat_faces, can_hold_the_source)
{
  Counts counts;
  for(unsigned seed = 1; seed <= 8; ++seed)
  {
    const Mesh_data data = random_convex_polyhedron(12, seed);
    const Built clean(data), flat(with_flat_faces(data, 1, seed));
    std::mt19937 engine(seed);
    const std::size_t face = engine() % data.triangles.size(), corner = engine() % 3;
    const auto a = data.points[data.triangles[face][corner]], b = data.points[data.triangles[face][(corner + 1) % 3]];
    using test_meshes::operator*, test_meshes::operator+, test_meshes::operator-;
    using test_meshes::norm;
    const auto on_edge = [&](const test_meshes::Point& p)
    {
      const double s = norm(p - a) / norm(b - a);
      const Mesh::Face_index f(static_cast<Mesh::size_type>(face));
      std::array<double, 3> weight = {{0., 0., 0.}};
      weight[corner] = 1. - s;
      weight[(corner + 1) % 3] = s;
      return location(clean, f, weight);
    };
    for(std::size_t f = data.triangles.size(); f < flat.data.triangles.size(); ++f)
    {
      const Triangle& t = flat.data.triangles[f];
      const test_meshes::Point p =
        0.2 * flat.data.points[t[0]] + (0.5 * flat.data.points[t[1]] + 0.3 * flat.data.points[t[2]]);
      if(std::fabs(norm(p - a) + norm(p - b) - norm(a - b)) > 1e-12)
        continue; // a part of a face at the edge
      SCOPED_TRACE(std::to_string(seed) + ", face " + std::to_string(f));
      compare(clean, on_edge(p), flat,
              location(flat, Mesh::Face_index(static_cast<Mesh::size_type>(f)), {{0.2, 0.5, 0.3}}), counts);
      for(std::size_t v : t)
        if(v >= data.points.size())
        {
          const Unfolding expected = CGAL::Cut_loci::source_unfolding(clean.mesh, on_edge(flat.data.points[v])),
                          found = CGAL::Cut_loci::source_unfolding(flat.mesh, flat.vertices[v]);
          if(expected.is_source_moved || found.is_source_moved)
            continue;
          EXPECT_LT(difference(outline(found), outline(expected)), 1e-9);
          EXPECT_EQ(found.source.mesh_vertex, flat.vertices[v]);
        }
    }
  }
  EXPECT_GT(counts.runs, 20);
}

// Four points on a line, in all orders along it: the flat faces are between two sides of a pyramid.
TEST(Unfolding_flat_faces, have_their_points_in_any_order)
{
  Counts counts;
  for(double left : {6., 8., 9.})
    for(double right : {6., 8., 9.})
      for(bool is_left_first : {true, false})
      {
        Mesh_data data, with;
        data.points = {{{0., 0., 0.}}, {{0., 13., 0.}}, {{-5., 6., 0.}}, {{4., 6., 0.}}, {{0.5, 5.5, 7.}}};
        data.triangles = {{{0, 1, 2}}, {{1, 0, 3}}, {{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}}};
        with = data;
        with.points.insert(with.points.end(), {{{0., left, 0.}}, {{0., right, 0.}}});
        with.triangles[0] = {{0, 5, 2}};
        with.triangles[1] = {{1, 6, 3}};
        with.triangles.insert(with.triangles.end(), {{{5, 1, 2}}, {{6, 0, 3}}});
        if(is_left_first)
          with.triangles.insert(with.triangles.end(), {{{0, 6, 5}}, {{5, 6, 1}}});
        else
          with.triangles.insert(with.triangles.end(), {{{0, 1, 5}}, {{0, 6, 1}}});
        const Built clean(data), flat(with);
        for(std::size_t v = 0; v < data.points.size(); ++v)
        {
          SCOPED_TRACE(std::to_string(left) + ' ' + std::to_string(right) + ", vertex " + std::to_string(v));
          compare(clean, clean.vertices[v], flat, flat.vertices[v], counts);
        }
      }
  EXPECT_LT(counts.moved, counts.runs / 2);
}

// Coordinates with two decimals are on one line up to rounding only.
TEST(Unfolding_flat_faces, are_flat_up_to_rounding)
{
  Counts counts;
  std::mt19937 engine(1);
  for(int i = 0; i < 20; ++i)
  {
    Mesh_data data;
    const auto decimal = [&]() { return static_cast<double>(engine() % 40) / 100.; };
    // a tetrahedron, and the middle of an edge of it
    const test_meshes::Point a = {{0.02 * static_cast<double>(engine() % 20), 0.7, decimal()}},
                             b = {{a[0] + 0.14, a[1] + 0.22, a[2] - 0.18}};
    data.points = {a, b, {{1.3 + decimal(), decimal(), decimal()}}, {{decimal(), decimal(), 1.5 + decimal()}}};
    data.triangles = {{{0, 1, 2}}, {{1, 0, 3}}, {{2, 1, 3}}, {{0, 2, 3}}};
    Mesh_data with = data;
    with.points.push_back({{a[0] + 0.07, a[1] + 0.11, a[2] - 0.09}});
    with.triangles[0] = {{0, 4, 2}};
    with.triangles.push_back({{4, 1, 2}});
    with.triangles.push_back({{0, 1, 4}});
    const Built clean(data), flat(with);
    for(std::size_t v = 0; v < 4; ++v)
    {
      SCOPED_TRACE(std::to_string(i) + ", vertex " + std::to_string(v));
      compare(clean, clean.vertices[v], flat, flat.vertices[v], counts);
    }
  }
  EXPECT_EQ(counts.runs, 80);
}

// On a sheet, at its border, too.
TEST(Unfolding_flat_faces, can_be_at_the_border)
{
  Mesh_data data;
  data.points = {{{0., 0., 0.}}, {{5., 0., 0.}}, {{6., 4., 0.}}, {{-1., 5., 0.}}};
  data.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  Mesh_data with = data;
  with.points.insert(with.points.end(), {{{2., 0., 0.}}, {{3., 0., 0.}}, {{3., 2., 0.}}});
  with.triangles = {{{0, 4, 2}}, {{4, 5, 2}}, {{5, 1, 2}}, {{0, 1, 4}},
                    {{1, 5, 4}}, {{0, 6, 3}}, {{6, 2, 3}}, {{0, 2, 6}}};
  const Built clean(data), flat(with);
  for(std::size_t v = 0; v < data.points.size(); ++v)
  {
    const Unfolding expected = CGAL::Cut_loci::source_unfolding(clean.mesh, clean.vertices[v]),
                    found = CGAL::Cut_loci::source_unfolding(flat.mesh, flat.vertices[v]);
    EXPECT_LT(difference(outline(found), outline(expected)), 1e-9);
    EXPECT_NEAR(area(found), area(expected), 1e-9);
  }
}

} // namespace

} // namespace test_unfolding_flat_faces
