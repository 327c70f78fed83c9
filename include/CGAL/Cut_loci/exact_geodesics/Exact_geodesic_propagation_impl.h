// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
#define CGAL_CUT_LOCI_EXACT_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/exact_geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_batches.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_merging.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_windows.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_window_filters.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

CGAL_CUT_LOCI_INLINE void Exact_geodesic_propagation::run(const std::vector<Indexed_location>& sources,
                                                          const Exact_geodesic_options& options,
                                                          Geodesic_window_observer* observer)
{
  start(sources, options);
  observer_ = observer;
  if(has_directions_ && is_approximate())
    propagate<9>();
  else if(has_directions_ || sources_.size() > 1)
    propagate<7>();
  else if(is_approximate())
    propagate<6>();
  else
    propagate<5>();
}

inline void Exact_geodesic_propagation::start(const std::vector<Indexed_location>& sources,
                                              const Exact_geodesic_options& options)
{
  if(sources.empty())
    throw Invalid_input(Cause::NO_SOURCE, "no source");
  prepare(sources, options);
  batches_.prepare(options.maximum_distance);
  slim_edges_.clear();
  maximum_distance_ = options.maximum_distance;
  tolerance_ = options.maximum_relative_error;
  merging_angle_ = options.merging_angle;
  number_of_windows_ = 0;
  beside_.clear();
  progress_ = options.progress;
  next_report_ = progress_.is_wanted() ? 0 : (std::numeric_limits<std::size_t>::max)();
}

template <int columns>
inline void Exact_geodesic_propagation::propagate()
{
  for(std::size_t i = 0; i < sources_.size(); ++i)
    if(sources_[i].vertex != null_index)
      start_at_vertex<columns>(i);
    else if(sources_[i].line == null_index)
      start_in_face<columns>(i);
  for(std::size_t i = 0; i < sources_.size(); ++i)
    if(sources_[i].line != null_index)
      start_at_line<columns>(i);
  do
  {
    Index item;
    while(batches_.pop(item))
    {
      prefetch(batches_.peek(6), batches_.peek(3));
      if(number_of_windows_ >= next_report_)
        report_progress();
      if(item < faces_.number_of_halfedges())
      {
        if(observer_ != nullptr)
          observer_->advance(batches_.key());
        cross_face<columns>(item);
      }
      else
        bend<columns>(item - faces_.number_of_halfedges());
    }
  } while(reach_beside_windows());
  finish_queries();
  if(maximum_distance_ < infinity)
    cut_off(maximum_distance_);
  if(!has_turns())
    add_errors();
}

// -- sources -------------------------------------------------------------------------------------------------------

template <int columns>
inline void Exact_geodesic_propagation::start_at_vertex(std::size_t number)
{
  const Index v = sources_[number].vertex;
  if(distance_[v] == 0.)
    return;
  distance_[v] = 0.;
  arrival_[v] = Geodesic_arrival();
  arrival_[v].halfedge = faces_.first_halfedge(v);
  arrival_[v].origin = static_cast<Index>(number);
  // On lines, only between their outer rays. The margin is for the rounding of these, as at a bend: it is that of a longer
  // way, from the image of the line. What is in the margin are paths as well, but not the shortest.
  constexpr double margin = 1e-6;
  const std::array<double, 2> fan =
    is_on_line(v) ? Geodesic_results::fan(v) : std::array<double, 2>{{-infinity, infinity}};
  const Index first = faces_.first_halfedge(v);
  double angle = 0.;
  Index h = first;
  do
  {
    Geodesic_arrival start;
    start.turn = has_turns() ? angle : 0.;
    start.origin = static_cast<Index>(number);
    const double width = faces_.angle(h), from = (std::max)(0., fan[0] - margin - angle),
                 to = (std::min)(width, fan[1] + margin - angle);
    if(from < to)
      emit<columns>(h, from, to, start);
    angle += width;
    h = faces_.next_around_source(h);
  } while(h != null_index && h != first);
}

/// as if windows from behind the border had come to its halfedge
template <int columns>
inline void Exact_geodesic_propagation::start_at_line(std::size_t number)
{
  const Index source = static_cast<Index>(number), h = line_halfedge(source);
  const Plane_point image = line_image(source);
  batches_.insert<columns>(h, {0., faces_.length(h), image.x, image.y, -line_distance(), 0., double(number)},
                           faces_.length(h));
}

/// for sources on edges and in faces
template <int columns>
inline void Exact_geodesic_propagation::start_in_face(std::size_t number)
{
  const Source& source = sources_[number];
  const Index f = source.location.face;
  if(source.halfedge == null_index)
  {
    start_in_face<columns>(number, 3 * f, faces_.in_frame(3 * f, source.location.coordinates), 0., null_index);
    return;
  }
  const Index h = source.halfedge, o = faces_.opposite(h);
  const double t = source.location.coordinates[Mesh::next(h) % 3] * faces_.length(h);
  start_in_face<columns>(number, h, {t, 0.}, 0., h);
  if(o != null_index)
    start_in_face<columns>(number, o, {faces_.length(h) - t, 0.}, geodesic_pi, o);
}

/// starts across all halfedges but `skipped` of the face of `h`, in whose frame the source is given
template <int columns>
inline void Exact_geodesic_propagation::start_in_face(std::size_t number, Index h, const Plane_point& p, double turn,
                                                      Index skipped)
{
  Geodesic_arrival arrival;
  arrival.x = p.x;
  arrival.y = p.y;
  arrival.turn = has_turns() ? turn : 0.;
  arrival.halfedge = h;
  arrival.origin = static_cast<Index>(number);
  const std::array<Plane_point, 3> corner = {{{0., 0.}, {faces_.length(h), 0.}, faces_.apex(h)}};
  double rotation = 0.;
  Index g = h;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Plane_point &from = corner[i], &to = corner[(i + 1) % 3];
    reach(faces_.source(g), std::hypot(from.x - p.x, from.y - p.y), arrival);
    const Index o = faces_.opposite(g);
    if(g != skipped && (o != null_index || observer_ != nullptr))
    {
      // the frame of the opposite halfedge starts at `to`
      const double length = faces_.length(g);
      const double ux = (from.x - to.x) / length, uy = (from.y - to.y) / length;
      const double dx = p.x - to.x, dy = p.y - to.y;
      const double depth = dy * ux - dx * uy;
      Geodesic_window w{0., length, dx * ux + dy * uy, (std::min)(depth, 0.), 0., 0., double(number)};
      if(has_turns())
        w.turn = turn + rotation - geodesic_pi;
      if(sources_.size() > 1 && o != null_index)
        batches_.mark_inner_source(o);
      send<columns>(g, w);
    }
    rotation += geodesic_pi - faces_.angle(Mesh::next(g));
    g = Mesh::next(g);
  }
}

/// sends the paths through the corner at the source of `h` with angles in `[from, to]` into the next face
template <int columns>
inline void Exact_geodesic_propagation::emit(Index h, double from, double to, Geodesic_arrival start)
{
  const Geodesic_face& face = faces_.face_of(h);
  const Index next = Mesh::next(h), v = faces_.source(h);
  const Geodesic_face::Corner& here = face.corner[h % 3];
  const Geodesic_face::Corner& right = face.corner[next % 3];
  const Geodesic_face::Corner& left = face.corner[Mesh::previous(h) % 3];
  start.halfedge = h;
  const bool starts_at_edge = from <= 0., ends_at_edge = to >= here.angle;
  if(starts_at_edge)
    reach(faces_.target(h), distance_[v] + here.length, start);
  if(ends_at_edge)
    reach(faces_.source(Mesh::previous(h)), distance_[v] + left.length, start);
  if(faces_.opposite(next) == null_index && observer_ == nullptr)
    return;
  Geodesic_window w;
  w.a = ends_at_edge ? 0. : right.length - here.length * std::sin(to) / std::sin(to + right.angle);
  w.b = starts_at_edge ? right.length : right.length - here.length * std::sin(from) / std::sin(from + right.angle);
  w.a = (std::max)(w.a, 0.);
  w.b = (std::min)(w.b, right.length);
  if(!(w.b - w.a > geodesic_narrow * right.length))
    return;
  w.x = left.length * left.cosine;
  w.y = -left.length * left.sine;
  w.sigma = start.sigma;
  w.turn = has_turns() ? start.turn - start.rate * right.angle : start.turn;
  w.origin = double(start.origin);
  w.rate = start.rate;
  w.error = start.error;
  send<columns>(next, w);
}

/// hands a window that leaves the face of `g` to the opposite of `g`, in whose frame it is given
template <int columns>
inline void Exact_geodesic_propagation::send(Index g, const Geodesic_window& w)
{
  const Index o = faces_.opposite(g);
  if(o != null_index)
  {
    batches_.insert<columns>(o, w, faces_.length(o));
    return;
  }
  Geodesic_window_list* list = batches_.allocate<columns>(1);
  list->append<columns>(w);
  observer_->take_on_border(g, list);
}

/// the same for a list of windows; `side` and `key` as for `Geodesic_batches::store()`
template <int columns>
inline void Exact_geodesic_propagation::send(Index g, std::size_t side, Geodesic_window_list* list, double key)
{
  if(faces_.opposite(g) != null_index)
    batches_.store<columns>(faces_.opposite(g), side, list, faces_.length(g), key);
  else if(list->empty())
    batches_.release(list);
  else
    observer_->take_on_border(g, list);
}

/// continues the shortest path to `v`, at which it may bend, into its shadow
template <int columns>
inline void Exact_geodesic_propagation::bend(Index v)
{
  const double sigma = distance_[v];
  if(sigma == 0. || sigma > maximum_distance_)
    return;
  const Geodesic_arrival_direction in = arrival_direction(v);
  Geodesic_arrival start = from_vertex(v);
  const bool is_turned = has_turns() && is_origin(v);
  if(columns > 5 && is_turned)
    bends_[v] = {direction_at_source(v), source_of(arrival_[v]), arrival_[v].origin,
                 direction_at_origin(arrival_[v], end_in_frame(arrival_[v], v))};
  // a shadow that is wider by the accuracy of the angle only adds a few paths that are not the shortest
  constexpr double margin = 1e-9;
  const bool is_border = faces_.is_border(v);
  const double first = geodesic_pi - margin;
  const double last = is_border ? infinity : faces_.total_angle(v) - geodesic_pi + margin;
  double angle = -in.angle;
  Index h = in.halfedge;
  do
  {
    const double width = faces_.angle(h);
    if(is_turned)
      start.turn = angle;
    if(angle + width > first && angle < last)
      emit<columns>(h, first - angle, (std::min)(last - angle, width), start);
    angle += width;
    h = faces_.next_around_source(h);
  } while(h != null_index && angle < last);
  if(!is_border)
    return;
  angle = faces_.angle(in.halfedge) - in.angle;
  h = in.halfedge;
  while(h != null_index)
  {
    const double width = faces_.angle(h);
    angle -= width;
    if(is_turned)
      start.turn = angle;
    if(angle < -first)
      emit<columns>(h, 0., (std::min)(-first - angle, width), start);
    h = faces_.previous_around_source(h);
  }
}

/// a path of length `d` to the vertex `v` has been found
inline void Exact_geodesic_propagation::reach(Index v, double d, const Geodesic_arrival& arrival)
{
  if(improve(v, d, arrival) && faces_.is_pseudo_source(v))
    batches_.push_vertex(d, v);
}

template <int columns>
inline void Exact_geodesic_propagation::note_path_beside(Index v, const Plane_point& apex, Index h,
                                                         const Geodesic_window_list& list, std::size_t i, double t)
{
  const Plane_point image{list.column(2)[i], list.column(3)[i]};
  const double d = distance_on_axis(image, t) + distance_on_axis(apex, t);
  // the accuracy of windows; what bends by more than its root is in a shadow
  if(d > (1. + geodesic_cover) * std::hypot(apex.x - image.x, apex.y - image.y))
    return;
  const Geodesic_window w = list.get<columns>(i);
  beside_.push_back(
    {v, w.sigma + d, {w.x, w.y, w.sigma, w.turn, h, static_cast<Index>(w.origin), true, w.rate, w.error}});
}

inline bool Exact_geodesic_propagation::reach_beside_windows()
{
  std::sort(beside_.begin(), beside_.end(),
            [](const Path_beside& p, const Path_beside& q) { return p.distance < q.distance; });
  bool result = false;
  for(const Path_beside& path : beside_)
    if(!is_reached(path.vertex))
    {
      reach(path.vertex, path.distance, path.arrival);
      result = true;
    }
  beside_.clear();
  return result;
}

inline void Exact_geodesic_propagation::report_progress()
{
  // one or two milliseconds, and so nothing beside them for the look at a sample of the vertices
  constexpr std::size_t windows = std::size_t(1) << 16, sample = 256;
  next_report_ = number_of_windows_ + windows;
  const std::size_t step = 1 + distance_.size() / sample;
  std::size_t number = 0, reached = 0;
  for(std::size_t v = 0; v < distance_.size(); v += step)
  {
    ++number;
    reached += distance_[v] < infinity;
  }
  progress_(static_cast<double>(reached) / static_cast<double>(number));
}

// -- propagation ---------------------------------------------------------------------------------------------------

inline void Exact_geodesic_propagation::prefetch(Index far, Index near) const
{
  if(far < faces_.number_of_halfedges())
  {
    batches_.prefetch_lists(far);
#if defined(__GNUC__)
    const char* face = reinterpret_cast<const char*>(&faces_.face_of(far));
    __builtin_prefetch(face);
    __builtin_prefetch(face + 64);
#endif
  }
  if(near < faces_.number_of_halfedges())
  {
    batches_.prefetch_windows(near);
#if defined(__GNUC__)
    const Geodesic_face& face = faces_.face_of(near);
    __builtin_prefetch(&distance_[face.vertex[0]]);
    __builtin_prefetch(&distance_[face.vertex[1]]);
    __builtin_prefetch(&distance_[face.vertex[2]]);
#endif
  }
}

/// takes the windows of `h` across the face of `h`
template <int columns>
inline void Exact_geodesic_propagation::cross_face(Index h)
{
  Geodesic_window_list* list = batches_.collect<columns>(h, faces_.length(h));
  if(!slim_edges_.empty() && !is_approximate() && !list->empty())
    slim_edges_.trim<columns>(h, *list);
  if(list->empty())
  {
    batches_.release(list);
    return;
  }
  const Geodesic_face& face = faces_.face_of(h);
  if(columns > 5 && is_approximate() && list->size() > 1)
    Geodesic_merging<columns>(*list, faces_.length(h), tolerance_, merging_angle_)();
  number_of_windows_ += list->size();
  const bool is_kept = observer_ != nullptr && faces_.opposite(h) != null_index && observer_->take(h, *list);
  constexpr std::array<Index, 5> modulo_3 = {{0, 1, 2, 0, 1}}; // a condition here would be hard to predict
  const Index i = h % 3, j = modulo_3[i + 1], k = modulo_3[i + 2];
  const Geodesic_face::Corner &corner_a = face.corner[i], &corner_b = face.corner[j];
  const double length = corner_a.length, length_left = face.corner[k].length, length_right = corner_b.length;
  const Plane_point apex{length_left * corner_a.cosine, length_left * corner_a.sine};

  const bool turns = has_turns();

  if(has_queries())
    answer_queries<columns>(h, *list);

  // the first windows pass the apex on its left, the last ones on its right; those in between need a closer look
  const std::size_t begin = list->begin, end = list->end;
  const double tolerance = geodesic_cover * length;
  const double *a = list->column(0), *b = list->column(1), *x = list->column(2), *y = list->column(3);
  std::size_t first = begin, last = end;
  while(first < last && side_of_rays(a[first], b[first], x[first], y[first], apex, tolerance) == passes_left)
    ++first;
  while(first < last &&
        side_of_rays(a[last - 1], b[last - 1], x[last - 1], y[last - 1], apex, tolerance) == passes_right)
    --last;
  if(last - first > sides_.size())
    sides_.resize(2 * (last - first));
  std::size_t winner = end, first_right = last, behind_left = first;
  double shortest = infinity;
  for(std::size_t w = first; w < last; ++w)
  {
    const Geodesic_side side = side_of_rays(a[w], b[w], x[w], y[w], apex, tolerance);
    sides_[w - first] = static_cast<unsigned char>(side);
    if(side == covers)
    {
      const double dx = apex.x - x[w], dy = apex.y - y[w];
      const double d = list->column(4)[w] + std::sqrt(dx * dx + dy * dy);
      if(d < shortest)
      {
        shortest = d;
        winner = w;
      }
    }
    else if(side == passes_left)
      behind_left = w + 1;
    else if(first_right == last)
      first_right = w;
  }
  const Index vertex_a = face.vertex[i], vertex_b = face.vertex[j], vertex_c = face.vertex[k];
  if(winner != end && shortest < distance_[vertex_c])
  {
    reach(vertex_c, shortest, end_of(list->get<columns>(winner), h));
  }
  if(winner == end && !is_reached(vertex_c))
  {
    if(behind_left > begin)
      note_path_beside<columns>(vertex_c, apex, h, *list, behind_left - 1, b[behind_left - 1]);
    if(first_right < end)
      note_path_beside<columns>(vertex_c, apex, h, *list, first_right, a[first_right]);
  }
  const double distance_a = distance_[vertex_a], distance_b = distance_[vertex_b];
  const double distance_c =
    (std::min)(distance_[vertex_c], (std::min)(distance_a + length_left, distance_b + length_right));

  // the windows that cover the apex go to their side of the winner only
  const bool is_sorted = first == last || (behind_left <= winner && winner < first_right);
  std::size_t number_left, number_right;
  if(first == last)
  {
    number_left = first - begin;
    number_right = end - last;
  }
  else if(is_sorted)
  {
    number_left = winner + 1 - begin;
    number_right = end - winner;
  }
  else
  {
    number_left = first - begin;
    number_right = end - last;
    for(std::size_t w = first; w < last; ++w)
    {
      number_left += goes_left(w, first, winner);
      number_right += goes_right(w, first, winner);
    }
  }
  if((face.opposite[k] != null_index || observer_ != nullptr) && number_left > 0)
  {
    Geodesic_window_list* out = batches_.allocate<columns>(number_left);
    const Geodesic_step step{length, length_left, corner_a.cosine, corner_a.sine, turns ? corner_a.angle : 0.};
    if(is_sorted)
      step_left<columns>(*list, begin, number_left, *out, step);
    else
    {
      step_left<columns>(*list, begin, first - begin, *out, step);
      for(std::size_t w = first; w < last; ++w)
        if(goes_left(w, first, winner))
          step_left<columns>(*list, w, 1, *out, step);
    }
    restore_order<columns>(*out, length_left);
    const Plane_point b_in_frame{length * corner_a.cosine, -length * corner_a.sine};
    filter_begin(*out, distance_a);
    filter_end(*out, distance_c, length_left, distance_b, b_in_frame);
    send<columns>(h - i + k, 0, out, (std::min)(distance_a, distance_c));
  }
  if((face.opposite[j] != null_index || observer_ != nullptr) && number_right > 0)
  {
    Geodesic_window_list* out = batches_.allocate<columns>(number_right);
    const Geodesic_step step{length, length_right, corner_b.cosine, corner_b.sine, turns ? -corner_b.angle : 0.};
    if(is_sorted)
      step_right<columns>(*list, end - number_right, number_right, *out, step);
    else
    {
      for(std::size_t w = first; w < last; ++w)
        if(goes_right(w, first, winner))
          step_right<columns>(*list, w, 1, *out, step);
      step_right<columns>(*list, last, end - last, *out, step);
    }
    restore_order<columns>(*out, length_right);
    const Plane_point a_in_frame{length_right - length * corner_b.cosine, -length * corner_b.sine};
    filter_begin(*out, distance_c, distance_a, a_in_frame);
    filter_end(*out, distance_b, length_right);
    send<columns>(h - i + j, 2, out, (std::min)(distance_b, distance_c));
  }
  if(!is_kept)
    batches_.release(list);
}

inline bool Exact_geodesic_propagation::goes_left(std::size_t w, std::size_t first, std::size_t winner) const
{
  const unsigned char side = sides_[w - first];
  return side == passes_left || (side == covers && w <= winner);
}

inline bool Exact_geodesic_propagation::goes_right(std::size_t w, std::size_t first, std::size_t winner) const
{
  const unsigned char side = sides_[w - first];
  return side == passes_right || (side == covers && w >= winner);
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
