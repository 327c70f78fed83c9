// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// What is shown by default: limbs and corners however narrow, and the same curve if a polyhedron is divided in its planes,
// turned, or rounded.

#include "surface_test.h"
#include "default_results.h"

namespace test_default_strength {

namespace {

using namespace default_test;
using namespace surface_test;
using namespace CGAL::Cut_loci::internal;

Mesh_data turned(Mesh_data m, unsigned seed)
{
  std::mt19937 engine(seed);
  for(int axis = 0; axis < 3; ++axis)
  {
    const double angle = pi * random_unit(engine), c = std::cos(angle), s = std::sin(angle);
    for(Vector& p : m.points)
    {
      const std::size_t i = axis, j = (axis + 1) % 3;
      const double x = p[i], y = p[j];
      p[i] = c * x - s * y;
      p[j] = s * x + c * y;
    }
  }
  return m;
}

Mesh_data rounded(Mesh_data m, int digits)
{
  const double unit = std::pow(10., -digits);
  for(Vector& p : m.points)
    for(double& x : p)
      x = unit * std::round(x / unit);
  return m;
}

Mesh_data moved(Mesh_data m, double by, unsigned seed)
{
  std::mt19937 engine(seed);
  for(Vector& p : m.points)
    for(double& x : p)
      x += by * random_unit(engine);
  return m;
}

Mesh_data regular_prism(std::size_t n)
{
  return closed_cylinder(n, 1.3, Flat_face::ZIGZAG);
}

Mesh_data tetrahedron()
{
  return {{{{1., 1., 1.}}, {{1., -1., -1.}}, {{-1., 1., -1.}}, {{-1., -1., 1.}}},
          {{{0, 1, 2}}, {{0, 3, 1}}, {{0, 2, 3}}, {{1, 3, 2}}}};
}

std::vector<Named_mesh> polyhedra()
{
  return {{"tetrahedron", tetrahedron()},
          {"cube", cube(1)},
          {"icosahedron", icosahedron()},
          {"box", cuboid({{1., 1.7, 0.6}}, 1)},
          {"triangular prism", regular_prism(3)},
          {"prism of 7 sides", regular_prism(7)},
          {"L-shape", l_shape(1)}};
}

// a ball with limbs along these axes, each one some faces around
Mesh_data with_limbs(std::size_t n, const std::vector<Vector>& axes)
{
  return star_shape(n,
                    [&](const Vector& p)
                    {
    double radius = 1.;
    for(const Vector& a : axes)
      radius += 2. * std::exp(40. * (p[0] * a[0] + p[1] * a[1] + p[2] * a[2] - 1.));
    return radius;
  });
}

struct Shown
{
  double length = 0.;
  std::vector<Vector> tips, nodes;
  Branch_strength least;
};

// above the strength of another mesh, or by default
Shown shown(const Mesh_data& m, const Indexed_source& source, const Branch_strength* strength = nullptr)
{
  const Indexed_triangle_mesh mesh = indexed(m);
  const Solved solved(mesh, source);
  Solved::Thresholds asked = solved.solver->default_thresholds();
  if(strength)
    static_cast<Branch_strength&>(asked) = *strength;
  const Indexed_cut_locus curve = solved.curve(asked, Curve::THROUGH_FACES);
  Shown result;
  result.length = length(mesh, curve);
  for(Index i : leaves(curve))
    result.tips.push_back(position(mesh, curve.nodes[i].location));
  for(const auto& node : curve.nodes)
    result.nodes.push_back(position(mesh, node.location));
  result.least = solved.solver->default_thresholds();
  return result;
}

// from a point that no symmetry maps to itself
Shown shown(const Mesh_data& m)
{
  return shown(m, in_face(static_cast<Index>(m.triangles.size() / 3), 0.21, 0.33, 0.46));
}

double length_of_all(const Mesh_data& m)
{
  const Indexed_triangle_mesh mesh = indexed(m);
  const Solved solved(mesh, in_face(static_cast<Index>(m.triangles.size() / 3), 0.21, 0.33, 0.46));
  return length(mesh, solved.curve(at_least(0., solved), Curve::THROUGH_FACES));
}

TEST(Default_strength, of_polyhedra_of_few_vertices_shows_all)
{
  for(const Named_mesh& m : polyhedra())
  {
    SCOPED_TRACE(m.name);
    EXPECT_NEAR(shown(m.data).length, length_of_all(m.data), 1e-6 * length_of_all(m.data));
  }
}

// Faces are divided in their planes, turned, and written with few digits. Seldom, what is drawn is wrong where vertices are off
// by as little as windows are accurate: then a piece goes out and back along an edge of the mesh.
TEST(Default_strength, of_polyhedra_does_not_depend_on_faces_axes_and_digits)
{
  int number = 0, number_of_wrong = 0;
  for(const Named_mesh& m : polyhedra())
  {
    Mesh_data divided = m.data;
    for(int times = 1; times <= 4; ++times)
    {
      divided = split_in_plane(divided);
      const double length = shown(divided).length;
      EXPECT_NEAR(length, length_of_all(divided), 1e-6 * length);
      for(int digits : {5, 6, 7})
      {
        SCOPED_TRACE(m.name + ", divided " + std::to_string(times) + " times, digits " + std::to_string(digits));
        const double difference = std::fabs(shown(rounded(turned(divided, 3), digits)).length - length);
        EXPECT_LE(difference, 0.02 * length);
        number_of_wrong += difference > 1e-3 * length;
        ++number;
      }
    }
  }
  EXPECT_LE(number_of_wrong, number / 16);
}

Branch_strength scaled(const Branch_strength& strength, double factor)
{
  Branch_strength result = strength;
  for(double* x : {&result.width, &result.narrow, &result.enclosed, &result.spur})
    *x *= factor;
  result.noise = {factor * strength.noise.sigma(), strength.noise.edge(), strength.noise.length()};
  return result;
}

// The noise is estimated from vertices that are neighbors, which are others once faces are divided: thresholds differ by
// little, so that the curve is one between those of a little more and of a little less, and at the same ones nothing does.
TEST(Default_strength, is_that_of_the_surface_however_faces_are_divided_in_their_planes)
{
  for(const Named_mesh& m : {Named_mesh{"bumpy sphere", irregular_bumpy_sphere(12, 0.3, 2)},
                             Named_mesh{"rough sphere", rough(sphere_of_squares(12), 0.1, 4)},
                             Named_mesh{"limbs", with_limbs(10, {{{1., 0., 0.}}, {{0., 0.6, 0.8}}})}})
  {
    const Index source = static_cast<Index>(nearest_vertex(m.data, {{-1., 0.3, 0.2}}));
    const Shown first = shown(m.data, at_vertex(indexed(m.data), source));
    const Branch_strength more = scaled(first.least, 1.05), less = scaled(first.least, 0.95);
    const double shortest = shown(m.data, at_vertex(indexed(m.data), source), &more).length,
                 longest = shown(m.data, at_vertex(indexed(m.data), source), &less).length;
    Mesh_data divided = m.data;
    for(int times = 1; times <= 2; ++times)
    {
      SCOPED_TRACE(m.name + ", divided " + std::to_string(times) + " times");
      divided = split_in_plane(divided);
      const Shown other = shown(divided, at_vertex(indexed(divided), source));
      EXPECT_GE(other.length, (1. - 1e-4) * shortest);
      EXPECT_LE(other.length, (1. + 1e-4) * longest);
      EXPECT_NEAR(other.least.width, first.least.width, 0.05 * first.least.width);
      EXPECT_NEAR(other.least.enclosed, first.least.enclosed, 0.05 * first.least.enclosed);
      const Shown same = shown(divided, at_vertex(indexed(divided), source), &first.least);
      EXPECT_NEAR(same.length, first.length, 1e-4 * first.length);
    }
  }
}

TEST(Default_strength, does_not_depend_on_the_axes)
{
  for(const Named_mesh& m : {Named_mesh{"rough sphere", rough(ellipsoid(1., 0.8, 0.4, 14, 0., 1), 0.1, 4)},
                             Named_mesh{"limbs", with_limbs(10, {{{1., 0., 0.}}, {{0., 0.6, 0.8}}})}})
  {
    const Shown first = shown(m.data);
    for(unsigned seed : {1u, 2u, 3u})
    {
      SCOPED_TRACE(m.name + ", turned " + std::to_string(seed));
      const Shown other = shown(turned(m.data, seed));
      EXPECT_NEAR(other.least.width, first.least.width, 1e-9 * first.least.width);
      EXPECT_NEAR(other.least.enclosed, first.least.enclosed, 1e-9);
      EXPECT_NEAR(other.length, first.length, 1e-6 * first.length);
    }
  }
}

TEST(Default_strength, changes_little_with_little_noise)
{
  std::vector<Named_mesh> meshes = polyhedra();
  meshes.push_back({"divided box", split_in_plane(split_in_plane(cuboid({{1., 1.7, 0.6}}, 2)))});
  meshes.push_back({"limbs", with_limbs(10, {{{1., 0., 0.}}, {{0., 0.6, 0.8}}})});
  meshes.push_back({"rough sphere", rough(sphere_of_squares(12), 0.1, 4)});
  for(const Named_mesh& m : meshes)
  {
    const double length = shown(m.data).length;
    for(unsigned seed : {1u, 2u})
    {
      SCOPED_TRACE(m.name + ", seed " + std::to_string(seed));
      EXPECT_NEAR(shown(moved(m.data, 1e-7, seed)).length, length, 1e-4 * length);
    }
  }
}

// Icosahedra with more and more noise: what is shown gets less, but not at once.
TEST(Default_strength, of_corners_fades)
{
  Mesh_data m = icosahedron();
  for(int i = 0; i < 3; ++i)
    m = split_in_plane(m);
  const double h = mean_edge_length(m), length = shown(m).length;
  for(double noise : {1e-3, 3e-3, 1e-2})
    EXPECT_NEAR(shown(moved(m, noise * h, 1)).length, length, 0.05 * length) << noise;
}

// They are six to eight faces around, narrower than three edges.
TEST(Default_strength, shows_each_limb_of_a_coarse_mesh)
{
  const double s = 1. / std::sqrt(3.);
  const std::vector<Vector> axes = {{{s, s, s}}, {{s, -s, -s}}, {{-s, s, -s}}, {{-s, -s, s}}, {{1., 0., 0.}}};
  for(std::size_t n : {7, 9, 14, 25})
  {
    SCOPED_TRACE(n);
    const Mesh_data m = with_limbs(n, axes);
    const Shown found = shown(m, at_vertex(indexed(m), static_cast<Index>(nearest_vertex(m, {{-1., 0.1, 0.2}}))));
    EXPECT_LE(found.tips.size(), 2 * axes.size()); // the end of a coarse one has two corners or three
    for(const Vector& a : axes)
    {
      double farthest = 0.;
      for(const Vector& p : found.tips)
        if(dot(p, a) > 0.8 * norm(p))
          farthest = (std::max)(farthest, norm(p));
      EXPECT_GT(farthest, 2.) << "along " << a[0] << ", " << a[1] << ", " << a[2];
    }
  }
}

// Around the antipode, where all paths meet, what is enclosed is large, and branches are short.
TEST(Default_strength, of_spheres_is_a_point)
{
  const std::vector<Mesh_data> spheres = {sphere(16), sphere_of_squares(12), sphere(5), jittered_sphere(16, 0.2, 3)};
  for(std::size_t i = 0; i < spheres.size(); ++i)
    for(std::size_t k = 0; k < 5; ++k)
    {
      SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(k));
      const Index v = static_cast<Index>(k * spheres[i].points.size() / 5);
      EXPECT_EQ(shown(spheres[i], at_vertex(indexed(spheres[i]), v)).length, 0.);
    }
}

// The first is up to a hundredth of what it is, and both are those of a piece next to the end.
TEST(Default_strength, is_told_by_the_edges_at_the_tips)
{
  int number_of_narrow = 0;
  for(const Mesh_data& m : {with_limbs(14, {{{1., 0., 0.}}, {{0., 0.6, 0.8}}}), irregular_bumpy_sphere(12, 0.3, 2)})
  {
    const Solved solved(indexed(m), in_face(static_cast<Index>(m.triangles.size() / 3), 0.21, 0.33, 0.46));
    const Branch_strength least = solved.solver->default_thresholds();
    const Indexed_cut_locus curve = solved.through_faces();
    std::vector<int> degree(curve.nodes.size(), 0);
    for(const auto& e : curve.edges)
      for(Index i : {e.source, e.target})
        ++degree[i];
    for(const auto& e : curve.edges)
    {
      if(degree[e.source] > 1 && degree[e.target] > 1)
        continue;
      const bool is_wide = e.width >= 0.98 * least.width;
      EXPECT_TRUE(is_wide || (e.curvature >= 0.98 * least.enclosed && e.width >= 0.98 * least.narrow));
      number_of_narrow += !is_wide;
    }
  }
  EXPECT_GT(number_of_narrow, 0);
}

// A block that is round below, so that a half of its curvature is in four corners.
TEST(Default_strength, shows_each_corner_of_a_part)
{
  for(std::size_t n : {8, 16, 32})
  {
    SCOPED_TRACE(n);
    const Mesh_data m = star_shape(n,
                                   [](const Vector& p)
                                   {
      const double share = p[2] < 0. ? p[2] * p[2] : 0.;
      double largest = 0., sum = 0.;
      for(double x : p)
      {
        largest = (std::max)(largest, std::fabs(x));
        sum += std::pow(x, 4);
      }
      return 1. / ((1. - share) * largest + share * std::pow(sum, 0.25));
    });
    const Shown found = shown(m, at_vertex(indexed(m), static_cast<Index>(nearest_vertex(m, {{0.1, -0.2, -1.}}))));
    for(double x : {-1., 1.})
      for(double y : {-1., 1.})
      {
        double nearest = 10.;
        for(const Vector& p : found.nodes)
          nearest = (std::min)(nearest, norm(p - Vector{{x, y, 1.}}));
        EXPECT_LT(nearest, 1.5 * mean_edge_length(m)) << x << ", " << y;
      }
  }
}

Mesh_data voxels(double a, double b, double c, unsigned seed)
{
  const Mesh_data axes = turned({{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}, {}}, seed);
  const int r = static_cast<int>((std::max)({a, b, c})) + 1;
  std::set<Voxel> inside;
  for(int x = -r; x <= r; ++x)
    for(int y = -r; y <= r; ++y)
      for(int z = -r; z <= r; ++z)
      {
        double sum = 0.;
        for(std::size_t i = 0; i < 3; ++i)
        {
          const Vector& axis = axes.points[i];
          const double t = (axis[0] * (x + 0.1) + axis[1] * (y - 0.2) + axis[2] * (z + 0.3)) / (i == 0   ? a
                                                                                                : i == 1 ? b
                                                                                                         : c);
          sum += t * t;
        }
        if(sum < 1.)
          inside.insert({{x, y, z}});
      }
  return voxel_surface(inside, 1);
}

// Their corners are as sharp as those of a cube, but they are no shape.
TEST(Default_strength, of_voxels_is_that_of_the_shape)
{
  int number = 0;
  for(const Mesh_data& m :
      {voxels(8., 8., 8., 1), voxels(12., 7., 5., 2), voxels(16., 14., 11., 3), voxels(20., 10., 10., 4)})
    for(Index source : {Index(0), static_cast<Index>(m.points.size() / 2)})
    {
      SCOPED_TRACE(number++);
      const Shown found = shown(m, at_vertex(indexed(m), source));
      EXPECT_GE(found.tips.size(), 2u);
      EXPECT_LE(found.tips.size(), 6u);
    }
}

} // namespace

} // namespace test_default_strength
