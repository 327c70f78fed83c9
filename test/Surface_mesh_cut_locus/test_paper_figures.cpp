// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What the figures of "Practical Computation of the Cut Locus on Discrete Surfaces" show, as statements.

#include "surface_test.h"

#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>

namespace test_paper_figures {

namespace {

using namespace surface_test;

const auto the_papers_method = by(Laplacian_method());

double distance_to(const Cut_locus& cut_locus, const Kernel::Point_3& p)
{
  double result = (std::numeric_limits<double>::infinity)();
  for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
    result = (std::min)(result, distance(cut_locus.graph()[v].point, p));
  return result;
}

double farthest_from(const Cut_locus& cut_locus, const Kernel::Point_3& p)
{
  double result = 0.;
  for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
    result = (std::max)(result, distance(cut_locus.graph()[v].point, p));
  return result;
}

// how many branches meet at each leaf and branch point, sorted
std::vector<std::size_t> junctions(const Cut_locus& cut_locus)
{
  std::vector<std::size_t> result;
  for(auto v : CGAL::make_range(vertices(cut_locus.graph())))
    if(degree(v, cut_locus.graph()) != 2)
      result.push_back(degree(v, cut_locus.graph()));
  std::sort(result.begin(), result.end());
  return result;
}

// the largest distance of a vertex of `from` to the nearest one of `to`
double one_sided_distance(const Cut_locus& from, const Cut_locus& to)
{
  double result = 0.;
  for(auto v : CGAL::make_range(vertices(from.graph())))
    result = (std::max)(result, distance_to(to, from.graph()[v].point));
  return result;
}

// What is wrong with the topology, or an empty string.
std::string fault_at(const Built& built, const Cut_locus& result, std::size_t source)
{
  std::size_t face = 0;
  while(std::find(built.data.triangles[face].begin(), built.data.triangles[face].end(), source) ==
        built.data.triangles[face].end())
    ++face;
  return fault_of(built, result, face, {source});
}

// Figure 5: a bump on a sphere draws a line from its top to the antipode of the source; the gradients meet at a wide
// angle at both ends only.
class Sphere_with_bump : public ::testing::Test
{
protected:
  Sphere_with_bump() : built(sphere_with_bump(24, {{1., 0., 0.}}, 0.15, 0.08)), solver(built.mesh, the_papers_method)
  {
    solver.set_source(built.vertices[nearest_vertex(built.data, {{-0.17, 0., 0.98}})]);
  }
  Built built;
  Solver solver;
  const Kernel::Point_3 top{1.15, 0., 0.}, antipode{0.17, 0., -0.98};
};

TEST_F(Sphere_with_bump, pruning_keeps_the_line_from_the_bump_to_the_antipode)
{
  const Cut_locus result =
    solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().filter_policy(Filter_policy::PRUNING)));
  const double h = mean_edge_length(built.data);
  EXPECT_LT(distance_to(result, top), 2. * h);
  EXPECT_LT(distance_to(result, antipode), 2. * h);
  for(auto v : CGAL::make_range(vertices(result.graph())))
    EXPECT_LT(std::abs(result.graph()[v].point.y()), 6. * h) << "off the plane of symmetry";
}

TEST_F(Sphere_with_bump, growing_takes_the_bump_for_noise)
{
  const Cut_locus result =
    solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().filter_policy(Filter_policy::GROWING)));
  EXPECT_LT(farthest_from(result, antipode), 0.5);
}

// Figure 7: the wider the angle, the simpler the cut locus, down to a line where the gradients are opposite.
TEST(Capsule, rising_thresholds_simplify_the_cut_locus_down_to_its_plane_of_symmetry)
{
  const Built built(capsule(1., 40, 40));
  Solver solver(built.mesh, the_papers_method);
  solver.set_source(built.vertices[nearest_vertex(built.data, {{1., 0., -0.3}})]);
  std::size_t previous = (std::numeric_limits<std::size_t>::max)();
  for(double angle : {0.05, 0.2, 0.5, 1., 2., 3., CGAL_PI})
  {
    const Cut_locus result =
      solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(angle)));
    EXPECT_LE(num_edges(result.graph()), previous) << angle;
    previous = num_edges(result.graph());
    if(angle == CGAL_PI)
    {
      for(auto v : CGAL::make_range(vertices(result.graph())))
        EXPECT_LT(std::abs(result.graph()[v].point.y()), mean_edge_length(built.data)); // made of edges
    }
  }
  EXPECT_LT(previous, 20u);
}

TEST(Sphere, is_cut_in_one_point_opposite_to_the_source)
{
  const Built built(jittered_sphere(20, 0.1, 3));
  Solver solver(built.mesh, the_papers_method);
  solver.set_source(built.vertices[0]);
  const Cut_locus result =
    solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(1.)));
  const auto source = built.mesh.point(built.vertices[0]);
  EXPECT_LT(farthest_from(result, CGAL::ORIGIN - (source - CGAL::ORIGIN)), 4. * mean_edge_length(built.data));
}

// Figures 11 and 16: all resolutions show the same branches: two loops, and an arc with two ends.
TEST(Torus, has_the_same_branches_at_all_resolutions)
{
  for(std::size_t n : {16, 24, 36})
  {
    const Built built(torus(1., 0.4, 5 * n / 2, n, 0.15, 7));
    Solver solver(built.mesh, the_papers_method);
    solver.set_source(built.vertices[0]);
    const Cut_locus result = solver.cut_locus(mesh_edges);
    EXPECT_EQ(number_of_cycles(result), 2u) << n;
    EXPECT_EQ(number_of_leaves(result), 2u) << n;
  }
}

// From the inner side the outer arc closes to a loop: what is left of the candidates are short branches on the loops,
// also where a generator ends.
TEST(Torus, has_no_branch_shorter_than_the_least_length)
{
  for(std::size_t n : {20, 30, 40})
  {
    const Built built(torus(1., 0.4, 5 * n / 2, n, 0.2, 1));
    Solver solver(built.mesh, the_papers_method);
    solver.set_source(built.vertices[nearest_vertex(built.data, {{0.3, 0.3, 1.}})]);
    for(std::size_t least : {3, 6})
    {
      const Cut_locus result =
        solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().minimum_branch_edges(least)));
      const auto& graph = result.graph();
      for(auto leaf : CGAL::make_range(vertices(graph)))
      {
        if(degree(leaf, graph) != 1)
          continue;
        std::size_t length = 1;
        auto e = *out_edges(leaf, graph).first;
        for(; degree(target(e, graph), graph) == 2; ++length)
        {
          const auto around = out_edges(target(e, graph), graph);
          e = target(*around.first, graph) == source(e, graph) ? *std::next(around.first) : *around.first;
        }
        EXPECT_GE(length, least) << n;
      }
      EXPECT_EQ(number_of_cycles(result), 2u);
    }
  }
}

// Figure 12: what the methods for the distances disagree in are the weak ends of branches, not the strong parts: those
// of each one are near to the cut locus by any other one.
TEST(Methods_for_distances, agree_on_strong_branches)
{
  const Built smooth(bumpy_sphere(30, 0.5, 1)), with_handle(torus(1., 0.4, 75, 30, 0.15, 7));
  for(const Built* built : {&smooth, &with_handle})
  {
    const std::size_t source = nearest_vertex(built->data, {{0.6, 0.4, 0.9}});
    Solver exact(built->mesh, the_papers_method);
    Solver heat(built->mesh, params::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()));
    Solver graph(built->mesh, params::geodesic_solver(CGAL::Graph_geodesic_solver()));
    std::vector<Cut_locus> whole, strong;
    for(Solver* solver : {&exact, &heat, &graph})
    {
      solver->set_source(built->vertices[source]);
      whole.push_back(solver->cut_locus(mesh_edges));
      strong.push_back(
        solver->cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(1.5))));
      EXPECT_EQ(fault_at(*built, whole.back(), source), "");
      EXPECT_EQ(fault_at(*built, strong.back(), source), "");
    }
    const double h = mean_edge_length(built->data);
    for(std::size_t i = 0; i < strong.size(); ++i)
      for(std::size_t j = 0; j < whole.size(); ++j)
        EXPECT_LE(one_sided_distance(strong[i], whole[j]), 2. * h) << i << " to " << j; // measured: 1.6 h at most
  }
}

// Figure 17: slim faces of all sizes bring spurious branches, but few; remeshing takes them away, and so may growing.
TEST(Irregular_mesh, has_fewer_leaves_when_remeshed)
{
  const Built irregular(irregular_bumpy_sphere(30, 0.5, 1)), regular(remeshed(irregular.data));
  std::vector<std::size_t> leaves, leaves_of_grown;
  for(const Built* built : {&irregular, &regular})
  {
    const std::size_t source = nearest_vertex(built->data, {{0.6, 0.4, 0.9}});
    Solver solver(built->mesh, the_papers_method);
    solver.set_source(built->vertices[source]);
    const Cut_locus pruned = solver.cut_locus(mesh_edges);
    const Cut_locus grown =
      solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().filter_policy(Filter_policy::GROWING)));
    EXPECT_EQ(fault_at(*built, pruned, source), "");
    EXPECT_EQ(fault_at(*built, grown, source), "");
    leaves.push_back(number_of_leaves(pruned));
    leaves_of_grown.push_back(number_of_leaves(grown));
  }
  EXPECT_LE(leaves[1], leaves[0]); // measured: 5 and 6
  EXPECT_LE(leaves[0], 8u);
  EXPECT_LE(leaves_of_grown[0], leaves[0]);
  EXPECT_LE(leaves_of_grown[1], leaves[1]);
}

TEST(Irregular_mesh, has_the_same_loops_as_remeshed)
{
  const Built irregular(torus(1., 0.4, 30, 40, 0.35, 5)), regular(remeshed(irregular.data));
  for(const Built* built : {&irregular, &regular})
  {
    const std::size_t source = nearest_vertex(built->data, {{1.4, 0., 0.}});
    Solver solver(built->mesh, the_papers_method);
    solver.set_source(built->vertices[source]);
    for(Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
    {
      // Angles are seen two edges to either side: on slim faces this may leave whiskers of three edges.
      const Cut_locus result =
        solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().filter_policy(policy).minimum_branch_edges(4)));
      EXPECT_EQ(fault_at(*built, result, source), "");
      EXPECT_EQ(number_of_cycles(result), 2u);
      EXPECT_EQ(number_of_leaves(result), 2u);
    }
  }
}

// Figures 1 and 16: smooth curves branch as those along the edges do.
TEST(Smooth_curves, keep_the_branches)
{
  for(const Mesh_data& data : {bumpy_sphere(20, 0.5, 1), torus(1., 0.4, 50, 20, 0.15, 7), perforated_plate(3, 1, 4, 1)})
  {
    const Built built(data);
    Solver solver(built.mesh, the_papers_method);
    solver.set_source(built.vertices[5]);
    const Cut_locus edges_of_mesh = solver.cut_locus(mesh_edges);
    const Cut_locus curves = solver.cut_locus(through_faces);
    EXPECT_EQ(junctions(curves), junctions(edges_of_mesh));
    EXPECT_EQ(number_of_cycles(curves), number_of_cycles(edges_of_mesh));
    EXPECT_LT(one_sided_distance(curves, edges_of_mesh), 2. * mean_edge_length(data));
  }
}

// Figure 13: on rough shapes a wider angle or the growing policy clears the spurious branches.
TEST(Rough_sphere, is_cleared_by_a_wider_angle_or_by_growing)
{
  const Built built(rough(bumpy_sphere(20, 0.5, 1), 0.1, 1));
  Solver solver(built.mesh, the_papers_method);
  solver.set_source(built.vertices[5]);
  const Cut_locus fine =
    solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(0.1)));
  const Cut_locus coarse =
    solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(1.)));
  const Cut_locus grown = solver.cut_locus(mesh_edges.cut_locus_method(
    Laplacian_method().gradient_angle_threshold(0.1).filter_policy(Filter_policy::GROWING)));
  EXPECT_LT(number_of_leaves(coarse), number_of_leaves(fine) / 2);
  EXPECT_LT(num_edges(grown.graph()), num_edges(fine.graph()));
}

// Figure 1 and Table 1: surfaces of high genus. The checker counts cycles and looks at the complement.
TEST(Surface_of_genus_56, is_cut_into_a_disk_at_any_threshold)
{
  const Built built(perforated_plate(8, 7, 2, 1));
  Solver solver(built.mesh, params::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()));
  const std::size_t source = 11;
  solver.set_source(built.vertices[source]);
  for(double angle : {0., 0.7, 3.14})
  {
    const Cut_locus result =
      solver.cut_locus(mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(angle)));
    EXPECT_EQ(result.genus(), 56u);
    EXPECT_EQ(number_of_cycles(result), 112u);
    EXPECT_EQ(fault_at(built, result, source), "") << angle;
  }
}

} // namespace

} // namespace test_paper_figures
