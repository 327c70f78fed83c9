// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "test_meshes.h"

#include <CGAL/Cut_loci/face_graph/surface_mesh_copy.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_solver.h>
#include <CGAL/Cut_loci/laplacian/smoothing.h>
#include <CGAL/Cut_loci/surface/insert_vertex.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Shortest_path_geodesic_solver.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <set>

namespace test_smoothing {

namespace {

using namespace test_meshes;
using CGAL::Cut_loci::Index;
using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;
using namespace CGAL::Cut_loci::internal;
using CGAL::Cut_loci::Indexed_cut_locus;
using CGAL::Cut_loci::Indexed_location;
using CGAL::Cut_loci::Indexed_source;
using CGAL::Cut_loci::Local_geodesics;
using CGAL::Cut_loci::Mesh_connectivity;
using CGAL::Cut_loci::null_index;
using CGAL::Cut_loci::straightest_geodesic;

Indexed_location random_location(const Mesh& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0., 1.);
  const double a = uniform(random), b = uniform(random) * (1. - a);
  Indexed_location x{static_cast<Index>(uniform(random) * mesh.number_of_faces()), {{a, b, 1. - a - b}}};
  const int kind = static_cast<int>(uniform(random) * 4.);
  if(kind == 0)
    x.coordinates = {{a, 1. - a, 0.}};
  else if(kind == 1)
    x.coordinates = {{0., 1., 0.}};
  return x;
}

void expect_valid(const Mesh& mesh, const Indexed_location& x)
{
  ASSERT_LT(x.face, mesh.number_of_faces());
  double sum = 0.;
  for(double c : x.coordinates)
  {
    ASSERT_GE(c, 0.);
    sum += c;
  }
  ASSERT_NEAR(sum, 1., 1e-12);
}

// ---- straightest geodesics

TEST(Straightest_geodesic, is_a_line_in_the_plane)
{
  const Mesh mesh = indexed(grid(12, 12));
  const Mesh_connectivity connectivity(mesh);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  int inside = 0;
  for(int k = 0; k < 2000; ++k)
  {
    const Indexed_location a = random_location(mesh, random);
    const Vector p = position(mesh, a);
    const double angle = pi * uniform(random), length = 3.;
    const Vector d = {{std::cos(angle), std::sin(angle), 0.}};
    const Vector q = p + length * d;
    const Indexed_location b = straightest_geodesic(mesh, connectivity, a, 7. * d, length);
    expect_valid(mesh, b);
    const Vector r = position(mesh, b);
    const bool is_inside = q[0] > 0. && q[0] < 11. && q[1] > 0. && q[1] < 11.;
    if(is_inside)
    {
      ++inside;
      ASSERT_LE(norm(r - q), 1e-4);
    }
    else // it stops where it meets the border
    {
      ASSERT_LE(norm(cross(r - p, d)), 1e-4);
      ASSERT_LE((std::min)({r[0], r[1], 11. - r[0], 11. - r[1]}), 1e-5);
    }
  }
  EXPECT_GT(inside, 500);
  // through vertices, along edges, and not at all
  const Indexed_location origin = {0, {{1., 0., 0.}}};
  const Indexed_location corner = straightest_geodesic(mesh, connectivity, origin, {{1., 1., 0.}}, 5. * std::sqrt(2.));
  EXPECT_LE(norm(position(mesh, corner) - Vector{{5., 5., 0.}}), 1e-5);
  const Indexed_location out = straightest_geodesic(mesh, connectivity, origin, {{-1., 0.5, 0.}}, 1.);
  EXPECT_LE(norm(position(mesh, out)), 1e-9);
  const Indexed_location still = straightest_geodesic(mesh, connectivity, {3, {{0.2, 0.3, 0.5}}}, {{0., 0., 0.}}, 1.);
  EXPECT_LE(norm(position(mesh, still) - position(mesh, {3, {{0.2, 0.3, 0.5}}})), 1e-12);
}

TEST(Straightest_geodesic, follows_the_unfolding_of_a_cube)
{
  // a cube of side 2 whose faces are grids
  Mesh mesh = indexed(star_shape(6,
                                 [](const Mesh::Point& p) {
    return 1. / (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }));
  const Mesh_connectivity connectivity(mesh);
  // from the top down the side x = 1, around the bottom and up again: eight to come home
  int tried = 0;
  for(double y : {0.123, -0.4567})
    for(Index f = 0; f < mesh.number_of_faces(); f += 7)
    {
      const Indexed_location a = {f, {{0.3, 0.45, 0.25}}};
      const Vector p = position(mesh, a);
      if(p[2] < 1. - 1e-9)
        continue;
      ++tried;
      const Indexed_location b = straightest_geodesic(mesh, connectivity, a, {{1., 0., 0.}}, 8.);
      EXPECT_LE(norm(position(mesh, b) - p), 1e-4);
      const double to_side = 1. - p[0];
      const double way = (to_side + 0.5) * std::hypot(1., y);
      const Indexed_location c = straightest_geodesic(mesh, connectivity, a, {{1., y, 0.}}, way);
      const Vector expected = {{1., p[1] + y * (to_side + 0.5), 0.5}};
      EXPECT_TRUE(std::abs(expected[1]) >= 1. || norm(position(mesh, c) - expected) <= 1e-4);
    }
  EXPECT_GE(tried, 10);
}

TEST(Straightest_geodesic, converges_to_great_circles)
{
  double previous = 1.;
  for(Index n : {8, 16, 32})
  {
    const Mesh mesh = indexed(sphere_of_squares(n));
    const Mesh_connectivity connectivity(mesh);
    double largest = 0.;
    for(Index f = 0; f < mesh.number_of_faces(); f += mesh.number_of_faces() / 40)
    {
      const Indexed_location a = {f, {{0.5, 0.2, 0.3}}};
      const Vector p = position(mesh, a);
      Vector d;
      ASSERT_TRUE(unit(tangential(Vector{{0.3, -0.5, 0.7}}, p), d));
      const Indexed_location b = straightest_geodesic(mesh, connectivity, a, d, 1.);
      Vector q, u;
      ASSERT_TRUE(unit(position(mesh, b), q) && unit(p, u));
      largest = (std::max)(largest, norm(q - (std::cos(1.) * u + std::sin(1.) * d)));
    }
    EXPECT_LE(largest, 0.7 * previous);
    previous = largest;
  }
  EXPECT_LE(previous, 0.02);
}

TEST(Straightest_geodesic, survives_needles_and_bumps)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for(const Mesh& mesh : {indexed(needles(10)), indexed(hilly_sphere(10))})
  {
    const Mesh_connectivity connectivity(mesh);
    for(int k = 0; k < 2000; ++k)
    {
      const Indexed_location a = random_location(mesh, random);
      const Vector d = {{uniform(random), uniform(random), uniform(random)}};
      const Indexed_location b = straightest_geodesic(mesh, connectivity, a, d, 0.7);
      expect_valid(mesh, b);
      ASSERT_LE(norm(position(mesh, b) - position(mesh, a)), 0.7 + 1e-3);
    }
  }
}

// ---- geodesic segments

double length(const Mesh& mesh, const std::vector<Indexed_location>& path)
{
  double result = 0.;
  for(std::size_t i = 1; i < path.size(); ++i)
    result += norm(position(mesh, path[i]) - position(mesh, path[i - 1]));
  return result;
}

// whether some face holds all vertices with a coordinate in `a` or `b`
bool share_a_face(const Mesh& mesh, const Mesh_connectivity& connectivity, const Indexed_location& a,
                  const Indexed_location& b)
{
  std::set<Index> vertices;
  for(const Indexed_location& x : {a, b})
    for(int i = 0; i < 3; ++i)
      if(x.coordinates[i] > 0.)
        vertices.insert(mesh.triangles[x.face][i]);
  const Index v = *vertices.begin();
  for(Index e = connectivity.ring_begin[v]; e < connectivity.ring_begin[v + 1]; ++e)
    for(Index h : {connectivity.ring_halfedge[e], mesh.opposite[connectivity.ring_halfedge[e]]})
      if(h != null_index)
      {
        const Mesh::Triangle& t = mesh.triangles[h / 3];
        if(std::all_of(vertices.begin(), vertices.end(), [&](Index w) { return w == t[0] || w == t[1] || w == t[2]; }))
          return true;
      }
  return false;
}

void expect_path(const Mesh& mesh, const Mesh_connectivity& connectivity, const std::vector<Indexed_location>& path)
{
  for(std::size_t i = 0; i < path.size(); ++i)
  {
    expect_valid(mesh, path[i]);
    if(i == 0)
      continue;
    ASSERT_TRUE(share_a_face(mesh, connectivity, path[i - 1], path[i]));
    ASSERT_GT(norm(position(mesh, path[i]) - position(mesh, path[i - 1])), 0.);
  }
}

std::vector<Indexed_location> segment(Local_geodesics& geodesics, Indexed_location a, const Indexed_location& b)
{
  std::vector<Indexed_location> path(1, a);
  EXPECT_TRUE(geodesics.append_segment(a, b, path));
  return path;
}

TEST(Local_geodesics, are_straight_lines_in_the_plane)
{
  std::mt19937 random(4);
  for(const Mesh& mesh : {indexed(grid(9, 9)), []
                          {
    Mesh m = indexed(grid(9, 9));
    for(auto& p : m.points)
      p[1] *= 0.01;
    return m;
                          }()})
  {
    const Mesh_connectivity connectivity(mesh);
    Local_geodesics geodesics(mesh, connectivity);
    for(int k = 0; k < 2000; ++k)
    {
      const Indexed_location a = random_location(mesh, random), b = random_location(mesh, random);
      const std::vector<Indexed_location> path = segment(geodesics, a, b);
      const double distance = norm(position(mesh, b) - position(mesh, a));
      if(distance == 0.)
      {
        ASSERT_EQ(path.size(), 1u);
        continue;
      }
      expect_path(mesh, connectivity, path);
      ASSERT_NEAR(length(mesh, path), distance, 1e-4);
      ASSERT_EQ(path.back().face, b.face);
    }
  }
}

TEST(Local_geodesics, are_shortest_between_near_points)
{
  std::mt19937 random(5);
  for(const Mesh& mesh : {indexed(sphere_of_squares(8)), indexed(hilly_sphere(8)), indexed(needles(6)),
                          indexed(torus_with_shifted_rows(20, 9))})
  {
    const Mesh_connectivity connectivity(mesh);
    Local_geodesics geodesics(mesh, connectivity);
    for(int k = 0; k < 6; ++k)
    {
      const Indexed_location a = random_location(mesh, random);
      Mesh refined = mesh;
      Index source = vertex_of(mesh, a);
      if(source == null_index)
      {
        refined = insert_vertex(mesh, a);
        source = mesh.number_of_vertices();
      }
      Indexed_source s;
      s.vertex = source;
      CGAL::Shortest_path_geodesic_solver solver;
      solver.set_mesh(refined);
      std::vector<double> exact;
      solver.compute_distances(s, exact);
      int near = 0;
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      {
        Indexed_location b = location_of_vertex(connectivity, v);
        const std::vector<Indexed_location> path = segment(geodesics, a, b);
        if(v == source)
          continue;
        expect_path(mesh, connectivity, path);
        const double l = length(mesh, path);
        ASSERT_GE(l, exact[v] * (1. - 1e-4));
        if(connectivity.mean_edge_length * 2.5 < exact[v])
          continue;
        // Where a hill lies between, a local minimum may be on its other side.
        near += std::abs(l - exact[v]) <= 1e-4 * l ? 1 : -4;
      }
      EXPECT_GE(near, 0);
    }
  }
}

TEST(Local_geodesics, joins_within_a_face_and_not_to_other_components)
{
  const Mesh mesh = indexed(disjoint_union(grid(3, 3), grid(3, 3), {{0., 0., 0.}}));
  const Mesh_connectivity connectivity(mesh);
  Local_geodesics geodesics(mesh, connectivity);
  std::vector<Indexed_location> path;
  EXPECT_TRUE(geodesics.append_segment({0, {{0.2, 0.3, 0.5}}}, {0, {{0.5, 0.3, 0.2}}}, path));
  EXPECT_EQ(path.size(), 1u);
  EXPECT_TRUE(geodesics.append_segment({0, {{0.2, 0.3, 0.5}}}, {0, {{0.2, 0.3, 0.5}}}, path));
  EXPECT_EQ(path.size(), 1u);
  EXPECT_FALSE(geodesics.append_segment({0, {{0.2, 0.3, 0.5}}}, {mesh.number_of_faces() - 1, {{1., 0., 0.}}}, path));
}

// ---- smoothing

struct Smoothed
{
  Indexed_cut_locus before, after;
};

template <typename Solver>
Smoothed smoothed(const Mesh& mesh, Index source_vertex, double angle, Index iterations = 4)
{
  Laplacian_solver component(mesh, CGAL::Cut_loci::Laplacian_operator::QUADRATIC_FIT);
  Indexed_source source;
  source.vertex = source_vertex;
  source.location = location_of_vertex(component.connectivity(), source_vertex);
  Solver solver;
  solver.set_mesh(mesh);
  std::vector<double> distance;
  solver.compute_distances(source, distance);
  component.set_distance({source}, distance);
  component.compute_strengths();
  component.grow_tree();
  component.close_cycles();
  CGAL::Cut_loci::Branch_thresholds thresholds;
  thresholds.gradient_angle = angle;
  thresholds.minimum_edges = 3;
  Smoothed result;
  result.before = component.filter(thresholds);
  CGAL::Cut_loci::Smoothing_parameters parameters;
  parameters.number_of_iterations = iterations;
  result.after = component.smoothed(result.before, parameters);
  return result;
}

// The branches as pairs of ends, where the ends that are mesh-edge nodes are told by `origin`: each branch is a set of
// origins, and its ends are the branches that meet there.
std::multiset<std::set<Index>> junctions(const Indexed_cut_locus& graph)
{
  std::vector<std::vector<Index>> incident(graph.nodes.size());
  for(Index e = 0; e < graph.edges.size(); ++e)
  {
    incident[graph.edges[e].source].push_back(e);
    incident[graph.edges[e].target].push_back(e);
  }
  // branches, each named by the smallest origin
  std::vector<Index> branch(graph.edges.size(), null_index);
  for(Index e = 0; e < graph.edges.size(); ++e)
  {
    if(branch[e] != null_index)
      continue;
    std::vector<Index> members(1, e);
    branch[e] = 0;
    Index name = graph.edges[e].origin;
    for(std::size_t i = 0; i < members.size(); ++i)
      for(Index node : {graph.edges[members[i]].source, graph.edges[members[i]].target})
        if(incident[node].size() == 2)
          for(Index other : incident[node])
            if(branch[other] == null_index)
            {
              branch[other] = 0;
              members.push_back(other);
              name = (std::min)(name, graph.edges[other].origin);
            }
    for(Index m : members)
      branch[m] = name;
  }
  std::multiset<std::set<Index>> result;
  for(const std::vector<Index>& edges : incident)
    if(edges.size() != 2)
    {
      std::set<Index> names;
      for(Index e : edges)
        names.insert(branch[e]);
      result.insert(names);
    }
  return result;
}

void expect_sound(const Mesh& mesh, const Smoothed& s)
{
  const Mesh_connectivity connectivity(mesh);
  ASSERT_FALSE(s.after.nodes.empty());
  // Euler characteristic and the way the branches meet
  EXPECT_EQ(int(s.after.nodes.size()) - int(s.after.edges.size()),
            int(s.before.nodes.size()) - int(s.before.edges.size()));
  std::vector<int> degree_before(s.before.nodes.size(), 0), degree(s.after.nodes.size(), 0);
  for(const auto& e : s.before.edges)
  {
    ++degree_before[e.source];
    ++degree_before[e.target];
  }
  std::vector<std::vector<Index>> neighbors(s.after.nodes.size());
  for(const auto& e : s.after.edges)
  {
    ++degree[e.source];
    ++degree[e.target];
    neighbors[e.source].push_back(e.target);
    neighbors[e.target].push_back(e.source);
    const Indexed_location &a = s.after.nodes[e.source].location, &b = s.after.nodes[e.target].location;
    ASSERT_TRUE(share_a_face(mesh, connectivity, a, b));
    ASSERT_GT(norm(position(mesh, a) - position(mesh, b)), 0.);
    ASSERT_EQ(e.halfedge, null_index);
    ASSERT_LT(e.origin, s.before.edges.size());
    ASSERT_EQ(e.strength, s.before.edges[e.origin].strength);
  }
  std::map<int, int> count_before, count;
  for(int d : degree_before)
    ++count_before[d];
  for(int d : degree)
    ++count[d];
  count.erase(2);
  count_before.erase(2);
  EXPECT_EQ(count, count_before);
  for(const auto& node : s.after.nodes)
    expect_valid(mesh, node.location);
  // in one piece
  std::vector<bool> seen(s.after.nodes.size(), false);
  std::vector<Index> stack(1, 0);
  seen[0] = true;
  std::size_t reached = 0;
  while(!stack.empty())
  {
    const Index v = stack.back();
    stack.pop_back();
    ++reached;
    for(Index w : neighbors[v])
      if(!seen[w])
      {
        seen[w] = true;
        stack.push_back(w);
      }
  }
  EXPECT_EQ(reached, s.after.nodes.size());
}

int sharp_turns(const Mesh& mesh, const Indexed_cut_locus& graph)
{
  std::vector<std::vector<Index>> neighbors(graph.nodes.size());
  for(const auto& e : graph.edges)
  {
    neighbors[e.source].push_back(e.target);
    neighbors[e.target].push_back(e.source);
  }
  int result = 0;
  for(Index i = 0; i < graph.nodes.size(); ++i)
    if(neighbors[i].size() == 2)
    {
      const Vector p = position(mesh, graph.nodes[i].location);
      const Vector a = p - position(mesh, graph.nodes[neighbors[i][0]].location);
      const Vector b = position(mesh, graph.nodes[neighbors[i][1]].location) - p;
      result += dot(a, b) < 0. ? 1 : 0;
    }
  return result;
}

// The pairs of edges in a face that cross each other.
int crossings(const Mesh& mesh, const Indexed_cut_locus& graph)
{
  const Mesh_connectivity connectivity(mesh);
  struct Piece
  {
    Index a, b;
    std::array<double, 2> p, q;
  };
  std::map<Index, std::vector<Piece>> pieces; // of each face
  for(const auto& e : graph.edges)
    for(Index end : {e.source, e.target}) // a segment in a face names it at one end, or lies on an edge
    {
      const Index f = graph.nodes[end].location.face;
      std::array<std::array<double, 2>, 2> point;
      bool is_in_face = true;
      for(int k = 0; k < 2; ++k)
      {
        const Indexed_location& x = graph.nodes[k == 0 ? e.source : e.target].location;
        std::array<double, 3> c = {{0., 0., 0.}};
        for(int i = 0; i < 3; ++i)
          for(int j = 0; j < 3; ++j)
            if(mesh.triangles[f][j] == mesh.triangles[x.face][i])
              c[j] = x.coordinates[i];
        is_in_face = is_in_face && std::abs(c[0] + c[1] + c[2] - 1.) < 1e-9;
        point[k] = {{c[0], c[1]}};
      }
      if(is_in_face)
        pieces[f].push_back({e.source, e.target, point[0], point[1]});
      if(graph.nodes[e.source].location.face == graph.nodes[e.target].location.face)
        break;
    }
  int result = 0;
  for(const auto& of_face : pieces)
    for(const Piece& s : of_face.second)
      for(const Piece& t : of_face.second)
      {
        if(s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b)
          continue;
        const auto side = [](const Piece& x, const std::array<double, 2>& p) { return cross(x.q - x.p, p - x.p); };
        if(side(s, t.p) * side(s, t.q) < 0. && side(t, s.p) * side(t, s.q) < 0.)
          ++result;
      }
  return result / 2;
}

// The cut locus of a point of the inner equator of a torus, at u = 0: the opposite meridian and the outer equator.
double mean_error_on_torus(const Mesh& mesh, const Indexed_cut_locus& graph, double scale = 1.)
{
  double sum = 0., weight = 0.;
  for(const auto& e : graph.edges)
  {
    const Vector a = (1. / scale) * position(mesh, graph.nodes[e.source].location);
    const Vector b = (1. / scale) * position(mesh, graph.nodes[e.target].location);
    const double l = norm(b - a);
    for(double t : {0.1, 0.3, 0.5, 0.7, 0.9})
    {
      const Vector p = (1. - t) * a + t * b;
      const double rho = std::hypot(p[0], p[1]);
      const double to_meridian = p[0] < 0. ? std::abs(p[1]) : 1.;
      const double to_equator = std::hypot(rho - 1.4, p[2]);
      sum += l * (std::min)(to_meridian, to_equator);
      weight += l;
    }
  }
  return sum / weight;
}

// with wavy rows and jitter, so that no row of edges follows the cut locus; vertex `n / 2` is on the inner equator
// for even n
Mesh irregular_torus(Index m, Index n)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  Mesh mesh = indexed(torus_with_shifted_rows(m, n));
  for(Index i = 0; i < m; ++i)
    for(Index j = 0; j < n; ++j)
    {
      const bool is_source = i == 0 && j == n / 2;
      const double wave = 1.2 * std::sin(3. * (2. * pi * i / m));
      const double w = 2. * pi * (j + wave + (is_source ? 0. : uniform(random))) / n;
      const double u = 2. * pi * (i + 1.2 * std::sin(2. * w) + (is_source ? 0. : uniform(random))) / m;
      const double rho = 1. + 0.4 * std::cos(w);
      mesh.points[i * n + j] = {{rho * std::cos(u), rho * std::sin(u), 0.4 * std::sin(w)}};
    }
  return mesh;
}

TEST(Smoothing, comes_closer_to_the_closed_form)
{
  double previous = 1.;
  for(Index n : {36, 48})
  {
    const Mesh mesh = irregular_torus(5 * n / 2, n);
    const Smoothed s = smoothed<CGAL::Shortest_path_geodesic_solver>(mesh, n / 2, 0.7);
    expect_sound(mesh, s);
    EXPECT_EQ(s.after.edges.size(), s.after.nodes.size() + 1);
    EXPECT_EQ(crossings(mesh, s.after), 0);
    EXPECT_EQ(sharp_turns(mesh, s.after), 0);
    const double before = mean_error_on_torus(mesh, s.before), after = mean_error_on_torus(mesh, s.after);
    EXPECT_LE(after, before / 3.);
    EXPECT_LE(after, 0.8 * previous);
    previous = after;
  }
}

TEST(Smoothing, does_not_depend_on_scale_and_pose)
{
  const Mesh mesh = irregular_torus(50, 20);
  const Smoothed s = smoothed<CGAL::Graph_geodesic_solver>(mesh, 10, 0.7);
  const Smoothed again = smoothed<CGAL::Graph_geodesic_solver>(mesh, 10, 0.7);
  ASSERT_EQ(s.after.nodes.size(), again.after.nodes.size());
  for(std::size_t i = 0; i < s.after.nodes.size(); ++i)
  {
    ASSERT_EQ(s.after.nodes[i].location.face, again.after.nodes[i].location.face);
    ASSERT_EQ(s.after.nodes[i].location.coordinates, again.after.nodes[i].location.coordinates);
  }
  // a power of two and a turn by a right angle: no rounding
  Mesh moved = mesh;
  for(auto& p : moved.points)
    p = {{-1024. * p[1], 1024. * p[0], 1024. * p[2]}};
  const Smoothed t = smoothed<CGAL::Graph_geodesic_solver>(moved, 10, 0.7);
  ASSERT_EQ(s.after.nodes.size(), t.after.nodes.size());
  for(std::size_t i = 0; i < s.after.nodes.size(); ++i)
  {
    const Vector p = position(mesh, s.after.nodes[i].location), q = position(moved, t.after.nodes[i].location);
    ASSERT_LE(norm(q - Vector{{-1024. * p[1], 1024. * p[0], 1024. * p[2]}}), 1e-3);
  }
}

TEST(Smoothing, keeps_the_topology_of_any_input)
{
  for(const Mesh& mesh : {indexed(torus_with_shifted_rows(40, 17)), indexed(hilly_sphere(20)), indexed(needles(12)),
                          indexed(grid(15, 15)), irregular_torus(25, 10), indexed(sphere_of_squares(8))})
    for(double angle : {0., 0.2, 0.7})
      for(Index source : {Index(0), mesh.number_of_vertices() / 3})
      {
        const Smoothed s = smoothed<CGAL::Graph_geodesic_solver>(mesh, source, angle);
        expect_sound(mesh, s);
        if(::testing::Test::HasFatalFailure())
          return;
        EXPECT_EQ(junctions(s.before), junctions(s.after));
        EXPECT_EQ(crossings(mesh, s.after), 0);
      }
}

TEST(Smoothing, turns_back_nowhere_on_strong_branches)
{
  for(const Mesh& mesh : {indexed(torus_with_shifted_rows(40, 17)), indexed(hilly_sphere(20))})
  {
    const Smoothed s = smoothed<CGAL::Shortest_path_geodesic_solver>(mesh, 0, 0.7);
    EXPECT_EQ(sharp_turns(mesh, s.after), 0);
    EXPECT_EQ(crossings(mesh, s.after), 0);
  }
}

TEST(Smoothing, is_reached_by_a_named_parameter)
{
  namespace params = CGAL::parameters;
  const auto mesh = surface_mesh_copy(irregular_torus(40, 16));
  CGAL::Surface_mesh_cut_locus<Geodesic_mesh> solver(mesh, params::geodesic_solver(CGAL::Graph_geodesic_solver()));
  solver.set_source(*mesh.vertices().begin());
  const auto edges_of_mesh = solver.cut_locus(mesh_edges);
  const auto none = solver.cut_locus(params::number_of_iterations(0));
  const auto curves = solver.cut_locus(params::number_of_iterations(4));
  EXPECT_EQ(num_edges(none.graph()), num_edges(edges_of_mesh.graph()));
  EXPECT_EQ(num_edges(curves.graph()), num_vertices(curves.graph()) + 1);
  std::size_t in_faces = 0;
  for(auto v : CGAL::make_range(vertices(curves.graph())))
    in_faces += curves.graph()[v].mesh_vertex == Geodesic_mesh::null_vertex() ? 1 : 0;
  EXPECT_GT(in_faces, num_vertices(curves.graph()) / 2);
}

} // namespace

} // namespace test_smoothing
