// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H
#define CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_crossing.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_starts.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/separate_compilation.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * computes exact geodesic distances on a triangle mesh by propagating windows.
 *
 * Windows \cgalCite{mmp-dgp-87} cross the faces in batches, one per halfedge, in the order of the distance
 * \cgalCite{xu-fwp-15}. In the face entered, only the window with the shortest path to the apex goes on to both other
 * edges \cgalCite{ch-spp-90}; the ends of a batch lose the windows to which a path through a vertex of the face is
 * preferable \cgalCite{Xin2009Improvingchenandhan}. Neighboring windows are trimmed as described in `geodesic_window_trimming.h`.
 * Batches are forgotten once they have been propagated. If an error is allowed, neighboring windows are merged as
 * described in `Geodesic_merging.h`; what is the direction otherwise, is then the error, unless both are asked for.
 *
 * The mesh geometry is read by the constructor. All memory is reused from one run to the next. Queries after a run
 * are const.
 */
class Exact_geodesic_propagation : public Geodesic_crossing
{
public:
  /// \throws Invalid_input see `Geodesic_faces`
  ///
  /// `positions` are the numbers by which messages name the vertices, if not by their index.
  explicit Exact_geodesic_propagation(const Indexed_triangle_mesh& mesh, const std::vector<Index>* positions = nullptr,
                                      const Progress& progress = {})
    : Exact_geodesic_propagation(std::make_shared<const Geodesic_faces>(mesh, positions, progress))
  {
  }

  /// for a mesh that has been read: several of them may share it, also in several threads
  explicit Exact_geodesic_propagation(std::shared_ptr<const Geodesic_faces> faces) : Geodesic_crossing(std::move(faces))
  {
  }

  /// \throws Invalid_input if there is no source, or a location is none on the mesh
  void run(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options = {})
  {
    run(sources, options, nullptr);
  }

  /// the same with directions, and shows the windows to an observer
  void run(const std::vector<Indexed_location>& sources, Exact_geodesic_options options,
           Geodesic_window_observer& observer)
  {
    options.directions = true;
    run(sources, options, &observer);
  }

  /// hands back a list that an observer has kept
  void release(Geodesic_window_list* list) { batches_.release(list); }
  /// a list with room for `n` windows as the observer gets them
  Geodesic_window_list* allocate(std::size_t n)
  {
    return is_approximate() ? batches_.allocate<9>(n) : batches_.allocate<7>(n);
  }
  /// whether windows wait to cross the face of `h`
  bool waits(Index h) const { return batches_.waits(h); }

  /// with a vertex as the only source
  void run(Index source, const Exact_geodesic_options& options = {}) { run({vertex_location(source)}, options); }

  /// the number of windows that have been propagated across a face in the last run
  std::size_t number_of_windows() const { return number_of_windows_; }

private:
  void run(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options,
           Geodesic_window_observer* observer);

  void start(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options)
  {
    if(sources.empty())
      throw Invalid_input(Cause::NO_SOURCE, "no source");
    prepare(sources, options);
    batches_.prepare(options.maximum_distance);
    slim_edges_.clear();
    maximum_distance_ = options.maximum_distance;
    tolerance_ = options.maximum_relative_error;
    number_of_windows_ = 0;
    windows_ = options.windows;
    beside_.clear();
    progress_ = options.progress;
    next_report_ = progress_.is_wanted() ? 0 : (std::numeric_limits<std::size_t>::max)();
  }

  template <int columns>
  void propagate()
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

  /// reaches the vertices that rounding has left between windows; whether there were any
  bool reach_beside_windows()
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

  /// tells the progress, and when to do so again
  void report_progress()
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

  void prefetch(Index far, Index near) const
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

  std::size_t next_report_ = 0; // the number of windows at which the progress is told
  Progress progress_;
};

} // namespace CGAL::Cut_loci::internal

#ifndef CGAL_CUT_LOCI_SEPARATE_COMPILATION
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation_impl.h>
#endif

#endif // CGAL_CUT_LOCI_GEODESICS_EXACT_GEODESIC_PROPAGATION_H
