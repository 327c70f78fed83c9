// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// All of the cut locus of convex polyhedra, against what is known of it.

#include "surface_test.h"
#include "default_results.h"

#include <CGAL/boost/graph/generators.h>

namespace test_exact_tree_convex {

namespace {

using namespace surface_test;
using namespace default_test;
using namespace CGAL::Cut_loci;

// The cut locus is a tree whose leaves are the vertices of positive curvature, all of them on it but the source.
void check_tree(const Indexed_triangle_mesh& mesh, const Indexed_source& source, const std::string& name)
{
  SCOPED_TRACE(name);
  const Solved solved(mesh, source, Branch_strength());
  const Indexed_cut_locus graph = solved.all();
  const auto total_angle = [&](Index v) { return solved.solver->geodesics().faces().total_angle(v); };
  expect_disk(mesh, graph);
  std::set<Index> on_it;
  for(const auto& node : graph.nodes)
    if(node.vertex != null_index)
      on_it.insert(node.vertex);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    EXPECT_TRUE(on_it.count(v) == 1 || v == source.vertex || total_angle(v) > 2. * pi - 1e-9) << "vertex " << v;
  for(Index i : leaves(graph))
  {
    const Index v = graph.nodes[i].vertex;
    ASSERT_NE(v, null_index);
    EXPECT_LT(total_angle(v), 2. * pi - 1e-9);
  }
}

TEST(Polyhedral_cut_locus, trees)
{
  const double s = std::sqrt(3.);
  const Indexed_triangle_mesh tetrahedron =
    indexed(Mesh_data{{{{1., 0., 0.}}, {{-0.5, s / 2., 0.}}, {{-0.5, -s / 2., 0.}}, {{0., 0., std::sqrt(2.)}}},
                      {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}});
  const Indexed_triangle_mesh prism = indexed(revolution(3, {{{0., 0.}}, {{1., 0.}}, {{1., 2.}}, {{0., 2.}}}));
  std::vector<std::pair<std::string, Indexed_triangle_mesh>> meshes = {
    {"tetrahedron", tetrahedron},
    {"prism", prism},
    {"double pyramid", indexed(revolution(5, {{{0., -1.}}, {{1., -0.5}}, {{0., 1.}}}))}};
  for(int n : {1, 2, 3})
  {
    meshes.push_back({"cube", indexed(cube(n, Diagonals::PARALLEL))});
    meshes.push_back({"box", indexed(cuboid({{3., 1., 0.4}}, n, Diagonals::PARALLEL))});
  }
  for(const auto& m : meshes)
  {
    for(Index v = 0; v < m.second.number_of_vertices(); ++v)
      check_tree(m.second, at_vertex(m.second, v), m.first + ", vertex " + std::to_string(v));
    for(Index f = 0; f < m.second.number_of_faces(); f += 3)
    {
      check_tree(m.second, in_face(f, 0.5, 0.3, 0.2), m.first + ", face " + std::to_string(f));
      check_tree(m.second, in_face(f, 1. / 3., 1. / 3., 1. / 3.), m.first + ", centroid " + std::to_string(f));
      check_tree(m.second, in_face(f, 0.4, 0.6, 0.), m.first + ", edge " + std::to_string(f));
    }
  }
}

// From the middle of a face of the cube: the four edges that leave that face, and the diagonals of the opposite one.
TEST(Polyhedral_cut_locus, cube_in_closed_form)
{
  for(int n : {2, 4})
  {
    const Indexed_triangle_mesh mesh = indexed(cube(n, Diagonals::PARALLEL));
    const auto middle = static_cast<Index>(nearest_vertex(mesh.points, {{0.5, 0.5, 0.}}));
    const Indexed_cut_locus graph = Solved(mesh, at_vertex(mesh, middle), Branch_strength()).all();
    EXPECT_NEAR(length(mesh, graph), 4. + 2. * std::sqrt(2.), 1e-6);
    EXPECT_EQ(leaves(graph).size(), 4u);
    for(const auto& node : graph.nodes)
    {
      const auto x = position(mesh, node.location);
      const bool on_vertical = std::fabs(x[0] - std::round(x[0])) < 1e-6 && std::fabs(x[1] - std::round(x[1])) < 1e-6;
      const bool on_diagonal =
        std::fabs(x[2] - 1.) < 1e-6 && (std::fabs(x[0] - x[1]) < 1e-6 || std::fabs(x[0] + x[1] - 1.) < 1e-6);
      EXPECT_TRUE(on_vertical || on_diagonal) << x[0] << " " << x[1] << " " << x[2];
    }
  }
}

TEST(Polyhedral_cut_locus, public_interface)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Mesh::Point(0., 0., 0.), Mesh::Point(1., 0., 0.), Mesh::Point(0., 1., 0.),
                         Mesh::Point(0., 0., 1.), mesh);
  Solver solver(mesh, by(Polyhedral_method()));
  solver.set_source(*mesh.vertices().begin());
  const auto result = solver.cut_locus();
  EXPECT_EQ(number_of_cycles(result), 0u);
  EXPECT_EQ(number_of_leaves(result), 3u);
}

} // namespace

} // namespace test_exact_tree_convex
