// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Sources that a symmetry of the surface takes to each other have the same radius, whatever rounding does, and where other
// curves are as right, the result says so.

#include "surface_test.h"
#include "checked_curves.h"
#include "node_distances.h"

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/statistics.h>

#include <map>

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

// a body of `n` sides, turned from a profile of radii and heights that starts and ends on the axis
Mesh_data turned(const std::vector<std::array<double, 2>>& profile, std::size_t n)
{
  const double pi = std::acos(-1.);
  const std::size_t last = profile.size() - 1;
  Mesh_data result;
  const auto vertex = [&](std::size_t k, std::size_t i) {
    return k == 0 ? 0 : k == last ? 1 + (last - 1) * n : 1 + (k - 1) * n + i % n;
  };
  result.points.push_back({{0., 0., profile[0][1]}});
  for(std::size_t k = 1; k < last; ++k)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2. * pi * double(i) / double(n);
      result.points.push_back({{profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle), profile[k][1]}});
    }
  result.points.push_back({{0., 0., profile[last][1]}});
  for(std::size_t k = 0; k < last; ++k)
    for(std::size_t i = 0; i < n; ++i)
    {
      if(k > 0)
        result.triangles.push_back({{vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1)}});
      if(k + 1 < last)
        result.triangles.push_back({{vertex(k, i), vertex(k + 1, i + 1), vertex(k + 1, i)}});
    }
  return result;
}

void expect_no_path_is_cut(const std::vector<std::array<double, 2>>& profile, std::size_t n)
{
  const Built built(turned(profile, n));
  Solver solver(built.mesh);
  for(auto v : built.vertices)
  {
    SCOPED_TRACE(std::to_string(n) + " sides, source " + std::to_string(std::size_t(v)));
    solver.set_source(v);
    EXPECT_LT(checked_curves::measured(built.mesh, solver.cut_locus(through_faces)).max, 1e-6);
  }
}

// Families of paths that others part may have the same image there, and leave the source in the same directions.
TEST(Symmetric_sources, on_turned_bodies_cut_no_shortest_path)
{
  for(std::size_t n : {5, 6, 7})
    expect_no_path_is_cut({{{0., 0.}},
                           {{0.5, 0.}},
                           {{1., 0.}},
                           {{1., 0.5}},
                           {{1.75, 0.5}},
                           {{2.5, 0.5}},
                           {{2.5, 1.}},
                           {{2., 1.}},
                           {{1.5, 1.}},
                           {{1.5, 1.5}},
                           {{1.25, 1.5}},
                           {{1., 1.5}},
                           {{1., 2.}},
                           {{0.5, 2.}},
                           {{0., 3.}}},
                          n);
}

// Paths that graze two vertices on a line of symmetry are equally long from every source behind that: no place of the source
// tells them apart.
TEST(Symmetric_sources, whose_paths_are_equally_long_wherever_they_are_cut_none)
{
  const double third = 2. / 3.;
  expect_no_path_is_cut({{{0., 0.}},
                         {{0.75, 0.}},
                         {{1.5, 0.}},
                         {{1.5, third}},
                         {{1.5, 2. * third}},
                         {{1.5, 2.}},
                         {{2., 2.}},
                         {{2.5, 2.}},
                         {{2.5, 2.25}},
                         {{2.5, 2.5}},
                         {{2., 2.5}},
                         {{1.5, 2.5}},
                         {{1.5, 3.5}},
                         {{1.75, 3.5}},
                         {{2., 3.75}},
                         {{2., 4.25}},
                         {{1., 4.25}},
                         {{0., 6.25}}},
                        4);
}

// a grid of n x n squares with a square hole in the middle of each 8 x 8 of them, bent in the middle like a roof
Mesh_data perforated_roof(std::size_t n)
{
  const auto is_hole = [](std::size_t i) { return i % 8 == 3 || i % 8 == 4; };
  Mesh_data result;
  std::map<std::array<std::size_t, 2>, std::size_t> number;
  const auto vertex = [&](std::size_t i, std::size_t j)
  {
    const auto found = number.insert({{{i, j}}, result.points.size()}).first;
    if(found->second == result.points.size())
      result.points.push_back({{double(i), double(j), 0.5 * std::fabs(double(i) - 0.5 * double(n))}});
    return found->second;
  };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      if(!is_hole(i) || !is_hole(j))
      {
        const std::size_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        const bool is_even = (i + j) % 2 == 0;
        result.triangles.push_back({{a, b, is_even ? d : c}});
        result.triangles.push_back({{is_even ? b : a, c, d}});
      }
  return result;
}

// Between rows of holes, paths bend at corners that are in line with each other, on both sides equally often.
// Lengths are changed by some millionths, on ways of up to a hundred edges.
TEST(Symmetric_sources, on_perforated_parts_cut_no_shortest_path)
{
  const Built built(perforated_roof(48));
  Solver solver(built.mesh);
  for(std::size_t source = 0; source < built.vertices.size(); source += 188)
  {
    SCOPED_TRACE(source);
    const std::vector<Mesh::Vertex_index> one = {built.vertices[source]},
                                          two = {one[0], built.vertices[source / 2 + 7]};
    for(const auto& sources : {one, two})
    {
      solver.set_sources(sources);
      EXPECT_LT(checked_curves::measured(built.mesh, solver.cut_locus(through_faces)).max, 1e-4) << sources.size();
    }
  }
}

} // namespace

} // namespace test_symmetric_sources
