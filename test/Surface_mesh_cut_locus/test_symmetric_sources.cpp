// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Sources that a symmetry of the surface takes to each other have the same radius, whatever rounding does, and where other
// curves are as right, the result says so.

#include "surface_test.h"
#include "node_distances.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>

namespace test_symmetric_sources {

namespace {

using namespace surface_test;

struct Range
{
  double least = 1e300, most = 0., h = 1.;
  int number_of_several = 0;
  double width() const { return (most - least) / h; }
};

Range radii(const Mesh_data& data, const std::vector<std::size_t>& sources)
{
  const Built built(data);
  Solver solver(built.mesh);
  Range result;
  result.h = mean_edge_length(data);
  for(std::size_t source : sources)
  {
    solver.set_source(built.vertices[source]);
    const auto cut_locus = solver.cut_locus(through_faces);
    const auto statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
    result.least = (std::min)(result.least, statistics.injectivity_radius);
    result.most = (std::max)(result.most, statistics.injectivity_radius);
    result.number_of_several += statistics.is_one_of_several;
    // also where the source has been moved
    EXPECT_LT(curve_measures::node_distance_errors(built.mesh, cut_locus).max, 1e-9) << "source " << source;
  }
  return result;
}

// The sources of a circle of latitude. Opposite to those on the equators, where there are two planes of symmetry, the curve
// follows edges of the mesh, and other ones are as good.
TEST(Symmetric_sources, have_one_radius_on_a_torus)
{
  const struct
  {
    double R, r;
    std::size_t nu, nw;
  } cases[] = {{2., 1., 24, 12}, {2., 0.8, 12, 8}, {2., 1., 30, 10}};
  for(const auto& c : cases)
    for(std::size_t w = 0; w < c.nw; w += c.nw / 4 - 1)
    {
      if(2 * w == c.nw)
        continue;
      std::vector<std::size_t> sources;
      for(std::size_t u = 0; u < c.nu; u += c.nu / 12)
        sources.push_back(u * c.nw + w);
      sources.push_back((c.nu - 1) * c.nw + w);
      const Range range = radii(torus(c.R, c.r, c.nu, c.nw), sources);
      EXPECT_LT(range.width(), 1e-6) << c.nu << " x " << c.nw << ", row " << w;
      EXPECT_EQ(range.number_of_several, int(sources.size())); // paths on both sides are equally long
    }
}

TEST(Symmetric_sources, have_one_radius_on_convex_surfaces_and_no_other_curve_is_as_right)
{
  for(int n : {1, 2, 4})
  {
    const Mesh_data data = cube(n);
    std::vector<std::size_t> corners;
    for(std::size_t v = 0; v < data.points.size(); ++v)
      if(std::all_of(data.points[v].begin(), data.points[v].end(), [](double x) { return x == 0. || x == 1.; }))
        corners.push_back(v);
    ASSERT_EQ(corners.size(), 8u);
    const Range range = radii(data, corners);
    EXPECT_LT(range.width(), 1e-6);
    EXPECT_EQ(range.number_of_several, 0);
  }
}

TEST(Symmetric_sources, are_told_from_others)
{
  const Range irregular = radii(torus(1., 0.4, 24, 12, 0.2, 3), {0, 5, 50, 100});
  EXPECT_EQ(irregular.number_of_several, 0);
  // Behind the saddles of the edge in the middle, paths on both sides are equally long from a point in the plane of symmetry.
  const Mesh_data l = l_shape(2);
  const Range symmetric = radii(l, {nearest_vertex(l.points, {{0., 0., 0.}})});
  EXPECT_EQ(symmetric.number_of_several, 1);
}

} // namespace

} // namespace test_symmetric_sources
