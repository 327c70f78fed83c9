// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
#define CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_crossing_impl.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_starts_impl.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

CGAL_CUT_LOCI_INLINE void Exact_geodesic_propagation::run(const std::vector<Indexed_location>& sources,
                                                          const Exact_geodesic_options& options,
                                                          Geodesic_window_observer* observer)
{
  start(sources, options);
  observer_ = observer;
  if(observer_ != nullptr && !is_approximate() && !has_lines())
    count_paths();
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
  windows_ = options.windows;
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
  find_true_distances();
  finish_queries();
  if(maximum_distance_ < infinity)
    cut_off(maximum_distance_);
  if(!has_turns())
    add_errors();
}

/// a path of length `d` to the vertex `v` has been found
inline void Exact_geodesic_propagation::reach(Index v, double d, const Geodesic_arrival& arrival)
{
  if(improve(v, d, arrival) && faces_.is_pseudo_source(v))
    batches_.push_vertex(d, v);
}

inline bool Exact_geodesic_propagation::reach_beside_windows()
{
  std::sort(beside_.begin(), beside_.end(),
            [](const Path_beside& p, const Path_beside& q) { return p.distance < q.distance; });
  bool result = false;
  for(const Path_beside& path : beside_)
    if(is_shorter(path))
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

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_IMPL_H
