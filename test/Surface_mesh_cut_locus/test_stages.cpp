// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"

#include <CGAL/Cut_loci/laplacian/Branch_filter.h>
#include <CGAL/Cut_loci/laplacian/Differential_operators.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_solver.h>
#include <CGAL/Cut_loci/laplacian/Tangent_directions.h>
#include <CGAL/Cut_loci/laplacian/gradient_angles.h>
#include <CGAL/Cut_loci/laplacian/homology.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/laplacian/thinning.h>

#include <queue>

namespace test_stages {

// Each stage alone, against naive implementations.

using namespace surface_test;
using namespace CGAL::Cut_loci;
using topology_checker::make_edge;

namespace {

struct Fixture
{
  explicit Fixture(const Mesh_data& d) : data(d), mesh(indexed(d)), connectivity(mesh) {}
  Mesh_data data;
  Indexed_triangle_mesh mesh;
  Mesh_connectivity connectivity;
};

// keys without ties
std::vector<float> random_keys(std::size_t n, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<float> key(n);
  for(float& k : key)
    k = static_cast<float>(random_unit(engine));
  return key;
}

// the distance in space to vertex `source`: smooth away from it, and enough for the topological stages
std::vector<double> distances(const Mesh_data& data, std::size_t source)
{
  std::vector<double> d;
  for(const Point& p : data.points)
    d.push_back(norm(p - data.points[source]));
  return d;
}

std::vector<std::set<Index>> neighbors(const Mesh_data& data)
{
  std::vector<std::set<Index>> result(data.points.size());
  for(const Triangle& t : data.triangles)
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(i != j)
          result[t[i]].insert(static_cast<Index>(t[j]));
  return result;
}

topology_checker::Edges edges_of(const Spanning_tree& tree)
{
  topology_checker::Edges edges;
  for(Index v : tree.order)
    if(v != tree.root)
      edges.insert(make_edge(v, tree.parent[v]));
  return edges;
}

void expect_tree(const Fixture& f, const Spanning_tree& tree)
{
  const auto neighbor = neighbors(f.data);
  std::set<Index> seen;
  ASSERT_FALSE(tree.order.empty());
  EXPECT_EQ(tree.order.front(), tree.root);
  for(Index v : tree.order)
  {
    EXPECT_TRUE(seen.insert(v).second) << "vertex " << v << " is twice in the order";
    EXPECT_TRUE(tree.contains(v));
    if(v == tree.root)
    {
      EXPECT_EQ(tree.parent[v], null_index);
      continue;
    }
    EXPECT_TRUE(seen.count(tree.parent[v])) << "vertex " << v << " comes before its parent";
    EXPECT_TRUE(neighbor[v].count(tree.parent[v]));
    EXPECT_EQ(f.connectivity.ring_vertex[tree.parent_entry[v]], tree.parent[v]);
    EXPECT_GE(tree.parent_entry[v], f.connectivity.ring_begin[v]);
    EXPECT_LT(tree.parent_entry[v], f.connectivity.ring_begin[v + 1]);
  }
  for(Index v = 0; v < f.data.points.size(); ++v)
    EXPECT_EQ(tree.contains(v), seen.count(v) != 0);
}

// the largest key on the path of the tree from v to the root, both ends left out
float bottleneck_in_tree(const Spanning_tree& tree, const std::vector<float>& key, Index v)
{
  float result = -2.f;
  for(Index w = tree.parent[v]; w != null_index && w != tree.root; w = tree.parent[w])
    result = (std::max)(result, key[w]);
  return result;
}

// the smallest possible such key: the least bound below which a path from v to the root exists
float least_bottleneck(const std::vector<std::set<Index>>& neighbor, const std::vector<float>& key, Index v, Index root)
{
  std::vector<float> bounds(key.begin(), key.end());
  bounds.push_back(-2.f);
  std::sort(bounds.begin(), bounds.end());
  const auto is_reached = [&](float bound)
  {
    std::vector<bool> seen(key.size(), false);
    std::vector<Index> stack(1, v);
    seen[v] = true;
    while(!stack.empty())
    {
      const Index w = stack.back();
      stack.pop_back();
      if(w == root)
        return true;
      for(Index x : neighbor[w])
        if(!seen[x] && (x == root || key[x] <= bound))
        {
          seen[x] = true;
          stack.push_back(x);
        }
    }
    return false;
  };
  return *std::partition_point(bounds.begin(), bounds.end(), [&](float b) { return !is_reached(b); });
}

std::vector<Mesh_data> closed_meshes()
{
  return {icosahedron(),
          jittered_sphere(5, 0.2, 1),
          torus(1., 0.4, 14, 9, 0.2, 2),
          box(3, 2, 1, 2),
          perforated_plate(2, 1, 2, 3),
          perforated_plate(3, 1, 1, 4),
          perforated_plate(4, 3, 1, 5)};
}

std::vector<Mesh_data> meshes_with_border()
{
  return {square(7, 0.3, 1), cylinder(2., 9, 6, 0.2, 2),
          punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}, {{-1., 0., 0.}}, {{0., 0., 1.}}}, 0.35),
          punctured(torus(1., 0.4, 24, 14, 0.2, 4), {{{-1.4, 0., 0.}}, {{0., 1.4, 0.}}}, 0.3)};
}

std::vector<Mesh_data> all_meshes()
{
  std::vector<Mesh_data> result = closed_meshes(), others = meshes_with_border();
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

// the library's order of the stages on one key
struct Trees
{
  Spanning_tree full, thinned;
  Spanning_tree extended; // another one with the same root
};

Trees grow(const Fixture& f, const std::vector<float>& key, Index root, const Source_element& source = Source_element())
{
  Trees t;
  t.full = region_growing_tree(f.connectivity, key, root, {source});
  t.thinned = t.full;
  thin(t.thinned, f.connectivity, key);
  t.extended = region_growing_tree(f.connectivity, random_keys(key.size(), 1000), root, {source});
  return t;
}

Index farthest(const std::vector<double>& distance)
{
  return static_cast<Index>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

} // namespace

TEST(Region_growing_tree, spans_the_mesh_from_its_root)
{
  for(const Mesh_data& data : all_meshes())
    for(unsigned seed = 0; seed < 3; ++seed)
    {
      const Fixture f(data);
      const Index root = static_cast<Index>(7 * seed % data.points.size());
      const Spanning_tree tree = region_growing_tree(f.connectivity, random_keys(data.points.size(), seed), root);
      EXPECT_EQ(tree.root, root);
      EXPECT_EQ(tree.order.size(), data.points.size());
      expect_tree(f, tree);
    }
}

TEST(Region_growing_tree, leads_each_vertex_to_the_root_by_the_path_of_lowest_keys)
{
  for(const Mesh_data& data : closed_meshes())
  {
    const Fixture f(data);
    const auto neighbor = neighbors(data);
    const std::vector<float> key = random_keys(data.points.size(), 5);
    const Spanning_tree tree = region_growing_tree(f.connectivity, key, 3);
    for(Index v = 0; v < data.points.size(); v += 5)
    {
      if(v != tree.root)
      {
        EXPECT_EQ(bottleneck_in_tree(tree, key, v), least_bottleneck(neighbor, key, v, tree.root)) << "vertex " << v;
      }
    }
  }
}

TEST(Region_growing_tree, breaks_ties_by_index)
{
  const Fixture f(icosahedron());
  const std::vector<float> key(12, 0.f);
  const Spanning_tree tree = region_growing_tree(f.connectivity, key, 4);
  // with equal keys the waiting vertex of lowest index goes first: each parent is the first that had the vertex as neighbor
  std::vector<Index> parent(12, null_index);
  std::priority_queue<Index, std::vector<Index>, std::greater<Index>> queue;
  const auto neighbor = neighbors(f.data);
  queue.push(4);
  while(!queue.empty())
  {
    const Index v = queue.top();
    queue.pop();
    for(Index w : neighbor[v])
      if(w != 4 && parent[w] == null_index)
      {
        parent[w] = v;
        queue.push(w);
      }
  }
  EXPECT_EQ(tree.parent, parent);
}

TEST(Region_growing_tree, enters_each_border_loop_once)
{
  for(const Mesh_data& data : meshes_with_border())
    for(unsigned seed = 0; seed < 20; ++seed)
    {
      const Fixture f(data);
      const topology_checker::Surface surface(data.triangles, 0);
      const std::vector<double> distance = distances(data, seed % data.points.size());
      const Trees trees = grow(f, random_keys(data.points.size(), seed), farthest(distance));
      for(const Spanning_tree* tree : {&trees.full, &trees.extended})
      {
        ASSERT_EQ(tree->order.size(), data.points.size());
        std::map<std::size_t, int> entered;
        for(Index v : tree->order)
        {
          const auto loop = surface.loop_of_vertex.find(v);
          if(loop != surface.loop_of_vertex.end())
            entered[loop->second] +=
              v == tree->root || !surface.border_edges.count(make_edge(v, tree->parent[v])) ? 1 : 0;
        }
        for(const auto& e : entered)
          EXPECT_EQ(e.second, 1) << "loop " << e.first << ", seed " << seed << ", "
                                 << (tree == &trees.full ? "grown" : "extended");
      }
    }
}

TEST(Thinning, leaves_a_tree_and_removes_whole_branches_from_their_tips)
{
  for(const Mesh_data& data : all_meshes())
    for(unsigned seed = 0; seed < 3; ++seed)
    {
      const Fixture f(data);
      const std::vector<double> distance = distances(data, 0);
      const Trees trees = grow(f, random_keys(data.points.size(), seed), farthest(distance));
      expect_tree(f, trees.thinned);
      EXPECT_LT(trees.thinned.order.size(), trees.full.order.size());
      for(Index v : trees.thinned.order)
        EXPECT_EQ(trees.thinned.parent[v], trees.full.parent[v]);
      expect_tree(f, trees.extended);
      EXPECT_EQ(trees.extended.order.size(), data.points.size());
    }
}

TEST(Thinning, removes_a_leaf_exactly_if_it_has_a_stronger_neighbor_outside_its_family)
{
  for(const Mesh_data& data : closed_meshes())
    for(unsigned seed = 0; seed < 5; ++seed)
    {
      const Fixture f(data);
      const auto neighbor = neighbors(data);
      const std::vector<float> key = random_keys(data.points.size(), seed);
      const Spanning_tree full = region_growing_tree(f.connectivity, key, 2);
      Spanning_tree thinned = full;
      thin(thinned, f.connectivity, key);

      // naive: the leaf of highest key that has such a neighbor goes, until there is none
      std::set<Index> in_tree(full.order.begin(), full.order.end());
      for(;;)
      {
        std::set<Index> parents;
        for(Index v : in_tree)
          parents.insert(full.parent[v]);
        Index worst = null_index;
        for(Index v : in_tree)
        {
          if(v == full.root || parents.count(v))
            continue;
          const bool is_weak = std::any_of(neighbor[v].begin(), neighbor[v].end(),
                                           [&](Index w) {
            return in_tree.count(w) && w != full.parent[v] && full.parent[w] != full.parent[v] && key[w] < key[v];
          });
          if(is_weak && (worst == null_index || key[v] > key[worst]))
            worst = v;
        }
        if(worst == null_index)
          break;
        in_tree.erase(worst);
      }
      EXPECT_EQ(std::set<Index>(thinned.order.begin(), thinned.order.end()), in_tree) << "seed " << seed;
    }
}

TEST(Homology_generators, are_two_per_handle_and_cut_the_surface_into_a_disk_together_with_the_tree)
{
  for(const Mesh_data& data : all_meshes())
    for(unsigned seed = 0; seed < 10; ++seed)
    {
      const Fixture f(data);
      const topology_checker::Surface surface(data.triangles, 0);
      const Index source = static_cast<Index>(11 * seed % data.points.size());
      const std::vector<double> distance = distances(data, source);
      const Indexed_source at = at_vertex(f.mesh, source);
      const Trees trees =
        grow(f, random_keys(data.points.size(), seed), farthest(distance), Source_element(f.connectivity, at));
      const std::vector<Index> generators = homology_generators(f.mesh, f.connectivity, trees.extended, distance,
                                                                Source_roots(f.mesh, f.connectivity, {at}));
      EXPECT_EQ(long(generators.size()), 2 * surface.genus());
      EXPECT_EQ(long(f.connectivity.genus(f.mesh)), surface.genus());
      EXPECT_EQ(f.connectivity.number_of_border_loops, surface.number_of_loops);
      topology_checker::Cut cut{edges_of(trees.extended), trees.extended.root};
      for(Index h : generators)
        EXPECT_TRUE(cut.edges.insert(make_edge(f.mesh.source(h), f.mesh.target(h))).second);
      EXPECT_EQ(topology_checker::fault(surface, cut), "") << data.points.size() << " vertices, seed " << seed;
    }
}

TEST(Gradient_angles, a_fold_of_the_plane_has_the_angle_of_its_two_gradients)
{
  // d = -(x cos a + y sin a) on one side of the line y = 1/2, its mirror image on the other: both descend away from it
  const Mesh_data data = square(20);
  const Fixture f(data);
  const Differential_operators operators(f.mesh, f.connectivity);
  const Tangent_directions tangent(f.mesh, f.connectivity);
  for(double slope : {0.2, 0.5, 1., 2.5})
  {
    Eigen::VectorXd d(static_cast<Eigen::Index>(data.points.size()));
    for(std::size_t v = 0; v < data.points.size(); ++v)
      d[static_cast<Eigen::Index>(v)] = data.points[v][0] - slope * std::abs(data.points[v][1] - 0.5);
    const std::vector<float> angle = gradient_angles(f.mesh, f.connectivity, tangent, operators.gradient * d);
    for(std::size_t v = 0; v < data.points.size(); ++v)
    {
      if(f.connectivity.is_border(static_cast<Index>(v)))
        continue;
      const double from_fold = std::abs(data.points[v][1] - 0.5) * 20.;
      if(from_fold < 0.5) // both sides are seen in the first ring, where the fit mixes them
      {
        EXPECT_GT(angle[v], 0.6 * std::atan(slope));
        EXPECT_LT(angle[v], 2. * std::atan(slope) + 1e-4);
      }
      else if(from_fold > 3.5 && data.points[v][0] > 0.1 && data.points[v][0] < 0.9)
      {
        EXPECT_NEAR(angle[v], 0., 1e-3) << from_fold;
      }
    }
  }
}

TEST(Gradient_angles, given_gradients_on_both_sides_of_a_fold_make_their_angle)
{
  for(double half_angle : {0.1, 0.7, 1.3, 1.57})
    for(bool converge : {true, false})
    {
      // Whether directions converge is judged from the vertex. Where the fold passes beside it, both may look upwards
      // from there: only on the regular grid are the two sides of the fold those of each vertex.
      const Mesh_data data = square(10, converge ? 0.2 : 0., 3);
      const Fixture f(data);
      const Differential_operators operators(f.mesh, f.connectivity);
      const Tangent_directions tangent(f.mesh, f.connectivity);
      // directions at `half_angle` to the line, towards it or away from it
      Eigen::VectorXd gradient(2 * static_cast<Eigen::Index>(data.points.size()));
      for(Index v = 0; v < data.points.size(); ++v)
      {
        const double side = (data.points[v][1] > 0.5 + 1e-9) == converge ? -1. : 1.;
        const Point g = {{std::cos(half_angle), side * std::sin(half_angle), 0.}};
        gradient[2 * v] = dot(g, operators.frames[v].e1);
        gradient[2 * v + 1] = dot(g, operators.frames[v].e2);
      }
      const auto neighbor = neighbors(data);
      const std::vector<float> angle = gradient_angles(f.mesh, f.connectivity, tangent, gradient);
      for(Index v = 0; v < data.points.size(); ++v)
      {
        if(f.connectivity.is_border(v))
          continue;
        bool above = false, below = false;
        for(Index w : neighbor[v])
          (data.points[w][1] > 0.5 + 1e-9 ? above : below) = true;
        if(above && below && converge)
        {
          EXPECT_NEAR(angle[v], 2. * half_angle, 1e-3);
        }
        else
        {
          EXPECT_NEAR(angle[v], 0., 1e-3) << (converge ? "off the fold" : "gradients that diverge");
        }
      }
    }
}

// Quadrics fit the square of the distance to a point of the plane, up to the point and however long the faces are.
TEST(Gradient_angles, of_the_distance_vanish_in_the_plane_and_its_laplacian_is_one_over_it)
{
  for(double stretch : {1., 4., 10.})
  {
    Mesh_data data = square(20, 0.2, 1);
    for(Point& p : data.points)
      p[0] *= stretch;
    const Fixture f(data);
    std::vector<Index> inside; // and no neighbor is on the border
    for(Index v = 0; v < data.points.size(); ++v)
    {
      bool is_inside = !f.connectivity.is_border(v);
      for(Index k = f.connectivity.ring_begin[v]; k < f.connectivity.ring_begin[v + 1]; ++k)
        is_inside &= !f.connectivity.is_border(f.connectivity.ring_vertex[k]);
      if(is_inside)
        inside.push_back(v);
    }
    const Indexed_source source = at_vertex(f.mesh, inside[inside.size() / 2]);
    const std::vector<double> distance = distances(data, source.vertex);
    CGAL::Cut_loci::internal::Laplacian_solver solver(f.mesh, Laplacian_operator::QUADRATIC_FIT);
    solver.set_distance({source}, distance);
    solver.compute_strengths();
    for(Index v : inside)
      if(v != source.vertex)
      {
        EXPECT_NEAR(solver.laplacian()[v] * distance[v] / f.connectivity.mean_edge_length, 1., 1e-4) << stretch;
        EXPECT_LT(solver.gradient_angle()[v], 1e-3) << stretch;
      }
  }
}

TEST(Gradient_angles, vanish_at_the_source_where_gradients_fan_out_and_are_large_at_the_farthest_point)
{
  for(unsigned seed = 0; seed < 5; ++seed)
  {
    const Mesh_data data = jittered_sphere(12, 0.15, seed);
    const Fixture f(data);
    const Differential_operators operators(f.mesh, f.connectivity);
    const Tangent_directions tangent(f.mesh, f.connectivity);
    const std::size_t source = 17 + seed;
    Eigen::VectorXd d(static_cast<Eigen::Index>(data.points.size()));
    for(std::size_t v = 0; v < data.points.size(); ++v)
      d[static_cast<Eigen::Index>(v)] =
        std::atan2(norm(cross(data.points[v], data.points[source])), dot(data.points[v], data.points[source]));
    const std::vector<float> angle = gradient_angles(f.mesh, f.connectivity, tangent, operators.gradient * d);
    EXPECT_NEAR(angle[source], 0., 1e-6);
    const std::size_t antipode = nearest_vertex(data, -1. * data.points[source]);
    EXPECT_GT(angle[antipode], 2.);
  }
}

namespace {

// A tree with its strengths, and the filter over it.
struct Filter_case
{
  Filter_case(const Mesh_data& data, unsigned seed) : f(data)
  {
    const std::size_t n = data.points.size();
    const std::vector<double> distance = distances(data, seed % n);
    const Indexed_source source = at_vertex(f.mesh, static_cast<Index>(seed % n));
    trees = grow(f, random_keys(n, seed), farthest(distance), Source_element(f.connectivity, source));
    generators = homology_generators(f.mesh, f.connectivity, trees.extended, distance,
                                     Source_roots(f.mesh, f.connectivity, {source}));
    angle = random_keys(n, seed + 100);
    for(float& a : angle)
      a = std::abs(a) * float(pi);
    laplacian = random_keys(n, seed + 200);
    filter = Branch_filter(f.mesh, f.connectivity, trees.thinned, trees.extended, generators, angle, laplacian);
    neighbor = neighbors(data);
  }

  // everything that the homology needs: paths from the generators and from where the tree enters the border loops
  std::set<Index> kept() const
  {
    std::set<Index> result = {trees.extended.root};
    const auto keep = [&](Index v)
    {
      for(; v != null_index; v = trees.extended.parent[v])
        result.insert(v);
    };
    for(Index h : generators)
    {
      keep(f.mesh.source(h));
      keep(f.mesh.target(h));
    }
    const topology_checker::Surface surface(f.data.triangles, 0);
    for(const auto& v : surface.loop_of_vertex)
    {
      const Index parent = trees.extended.parent[v.first];
      if(parent != null_index && !surface.border_edges.count(make_edge(v.first, parent)))
        keep(static_cast<Index>(v.first));
    }
    return result;
  }

  // Branches hang on what is always kept, and on border loops where that enters them.
  std::map<Index, Index> joined() const
  {
    const std::set<Index> always = kept();
    std::map<Index, Index> parent;
    for(Index v = 0; v < f.data.points.size(); ++v)
    {
      const bool is_fixed = always.count(v) || f.connectivity.is_border(v);
      if(is_fixed || trees.thinned.contains(v))
        parent[v] = is_fixed ? trees.extended.parent[v] : trees.thinned.parent[v];
    }
    return parent;
  }

  // walks the tree anew for each threshold
  std::set<Index> naive(const Branch_thresholds& t) const
  {
    const std::set<Index> always = kept();
    const std::map<Index, Index> parent = joined();
    const auto is_strong = [&](Index v) { return angle[v] >= t.gradient_angle; };
    const auto is_low = [&](Index v) { return -laplacian[v] >= t.laplacian; };
    std::set<Index> result = always;
    if(t.policy == Filter_policy::GROWING)
    {
      for(const auto& [v, unused] : parent)
      {
        bool passes = !f.connectivity.is_border(v);
        for(Index w = v; !always.count(w) && passes; w = parent.at(w))
          passes = f.connectivity.is_border(w) || (is_strong(w) && is_low(w));
        for(Index w = v; passes && !result.count(w); w = parent.at(w)) // with the border that leads there
          result.insert(w);
      }
      return result;
    }
    // a branch needs a vertex at or below that is strong, and one that is low
    std::set<Index> strong_below, low_below;
    for(const auto& [v, unused] : parent)
      for(Index w = v; w != null_index && !f.connectivity.is_border(v); w = parent.at(w))
      {
        if(is_strong(v))
          strong_below.insert(w);
        if(is_low(v))
          low_below.insert(w);
      }
    for(const auto& [v, unused] : parent)
      if(!f.connectivity.is_border(v) && strong_below.count(v) && low_below.count(v))
        for(Index w = v; !result.count(w); w = parent.at(w)) // with the border that leads there
          result.insert(w);
    return result;
  }

  // Takes the weak end at the root from what `naive()` selects on a surface with a border; returns the root that is left.
  Index trim(std::set<Index>& selected, const Branch_thresholds& t) const
  {
    const std::map<Index, Index> parent = joined();
    Index root = trees.extended.root;
    while(f.connectivity.number_of_border_loops > 0 && !f.connectivity.is_border(root))
    {
      std::vector<Index> children;
      for(Index v : selected)
        if(v != root && parent.at(v) == root)
          children.push_back(v);
      bool stays = children.size() != 1 || (angle[root] >= t.gradient_angle && -laplacian[root] >= t.laplacian);
      for(Index h : generators)
        stays = stays || f.mesh.source(h) == root || f.mesh.target(h) == root;
      if(stays)
        break;
      selected.erase(root);
      root = children.front();
    }
    return root;
  }

  Fixture f;
  Trees trees;
  std::vector<Index> generators;
  std::vector<float> angle, laplacian;
  Branch_filter filter;
  std::vector<std::set<Index>> neighbor;
};

std::vector<Filter_case> filter_cases()
{
  std::vector<Filter_case> cases;
  unsigned seed = 0;
  for(const Mesh_data& data : all_meshes())
  {
    cases.emplace_back(data, seed);
    cases.emplace_back(data, seed + 1);
    seed += 2;
  }
  return cases;
}

topology_checker::Cut cut_of(const Branch_filter::Result& result)
{
  topology_checker::Cut cut;
  cut.root = result.vertices.front();
  for(const Branch_filter::Edge& e : result.edges)
    cut.edges.insert(make_edge(e.vertex, e.parent));
  return cut;
}

} // namespace

TEST(Branch_filter, selects_what_a_walk_over_the_tree_selects_at_any_threshold)
{
  const double none = -std::numeric_limits<double>::infinity();
  for(const Filter_case& c : filter_cases())
    for(Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
      for(double angle : {0., 0.3, 1., 2., 2.9, 3.1, 4.})
        for(double laplacian : {none, -0.5, 0.3, 0.9, 1.1})
        {
          Branch_thresholds t;
          t.policy = policy;
          t.gradient_angle = angle;
          t.laplacian = laplacian;
          const Branch_filter::Result result = c.filter(c.f.mesh, c.f.connectivity, t);
          std::set<Index> expected = c.naive(t);
          EXPECT_EQ(result.vertices.front(), c.trim(expected, t));
          EXPECT_EQ(std::set<Index>(result.vertices.begin(), result.vertices.end()), expected)
            << "angle " << angle << ", laplacian " << laplacian << ", policy " << int(policy);
          EXPECT_EQ(result.edges.size(), result.vertices.size() - 1 + c.generators.size());
          EXPECT_EQ(topology_checker::fault(topology_checker::Surface(c.f.data.triangles, 0), cut_of(result)), "");
        }
}

TEST(Branch_filter, a_higher_threshold_selects_a_subset)
{
  for(const Filter_case& c : filter_cases())
    for(Filter_policy policy : {Filter_policy::PRUNING, Filter_policy::GROWING})
      for(bool by_angle : {true, false})
      {
        std::set<Index> previous;
        for(int i = 0; i <= 20; ++i)
        {
          Branch_thresholds t;
          t.policy = policy;
          t.gradient_angle = by_angle ? pi * i / 20. : 0.;
          t.laplacian = by_angle ? t.laplacian : -1. + i / 10.;
          const Branch_filter::Result result = c.filter(c.f.mesh, c.f.connectivity, t);
          const std::set<Index> now(result.vertices.begin(), result.vertices.end());
          if(i > 0)
          {
            EXPECT_TRUE(std::includes(previous.begin(), previous.end(), now.begin(), now.end()));
          }
          previous = now;
        }
      }
}

TEST(Branch_filter, growing_selects_a_part_of_what_pruning_selects)
{
  for(const Filter_case& c : filter_cases())
    for(double angle : {0.1, 0.5, 1., 2., 3.})
    {
      Branch_thresholds t;
      t.gradient_angle = angle;
      const std::vector<Index> pruned = c.filter(c.f.mesh, c.f.connectivity, t).vertices;
      t.policy = Filter_policy::GROWING;
      const std::vector<Index> grown = c.filter(c.f.mesh, c.f.connectivity, t).vertices;
      const std::set<Index> all(pruned.begin(), pruned.end());
      for(Index v : grown)
        EXPECT_TRUE(all.count(v));
    }
}

TEST(Branch_filter, an_edge_has_the_largest_strength_from_there_to_the_tips_of_its_branch)
{
  for(const Filter_case& c : filter_cases())
  {
    const float none = -std::numeric_limits<float>::infinity();
    std::vector<float> strongest(c.angle.size(), none);
    const std::map<Index, Index> parent = c.joined();
    for(const auto& [v, unused] : parent)
      for(Index w = v; w != null_index && !c.f.connectivity.is_border(v); w = parent.at(w))
        strongest[w] = (std::max)(strongest[w], c.angle[v]);
    const Branch_filter::Result result = c.filter(c.f.mesh, c.f.connectivity, Branch_thresholds());
    for(std::size_t i = 0; i + c.generators.size() < result.edges.size(); ++i)
      EXPECT_EQ(result.edges[i].strength, strongest[result.edges[i].vertex]);
  }
}

namespace {

// the branches of a selected tree, the longest first at each vertex
class Naive_branches
{
public:
  Naive_branches(const Filter_case& c, const std::set<Index>& selected)
    : c_(c), parent_(c.joined()), always_(c.kept()), root_(c.trees.extended.root)
  {
    for(Index v : selected)
      if(v != root_)
        children_[parent_.at(v)].push_back(v);
  }

  // with what is left of them if those are removed that are shorter than a length or lead fewer edges away
  std::set<Index> left(Index edges, double length)
  {
    std::set<Index> result = always_, removed;
    result.insert(root_);
    for(;;)
    {
      Index longest = null_index;
      for(const auto& [v, below] : children_)
        for(Index w : below)
          if(result.count(v) && !result.count(w) && !removed.count(w) &&
             (longest == null_index || std::make_pair(-length_of(w), w) < std::make_pair(-length_of(longest), longest)))
            longest = w;
      if(longest == null_index)
        return result;
      const std::vector<Index> branch = branch_at(longest);
      if(length_of(longest) >= length && edges_away(branch, result) >= edges)
        result.insert(branch.begin(), branch.end());
      else
        removed.insert(longest);
    }
  }

private:
  // from the edge above `v` on
  std::vector<Index> branch_at(Index v)
  {
    std::vector<Index> result = {v}, best;
    for(Index w : children_[v])
      if(best.empty() || length_of(w) > length_of(best.front()))
        best = branch_at(w);
    result.insert(result.end(), best.begin(), best.end());
    return result;
  }

  double length_of(Index v)
  {
    double behind = 0.;
    for(Index w : children_[v])
      behind = (std::max)(behind, length_of(w));
    return behind + norm(c_.f.mesh.points[v] - c_.f.mesh.points[parent_.at(v)]);
  }

  std::size_t edges_away(const std::vector<Index>& branch, std::set<Index> reached) const
  {
    for(std::size_t n = 0;; ++n)
    {
      if(std::all_of(branch.begin(), branch.end(), [&](Index v) { return reached.count(v) == 1; }))
        return n;
      const std::set<Index> before = reached;
      for(Index v : before)
        reached.insert(c_.neighbor[v].begin(), c_.neighbor[v].end());
    }
  }

  const Filter_case& c_;
  std::map<Index, Index> parent_;
  std::set<Index> always_;
  Index root_;
  std::map<Index, std::vector<Index>> children_;
};

} // namespace

TEST(Branch_filter, removes_short_branches_and_those_that_lead_nowhere)
{
  std::size_t number_along = 0; // of long branches that are removed because they lead nowhere
  for(const Filter_case& c : filter_cases())
    for(Index minimum_edges : {0u, 1u, 2u, 3u, 5u, 20u})
      for(double minimum_length : {0., 0.3, 0.8})
      {
        Branch_thresholds t;
        t.gradient_angle = 1.5;
        const std::set<Index> all = c.naive(t);
        t.minimum_edges = minimum_edges;
        t.minimum_length = minimum_length;
        std::set<Index> expected = Naive_branches(c, all).left(minimum_edges, minimum_length);
        number_along += expected.size() < Naive_branches(c, all).left(0, minimum_length).size();
        c.trim(expected, t);
        const Branch_filter::Result result = c.filter(c.f.mesh, c.f.connectivity, t);
        EXPECT_EQ(std::set<Index>(result.vertices.begin(), result.vertices.end()), expected)
          << minimum_edges << " edges, length " << minimum_length;
        EXPECT_EQ(topology_checker::fault(topology_checker::Surface(c.f.data.triangles, 0), cut_of(result)), "");
      }
  EXPECT_GT(number_along, 0u);
}

} // namespace test_stages
