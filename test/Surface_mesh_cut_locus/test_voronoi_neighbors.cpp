// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "surface_test.h"
#include "curve_sources_cases.h"

#include <CGAL/Cut_loci/voronoi_neighbors.h>
#include <CGAL/refine_along_cut_locus.h>

#include <numeric>

// The dual graph of geodesic Voronoi diagrams, and the areas of their cells.

namespace test_voronoi_neighbors {

namespace {

using namespace curve_sources;
using Neighbors = std::vector<CGAL::Cut_loci::Voronoi_neighbors>;

Neighbors neighbors(const Built& built, const Vertices& sources)
{
  return CGAL::Cut_loci::voronoi_neighbors(compute_cut_locus(built.mesh, sources));
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
    const Result cut_locus = compute_cut_locus(built.mesh, sources);
    std::set<std::array<std::size_t, 2>> touching;
    double sum = 0.;
    for(const auto& pair : CGAL::Cut_loci::voronoi_neighbors(cut_locus))
    {
      EXPECT_LT(pair.sources[0], pair.sources[1]);
      EXPECT_LT(pair.sources[1], sources.size());
      EXPECT_TRUE(touching.insert(pair.sources).second);
      sum += pair.length;
    }
    EXPECT_NEAR(sum, length(compute_cut_locus(built.mesh, sources, params::kept_part(Kept_part::VORONOI))), 1e-9);
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
  EXPECT_TRUE(CGAL::Cut_loci::voronoi_neighbors(compute_cut_locus(built.mesh, built.vertices[0])).empty());
}

/// sources in a square whose cells are known polygons: between parallel lines, and in quarters
TEST(Voronoi_cells, of_a_square_have_areas_in_closed_form)
{
  const Built built(square(9, 0.25, 3));
  const auto locations = [&](const std::vector<Point>& points)
  {
    Vertices result;
    for(const Point& p : points)
      result.push_back(built.vertices[nearest_vertex(built.data, p)]);
    return result;
  };
  const Vertices quarters = locations({{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 1., 0.}}, {{0., 1., 0.}}});
  const Result cut_locus = compute_cut_locus(built.mesh, quarters);
  for(const double found : CGAL::Cut_loci::voronoi_cell_areas(built.mesh, cut_locus))
    EXPECT_NEAR(found, 0.25, 1e-6);
}

/// all faces have a source, that of each vertex inside, and the areas are those of the faces, and together of the surface
TEST(Voronoi_cells, divide_random_surfaces)
{
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Built built(seed % 2 ? torus(2., 0.8, 18, 10, 0.2, seed) : irregular_bumpy_sphere(7, 0.3, seed));
    std::mt19937 random(seed);
    std::set<std::size_t> chosen;
    while(chosen.size() < 2 + seed)
      chosen.insert(random() % built.vertices.size());
    Vertices sources;
    for(const std::size_t v : chosen)
      sources.push_back(built.vertices[v]);
    const Result cut_locus = compute_cut_locus(built.mesh, sources);
    Mesh refined;
    auto cell = refined.add_property_map<Mesh::Face_index, std::size_t>("f:cell", 1000).first;
    std::map<Mesh::Face_index, Mesh::Face_index> origin;
    CGAL::refine_along_cut_locus(
      built.mesh, cut_locus, refined,
      params::snapping_tolerance(1. / (1 << 20)).face_to_face_map(boost::make_assoc_property_map(origin)),
      params::face_patch_map(cell));
    std::vector<double> sums(sources.size(), 0.);
    double whole = 0.;
    for(const Mesh::Face_index f : refined.faces())
    {
      ASSERT_LT(cell[f], sources.size());
      sums[cell[f]] += area(refined, f);
    }
    for(const Mesh::Face_index f : built.mesh.faces())
      whole += area(built.mesh, f);
    const std::vector<double> areas = CGAL::Cut_loci::voronoi_cell_areas(built.mesh, cut_locus);
    ASSERT_EQ(areas.size(), sources.size());
    for(std::size_t i = 0; i < areas.size(); ++i)
    {
      EXPECT_GT(areas[i], 0.);
      EXPECT_NEAR(areas[i], sums[i], 1e-9 * whole);
    }
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.), whole, 1e-10 * whole);
    // at a source, and in most of the faces by the exact distances of their centroids, the cell is that of the nearest source
    Geodesics geodesics(refined);
    for(const Mesh::Face_index f : refined.faces())
      geodesics.add_query({f, {{1. / 3., 1. / 3., 1. / 3.}}});
    for(const Mesh::Vertex_index v : sources)
      geodesics.add_source(*std::min_element(refined.vertices().begin(), refined.vertices().end(),
                                             [&](auto a, auto b) {
        return CGAL::has_smaller_distance_to_point(built.mesh.point(v), refined.point(a), refined.point(b));
      }));
    geodesics.compute();
    double wrong = 0.;
    for(const Mesh::Face_index f : refined.faces())
      if(geodesics.nearest_source(Geodesics::Query{f.idx()}) != cell[f])
        wrong += area(refined, f);
    EXPECT_LT(wrong, 1e-4 * whole); // chords of the curves in faces
  }
}

/// of one source, the cell is all of its component; of others, no face is in any
TEST(Voronoi_cells, of_one_point_are_its_component)
{
  const Built built(two_tori());
  const Result cut_locus = compute_cut_locus(built.mesh, built.vertices[0]);
  Mesh refined;
  auto cell = refined.add_property_map<Mesh::Face_index, std::size_t>("f:cell", 1000).first;
  CGAL::refine_along_cut_locus(built.mesh, cut_locus, refined, params::default_values(), params::face_patch_map(cell));
  double inside = 0., outside = 0.;
  for(const Mesh::Face_index f : refined.faces())
  {
    EXPECT_TRUE(cell[f] == 0 || cell[f] == CGAL::Cut_loci::no_source);
    (cell[f] == 0 ? inside : outside) += area(refined, f);
  }
  EXPECT_GT(outside, 0.);
  const std::vector<double> areas = CGAL::Cut_loci::voronoi_cell_areas(built.mesh, cut_locus);
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(areas[0], inside, 1e-9 * inside);
}

} // namespace

} // namespace test_voronoi_neighbors
