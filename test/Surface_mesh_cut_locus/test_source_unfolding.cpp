// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Source unfoldings: that they are the polyhedron when glued, and do not overlap.

#include "surface_test.h"

#include <CGAL/Cut_loci/source_unfolding.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

namespace test_source_unfolding {

namespace {

using namespace surface_test;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_index = Mesh::Vertex_index;
using Named_surface = std::pair<std::string, Mesh>;
using Unfolding = CGAL::Cut_loci::Source_unfolding<Mesh, Kernel::Point_3>;
using CGAL::Cut_loci::source_unfolding;

Mesh_data dodecahedron()
{
  const double g = 0.5 * (1. + std::sqrt(5.));
  std::vector<Point> points;
  for(double x : {-1., 1.})
    for(double y : {-1., 1.})
      points.insert(points.end(),
                    {{{x, y, -1.}}, {{x, y, 1.}}, {{0., x / g, y * g}}, {{x / g, y * g, 0.}}, {{x * g, 0., y / g}}});
  return convex_hull(points);
}

Mesh_data hull_of_ball(std::size_t n, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Point> points;
  while(points.size() < n)
  {
    const Point p = {{random_unit(engine), random_unit(engine), random_unit(engine)}};
    if(norm(p) < 1.)
      points.push_back(p);
  }
  return convex_hull(points);
}

double length(const Kernel::Vector_3& v)
{
  return std::sqrt(v.squared_length());
}

// the angle of a face at the source of `h`
double corner_angle(const Mesh& mesh, Mesh::Halfedge_index h)
{
  const Kernel::Point_3& p = mesh.point(mesh.source(h));
  const Kernel::Vector_3 a = mesh.point(mesh.target(h)) - p, b = mesh.point(mesh.source(mesh.prev(h))) - p;
  return std::atan2(length(CGAL::cross_product(a, b)), a * b);
}

std::vector<double> total_angles(const Mesh& mesh)
{
  std::vector<double> result(mesh.number_of_vertices(), 0.);
  for(auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      result[mesh.source(h)] += corner_angle(mesh, h);
  return result;
}

class Checked_unfolding
{
public:
  template <typename Source>
  Checked_unfolding(const Mesh& mesh, const Source& source)
    : mesh_(mesh), u_(source_unfolding(mesh, source)), angles_(total_angles(mesh))
  {
    for(const auto& c : u_.corners)
      scale_ = (std::max)(scale_, std::hypot(c.point.x(), c.point.y()));
    check_gluing();
    check_area();
    check_distances();
    check_angles();
    check_folds();
    check_overlap();
  }

  const Unfolding& operator()() const { return u_; }

  // All vertices of positive curvature, but the source, are ends of branches or on them.
  void check_ends(Vertex_index source) const
  {
    std::vector<int> copies(u_.vertices.size(), 0);
    for(const auto& c : u_.corners)
      ++copies[c.vertex];
    std::set<Vertex_index> found;
    for(std::size_t i = 0; i < copies.size(); ++i)
    {
      const Vertex_index v = u_.vertices[i].mesh_vertex;
      if(v != Mesh::null_vertex())
      {
        EXPECT_TRUE(found.insert(v).second) << v << " twice";
      }
      if(copies[i] == 1)
      {
        ASSERT_NE(v, Mesh::null_vertex());
        EXPECT_LT(angles_[v], 2. * pi - 1e-7);
      }
    }
    for(Vertex_index v : mesh_.vertices())
      EXPECT_TRUE(found.count(v) == 1 || angles_[v] > 2. * pi - 1e-7 || v == source) << v;
  }

private:
  const Unfolding::Corner& corner(std::size_t i) const { return u_.corners[i % u_.corners.size()]; }
  double edge_length(std::size_t i) const
  {
    return std::sqrt(CGAL::squared_distance(corner(i).point, corner(i + 1).point));
  }

  void check_gluing() const
  {
    const std::size_t n = u_.corners.size();
    ASSERT_GE(n, 2u);
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = corner(i).vertex, b = corner(i + 1).vertex, j = corner(i).glued_to;
      const double l = edge_length(i);
      // each edge is in a face, but for a cut from the source
      if(i > 0 || u_.vertices[a].distance > 0.)
      {
        if(i + 1 < n || u_.vertices[b].distance > 0.)
        {
          EXPECT_NEAR(l, length(u_.vertices[b].point - u_.vertices[a].point), 1e-9 * scale_);
        }
      }
      if(j == Unfolding::no_edge)
        continue;
      ASSERT_LT(j, n);
      ASSERT_NE(j, i);
      EXPECT_EQ(corner(j).glued_to, i);
      EXPECT_EQ(corner(j).vertex, b);
      EXPECT_EQ(corner(j + 1).vertex, a);
      EXPECT_NEAR(l, edge_length(j), 1e-9 * l + 1e-12 * scale_);
    }
  }

  void check_area() const
  {
    double area = 0., expected = 0.;
    for(std::size_t i = 0; i < u_.corners.size(); ++i)
    {
      const auto &p = corner(i).point, &q = corner(i + 1).point;
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    for(auto f : mesh_.faces())
    {
      const auto h = mesh_.halfedge(f);
      const Kernel::Point_3& p = mesh_.point(mesh_.source(h));
      expected += 0.5 * length(CGAL::cross_product(mesh_.point(mesh_.target(h)) - p,
                                                   mesh_.point(mesh_.target(mesh_.next(h))) - p));
    }
    EXPECT_NEAR(area, expected, 1e-9 * expected);
  }

  void check_distances() const
  {
    // distances are to the source, and corners around the vertex beside which it is
    const bool is_beside = u_.is_source_moved && u_.vertices[corner(0).vertex].distance == 0.;
    for(const auto& c : u_.corners)
      EXPECT_NEAR(std::hypot(c.point.x(), c.point.y()), u_.vertices[c.vertex].distance,
                  (is_beside ? 1e-3 : 1e-8) * scale_);
  }

  // around the copies of a vertex is what is around it on the surface
  void check_angles() const
  {
    std::vector<double> sum(u_.vertices.size(), 0.);
    const std::size_t n = u_.corners.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Kernel::Vector_2 a = corner(i + 1).point - corner(i).point, b = corner(i + n - 1).point - corner(i).point;
      const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
      // the end of a branch: nearly a full turn
      sum[corner(i).vertex] += angle <= 0. ? angle + 2. * pi : angle;
      shortest_ = (std::min)(shortest_, edge_length(i));
    }
    for(std::size_t i = 0; i < sum.size(); ++i)
    {
      const Vertex_index v = u_.vertices[i].mesh_vertex;
      const double expected = v != Mesh::null_vertex() ? angles_[v] : is_on_border(u_.vertices[i]) ? pi : 2. * pi;
      EXPECT_NEAR(sum[i], expected, 1e-8 + 1e-14 * scale_ / shortest_) << "vertex " << i;
    }
  }

  bool is_on_border(const Unfolding::Vertex& v) const
  {
    auto h = mesh_.halfedge(v.location.first);
    for(int i = 0; i < 3; ++i, h = mesh_.next(h))
      if(v.location.second[(i + 2) % 3] < 1e-12 && mesh_.is_border(mesh_.opposite(h)))
        return true;
    return false;
  }

  // The parts of an edge are all of it, unless it is on the cut.
  void check_folds() const
  {
    std::vector<double> sum(mesh_.number_of_edges(), 0.);
    for(const auto& f : u_.fold_lines)
      sum[mesh_.edge(f.halfedge)] += std::sqrt(CGAL::squared_distance(f.source, f.target));
    const bool is_cut = u_.vertices[corner(0).vertex].distance == 0.;
    for(auto e : mesh_.edges())
    {
      const auto h = mesh_.halfedge(e);
      const double l = length(mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.source(h)));
      if(mesh_.is_border(e) || (is_cut && sum[e] == 0.))
        EXPECT_EQ(sum[e], 0.);
      else
        EXPECT_NEAR(sum[e], l, 1e-8 * scale_);
    }
    // they are inside: no corner is across
    for(const auto& f : u_.fold_lines)
      for(const auto& p : {f.source, f.target})
        EXPECT_LE(std::hypot(p.x(), p.y()), scale_ * (1. + 1e-9));
  }

  void check_overlap() const
  {
    std::vector<Epick::Point_2> points;
    for(std::size_t i = 0; i < u_.corners.size(); ++i)
    {
      points.push_back({corner(i).point.x(), corner(i).point.y()});
      const auto &p = corner(i).point, &q = corner(i + 1).point;
      EXPECT_GE(p.x() * q.y() - p.y() * q.x(), -1e-12 * scale_ * scale_) << "not star-shaped";
    }
    EXPECT_TRUE(CGAL::is_simple_2(points.begin(), points.end(), Epick()));
  }

  const Mesh& mesh_;
  const Unfolding u_;
  std::vector<double> angles_;
  double scale_ = 0.;
  mutable double shortest_ = 1e300;
};

int check_vertex(const Mesh& mesh, Vertex_index v, const std::string& name)
{
  SCOPED_TRACE(name + ", vertex " + std::to_string(v.idx()));
  const Checked_unfolding u(mesh, v);
  u.check_ends(v);
  if(total_angles(mesh)[v] < 2. * pi - 1e-7)
  {
    EXPECT_EQ(u().corners.front().point, Kernel::Point_2(0., 0.));
    EXPECT_EQ(u().vertices[u().corners.front().vertex].mesh_vertex, v);
    EXPECT_EQ(u().vertices[u().corners[1].vertex].mesh_vertex == Mesh::null_vertex(), false);
  }
  return u().is_source_moved;
}

int check_location(const Mesh& mesh, std::size_t f, const std::array<double, 3>& c, const std::string& name)
{
  const Location location(Mesh::Face_index(static_cast<Mesh::size_type>(f)), c);
  SCOPED_TRACE(name + ", face " + std::to_string(f) + " at " + std::to_string(c[0]) + ' ' + std::to_string(c[1]) + ' ' +
               std::to_string(c[2]));
  const Checked_unfolding u(mesh, location);
  u.check_ends(Mesh::null_vertex());
  return u().is_source_moved;
}

// From most of these points many paths are equally long.
TEST(Source_unfolding, regular_and_divided_polyhedra)
{
  std::vector<std::pair<std::string, Mesh_data>> meshes = {
    {"tetrahedron", convex_hull({{{1., 1., 1.}}, {{1., -1., -1.}}, {{-1., 1., -1.}}, {{-1., -1., 1.}}})},
    {"octahedron", octahedron()},
    {"icosahedron", icosahedron()},
    {"dodecahedron", dodecahedron()}};
  for(int n : {1, 2, 3})
  {
    meshes.push_back({"cube " + std::to_string(n), cube(n)});
    meshes.push_back({"box " + std::to_string(n), cuboid({{3., 1., 0.4}}, n)});
  }
  int number = 0, moved = 0;
  for(const auto& [name, data] : meshes)
  {
    const Mesh mesh = to_surface_mesh(data);
    for(Vertex_index v : mesh.vertices())
      moved += check_vertex(mesh, v, name);
    for(std::size_t f = 0; f < mesh.number_of_faces(); f += name == "dodecahedron" ? 1 : 3)
      for(const Point& c :
          {Point{{0.5, 0.3, 0.2}}, Point{{1. / 3., 1. / 3., 1. / 3.}}, Point{{0.5, 0.5, 0.}}, Point{{0.4, 0., 0.6}}})
      {
        moved += check_location(mesh, f, c, name);
        ++number;
      }
  }
  RecordProperty("locations", number);
  RecordProperty("moved", moved);
}

TEST(Source_unfolding, random_convex_polyhedra)
{
  for(unsigned seed = 1; seed <= 12; ++seed)
  {
    std::vector<Named_surface> meshes = {
      {"sphere", to_surface_mesh(random_convex_polyhedron(8 * seed, seed))},
      {"ellipsoid", to_surface_mesh(random_convex_polyhedron(6 * seed + 10, seed, {{1., 0.6, 0.2}}))},
      {"needle", to_surface_mesh(random_convex_polyhedron(40, seed, {{10., 1., 1.}}))},
      {"ball", to_surface_mesh(hull_of_ball(20 * seed + 10, seed))},
      {"split", to_surface_mesh(split_in_plane(random_convex_polyhedron(4 + seed, seed)))}};
    for(const auto& m : meshes)
    {
      const std::string name = m.first + ' ' + std::to_string(seed);
      for(std::size_t k = 0; k < 4; ++k)
      {
        check_vertex(m.second, Vertex_index(static_cast<Mesh::size_type>(k * m.second.number_of_vertices() / 4)), name);
        check_location(m.second, k * m.second.number_of_faces() / 4, {{0.2, 0.5, 0.3}}, name);
        check_location(m.second, k * m.second.number_of_faces() / 4, {{0.7, 0., 0.3}}, name);
      }
    }
  }
}

TEST(Source_unfolding, large_polyhedra)
{
  const std::vector<Named_surface> meshes = {
    {"sphere", to_surface_mesh(random_convex_polyhedron(2502, 5))},
    {"ellipsoid", to_surface_mesh(random_convex_polyhedron(2502, 7, {{1., 0.8, 0.5}}))},
    {"cube", to_surface_mesh(cube(20))}};
  for(const auto& m : meshes)
  {
    ASSERT_GE(m.second.number_of_faces(), 4800u);
    check_location(m.second, 17, {{0.2, 0.5, 0.3}}, m.first);
    check_location(m.second, 100, {{0.2, 0.5, 0.3}}, m.first);
  }
  check_vertex(to_surface_mesh(random_convex_polyhedron(1002, 6)), Vertex_index(100), "2000 faces");
}

// The boundary has both sides of the cut locus.
TEST(Source_unfolding, is_as_long_as_the_cut_locus)
{
  const Mesh mesh = to_surface_mesh(random_convex_polyhedron(60, 3, {{1., 0.8, 0.5}}));
  const Location location(Mesh::Face_index(7), {{0.2, 0.5, 0.3}});
  const auto cut_locus = compute_cut_locus(mesh, location, by(Polyhedral_method()));
  double sum = 0.;
  const double expected = surface_test::length(cut_locus);
  const Unfolding u = source_unfolding(mesh, location);
  for(std::size_t i = 0; i < u.corners.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(u.corners[i].point, u.corners[(i + 1) % u.corners.size()].point));
  EXPECT_NEAR(sum, 2. * expected, 1e-7 * expected);
}

// From the middle of a face whose diagonal is an edge of the mesh: four arms, as is well known.
TEST(Source_unfolding, cube)
{
  const Mesh mesh = to_surface_mesh(cube(1));
  const Unfolding u = source_unfolding(mesh, Location(Mesh::Face_index(0), {{0.5, 0.5, 0.}}));
  std::vector<int> copies(u.vertices.size(), 0);
  for(const auto& c : u.corners)
    ++copies[c.vertex];
  EXPECT_EQ(u.corners.size(), 16u);
  EXPECT_EQ(u.vertices.size(), 9u);
  EXPECT_EQ(std::count(copies.begin(), copies.end(), 1), 4);
  EXPECT_EQ(std::count(copies.begin(), copies.end(), 2), 4);
  EXPECT_EQ(std::count(copies.begin(), copies.end(), 4), 1);
  double largest = 0.;
  for(const auto& f : u.fold_lines)
  {
    EXPECT_TRUE(std::fabs(f.angle) < 1e-12 || std::fabs(f.angle - 0.5 * pi) < 1e-12);
    largest = (std::max)(largest, f.angle);
  }
  EXPECT_GT(largest, 1.);
}

TEST(Source_unfolding, surfaces_with_border)
{
  // without the faces on one side
  const auto open = [](Mesh_data m, const Point& normal, double height)
  {
    const auto is_on_side = [&](const Triangle& t)
    {
      return std::all_of(t.begin(), t.end(),
                         [&](std::size_t v) { return std::fabs(dot(m.points[v], normal) - height) < 1e-9; });
    };
    m.triangles.erase(std::remove_if(m.triangles.begin(), m.triangles.end(), is_on_side), m.triangles.end());
    return without_isolated_vertices(m);
  };
  const std::vector<Named_surface> meshes = {
    {"open cube", to_surface_mesh(open(cube(1), {{0., 0., 1.}}, 1.))},
    {"open box", to_surface_mesh(open(cuboid({{3., 1., 0.4}}, 2), {{0., 0., 1.}}, 0.4))},
    {"square", to_surface_mesh(square(3, 0.1, 1))},
  };
  for(const auto& m : meshes)
    for(std::size_t f = 0; f < m.second.number_of_faces(); ++f)
    {
      SCOPED_TRACE(m.first + ", face " + std::to_string(f));
      const Checked_unfolding u(m.second,
                                Location(Mesh::Face_index(static_cast<Mesh::size_type>(f)), {{0.5, 0.2, 0.3}}));
      int number = 0;
      for(const auto& c : u().corners)
        number += c.glued_to == Unfolding::no_edge;
      EXPECT_GE(number, 4);
    }
  for(Vertex_index v : meshes[1].second.vertices())
  {
    SCOPED_TRACE(v.idx());
    const Checked_unfolding u(meshes[1].second, v);
  }
}

std::string message(const Mesh& mesh, Vertex_index source)
{
  return message_of([&] { source_unfolding(mesh, source); });
}

TEST(Source_unfolding, refuses_surfaces_on_which_paths_bend)
{
  const Mesh l = to_surface_mesh(l_shape(1));
  const std::string text = message(l, Vertex_index(0));
  expect_has(text, "450 degrees");
  const std::vector<double> angles = total_angles(l);
  const auto saddle = std::find_if(angles.begin(), angles.end(), [](double a) { return a > 2. * pi + 1e-9; });
  expect_has(text, "vertex #" + std::to_string(saddle - angles.begin()) + ' ');

  const Mesh ring = to_surface_mesh(annulus(0.5, 1., 20, 2));
  expect_has(message(ring, Vertex_index(0)), "on the border");
  expect_has(message(to_surface_mesh(torus(2., 1., 20, 12)), Vertex_index(0)), "more than 360");
  expect_has(message(l, Mesh::null_vertex()), "null");
}

TEST(Source_unfolding, takes_the_component_of_the_source)
{
  const Mesh mesh = to_surface_mesh(disjoint_union(l_shape(1), cube(1), {{5., 0., 0.}}));
  const Vertex_index v(static_cast<Mesh::size_type>(mesh.number_of_vertices() - 1));
  const Unfolding u = source_unfolding(mesh, v);
  for(const auto& c : u.vertices)
    EXPECT_GE(c.point.x(), 5.);
  double area = 0.;
  for(std::size_t i = 0; i < u.corners.size(); ++i)
  {
    const auto &p = u.corners[i].point, &q = u.corners[(i + 1) % u.corners.size()].point;
    area += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  EXPECT_NEAR(area, 6., 1e-9);
}

} // namespace

} // namespace test_source_unfolding
