// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The forest of a distance, good or bad, leaves room for a tree of all vertices and 2g edges more.

#include "Union_find.h"
#include "test_meshes.h"

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/ways/Straight_waves.h>
#include <CGAL/Graph_geodesic_solver.h>
#include <CGAL/Cut_loci/ways/Way_forest.h>
#include <CGAL/Cut_loci/laplacian/homology.h>
#include <CGAL/Cut_loci/laplacian/region_growing_tree.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_way_forest {

namespace {

using namespace CGAL::Cut_loci;
using Mesh = CGAL::Cut_loci::Indexed_triangle_mesh;

std::vector<unsigned char> edges_crossed_by_ways(const Mesh& mesh, const Mesh_connectivity& connectivity,
                                                 const std::vector<double>& distance, const Source_roots& roots)
{
  internal::Way_forest forest(mesh, connectivity, roots, distance);
  forest.grow({});
  return forest.ways([](Index) { return true; }).is_crossed;
}

void expect_room(const Mesh& mesh, const std::vector<double>& distance, const Indexed_source& source)
{
  const Mesh_connectivity connectivity(mesh);
  const Source_roots roots(mesh, connectivity, {source});
  const std::vector<unsigned char> crossed = edges_crossed_by_ways(mesh, connectivity, distance, roots);
  curve_measures::Union_find faces(mesh.number_of_faces());
  for(Index e = 0; e < crossed.size(); ++e)
    if(crossed[e])
    {
      const Index h = connectivity.halfedge_of_edge[e];
      ASSERT_FALSE(mesh.is_border_edge(h));
      EXPECT_TRUE(faces.unite(h / 3, mesh.opposite[h] / 3)) << "the faces and crossings are a forest";
    }

  std::vector<float> key(mesh.number_of_vertices());
  std::mt19937 engine(1);
  for(float& k : key)
    k = static_cast<float>(engine() / 4294967296.);
  Index root = 0;
  while(root == source.vertex)
    ++root;
  const Spanning_tree tree = region_growing_tree(connectivity, key, root, roots.elements(), crossed);
  EXPECT_EQ(tree.order.size(), mesh.number_of_vertices());
  for(Index v : tree.order)
    if(v != tree.root)
    {
      const Index e = connectivity.ring_edge(tree.parent_entry[v]);
      EXPECT_FALSE(crossed[e]);
    }
  const std::vector<Index> generators = homology_generators(mesh, connectivity, tree, distance, roots, crossed);
  EXPECT_EQ(generators.size(), 2u * connectivity.genus(mesh));
  for(Index h : generators)
    EXPECT_FALSE(crossed[connectivity.edge_of_halfedge[h]]);
}

TEST(Way_forest, leaves_a_tree_and_generators)
{
  std::mt19937 engine(7);
  for(const Mesh& mesh :
      {test_meshes::indexed(test_meshes::sphere_of_squares(6)), test_meshes::indexed(test_meshes::hilly_sphere(10)),
       test_meshes::indexed(test_meshes::torus_with_shifted_rows(24, 10)),
       test_meshes::indexed(test_meshes::grid(9, 7)), test_meshes::indexed(test_meshes::needles(6))})
    for(int i = 0; i < 6; ++i)
    {
      Indexed_source source;
      source.location.face = static_cast<Index>(engine() % mesh.number_of_faces());
      if(i % 3 == 0) // a vertex
      {
        source.location.coordinates = {{1., 0., 0.}};
        source.vertex = mesh.triangles[source.location.face][0];
      }
      else if(i % 3 == 1) // an edge
        source.location.coordinates = {{0.3, 0.7, 0.}};
      else
        source.location.coordinates = {{0.2, 0.3, 0.5}};
      SCOPED_TRACE(i);
      internal::Exact_geodesic_propagation exact(mesh);
      exact.run({source.location});
      std::vector<double> distance = exact.distances();
      expect_room(mesh, distance, source);
      for(double& d : distance) // with pits all over
        d += 0.5 * (engine() / 4294967296.);
      expect_room(mesh, distance, source);
      for(double& d : distance) // and with plateaus
        d = static_cast<double>(engine() % 3);
      expect_room(mesh, distance, source);
    }
}

// the largest distance from a vertex, if no edges may be crossed but those given, less that with all
double longest_detour(const Mesh& mesh, const Mesh_connectivity& connectivity, Index source,
                      const std::vector<double>& distance, const std::vector<unsigned char>& crossed)
{
  Seams seams(mesh.number_of_halfedges(), 0);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!crossed[connectivity.edge_of_halfedge[h]])
      add_seam(mesh, h, seams);
  const Cut_mesh cut = cut_open(mesh, seams);
  std::vector<Indexed_location> copies;
  std::vector<bool> is_done(cut.mesh.number_of_vertices(), false);
  for(Index h = 0; h < cut.mesh.number_of_halfedges(); ++h)
    if(const Index v = cut.mesh.source(h); !is_done[v] && cut.vertices[v] == source)
    {
      is_done[v] = true;
      copies.push_back(internal::location_on(h));
    }
  internal::Exact_geodesic_propagation exact(cut.mesh);
  internal::Exact_geodesic_options options;
  options.owners.assign(copies.size(), 0);
  exact.run(copies, options);
  std::vector<double> least(mesh.number_of_vertices(), (std::numeric_limits<double>::infinity)());
  for(Index v = 0; v < cut.mesh.number_of_vertices(); ++v)
    least[cut.vertices[v]] = (std::min)(least[cut.vertices[v]], exact.distance(v));
  double result = 0.;
  for(Index v = 0; v < least.size(); ++v)
    result = (std::max)(result, least[v] - distance[v]);
  return result;
}

// the same for the forest of the exact distances from a vertex, in mean edge lengths
double longest_detour_from(Index v, const Mesh& mesh)
{
  const Mesh_connectivity connectivity(mesh);
  const Indexed_source source = test_meshes::at_vertex(mesh, v);
  internal::Exact_geodesic_propagation exact(mesh);
  exact.run({source.location});
  const std::vector<double> distance = exact.distances();
  const Source_roots roots(mesh, connectivity, {source});
  expect_room(mesh, distance, source);
  const auto crossed = edges_crossed_by_ways(mesh, connectivity, distance, roots);
  return longest_detour(mesh, connectivity, v, distance, crossed) / connectivity.mean_edge_length;
}

// Shortest paths to different sides of a vertex cross the same edges of a fan before they part. Where older ones went, and
// most of them, is not where the others have to go. What is longer by a mean edge is left as it is, and no path may become
// longer by another one for others; without a look at how long they become, some do.
TEST(Way_forest, leads_paths_through_fans_of_slim_faces)
{
  for(const std::vector<std::size_t>& numbers : {std::vector<std::size_t>{3, 40}, std::vector<std::size_t>{4, 40},
                                                 std::vector<std::size_t>{5, 61, 17}, std::vector<std::size_t>{6, 90}})
    for(const Index v : {7, 30, 50, 71, 100})
    {
      SCOPED_TRACE(std::to_string(numbers.back()) + " vertices, source " + std::to_string(v));
      EXPECT_LT(longest_detour_from(v, test_meshes::indexed(test_meshes::torus_of_rings(numbers))), 2.);
    }
}

// Shortest paths to several vertices pass the same slim faces and part there. One of them at most can have those; to the
// others, a way along an edge is hardly longer. Led along paths of their own alone, some stay longer by two mean edges.
TEST(Way_forest, leads_ways_along_edges_beside_fans)
{
  const Mesh mesh = test_meshes::indexed(test_meshes::torus_of_rings({4, 7, 33, 120}));
  for(Index v = 0; v < mesh.number_of_vertices(); v += 12)
  {
    SCOPED_TRACE(v);
    EXPECT_LT(longest_detour_from(v, mesh), 1.5);
  }
}

// Where all edges at a vertex are longer than its distance, that rises along them, and the way to it passes slim faces whose far
// corners come late. No way starts there but at the source.
TEST(Way_forest, comes_from_the_source_where_edges_are_long)
{
  test_meshes::Mesh_data data;
  data.points = {{0., 0., 0.},  {-4., .1, 0.},  {0., -5., 0.}, {4., .1, 0.}, {-30., .3, 0.},
                 {30., .5, 0.}, {-4., .62, 0.}, {4., .8, 0.},  {0., 1., 0.}, {0., 6., 0.}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 4}, {4, 3, 5},
                    {4, 5, 6}, {6, 5, 7}, {6, 7, 8}, {7, 9, 8}, {9, 6, 8}};
  const Mesh mesh = test_meshes::indexed(data);
  const Mesh_connectivity connectivity(mesh);
  const Indexed_source source = test_meshes::at_vertex(mesh, 0);
  internal::Exact_geodesic_propagation exact(mesh);
  exact.run({source.location});
  EXPECT_NEAR(exact.distance(8), 1., 1e-12);
  const Source_roots roots(mesh, connectivity, {source});
  internal::Way_forest forest(mesh, connectivity, roots, exact.distances());
  forest.grow({});
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    EXPECT_EQ(forest.starts_at(v), v < 4) << v;
}

// The mean error of the lengths of ways that approximate distances lead to, and of the same straightened, in mean edge lengths.
std::array<double, 2> errors_of_ways(const Mesh& mesh, Index v)
{
  const Mesh_connectivity connectivity(mesh);
  const Indexed_source source = test_meshes::at_vertex(mesh, v);
  internal::Exact_geodesic_propagation exact(mesh);
  exact.run({source.location});
  CGAL::Graph_geodesic_solver graph;
  graph.set_mesh(mesh);
  std::vector<double> distance;
  graph.compute_distances({source}, distance);
  const Source_roots roots(mesh, connectivity, {source});
  internal::Way_forest forest(mesh, connectivity, roots, distance);
  forest.grow({});
  const std::vector<double> lengths = forest.lengths();
  std::vector<double> straightened = lengths, before(lengths.size(), internal::Straight_waves::infinity());
  for(Index w = 0; w < lengths.size(); ++w)
    if(forest.starts_at(w))
      before[w] = 0.;
  internal::Straight_waves(mesh, connectivity, before, straightened).straighten();
  std::array<double, 2> result = {{0., 0.}};
  for(Index w = 0; w < lengths.size(); ++w)
  {
    EXPECT_LE(straightened[w], lengths[w]);
    result[0] += std::abs(lengths[w] - exact.distance(w));
    result[1] += std::abs(straightened[w] - exact.distance(w));
  }
  for(double& r : result)
    r /= static_cast<double>(lengths.size()) * connectivity.mean_edge_length;
  return result;
}

// On coarser meshes ways are as good: what circles err by is the curvature of the surface.
TEST(Straight_waves, shorten_ways_that_bend_as_their_faces_do)
{
  for(const Mesh& mesh : {test_meshes::indexed(test_meshes::irregular_bumpy_sphere(80, 0.1, 3)),
                          test_meshes::indexed(test_meshes::torus(1., 0.4, 240, 80, 0.2, 5)),
                          test_meshes::indexed(test_meshes::jittered_sphere(80, 0.15, 3))})
  {
    const std::array<double, 2> error = errors_of_ways(mesh, 7);
    EXPECT_LT(error[1], 0.8 * error[0]);
    EXPECT_LT(error[1], 0.1);
  }
}

// In the plane waves are circles.
TEST(Straight_waves, are_circles_in_the_plane)
{
  const std::array<double, 2> error = errors_of_ways(test_meshes::indexed(test_meshes::square(80, 0.2, 3)), 3000);
  EXPECT_GT(error[0], 0.1);
  EXPECT_LT(error[1], 1e-3);
}

} // namespace

} // namespace test_way_forest
