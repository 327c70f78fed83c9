// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_LAYOUT_OVERLAP_H
#define CGAL_CUT_LOCI_FLATTENING_LAYOUT_OVERLAP_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/flattening/Symmetric_dirichlet.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

using Layout_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// exact for the coordinates as they are
inline CGAL::Orientation orientation_in_plane(const Planar_point& p, const Planar_point& q, const Planar_point& r)
{
  using Point = Layout_kernel::Point_2;
  return Layout_kernel().orientation_2_object()(Point(p[0], p[1]), Point(q[0], q[1]), Point(r[0], r[1]));
}

inline Planar_triangle image_of(const Triangle_corners& corners, const Planar_points& plane)
{
  return {{plane[corners[0]], plane[corners[1]], plane[corners[2]]}};
}

inline bool is_flipped(const Planar_triangle& t)
{
  return orientation_in_plane(t[0], t[1], t[2]) != CGAL::LEFT_TURN;
}

// A disk none of whose faces is flipped has no overlap if and only if this holds: each point is covered as often as the
// border winds around it.
inline bool is_simple(const std::vector<Index>& border, const Planar_points& plane)
{
  std::vector<Layout_kernel::Point_2> polygon;
  polygon.reserve(border.size());
  for(const Index v : border)
    polygon.emplace_back(plane[v][0], plane[v][1]);
  return CGAL::is_simple_2(polygon.begin(), polygon.end(), Layout_kernel());
}

// Whether the interiors of two counterclockwise triangles meet: then no line along an edge is between them.
inline bool do_overlap(const Planar_triangle& s, const Planar_triangle& t)
{
  const auto is_separated_by_edge = [](const Planar_triangle& a, const Planar_triangle& b)
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(std::none_of(b.begin(), b.end(),
                      [&](const Planar_point& p)
                      { return orientation_in_plane(a[i], a[(i + 1) % 3], p) == CGAL::LEFT_TURN; }))
        return true;
    return false;
  };
  return !is_separated_by_edge(s, t) && !is_separated_by_edge(t, s);
}

// How many faces have others over or under them. Faces without area have none.
inline std::size_t number_of_overlapping_faces(const std::vector<Triangle_corners>& faces, const Planar_points& plane)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  std::vector<Planar_triangle> images;
  std::vector<Box> boxes;
  for(const Triangle_corners& corners : faces)
  {
    Planar_triangle t = image_of(corners, plane);
    const CGAL::Orientation orientation = orientation_in_plane(t[0], t[1], t[2]);
    if(orientation == CGAL::RIGHT_TURN)
      std::swap(t[1], t[2]);
    images.push_back(t);
    if(orientation == CGAL::COLLINEAR)
      continue;
    std::array<double, 2> low = t[0], high = t[0];
    for(const Planar_point& p : t)
      for(std::size_t i = 0; i < 2; ++i)
      {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    boxes.emplace_back(low.data(), high.data(), images.size() - 1);
  }
  std::vector<bool> overlaps(faces.size(), false);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& a, const Box& b)
                                {
    if((!overlaps[a.info()] || !overlaps[b.info()]) && do_overlap(images[a.info()], images[b.info()]))
      overlaps[a.info()] = overlaps[b.info()] = true;
  });
  return static_cast<std::size_t>(std::count(overlaps.begin(), overlaps.end(), true));
}

// The part of the covered points of a grid that several faces cover.
inline double overlapping_part(const std::vector<Triangle_corners>& faces, const Planar_points& plane)
{
  constexpr int size = 1024; // as a texture would have
  if(faces.empty())
    return 0.;
  Planar_point low = plane[faces.front()[0]], high = low;
  for(const Triangle_corners& corners : faces)
    for(const Index v : corners)
      for(std::size_t i = 0; i < 2; ++i)
      {
        low[i] = (std::min)(low[i], plane[v][i]);
        high[i] = (std::max)(high[i], plane[v][i]);
      }
  const double extent = (std::max)(high[0] - low[0], high[1] - low[1]);
  if(!(extent > 0.))
    return 0.;
  const double scale = size / extent;
  std::vector<unsigned char> count(std::size_t(size) * size, 0);
  for(const Triangle_corners& corners : faces)
  {
    Planar_triangle t = image_of(corners, plane);
    for(Planar_point& p : t)
      for(std::size_t i = 0; i < 2; ++i)
        p[i] = scale * (p[i] - low[i]) - 0.5; // point (i, j) of the grid is at (i, j)
    if(twice_signed_area(t[0], t[1], t[2]) < 0.)
      std::swap(t[1], t[2]);
    const auto x = std::minmax({t[0][0], t[1][0], t[2][0]}), y = std::minmax({t[0][1], t[1][1], t[2][1]});
    for(int j = (std::max)(0, static_cast<int>(std::ceil(y.first))); j <= y.second && j < size; ++j)
      for(int i = (std::max)(0, static_cast<int>(std::ceil(x.first))); i <= x.second && i < size; ++i)
      {
        const Planar_point p = {{double(i), double(j)}};
        unsigned char& c = count[std::size_t(j) * size + i];
        // a point on an edge belongs to no face rather than to two
        if(twice_signed_area(t[0], t[1], p) > 0. && twice_signed_area(t[1], t[2], p) > 0. &&
           twice_signed_area(t[2], t[0], p) > 0.)
          c = static_cast<unsigned char>((std::min)(c + 1, 2));
      }
  }
  const auto covered = std::count_if(count.begin(), count.end(), [](unsigned char c) { return c > 0; });
  return covered == 0 ? 0. : double(std::count(count.begin(), count.end(), 2)) / double(covered);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_LAYOUT_OVERLAP_H
