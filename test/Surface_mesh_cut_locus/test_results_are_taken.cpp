// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What compute_cut_locus() takes, every function on its result takes: the surface is cut open to a disk and refined along
// the curve where it covers parts of edges, where components touch in a vertex, and on doubly covered triangles.

#include "surface_test.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/cut_along_cut_locus.h>
#include <CGAL/refine_along_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

namespace test_results_are_taken {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using namespace surface_test;

bool is_disk(const Mesh& mesh)
{
  std::size_t border = 0;
  for(const auto h : mesh.halfedges())
    border += mesh.is_border(h);
  return CGAL::is_valid_polygon_mesh(mesh) && border > 0 &&
         mesh.number_of_vertices() + mesh.number_of_faces() == mesh.number_of_edges() + 1;
}

// Calls all functions on a curve through the faces; returns what is wrong, or an empty string.
template <typename Result>
std::string fault_of_functions(const Mesh& mesh, const Result& result, double area_of_component)
{
  Mesh refined, disk;
  CGAL::refine_along_cut_locus(mesh, result, refined);
  if(std::fabs(PMP::area(refined) - PMP::area(mesh)) > 0.01 * PMP::area(mesh))
    return "refining has changed the area";
  CGAL::cut_along_cut_locus(mesh, result, disk);
  if(!is_disk(disk))
    return "what is cut along the curve is no disk";
  if(std::fabs(PMP::area(disk) - area_of_component) > 0.01 * area_of_component)
    return "cutting has changed the area";
  if(CGAL::Cut_loci::compute_statistics(result).components != 1)
    return "the curve is not connected";
  if(!(CGAL::Cut_loci::injectivity_radius(result).distance > 0.))
    return "the injectivity radius is zero";
  return std::string();
}

template <typename Result>
std::string fault_of_functions_on_edges(const Mesh& mesh, const Result& result)
{
  Mesh disk;
  CGAL::cut_along_cut_locus(mesh, result, disk);
  if(!is_disk(disk))
    return "what is cut along the edges is no disk";
  Mesh copy = mesh;
  auto seam_edges = copy.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  auto seam_vertices = copy.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  CGAL::mark_cut_locus_seams(copy, result, seam_edges, seam_vertices);
  return std::string();
}

// Sources at vertices, on edges at simple fractions, and inside of faces.
std::vector<Location> sources_in(const Built& built, std::size_t face)
{
  std::vector<Location> result;
  for(const std::array<double, 3>& c : std::vector<std::array<double, 3>>{{{1., 0., 0.}},
                                                                          {{0.5, 0.5, 0.}},
                                                                          {{0.25, 0.75, 0.}},
                                                                          {{0., 0.3, 0.7}},
                                                                          {{0.5, 0.25, 0.25}},
                                                                          {{1. / 3, 1. / 3, 1. / 3}},
                                                                          {{0.2, 0.3, 0.5}}})
    result.push_back(built.location<double>(face, c));
  return result;
}

void expect_functions_on_all_sources(const Mesh_data& data)
{
  const Built built(data);
  const double area = PMP::area(built.mesh);
  for(std::size_t f = 0; f < data.triangles.size(); ++f)
    for(const Location& source : sources_in(built, f))
    {
      const auto full = compute_cut_locus(built.mesh, source, by(Polyhedral_method()));
      EXPECT_EQ(fault_of_functions(built.mesh, full, area), "") << f;
      const auto curve = compute_cut_locus(built.mesh, source, through_faces);
      EXPECT_EQ(fault_of_functions(built.mesh, curve, area), "") << f;
      const auto edges = compute_cut_locus(built.mesh, source, mesh_edges);
      EXPECT_EQ(fault_of_functions_on_edges(built.mesh, edges), "") << f;
    }
}

TEST(Results_are_taken, where_they_cover_parts_of_edges_of_an_octahedron)
{
  expect_functions_on_all_sources(octahedron());
}

TEST(Results_are_taken, where_they_cover_parts_of_edges_of_a_cube)
{
  expect_functions_on_all_sources(cube(1));
  expect_functions_on_all_sources(cube(2));
}

std::vector<Mesh_data> doubly_covered_triangles()
{
  std::vector<Mesh_data> result;
  for(const std::array<double, 2>& top :
      {std::array<double, 2>{{0.5, 0.8}}, std::array<double, 2>{{0.5, std::sqrt(0.75)}},
       std::array<double, 2>{{0.1, 0.3}}, std::array<double, 2>{{1.7, 0.4}}})
  {
    Mesh_data m;
    m.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{top[0], top[1], 0.}}};
    m.triangles = {{{0, 1, 2}}, {{0, 2, 1}}};
    result.push_back(m);
  }
  return result;
}

TEST(Results_are_taken, on_doubly_covered_triangles)
{
  for(const Mesh_data& m : doubly_covered_triangles())
    expect_functions_on_all_sources(m);
}

// From a corner, the two sheets are equally far from all sides that do not meet there: these are the cut locus.
void expect_length_of_edges(const Mesh_data& data, std::size_t corner, double length)
{
  const Built built(data);
  const auto edges =
    compute_cut_locus(built.mesh, built.vertices[corner],
                      mesh_edges.cut_locus_method(Default_method().minimum_branch_gap(0.).minimum_branch_width(0.)));
  EXPECT_NEAR(CGAL::Cut_loci::compute_statistics(edges).length, length, 1e-12 * length) << corner;
}

TEST(Results_are_taken, as_edges_of_the_mesh_where_the_cut_locus_runs_along_them)
{
  for(const Mesh_data& m : doubly_covered_triangles())
    for(std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto &p = m.points[(corner + 1) % 3], &q = m.points[(corner + 2) % 3];
      expect_length_of_edges(m, corner, std::hypot(q[0] - p[0], q[1] - p[1]));
    }
  for(std::size_t n : {2, 4, 6})
    expect_length_of_edges(doubly_covered(square(n)), 0, 2.);
  // from a vertex of an octahedron, the four edges at the opposite one
  expect_length_of_edges(octahedron(), 0, 4. * std::sqrt(2.));
}

TEST(Results_are_taken, on_doubly_covered_squares)
{
  expect_functions_on_all_sources(doubly_covered(square(4)));
}

// Two octahedra with one vertex in common, each a surface of its own.
TEST(Results_are_taken, where_components_touch_in_a_vertex)
{
  Built built(disjoint_union(octahedron(), octahedron(), {{2., 0., 0.}}));
  const auto kept = built.vertices[0], replaced = built.vertices[7];
  const std::vector<Mesh::Halfedge_index> around(CGAL::halfedges_around_target(replaced, built.mesh).begin(),
                                                 CGAL::halfedges_around_target(replaced, built.mesh).end());
  for(const Mesh::Halfedge_index h : around)
    built.mesh.set_target(h, kept);
  built.mesh.remove_vertex(replaced);
  for(Triangle& t : built.data.triangles)
    std::replace(t.begin(), t.end(), std::size_t(7), std::size_t(0));
  const double area = 0.5 * PMP::area(built.mesh);
  for(const std::size_t f : {0, 1, 8, 13})
    for(const Location& source : sources_in(built, f))
    {
      const auto full = compute_cut_locus(built.mesh, source, by(Polyhedral_method()));
      EXPECT_EQ(fault_of_functions(built.mesh, full, area), "") << f;
      const auto edges = compute_cut_locus(built.mesh, source, mesh_edges);
      EXPECT_EQ(fault_of_functions_on_edges(built.mesh, edges), "") << f;
    }
}

} // namespace

} // namespace test_results_are_taken
