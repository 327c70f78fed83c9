// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "topology_checker.h"

#include <gtest/gtest.h>

namespace test_topology_checker {

// The checker must see what is wrong: each fault is made on purpose.

using topology_checker::Cut;
using topology_checker::fault;
using topology_checker::fault_at_source;
using topology_checker::make_edge;
using topology_checker::Surface;

namespace {

// A spanning tree of edges plus nothing else.
topology_checker::Edges spanning_tree(const Surface& surface)
{
  topology_checker::Edges tree;
  topology_checker::Union_find joined(*surface.vertices.rbegin() + 1);
  for(const auto& e : surface.edges)
    if(joined.unite(e.first, e.second))
      tree.insert(e);
  return tree;
}

} // namespace

TEST(Topology_checker, accepts_a_single_vertex_and_a_spanning_tree_on_a_sphere)
{
  const Surface sphere(test_meshes::sphere(3).triangles, 0);
  EXPECT_EQ(sphere.genus(), 0);
  EXPECT_EQ(fault(sphere, {{}, 5}), "");
  EXPECT_EQ(fault(sphere, {spanning_tree(sphere), 5}), "");
}

TEST(Topology_checker, sees_two_pieces_on_a_sphere)
{
  const Surface sphere(test_meshes::icosahedron().triangles, 0);
  EXPECT_EQ(fault(sphere, {{make_edge(0, 11), make_edge(3, 9)}, 0}), "the graph has 2 components");
  EXPECT_EQ(fault(sphere, {{make_edge(3, 9)}, 0}), "the graph has 2 components");
}

TEST(Topology_checker, sees_a_cycle_on_a_sphere)
{
  const Surface sphere(test_meshes::icosahedron().triangles, 0);
  EXPECT_EQ(fault(sphere, {{make_edge(0, 11), make_edge(11, 5), make_edge(0, 5)}, 0}),
            "the graph has 1 independent cycles on a surface of genus 0");
}

TEST(Topology_checker, sees_edges_that_the_surface_does_not_have)
{
  const Surface sphere(test_meshes::icosahedron().triangles, 0);
  EXPECT_EQ(fault(sphere, {{make_edge(0, 3)}, 0}), "edge 0 - 3 is not an edge of the component");
}

TEST(Topology_checker, sees_missing_and_separating_cycles_on_a_torus)
{
  const std::size_t nu = 8, nw = 6;
  const Surface torus(test_meshes::torus(1., 0.4, nu, nw).triangles, 0);
  EXPECT_EQ(torus.genus(), 1);
  EXPECT_EQ(fault(torus, {{}, 0}), "the graph has 0 independent cycles on a surface of genus 1");
  topology_checker::Edges meridian, parallel, other_meridian;
  for(std::size_t w = 0; w < nw; ++w)
  {
    meridian.insert(make_edge(w, (w + 1) % nw));
    other_meridian.insert(make_edge(3 * nw + w, 3 * nw + (w + 1) % nw));
  }
  for(std::size_t u = 0; u < nu; ++u)
    parallel.insert(make_edge(u * nw, (u + 1) % nu * nw));
  Cut cut{meridian, 0};
  EXPECT_EQ(fault(torus, cut), "the graph has 1 independent cycles on a surface of genus 1");
  cut.edges.insert(parallel.begin(), parallel.end());
  EXPECT_EQ(fault(torus, cut), "");
  // two meridians and a path between them: connected, two cycles, but the surface falls in two
  cut.edges = meridian;
  cut.edges.insert(other_meridian.begin(), other_meridian.end());
  for(std::size_t u = 0; u < 3; ++u)
    cut.edges.insert(make_edge(u * nw, (u + 1) * nw));
  EXPECT_EQ(fault(torus, cut), "the complement has 2 parts");
}

TEST(Topology_checker, counts_each_border_loop_as_a_point)
{
  const test_meshes::Mesh_data cylinder = test_meshes::cylinder(1., 6, 3, 0., 0);
  const Surface surface(cylinder.triangles, 0);
  EXPECT_EQ(surface.number_of_loops, 2u);
  EXPECT_EQ(surface.genus(), 0);
  EXPECT_EQ(fault(surface, {{}, 0}), "the graph has 2 components");
  Cut cut{{make_edge(0, 6), make_edge(6, 12), make_edge(12, 18)}, 6};
  EXPECT_EQ(fault(surface, cut), "");
  cut.edges.insert(make_edge(0, 1)); // along the border
  EXPECT_EQ(fault(surface, cut), "");
  cut.edges.insert(make_edge(1, 7));
  EXPECT_EQ(fault(surface, cut), "");
  cut.edges.insert(make_edge(6, 7));
  EXPECT_EQ(fault(surface, cut), "the graph has 1 independent cycles on a surface of genus 0");
}

TEST(Topology_checker, sees_the_source_on_the_cut)
{
  const Surface sphere(test_meshes::icosahedron().triangles, 0);
  const Cut cut{{make_edge(0, 11)}, 0};
  EXPECT_EQ(fault_at_source(sphere, cut, {3}), "");
  EXPECT_EQ(fault_at_source(sphere, cut, {11}), "the source is on the cut locus");
  EXPECT_EQ(fault_at_source(sphere, cut, {0}), "the source is the root");
  EXPECT_EQ(fault_at_source(sphere, cut, {0, 11}), "the edge of the source is on the cut locus");
  EXPECT_EQ(fault_at_source(sphere, cut, {0, 5}), "");
}

} // namespace test_topology_checker
