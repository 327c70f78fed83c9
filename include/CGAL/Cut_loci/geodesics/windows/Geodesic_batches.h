// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BATCHES_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BATCHES_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_bucket_queue.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * holds the windows that wait at halfedges to be propagated, and the vertices that wait to be sources, in the order of
 * the distance.
 *
 * A halfedge waits as long as it has windows, a vertex at most once.
 */
class Geodesic_batches
{
public:
  /// `width` is the difference of the distance from which on order matters
  Geodesic_batches(Index number_of_halfedges, Index number_of_vertices, double width)
    : queue_(width), lists_(3 * std::size_t(number_of_halfedges), nullptr), is_queued_(number_of_vertices, 0),
      number_of_halfedges_(number_of_halfedges)
  {
  }

  void prepare(double maximum_distance)
  {
    if(!is_clean_)
    {
      // an exception has ended the last run
      std::fill(lists_.begin(), lists_.end(), nullptr);
      std::fill(is_queued_.begin(), is_queued_.end(), static_cast<unsigned char>(0));
    }
    pool_.clear();
    queue_.clear();
    has_inner_source_.clear();
    maximum_distance_ = maximum_distance;
    is_clean_ = false;
  }

  /// a list with room for `n` windows, to be handed back by `release()` or `store()`
  template <int columns>
  Geodesic_window_list* allocate(std::size_t n)
  {
    return pool_.allocate<columns>(n);
  }
  void release(Geodesic_window_list* list) { pool_.release(list); }

  /// hands a list, which came from the given side, to the halfedge it has reached
  template <int columns>
  void store(Index h, std::size_t side, Geodesic_window_list* list, double length, double key)
  {
    if(maximum_distance_ < infinity)
      filter_distance<columns>(*list, maximum_distance_);
    if(list->empty())
    {
      pool_.release(list);
      return;
    }
    Geodesic_window_list** lists = &lists_[3 * std::size_t(h)];
    if(lists[0] == nullptr && lists[1] == nullptr && lists[2] == nullptr)
    {
      if(key == infinity)
      {
        const Geodesic_window w = list->get<columns>(list->begin);
        key = w.distance(w.a);
      }
      queue_.push(key, h);
    }
    if(lists[side] == nullptr)
      lists[side] = list;
    else
    {
      // a second batch from the same side
      Geodesic_window_list* envelope = pool_.allocate<columns>(4 * std::size_t(list->size() + lists[side]->size()));
      Geodesic_envelope<columns>()(*lists[side], *list, *envelope, length);
      pool_.release(list);
      pool_.release(lists[side]);
      lists[side] = envelope;
    }
  }

  /// hands a single window of a (pseudo-)source to the halfedge `h`
  template <int columns>
  void insert(Index h, const Geodesic_window& w, double length)
  {
    Geodesic_window_list* list = pool_.allocate<columns>(1);
    list->append<columns>(w);
    store<columns>(h, 1, list, length, (std::min)(w.distance(w.a), w.distance(w.b)));
  }

  /// the windows of a source inside of a face are not in order with the ones that enter it
  void mark_inner_source(Index h)
  {
    if(has_inner_source_.empty())
      has_inner_source_.assign(number_of_halfedges_, 0);
    has_inner_source_[h] = 1;
  }

  /// the windows of `h` from all three sides, in one list in order
  template <int columns>
  Geodesic_window_list* collect(Index h, double length)
  {
    Geodesic_window_list** lists = &lists_[3 * std::size_t(h)];
    std::size_t size = 0, number = 0, present = 0;
    for(std::size_t k = 0; k < 3; ++k)
      if(lists[k] != nullptr)
      {
        size += lists[k]->size();
        ++number;
        present = k;
      }
    Geodesic_window_list* all = lists[present];
    if(number > 1)
    {
      const bool apart = !has_inner_source_.empty() && has_inner_source_[h] && lists[1] != nullptr;
      all = pool_.allocate<columns>(size);
      for(std::size_t k = 0; k < 3; ++k)
        if(lists[k] != nullptr && !(apart && k == 1))
        {
          const std::size_t junction = all->end;
          all->append<columns>(*lists[k]);
          pool_.release(lists[k]);
          if(junction > 0)
            Geodesic_trimming<columns>(*all, length, false).join(junction);
        }
      if(apart)
      {
        // the windows of a source inside of the face are not in order with those that enter it
        Geodesic_window_list* envelope = pool_.allocate<columns>(4 * size);
        Geodesic_envelope<columns>()(*lists[1], *all, *envelope, length);
        pool_.release(lists[1]);
        pool_.release(all);
        all = envelope;
      }
    }
    lists[0] = lists[1] = lists[2] = nullptr;
    return all;
  }

  /// lets the vertex `v` at the distance `d` wait
  void push_vertex(double d, Index v)
  {
    if(is_queued_[v])
      return;
    is_queued_[v] = 1;
    queue_.push(d, number_of_halfedges_ + v);
  }

  /// takes the next halfedge or, behind the number of the halfedges, vertex; returns `false` if nothing waits
  bool pop(Index& item)
  {
    if(!queue_.pop(item))
    {
      is_clean_ = true;
      return false;
    }
    if(item >= number_of_halfedges_)
      is_queued_[item - number_of_halfedges_] = 0;
    return true;
  }

  /// whether windows wait at `h`
  bool waits(Index h) const
  {
    const std::size_t first = 3 * std::size_t(h);
    return lists_[first] != nullptr || lists_[first + 1] != nullptr || lists_[first + 2] != nullptr;
  }

  /// the distance up to which everything has been taken, but for what comes too late
  double key() const { return queue_.key(); }

  /// what will probably be taken in `ahead` steps, or null
  Index peek(std::size_t ahead) const { return queue_.peek(ahead); }

  void prefetch_lists(Index h) const
  {
#if defined(__GNUC__)
    __builtin_prefetch(&lists_[3 * std::size_t(h)]);
#else
    (void)h;
#endif
  }

  void prefetch_windows(Index h) const
  {
#if defined(__GNUC__)
    const std::size_t first = 3 * std::size_t(h);
    for(std::size_t k = first; k < first + 3; ++k)
      if(lists_[k] != nullptr)
        for(std::size_t i = 0; i < 5; ++i)
          __builtin_prefetch(lists_[k]->column(i));
#else
    (void)h;
#endif
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  Geodesic_bucket_queue queue_;
  Geodesic_window_pool pool_;
  std::vector<Geodesic_window_list*> lists_; // of each halfedge: from the left, from the vertex behind, from the right
  std::vector<unsigned char> is_queued_, has_inner_source_;
  Index number_of_halfedges_;
  double maximum_distance_ = infinity;
  bool is_clean_ = true;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BATCHES_H
