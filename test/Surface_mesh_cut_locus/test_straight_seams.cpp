// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "disk_checker.h"

#include <CGAL/cut_along_cut_locus.h>
#include <CGAL/refine_along_cut_locus.h>

namespace test_straight_seams {

namespace {

using namespace surface_test;

Point to_array(const Kernel::Point_3& p)
{
  return {{p.x(), p.y(), p.z()}};
}

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Point d = b - a;
  const double t = dot(d, d) > 0. ? (std::min)(1., (std::max)(0., dot(p - a, d) / dot(d, d))) : 0.;
  return norm(p - (a + t * d));
}

double area(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Point a = to_array(mesh.point(mesh.source(h))), b = to_array(mesh.point(mesh.target(h))),
              c = to_array(mesh.point(mesh.target(mesh.next(h))));
  return 0.5 * norm(cross(b - a, c - a));
}

Point normal(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Point a = to_array(mesh.point(mesh.source(h))), b = to_array(mesh.point(mesh.target(h))),
              c = to_array(mesh.point(mesh.target(mesh.next(h))));
  return cross(b - a, c - a);
}

// What holds of the refined mesh: the same surface, with seams where the curve is.
void expect_refined(const Mesh& mesh, const Cut_locus& cut_locus, double tolerance)
{
  Mesh refined;
  auto face_origin = refined.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
  auto vertex_origin = refined.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  auto is_seam = refined.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
  CGAL::refine_along_cut_locus(
    mesh, cut_locus, refined,
    params::vertex_to_vertex_map(vertex_origin).face_to_face_map(face_origin).snapping_tolerance(tolerance),
    params::edge_is_constrained_map(is_seam));
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(refined));
  const disk_checker::Counts before = disk_checker::count(mesh), after = disk_checker::count(refined);
  EXPECT_EQ(before.vertices - before.edges + before.faces, after.vertices - after.edges + after.faces);
  EXPECT_EQ(before.border_loops, after.border_loops);
  EXPECT_EQ(before.parts, after.parts);

  std::vector<double> sum(mesh.number_of_faces(), 0.);
  for(Mesh::Face_index f : refined.faces())
  {
    const double part = area(refined, f), whole = area(mesh, face_origin[f]);
    sum[face_origin[f]] += part;
    EXPECT_GT(part, 0.99 * tolerance * tolerance * whole);
    EXPECT_GT(dot(normal(refined, f), normal(mesh, face_origin[f])), 0.99 * 4. * part * whole);
  }
  for(Mesh::Face_index f : mesh.faces())
    EXPECT_NEAR(sum[f], area(mesh, f), 1e-9 * area(mesh, f));
  std::size_t kept = 0;
  for(Mesh::Vertex_index v : refined.vertices())
    if(vertex_origin[v] != Mesh::null_vertex())
    {
      ++kept;
      EXPECT_EQ(refined.point(v), mesh.point(vertex_origin[v]));
    }
  EXPECT_EQ(kept, mesh.number_of_vertices());

  // Each end of a seam is near the curve: a coordinate is rounded by up to the tolerance, over two edges.
  double longest = 0.;
  for(Mesh::Edge_index e : mesh.edges())
    longest =
      (std::max)(longest, norm(to_array(mesh.point(mesh.vertex(e, 0))) - to_array(mesh.point(mesh.vertex(e, 1)))));
  const auto& graph = cut_locus.graph();
  for(Mesh::Edge_index e : refined.edges())
  {
    if(!is_seam[e])
      continue;
    double nearest = (std::numeric_limits<double>::infinity)();
    const Point p =
      0.5 * (to_array(refined.point(refined.vertex(e, 0))) + to_array(refined.point(refined.vertex(e, 1))));
    for(auto g : CGAL::make_range(edges(graph)))
      nearest = (std::min)(nearest, distance_to_segment(p, to_array(graph[source(g, graph)].point),
                                                        to_array(graph[target(g, graph)].point)));
    EXPECT_LE(nearest, 2. * tolerance * longest);
  }
}

void expect_disk(const Mesh& mesh, const Cut_locus& cut_locus, double tolerance)
{
  Mesh disk;
  std::map<Mesh::Face_index, Mesh::Face_index> face_origin;
  CGAL::cut_along_cut_locus(
    mesh, cut_locus, disk,
    params::snapping_tolerance(tolerance).face_to_face_map(boost::make_assoc_property_map(face_origin)));
  EXPECT_EQ(disk_checker::fault(disk), "");
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(disk));
  EXPECT_EQ(face_origin.size(), disk.number_of_faces());
}

void expect_straight_seams(const Mesh_data& data, const std::vector<std::size_t>& sources,
                           const std::vector<double>& tolerances = {1. / 256.})
{
  const Built built(data);
  Solver laplacian(built.mesh, by(Laplacian_method()));
  Solver direction(built.mesh, by(Default_method()));
  const auto check = [&](const Cut_locus& cut_locus)
  {
    for(double tolerance : tolerances)
    {
      expect_refined(built.mesh, cut_locus, tolerance);
      expect_disk(built.mesh, cut_locus, tolerance);
    }
  };
  for(std::size_t s : sources)
  {
    SCOPED_TRACE(std::to_string(data.triangles.size()) + " faces, source " + std::to_string(s));
    laplacian.set_source(built.vertices[s]);
    for(double angle : {0., 0.7, 3.14})
    {
      SCOPED_TRACE("angle " + std::to_string(angle));
      check(laplacian.cut_locus(by(Laplacian_method().gradient_angle_threshold(angle))));
    }
    check(laplacian.cut_locus());
    direction.set_source(built.vertices[s]);
    for(double width : {1., 0.1, 0.03, 0.})
    {
      SCOPED_TRACE("width " + std::to_string(width));
      check(direction.cut_locus(through_faces.cut_locus_method(Default_method().minimum_branch_width(width))));
    }
  }
}

TEST(Straight_seams, Closed_surfaces_of_any_genus)
{
  for(const Mesh_data& data : {jittered_sphere(6, 0.2, 1), bumpy_sphere(8, 0.4, 2), torus(1., 0.4, 24, 12, 0.2, 3),
                               perforated_plate(2, 1, 2, 4), perforated_plate(3, 1, 1, 5), perforated_plate(2, 2, 1, 6),
                               perforated_plate(5, 1, 1, 7), perforated_plate(3, 2, 2, 8)})
    expect_straight_seams(data, {0, data.points.size() / 3, data.points.size() - 1});
}

TEST(Straight_seams, Surfaces_with_boundary)
{
  for(const Mesh_data& data :
      {square(8, 0.2, 1), cylinder(2., 16, 8, 0.2, 2), punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}}, 0.35),
       punctured(torus(1., 0.4, 24, 14, 0.2, 4), {{{-1.4, 0., 0.}}, {{0., 1.4, 0.}}}, 0.3)})
    expect_straight_seams(data, {0, data.points.size() / 2});
}

// Down to a grid on which all of the curve goes through vertices and the middles of edges.
TEST(Straight_seams, Any_tolerance)
{
  for(const Mesh_data& data : {torus(1., 0.4, 24, 12, 0.2, 3), perforated_plate(2, 1, 1, 4), box(1, 1, 1, 3)})
    expect_straight_seams(data, {5}, {1. / (1 << 20), 1e-3, 0.05, 0.2, 0.5});
}

// On a symmetric mesh the cut locus runs through vertices and along edges.
TEST(Straight_seams, Curves_along_edges_of_the_mesh)
{
  for(const Mesh_data& data : {torus(1., 0.4, 24, 12), box(2, 1, 1, 2), icosahedron(), square(6)})
    expect_straight_seams(data, {0, data.points.size() / 2});
}

TEST(Straight_seams, Faces_off_the_curve_stay)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 3));
  const Cut_locus on_edges = compute_cut_locus(built.mesh, built.vertices[0], mesh_edges);
  Mesh refined;
  CGAL::refine_along_cut_locus(built.mesh, on_edges, refined);
  EXPECT_EQ(refined.number_of_faces(), built.mesh.number_of_faces());
  EXPECT_EQ(refined.number_of_vertices(), built.mesh.number_of_vertices());
}

TEST(Straight_seams, Bad_input_gives_an_error)
{
  const Built built(torus(1., 0.4, 24, 12, 0.2, 3)), other(jittered_sphere(5, 0.1, 1));
  const Cut_locus curve = compute_cut_locus(built.mesh, built.vertices[0], through_faces);
  Mesh output;
  EXPECT_THROW(CGAL::cut_along_cut_locus(other.mesh, curve, output), Invalid_input);
  for(double tolerance : {-1., 0., 1e-9, 0.6, std::nan("")})
    EXPECT_THROW(CGAL::refine_along_cut_locus(built.mesh, curve, output, params::snapping_tolerance(tolerance)),
                 Invalid_input);
  EXPECT_TRUE(output.is_empty());
}

} // namespace

} // namespace test_straight_seams
