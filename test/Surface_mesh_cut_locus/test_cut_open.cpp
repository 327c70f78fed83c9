// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "cut_locus_by_hand.h"
#include "disk_checker.h"

#include <CGAL/cut_along_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>

namespace test_cut_open {

namespace {

using namespace surface_test;

using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;

// What holds of a surface cut open, and of the maps back to it.
void expect_cut_open(Mesh& mesh, const Cut_locus& cut_locus)
{
  Mesh disk;
  auto vertex_origin = disk.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  auto face_origin = disk.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
  CGAL::cut_along_cut_locus(mesh, cut_locus, disk,
                            params::vertex_to_vertex_map(vertex_origin).face_to_face_map(face_origin));
  EXPECT_EQ(disk_checker::fault(disk), "");
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(disk));
  std::size_t not_manifold = 0;
  for(Mesh::Vertex_index v : disk.vertices())
    not_manifold += CGAL::Polygon_mesh_processing::is_non_manifold_vertex(v, disk);
  EXPECT_EQ(not_manifold, 0u);

  EXPECT_EQ(disk.number_of_faces(), mesh.number_of_faces());
  std::set<Mesh::Face_index> faces;
  for(Mesh::Face_index f : disk.faces())
  {
    EXPECT_TRUE(faces.insert(face_origin[f]).second);
    Mesh::Halfedge_index h = disk.halfedge(f), k = mesh.halfedge(face_origin[f]);
    for(int i = 0; i < 3; ++i, h = disk.next(h), k = mesh.next(k))
    {
      EXPECT_EQ(vertex_origin[disk.source(h)], mesh.source(k));
      EXPECT_EQ(disk.point(disk.source(h)), mesh.point(mesh.source(k)));
    }
  }

  Edge_map seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", true).first;
  Vertex_map seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", true).first;
  const Mesh::Halfedge_index start = CGAL::mark_cut_locus_seams(mesh, cut_locus, seam_edges, seam_vertices);
  const Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  const disk_checker::Counts c = disk_checker::count(seam_mesh);
  EXPECT_EQ(disk_checker::fault(seam_mesh), "");
  EXPECT_EQ(c.vertices, long(disk.number_of_vertices()));
  EXPECT_EQ(c.edges, long(disk.number_of_edges()));
  EXPECT_TRUE(seam_edges[mesh.edge(start)] || mesh.is_border(mesh.edge(start)));
  EXPECT_FALSE(mesh.is_border(start));
  mesh.remove_property_map(seam_edges);
  mesh.remove_property_map(seam_vertices);
}

// for many thresholds of both methods
void expect_cut_open(const Mesh_data& data, std::size_t source)
{
  Built built(data);
  {
    Solver solver(built.mesh, by(Laplacian_method()));
    solver.set_source(built.vertices[source]);
    for(double angle : {0., 0.2, 0.7, 2., 3.14})
      for(std::size_t edges : {0, 3})
      {
        SCOPED_TRACE("angle " + std::to_string(angle) + ", " + std::to_string(edges) + " edges");
        expect_cut_open(built.mesh, solver.cut_locus(mesh_edges.cut_locus_method(
                                      Laplacian_method().gradient_angle_threshold(angle).minimum_branch_edges(edges))));
      }
  }
  Solver solver(built.mesh, by(Default_method()));
  solver.set_source(built.vertices[source]);
  for(double width : {1., 0.1, 0.03, 0.})
  {
    SCOPED_TRACE("width " + std::to_string(width));
    expect_cut_open(built.mesh,
                    solver.cut_locus(mesh_edges.cut_locus_method(Default_method().minimum_branch_width(width))));
  }
}

TEST(Cut_open, Closed_surfaces_of_any_genus)
{
  const std::vector<Mesh_data> surfaces = {
    jittered_sphere(6, 0.2, 1),     bumpy_sphere(8, 0.4, 2),      box(1, 1, 1, 3),
    torus(1., 0.4, 24, 12, 0.2, 3), perforated_plate(2, 1, 2, 4), perforated_plate(3, 1, 2, 5),
    perforated_plate(2, 2, 1, 6),   perforated_plate(5, 1, 1, 7), perforated_plate(3, 2, 2, 8)};
  for(const Mesh_data& data : surfaces)
    for(std::size_t source : {std::size_t(0), data.points.size() / 2})
    {
      SCOPED_TRACE(std::to_string(data.triangles.size()) + " faces, source " + std::to_string(source));
      expect_cut_open(data, source);
    }
}

TEST(Cut_open, Surfaces_with_boundary)
{
  const std::vector<Mesh_data> surfaces = {
    square(8, 0.2, 1), cylinder(2., 16, 8, 0.2, 2), punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}}, 0.35),
    punctured(jittered_sphere(8, 0.2, 3), {{{1., 0., 0.}}, {{-1., 0., 0.}}, {{0., 0., 1.}}}, 0.35),
    punctured(torus(1., 0.4, 24, 14, 0.2, 4), {{{-1.4, 0., 0.}}, {{0., 1.4, 0.}}}, 0.3)};
  for(const Mesh_data& data : surfaces)
  {
    SCOPED_TRACE(std::to_string(data.triangles.size()) + " faces");
    expect_cut_open(data, data.points.size() / 2);
    expect_cut_open(data, 0);
  }
}

TEST(Cut_open, Smallest_closed_surface)
{
  Mesh_data tetrahedron;
  tetrahedron.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}};
  tetrahedron.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
  for(std::size_t source = 0; source < 4; ++source)
    expect_cut_open(tetrahedron, source);
}

TEST(Cut_open, Single_vertex_is_cut_by_two_edges_that_avoid_the_source)
{
  for(const Mesh_data& data : {icosahedron(), jittered_sphere(4, 0.1, 2)})
  {
    Built built(data);
    Mesh& mesh = built.mesh;
    const Mesh::Vertex_index source = built.vertices[3];
    const Cut_locus point =
      compute_cut_locus(mesh, source, mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(3.14)));
    ASSERT_EQ(num_edges(point.graph()), 0u);
    Edge_map seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
    Vertex_map seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam").first;
    CGAL::mark_cut_locus_seams(mesh, point, seam_edges, seam_vertices);
    const Mesh::Vertex_index v = point.graph()[0].mesh_vertex;
    int count = 0;
    for(Mesh::Edge_index e : mesh.edges())
      if(seam_edges[e])
      {
        ++count;
        EXPECT_TRUE(mesh.vertex(e, 0) == v || mesh.vertex(e, 1) == v);
      }
    EXPECT_EQ(count, 2);
    EXPECT_FALSE(seam_vertices[source]);
  }
}

TEST(Cut_open, Only_the_component_of_the_source_is_returned)
{
  const Mesh_data first = jittered_sphere(5, 0.1, 1), second = torus(1., 0.4, 20, 10, 0.1, 2);
  Built built(disjoint_union(first, second, {{5., 0., 0.}}));
  const Mesh::Vertex_index source = built.vertices[first.points.size() + 7];
  const Cut_locus cut_locus = compute_cut_locus(built.mesh, source, mesh_edges);
  Mesh disk;
  std::vector<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> vertices;
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> faces;
  CGAL::cut_along_cut_locus(built.mesh, cut_locus, disk,
                            params::vertex_to_vertex_output_iterator(std::back_inserter(vertices))
                              .face_to_face_output_iterator(std::back_inserter(faces)));
  EXPECT_EQ(disk_checker::fault(disk), "");
  EXPECT_EQ(disk.number_of_faces(), second.triangles.size());
  ASSERT_EQ(vertices.size(), disk.number_of_vertices());
  ASSERT_EQ(faces.size(), disk.number_of_faces());
  std::map<Mesh::Vertex_index, int> copies;
  for(const auto& p : vertices)
  {
    EXPECT_GE(built.index(p.first), first.points.size());
    EXPECT_EQ(built.mesh.point(p.first), disk.point(p.second));
    ++copies[p.first];
  }
  for(const auto& p : faces)
    EXPECT_GE(std::size_t(p.first), first.triangles.size());
  // Away from the border, a vertex has as many copies as edges of the cut locus, or one.
  const auto& graph = cut_locus.graph();
  for(auto v : CGAL::make_range(boost::vertices(graph)))
    EXPECT_EQ(copies.at(graph[v].mesh_vertex), int((std::max)(degree(v, graph), std::size_t(1))));
}

TEST(Cut_open, Other_mesh_types)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  const Built_mesh<Polyhedron> built(perforated_plate(2, 1, 1, 4));
  const auto cut_locus = compute_cut_locus(built.mesh, built.vertices[0], mesh_edges);
  Polyhedron polyhedron;
  CGAL::cut_along_cut_locus(built.mesh, cut_locus, polyhedron);
  EXPECT_EQ(disk_checker::fault(polyhedron), "");
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(polyhedron));

  CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> mesh; // the coordinates are converted
  std::map<boost::graph_traits<decltype(mesh)>::vertex_descriptor, Kernel::Point_3> points;
  CGAL::cut_along_cut_locus(built.mesh, cut_locus, mesh);
  EXPECT_EQ(disk_checker::fault(mesh), "");
  EXPECT_EQ(mesh.number_of_vertices(), polyhedron.size_of_vertices());
  mesh.clear();
  CGAL::cut_along_cut_locus(built.mesh, cut_locus, mesh, params::default_values(),
                            params::vertex_point_map(boost::make_assoc_property_map(points)));
  EXPECT_EQ(points.size(), polyhedron.size_of_vertices());
}

std::string error(const Mesh& mesh, const Cut_locus& cut_locus)
{
  Mesh disk;
  return message_of([&] { CGAL::cut_along_cut_locus(mesh, cut_locus, disk); });
}

TEST(Cut_open, Bad_input_gives_an_error)
{

  Built built(torus(1., 0.4, 24, 12, 0.2, 3));
  const Cut_locus cut_locus = compute_cut_locus(built.mesh, built.vertices[0], mesh_edges);
  const std::string none = "nothing was thrown";
  ASSERT_EQ(error(built.mesh, cut_locus), none);

  for(const Mesh_data& data :
      {icosahedron(), jittered_sphere(12, 0.1, 1), torus(1., 0.4, 12, 24, 0.2, 3), perforated_plate(2, 1, 2, 1)})
    expect_has(error(Built(data).mesh, cut_locus), "does not belong to the mesh");
  EXPECT_NE(error(Mesh(), cut_locus), none);

  const Cut_locus in_faces = compute_cut_locus(built.mesh, built.vertices[0]);
  EXPECT_EQ(error(built.mesh, in_faces), none) << "faces are split";
  std::map<Mesh::Edge_index, bool> seam_edges;
  std::map<Mesh::Vertex_index, bool> seam_vertices;
  expect_words(
    [&]
    {
    CGAL::mark_cut_locus_seams(built.mesh, in_faces, boost::make_assoc_property_map(seam_edges),
                               boost::make_assoc_property_map(seam_vertices));
    },
    {"cut_along_cut_locus", "cut_locus_curve(Cut_loci::Curve::MESH_EDGES)"});

  // a graph of its own: empty, or a part of a cut locus
  const auto with_graph = [&](const Cut_locus::Graph& graph)
  { return cut_locus_by_hand<Cut_locus>(graph, {cut_locus.source()}); };
  expect_has(error(built.mesh, with_graph(Cut_locus::Graph())), "empty");
  Cut_locus::Graph part = cut_locus.graph();
  remove_edge(*edges(part).first, part);
  expect_has(error(built.mesh, with_graph(part)), "no disk");

  Mesh quads;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), quads);
  expect_has(error(quads, cut_locus), "triangles");
}

} // namespace

} // namespace test_cut_open
