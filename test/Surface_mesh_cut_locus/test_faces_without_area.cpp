// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Faces without area, caps and needles, are no part of the surface: with them it has the distances and the cut locus that
// it has without, up to the bound that the documentation states.

#include "surface_test.h"
#include "curve_topology.h"
#include "checked_curves.h"
#include "fuzz_surfaces.h"
#include "node_distances.h"
#include "Shortest_path_geodesic_solver.h"

#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Heat_method_geodesic_solver.h>
#include <CGAL/cut_along_cut_locus.h>
#include <CGAL/exact_geodesic_distances.h>
#include <CGAL/refine_along_cut_locus.h>

namespace test_faces_without_area {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using namespace surface_test;

// A vertex on an edge of one of its two faces, which becomes two; a face without area is between it and the other one.
void add_cap(Mesh_data& m, std::size_t face, std::size_t corner, double share)
{
  const std::size_t a = m.triangles[face][corner], b = m.triangles[face][(corner + 1) % 3],
                    c = m.triangles[face][(corner + 2) % 3], v = m.points.size();
  using test_meshes::operator*, test_meshes::operator+;
  m.points.push_back((1. - share) * m.points[a] + share * m.points[b]);
  m.triangles[face] = Triangle{{a, v, c}};
  m.triangles.push_back(Triangle{{v, b, c}});
  m.triangles.push_back(Triangle{{a, b, v}});
}

// The edge from corner `corner` of a face becomes two edges at the same place, with two faces in between that are needles
// of the width zero: a vertex at the same point as the start of the edge.
void add_needles(Mesh_data& m, std::size_t face, std::size_t corner)
{
  add_cap(m, face, corner, 0.);
}

Mesh_data with_flat_faces(Mesh_data m, std::size_t number, unsigned seed)
{
  std::mt19937 engine(seed);
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::size_t face = engine() % m.triangles.size(), corner = engine() % 3;
    const bool is_edge_long = m.points[m.triangles[face][corner]] != m.points[m.triangles[face][(corner + 1) % 3]];
    if(i % 2 == 0 || !is_edge_long)
      add_cap(m, face, corner, 0.5 + 0.4 * random_unit(engine));
    else
      add_needles(m, face, corner);
  }
  return m;
}

std::vector<double> distances(const Built& built, std::size_t source)
{
  std::vector<double> result(built.mesh.number_of_vertices());
  CGAL::exact_geodesic_distances(built.mesh, built.vertices[source], CGAL::make_property_map(result));
  return result;
}

std::vector<Mesh_data> clean_meshes()
{
  return {random_convex_polyhedron(40, 1), test_meshes::irregular_bumpy_sphere(5, 0.3, 2),
          torus(1., 0.4, 12, 8, 0.15, 5), test_meshes::cylinder(1., 12, 4, 0.1, 4)};
}

TEST(Faces_without_area, are_not_in_good_meshes_whose_results_stay_what_they_are)
{
  for(const Mesh_data& data : clean_meshes())
    EXPECT_FALSE(CGAL::Cut_loci::internal::needs_mollification(indexed(data)));
}

TEST(Faces_without_area, make_no_distance_shorter_and_none_longer_than_the_bound)
{
  for(const Mesh_data& data : clean_meshes())
  {
    const Built clean(data), flat(with_flat_faces(data, 12, 3));
    ASSERT_TRUE(CGAL::Cut_loci::internal::needs_mollification(indexed(flat.data)));
    const double gained = CGAL::Cut_loci::internal::Mollification(indexed(flat.data)).most_gained;
    EXPECT_LT(gained, 1e-5);
    const std::vector<double> expected = distances(clean, 0), found = distances(flat, 0);
    // a path crosses each flat face once at most, of which there are up to two for each that has been added
    const double most = 24. * gained;
    for(std::size_t v = 0; v < expected.size(); ++v)
    {
      EXPECT_GE(found[v], expected[v] - 1e-12);
      EXPECT_LE(found[v], expected[v] + most);
    }
  }
}

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const double l = CGAL::squared_distance(a, b);
  const double t = l > 0. ? (std::min)((std::max)(((p - a) * (b - a)) / l, 0.), 1.) : 0.;
  return std::sqrt(CGAL::squared_distance(p, a + t * (b - a)));
}

// the largest distance of a vertex of a curve to another curve
template <typename Result>
double distance(const Result& from, const Result& to)
{
  const auto &p = from.graph(), &q = to.graph();
  double result = 0.;
  for(const auto v : CGAL::make_range(vertices(p)))
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(const auto e : CGAL::make_range(edges(q)))
      least = (std::min)(least, distance_to_segment(p[v].point, q[source(e, q)].point, q[target(e, q)].point));
    result = (std::max)(result, least);
  }
  return result;
}

TEST(Faces_without_area, leave_the_cut_locus_where_it_is)
{
  for(const Mesh_data& data : clean_meshes())
  {
    const Built clean(data), flat(with_flat_faces(data, 8, 7));
    const auto curve = [](const Built& built, double width)
    { return compute_cut_locus(built.mesh, built.vertices[0], by(Polyhedral_method().minimum_branch_width(width))); };
    // what is wide in one is in the other, where a little less is asked for
    EXPECT_LT(distance(curve(clean, 0.12), curve(flat, 0.1)), 1e-4);
    EXPECT_LT(distance(curve(flat, 0.12), curve(clean, 0.1)), 1e-4);
  }
}

// Shortest paths lead on different ways to two vertices at the same point, and go on from both along one line.
TEST(Faces_without_area, at_which_paths_meet_leave_a_disk)
{
  namespace lib = CGAL::Cut_loci::internal;
  const Mesh_data clean = l_shape(1);
  for(std::size_t i = 0; i < 3 * clean.triangles.size(); ++i)
  {
    Mesh_data data = clean;
    add_needles(data, i / 3, i % 3);
    const Built built(data);
    const auto read = lib::read_triangle_mesh(built.mesh, get(CGAL::vertex_point, built.mesh));
    Solver solver(built.mesh, by(Polyhedral_method()));
    for(const auto v : built.mesh.vertices())
    {
      solver.set_source(v);
      const auto curve = solver.cut_locus(through_faces);
      const auto on = lib::on_component(read.mesh, lib::curve_on_mesh(read, built.mesh, curve));
      EXPECT_EQ(curve_measures::internal::Curve_topology(on.component.mesh, on.curve.graph).fault(), "")
        << "needles at corner " << i % 3 << " of face " << i / 3 << ", from " << v;
    }
  }
}

TEST(Faces_without_area, do_not_hide_the_order_of_the_branches_at_a_vertex)
{
  for(unsigned seed = 0; seed < 20; ++seed)
  {
    const Built built(with_flat_faces(torus(1., 0.4, 12, 8, 0.15, seed), 40, seed));
    Solver solver(built.mesh, params::geodesic_solver(CGAL::Heat_method_geodesic_solver<>()));
    solver.set_source(built.vertices[seed]);
    SCOPED_TRACE(seed);
    checked_curves::measured(built.mesh, solver.cut_locus());
  }
}

// Rounding may take the window that alone leads to a vertex, where the path to it grazes another one.
TEST(Faces_without_area, hide_no_vertex_behind_another_one)
{
  for(const auto& [seed, source] : {std::pair<unsigned, std::size_t>{64, 38}, {142, 37}, {164, 41}, {195, 34}})
  {
    Mesh_data data = test_meshes::plate_with_holes(1, 1, 1);
    for(auto& p : data.points)
      p = {{7.7 * p[0], 22.17 * p[1], 0.25 * p[2]}};
    std::mt19937 engine(seed);
    for(int i = 0; i < 12; ++i)
    {
      const std::size_t face = engine() % data.triangles.size(), corner = engine() % 3;
      if(data.points[data.triangles[face][corner]] != data.points[data.triangles[face][(corner + 1) % 3]])
        add_needles(data, face, corner);
    }
    const Built built(data);
    SCOPED_TRACE(seed);
    checked_curves::measured(built.mesh, compute_cut_locus(built.mesh, built.vertices[source], through_faces));
  }
}

// A point of face `f` beside one of its corners or edges, by a share of it: three faces, of which two or one are thin.
void add_beside(Mesh_data& m, std::size_t f, double share, std::mt19937& engine)
{
  using test_meshes::operator*, test_meshes::operator+;
  const Triangle t = m.triangles[f];
  const double along = engine() % 2 == 0 ? 0. : random_unit(engine); // of the first edge
  const double a = (1. - share) * (1. - along) + 0.2 * share, b = (1. - share) * along + 0.3 * share;
  const std::size_t v = m.points.size();
  m.points.push_back(a * m.points[t[0]] + b * m.points[t[1]] + (1. - a - b) * m.points[t[2]]);
  m.triangles[f] = {{t[0], t[1], v}};
  m.triangles.push_back({{t[1], t[2], v}});
  m.triangles.push_back({{t[2], t[0], v}});
}

// Where rounding decides, a branch may be led astray: seldom.
TEST(Faces_without_area, or_nearly_so_block_hardly_a_path)
{
  int runs = 0, right = 0;
  for(unsigned seed = 0; seed < 60; ++seed)
  {
    std::mt19937 engine(seed);
    Mesh_data data = seed % 2 == 0 ? random_convex_polyhedron(6 + seed % 9, seed)
                                   : torus(1., 0.4, 3 + seed % 5, 3 + seed % 3, 0.1, seed);
    const double share = std::pow(10., -9.5 - 3. * random_unit(engine));
    const std::size_t faces = data.triangles.size(), first = engine() % faces;
    for(std::size_t i = 0; i < 1 + seed % 5; ++i)
      add_beside(data, (first + i) % faces, share, engine);
    const Built built(data);
    for(const Method method : {Method(Default_method()), Method(Polyhedral_method())})
    {
      const auto curve = compute_cut_locus(built.mesh, built.vertices[engine() % built.vertices.size()],
                                           through_faces.cut_locus_method(method));
      const auto measures = curve_measures::measure(built.mesh, curve);
      EXPECT_EQ(measures.measuring_failed, "") << "seed " << seed;
      // also where labels alone tell what is drawn
      EXPECT_LT(curve_measures::node_distance_errors(built.mesh, curve).max, 1e-6) << "seed " << seed;
      ++runs;
      right += measures.topology_fault.empty() && measures.max < 1e-4;
    }
  }
  EXPECT_GE(right, 0.9 * runs);
}

// Rays that bound windows are inexact behind such a face, and leave gaps between windows.
TEST(Faces_without_area, or_nearly_so_hide_no_place_from_queries)
{
  std::vector<unsigned> seeds = {417,  1201,  3322,  4239,  5059,  9007,
                                 9439, 10418, 11520, 12179, 12376, 14637}; // had gaps
  for(unsigned seed = 0; seed < 300; ++seed)
    seeds.push_back(seed);
  for(const unsigned seed : seeds)
  {
    fuzz_surfaces::Random random(seed);
    fuzz_surfaces::Surface surface = fuzz_surfaces::surface(random);
    fuzz_surfaces::add_thin_faces(surface, random);
    const Built built({surface.points, {surface.faces.begin(), surface.faces.end()}});
    const auto curve =
      compute_cut_locus(built.mesh, built.vertices[random.below(built.vertices.size())], by(Polyhedral_method()));
    EXPECT_LT(curve_measures::node_distance_errors(built.mesh, curve).max, 5e-5) << "seed " << seed;
  }
}

// Returns the distances of the solver.
template <typename GeodesicSolver>
std::vector<double> laplacian_by(const Built& built, const GeodesicSolver& geodesic_solver)
{
  Solver solver(built.mesh, by(Laplacian_method()).geodesic_solver(geodesic_solver));
  solver.set_source(built.vertices[0]);
  const auto edges = solver.cut_locus(mesh_edges);
  EXPECT_EQ(fault_of(built, edges, 0, {0}, Laplacian_method()), "");
  const auto straight = solver.cut_locus(through_faces);
  for(const auto v : CGAL::make_range(vertices(straight.graph())))
    EXPECT_TRUE(std::isfinite(straight.graph()[v].point.x()) && std::isfinite(straight.graph()[v].distance));
  std::vector<double> result;
  for(const auto v : built.vertices)
    result.push_back(edges.distance(v));
  return result;
}

TEST(Faces_without_area, are_taken_by_laplacian_with_any_distances)
{
  for(const Mesh_data& data : clean_meshes())
    for(unsigned seed = 1; seed <= 3; ++seed)
    {
      const Built flat(with_flat_faces(data, 12, seed));
      const std::vector<double> exact = distances(flat, 0);
      const double h = mean_edge_length(data);
      const std::vector<double> by_exact = laplacian_by(flat, CGAL::Exact_geodesic_solver()),
                                by_graph = laplacian_by(flat, CGAL::Graph_geodesic_solver());
      for(std::size_t v = 0; v < exact.size(); ++v)
      {
        EXPECT_NEAR(by_exact[v], exact[v], 1e-12);
        EXPECT_NEAR(by_graph[v], exact[v], 0.3 * h); // straightened ways, measured: 0.22 at most
      }
    }
}

// CGAL's classes take points: they are given the surface without these faces.
TEST(Faces_without_area, are_taken_by_solvers_of_CGAL)
{
  for(const Mesh_data& data : clean_meshes())
    for(std::size_t number : {1, 2, 12, 40})
    {
      const Built flat(with_flat_faces(data, number, 3));
      const std::vector<double> exact = distances(flat, 0);
      const double h = mean_edge_length(data), far = *std::max_element(exact.begin(), exact.end());
      const std::vector<double> by_cgal = laplacian_by(flat, CGAL::Shortest_path_geodesic_solver()),
                                by_heat = laplacian_by(flat, CGAL::Heat_method_geodesic_solver()),
                                by_direct =
                                  laplacian_by(flat, CGAL::Heat_method_geodesic_solver<CGAL::Heat_method_3::Direct>());
      for(std::size_t v = 0; v < exact.size(); ++v)
      {
        EXPECT_NEAR(by_cgal[v], exact[v], 1e-4 * h); // others measure these faces by other lengths
        EXPECT_NEAR(by_heat[v], exact[v], h + 0.2 * far);
        EXPECT_NEAR(by_direct[v], exact[v], h + 0.2 * far);
      }
    }
}

// from a point in such a face, too
TEST(Faces_without_area, hold_sources_of_solvers_of_CGAL)
{
  for(const Mesh_data& data : clean_meshes())
  {
    const Built flat(with_flat_faces(data, 12, 5));
    const double h = mean_edge_length(data);
    for(std::size_t f : {data.triangles.size() + 1, flat.data.triangles.size() - 1})
    {
      const auto face = Mesh::Face_index(static_cast<Mesh::size_type>(f));
      Solver exact(flat.mesh), by_cgal(flat.mesh, params::geodesic_solver(CGAL::Shortest_path_geodesic_solver()));
      const std::pair<Mesh::Face_index, std::array<double, 3>> source(face, {{0.3, 0.3, 0.4}});
      exact.set_source(source);
      by_cgal.set_source(source);
      const auto expected = exact.cut_locus(), found = by_cgal.cut_locus();
      for(const auto v : flat.vertices)
        EXPECT_NEAR(found.distance(v), expected.distance(v), 1e-4 * h);
    }
  }
}

TEST(Faces_without_area, can_be_cut_and_refined_along_a_cut_locus)
{
  const Built flat(with_flat_faces(torus(1., 0.4, 12, 8, 0.15, 5), 8, 7));
  const auto edges = compute_cut_locus(flat.mesh, flat.vertices[0], mesh_edges);
  EXPECT_EQ(fault_of(flat, edges, 0, {0}, Default_method()), "");
  Mesh disk;
  CGAL::cut_along_cut_locus(flat.mesh, edges, disk);
  EXPECT_EQ(disk.number_of_vertices() + disk.number_of_faces(), disk.number_of_edges() + 1);
  const auto curve = compute_cut_locus(flat.mesh, flat.vertices[0], through_faces);
  Mesh refined, straight_disk;
  CGAL::refine_along_cut_locus(flat.mesh, curve, refined);
  EXPECT_EQ(refined.number_of_vertices() + refined.number_of_faces(), refined.number_of_edges());
  CGAL::cut_along_cut_locus(flat.mesh, curve, straight_disk);
  EXPECT_EQ(straight_disk.number_of_vertices() + straight_disk.number_of_faces(), straight_disk.number_of_edges() + 1);
}

} // namespace

} // namespace test_faces_without_area
