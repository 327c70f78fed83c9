// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "cut_locus_by_hand.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>

namespace test_injectivity_radius {

namespace {

using namespace surface_test;
using CGAL::Cut_loci::injectivity_radius;

// ---- the minimum over a graph

// a graph of given points in the plane, with the distances to the origin
Cut_locus made_of(const std::vector<Kernel::Point_3>& points, const std::vector<std::pair<int, int>>& edges)
{
  Cut_locus::Graph graph;
  for(const Kernel::Point_3& p : points)
  {
    Cut_locus::Vertex v;
    v.point = p;
    v.distance = std::sqrt((p - CGAL::ORIGIN).squared_length());
    add_vertex(v, graph);
  }
  for(const auto& e : edges)
    add_edge(e.first, e.second, Cut_locus::Edge(), graph);
  return cut_locus_by_hand<Cut_locus>(graph);
}

TEST(Injectivity_radius, Is_reached_at_a_vertex_or_within_an_edge)
{
  const auto inside = injectivity_radius(made_of({{-1., 1., 0.}, {3., 1., 0.}, {3., 2., 0.}}, {{1, 2}, {0, 1}}));
  EXPECT_DOUBLE_EQ(inside.distance, 1.);
  EXPECT_NEAR((inside.point - Kernel::Point_3(0., 1., 0.)).squared_length(), 0., 1e-30);
  EXPECT_TRUE(inside.edge);
  EXPECT_EQ(inside.vertex, 0u);

  const auto at_vertex = injectivity_radius(made_of({{1., 1., 0.}, {3., 1., 0.}, {3., 2., 0.}}, {{1, 2}, {0, 1}}));
  EXPECT_DOUBLE_EQ(at_vertex.distance, std::sqrt(2.));
  EXPECT_EQ(at_vertex.point, Kernel::Point_3(1., 1., 0.));
  EXPECT_FALSE(at_vertex.edge);
  EXPECT_EQ(at_vertex.vertex, 0u);

  EXPECT_DOUBLE_EQ(injectivity_radius(made_of({{3., 4., 0.}}, {})).distance, 5.);
  EXPECT_DOUBLE_EQ(injectivity_radius(made_of({{3., 4., 0.}, {3., 4., 0.}}, {{0, 1}})).distance, 5.); // no length
  EXPECT_DOUBLE_EQ(
    CGAL::Cut_loci::compute_statistics(made_of({{-1., 1., 0.}, {3., 1., 0.}}, {{0, 1}})).injectivity_radius, 1.);
  EXPECT_THROW(injectivity_radius(made_of({}, {})), Invalid_input);
}

// ---- closed forms

struct Surface
{
  std::string name;
  double radius;                                // of injectivity
  std::function<Mesh_data(int, unsigned)> make; // with vertices out of place by chance
  Point source;
};

double half_meridian_of_spheroid(double a, double c)
{
  double sum = 0.;
  const int n = 10000;
  for(int i = 0; i < n; ++i)
  {
    const double t = pi * (i + 0.5) / n;
    sum += std::hypot(a * std::cos(t), c * std::sin(t));
  }
  return sum * pi / n;
}

// The distance of the first conjugate point on a meridian from the equator: the first zero of J'' + K J = 0.
double conjugate_distance_on_meridian(double a, double c)
{
  double s = 0., j = 0., dj = 1.;
  const double dt = 1e-5;
  for(double t = 0.5 * dt; j >= 0.; t += dt)
  {
    const double q = a * a * std::sin(t) * std::sin(t) + c * c * std::cos(t) * std::cos(t);
    const double ds = std::sqrt(q) * dt, curvature = c * c / (q * q);
    dj -= curvature * j * ds;
    j += dj * ds;
    s += ds;
  }
  return s;
}

// On the sphere the cut locus is the antipode; on the tori, whose closed geodesics of a meridian are the shortest, half
// of one is the radius, reached inside of a curve. The end of the curve, a conjugate point, is the nearest point for a
// source on the equator of a flat spheroid, at pi c, and of a long one. From a pole, all meridians meet at the other.
const std::vector<Surface>& surfaces()
{
  const auto flat = [](int n, unsigned seed) { return ellipsoid(1., 1., 0.6, 10 * n, 0.15, 3 + seed); };
  const auto elongated = [](int n, unsigned seed) { return ellipsoid(1., 1., 1.5, 10 * n, 0.15, 3 + seed); };
  const auto tube = [](int n, unsigned seed) { return torus(1., 0.4, 50 * n, 20 * n, 0.15, 2 + seed); };
  static const std::vector<Surface> result = {
    {"sphere", pi, [](int n, unsigned seed) { return jittered_sphere(10 * n, 0.15, 1 + seed); }, {{1., 0., 0.}}},
    {"torus, outer equator", 0.4 * pi, tube, {{1.4, 0., 0.}}},
    {"torus, inner equator", 0.4 * pi, tube, {{0.6, 0., 0.}}},
    {"flat spheroid, equator", 0.6 * pi, flat, {{1., 0., 0.}}},
    {"long spheroid, equator", conjugate_distance_on_meridian(1., 1.5), elongated, {{1., 0., 0.}}},
    {"long spheroid, pole", half_meridian_of_spheroid(1., 1.5), elongated, {{0., 0., 1.5}}}};
  return result;
}

bool is_torus(const Surface& surface)
{
  return surface.name.find("torus") == 0;
}

struct Estimate
{
  double error, h; // in the mean over some meshes; h: the mean length of edges
  double first;    // error, of the first mesh
};

// at three resolutions, each twice as fine as the one before
std::vector<Estimate> estimates(const Surface& surface, Method method, bool is_through_faces, unsigned number = 1)
{
  std::vector<Estimate> result;
  for(int n : {1, 2, 4})
  {
    result.push_back({0., 0., 0.});
    for(unsigned seed = 0; seed < number; ++seed)
    {
      const Mesh_data data = surface.make(n, seed);
      const Built built(data);
      Solver solver(built.mesh, by(method));
      solver.set_source(built.vertices[nearest_vertex(data, surface.source)]);
      const auto radius = injectivity_radius(
        solver.cut_locus(params::cut_locus_curve(is_through_faces ? Curve::THROUGH_FACES : Curve::MESH_EDGES)));
      const double error = std::abs(radius.distance - surface.radius);
      result.back().error += error / number;
      if(seed == 0)
        result.back().first = error;
      result.back().h += mean_edge_length(data) / number;
    }
  }
  return result;
}

// A tip is cut where the paths are three edges apart, and edges of the mesh are up to one edge beside the cut locus.
TEST(Injectivity_radius, Is_within_an_edge_by_the_method_of_directions)
{
  for(const Surface& surface : surfaces())
    for(bool is_through_faces : {false, true})
    {
      SCOPED_TRACE(surface.name + (is_through_faces ? ", through faces" : ", edges of the mesh"));
      const std::vector<Estimate> e = estimates(surface, Default_method(), is_through_faces, 4);
      for(const Estimate& estimate : e)
        EXPECT_LT(estimate.first, (is_through_faces ? 0.5 : 1.1) * estimate.h);
      if(is_through_faces)
      {
        EXPECT_LT(e[2].error, (std::max)(0.6 * e[0].error, 0.2 * e[2].h));
      }
    }
}

TEST(Injectivity_radius, Has_an_error_of_second_order_inside_a_curve_through_faces)
{
  for(const Surface& surface : surfaces())
  {
    if(!is_torus(surface))
      continue;
    for(const Estimate& estimate : estimates(surface, Default_method(), true))
      EXPECT_LT(estimate.error, 0.5 * estimate.h * estimate.h) << surface.name;
  }
}

// A branch thins out towards a conjugate point, where the threshold on the angle cuts it off, whatever the resolution:
// the radius is then that of the branch that is left. Around a point where all paths meet, stubs of a few edges remain.
TEST(Injectivity_radius, Converges_by_the_method_of_the_Laplacian_unless_a_threshold_cuts_it_off)
{
  for(const Surface& surface : surfaces())
  {
    if(surface.name == "flat spheroid, equator")
      continue;
    for(bool is_through_faces : {false, true})
      for(const Estimate& estimate : estimates(surface, Laplacian_method(), is_through_faces))
        EXPECT_LT(estimate.error, (is_torus(surface) ? 0.5 : 4.) * estimate.h)
          << surface.name << (is_through_faces ? ", through faces" : ", edges of the mesh");
  }
}

// From a corner of the box 1 x 1 x 2, farthest is not the opposite corner, which is 2 sqrt(2) away, but a point that is a
// quarter beside it.
TEST(Farthest_node, Is_beyond_the_opposite_corner_of_a_box)
{
  for(const int n : {1, 2, 4, 5})
  {
    const Mesh_data data = cuboid({{1., 1., 2.}}, n);
    const Built built(data);
    for(const Method method : {Method(Default_method()), Method(Polyhedral_method())})
    {
      Solver solver(built.mesh, by(method));
      solver.set_source(built.vertices[nearest_vertex(data, {{0., 0., 0.}})]);
      const auto cut_locus = solver.cut_locus(through_faces);
      const auto& farthest = cut_locus.graph()[cut_locus.farthest_node()];
      EXPECT_NEAR(farthest.distance, std::sqrt(130.) / 4., 1e-5) << n;
      EXPECT_NEAR(farthest.point.z(), 2., 1e-5);
      EXPECT_NEAR(farthest.point.x(), 0.75, 1e-5);
      EXPECT_NEAR(farthest.point.y(), 0.75, 1e-5);
      // where all branches are asked for, lengths may be changed by some millionths, and the curve with them
      const double moved = std::holds_alternative<Polyhedral_method>(method) ? 1e-5 : 1e-12;
      EXPECT_LE(cut_locus.distance(cut_locus.farthest_vertex()), farthest.distance + moved);
    }
  }
}

} // namespace

} // namespace test_injectivity_radius
