// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_FILTERS_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_FILTERS_H

#include <CGAL/Cut_loci/geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_windows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Cut_loci::internal {

// Windows at the ends of a list are removed if a path through a vertex is shorter: one along the halfedge from its
// source or target, or one from the vertex `v` behind the halfedge, past which all windows go on the same side.

/// whether a path of length `d` to the point `t` is shorter than the one from the image of the window
template <int columns>
inline bool is_shorter(double d, const Geodesic_window_list& list, std::size_t i, double t)
{
  if(list.is_parallel<columns>(i))
    return d < list.distance<columns>(i, t, 0.);
  const double dx = t - list.column(2)[i], y = list.column(3)[i], rest = d - list.column(4)[i];
  return rest < 0. || rest * rest < dx * dx + y * y;
}

/// the distance of `v` from the point `t` of the halfedge
inline double distance_on_axis(const Plane_point& v, double t)
{
  return std::sqrt((v.x - t) * (v.x - t) + v.y * v.y);
}

/// of the way from `image` to `point`, on the other side of the halfedge, through the point `t` of this
inline double length_through(const Plane_point& image, double t, const Plane_point& point)
{
  return distance_on_axis(image, t) + distance_on_axis(point, t);
}

template <int columns>
inline void filter_begin(Geodesic_window_list& list, double distance_source)
{
  for(; !list.empty(); ++list.begin)
  {
    const double t = list.column(1)[list.begin];
    if(!is_shorter<columns>(distance_source + t, list, list.begin, t))
      return;
  }
}

template <int columns>
inline void filter_begin(Geodesic_window_list& list, double distance_source, double distance_v, const Plane_point& v)
{
  for(; !list.empty(); ++list.begin)
  {
    const double t = list.column(1)[list.begin];
    const double d = (std::min)(distance_source + t, distance_v + distance_on_axis(v, t));
    if(!is_shorter<columns>(d, list, list.begin, t))
      return;
  }
}

template <int columns>
inline void filter_end(Geodesic_window_list& list, double distance_target, double length)
{
  for(; !list.empty(); --list.end)
  {
    const double t = list.column(0)[list.end - 1];
    if(!is_shorter<columns>(distance_target + length - t, list, list.end - 1, t))
      return;
  }
}

template <int columns>
inline void filter_end(Geodesic_window_list& list, double distance_target, double length, double distance_v,
                       const Plane_point& v)
{
  for(; !list.empty(); --list.end)
  {
    const double t = list.column(0)[list.end - 1];
    const double d = (std::min)(distance_target + length - t, distance_v + distance_on_axis(v, t));
    if(!is_shorter<columns>(d, list, list.end - 1, t))
      return;
  }
}

/// removes the windows that are further away than `maximum_distance`
template <int columns>
void filter_distance(Geodesic_window_list& list, double maximum_distance)
{
  std::uint32_t to = list.begin;
  for(std::uint32_t i = list.begin; i < list.end; ++i)
  {
    const Geodesic_window w = list.get<columns>(i);
    if(w.distance((std::min)((std::max)(w.x, w.a), w.b)) <= maximum_distance)
      list.move<columns>(i, to++);
  }
  list.end = to;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_FILTERS_H
