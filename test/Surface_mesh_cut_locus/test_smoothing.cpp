// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "curve_topology.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Cut_loci/face_graph/Mesh_of_points.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_solver.h>
#include <CGAL/Cut_loci/laplacian/smoothing.h>
#include <CGAL/Cut_loci/surface/insert_vertex.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

#include <numeric>

namespace test_smoothing {

namespace {

using namespace surface_test;
using Mesh = Indexed_triangle_mesh;
using namespace CGAL::Cut_loci::internal;

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

struct Smoothed
{
  Indexed_cut_locus before, after;
};

template <typename Solver>
void compute_strengths(const Mesh& mesh, const Indexed_source& source, Laplacian_solver& component)
{
  Solver solver;
  solver.set_mesh(mesh);
  std::vector<double> distance;
  solver.compute_distances(source, distance);
  component.set_distance({source}, distance, {},
                         CGAL::Cut_loci::internal::Geodesic_solver_handle(solver).is_approximate());
  component.compute_strengths();
}

template <typename Solver>
Smoothed smoothed(const Mesh& mesh, Index source_vertex, double angle, Index iterations = 4)
{
  Laplacian_solver component(mesh, CGAL::Cut_loci::Laplacian_operator::QUADRATIC_FIT);
  compute_strengths<Solver>(mesh, at_vertex(mesh, source_vertex), component);
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

// The branch of each edge, between leaves and branch points, named by the smallest of `names` of the origins of its edges.
std::vector<Index> branches(const Indexed_cut_locus& graph, const std::vector<Index>& names)
{
  const auto incident = incident_edges(graph);
  std::vector<Index> branch(graph.edges.size(), null_index);
  for(Index e = 0; e < graph.edges.size(); ++e)
  {
    if(branch[e] != null_index)
      continue;
    std::vector<Index> members(1, e);
    branch[e] = 0;
    Index name = names[graph.edges[e].origin];
    for(std::size_t i = 0; i < members.size(); ++i)
      for(Index node : {graph.edges[members[i]].source, graph.edges[members[i]].target})
        if(incident.size(node) == 2)
          for(Index other : incident[node])
            if(branch[other] == null_index)
            {
              branch[other] = 0;
              members.push_back(other);
              name = (std::min)(name, names[graph.edges[other].origin]);
            }
    for(Index m : members)
      branch[m] = name;
  }
  return branch;
}

// which branches meet at leaves and branch points
std::multiset<std::set<Index>> junctions(const Indexed_cut_locus& graph, const std::vector<Index>& branch)
{
  const auto incident = incident_edges(graph);
  std::multiset<std::set<Index>> result;
  for(Index node = 0; node < graph.nodes.size(); ++node)
    if(incident.size(node) != 2)
    {
      std::set<Index> names;
      for(Index e : incident[node])
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
  const auto degrees = [](const Indexed_cut_locus& graph)
  {
    std::vector<int> degree(graph.nodes.size(), 0);
    for(const auto& e : graph.edges)
      for(Index i : {e.source, e.target})
        ++degree[i];
    std::map<int, int> count;
    for(int d : degree)
      count[d] += d != 2;
    count.erase(2);
    return count;
  };
  EXPECT_EQ(degrees(s.after), degrees(s.before));
  topology_checker::Union_find parts(s.after.nodes.size());
  for(const auto& e : s.after.edges)
  {
    parts.unite(e.source, e.target);
    const Indexed_location &a = s.after.nodes[e.source].location, &b = s.after.nodes[e.target].location;
    ASSERT_TRUE(share_a_face(mesh, connectivity, a, b));
    ASSERT_GT(norm(position(mesh, a) - position(mesh, b)), 0.);
    ASSERT_EQ(e.halfedge != null_index,
              s.after.nodes[e.source].vertex != null_index && s.after.nodes[e.target].vertex != null_index);
    ASSERT_LT(e.origin, s.before.edges.size());
    ASSERT_EQ(e.strength, s.before.edges[e.origin].strength);
  }
  EXPECT_EQ(parts.number_of_parts(), 1u);
  for(const auto& node : s.after.nodes)
    expect_valid(mesh, node.location);
}

// the nodes where the curve turns back by more than a right angle
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

// Distances of heat are smoothed, most of all at the cut locus, and those of the graph are too long: both are off by more than the
// lengths of ways, which place the curve.
TEST(Smoothing, comes_closer_than_given_distances)
{
  const Mesh mesh = irregular_torus(120, 48);
  const double h = Mesh_connectivity(mesh).mean_edge_length;
  for(const Smoothed& s : {smoothed<CGAL::Graph_geodesic_solver>(mesh, 24, 0.7),
                           smoothed<CGAL::Heat_method_geodesic_solver<>>(mesh, 24, 0.7)})
  {
    expect_sound(mesh, s);
    EXPECT_LT(mean_error_on_torus(mesh, s.after), 0.1 * h);
  }
}

// Two triangles that are glued along two sides, like a pocket, and a third one that is glued to one side of its mouth: vertices
// 0 and 1 are joined by halfedge 0, which is on the border, and by halfedges 3 and 6.
TEST(Smoothing, tells_edges_between_the_same_vertices_apart)
{
  Mesh mesh;
  mesh.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0.4, -0.6, 0.}}, {{0.5, 1., 0.}}};
  mesh.triangles = {{{0, 1, 2}}, {{1, 0, 2}}, {{0, 1, 3}}};
  mesh.opposite = {null_index, 5, 4, 6, 2, 1, 3, null_index, null_index};
  const auto on_edges = [&](const std::vector<Index>& halfedges)
  {
    Indexed_cut_locus result;
    std::map<Index, Index> node;
    for(Index h : halfedges)
      for(Index v : {mesh.source(h), mesh.target(h)})
        if(node.emplace(v, static_cast<Index>(result.nodes.size())).second)
          result.nodes.push_back({location_of_vertex(Mesh_connectivity(mesh), v), v});
    for(Index h : halfedges)
      result.edges.push_back({node[mesh.source(h)], node[mesh.target(h)], h, 1.f, 0});
    return result;
  };
  Laplacian_solver component(mesh, CGAL::Cut_loci::Laplacian_operator::QUADRATIC_FIT);
  compute_strengths<CGAL::Graph_geodesic_solver>(mesh, at_vertex(mesh, 3), component);
  const auto expect = [&](const std::vector<Index>& halfedges, const std::set<Index>& edge, const std::string& fault)
  {
    const Indexed_cut_locus curve = component.smoothed(on_edges(halfedges), {});
    ASSERT_EQ(curve.edges.size(), 1u);
    EXPECT_EQ(edge.count(curve.edges[0].halfedge), 1u) << curve.edges[0].halfedge;
    EXPECT_EQ(curve_measures::internal::Curve_topology(mesh, curve).fault(), fault);
    const CGAL::Cut_loci::Seams seams =
      CGAL::Cut_loci::refine_along_curve(mesh, Mesh_connectivity(mesh), curve, 256).seams;
    EXPECT_EQ(std::size_t(std::count_if(seams.begin(), seams.end(), [](auto s) { return s != 0; })),
              edge.size() == 1 ? 0u : 2u); // none on the border
  };
  expect({0}, {0}, "");
  const std::string no_disk = "1 independent cycles on a surface of genus 0";
  expect({3}, {3, 6}, no_disk);
  // vertex 2 is passed where no path to it arrives: through face 1 from vertex 3, and from a point of face 0 through that
  expect({2, 1}, {0}, "");
  compute_strengths<CGAL::Graph_geodesic_solver>(mesh, {{0, {{0.3, 0.4, 0.3}}}, null_index}, component);
  expect({2, 1}, {3, 6}, no_disk);
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
        std::vector<Index> names(s.before.edges.size());
        std::iota(names.begin(), names.end(), Index(0));
        names = branches(s.before, names);
        EXPECT_EQ(junctions(s.before, names), junctions(s.after, branches(s.after, names)));
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
  const auto mesh = surface_mesh_copy(irregular_torus(40, 16));
  CGAL::Surface_mesh_cut_locus<Geodesic_mesh> solver(mesh, params::geodesic_solver(CGAL::Graph_geodesic_solver()));
  solver.set_source(*mesh.vertices().begin());
  const auto curves = solver.cut_locus(through_faces);
  EXPECT_EQ(number_of_cycles(curves), 2u);
  std::size_t in_faces = 0;
  for(auto v : CGAL::make_range(vertices(curves.graph())))
    in_faces += curves.graph()[v].mesh_vertex == Geodesic_mesh::null_vertex() ? 1 : 0;
  EXPECT_GT(in_faces, num_vertices(curves.graph()) / 2);
}

} // namespace

} // namespace test_smoothing
