// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut locus of polyhedra of any kind: with saddles, handles, borders and flat parts, from any source. What is on it
// is told by an oracle that unfolds the surface on its own.

#include "surface_test.h"
#include "curve_topology.h"
#include "detour.h"
#include "polyhedral_oracle.h"

#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>

namespace test_exact_tree {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::internal::Exact_tree_solver;
using Point = CGAL::Simple_cartesian<double>::Point_3;

Indexed_cut_locus curve_of(Exact_tree_solver& solver, double gap = 0., double width = 0.)
{
  CGAL::Cut_loci::internal::Exact_tree_thresholds thresholds;
  thresholds.gap = gap;
  thresholds.width = width;
  return solver.filter(thresholds, CGAL::Cut_loci::Curve::THROUGH_FACES);
}

// in no symmetric position
std::vector<Named_mesh> generic_meshes()
{
  return {{"convex", test_meshes::random_convex_polyhedron(60, 1)},
          {"flat convex", test_meshes::random_convex_polyhedron(50, 2, {{1., 0.8, 0.1}})},
          {"torus", test_meshes::torus(1., 0.4, 14, 9, 0.1, 5)},
          {"saddle", test_meshes::saddle(8, 0.7, 0.2, 3)},
          {"open cylinder", test_meshes::cylinder(1., 12, 4, 0.1, 4)},
          {"rough torus", test_meshes::torus(1., 0.5, 20, 12, 0.3, 7)}};
}

// with all that CAD models have: flat parts, edges in a line, ties
std::vector<Named_mesh> meshes()
{
  return {{"convex", test_meshes::random_convex_polyhedron(60, 1)},
          {"flat convex", test_meshes::random_convex_polyhedron(50, 2, {{1., 0.8, 0.1}})},
          {"cube", test_meshes::cube(2)},
          {"cuboid", test_meshes::cuboid({{3., 1., 0.4}}, 2)},
          {"L-shape", test_meshes::l_shape(2)},
          {"torus", test_meshes::torus(1., 0.4, 14, 9, 0.1, 5)},
          {"plate of genus 3", test_meshes::plate_with_holes(3, 1, 1)},
          {"square with holes", test_meshes::square_with_holes(2, 2)},
          {"saddle", test_meshes::saddle(8, 0.7, 0.2, 3)},
          {"annulus", test_meshes::annulus(0.4, 1., 16, 3)},
          {"open cylinder", test_meshes::cylinder(1., 12, 4, 0.1, 4)}};
}

// a vertex, a border vertex if there is one, a point of an edge and one in a face
std::vector<Indexed_source> sources(const Indexed_triangle_mesh& mesh)
{
  std::vector<Indexed_source> result = {at_vertex(mesh, mesh.number_of_vertices() / 3),
                                        in_face(mesh.number_of_faces() / 2, 0.5, 0.2, 0.3),
                                        in_face(mesh.number_of_faces() / 5, 0.37, 0.63, 0.)};
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
    {
      result.push_back(at_vertex(mesh, mesh.source(h)));
      break;
    }
  return result;
}

void solve(Exact_tree_solver& solver, const Indexed_source& source)
{
  solver.compute_distance(source);
  solver.compute_strengths();
  solver.grow_tree();
  solver.close_cycles();
}

struct Graph_numbers
{
  std::size_t components, cycles;
};

// each border loop is one more node
Graph_numbers count(const Indexed_triangle_mesh& mesh, const CGAL::Cut_loci::Mesh_connectivity& c,
                    const Indexed_cut_locus& graph)
{
  const std::size_t n = graph.nodes.size();
  std::vector<std::size_t> parent(n + c.number_of_border_loops);
  for(std::size_t i = 0; i < parent.size(); ++i)
    parent[i] = i;
  const std::function<std::size_t(std::size_t)> root = [&](std::size_t i)
  { return parent[i] == i ? i : parent[i] = root(parent[i]); };
  Graph_numbers result{parent.size(), 0};
  const auto unite = [&](std::size_t a, std::size_t b)
  {
    const bool is_new = root(a) != root(b);
    parent[root(a)] = root(b);
    result.components -= is_new;
    return is_new;
  };
  for(std::size_t i = 0; i < n; ++i)
  {
    const Indexed_cut_locus::Node& node = graph.nodes[i];
    if(node.vertex != null_index && c.is_border(node.vertex))
      unite(i, n + c.border_loop[node.vertex]);
    for(Index k = 0; k < 3 && node.vertex == null_index; ++k)
      if(node.location.coordinates[(k + 2) % 3] == 0. && mesh.is_border_edge(3 * node.location.face + k))
        unite(i, n + c.border_loop[mesh.source(3 * node.location.face + k)]);
  }
  for(const Indexed_cut_locus::Edge& e : graph.edges)
    result.cycles += !unite(e.source, e.target);
  return result;
}

void expect_topology(const Indexed_triangle_mesh& mesh, const CGAL::Cut_loci::Mesh_connectivity& c,
                     const Indexed_cut_locus& graph)
{
  const Graph_numbers numbers = count(mesh, c, graph);
  EXPECT_EQ(numbers.components, 1u);
  EXPECT_EQ(numbers.cycles, 2 * c.genus(mesh));
}

TEST(Exact_tree, two_shortest_paths_lead_to_its_points_and_one_to_others)
{
  for(const Named_mesh& m : generic_meshes())
  {
    const Indexed_triangle_mesh mesh = indexed(m.data);
    Exact_tree_solver solver(mesh);
    int number = 0;
    for(const Indexed_source& source : sources(mesh))
    {
      SCOPED_TRACE(m.name + ", source " + std::to_string(number++));
      solve(solver, source);
      const Indexed_cut_locus graph = curve_of(solver);
      expect_topology(mesh, solver.connectivity(), graph);
      polyhedral_oracle::Polyhedral_oracle oracle(mesh, source.location);
      std::vector<int> degree(graph.nodes.size(), 0);
      for(const Indexed_cut_locus::Edge& e : graph.edges)
      {
        ++degree[e.source];
        ++degree[e.target];
      }
      std::mt19937 generator(1);
      for(int i = 0; i < 60 && !graph.edges.empty(); ++i)
      {
        const std::size_t k = generator() % graph.nodes.size();
        if(degree[k] < 2)
          continue; // a tip, or a point on the border
        const auto arrivals = oracle.shortest_arrivals(graph.nodes[k].location, 1e-8);
        EXPECT_GE(arrivals.size(), 2u) << "node " << k;
        EXPECT_NEAR(arrivals.front().distance, graph.nodes[k].distance, 1e-9);
      }
      std::uniform_real_distribution<double> uniform(0.05, 1.);
      for(int i = 0; i < 60; ++i)
      {
        Indexed_location location;
        location.face = static_cast<Index>(generator() % mesh.number_of_faces());
        location.coordinates = {{uniform(generator), uniform(generator), uniform(generator)}};
        const double sum = location.coordinates[0] + location.coordinates[1] + location.coordinates[2];
        for(double& c : location.coordinates)
          c /= sum;
        EXPECT_EQ(oracle.shortest_arrivals(location, 1e-13).size(), 1u);
      }
    }
  }
}

// The detour is measured on a mesh whose faces are split along the curve, rounded to 2^-16 of an edge.
TEST(Exact_tree, no_shortest_path_crosses_it)
{
  for(const Named_mesh& m : meshes())
  {
    SCOPED_TRACE(m.name);
    const Mesh mesh = to_surface_mesh(m.data);
    CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method()));
    for(int i : {0, 1, 2})
    {
      solver.set_source(Mesh::Vertex_index(Mesh::size_type(i * (mesh.number_of_vertices() - 1) / 2)));
      for(double width : {0., 0.02, 0.2})
      {
        const auto cut_locus =
          solver.cut_locus(params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method().minimum_branch_width(width)));
        const curve_measures::Measures measures = curve_measures::measure(mesh, cut_locus);
        EXPECT_EQ(measures.measuring_failed, "");
        EXPECT_LT(measures.max, 1e-3);
      }
    }
  }
}

// of all of the cut locus of some vertices
curve_measures::Measures measures_of(const Mesh& mesh, const std::vector<std::size_t>& sources)
{
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method()));
  std::vector<Mesh::Vertex_index> vertices;
  for(std::size_t v : sources)
    vertices.push_back(Mesh::Vertex_index(Mesh::size_type(v)));
  solver.set_sources(vertices);
  return curve_measures::measure(mesh, solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES)));
}

// The boundary of a shadow, and the branches on its both sides, meet in a point that is known to fewer digits than others.
TEST(Exact_tree, no_branch_leads_to_a_vertex_at_which_paths_bend)
{
  for(unsigned seed : {14u, 286u, 541u, 558u, 633u})
  {
    const Mesh mesh = to_surface_mesh(test_meshes::rough(test_meshes::square_with_holes(2, 1), 0.3, seed));
    for(std::size_t source = 0; source < mesh.number_of_vertices(); ++source)
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", source " << source);
      const curve_measures::Measures measures = measures_of(mesh, {source});
      EXPECT_EQ(measures.topology_fault, "");
      EXPECT_LT(measures.max, 1e-6);
    }
  }
}

// A bisector may cross a face twice, and the one of a path and another one that bends is so narrow that three paths are
// equally long on both of its sides.
TEST(Exact_tree, branches_between_two_images_go_on_in_one_direction)
{
  const std::vector<std::pair<test_meshes::Mesh_data, std::vector<std::size_t>>> cases = {
    {test_meshes::rough(test_meshes::torus(1., 0.4, 18, 12, 0.2, 52), 0.3, 52), {10, 82, 154}},
    {test_meshes::rough(test_meshes::torus(1., 0.4, 18, 12, 0.2, 65), 0.3, 65), {70, 142, 214}},
    {test_meshes::rough(test_meshes::torus(1., 0.4, 18, 12, 0.2, 72), 0.3, 72), {20, 92, 164}},
    {test_meshes::bumpy_sphere(6, 0.3, 53), {0, 120, 240}}};
  for(const auto& c : cases)
  {
    SCOPED_TRACE(testing::Message() << "sources " << c.second.front() << ", ...");
    const curve_measures::Measures measures = measures_of(to_surface_mesh(c.first), c.second);
    EXPECT_EQ(measures.topology_fault, "");
    EXPECT_LT(measures.max, 1e-6);
  }
}

// A branch starts nearly along an edge: rounding shows the paths of its other side at the end of the edge, too.
TEST(Exact_tree, branches_leave_a_vertex_on_one_side_of_an_edge)
{
  const Mesh mesh = to_surface_mesh(test_meshes::rough(test_meshes::square_with_holes(2, 1), 0.2, 375));
  for(const std::vector<std::size_t>& sources : {std::vector<std::size_t>{9, 27}, std::vector<std::size_t>{27, 9}})
  {
    const curve_measures::Measures measures = measures_of(mesh, sources);
    EXPECT_EQ(measures.topology_fault, "");
    EXPECT_LT(measures.max, 1e-6);
  }
}

TEST(Exact_tree, thresholds_cut_branches_from_their_tips)
{
  for(const Named_mesh& m : meshes())
  {
    SCOPED_TRACE(m.name);
    const Indexed_triangle_mesh mesh = indexed(m.data);
    Exact_tree_solver solver(mesh);
    solve(solver, at_vertex(mesh, 1));
    std::size_t more = curve_of(solver).edges.size();
    for(double gap : {0.01, 0.1, 0.5, 1., 3.})
    {
      const Indexed_cut_locus graph = curve_of(solver, gap, 0.);
      expect_topology(mesh, solver.connectivity(), graph);
      EXPECT_LE(graph.edges.size(), more);
      more = graph.edges.size();
    }
    more = curve_of(solver).edges.size();
    for(double width : {0.01, 0.1, 0.3, 1., 10.})
    {
      const Indexed_cut_locus graph = curve_of(solver, 0., width);
      expect_topology(mesh, solver.connectivity(), graph);
      EXPECT_LE(graph.edges.size(), more);
      more = graph.edges.size();
    }
  }
}

double length_of_tree(const Mesh_data& data, Index source)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  Exact_tree_solver solver(mesh);
  solve(solver, at_vertex(mesh, source));
  return length(mesh, curve_of(solver));
}

TEST(Exact_tree, is_that_of_the_surface_and_not_of_its_triangulation)
{
  for(const Named_mesh& m : {generic_meshes()[0], generic_meshes()[1], generic_meshes()[3]})
  {
    SCOPED_TRACE(m.name);
    // chords of curved pieces leave them by 1e-4 of an edge
    const double expected = length_of_tree(m.data, 1);
    EXPECT_NEAR(length_of_tree(test_meshes::split_in_plane(m.data), 1), expected, 1e-3 * expected);
    EXPECT_NEAR(length_of_tree(test_meshes::scaled(m.data, {{1000., 1000., 1000.}}), 1), 1000. * expected,
                1e-3 * expected);
  }
}

TEST(Exact_tree, touches_the_border_wherever_a_symmetric_source_is_moved_to)
{
  // A source at a corner is moved into a face, and what then leads to the corner is removed again: up to the border, if
  // that is where it comes from.
  for(int n : {1, 2})
  {
    test_meshes::Mesh_data data = test_meshes::cube(n);
    const auto is_in_window = [&](const test_meshes::Triangle& t)
    {
      return std::all_of(t.begin(), t.end(),
                         [&](std::size_t v) {
        return data.points[v][0] == 1. && data.points[v][1] <= 1. / n && data.points[v][2] <= 1. / n;
      });
    };
    data.triangles.erase(std::remove_if(data.triangles.begin(), data.triangles.end(), is_in_window),
                         data.triangles.end());
    const Indexed_triangle_mesh mesh = indexed(data);
    const CGAL::Cut_loci::Mesh_connectivity connectivity(mesh);
    Exact_tree_solver solver(mesh);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      Indexed_source source;
      source.vertex = mesh.source(h);
      source.location.face = h / 3;
      source.location.coordinates = {{0., 0., 0.}};
      source.location.coordinates[h % 3] = 1.;
      SCOPED_TRACE(testing::Message() << n << ", vertex " << source.vertex << ", face " << source.location.face);
      solve(solver, source);
      expect_topology(mesh, connectivity, curve_of(solver));
    }
  }
}

TEST(Exact_tree, gap_and_width_in_closed_form)
{
  // From the middle of a face of the unit cube the paths to the middle of the opposite one come over four faces. The two
  // that lead over faces beside each other part at a right angle, and are farthest apart at half of the way: there they
  // are in the middle of their faces.
  const Indexed_triangle_mesh mesh = indexed(test_meshes::cube(2));
  Index middle = null_index;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.points[v][0] == 0.5 && mesh.points[v][1] == 0.5 && mesh.points[v][2] == 0.)
      middle = v;
  ASSERT_NE(middle, null_index);
  Exact_tree_solver solver(mesh);
  solve(solver, at_vertex(mesh, middle));
  float gap = 0.f, width = 0.f;
  for(const Indexed_cut_locus::Edge& e : curve_of(solver).edges)
  {
    gap = (std::max)(gap, e.strength);
    width = (std::max)(width, e.width);
  }
  EXPECT_NEAR(gap, std::acos(0.), 1e-6);
  EXPECT_NEAR(width, std::sqrt(0.5), 1e-6);
}

TEST(Exact_tree, shows_the_widths_of_its_pieces)
{
  std::size_t number = 0, number_of_wrong = 0;
  for(const Named_mesh& m : generic_meshes())
  {
    const Indexed_triangle_mesh mesh = indexed(m.data);
    Exact_tree_solver solver(mesh);
    solve(solver, at_vertex(mesh, 0));
    curve_of(solver);
    for(const auto& branch : solver.tree().kept({}))
    {
      const double width = solver.tree().width(branch.edge), shown = solver.tree().shown_width(branch.edge);
      EXPECT_EQ(width > 0., shown > 0.) << m.name;
      ++number;
      number_of_wrong += std::abs(width - shown) > 0.01 * width;
    }
  }
  EXPECT_GT(number, 1000u);
  EXPECT_LT(number_of_wrong, number / 50);
}

TEST(Exact_tree, pieces_are_drawn_in_their_face)
{
  // One of the two images is that of a vertex from which paths go on nearly as those to the other image. An end of the
  // piece is at a corner of the face, the first one, and up to rounding as far from both: but rounding is enough to let
  // the bisector pass the corner at a distance, outside of the face.
  using CGAL::Cut_loci::internal::Image;
  using CGAL::Cut_loci::internal::Plane_point;
  const Image source{0.91906073109107966, -1.923670147648382, 0., 0, 0.},
    vertex{0.71048475685241064, -1.4605702944892047, 0.50790151898448155, 1, 0.};
  const Plane_point corner{0.057430603479329781, 0.}, apex{0.030278926750715321, 0.063427612463538438},
    end{0.052349884421626434, 0.011386366416637593};
  ASSERT_LT(std::abs(source.distance(corner) - vertex.distance(corner)), 1e-8);
  std::vector<Plane_point> points;
  CGAL::Cut_loci::internal::sample_bisector(source, vertex, corner, end, 1e-10, points);
  ASSERT_FALSE(points.empty());
  for(const Plane_point& p : points)
    EXPECT_GT((apex.x - corner.x) * (p.y - corner.y) - (apex.y - corner.y) * (p.x - corner.x), 0.);
}

TEST(Exact_tree, branches_closer_than_rounding_do_not_cross)
{
  // nearly flat bands of a cylinder, in which many branches run beside each other
  const Indexed_triangle_mesh mesh = indexed(test_meshes::cylinder(1., 12, 4, 1e-3, 5));
  Exact_tree_solver solver(mesh);
  for(Index source = 0; source < mesh.number_of_vertices(); source += 5)
  {
    solve(solver, at_vertex(mesh, source));
    const Indexed_cut_locus curve = curve_of(solver);
    EXPECT_EQ(curve_measures::internal::Curve_topology(mesh, curve).fault(), "") << "source " << source;
  }
}

// a plate with square holes in rows and columns, divided by lines along their sides and one beside each
test_meshes::Mesh_data plate_with_holes(int rows)
{
  std::vector<double> x = {0.};
  for(int i = 0; i < rows; ++i)
    for(double step : {1., 0.2, 0.3})
      x.push_back(x.back() + step);
  x.push_back(x.back() + 1.);
  const int n = static_cast<int>(x.size());
  const auto is_solid = [n](int i, int j)
  { return i >= 0 && j >= 0 && i < n - 1 && j < n - 1 && !(i % 3 == 2 && j % 3 == 2); };
  test_meshes::Mesh_data m;
  for(double a : x)
    for(double b : x)
      for(double height : {0., 1.})
        m.points.push_back({{a, b, height}});
  const auto at = [n](int i, int j, int k) { return static_cast<std::size_t>((i * n + j) * 2 + k); };
  const auto add = [&m](std::size_t a, std::size_t b, std::size_t c, std::size_t d)
  {
    m.triangles.push_back({{a, b, c}});
    m.triangles.push_back({{a, c, d}});
  };
  for(int i = 0; i < n - 1; ++i)
    for(int j = 0; j < n - 1; ++j)
    {
      if(!is_solid(i, j))
        continue;
      add(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
      add(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
      const auto wall = [&](int a, int b, int c, int d) { add(at(a, b, 0), at(c, d, 0), at(c, d, 1), at(a, b, 1)); };
      if(!is_solid(i - 1, j))
        wall(i, j + 1, i, j);
      if(!is_solid(i + 1, j))
        wall(i + 1, j, i + 1, j + 1);
      if(!is_solid(i, j - 1))
        wall(i, j, i + 1, j);
      if(!is_solid(i, j + 1))
        wall(i + 1, j + 1, i, j + 1);
    }
  return m;
}

// Sources are symmetric, and branches run along edges: what the topology adds there must not run along the same edges.
TEST(Exact_tree, of_a_plate_with_holes_leaves_a_disk)
{
  const Indexed_triangle_mesh mesh = indexed(plate_with_holes(4));
  Exact_tree_solver solver(mesh);
  for(Index source = 0; source < mesh.number_of_vertices(); source += 8)
  {
    solve(solver, at_vertex(mesh, source));
    const Indexed_cut_locus curve = curve_of(solver);
    EXPECT_EQ(curve_measures::internal::Curve_topology(mesh, curve).fault(), "") << "source " << source;
  }
}

TEST(Exact_tree, planar_positions)
{
  using CGAL::Cut_loci::internal::Plane_point;
  // two trees between the edges of a triangle; of the first one, a node is beyond the other tree
  std::vector<Plane_point> position = {{0.2, 0.}, {0.4, 0.}, {0., 0.3}, {0.7, 0.2}, {0.5, 0.}, {0., 0.5}};
  CGAL::Cut_loci::internal::move_to_planar_positions({{{0, 3}}, {{1, 3}}, {{2, 3}}, {{4, 5}}}, {1, 1, 1, 0, 1, 1},
                                                     position);
  EXPECT_NEAR(position[3].x, 0.2, 1e-9);
  EXPECT_NEAR(position[3].y, 0.1, 1e-9);
  EXPECT_EQ(position[4].x, 0.5);
}

TEST(Exact_tree, needs_the_exact_solver)
{
  const Mesh mesh = to_surface_mesh(test_meshes::cube(1));
  const auto method = params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method());
  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, method);
  std::vector<double> distances(mesh.number_of_vertices(), 1.);
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  EXPECT_THROW(solver.set_source(Mesh::Vertex_index(0), params::vertex_distance_map(map)),
               CGAL::Cut_loci::Invalid_input);
  solver.set_source(Mesh::Vertex_index(0));
  EXPECT_THROW(solver.cut_locus(params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method().minimum_branch_gap(-1.))),
               CGAL::Cut_loci::Invalid_input);
  EXPECT_THROW(solver.cut_locus(params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method().minimum_branch_gap(4.))),
               CGAL::Cut_loci::Invalid_input);
  EXPECT_THROW(
    solver.cut_locus(params::cut_locus_method(CGAL::Cut_loci::Polyhedral_method().minimum_branch_width(-1.))),
    CGAL::Cut_loci::Invalid_input);
}

} // namespace

} // namespace test_exact_tree
