// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "cut_locus_by_hand.h"
#include "surface_test.h"

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/geodesic_loop.h>
#include <CGAL/Cut_loci/injectivity_radius.h>

// The two shortest paths to the nearest point of the cut locus.

namespace test_geodesic_loop {

namespace {

using namespace surface_test;
using Points = std::vector<Kernel::Point_3>;

double length(const Points& points)
{
  double result = 0.;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    result += distance(points[i], points[i + 1]);
  return result;
}

/// around a cylinder, it is the circle through the source
TEST(Geodesic_loop, of_a_cylinder_goes_around)
{
  const Built built(cylinder(2., 24, 8, 0., 0));
  const Mesh& mesh = built.mesh;
  for(const Mesh::Vertex_index source : {built.vertices[0], built.vertices[built.vertices.size() / 2]})
  {
    const Points loop = CGAL::Cut_loci::geodesic_loop(mesh, compute_cut_locus(mesh, source));
    EXPECT_NEAR(length(loop), 48. * std::sin(pi / 24.), 1e-5);
    EXPECT_EQ(loop.front(), loop.back());
    for(const Kernel::Point_3& p : loop)
      EXPECT_NEAR(p.z(), mesh.point(source).z(), 2e-3);
  }
}

/// begins and ends at the source, passes through the nearest point in its middle, and is twice as long as the radius
TEST(Geodesic_loop, is_twice_the_radius_on_random_surfaces)
{
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(seed % 3 == 0   ? torus(2., 0.8, 18, 10, 0.2, seed)
                      : seed % 3 == 1 ? irregular_bumpy_sphere(6, 0.3, seed)
                                      : random_convex_polyhedron(15, seed));
    const std::pair<Mesh::Face_index, std::array<double, 3>> source(Mesh::Face_index(seed), {{0.2, 0.5, 0.3}});
    const auto cut_locus = compute_cut_locus(built.mesh, source);
    const auto nearest = CGAL::Cut_loci::injectivity_radius(cut_locus);
    const Points loop = CGAL::Cut_loci::geodesic_loop(built.mesh, cut_locus);
    // between the ends of an edge, the radius is that in a plane, which is known to this
    double tolerance = 1e-5;
    if(nearest.edge)
    {
      const auto& graph = cut_locus.graph();
      const auto &a = graph[boost::source(*nearest.edge, graph)], &b = graph[boost::target(*nearest.edge, graph)];
      tolerance += CGAL::squared_distance(a.point, b.point) / (4. * (a.distance + b.distance));
    }
    EXPECT_NEAR(length(loop), 2. * nearest.distance, 2. * tolerance);
    const Kernel::Point_3 start = cut_locus.source().point;
    EXPECT_LT(CGAL::squared_distance(loop.front(), start), 1e-24);
    EXPECT_LT(CGAL::squared_distance(loop.back(), start), 1e-24);
    double way = 0., closest = 1.;
    for(std::size_t i = 0; i + 1 < loop.size(); ++i)
    {
      if(std::fabs(way - nearest.distance) < tolerance)
        closest = std::min(closest, std::sqrt(CGAL::squared_distance(loop[i], nearest.point)));
      way += std::sqrt(CGAL::squared_distance(loop[i], loop[i + 1]));
    }
    EXPECT_LT(closest, 1e-5);
  }
}

/// A square with two sides: edges on both join the same two vertices. The cut locus is one of them, the source on the other.
TEST(Geodesic_loop, passes_the_edge_of_the_cut_locus)
{
  Indexed_triangle_mesh square;
  square.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0.5, 0.5, 0.}}, {{0.5, -0.5, 0.}}};
  square.triangles = {{{0, 1, 2}}, {{1, 0, 2}}, {{1, 0, 3}}, {{0, 1, 3}}};
  square.opposite = {6, 5, 4, 9, 2, 1, 0, 11, 10, 3, 8, 7};
  Mesh mesh;
  const auto built = CGAL::Cut_loci::internal::build_face_graph(square, mesh);
  for(Index v = 0; v < 4; ++v)
    mesh.point(built.vertices[v]) = {square.points[v][0], square.points[v][1], square.points[v][2]};
  using Cut_locus = CGAL::Cut_locus<Mesh, Kernel::Point_3>;
  const auto at = [&](Index h, double share)
  {
    Cut_locus::Vertex result;
    const Indexed_location x = CGAL::Cut_loci::internal::location_on(h, share);
    // the face has its corners from those of the first halfedge on
    result.location = {face(built.halfedges[h], mesh), x.coordinates};
    result.mesh_vertex = share == 0. ? built.vertices[square.source(h)] : Mesh::null_vertex();
    result.point = {(1. - share) * square.points[square.source(h)][0] + share * square.points[square.target(h)][0], 0.,
                    0.};
    result.distance = std::sqrt(0.5);
    return result;
  };
  for(const auto& [cut, opposite] : {std::pair<Index, Index>(0, 9), std::pair<Index, Index>(9, 0)})
  {
    Cut_locus::Graph graph;
    add_vertex(at(0, 0.), graph);
    add_vertex(at(3, 0.), graph);
    Cut_locus::Edge edge;
    edge.mesh_halfedge = built.halfedges[cut];
    add_edge(0, 1, edge, graph);
    const Points loop = CGAL::Cut_loci::geodesic_loop(mesh, cut_locus_by_hand<Cut_locus>(graph, {at(opposite, 0.5)}));
    EXPECT_NEAR(length(loop), std::sqrt(2.), 1e-5) << "edge " << cut;
  }
}

TEST(Geodesic_loop, is_that_of_one_source)
{
  const Built built(torus(2., 0.8, 18, 10));
  const auto of_two = compute_cut_locus(built.mesh, Vertices{built.vertices[0], built.vertices[50]});
  EXPECT_THROW(CGAL::Cut_loci::geodesic_loop(built.mesh, of_two), Invalid_input);
}

} // namespace

} // namespace test_geodesic_loop
