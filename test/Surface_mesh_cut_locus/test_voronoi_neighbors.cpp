// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "curve_sources_cases.h"

#include <CGAL/Cut_loci/voronoi_neighbors.h>
#include <CGAL/compute_cut_locus.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

// The dual graph of geodesic Voronoi diagrams.

namespace test_voronoi_neighbors {

namespace {

using namespace curve_sources;
using Neighbors = std::vector<CGAL::Cut_loci::Voronoi_neighbors>;

Neighbors neighbors(const Built& built, const Vertices& sources)
{
  return CGAL::Cut_loci::voronoi_neighbors(CGAL::compute_cut_locus(built.mesh, sources));
}

/// four corners of a square, whose cells touch along lines of half of its side, and in its middle
TEST(Voronoi_neighbors, of_a_square)
{
  const Built built(square(8));
  Vertices corners;
  for(const Point& p : {Point{{0., 0., 0.}}, Point{{1., 0., 0.}}, Point{{1., 1., 0.}}, Point{{0., 1., 0.}}})
    corners.push_back(built.vertices[nearest_vertex(built.data, p)]);
  std::map<std::array<std::size_t, 2>, double> found;
  for(const auto& pair : neighbors(built, corners))
    found[pair.sources] = pair.length;
  for(const std::array<std::size_t, 2>& sides : {std::array<std::size_t, 2>{{0, 1}}, {{1, 2}}, {{2, 3}}, {{0, 3}}})
    EXPECT_NEAR(found[sides], 0.5, 1e-6) << sides[0] << ' ' << sides[1];
  for(const auto& pair : found)
    EXPECT_TRUE(pair.second > 0.4 || pair.second < 1e-4); // where four cells meet, rounding may part them
}

/// edges of the mesh lead from a cell to one that touches it, up to what lies between vertices; all the curve is told
TEST(Voronoi_neighbors, are_the_cells_on_both_sides)
{
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(seed % 2 ? torus(2., 0.8, 24, 14, 0.2, seed) : irregular_bumpy_sphere(10, 0.3, seed));
    std::mt19937 random(seed);
    std::set<std::size_t> chosen;
    while(chosen.size() < 7)
      chosen.insert(random() % built.vertices.size());
    Vertices sources;
    for(const std::size_t v : chosen)
      sources.push_back(built.vertices[v]);
    const Result cut_locus = CGAL::compute_cut_locus(built.mesh, sources);
    std::set<std::array<std::size_t, 2>> touching;
    double sum = 0.;
    for(const auto& pair : CGAL::Cut_loci::voronoi_neighbors(cut_locus))
    {
      EXPECT_LT(pair.sources[0], pair.sources[1]);
      EXPECT_LT(pair.sources[1], sources.size());
      EXPECT_TRUE(touching.insert(pair.sources).second);
      sum += pair.length;
    }
    EXPECT_NEAR(sum, length(CGAL::compute_cut_locus(built.mesh, sources, params::voronoi(true))), 1e-9);
    // two cells that are met along an edge of the mesh without a third one in between touch
    for(const Mesh::Edge_index e : built.mesh.edges())
    {
      const auto a = cut_locus.nearest_source(built.mesh.vertex(e, 0)),
                 b = cut_locus.nearest_source(built.mesh.vertex(e, 1));
      ASSERT_TRUE(a && b);
      std::set<std::size_t> around = {*a, *b};
      for(int i = 0; i < 2; ++i)
        for(const Mesh::Vertex_index v : built.mesh.vertices_around_target(built.mesh.halfedge(e, i)))
          around.insert(*cut_locus.nearest_source(v));
      if(*a != *b && around.size() == 2)
      {
        EXPECT_EQ(touching.count({{std::min(*a, *b), std::max(*a, *b)}}), 1u);
      }
    }
  }
}

TEST(Voronoi_neighbors, of_one_point_are_none)
{
  const Built built(torus(2., 0.8, 24, 14));
  EXPECT_TRUE(CGAL::Cut_loci::voronoi_neighbors(CGAL::compute_cut_locus(built.mesh, built.vertices[0])).empty());
}

} // namespace

} // namespace test_voronoi_neighbors
