// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut locus of polyhedra of any kind: with saddles, handles, borders and flat parts, from any source. What is on it
// is told by an oracle that unfolds the surface on its own.

#include "surface_test.h"
#include "default_results.h"
#include "polyhedral_oracle.h"

namespace test_exact_tree {

namespace {

using namespace surface_test;
using namespace default_test;
using checked_curves::measured;

Indexed_cut_locus curve_of(const Solved& solved, double gap = 0., double width = 0.)
{
  Solved::Thresholds thresholds;
  thresholds.gap = gap;
  thresholds.width = width;
  return solved.curve(thresholds, Curve::THROUGH_FACES);
}

// in no symmetric position
std::vector<Named_mesh> generic_meshes()
{
  return {{"convex", random_convex_polyhedron(60, 1)},
          {"flat convex", random_convex_polyhedron(50, 2, {{1., 0.8, 0.1}})},
          {"nonconvex", irregular_bumpy_sphere(6, 0.3, 2)},
          {"torus", torus(1., 0.4, 14, 9, 0.1, 5)},
          {"jittered torus", torus(1., 0.4, 16, 10, 0.15, 5)},
          {"saddle", saddle(8, 0.7, 0.2, 3)},
          {"open cylinder", cylinder(1., 12, 4, 0.1, 4)},
          {"finer open cylinder", cylinder(1., 14, 5, 0.1, 4)},
          {"rough torus", torus(1., 0.5, 20, 12, 0.3, 7)}};
}

// with all that CAD models have: flat parts, edges in a line, ties
std::vector<Named_mesh> meshes()
{
  return {{"convex", random_convex_polyhedron(60, 1)},
          {"flat convex", random_convex_polyhedron(50, 2, {{1., 0.8, 0.1}})},
          {"cube", cube(2)},
          {"cuboid", cuboid({{3., 1., 0.4}}, 2)},
          {"L-shape", l_shape(2)},
          {"torus", torus(1., 0.4, 14, 9, 0.1, 5)},
          {"plate of genus 3", plate_with_holes(3, 1, 1)},
          {"square with holes", square_with_holes(2, 2)},
          {"saddle", saddle(8, 0.7, 0.2, 3)},
          {"annulus", annulus(0.4, 1., 16, 3)},
          {"open cylinder", cylinder(1., 12, 4, 0.1, 4)}};
}

// two vertices, a border vertex if there is one, a point of an edge and one in a face
std::vector<Indexed_source> sources(const Indexed_triangle_mesh& mesh)
{
  std::vector<Indexed_source> result = {
    at_vertex(mesh, mesh.number_of_vertices() / 3), at_vertex(mesh, mesh.number_of_vertices() / 2),
    in_face(mesh.number_of_faces() / 2, 0.5, 0.2, 0.3), in_face(mesh.number_of_faces() / 5, 0.37, 0.63, 0.)};
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.is_border_edge(h))
    {
      result.push_back(at_vertex(mesh, mesh.source(h)));
      break;
    }
  return result;
}

TEST(Exact_tree, two_shortest_paths_lead_to_its_points_and_one_to_others)
{
  int number_of_nodes = 0;
  for(const Named_mesh& m : generic_meshes())
  {
    const Indexed_triangle_mesh mesh = indexed(m.data);
    int number = 0;
    for(const Indexed_source& source : sources(mesh))
    {
      SCOPED_TRACE(m.name + ", source " + std::to_string(number++));
      const Indexed_cut_locus graph = Solved(mesh, source, Branch_strength()).all();
      expect_disk(mesh, graph);
      const polyhedral_oracle::Polyhedral_oracle oracle(mesh, source.location);
      std::vector<int> degree(graph.nodes.size(), 0);
      for(const Indexed_cut_locus::Edge& e : graph.edges)
        for(Index i : {e.source, e.target})
          ++degree[i];
      std::vector<std::size_t> inner; // tips and points on the border have one path
      for(std::size_t i = 0; i < degree.size(); ++i)
        if(degree[i] > 1)
          inner.push_back(i);

      std::mt19937 generator(1);
      constexpr double rounding = 1e-9;
      for(int i = 0; i < 75; ++i)
      {
        EXPECT_EQ(oracle.shortest_arrivals(random_location(mesh, generator), rounding).size(), 1u);
        if(inner.empty())
          continue; // a saddle has no cut locus from some of its points
        const Indexed_cut_locus::Node& node = graph.nodes[inner[generator() % inner.size()]];
        const auto arrivals = oracle.shortest_arrivals(node.location, rounding);
        EXPECT_GE(arrivals.size(), 2u);
        EXPECT_NEAR(arrivals.front().distance, node.distance, rounding);
        ++number_of_nodes;
      }
    }
  }
  EXPECT_GT(number_of_nodes, 2000);
}

// The detour is measured on a mesh whose faces are split along the curve, rounded to 2^-16 of an edge.
TEST(Exact_tree, no_shortest_path_crosses_it)
{
  for(const Named_mesh& m : meshes())
  {
    SCOPED_TRACE(m.name);
    const Mesh mesh = to_surface_mesh(m.data);
    Solver solver(mesh, by(Polyhedral_method()));
    for(int i : {0, 1, 2})
    {
      solver.set_source(Mesh::Vertex_index(Mesh::size_type(i * (mesh.number_of_vertices() - 1) / 2)));
      for(double width : {0., 0.02, 0.2})
      {
        const auto cut_locus = solver.cut_locus(by(Polyhedral_method().minimum_branch_width(width)));
        EXPECT_LT(measured(mesh, cut_locus).max, 1e-3);
      }
    }
  }
}

// all of the cut locus of some vertices has no detour
void expect_no_detour(const Mesh& mesh, const std::vector<std::size_t>& sources)
{
  SCOPED_TRACE("source " + std::to_string(sources.front()));
  Solver solver(mesh, by(Polyhedral_method()));
  Vertices vertices;
  for(std::size_t v : sources)
    vertices.push_back(Mesh::Vertex_index(Mesh::size_type(v)));
  solver.set_sources(vertices);
  EXPECT_LT(measured(mesh, solver.cut_locus(through_faces)).max, 1e-6);
}

// The boundary of a shadow, and the branches on its both sides, meet in a point that is known to fewer digits than others.
TEST(Exact_tree, no_branch_leads_to_a_vertex_at_which_paths_bend)
{
  for(unsigned seed : {14u, 286u, 541u, 558u, 633u})
  {
    const Mesh mesh = to_surface_mesh(rough(square_with_holes(2, 1), 0.3, seed));
    SCOPED_TRACE(seed);
    for(std::size_t source = 0; source < mesh.number_of_vertices(); ++source)
      expect_no_detour(mesh, {source});
  }
}

// A bisector may cross a face twice, and the one of a path and another one that bends is so narrow that three paths are
// equally long on both of its sides.
TEST(Exact_tree, branches_between_two_images_go_on_in_one_direction)
{
  const std::vector<std::pair<Mesh_data, std::vector<std::size_t>>> cases = {
    {rough(torus(1., 0.4, 18, 12, 0.2, 52), 0.3, 52), {10, 82, 154}},
    {rough(torus(1., 0.4, 18, 12, 0.2, 65), 0.3, 65), {70, 142, 214}},
    {rough(torus(1., 0.4, 18, 12, 0.2, 72), 0.3, 72), {20, 92, 164}},
    {bumpy_sphere(6, 0.3, 53), {0, 120, 240}}};
  for(const auto& c : cases)
    expect_no_detour(to_surface_mesh(c.first), c.second);
}

// A branch starts nearly along an edge: rounding shows the paths of its other side at the end of the edge, too.
TEST(Exact_tree, branches_leave_a_vertex_on_one_side_of_an_edge)
{
  const Mesh mesh = to_surface_mesh(rough(square_with_holes(2, 1), 0.2, 375));
  expect_no_detour(mesh, {9, 27});
  expect_no_detour(mesh, {27, 9});
}

TEST(Exact_tree, thresholds_cut_branches_from_their_tips)
{
  for(const Named_mesh& m : meshes())
  {
    SCOPED_TRACE(m.name);
    const Indexed_triangle_mesh mesh = indexed(m.data);
    const Solved solved(mesh, at_vertex(mesh, 1), Branch_strength());
    const auto expect_less_and_less = [&](const std::vector<std::pair<double, double>>& thresholds)
    {
      std::size_t more = solved.all().edges.size();
      for(const auto& [gap, width] : thresholds)
      {
        const Indexed_cut_locus graph = curve_of(solved, gap, width);
        expect_disk(mesh, graph);
        EXPECT_LE(graph.edges.size(), more);
        more = graph.edges.size();
      }
    };
    expect_less_and_less({{0.01, 0.}, {0.1, 0.}, {0.5, 0.}, {1., 0.}, {3., 0.}});
    expect_less_and_less({{0., 0.01}, {0., 0.1}, {0., 0.3}, {0., 1.}, {0., 10.}});
  }
}

double length_of_tree(const Mesh_data& data, Index source)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  return length(mesh, Solved(mesh, at_vertex(mesh, source), Branch_strength()).all());
}

TEST(Exact_tree, touches_the_border_on_a_symmetric_surface)
{
  for(int n : {1, 2})
  {
    Mesh_data data = cube(n);
    const auto is_in_window = [&](const Triangle& t)
    {
      return std::all_of(t.begin(), t.end(),
                         [&](std::size_t v) {
        return data.points[v][0] == 1. && data.points[v][1] <= 1. / n && data.points[v][2] <= 1. / n;
      });
    };
    data.triangles.erase(std::remove_if(data.triangles.begin(), data.triangles.end(), is_in_window),
                         data.triangles.end());
    const Indexed_triangle_mesh mesh = indexed(data);
    Solved solved(mesh, at_vertex(mesh, 0), Branch_strength());
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      Indexed_source source;
      source.vertex = mesh.source(h);
      source.location.face = h / 3;
      source.location.coordinates = {{0., 0., 0.}};
      source.location.coordinates[h % 3] = 1.;
      SCOPED_TRACE(testing::Message() << n << ", vertex " << source.vertex << ", face " << source.location.face);
      solved.solve(source);
      expect_disk(mesh, solved.all());
    }
  }
}

TEST(Exact_tree, gap_and_width_in_closed_form)
{
  // From the middle of a face of the unit cube the paths to the middle of the opposite one come over four faces. The two
  // that lead over faces beside each other part at a right angle, and are farthest apart at half of the way: there they
  // are in the middle of their faces.
  const Indexed_triangle_mesh mesh = indexed(cube(2));
  const auto middle = static_cast<Index>(nearest_vertex(mesh.points, {{0.5, 0.5, 0.}}));
  const Solved solved(mesh, at_vertex(mesh, middle), Branch_strength());
  float gap = 0.f, width = 0.f;
  for(const Indexed_cut_locus::Edge& e : solved.all().edges)
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
    Solved solved(mesh, at_vertex(mesh, 0), Branch_strength());
    solved.all();
    auto& tree = solved.solver->tree();
    for(const auto& branch : tree.kept({}))
    {
      const double width = tree.width(branch.edge), shown = tree.shown_width(branch.edge);
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

void expect_disks(const Mesh_data& data, Index step)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  Solved solved(mesh, at_vertex(mesh, 0), Branch_strength());
  for(Index source = 0; source < mesh.number_of_vertices(); source += step)
  {
    SCOPED_TRACE(source);
    solved.solve(at_vertex(mesh, source));
    expect_disk(mesh, solved.all());
  }
}

// nearly flat bands of a cylinder, in which many branches run beside each other
TEST(Exact_tree, branches_closer_than_rounding_do_not_cross)
{
  expect_disks(cylinder(1., 12, 4, 1e-3, 5), 5);
}

// a plate with square holes in rows and columns, divided by lines along their sides and one beside each
Mesh_data plate_with_holes(int rows)
{
  std::vector<double> x = {0.};
  for(int i = 0; i < rows; ++i)
    for(double step : {1., 0.2, 0.3})
      x.push_back(x.back() + step);
  x.push_back(x.back() + 1.);
  const int n = static_cast<int>(x.size());
  const auto is_solid = [n](int i, int j)
  { return i >= 0 && j >= 0 && i < n - 1 && j < n - 1 && !(i % 3 == 2 && j % 3 == 2); };
  Mesh_data m;
  for(double a : x)
    for(double b : x)
      for(double height : {0., 1.})
        m.points.push_back({{a, b, height}});
  const auto at = [n](int i, int j, int k) { return static_cast<std::size_t>((i * n + j) * 2 + k); };
  for(int i = 0; i < n - 1; ++i)
    for(int j = 0; j < n - 1; ++j)
    {
      if(!is_solid(i, j))
        continue;
      add_square(m, {{at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)}});
      add_square(m, {{at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)}});
      const auto wall = [&](int a, int b, int c, int d) {
        add_square(m, {{at(a, b, 0), at(c, d, 0), at(c, d, 1), at(a, b, 1)}});
      };
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
  expect_disks(plate_with_holes(4), 8);
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
  const Mesh mesh = to_surface_mesh(cube(1));
  Solver solver(mesh, by(Polyhedral_method()));
  std::vector<double> distances(mesh.number_of_vertices(), 1.);
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  EXPECT_THROW(solver.set_source(Mesh::Vertex_index(0), params::vertex_distance_map(map)), Invalid_input);
  solver.set_source(Mesh::Vertex_index(0));
  for(const Polyhedral_method& wrong :
      {Polyhedral_method().minimum_branch_gap(-1.), Polyhedral_method().minimum_branch_gap(4.),
       Polyhedral_method().minimum_branch_width(-1.)})
    EXPECT_THROW(solver.cut_locus(by(wrong)), Invalid_input);
}

} // namespace

} // namespace test_exact_tree
