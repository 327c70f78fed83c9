// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_TRIMMING_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_TRIMMING_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

// The windows of a list are in the order of their rays: where two of them overlap, the rays of the first come from
// further left. The difference of their distances then grows from left to right, so that the first is the better one
// up to one tie, and the second beyond. A window that ends up outside of the order on the halfedge has crossed another
// one; the paths of one of the two behind the crossing are no shortest paths. A list thus stays sorted by both ends
// at the price of a comparison, and a tie has to be found only when a window is about to leave the order; windows may
// overlap until then.

/// lengths on a halfedge below which two points are one, in units of the length of the halfedge: some hundred roundings
constexpr double geodesic_narrow = 1e-13;
/// the same for the ray through a vertex, which has seen the roundings of all faces it crossed; a path that passes a
/// vertex on the wrong side by this much is too short by about its square
constexpr double geodesic_cover = 1e-9;

inline bool is_alive(const Geodesic_window& w, double narrow)
{
  return w.b - w.a > narrow;
}

/// of the distances at the point `t`, which is `way` from the image
inline double slope_at(const Geodesic_window& w, double t, double way)
{
  return w.is_parallel() ? w.way(1.) : (t - w.x) / way;
}

/// the depth below the halfedge at which the path to its point `t` begins
inline double depth_of_image(const Geodesic_window& w, double t)
{
  return w.is_parallel() ? w.distance(t) * w.way(0., -1.) : w.y;
}

/// the point of `[low, high]` up to which `left` is better; `at_low` and `at_high`: how much further it is there
inline double find_tie(const Geodesic_window& left, const Geodesic_window& right, double low, double high,
                       double at_low, double at_high)
{
  if(left.sigma == right.sigma && !left.is_parallel() && !right.is_parallel())
  {
    // the bisector of two points
    const double t =
      ((right.x - left.x) * (right.x + left.x) + (right.y - left.y) * (right.y + left.y)) / (2. * (right.x - left.x));
    if(t >= low && t <= high)
      return t;
  }
  const double accuracy = 1e-15 * (std::fabs(low) + std::fabs(high));
  double t = low - at_low * (high - low) / (at_high - at_low);
  if(!(t > low && t < high))
    t = 0.5 * (low + high);
  double last_step = high - low;
  for(int i = 0; i < 100 && high - low > accuracy; ++i)
  {
    const double dl = left.way(t), dr = right.way(t);
    const double difference = (left.sigma - right.sigma) + (dl - dr);
    if(difference < 0.)
      low = t;
    else
      high = t;
    const double slope = slope_at(left, t, dl) - slope_at(right, t, dr);
    const double previous = t;
    t -= difference / slope;
    if(!(t > low && t < high)) // also if the slope is not a number
      t = 0.5 * (low + high);
    // the steps of Newton's method shrink quadratically: the next one would be about this long
    const double step = std::fabs(t - previous), shrink = step / last_step;
    if(shrink * shrink * step <= accuracy)
      break;
    last_step = step;
  }
  return t;
}

/// ends `left` and starts `right` at their tie; windows that have crossed each other completely lose one of them
inline void resolve_overlap(Geodesic_window& left, Geodesic_window& right)
{
  const double low = (std::max)(left.a, right.a), high = (std::min)(left.b, right.b);
  if(low < high)
  {
    const double at_low = left.distance(low) - right.distance(low),
                 at_high = left.distance(high) - right.distance(high);
    if(at_low >= 0.)
      left.b = low;
    else if(at_high <= 0.)
      right.a = high;
    else
      left.b = right.a = find_tie(left, right, low, high, at_low, at_high);
    return;
  }
  // the outer rays meet below the halfedge, at the depth y; whoever comes there first is better on all crossings
  const double slope_left = left.y < 0. ? (left.x - left.a) / left.y : 0.;
  const double slope_right = right.y < 0. ? (right.x - right.b) / right.y : 0.;
  double y = 0.;
  if(slope_right < slope_left)
    y = (std::max)((left.a - right.b) / (slope_right - slope_left),
                   (std::max)(depth_of_image(left, left.a), depth_of_image(right, right.b)));
  const double x_left = left.a + slope_left * y, x_right = right.b + slope_right * y;
  const double x = 0.5 * (x_left + x_right);
  if(left.distance(x, y) <= right.distance(x, y))
    right.b = right.a;
  else
    left.b = left.a;
}

/// Whether both windows have the same source and touch: a flat vertex between them has parted what belongs together. Ways
/// around both sides of a vertex may have the same image, but start in other directions.
template <int columns>
inline bool are_mergeable(const Geodesic_window& left, const Geodesic_window& right, double length)
{
  constexpr bool has_error_for_turn = columns == 6;
  const double scale = std::fabs(left.x) + std::fabs(left.y) + length;
  const bool is_alike = left.is_parallel() && right.is_parallel()
                          ? std::fabs(left.sigma - right.sigma) <= 1e-12 * (std::fabs(left.sigma) + length)
                          : left.sigma == right.sigma;
  return is_alike && std::fabs(left.x - right.x) <= 1e-12 * scale && std::fabs(left.y - right.y) <= 1e-12 * scale &&
         right.a <= left.b + geodesic_cover * length && left.a <= right.b + geodesic_cover * length &&
         left.origin == right.origin && (has_error_for_turn || std::fabs(left.turn - right.turn) <= 1e-9);
}

/// what becomes of the errors if `w` is joined to a window with the same image
template <int columns>
inline void take_larger_errors(Geodesic_window& joined, const Geodesic_window& w)
{
  if(columns > 7)
    joined.error = (std::max)(joined.error, w.error);
  else
    joined.turn = (std::max)(joined.turn, w.turn); // the same direction, or the error
}

/// restores the order of a list, using its first places as a stack.
template <int columns>
class Geodesic_trimming
{
public:
  /// `strictly`: without any overlap
  Geodesic_trimming(Geodesic_window_list& list, double length, bool strictly)
    : list_(list), length_(length), strictly_(strictly)
  {
  }

  /// the windows before `first` are known to be in order
  void operator()(std::size_t first)
  {
    const double* a = list_.column(0);
    const double* b = list_.column(1);
    top_ = first;
    for(std::size_t i = first, end = list_.end; i < end; ++i)
    {
      if(top_ > list_.begin && is_in_order(a[top_ - 1], b[top_ - 1], a[i], b[i]) &&
         b[i] - a[i] > geodesic_narrow * length_)
      {
        if(top_ != i)
          list_.template move<columns>(i, top_);
        ++top_;
      }
      else
        push(list_.template get<columns>(i), false);
    }
    list_.end = static_cast<std::uint32_t>(top_);
  }

  /// joins two lists: the windows before `first` and those from there on are known to be in order
  void join(std::size_t first)
  {
    const double* a = list_.column(0);
    const double* b = list_.column(1);
    top_ = first;
    for(std::size_t i = first, end = list_.end; i < end; ++i)
    {
      const Geodesic_window w = list_.template get<columns>(i);
      push(w, i == first);
      if(top_ > list_.begin && a[top_ - 1] == w.a && b[top_ - 1] == w.b)
      {
        // it has its place, and so have those that follow it
        if(top_ == i + 1)
          return;
        for(++i; i < end; ++i)
          list_.template move<columns>(i, top_++);
      }
    }
    list_.end = static_cast<std::uint32_t>(top_);
  }

private:
  bool is_in_order(double a, double b, double next_a, double next_b) const
  {
    return strictly_ ? b <= next_a : (a <= next_a && b <= next_b);
  }

  void push(Geodesic_window w, bool merge)
  {
    const double narrow = geodesic_narrow * length_;
    while(is_alive(w, narrow))
    {
      if(top_ == list_.begin)
      {
        list_.template set<columns>(top_++, w);
        return;
      }
      Geodesic_window top = list_.template get<columns>(top_ - 1);
      const bool in_order = is_in_order(top.a, top.b, w.a, w.b);
      if((merge || !in_order) && are_mergeable<columns>(top, w, length_))
      {
        top.a = (std::min)(top.a, w.a);
        top.b = (std::max)(top.b, w.b);
        take_larger_errors<columns>(top, w);
        --top_;
        push(top, false);
        return;
      }
      if(in_order)
      {
        list_.template set<columns>(top_++, w);
        return;
      }
      const double b = top.b;
      resolve_overlap(top, w);
      if(top.b != b)
      {
        // a shorter window may now end before one that precedes it
        --top_;
        push(top, false);
      }
    }
  }

  Geodesic_window_list& list_;
  double length_;
  bool strictly_;
  std::size_t top_ = 0;
};

/// restores the order of the windows of a list, as produced by a step into the next face
template <int columns>
inline void restore_order(Geodesic_window_list& list, double length)
{
  const double* a = list.column(0);
  const double* b = list.column(1);
  const double narrow = geodesic_narrow * length;
  const std::size_t end = list.end;
  std::size_t i = list.begin;
  if(i == end)
    return;
  if(b[i] - a[i] > narrow)
    for(++i; i < end; ++i)
      if(a[i] < a[i - 1] || b[i] < b[i - 1] || !(b[i] - a[i] > narrow))
        break;
  if(i < end)
    Geodesic_trimming<columns>(list, length, false)(i);
}

/// the lower envelope of two lists that are not in any order with respect to each other
template <int columns>
class Geodesic_envelope
{
public:
  /// trims `first` and `second`, and writes their lower envelope to `result`, which needs room for four times as many
  void operator()(Geodesic_window_list& first, Geodesic_window_list& second, Geodesic_window_list& result,
                  double length)
  {
    Geodesic_trimming<columns>(first, length, true)(first.begin);
    Geodesic_trimming<columns>(second, length, true)(second.begin);
    result_ = &result;
    narrow_ = geodesic_narrow * length;
    std::size_t i = first.begin, j = second.begin;
    double position = 0.;
    while(i < first.end || j < second.end)
    {
      if(i == first.end || j == second.end)
      {
        const Geodesic_window w = i < first.end ? first.template get<columns>(i++) : second.template get<columns>(j++);
        emit(w, (std::max)(position, w.a), w.b);
        continue;
      }
      const Geodesic_window v = first.template get<columns>(i), w = second.template get<columns>(j);
      const double v_start = (std::max)(position, v.a), w_start = (std::max)(position, w.a);
      const double start = (std::max)(v_start, w_start), stop = (std::min)(v.b, w.b);
      if(v_start < w_start)
        emit(v, v_start, (std::min)(v.b, w_start));
      else if(w_start < v_start)
        emit(w, w_start, (std::min)(w.b, v_start));
      if(start < stop)
      {
        split(v, w, start, stop);
        position = stop;
      }
      else
        position = (std::min)(v.b <= w.b ? v.b : w.b, start);
      if(v.b <= position)
        ++i;
      if(w.b <= position)
        ++j;
    }
  }

private:
  /// the ties divide the overlap; the difference of the distances has at most one extremum
  void split(const Geodesic_window& v, const Geodesic_window& w, double start, double stop)
  {
    const double depth_v = -v.y, depth_w = -w.y;
    const double extremum = (v.x * depth_w - w.x * depth_v) / (depth_w - depth_v);
    if(extremum > start && extremum < stop)
    {
      split_monotone(v, w, start, extremum);
      split_monotone(v, w, extremum, stop);
    }
    else
      split_monotone(v, w, start, stop);
  }

  void split_monotone(const Geodesic_window& v, const Geodesic_window& w, double start, double stop)
  {
    const double at_start = v.distance(start) - w.distance(start), at_stop = v.distance(stop) - w.distance(stop);
    const bool v_first = at_start <= 0., v_last = at_stop <= 0.;
    if(v_first == v_last)
    {
      emit(v_first ? v : w, start, stop);
      return;
    }
    const double t =
      v_first ? find_tie(v, w, start, stop, at_start, at_stop) : find_tie(w, v, start, stop, -at_start, -at_stop);
    emit(v_first ? v : w, start, t);
    emit(v_first ? w : v, t, stop);
  }

  void emit(Geodesic_window w, double start, double stop)
  {
    if(stop - start <= narrow_)
      return;
    w.a = start;
    w.b = stop;
    if(!result_->empty())
    {
      Geodesic_window last = result_->template get<columns>(result_->end - 1);
      if(last.x == w.x && last.y == w.y && last.sigma == w.sigma && last.origin == w.origin &&
         start - last.b <= narrow_)
      {
        last.b = stop;
        take_larger_errors<columns>(last, w);
        result_->template set<columns>(result_->end - 1, last);
        return;
      }
    }
    result_->template append<columns>(w);
  }

  Geodesic_window_list* result_ = nullptr;
  double narrow_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_TRIMMING_H
