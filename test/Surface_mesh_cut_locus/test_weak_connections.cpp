// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What joins the strong branches of the cut locus to the holes of a surface, and around its handles, belongs to it however
// weak it is. It is where shortest paths separate what it joins.

#include "surface_test.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>
#include <CGAL/Cut_loci/polyhedral/strength/Path_classes.h>

namespace test_weak_connections {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::internal::Branch_strength;
using CGAL::Cut_loci::internal::Exact_tree_solver;
using CGAL::Cut_loci::internal::Path_classes;
using CGAL::Cut_loci::internal::Tree_graph;

// a rough surface without some of its faces, no two of which have a vertex in common
Mesh_data scan(std::size_t n, std::size_t number_of_holes, unsigned seed)
{
  Mesh_data m = irregular_bumpy_sphere(n, 0.3, seed);
  std::vector<unsigned char> is_at_hole(m.points.size(), 0);
  std::mt19937 engine(seed);
  while(number_of_holes > 0)
  {
    const auto t = m.triangles.begin() + static_cast<std::ptrdiff_t>(engine() % m.triangles.size());
    if(is_at_hole[(*t)[0]] || is_at_hole[(*t)[1]] || is_at_hole[(*t)[2]])
      continue;
    for(std::size_t v : *t)
      is_at_hole[v] = 1;
    m.triangles.erase(t);
    --number_of_holes;
  }
  return m;
}

std::vector<Named_mesh> cases()
{
  return {{"scan with two holes", scan(8, 2, 1)},
          {"scan with seven holes", scan(20, 7, 2)},
          {"torus", torus(1., 0.4, 24, 14, 0.2, 5)},
          {"thin torus", torus(1., 0.1, 40, 6, 0.2, 6)},
          {"annulus", annulus(0.4, 1., 17, 4)},
          {"square with holes", square_with_holes(2, 2)},
          {"square with more holes", square_with_holes(3, 2)},
          {"open cylinder", cylinder(1., 16, 6, 0.1, 4)}};
}

// Whether something that passes was not looked for at first.
bool solve(Exact_tree_solver& solver, const Indexed_source& source, const Branch_strength& least)
{
  solver.expect(least);
  solver.compute_distance(source);
  solver.compute_strengths();
  solver.grow_tree();
  solver.tree().prepare_widths();
  const bool is_known = solver.tree().is_known(solver.tree().kept(least));
  solver.close_cycles();
  return !is_known;
}

// What is left of the cut locus if leaf after leaf is taken away: how often it crosses each edge of the mesh.
std::vector<int> crossings_of_core(const Exact_tree_solver& solver, const Tree_graph& graph)
{
  const Index number_of_loops = solver.number_of_border_loops();
  std::vector<int> degree(graph.nodes.size(), 0);
  for(Index i = 0; i < number_of_loops; ++i)
    degree[i] = 2; // no leaf
  for(const Tree_graph::Edge& e : graph.edges)
    for(Index i : e.nodes)
      ++degree[i];
  std::vector<unsigned char> is_left(graph.edges.size(), 1);
  for(bool is_done = false; !is_done;)
  {
    is_done = true;
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
    {
      const auto& nodes = graph.edges[e].nodes;
      if(!is_left[e] || (degree[nodes[0]] > 1 && degree[nodes[1]] > 1))
        continue;
      is_left[e] = 0;
      is_done = false;
      for(Index i : nodes)
        --degree[i];
    }
  }
  std::vector<int> result(solver.connectivity().number_of_edges(), 0);
  for(Index i = number_of_loops; i < graph.nodes.size(); ++i)
    if(degree[i] > 0 && graph.nodes[i].crossing != null_index)
      ++result[solver.connectivity().edge_of_halfedge[graph.nodes[i].halfedge]];
  return result;
}

// those of the border loops
std::vector<Path_classes::Mark> marks(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
{
  std::vector<Path_classes::Mark> result(connectivity.number_of_border_loops);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
      result[connectivity.border_loop[mesh.source(h)]] = {h, 0.};
  return result;
}

void expect_classes_of_core(const Indexed_triangle_mesh& mesh, const Exact_tree_solver& solver, const Tree_graph& graph)
{
  const auto& connectivity = solver.connectivity();
  const Path_classes classes(mesh, connectivity, solver.geodesics(), marks(mesh, connectivity));
  const std::vector<int> crossings = crossings_of_core(solver, graph);
  std::size_t number = 0;
  for(Index e = 0; e < crossings.size(); ++e)
  {
    const Index h = connectivity.halfedge_of_edge[e];
    if(mesh.is_border_edge(h))
      continue;
    // crossings of several may cancel each other
    if(crossings[e] < 2)
    {
      EXPECT_EQ(classes.separates(h), crossings[e] == 1) << "edge " << e;
    }
    number += crossings[e] == 1;
  }
  EXPECT_GT(number, 0u);
}

TEST(Weak_connections, cross_the_edges_whose_shortest_paths_separate_what_they_join)
{
  double number = 0., number_of_sure = 0.;
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    Exact_tree_solver solver(mesh);
    std::vector<Indexed_source> sources;
    for(Index v : {Index(1), mesh.number_of_vertices() / 3, mesh.number_of_vertices() - 1})
      sources.push_back(at_vertex(mesh, v));
    for(Index f = 0; f < mesh.number_of_faces(); f += mesh.number_of_faces() / 7)
      for(double a : {0., 0.31}) // on an edge, and inside
        sources.push_back(in_face(f, a, 0.37, 0.63 - a));
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      SCOPED_TRACE(c.name + ", source " + std::to_string(i));
      solve(solver, sources[i], {});
      number += 1;
      number_of_sure += solver.tree().is_sure();
      if(solver.tree().is_sure())
        expect_classes_of_core(mesh, solver, solver.tree().graph());
    }
  }
  EXPECT_GT(number_of_sure, 0.9 * number);
}

TEST(Weak_connections, are_found_where_they_are_though_what_is_weak_is_not_looked_for)
{
  std::size_t number_of_weak = 0;
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    for(Index source :
        {Index(1), mesh.number_of_vertices() / 5, mesh.number_of_vertices() / 3, mesh.number_of_vertices() / 2,
         3 * mesh.number_of_vertices() / 4, mesh.number_of_vertices() - 1})
      for(double width : {2., 5., 1000.})
      {
        SCOPED_TRACE(c.name + ", source " + std::to_string(source) + ", width " + std::to_string(width));
        CGAL::Cut_loci::internal::Exact_tree_thresholds least;
        least.width = width * mean_edge_length(c.data);
        Exact_tree_solver full(mesh), run(mesh);
        solve(full, at_vertex(mesh, source), {});
        number_of_weak += solve(run, at_vertex(mesh, source), least);
        const auto faces = Curve::THROUGH_FACES;
        const double expected = length(mesh, full.filter(least, faces)), found = length(mesh, run.filter(least, faces));
        EXPECT_TRUE(run.tree().is_known(run.tree().kept(least)));
        EXPECT_NEAR(found, expected, 0.01 * expected);
      }
  }
  EXPECT_GE(number_of_weak, 2u); // most are between faces that are drawn, and drawn with these
}

} // namespace

} // namespace test_weak_connections
