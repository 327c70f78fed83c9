// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_KERNELS_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_KERNELS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

// tells the compiler that the columns of a window list do not overlap, so that it vectorises the loop
#if defined(__clang__)
#define CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(enable)")
#elif defined(__GNUC__)
#define CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS
#endif

namespace CGAL::Cut_loci::internal {

/// is a step from a halfedge across its face: the corner at the common vertex and the edge reached.
struct Geodesic_step
{
  double base;             // length of the halfedge
  double length;           // length of the edge reached
  double cosine, sine;     // of the corner
  double turn;             // rotation of the frame
  bool has_parallel_paths; // among the windows
};

/// stands in for a denominator that is not negative; what is divided by it is beyond every edge. The division must not
/// depend on a condition, or compilers do not vectorise it.
constexpr double geodesic_away = -1e-250;

/// the part of a step that both edges have in common: the columns for directions; the windows are appended then
template <int columns>
inline void step_turns(const Geodesic_window_list& in, std::size_t first, std::size_t n, Geodesic_window_list& out,
                       double turn)
{
  const std::size_t ci = in.capacity, co = out.capacity, pairs = (n + 1) / 2;
  const double* p = in.column(0) + first;
  double* q = out.column(0) + out.end;
  if(columns > 5)
  {
    CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS
    for(std::size_t i = 0; i < 2 * pairs; ++i)
      q[i + 5 * co] = columns > 7 ? p[i + 5 * ci] + p[i + 7 * ci] * turn : p[i + 5 * ci] + turn;
  }
  for(std::size_t k = 6; k < columns; ++k)
    for(std::size_t i = 0; i < 2 * pairs; ++i)
      q[i + k * co] = p[i + k * ci];
  out.end += static_cast<std::uint32_t>(n);
}

/// appends to `out` what `n` windows from `first` on become behind the edge from the apex to the source of the halfedge;
/// nothing is left of those whose image is not behind that edge: rounding alone has led their rays there
template <int columns>
inline void step_left(const Geodesic_window_list& in, std::size_t first, std::size_t n, Geodesic_window_list& out,
                      const Geodesic_step& step)
{
  const std::size_t ci = in.capacity, co = out.capacity;
  const std::size_t pairs = (n + 1) / 2; // lists have room for one more
  const double* p = in.column(0) + first;
  double* q = out.column(0) + out.end;
  const double length = step.length, c = step.cosine, s = step.sine;
  CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS
  for(std::size_t i = 0; i < 2 * pairs; ++i)
  {
    const double a = p[i], b = p[i + ci], x = p[i + 2 * ci], y = p[i + 3 * ci];
    const double yc = y * c;
    const double da = (a - x) * s + yc, db = (b - x) * s + yc;
    // a ray that leads away from the edge, or passes the apex on the other side, ends the window at the apex
    const double ta = a * y / (da < geodesic_away ? da : geodesic_away);
    const double tb = b * y / (db < geodesic_away ? db : geodesic_away);
    const double depth = yc - x * s;
    const double begin = ta < length ? ta : length, end = tb < length ? tb : length;
    q[i] = begin;
    q[i + co] = depth < 0. ? end : begin;
    q[i + 2 * co] = x * c + y * s;
    q[i + 3 * co] = depth;
    q[i + 4 * co] = p[i + 4 * ci];
  }
  step_turns<columns>(in, first, n, out, step.turn);
}

/// the same behind the edge from the target of the halfedge to the apex: the mirror image
template <int columns>
inline void step_right(const Geodesic_window_list& in, std::size_t first, std::size_t n, Geodesic_window_list& out,
                       const Geodesic_step& step)
{
  const std::size_t ci = in.capacity, co = out.capacity;
  const std::size_t pairs = (n + 1) / 2; // lists have room for one more
  const double* p = in.column(0) + first;
  double* q = out.column(0) + out.end;
  const double base = step.base, length = step.length, c = step.cosine, s = step.sine;
  CGAL_CUT_LOCI_INDEPENDENT_ITERATIONS
  for(std::size_t i = 0; i < 2 * pairs; ++i)
  {
    const double a = p[i], b = p[i + ci], x = p[i + 2 * ci], y = p[i + 3 * ci];
    const double yc = y * c, from_target = base - x;
    const double da = (x - a) * s + yc, db = (x - b) * s + yc;
    const double ta = (base - a) * y / (da < geodesic_away ? da : geodesic_away);
    const double tb = (base - b) * y / (db < geodesic_away ? db : geodesic_away);
    const double depth = yc - from_target * s;
    const double begin = length - (ta < length ? ta : length), end = length - (tb < length ? tb : length);
    q[i] = begin;
    q[i + co] = depth < 0. ? end : begin;
    q[i + 2 * co] = length - (from_target * c + y * s);
    q[i + 3 * co] = depth;
    q[i + 4 * co] = p[i + 4 * ci];
  }
  if(columns == 7 && step.has_parallel_paths)
    for(std::size_t i = 0; i < n; ++i)
      if(in.is_parallel<columns>(first + i)) // the apex is the origin now
        q[i + 4 * co] = in.distance<columns>(first + i, base - length * c, length * s);
  step_turns<columns>(in, first, n, out, step.turn);
}

enum Geodesic_side {
  passes_left, // all rays of the window leave the point on their right
  covers,
  passes_right
};

/// on which side of a point above the halfedge the rays of a window pass
inline Geodesic_side side_of_rays(double a, double b, double x, double y, const Plane_point& point, double tolerance)
{
  // so that nothing is lost if the image is far away
  const double end = b + tolerance, begin = a - tolerance;
  if((end - x) * point.y + (point.x - end) * y < 0.)
    return passes_left;
  return (begin - x) * point.y + (point.x - begin) * y > 0. ? passes_right : covers;
}

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

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_KERNELS_H
