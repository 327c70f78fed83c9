// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_GEODESIC_BATCHES_H
#define CGAL_CUT_LOCI_INTERNAL_GEODESIC_BATCHES_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/internal/Geodesic_bucket_queue.h>
#include <CGAL/Cut_loci/internal/Geodesic_windows.h>
#include <CGAL/Cut_loci/internal/geodesic_window_filters.h>
#include <CGAL/Cut_loci/internal/geodesic_window_trimming.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

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
    : m_queue(width)
    , m_lists(3 * std::size_t(number_of_halfedges), nullptr)
    , m_is_queued(number_of_vertices, 0)
    , m_number_of_halfedges(number_of_halfedges)
  {}

  void prepare(double maximum_distance)
  {
    if(!m_is_clean) {
      // an exception has ended the last run
      std::fill(m_lists.begin(), m_lists.end(), nullptr);
      std::fill(m_is_queued.begin(), m_is_queued.end(), static_cast<unsigned char>(0));
    }
    m_pool.clear();
    m_queue.clear();
    m_has_inner_source.clear();
    m_maximum_distance = maximum_distance;
    m_is_clean = false;
  }

  /// a list with room for `n` windows, to be handed back by `release()` or `store()`
  template <int columns>
  Geodesic_window_list* allocate(std::size_t n)
  {
    return m_pool.allocate<columns>(n);
  }
  void release(Geodesic_window_list* list) { m_pool.release(list); }

  /// hands a list, which came from the given side, to the halfedge it has reached
  template <int columns>
  void store(Index h, std::size_t side, Geodesic_window_list* list, double length, double key)
  {
    if(m_maximum_distance < infinity)
      filter_distance<columns>(*list, m_maximum_distance);
    if(list->empty()) {
      m_pool.release(list);
      return;
    }
    Geodesic_window_list** lists = &m_lists[3 * std::size_t(h)];
    if(lists[0] == nullptr && lists[1] == nullptr && lists[2] == nullptr) {
      if(key == infinity) {
        const Geodesic_window w = list->get<columns>(list->begin);
        key = w.distance(w.a);
      }
      m_queue.push(key, h);
    }
    if(lists[side] == nullptr)
      lists[side] = list;
    else {
      // a second batch from the same side
      Geodesic_window_list* envelope = m_pool.allocate<columns>(4 * std::size_t(list->size() + lists[side]->size()));
      Geodesic_envelope<columns>()(*lists[side], *list, *envelope, length);
      m_pool.release(list);
      m_pool.release(lists[side]);
      lists[side] = envelope;
    }
  }

  /// hands a single window of a (pseudo-)source to the halfedge `h`
  template <int columns>
  void insert(Index h, const Geodesic_window& w, double length)
  {
    Geodesic_window_list* list = m_pool.allocate<columns>(1);
    list->append<columns>(w);
    store<columns>(h, 1, list, length, (std::min)(w.distance(w.a), w.distance(w.b)));
  }

  /// the windows of a source inside of a face are not in order with the ones that enter it
  void mark_inner_source(Index h)
  {
    if(m_has_inner_source.empty())
      m_has_inner_source.assign(m_number_of_halfedges, 0);
    m_has_inner_source[h] = 1;
  }

  /// the windows of `h` from all three sides, in one list in order
  template <int columns>
  Geodesic_window_list* collect(Index h, double length)
  {
    Geodesic_window_list** lists = &m_lists[3 * std::size_t(h)];
    std::size_t size = 0, number = 0, present = 0;
    for(std::size_t k = 0; k < 3; ++k)
      if(lists[k] != nullptr) {
        size += lists[k]->size();
        ++number;
        present = k;
      }
    Geodesic_window_list* all = lists[present];
    if(number > 1) {
      const bool apart = !m_has_inner_source.empty() && m_has_inner_source[h] && lists[1] != nullptr;
      all = m_pool.allocate<columns>(size);
      for(std::size_t k = 0; k < 3; ++k)
        if(lists[k] != nullptr && !(apart && k == 1)) {
          const std::size_t junction = all->end;
          all->append<columns>(*lists[k]);
          m_pool.release(lists[k]);
          if(junction > 0)
            Geodesic_trimming<columns>(*all, length, false).join(junction);
        }
      if(apart) {
        // the windows of a source inside of the face are not in order with those that enter it
        Geodesic_window_list* envelope = m_pool.allocate<columns>(4 * size);
        Geodesic_envelope<columns>()(*lists[1], *all, *envelope, length);
        m_pool.release(lists[1]);
        m_pool.release(all);
        all = envelope;
      }
    }
    lists[0] = lists[1] = lists[2] = nullptr;
    return all;
  }

  /// lets the vertex `v` at the distance `d` wait
  void push_vertex(double d, Index v)
  {
    if(m_is_queued[v])
      return;
    m_is_queued[v] = 1;
    m_queue.push(d, m_number_of_halfedges + v);
  }

  /// takes the next halfedge or, behind the number of the halfedges, vertex; returns `false` if nothing waits
  bool pop(Index& item)
  {
    if(!m_queue.pop(item)) {
      m_is_clean = true;
      return false;
    }
    if(item >= m_number_of_halfedges)
      m_is_queued[item - m_number_of_halfedges] = 0;
    return true;
  }

  /// what will probably be taken in `ahead` steps, or null
  Index peek(std::size_t ahead) const { return m_queue.peek(ahead); }

  void prefetch_lists(Index h) const
  {
#if defined(__GNUC__)
    __builtin_prefetch(&m_lists[3 * std::size_t(h)]);
#else
    (void)h;
#endif
  }

  void prefetch_windows(Index h) const
  {
#if defined(__GNUC__)
    const std::size_t first = 3 * std::size_t(h);
    for(std::size_t k = first; k < first + 3; ++k)
      if(m_lists[k] != nullptr)
        for(std::size_t i = 0; i < 5; ++i)
          __builtin_prefetch(m_lists[k]->column(i));
#else
    (void)h;
#endif
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  Geodesic_bucket_queue m_queue;
  Geodesic_window_pool m_pool;
  std::vector<Geodesic_window_list*> m_lists; // of each halfedge: from the left, from the vertex behind, from the right
  std::vector<unsigned char> m_is_queued, m_has_inner_source;
  Index m_number_of_halfedges;
  double m_maximum_distance = infinity;
  bool m_is_clean = true;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_GEODESIC_BATCHES_H
