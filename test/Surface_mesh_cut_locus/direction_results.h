// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_TEST_DIRECTION_RESULTS_H
#define CGAL_CUT_LOCI_TEST_DIRECTION_RESULTS_H

#include "surface_test.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>

// Cut loci on dense arrays from the exact distances, and what must hold for every result.
namespace direction_test {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using namespace surface_test;

inline std::array<double, 3> point_at(const Indexed_triangle_mesh& mesh,
                                      const CGAL::Cut_loci::Indexed_location& location)
{
  using namespace CGAL::Cut_loci::internal;
  std::array<double, 3> p = {{0., 0., 0.}};
  for(int i = 0; i < 3; ++i)
    p = p + location.coordinates[i] * mesh.points[mesh.triangles[location.face][i]];
  return p;
}

inline std::vector<Index> leaves(const Indexed_cut_locus& graph)
{
  std::vector<int> degree(graph.nodes.size(), 0);
  for(const auto& e : graph.edges)
  {
    ++degree[e.source];
    ++degree[e.target];
  }
  std::vector<Index> result;
  for(Index i = 0; i < degree.size(); ++i)
    if(degree[i] == 1)
      result.push_back(i);
  return result;
}

inline double total_length(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& graph)
{
  using namespace CGAL::Cut_loci::internal;
  double result = 0.;
  for(const auto& e : graph.edges)
    result += norm(point_at(mesh, graph.nodes[e.source].location) - point_at(mesh, graph.nodes[e.target].location));
  return result;
}

// Connected, 2g cycles, border loops being points: the Betti numbers of the graph.
inline void expect_graph_topology(const Indexed_triangle_mesh& mesh, const CGAL::Cut_loci::Mesh_connectivity& c,
                                  const Indexed_cut_locus& graph)
{
  const std::size_t n = graph.nodes.size();
  std::vector<std::size_t> parent(n + c.number_of_border_loops);
  for(std::size_t i = 0; i < parent.size(); ++i)
    parent[i] = i;
  const std::function<std::size_t(std::size_t)> find = [&](std::size_t i)
  { return parent[i] == i ? i : parent[i] = find(parent[i]); };
  std::size_t components = parent.size(), cycles = 0;
  const auto unite = [&](std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    parent[a] = b;
    components -= a != b;
    return a != b;
  };
  for(std::size_t i = 0; i < n; ++i)
  {
    const auto& location = graph.nodes[i].location;
    Index loop = null_index;
    if(graph.nodes[i].vertex != null_index && c.is_border(graph.nodes[i].vertex))
      loop = c.border_loop[graph.nodes[i].vertex];
    for(Index k = 0; k < 3; ++k)
      if(graph.nodes[i].vertex == null_index && location.coordinates[(k + 2) % 3] == 0. &&
         mesh.is_border_edge(3 * location.face + k))
        loop = c.border_loop[mesh.source(3 * location.face + k)];
    if(loop != null_index)
      unite(i, n + loop);
  }
  for(const auto& e : graph.edges)
    cycles += !unite(e.source, e.target);
  EXPECT_EQ(cycles, 2 * c.genus(mesh));
  EXPECT_EQ(components, 1u);
}

// The mesh falls into one piece when it is cut along the edges.
inline void expect_complement_in_one_piece(const Indexed_triangle_mesh& mesh,
                                           const CGAL::Cut_loci::Mesh_connectivity& c, const Indexed_cut_locus& graph)
{
  std::set<Index> cut;
  for(const auto& e : graph.edges)
  {
    ASSERT_NE(e.halfedge, null_index);
    EXPECT_TRUE(cut.insert(c.edge_of_halfedge[e.halfedge]).second) << "an edge occurs twice";
    const std::set<Index> ends = {graph.nodes[e.source].vertex, graph.nodes[e.target].vertex};
    EXPECT_EQ(ends, (std::set<Index>{mesh.source(e.halfedge), mesh.target(e.halfedge)}));
  }
  std::vector<Index> stack(1, 0);
  std::vector<bool> seen(mesh.number_of_faces(), false);
  seen[0] = true;
  Index count = 1;
  while(!stack.empty())
  {
    const Index f = stack.back();
    stack.pop_back();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(mesh.opposite[h] != null_index && cut.count(c.edge_of_halfedge[h]) == 0 && !seen[mesh.opposite[h] / 3])
      {
        seen[mesh.opposite[h] / 3] = true;
        ++count;
        stack.push_back(mesh.opposite[h] / 3);
      }
  }
  EXPECT_EQ(count, mesh.number_of_faces());
}

struct Solved
{
  using Thresholds = CGAL::Cut_loci::internal::Exact_tree_thresholds;

  Indexed_triangle_mesh mesh;
  std::unique_ptr<CGAL::Cut_loci::internal::Exact_tree_solver> solver;

  /// `error`: the maximum relative error of the distances
  Solved(const Indexed_triangle_mesh& m, const CGAL::Cut_loci::Indexed_source& source, double error = 0.) : mesh(m)
  {
    solver.reset(new CGAL::Cut_loci::internal::Exact_tree_solver(mesh));
    solver->expect(solver->default_thresholds());
    solver->set_maximum_relative_error(error);
    solver->compute_distance(source);
    solver->compute_strengths();
    solver->grow_tree();
    solver->close_cycles();
  }

  Indexed_cut_locus curve(const Thresholds& thresholds, CGAL::Cut_loci::Curve kind) const
  {
    return solver->filter(thresholds, kind);
  }
  Indexed_cut_locus mesh_edges() const
  {
    return curve(solver->default_thresholds(), CGAL::Cut_loci::Curve::MESH_EDGES);
  }
  Indexed_cut_locus through_faces() const
  {
    return curve(solver->default_thresholds(), CGAL::Cut_loci::Curve::THROUGH_FACES);
  }
};

// of a width in mean edge lengths
inline Solved::Thresholds at_least(double width, const Solved& solved)
{
  Solved::Thresholds result;
  result.width = width * solved.solver->connectivity().mean_edge_length;
  return result;
}

// what must hold at any threshold
inline void expect_invariants(const Indexed_triangle_mesh& mesh, const CGAL::Cut_loci::Indexed_source& source,
                              const std::string& name, double error = 0.)
{
  const Solved solved(mesh, source, error);
  for(const Solved::Thresholds& thresholds : {solved.solver->default_thresholds(), at_least(1e9, solved),
                                              at_least(5., solved), at_least(0.5, solved), at_least(0., solved)})
  {
    if(error > 0. && thresholds.is_none())
      continue; // needs exact distances
    SCOPED_TRACE(name + ", width " + std::to_string(thresholds.width) + ", gap " + std::to_string(thresholds.gap));
    const Indexed_cut_locus edges = solved.curve(thresholds, CGAL::Cut_loci::Curve::MESH_EDGES),
                            curve = solved.curve(thresholds, CGAL::Cut_loci::Curve::THROUGH_FACES);
    ASSERT_FALSE(edges.nodes.empty());
    ASSERT_FALSE(curve.nodes.empty());
    expect_graph_topology(mesh, solved.solver->connectivity(), edges);
    expect_complement_in_one_piece(mesh, solved.solver->connectivity(), edges);
    expect_graph_topology(mesh, solved.solver->connectivity(), curve);
    for(const auto& node : edges.nodes)
      EXPECT_NE(node.vertex, source.vertex == null_index ? null_index - 1 : source.vertex);
    for(const auto& node : curve.nodes)
    {
      double sum = 0.;
      for(double x : node.location.coordinates)
      {
        EXPECT_GE(x, 0.);
        sum += x;
      }
      EXPECT_NEAR(sum, 1., 1e-9);
      EXPECT_GT(node.distance, 0.);
    }
    for(const auto& e : curve.edges)
      EXPECT_NE(e.source, e.target);
  }
}

} // namespace direction_test

#endif // CGAL_CUT_LOCI_TEST_DIRECTION_RESULTS_H
