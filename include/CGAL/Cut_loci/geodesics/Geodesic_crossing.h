// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_CROSSING_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_CROSSING_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_queries.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_starts.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_merging.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_slim_edges.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/// takes windows across faces.
class Geodesic_crossing : public Geodesic_starts
{
protected:
  /// the face of a halfedge, as windows see it that cross it from there
  struct Crossing
  {
    Index halfedge, left,
      right; // `left` leads from the apex to the source of `halfedge`, `right` from its target there
    Index source, target, apex_vertex;
    Plane_point apex;
    Geodesic_step to_left, to_right;
  };

  /// which windows of a list pass the apex on its left, cover it or pass it on its right. The first ones pass it on its left,
  /// the last ones on its right; those in `[first, last)` need a closer look.
  struct Apex_view
  {
    std::size_t first, last;
    std::size_t behind_left, first_right; // behind the last that passes on the left; the first that does on the right
    std::size_t winner;                   // has the shortest path to the apex, or is the end of the list
    double shortest;
    std::size_t number_left, number_right; // of the windows that go on to these edges
    bool is_sorted; // whether those on the left come before the winner, those on the right behind it
  };

  explicit Geodesic_crossing(std::shared_ptr<const Geodesic_faces> faces)
    : Geodesic_starts(std::move(faces)), slim_edges_(faces_)
  {
  }

  /// notes the path by the window `i` to its end `t` and from there to the apex, if it is straight up to rounding: it counts
  /// if no window covers the apex, or only those of longer paths
  template <int columns>
  void note_path_beside(const Crossing& crossing, const Geodesic_window_list& list, std::size_t i, double t)
  {
    const Plane_point& apex = crossing.apex;
    const Geodesic_window w = list.get<columns>(i);
    const double d = w.way(t) + distance_on_axis(apex, t), straight = w.way(apex.x, apex.y);
    // the accuracy of windows; what bends by more than its root is in a shadow
    if(d - straight > geodesic_cover * (straight + (w.is_parallel() ? w.sigma : 0.)))
      return;
    note({crossing.apex_vertex, w.sigma + d, end_of(w, crossing.halfedge)});
  }

  /// takes the windows of `h` across the face of `h`
  template <int columns>
  void cross_face(Index h)
  {
    Geodesic_window_list* list = batches_.collect<columns>(h, faces_.length(h));
    if(!slim_edges_.empty() && !is_approximate() && !list->empty())
      slim_edges_.trim<columns>(h, *list);
    if(list->empty())
    {
      batches_.release(list);
      return;
    }
    if(columns > 5 && is_approximate() && list->size() > 1)
      Geodesic_merging<columns>(*list, faces_.length(h), tolerance_, merging_angle())();
    number_of_windows_ += list->size();
    const bool is_kept = observer_ != nullptr && faces_.opposite(h) != null_index && observer_->take(h, *list);
    if(has_queries())
      answer_queries<columns>(h, *list);
    if(windows_ != nullptr)
      for(std::size_t i = list->begin; i < list->end; ++i)
        windows_->push_back({h, list->is_parallel<columns>(i), list->column(0)[i], list->column(1)[i],
                             list->column(2)[i], list->column(3)[i], list->column(4)[i]});
    const Crossing crossing = crossing_of(h);
    const Apex_view view = look_at_apex<columns>(*list, crossing);
    reach_apex<columns>(*list, crossing, view);
    if((faces_.opposite(crossing.left) != null_index || observer_ != nullptr) && view.number_left > 0)
      go_left<columns>(*list, crossing, view);
    if((faces_.opposite(crossing.right) != null_index || observer_ != nullptr) && view.number_right > 0)
      go_right<columns>(*list, crossing, view);
    if(!is_kept)
      batches_.release(list);
  }

  Crossing crossing_of(Index h) const
  {
    const Geodesic_face& face = faces_.face_of(h);
    constexpr std::array<Index, 5> modulo_3 = {{0, 1, 2, 0, 1}}; // a condition here would be hard to predict
    const Index i = h % 3, j = modulo_3[i + 1], k = modulo_3[i + 2];
    const Geodesic_face::Corner &corner_a = face.corner[i], &corner_b = face.corner[j];
    const double length = corner_a.length, length_left = face.corner[k].length, length_right = corner_b.length;
    const bool turns = has_turns();
    return {h,
            h - i + k,
            h - i + j,
            face.vertex[i],
            face.vertex[j],
            face.vertex[k],
            {length_left * corner_a.cosine, length_left * corner_a.sine},
            {length, length_left, corner_a.cosine, corner_a.sine, turns ? corner_a.angle : 0., has_parallel_waves()},
            {length, length_right, corner_b.cosine, corner_b.sine, turns ? -corner_b.angle : 0., has_parallel_waves()}};
  }

  template <int columns>
  Apex_view look_at_apex(const Geodesic_window_list& list, const Crossing& crossing)
  {
    const Plane_point& apex = crossing.apex;
    const double tolerance = geodesic_cover * crossing.to_left.base;
    const double *a = list.column(0), *b = list.column(1), *x = list.column(2), *y = list.column(3);
    std::size_t first = list.begin, last = list.end;
    while(first < last && side_of_rays(a[first], b[first], x[first], y[first], apex, tolerance) == passes_left)
      ++first;
    while(first < last &&
          side_of_rays(a[last - 1], b[last - 1], x[last - 1], y[last - 1], apex, tolerance) == passes_right)
      --last;
    if(last - first > sides_.size())
      sides_.resize(2 * (last - first));
    Apex_view view{first, last, first, last, list.end, infinity, 0, 0, false};
    for(std::size_t w = first; w < last; ++w)
    {
      const Geodesic_side side = side_of_rays(a[w], b[w], x[w], y[w], apex, tolerance);
      sides_[w - first] = static_cast<unsigned char>(side);
      if(side == covers)
      {
        const double d = list.distance<columns>(w, apex.x, apex.y);
        if(d < view.shortest)
        {
          view.shortest = d;
          view.winner = w;
        }
      }
      else if(side == passes_left)
        view.behind_left = w + 1;
      else if(view.first_right == last)
        view.first_right = w;
    }
    // the windows that cover the apex go to their side of the winner only
    view.is_sorted = first == last || (view.behind_left <= view.winner && view.winner < view.first_right);
    view.number_left = first - list.begin;
    view.number_right = list.end - last;
    if(first != last && view.is_sorted)
    {
      view.number_left = view.winner + 1 - list.begin;
      view.number_right = list.end - view.winner;
    }
    else
      for(std::size_t w = first; w < last; ++w)
      {
        view.number_left += goes_left(w, view);
        view.number_right += goes_right(w, view);
      }
    return view;
  }

  template <int columns>
  void reach_apex(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view)
  {
    const Index v = crossing.apex_vertex;
    if(view.winner != list.end)
    {
      if(view.shortest < distance_[v])
        reach(v, view.shortest, end_of(list.get<columns>(view.winner), crossing.halfedge));
      if(counts_paths() && view.shortest < (1. + equal_lengths) * distance_[v])
        reach_as_soon<columns>(list, crossing, view);
    }
    else
    {
      if(view.behind_left > list.begin)
        note_path_beside<columns>(crossing, list, view.behind_left - 1, list.column(1)[view.behind_left - 1]);
      if(view.first_right < list.end)
        note_path_beside<columns>(crossing, list, view.first_right, list.column(0)[view.first_right]);
    }
  }

  /// paths to the apex that are as long as the shortest one
  template <int columns>
  void reach_as_soon(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view)
  {
    const Index v = crossing.apex_vertex;
    for(std::size_t w = view.first; w < view.last; ++w)
      if(sides_[w - view.first] == covers)
      {
        const double d =
          list.column(4)[w] + std::hypot(crossing.apex.x - list.column(2)[w], crossing.apex.y - list.column(3)[w]);
        if(d < (1. + equal_lengths) * distance_[v])
          reach(v, d, end_of(list.get<columns>(w), crossing.halfedge));
      }
  }

  /// an upper bound of the distance of the apex
  double bound_at_apex(const Crossing& c) const
  {
    return (std::min)(distance_[c.apex_vertex],
                      (std::min)(distance_[c.source] + c.to_left.length, distance_[c.target] + c.to_right.length));
  }

  template <int columns>
  void go_left(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view)
  {
    const Geodesic_step& step = crossing.to_left;
    Geodesic_window_list* out = batches_.allocate<columns>(view.number_left);
    if(view.is_sorted)
      step_left<columns>(list, list.begin, view.number_left, *out, step);
    else
    {
      step_left<columns>(list, list.begin, view.first - list.begin, *out, step);
      for(std::size_t w = view.first; w < view.last; ++w)
        if(goes_left(w, view))
          step_left<columns>(list, w, 1, *out, step);
    }
    restore_order<columns>(*out, step.length);
    const double at_source = distance_[crossing.source], at_apex = bound_at_apex(crossing);
    const Plane_point target{step.base * step.cosine, -step.base * step.sine};
    filter_begin<columns>(*out, at_source);
    filter_end<columns>(*out, at_apex, step.length, distance_[crossing.target], target);
    send<columns>(crossing.left, 0, out, (std::min)(at_source, at_apex));
  }

  template <int columns>
  void go_right(const Geodesic_window_list& list, const Crossing& crossing, const Apex_view& view)
  {
    const Geodesic_step& step = crossing.to_right;
    Geodesic_window_list* out = batches_.allocate<columns>(view.number_right);
    if(view.is_sorted)
      step_right<columns>(list, list.end - view.number_right, view.number_right, *out, step);
    else
    {
      for(std::size_t w = view.first; w < view.last; ++w)
        if(goes_right(w, view))
          step_right<columns>(list, w, 1, *out, step);
      step_right<columns>(list, view.last, list.end - view.last, *out, step);
    }
    restore_order<columns>(*out, step.length);
    const double at_target = distance_[crossing.target], at_apex = bound_at_apex(crossing);
    const Plane_point source{step.length - step.base * step.cosine, -step.base * step.sine};
    filter_begin<columns>(*out, at_apex, distance_[crossing.source], source);
    filter_end<columns>(*out, at_target, step.length);
    send<columns>(crossing.right, 2, out, (std::min)(at_target, at_apex));
  }

  bool goes_left(std::size_t w, const Apex_view& view) const
  {
    const unsigned char side = sides_[w - view.first];
    return side == passes_left || (side == covers && w <= view.winner);
  }

  bool goes_right(std::size_t w, const Apex_view& view) const
  {
    const unsigned char side = sides_[w - view.first];
    return side == passes_right || (side == covers && w >= view.winner);
  }

  Geodesic_slim_edges slim_edges_;
  std::vector<Crossing_window>* windows_ = nullptr;
  std::vector<unsigned char> sides_; // of the apex, for the windows in work
  double tolerance_ = 0.;
  std::size_t number_of_windows_ = 0; // that have been propagated across a face in the last run
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_CROSSING_H
