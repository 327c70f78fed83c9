// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Turned polyhedra of unit squares whose faces are divided anyhow, with the seven digits that many files have: no two faces
// are quite coplanar, each vertex has a branch along which two paths differ by less than rounding in one place or another,
// and paths pass vertices by less than windows are accurate.

#include "surface_test.h"
#include "checked_curves.h"

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/polyhedral/faces/Face_ridges.h>
#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/Path_label.h>
#include <CGAL/Surface_mesh_shortest_path.h>

namespace test_rounded_polyhedra {

namespace {

using namespace surface_test;

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

// each unit square is divided in n x n
Mesh rounded(const Mesh_data& m, int n, unsigned seed)
{
  std::mt19937 engine(seed);
  Mesh mesh;
  for(Point p : m.points)
  {
    for(double& x : p)
    {
      const double jitter = 0.3 / n * random_unit(engine);
      x += x != std::round(x) ? jitter : 0.;
    }
    const double x = 0.8 * p[0] - 0.6 * p[1], y = 0.6 * p[0] + 0.8 * p[1];
    p = {{x, 0.28 * y - 0.96 * p[2], 0.96 * y + 0.28 * p[2]}};
    for(double& c : p)
      c = std::round(1e7 * c) * 1e-7;
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  }
  for(const Triangle& t : m.triangles)
    mesh.add_face(Mesh::Vertex_index(Mesh::size_type(t[0])), Mesh::Vertex_index(Mesh::size_type(t[1])),
                  Mesh::Vertex_index(Mesh::size_type(t[2])));
  return mesh;
}

std::vector<Named_mesh> meshes()
{
  std::vector<Named_mesh> result;
  for(unsigned seed : {1u, 2u, 3u})
  {
    const std::string end = ", seed " + std::to_string(seed);
    for(int n : {3, 6, 10})
    {
      result.push_back({"cube " + std::to_string(n) + end, rounded(cube(n), n, seed)});
      result.push_back({"L-shape " + std::to_string(n) + end, rounded(l_shape(n), n, seed)});
    }
    for(int n : {1, 2, 3})
      result.push_back(
        {"plate with holes " + std::to_string(n) + end, rounded(plate_with_holes(2, 1, n), 3 * n, seed)});
  }
  return result;
}

Vertices sources(const Mesh& mesh)
{
  Vertices result;
  for(int i : {0, 1, 2})
    result.push_back(Mesh::Vertex_index(Mesh::size_type(i * (mesh.number_of_vertices() - 1) / 2)));
  return result;
}

TEST(Rounded_polyhedra, distances_are_those_of_cgal)
{
  for(const Named_mesh& m : meshes())
  {
    if(m.mesh.number_of_vertices() > 600)
      continue;
    const Mesh& mesh = m.mesh;
    SCOPED_TRACE(m.name);
    const auto read = CGAL::Cut_loci::internal::read_triangle_mesh(mesh, get(CGAL::vertex_point, mesh));
    CGAL::Cut_loci::internal::Exact_geodesic_propagation geodesics(read.mesh);
    for(Mesh::Vertex_index source : sources(mesh))
    {
      geodesics.run(static_cast<Index>(source.idx()));
      CGAL::Surface_mesh_shortest_path<Traits> other(mesh);
      other.add_source_point(source);
      for(Mesh::Vertex_index v : mesh.vertices())
      {
        const double expected = other.shortest_distance_to_source_points(v).first;
        EXPECT_NEAR(geodesics.distance(static_cast<Index>(v.idx())), expected, 1e-9 * (1. + expected))
          << "from " << source << " to " << v;
      }
    }
  }
}

TEST(Rounded_polyhedra, no_shortest_path_crosses_the_cut_locus)
{
  for(const Named_mesh& m : meshes())
  {
    Solver solver(m.mesh, by(Polyhedral_method()));
    for(Mesh::Vertex_index source : sources(m.mesh))
    {
      SCOPED_TRACE(testing::Message() << m.name << ", from " << source);
      solver.set_source(source);
      EXPECT_LT(checked_curves::measured(m.mesh, solver.cut_locus(through_faces)).max, 0.01);
    }
  }
}

// a part of a ring of which each vertex of the inner rim bends paths by a little
Mesh part_of_a_ring(int n, double opening, bool has_seven_digits)
{
  Mesh mesh;
  Vertices v;
  const auto rounded = [&](double x) { return has_seven_digits ? static_cast<double>(static_cast<float>(x)) : x; };
  for(int i = 0; i <= n; ++i)
  {
    const double angle = 0.5 * opening + (2. * pi - opening) * i / n;
    const double c = 0.8 * std::cos(angle) - 0.6 * std::sin(angle), s = 0.6 * std::cos(angle) + 0.8 * std::sin(angle);
    for(const auto& [radius, height] :
        std::array<std::pair<double, double>, 4>{{{1., 0.3}, {1., 0.}, {0.5, 0.}, {0.5, 0.3}}})
      v.push_back(mesh.add_vertex(Kernel::Point_3(rounded(radius * c), rounded(radius * s), rounded(height))));
  }
  const auto add_rectangle = [&](int a, int b, int c, int d)
  {
    const auto at = [&](int i) { return v[static_cast<std::size_t>(i)]; };
    mesh.add_face(at(a), at(b), at(c));
    mesh.add_face(at(a), at(c), at(d));
  };
  for(int i = 0; i < n; ++i)
    for(int k = 0; k < 4; ++k)
      add_rectangle(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k);
  add_rectangle(3, 2, 1, 0);
  add_rectangle(4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3);
  return mesh;
}

// They run along edges, and pass one vertex of the rim after another by less than rounding.
TEST(Rounded_polyhedra, no_shortest_path_that_grazes_a_rim_crosses_the_cut_locus)
{
  for(bool has_seven_digits : {true, false})
    for(double opening : {0.5, 3.})
    {
      const Mesh mesh = part_of_a_ring(120, opening, has_seven_digits);
      Solver solver(mesh, by(Polyhedral_method()));
      for(Mesh::size_type source = 0; source < mesh.number_of_vertices(); source += 7)
      {
        SCOPED_TRACE(testing::Message() << "opening " << opening << ", from " << source
                                        << (has_seven_digits ? ", seven digits" : ""));
        solver.set_source(Mesh::Vertex_index(source));
        // where paths are equally long, lengths are changed by some millionths
        EXPECT_LT(checked_curves::measured(mesh, solver.cut_locus(through_faces)).max, 1e-6);
      }
    }
}

// a square plate with a round hole in the middle, all of whose triangles are long fans, given with four digits
Mesh plate_with_a_round_hole(int n, double half_side, double height)
{
  Mesh mesh;
  std::array<Vertices, 2> rim, corners;
  const auto rounded = [](double x) { return std::round(1e4 * x) / 1e4; };
  for(std::size_t level : {0, 1})
  {
    const double z = level == 0 ? 0. : height;
    for(int k = 0; k < n; ++k)
    {
      const double angle = 2. * pi * k / n;
      rim[level].push_back(mesh.add_vertex(Kernel::Point_3(rounded(std::cos(angle)), rounded(std::sin(angle)), z)));
    }
    for(const auto& [x, y] : std::array<std::pair<int, int>, 4>{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}})
      corners[level].push_back(mesh.add_vertex(Kernel::Point_3(x * half_side, y * half_side, z)));
  }
  const auto add_side = [&](Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c, Mesh::Vertex_index d)
  {
    mesh.add_face(a, b, c);
    mesh.add_face(a, c, d);
  };
  const auto rim_size = static_cast<std::size_t>(n);
  for(std::size_t k = 0; k < rim_size; ++k)
  {
    const std::size_t next = (k + 1) % rim_size, c = 4 * k / rim_size;
    mesh.add_face(rim[1][k], corners[1][c], rim[1][next]);
    mesh.add_face(rim[0][next], corners[0][c], rim[0][k]);
    add_side(rim[0][k], rim[1][k], rim[1][next], rim[0][next]);
    if(4 * k % rim_size != 0)
      continue;
    const std::size_t last = (c + 3) % 4;
    mesh.add_face(rim[1][k], corners[1][last], corners[1][c]);
    mesh.add_face(rim[0][k], corners[0][c], corners[0][last]);
    add_side(corners[0][last], corners[0][c], corners[1][c], corners[1][last]);
  }
  return mesh;
}

// A path around the wall is straight on it: it passes the vertices of both rims by what rays are inaccurate across edges
// that are hundreds of times as long.
TEST(Rounded_polyhedra, no_shortest_path_around_a_round_hole_crosses_the_cut_locus)
{
  for(double height : {1., 0.3})
  {
    const Mesh mesh = plate_with_a_round_hole(40, 20., height);
    Solver solver(mesh, by(Polyhedral_method()));
    for(Mesh::Vertex_index source : mesh.vertices())
    {
      SCOPED_TRACE(testing::Message() << "height " << height << ", from " << source);
      solver.set_source(source);
      EXPECT_LT(checked_curves::measured(mesh, solver.cut_locus(through_faces)).max, 1e-9);
    }
  }
}

// -- in a face --------------------------------------------------------------------------------------------------------

namespace lib = CGAL::Cut_loci::internal;
using lib::Plane_point;

// of an origin of that number
lib::Image image(double x, double y, double sigma, Index origin)
{
  return {x, y, sigma, origin, 0, 0.};
}

// what is drawn in a face between the ends of its longest edge and a point
lib::Face_ridges drawn(const Plane_point& apex, const std::vector<lib::Face_change>& changes)
{
  lib::Face_ridges result;
  std::vector<lib::Face_ridges::Entry> entries;
  const std::array<Plane_point, 3> corners = {{{0., 0.}, {1., 0.}, apex}};
  result.draw(
    corners, changes, 1e-8, [&]() -> const std::vector<lib::Face_ridges::Entry>& { return entries; },
    [](const lib::Image& a, const lib::Image& b, const Plane_point&, bool is_ray)
    { return is_ray && a.origin != b.origin; });
  return result;
}

TEST(Rounded_polyhedra, images_of_vertices_on_a_straight_edge_have_a_node)
{
  for(double tilt : {0., 1e-18, -1e-17, 1e-9})
  {
    const Plane_point node{2e-3, 1e-3};
    std::vector<lib::Image> images;
    for(double y : {5e-3, 6e-3, -6e-3})
    {
      const double x = tilt * y;
      images.push_back(image(x, y, 0.05 - std::hypot(x - node.x, y - node.y), 0));
    }
    std::array<Plane_point, 2> found;
    const std::size_t n = lib::equidistant_points(images[0], images[1], images[2], found);
    double least = 1.;
    for(std::size_t i = 0; i < n; ++i)
      least = (std::min)(least, std::hypot(found[i].x - node.x, found[i].y - node.y));
    EXPECT_LT(least, 1e-10) << tilt;
  }
}

TEST(Rounded_polyhedra, shadows_without_a_window_keep_no_pieces_apart)
{
  // on each side of a piece, two images that are turned around a vertex, which is beside the face, and its shadow
  const Plane_point apex{0.5, 0.5}, vertex{0.5, 0.6}, other{0.15, 0.25};
  const double turn = 1e-6, beyond = 0.1 + 0.05 * 2. / 1.75, entry = 0.275 / 1.75 / (1. + 0.05 / 1.75);
  const lib::Image a = image(0.5 - turn, 2., 0., 0), b = image(0.5 + turn, 2., 0., 0),
                   shadow = image(vertex.x, vertex.y, 1.4, 1), c = image(0.1 - turn, 2., 0., 0),
                   d = image(0.1 + turn, 2., 0., 0), other_shadow = image(other.x, other.y, std::hypot(0.05, 1.75), 2);
  const std::vector<lib::Face_change> changes = {{{beyond, 0.}, 0, d, other_shadow, true, true},
                                                 {{beyond + turn, 0.}, 0, other_shadow, c, true, true},
                                                 {{0.3, 0.}, 0, c, b, false, false},
                                                 {{0.5, 0.}, 0, b, shadow, true, true},
                                                 {{0.5 + turn, 0.}, 0, shadow, a, true, true},
                                                 {apex, 1, a, b, true, true},
                                                 {{0.3, 0.3}, 2, b, c, false, false},
                                                 {{entry, entry}, 2, c, d, true, true}};
  EXPECT_FALSE(drawn(apex, changes).is_doubtful);
}

TEST(Rounded_polyhedra, paths_on_two_sides_of_a_shadow_get_apart)
{
  const lib::Path_label left{-0.1, -1., 0., 0., 0, false}, right{0.1, -1., 0., 0., 0, false};
  EXPECT_TRUE(lib::get_apart(right, left, 0.));
  EXPECT_FALSE(lib::get_apart(left, right, 0.));
  EXPECT_TRUE(lib::get_apart(right.opposite(1.), left.opposite(1.), 1.) !=
              lib::get_apart(left.opposite(1.), right.opposite(1.), 1.));
}

} // namespace

} // namespace test_rounded_polyhedra
