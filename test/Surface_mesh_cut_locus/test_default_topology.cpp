// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The topology of the direction method's results, on meshes chosen to break it.

#include "surface_test.h"
#include "default_results.h"

#include <CGAL/Cut_loci/geodesics/geodesic_path_tracing.h>

namespace test_default_topology {

namespace {

using namespace default_test;
using namespace surface_test;

void check_all_kinds_of_sources(const Mesh_data& data, const std::string& name)
{
  const Indexed_triangle_mesh mesh = indexed(data);
  expect_invariants(mesh, at_vertex(mesh, 0), name + ", vertex");
  expect_invariants(mesh, at_vertex(mesh, mesh.number_of_vertices() / 2), name + ", another vertex");
  const Index f = mesh.number_of_faces() / 3;
  expect_invariants(mesh, in_face(f, 0.5, 0.3, 0.2), name + ", face");
  expect_invariants(mesh, in_face(f, 0.4, 0.6, 0.), name + ", edge");
  expect_invariants(mesh, in_face(f, 1. - 2e-6, 1e-6, 1e-6), name + ", near a vertex");
}

TEST(Default_topology, flat_polyhedra)
{
  for(int n : {1, 2, 5})
  {
    check_all_kinds_of_sources(cube(n, Diagonals::PARALLEL), "cube " + std::to_string(n));
    check_all_kinds_of_sources(cuboid({{3., 1., 0.4}}, n, Diagonals::PARALLEL), "box " + std::to_string(n));
  }
  const double s = std::sqrt(3.);
  check_all_kinds_of_sources(Mesh_data{{{{1., 0., 0.}}, {{-0.5, s / 2., 0.}}, {{-0.5, -s / 2., 0.}}, {{0., 0., 1.4}}},
                                       {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}},
                             "tetrahedron");
  check_all_kinds_of_sources(revolution(3, {{{0., 0.}}, {{1., 0.}}, {{1., 2.}}, {{0., 2.}}}), "prism");
}

TEST(Default_topology, genus)
{
  for(int holes : {1, 2, 3})
    for(int n : {1, 2, 4})
      check_all_kinds_of_sources(plate_with_holes(holes, 1, n, Diagonals::PARALLEL),
                                 "plate with " + std::to_string(holes) + " holes");
  check_all_kinds_of_sources(torus(1., 0.4, 40, 16), "torus");
  check_all_kinds_of_sources(torus(1., 0.4, 3, 3), "torus of 18 faces");
}

TEST(Default_topology, symmetry)
{
  // All is a tie: circles of equally good points, and a sphere whose cut locus is one point.
  check_all_kinds_of_sources(sphere_of_squares(8), "sphere");
  std::vector<std::array<double, 2>> cylinder = {{{0., 0.}}, {{0.5, 0.}}, {{1., 0.}}};
  for(int i = 1; i <= 10; ++i)
    cylinder.push_back({{1., 0.4 * i}});
  cylinder.insert(cylinder.end(), {{{0.5, 4.}}, {{0., 4.}}});
  check_all_kinds_of_sources(revolution(16, cylinder), "cylinder with caps");
  std::vector<std::array<double, 2>> limb = {{{0., 0.}}};
  for(int i = 0; i <= 60; ++i)
    limb.push_back({{i < 10 ? 1. : 0.04, 0.1 * (i + 1)}});
  limb.push_back({{0., 6.2}});
  check_all_kinds_of_sources(revolution(12, limb), "thin limb");
}

TEST(Default_topology, bad_shapes)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> random(-1., 1.);
  Mesh_data needles = torus(1., 0.4, 60, 24);
  for(auto& p : needles.points)
    p[2] *= 30.;
  check_all_kinds_of_sources(needles, "needles");
  Mesh_data rough = torus(1., 0.4, 30, 12);
  for(auto& p : rough.points)
    for(double& x : p)
      x += 0.08 * random(generator);
  check_all_kinds_of_sources(rough, "saddles everywhere");
  Mesh_data crumpled = sphere_of_squares(6);
  for(auto& p : crumpled.points)
  {
    const double s = 1. + 0.4 * random(generator);
    for(double& x : p)
      x *= s;
  }
  check_all_kinds_of_sources(crumpled, "crumpled sphere");
}

TEST(Default_topology, boundary)
{
  const Mesh_data ball = sphere_of_squares(8);
  const Mesh_data cap = without_ball(ball, {{0., 0., 1.}}, 0.5);
  check_all_kinds_of_sources(cap, "sphere with a hole");
  const Mesh_data band_data = without_ball(without_ball(cap, {{0., 0., -1.}}, 0.5), {{1., 0., 0.}}, 0.4);
  check_all_kinds_of_sources(band_data, "sphere with three holes");
  const Indexed_triangle_mesh band = indexed(band_data);
  for(Index v = 0; v < band.number_of_vertices(); v += 37)
    expect_invariants(band, at_vertex(band, v), "sphere with three holes");
  check_all_kinds_of_sources(without_ball(torus(1., 0.4, 40, 16), {{1.4, 0., 0.}}, 0.3), "torus with a hole");
  check_all_kinds_of_sources(without_ball(plate_with_holes(2, 1, 4, Diagonals::PARALLEL), {{0., 0., 0.5}}, 0.3),
                             "plate with a hole at a corner");
  check_all_kinds_of_sources(revolution(20, {{{0.3, 0.}}, {{0.6, 0.}}, {{1., 0.}}, {{1.4, 0.}}}), "flat annulus");
  check_all_kinds_of_sources(revolution(20, {{{0., 0.}}, {{0.6, 0.}}, {{1., 0.}}, {{1.4, 0.}}}), "flat disk");
  expect_invariants(indexed(Mesh_data{{{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}}, {{{0, 1, 2}}}}),
                    in_face(0, 0.3, 0.3, 0.4), "one triangle");
}

// The number of vertices that lie on the other side of the cycles than their shortest path, up to crossings within three
// edges of the vertex.
int paths_across_cycles(const Indexed_triangle_mesh& mesh, const Indexed_source& source)
{
  using namespace CGAL::Cut_loci::internal;
  const Solved solved(mesh, source);
  const Indexed_cut_locus cycles = solved.curve(at_least(1e9, solved), Curve::MESH_EDGES);
  std::set<std::pair<Index, Index>> cut;
  for(const auto& e : cycles.edges)
    cut.insert(std::minmax(cycles.nodes[e.source].vertex, cycles.nodes[e.target].vertex));
  Exact_geodesic_propagation geodesics(mesh);
  geodesics.run({source.location}, Exact_geodesic_options());
  Geodesic_path_tracing paths(geodesics);
  int result = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    bool is_across = false;
    double length = 0.;
    std::array<double, 3> last = mesh.points[v];
    for(const auto& place : paths.path_from_query(geodesics.at_vertex(v)))
    {
      const std::array<double, 3> point = position(mesh, place);
      length += norm(point - last);
      last = point;
      const auto is_zero = [](double x) { return x < 1e-6; };
      const auto& t = place.coordinates;
      if(std::count_if(t.begin(), t.end(), is_zero) != 1)
        continue;
      const std::size_t i = std::find_if(t.begin(), t.end(), is_zero) - t.begin();
      const auto& corners = mesh.triangles[place.face];
      if(length > 3. * solved.solver->connectivity().mean_edge_length &&
         cut.count(std::minmax(corners[(i + 1) % 3], corners[(i + 2) % 3])) != 0)
        is_across = !is_across;
    }
    result += is_across;
  }
  return result;
}

TEST(Default_topology, shortest_paths_do_not_cross_the_cycles)
{
  // Behind a hole, the paths around it bend at the same corners, so that their directions at the source hardly differ.
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> random(-0.2, 0.2);
  for(int spacing : {2, 3})
    for(int n : {1, 2, 3})
    {
      std::set<std::array<int, 3>> cells;
      for(int i = 0; i < 9; ++i)
        for(int j = 0; j < 9; ++j)
          if(i % spacing != 1 || j % spacing != 1)
            cells.insert({{i, j, 0}});
      Indexed_triangle_mesh plate = indexed(voxel_surface(cells, n, Diagonals::PARALLEL));
      for(auto& p : plate.points)
        for(double& x : p)
          x += random(generator) / n; // no ties
      const Index step = plate.number_of_vertices() / 8;
      int across = 0, all = 0;
      for(Index v = 0; v < plate.number_of_vertices(); v += step)
      {
        across += paths_across_cycles(plate, at_vertex(plate, v));
        all += static_cast<int>(plate.number_of_vertices());
      }
      EXPECT_LT(across, 0.05 * all) << spacing << ", " << n; // not zero: edges of the mesh zigzag around the cycles
    }
}

TEST(Default_topology, sphere_is_cut_at_a_point)
{
  const Indexed_triangle_mesh ball = indexed(sphere_of_squares(20));
  const Index v = static_cast<Index>(nearest_vertex(ball.points, {{0., 0., 1.}}));
  const Solved solved(ball, at_vertex(ball, v));
  const double h = solved.solver->connectivity().mean_edge_length;
  for(const auto& node : solved.through_faces().nodes)
  {
    using namespace CGAL::Cut_loci::internal;
    EXPECT_LT(norm(position(ball, node.location) + ball.points[v]), 3. * h);
  }
}

} // namespace

} // namespace test_default_topology
