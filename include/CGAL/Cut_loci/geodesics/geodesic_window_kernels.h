// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_KERNELS_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_KERNELS_H

#include <CGAL/Cut_loci/geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_windows.h>

#include <cstddef>

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

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_WINDOW_KERNELS_H
