// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What is left of the cut locus at a threshold: all that is as strong, and nothing that ends in anything weaker.

#include "default_results.h"
#include "several_sources_cases.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/squared_distance_3.h>

namespace test_branch_thresholds {

namespace {

using namespace surface_test;
using namespace default_test;
using CGAL::Cut_loci::internal::Exact_tree;
using CGAL::Cut_loci::internal::Tree_graph;

// A body with limbs, of genus 0, and saddles between them: the widest place of its cut locus is anywhere. With noise,
// the largest gap is anywhere, too.
Mesh_data limbed(std::size_t n, unsigned seed, double noise = 0.)
{
  const std::vector<Point> limbs = {
    {{0.1, 0.9, 0.3}}, {{0.8, -0.5, 0.2}}, {{-0.7, -0.6, 0.1}}, {{0.1, -0.3, 0.95}}, {{0., 0.2, -0.9}}};
  Mesh_data m = jittered_sphere(n, 0.15, seed);
  std::mt19937 engine(seed);
  for(Point& p : m.points)
  {
    double radius = 0.5 + noise * random_unit(engine);
    for(std::size_t i = 0; i < limbs.size(); ++i)
      radius += (0.8 + 0.2 * double(i)) * std::exp(-14. * (1. - dot(p, normalized(limbs[i]))));
    for(double& x : p)
      x *= radius;
  }
  return m;
}

std::vector<Named_mesh> cases()
{
  return {{"limbs", limbed(10, 1)},
          {"more limbs", limbed(14, 2)},
          {"rough limbs", limbed(12, 3, 0.02)},
          {"convex", random_convex_polyhedron(80, 1)},
          {"torus", torus(1., 0.4, 24, 14, 0.2, 5)},
          {"open cylinder", cylinder(1., 16, 6, 0.1, 4)},
          {"saddle", saddle(10, 0.7, 0.2, 3)}};
}

class Solved_tree : private Solved
{
public:
  // looks for what is that strong
  Solved_tree(const Indexed_triangle_mesh& m, Index source, const Branch_strength& least)
    : Solved(m, at_vertex(m, source), least)
  {
  }

  Exact_tree& tree() { return solver->tree(); }
  const Tree_graph& graph() { return tree().graph(); }

  bool is_strong(Index e, const Branch_strength& least)
  {
    return graph().edges[e].piece != null_index && graph().edges[e].gap >= least.gap && tree().width(e) >= least.width;
  }

  double length(Index e)
  {
    const Tree_graph::Edge& edge = graph().edges[e];
    if(edge.piece == null_index)
      return 0.;
    const auto p = tree().ridges().piece_end(edge.piece, 0), q = tree().ridges().piece_end(edge.piece, 1);
    return std::hypot(p.x - q.x, p.y - q.y);
  }

  // by how much a way along it is longer than the distance grows
  double height(Index e)
  {
    const auto& [a, b] = graph().edges[e].nodes;
    return (std::max)(0., length(e) - std::fabs(graph().nodes[a].distance - graph().nodes[b].distance));
  }

  // of what is kept; what only holds it together may be shorter if less has been looked for
  double length_of_strong(const Branch_strength& least)
  {
    double result = 0.;
    for(const auto& b : tree().kept(least))
      if(is_strong(b.edge, least))
        result += length(b.edge);
    return result;
  }

  // Where four branches meet, rounding tells between which two of them there is one more, which is as short as that.
  double largest_width()
  {
    double longest = 0., result = 0.;
    for(Index e = 0; e < graph().edges.size(); ++e)
      longest = (std::max)(longest, length(e));
    for(Index e = 0; e < graph().edges.size(); ++e)
      if(length(e) > 1e-6 * longest)
        result = (std::max)(result, tree().width(e));
    return result;
  }
};

std::vector<Branch_strength> thresholds(double h)
{
  std::vector<Branch_strength> result;
  for(const auto& [gap, width] : {std::pair{0., h}, {0., 3. * h}, {0.1, 0.}, {0.5, 0.}, {0.2, 2. * h}})
  {
    result.emplace_back();
    result.back().gap = gap;
    result.back().width = width;
  }
  return result;
}

TEST(Branch_thresholds, Nothing_that_is_strong_is_missing)
{
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    for(Index source : {Index(0), mesh.number_of_vertices() / 2, mesh.number_of_vertices() - 1})
    {
      Solved_tree full(mesh, source, {});
      for(const Branch_strength& least : thresholds(mean_edge_length(c.data)))
      {
        SCOPED_TRACE(c.name + ", source " + std::to_string(source) + ", gap " + std::to_string(least.gap) + ", width " +
                     std::to_string(least.width));
        std::vector<unsigned char> is_kept(full.graph().edges.size(), 0);
        for(const auto& b : full.tree().kept(least))
          is_kept[b.edge] = 1;
        double strong = 0., missing = 0.;
        for(Index e = 0; e < is_kept.size(); ++e)
          if(full.is_strong(e, least))
          {
            strong += full.length(e);
            missing += is_kept[e] ? 0. : full.length(e);
          }
        // where branches do not get stronger inward, a short part may not be among what is tried
        EXPECT_LE(missing, 0.01 * strong);
      }
    }
  }
}

// Gauss and Bonnet: on a convex polyhedron, whose vertices are the leaves, two paths enclose the deficits of the leaves
// beyond, or those of all others.
TEST(Branch_thresholds, What_paths_enclose_is_the_curvature_of_the_vertices_beyond)
{
  std::vector<Mesh_data> bodies = {random_convex_polyhedron(60, 4)};
  bodies.push_back(bodies.back()); // and as a tower, at whose top paths come from below
  for(Point& p : bodies.back().points)
    p[2] *= 5.;
  for(const bool is_tower : {false, true})
  {
    const Mesh_data& body = bodies[is_tower];
    const Indexed_triangle_mesh mesh = indexed(body);
    std::vector<double> beyond_vertex(mesh.number_of_vertices(), 2. * pi);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const auto& p = mesh.points[mesh.source(h)];
      const auto& q = mesh.points[mesh.target(h)];
      const auto& r = mesh.points[mesh.target(Indexed_triangle_mesh::next(h))];
      const Point a = {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}}, b = {{r[0] - p[0], r[1] - p[1], r[2] - p[2]}};
      beyond_vertex[mesh.source(h)] -= std::acos(dot(normalized(a), normalized(b)));
    }
    const Index lowest = static_cast<Index>(std::min_element(mesh.points.begin(), mesh.points.end(),
                                                             [](const auto& p, const auto& q) { return p[2] < q[2]; }) -
                                            mesh.points.begin());
    Solved_tree full(mesh, lowest, {});
    const auto kept = full.tree().kept({});
    std::vector<double> beyond(full.graph().nodes.size(), 0.);
    for(std::size_t i = 0; i < beyond.size(); ++i)
      if(full.graph().nodes[i].vertex != null_index)
        beyond[i] = beyond_vertex[full.graph().nodes[i].vertex];
    int number = 0, from_behind = 0;
    for(auto b = kept.rbegin(); b != kept.rend(); ++b)
    {
      const Tree_graph::Edge& edge = full.graph().edges[b->edge];
      if(edge.piece != null_index && full.length(b->edge) > 1e-6)
      {
        const double found = full.tree().curvature(b->edge);
        const double of_both_sides = 4. * pi - beyond_vertex[lowest];
        EXPECT_NEAR(found, (std::min)(beyond[b->outer], of_both_sides - beyond[b->outer]), 1e-6);
        ++number;
        from_behind += found > pi + edge.gap;
      }
      beyond[b->inner] += beyond[b->outer];
    }
    EXPECT_GT(number, 60);
    if(is_tower)
    {
      EXPECT_GT(from_behind, 3);
    }
  }
}

// Of those that meet, one may be as low: it continues another one.
TEST(Branch_thresholds, Of_branches_that_meet_none_is_a_spur)
{
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    Solved_tree full(mesh, mesh.number_of_vertices() / 2, {});
    for(Branch_strength least : thresholds(mean_edge_length(c.data)))
    {
      least.spur = 0.1 * least.width;
      SCOPED_TRACE(c.name + ", gap " + std::to_string(least.gap) + ", width " + std::to_string(least.width));
      std::map<Index, std::vector<Index>> around;
      for(const auto& b : full.tree().kept(least))
        for(Index i : full.graph().edges[b.edge].nodes)
          around[i].push_back(b.edge);
      std::map<Index, int> spurs; // by the node where they end
      for(const auto& [leaf, edges] : around)
      {
        if(edges.size() != 1 || full.graph().nodes[leaf].face == null_index)
          continue;
        double height = 0.;
        Index i = leaf, e = edges[0];
        for(;;)
        {
          height += full.height(e);
          const auto& ends = full.graph().edges[e].nodes;
          i = ends[0] == i ? ends[1] : ends[0];
          if(around[i].size() != 2)
            break;
          e = around[i][0] == e ? around[i][1] : around[i][0];
        }
        spurs[i] += around[i].size() > 2 && height < (1. - 1e-9) * least.spur;
      }
      for(const auto& [i, number] : spurs)
        EXPECT_LE(number, 1);
    }
  }
}

TEST(Branch_thresholds, No_branch_ends_in_what_is_weak)
{
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    Solved_tree full(mesh, mesh.number_of_vertices() / 2, {});
    for(const Branch_strength& least : thresholds(mean_edge_length(c.data)))
    {
      SCOPED_TRACE(c.name + ", gap " + std::to_string(least.gap) + ", width " + std::to_string(least.width));
      std::vector<int> degree(full.graph().nodes.size(), 0);
      const auto kept = full.tree().kept(least);
      for(const auto& b : kept)
        for(Index i : full.graph().edges[b.edge].nodes)
          ++degree[i];
      for(const auto& b : kept)
        for(Index i : full.graph().edges[b.edge].nodes)
        {
          const bool is_end = degree[i] == 1 && full.graph().nodes[i].face != null_index;
          EXPECT_TRUE(!is_end || full.tree().width(b.edge) >= least.width);
        }
    }
  }
}

// What is not looked for from the start is left out only if it is weak.
TEST(Branch_thresholds, Looking_for_strong_branches_alone_finds_the_same)
{
  for(const Named_mesh& c : cases())
  {
    const Indexed_triangle_mesh mesh = indexed(c.data);
    for(Index source : {Index(0), mesh.number_of_vertices() - 1})
    {
      Solved_tree full(mesh, source, {});
      for(const Branch_strength& least : thresholds(mean_edge_length(c.data)))
      {
        SCOPED_TRACE(c.name + ", source " + std::to_string(source) + ", gap " + std::to_string(least.gap) + ", width " +
                     std::to_string(least.width));
        Solved_tree run(mesh, source, least);
        const double of_full = full.length_of_strong(least), of_run = run.length_of_strong(least);
        EXPECT_NEAR(of_run, of_full, 0.02 * of_full);
      }
    }
  }
}

// The default is what the tree of the whole polyhedron has at its strength: what is narrow and encloses much, what is weak
// between two strong parts, and what is widest in the middle of all.
TEST(Branch_thresholds, The_default_is_what_the_whole_tree_has_at_its_strength)
{
  for(const double noise : {0., 0.01, 0.03})
    for(const std::size_t n : {14, 18})
      for(unsigned seed = 1; seed <= 3; ++seed)
      {
        const Indexed_triangle_mesh mesh = indexed(limbed(n, seed, noise));
        const Branch_strength strength = Exact_tree_solver(mesh).default_thresholds();
        for(Index source = seed; source < mesh.number_of_vertices(); source += mesh.number_of_vertices() / 5)
        {
          SCOPED_TRACE("noise " + std::to_string(noise) + ", n " + std::to_string(n) + ", seed " +
                       std::to_string(seed) + ", source " + std::to_string(source));
          Solved_tree full(mesh, source, {}), run(mesh, source, strength);
          const auto length_of_kept = [&](Solved_tree& solved)
          {
            double result = 0.;
            for(const auto& b : solved.tree().kept(strength))
              result += solved.length(b.edge);
            return result;
          };
          const double of_full = length_of_kept(full);
          EXPECT_NEAR(length_of_kept(run), of_full, 1e-3 * of_full);
        }
      }
}

// of the edges of at least a width
template <typename Curve>
double length(const Curve& curve, double width)
{
  double result = 0.;
  for(auto e : CGAL::make_range(edges(curve.graph())))
    if(curve.graph()[e].width >= width)
      result += std::sqrt(CGAL::squared_distance(curve.graph()[source(e, curve.graph())].point,
                                                 curve.graph()[target(e, curve.graph())].point));
  return result;
}

// On a closed surface of genus 0 nothing but the thresholds holds the curve together.
TEST(Branch_thresholds, Every_limb_has_its_branch)
{
  for(double noise : {0., 0.01, 0.02})
  {
    const Mesh_data data = limbed(16, 3, noise);
    const Built built(data);
    const double h = mean_edge_length(data);
    for(std::size_t source : {0, 700, 2000})
    {
      SCOPED_TRACE("noise " + std::to_string(noise) + ", source " + std::to_string(source));

      const auto all =
        compute_cut_locus(built.mesh, built.vertices[source], through_faces.cut_locus_method(Polyhedral_method()));
      const auto strong = compute_cut_locus(built.mesh, built.vertices[source],
                                            through_faces.cut_locus_method(Default_method().minimum_branch_width(
                                              4. * h / several_sources::diagonal(built))));
      EXPECT_GE(length(strong, 0.), 0.99 * length(all, 4.4 * h));
      EXPECT_LE(length(strong, 0.), 1.1 * length(all, 3.6 * h));
    }
  }
}

// Limbs are narrower than the width asked for, and enclose more than half a sphere; less is asked for, more is kept.
TEST(Branch_thresholds, What_encloses_enough_may_be_narrower)
{
  const Mesh_data data = limbed(16, 3);
  const Built built(data);
  Solver solver(built.mesh);
  for(std::size_t source : {0, 700})
  {
    SCOPED_TRACE(source);
    solver.set_source(built.vertices[source]);
    const auto of = [&](const Default_method& method) { return length(solver.cut_locus(by(method)), 0.); };
    Default_method wide;
    wide.minimum_branch_width(0.25);
    double last = of(wide);
    const double of_width = last;
    for(double enclosed : {12., 6., 4., 2., 1., 0.1, 0.})
    {
      const double now = of(wide.minimum_branch_curvature(enclosed));
      EXPECT_GE(now, (1. - 1e-6) * last) << enclosed;
      last = now;
      if(enclosed == 4.)
      {
        EXPECT_GT(now, 1.2 * of_width);
      }
    }
    // at last a quarter of the width is what counts
    const double narrow = of(Default_method().minimum_branch_width(0.0625));
    EXPECT_NEAR(last, narrow, 0.05 * narrow);
    const auto by_default = solver.cut_locus(through_faces);
    const auto asked = solver.cut_locus(
      through_faces.cut_locus_method(Default_method().minimum_branch_curvature(solver.minimum_branch_curvature())));
    EXPECT_EQ(num_edges(by_default.graph()), num_edges(asked.graph()));
  }
  for(double wrong : {-1., 13., std::nan("")})
    EXPECT_THROW(solver.cut_locus(by(Default_method().minimum_branch_curvature(wrong))), Invalid_input);
}

// Paths along the edges of a mesh lead through vertices.
TEST(Branch_thresholds, Widths_are_those_of_the_polyhedron_however_it_is_divided)
{
  const std::vector<Named_mesh> polyhedra = {{"cuboid", cuboid({{3., 1., 0.4}}, 2)},
                                             {"L-shape", l_shape(2)},
                                             {"torus", torus(1., 0.5, 20, 12)},
                                             {"limbs", limbed(6, 1)}};
  for(const Named_mesh& c : polyhedra)
  {
    SCOPED_TRACE(c.name);
    const Mesh_data divided = split_in_plane(c.data);
    const Indexed_triangle_mesh coarse = indexed(c.data), fine = indexed(divided);
    Solved_tree a(coarse, 1, {}), b(fine, 1, {});
    EXPECT_NEAR(b.largest_width(), a.largest_width(), 1e-4 * a.largest_width());
  }
}

// Near a sharp vertex the paths to its branch part at a small angle, and meet at a large one.
TEST(Branch_thresholds, A_polyhedron_shows_the_branches_of_its_vertices_up_to_these)
{
  const std::vector<Named_mesh> polyhedra = {
    {"cube", cube(1)}, {"divided cube", cube(3)}, {"L-shape", l_shape(1)}, {"convex", random_convex_polyhedron(10, 3)}};
  for(const Named_mesh& c : polyhedra)
    for(std::size_t source : {std::size_t(0), c.data.points.size() / 2})
    {
      SCOPED_TRACE(c.name + ", source " + std::to_string(source));
      const Built built(c.data);

      const auto by_default = compute_cut_locus(built.mesh, built.vertices[source], through_faces);
      const auto all =
        compute_cut_locus(built.mesh, built.vertices[source], through_faces.cut_locus_method(Polyhedral_method()));
      EXPECT_NEAR(length(by_default, 0.), length(all, 0.), 1e-4 * length(all, 0.));
    }
}

} // namespace

} // namespace test_branch_thresholds
