// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Whatever the thresholds, the full tree of the polyhedron has no point nearer to the source than the lower bound.

#include "surface_test.h"
#include "curve_sources_cases.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>

namespace test_injectivity_lower_bound {

namespace {

using namespace curve_sources;
using CGAL::Cut_loci::injectivity_radius;
using Source = Solver::Source;

std::vector<Named_mesh> meshes()
{
  std::vector<Named_mesh> result = {
    {"cube", cube(1)},
    {"divided cube", cube(5)},
    {"turned diagonals", cube(4, Diagonals::PARALLEL)},
    {"cuboid", cuboid({{1., 2., 3.}}, 3)},
    {"l-shape", l_shape(3)},
    {"bumpy", bumpy_sphere(8, 0.5, 3)},
    {"irregular", irregular_bumpy_sphere(8, 0.3, 2)},
    {"torus", torus(1., 0.4, 24, 12, 0.2, 4)},
    {"capsule", capsule(2., 16, 14)},
    {"rough", rough(bumpy_sphere(8, 0.5, 1), 0.1, 1)},
    {"plate", perforated_plate(2, 1, 2, 5)},
    {"cylinder", cylinder(2., 12, 8, 0.2, 2)},
    {"two holes", punctured(jittered_sphere(9, 0.2, 3), {{{1., 0., 0.}}, {{-1., 0., 0.}}}, 0.35)}};
  for(unsigned seed = 1; seed <= 12; ++seed)
    result.push_back({"polyhedron " + std::to_string(seed), random_convex_polyhedron(5 + 4 * seed, seed)});
  return result;
}

std::vector<Source> random_sources(const Built& built, std::size_t k, std::mt19937& engine)
{
  std::vector<Source> result;
  std::set<std::size_t> taken;
  while(result.size() < k)
  {
    const std::size_t v = engine() % built.vertices.size(), f = engine() % built.faces.size();
    if(engine() % 2 == 0 && taken.insert(v).second)
      result.push_back(built.vertices[v]);
    else if(taken.insert(built.vertices.size() + f).second)
      result.push_back(Solver::Face_location(built.faces[f], {{0.2, 0.5, 0.3}}));
  }
  return result;
}

// of a result with all branches. Curves are moved, by 1e-4 of their edges at most, which bends what was flat as much.
double least_distance(const Result& full)
{
  double result = full.number_of_sources() > 0 && !full.is_curve(0) ? injectivity_radius(full).distance
                                                                    : std::numeric_limits<double>::infinity();
  const auto& graph = full.graph();
  for(const auto e : CGAL::make_range(edges(graph)))
    if(graph[e].strength > 1e-4)
      for(const auto v : {source(e, graph), target(e, graph)})
        result = (std::min)(result, graph[v].distance);
  return result;
}

struct Counts
{
  int all = 0, equal = 0;
};

// that no bound is too high, whatever the thresholds, and none is too low by more than lengths may be changed
void expect_bounds(const Built& built, const Solver& direction, const Result& full, Counts& counts)
{
  const double rounding = 1e-9 * mean_edge_length(built.data), least = least_distance(full);
  const double far = 2.5e-4 * longest_edge(built.mesh); // twice as far as any move
  const auto of_all = injectivity_radius(full);
  EXPECT_GE(of_all.lower_bound, of_all.distance - far);
  for(const Result& result : {direction.cut_locus(), direction.cut_locus(by(Default_method().minimum_branch_width(1.))),
                              direction.cut_locus(by(Default_method().minimum_branch_gap(0.5))),
                              direction.cut_locus(by(Default_method().minimum_branch_width(0.01)))})
  {
    const auto radius = injectivity_radius(result);
    EXPECT_LE(radius.lower_bound, least + rounding);
    EXPECT_LE(radius.lower_bound, radius.distance);
    EXPECT_GE(radius.lower_bound, least - far);
    const auto statistics = CGAL::Cut_loci::compute_statistics(result);
    EXPECT_EQ(statistics.injectivity_radius, radius.distance);
    EXPECT_EQ(statistics.injectivity_lower_bound, radius.lower_bound);
    ++counts.all;
    counts.equal += radius.lower_bound >= least - rounding;
  }
}

TEST(Injectivity_lower_bound, of_points_is_the_least_distance_of_the_full_tree)
{
  Counts counts;
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    Solver full(built.mesh, by(Polyhedral_method())), direction(built.mesh);
    std::mt19937 engine(7);
    for(std::size_t k : {1, 1, 1, 1, 3, 6})
    {
      const std::vector<Source> sources = random_sources(built, k, engine);
      SCOPED_TRACE(m.name + ", " + std::to_string(k) + " sources");
      full.set_sources(sources);
      direction.set_sources(sources);
      const Result all = full.cut_locus();
      expect_bounds(built, direction, all, counts);
      // edges of the mesh have a radius of their own, and are no reason for a higher bound
      const auto edges = injectivity_radius(direction.cut_locus(mesh_edges));
      EXPECT_LE(edges.lower_bound, (std::min)(edges.distance, least_distance(all) + 1e-9 * mean_edge_length(m.data)));
      if(k > 1)
        continue;
      direction.set_sources(sources, params::maximum_relative_error(0.01));
      EXPECT_LE(injectivity_radius(direction.cut_locus()).lower_bound, least_distance(all));
    }
  }
  EXPECT_GT(counts.equal, 0.95 * counts.all);
}

TEST(Injectivity_lower_bound, of_curves_is_zero_at_corners_and_else_the_least_distance)
{
  Counts counts;
  int zero = 0;
  for(const Named_mesh& m : meshes())
  {
    const Built built(m.data);
    if(built.vertices.size() < 40)
      continue;
    Solver full(built.mesh, by(Polyhedral_method())), direction(built.mesh);
    std::vector<std::vector<Edges>> sets = {border_loops(built)};
    for(unsigned seed = 1; seed <= 4; ++seed)
      sets.push_back(random_curves(built, seed % 3 + 1, seed % 2 == 0 ? 1 : 4, seed)); // one edge has no corner
    for(const std::vector<Edges>& curves : sets)
    {
      if(curves.empty())
        continue;
      SCOPED_TRACE(m.name + ", " + std::to_string(curves.size()) + " curves");
      full.set_sources(Vertices(), params::source_curves(curves));
      direction.set_sources(Vertices(), params::source_curves(curves));
      const Result all = full.cut_locus();
      expect_bounds(built, direction, all, counts);
      zero += injectivity_radius(direction.cut_locus()).lower_bound == 0.;
    }
  }
  EXPECT_GT(zero, 20);
  EXPECT_GT(counts.all, 4 * zero + 80);
}

// Nothing is left out where nothing is weak: the bound is the radius. Along the border there are no corners.
TEST(Injectivity_lower_bound, is_the_radius_where_no_vertex_has_positive_curvature)
{
  const Built built(cylinder(2., 12, 8, 0., 0));
  Solver solver(built.mesh);
  for(std::size_t v : {1, 20, 50})
  {
    solver.set_source(built.vertices[v]);
    const auto radius = injectivity_radius(solver.cut_locus());
    EXPECT_NEAR(radius.lower_bound, radius.distance, 2.5e-4 * longest_edge(built.mesh));
  }
  solver.set_sources(Vertices(), params::source_border(true));
  const auto radius = injectivity_radius(solver.cut_locus());
  EXPECT_NEAR(radius.distance, 1., 1e-5);
  EXPECT_NEAR(radius.lower_bound, 1., 2.5e-4 * longest_edge(built.mesh));
}

TEST(Injectivity_lower_bound, is_zero_where_it_is_not_known)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 4));
  const auto radius = injectivity_radius(compute_cut_locus(built.mesh, built.vertices[0], by(Laplacian_method())));
  EXPECT_GT(radius.distance, 0.);
  EXPECT_EQ(radius.lower_bound, 0.);
}

} // namespace

} // namespace test_injectivity_lower_bound
