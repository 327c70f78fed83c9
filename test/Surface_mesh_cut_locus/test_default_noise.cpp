// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Noise along the normals moves the cut locus a little; with its defaults the method neither loses it nor adds to it.

#include "surface_test.h"
#include "default_results.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace test_default_noise {

namespace {

using namespace default_test;
using namespace surface_test;
using namespace CGAL::Cut_loci::internal;

Indexed_triangle_mesh noisy(const Indexed_triangle_mesh& mesh, double amplitude, unsigned seed)
{
  std::vector<Vector> normals(mesh.points.size(), Vector{{0., 0., 0.}});
  for(const auto& t : mesh.triangles)
    for(Index v : t)
      normals[v] = normals[v] + cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
  const double h = Mesh_connectivity(mesh).mean_edge_length;
  std::mt19937 generator(seed);
  std::normal_distribution<double> random(0., amplitude * h);
  Indexed_triangle_mesh result = mesh;
  for(std::size_t v = 0; v < normals.size(); ++v)
    result.points[v] = mesh.points[v] + (random(generator) / norm(normals[v])) * normals[v];
  return result;
}

Indexed_triangle_mesh ellipsoid(int n)
{
  Indexed_triangle_mesh mesh = indexed(sphere_of_squares(n));
  for(auto& p : mesh.points)
  {
    p[1] *= 0.8;
    p[2] *= 0.6;
  }
  return mesh;
}

// a ball with four limbs, the narrower the larger `sharpness` is
Indexed_triangle_mesh limbs(int n, double sharpness = 15.)
{
  Indexed_triangle_mesh mesh = indexed(sphere_of_squares(n));
  const double s = 1. / std::sqrt(3.);
  for(auto& p : mesh.points)
  {
    double radius = 1.;
    for(const Vector& axis : {Vector{{s, s, s}}, Vector{{s, -s, -s}}, Vector{{-s, s, -s}}, Vector{{-s, -s, s}}})
      radius += 2. * std::exp(sharpness * (dot(p, axis) - 1.));
    p = radius * p;
  }
  return mesh;
}

std::vector<Vector> nodes(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& graph)
{
  std::vector<Vector> result;
  for(const auto& node : graph.nodes)
    result.push_back(position(mesh, node.location));
  return result;
}

// of a point of `from` from the nearest one of `to`, at most
double farthest(const std::vector<Vector>& from, const std::vector<Vector>& to)
{
  double result = 0.;
  for(const Vector& p : from)
  {
    double d = (std::numeric_limits<double>::infinity)();
    for(const Vector& q : to)
      d = (std::min)(d, norm(p - q));
    result = (std::max)(result, d);
  }
  return result;
}

TEST(Default_noise, ellipsoids)
{
  for(int n : {20, 35, 50})
  {
    const Indexed_triangle_mesh smooth = ellipsoid(n);
    for(const Vector& at : {Vector{{0.5, 0.4, 0.45}}, Vector{{0.2, -0.7, 0.1}}, Vector{{-0.6, 0.3, -0.3}}})
    {
      const auto source = at_vertex(smooth, static_cast<Index>(nearest_vertex(smooth.points, at)));
      const Solved reference(smooth, source);
      const double h = reference.solver->connectivity().mean_edge_length;
      const auto true_curve = reference.through_faces();
      const auto truth = nodes(smooth, true_curve);
      const double true_length = length(smooth, true_curve);
      for(double amplitude : {0.03, 0.1, 0.2})
      {
        SCOPED_TRACE(std::to_string(n) + ", noise " + std::to_string(amplitude));
        const Solved solved(noisy(smooth, amplitude, 5), source);
        const auto curve = solved.through_faces();
        const auto found = nodes(solved.mesh, curve);
        EXPECT_LT(farthest(found, truth) / h, 5.) << "a spurious branch";
        // Towards an end, the angle between the paths falls as the square root of the way to it, so that a part at the
        // ends is lost in the noise whatever the edges; not the branch, unless the noise is as wide as the branch.
        if(amplitude < 0.1)
        {
          EXPECT_GT(length(solved.mesh, curve), 0.5 * true_length) << "a lost branch";
        }
      }
    }
  }
}

// What connects a branch to the root decides on it: the root must not be on a branch that noise has made.
// The limbs that the curve reaches out to: three without that of the source.
int number_of_limbs(const Indexed_triangle_mesh& mesh, const Indexed_cut_locus& graph)
{
  std::set<std::array<bool, 3>> result;
  for(const Vector& p : nodes(mesh, graph))
    if(norm(p) > 2.)
      result.insert({{p[0] > 0., p[1] > 0., p[2] > 0.}});
  return static_cast<int>(result.size());
}

TEST(Default_noise, limbs_are_not_taken_for_noise)
{
  const Indexed_triangle_mesh smooth = limbs(50);
  const Index v = static_cast<Index>(nearest_vertex(smooth.points, {{1.7, 1.7, 1.7}}));
  EXPECT_EQ(number_of_limbs(smooth, Solved(smooth, at_vertex(smooth, v)).through_faces()), 3);
  const Indexed_triangle_mesh mesh = noisy(smooth, 0.03, 3);
  EXPECT_EQ(number_of_limbs(mesh, Solved(mesh, at_vertex(mesh, v)).through_faces()), 3);
}

// Paths part where a limb begins: what noise does to them before does not matter. The narrower limbs are five edges thick.
TEST(Default_noise, limbs_of_noisy_bodies)
{
  for(double sharpness : {15., 40.})
  {
    const Indexed_triangle_mesh smooth = limbs(50, sharpness);
    const Index v = static_cast<Index>(nearest_vertex(smooth.points, {{0.58, 0.58, -0.58}}));
    for(double amplitude : {0.03, 0.1, 0.2, 0.3})
      for(unsigned seed = 0; seed < 2; ++seed)
      {
        SCOPED_TRACE("noise " + std::to_string(amplitude) + ", " + std::to_string(seed));
        const Indexed_triangle_mesh mesh = noisy(smooth, amplitude, seed);
        const auto curve = Solved(mesh, at_vertex(mesh, v)).through_faces();
        EXPECT_EQ(number_of_limbs(mesh, curve), 4);
        EXPECT_EQ(leaves(curve).size(), 3u); // on the fourth limb it branches
      }
  }
}

double default_width(const Indexed_triangle_mesh& mesh)
{
  const CGAL::Cut_loci::internal::Exact_tree_solver solver(mesh);
  return solver.default_thresholds().width / solver.connectivity().mean_edge_length;
}

// Whoever has few faces to spend puts a vertex where the shape is: this is no noise.
Indexed_triangle_mesh decimated(const Mesh_data& data, std::size_t number_of_faces)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  namespace SMS = CGAL::Surface_mesh_simplification;
  Mesh mesh = Built_mesh<Mesh>(data).mesh;
  SMS::edge_collapse(mesh, SMS::Count_stop_predicate<Mesh>(number_of_faces * 3 / 2));
  mesh.collect_garbage();
  Mesh_data result;
  for(const auto v : mesh.vertices())
    result.points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.triangles.push_back({{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
  }
  return indexed(result);
}

TEST(Default_noise, limbs_of_coarse_bodies)
{
  for(double sharpness : {25., 40., 60., 80.})
  {
    Mesh_data smooth = sphere_of_squares(40);
    for(auto& p : smooth.points)
    {
      double radius = 1.;
      for(double x : p)
        radius += 2. * std::exp(sharpness * (std::abs(x) - 1.));
      for(double& x : p)
        x *= radius;
    }
    for(std::size_t number_of_faces : {150, 200, 300})
    {
      SCOPED_TRACE(std::to_string(number_of_faces) + ", sharpness " + std::to_string(sharpness));
      const Indexed_triangle_mesh mesh = decimated(smooth, number_of_faces);
      const Index source = static_cast<Index>(nearest_vertex(mesh.points, {{0.58, 0.58, 0.58}}));
      EXPECT_EQ(leaves(Solved(mesh, at_vertex(mesh, source)).through_faces()).size(), 6u);
    }
  }
}

// What is around almost a full turn is a limb, and steps of voxels do not make it one that noise explains.
TEST(Default_noise, limbs_of_voxels)
{
  for(int radius : {2, 4})
  {
    SCOPED_TRACE(radius);
    std::set<Voxel> voxels;
    for(int x = -12; x < 12; ++x)
      for(int y = -12; y < 12; ++y)
        for(int z = -12; z < 40; ++z)
        {
          const double square = (x + 0.5) * (x + 0.5) + (y + 0.5) * (y + 0.5);
          if(square + (z + 0.5) * (z + 0.5) < 144. || (z > 0 && square < radius * radius))
            voxels.insert({{x, y, z}});
        }
    const Indexed_triangle_mesh mesh = indexed(voxel_surface(voxels, 1));
    const Index source = static_cast<Index>(nearest_vertex(mesh.points, {{9., 3., -8.}}));
    const auto curve = Solved(mesh, at_vertex(mesh, source)).through_faces();
    double top = 0.;
    for(const Vector& p : nodes(mesh, curve))
      top = (std::max)(top, p[2]);
    EXPECT_GT(top, 39.);
    EXPECT_LE(leaves(curve).size(), 6u);
  }
}

// Bumps of six edges are shape, at whatever height; the same roughness from vertex to vertex is noise.
TEST(Default_noise, rough_shape_is_no_noise)
{
  const Indexed_triangle_mesh smooth = ellipsoid(40);
  const double h = Mesh_connectivity(smooth).mean_edge_length;
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0., 6.283185307);
  Indexed_triangle_mesh bumpy = smooth;
  for(int wave = 0; wave < 30; ++wave)
  {
    Vector k{{normal(generator), normal(generator), normal(generator)}};
    k = (6.283185307 / (6. * h * norm(k))) * k;
    const double shift = phase(generator);
    for(std::size_t v = 0; v < bumpy.points.size(); ++v)
      bumpy.points[v] = (1. + 0.2 * h * std::sin(dot(k, smooth.points[v]) + shift)) * bumpy.points[v];
  }
  EXPECT_LT(default_width(smooth), 3.2);
  EXPECT_LT(default_width(bumpy), 3.2);
  double last = 3.2;
  for(double amplitude : {0.05, 0.1, 0.2})
  {
    const double width = default_width(noisy(smooth, amplitude, 3));
    EXPECT_GT(width, 1.2 * last) << amplitude;
    last = width;
  }
}

} // namespace

} // namespace test_default_noise
