// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_SLIM_EDGES_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_SLIM_EDGES_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_window_lists.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * keeps windows from winding around needles.
 *
 * Straight lines that go up a spike wind around it, about as often as it is longer than wide, and nothing that a batch
 * knows says that they are not shortest: the batch of the first turn has been forgotten. So what has crossed the long
 * edges of slim faces many times is remembered, from both sides, and what comes later and is nowhere shorter is dropped.
 */
class Geodesic_slim_edges
{
public:
  explicit Geodesic_slim_edges(const Geodesic_faces& faces) : faces_(faces)
  {
    for(Index h = 0; h < faces.number_of_halfedges(); ++h)
      if(is_slim(h))
        known_[edge(h)];
  }

  bool empty() const { return known_.empty(); }

  /// forgets all windows, for the next run
  void clear()
  {
    pool_.clear();
    for(auto& known : known_)
      known.second = Known();
  }

  /// drops what is not shorter than what has crossed the edge of `h` before, and remembers the rest
  template <int columns>
  void trim(Index h, Geodesic_window_list& list)
  {
    const auto found = known_.find(edge(h));
    if(found == known_.end())
      return;
    Known& known = found->second;
    if(known.visits < first_visits)
    {
      ++known.visits;
      return;
    }
    const bool is_mirrored = edge(h) != h;
    const double length = faces_.length(h);
    drop<columns>(known, list, length, is_mirrored);
    if(!list.empty())
      remember<columns>(known, list, length, is_mirrored);
  }

private:
  // Well shaped faces have none; a spike of this shape has some hundred windows.
  static constexpr double slim = 32.;
  // Batches that come once from each side, or a few times, are cheaper than what is remembered of them. And where an edge
  // is on the cut locus, shortest paths reach all of it from both sides, and neither is to be dropped: these come first.
  static constexpr unsigned first_visits = 8;

  struct Known
  {
    Geodesic_window_lists windows; // in the frame of the halfedge of smaller index
    unsigned visits = 0;
  };

  Index edge(Index h) const { return (std::min)(h, faces_.opposite(h)); }

  bool is_slim(Index h) const
  {
    const Geodesic_face& face = faces_.face_of(h);
    double shortest = face.corner[0].length;
    for(const Geodesic_face::Corner& corner : face.corner)
      shortest = (std::min)(shortest, corner.length);
    return faces_.length(h) > slim * shortest;
  }

  static Geodesic_window in_frame(Geodesic_window w, double length, bool is_mirrored)
  {
    if(!is_mirrored)
      return w;
    std::swap(w.a, w.b);
    w.a = length - w.a;
    w.b = length - w.b;
    w.sigma = w.is_parallel() ? w.distance(length) : w.sigma;
    w.x = length - w.x;
    return w;
  }

  template <int columns>
  void drop(const Known& known, Geodesic_window_list& list, double length, bool is_mirrored) const
  {
    const double narrow = geodesic_narrow * length;
    std::size_t n = list.begin;
    for(std::size_t i = list.begin; i < list.end; ++i)
    {
      Geodesic_window w = in_frame(list.template get<columns>(i), length, is_mirrored);
      clip(known, w, narrow);
      if(is_alive(w, narrow))
        list.template set<columns>(n++, in_frame(w, length, is_mirrored));
    }
    list.end = static_cast<std::uint32_t>(n);
  }

  /// cuts off both ends of a window as far as their points are reached by paths that are not longer
  static void clip(const Known& known, Geodesic_window& w, double narrow)
  {
    bool goes_on = true;
    while(goes_on) // what one list leaves may be in another one
    {
      const double a = w.a, b = w.b;
      const std::vector<Geodesic_window_list*>& lists = known.windows.lists();
      for(std::size_t i = 0; i < lists.size() && is_alive(w, narrow); ++i)
        clip(*lists[i], w, narrow);
      goes_on = lists.size() > 1 && is_alive(w, narrow) && (w.a > a || w.b < b);
    }
  }

  static void clip(const Geodesic_window_list& known, Geodesic_window& w, double narrow)
  {
    const double *begins = known.column(0), *ends = known.column(1);
    for(std::size_t i = std::upper_bound(ends + known.begin, ends + known.end, w.a) - ends;
        i < known.end && is_alive(w, narrow); ++i)
    {
      const Geodesic_window k = known.get<7>(i);
      if(k.a > w.a + narrow || !is_nowhere_longer(k, w, w.a, (std::min)(k.b, w.b)))
        break;
      w.a = (std::min)(k.b, w.b);
    }
    for(std::size_t i = std::lower_bound(begins + known.begin, begins + known.end, w.b) - begins;
        i-- > known.begin && is_alive(w, narrow);)
    {
      const Geodesic_window k = known.get<7>(i);
      if(k.b < w.b - narrow || !is_nowhere_longer(k, w, (std::max)(k.a, w.a), w.b))
        break;
      w.b = (std::max)(k.a, w.a);
    }
  }

  static bool is_nowhere_longer(const Geodesic_window& k, const Geodesic_window& w, double start, double stop)
  {
    // far up a spike all turns are as long, up to rounding
    constexpr double rounding = 1e-14;
    const auto is_longer = [&](double t) { return k.distance(t) > (1. + rounding) * w.distance(t); };
    if(is_longer(start) || is_longer(stop))
      return false;
    // the difference has one extremum at most
    const double extremum = (w.x * k.y - k.x * w.y) / (k.y - w.y);
    return !(extremum > start && extremum < stop) || !is_longer(extremum);
  }

  template <int columns>
  void remember(Known& known, const Geodesic_window_list& list, double length, bool is_mirrored)
  {
    Geodesic_window_list* fresh = pool_.allocate<7>(list.size());
    for(std::size_t i = 0; i < list.size(); ++i)
    {
      Geodesic_window w =
        in_frame(list.template get<columns>(is_mirrored ? list.end - 1 - i : list.begin + i), length, is_mirrored);
      w.turn = 0.; // which is another one from the other side
      fresh->append<7>(w);
    }
    Geodesic_trimming<7>(*fresh, length, true)(fresh->begin);
    known.windows.add(fresh, [&](Geodesic_window_list* first, Geodesic_window_list* second)
                      { return joined(first, second, length); });
  }

  /// the lower envelope of two lists, in place of them
  Geodesic_window_list* joined(Geodesic_window_list* first, Geodesic_window_list* second, double length)
  {
    Geodesic_window_list* envelope = pool_.allocate<7>(4 * std::size_t(first->size() + second->size()));
    Geodesic_envelope<7>()(*first, *second, *envelope, length);
    Geodesic_window_list* result = pool_.allocate<7>(envelope->size());
    result->append<7>(*envelope);
    for(Geodesic_window_list* list : {first, second, envelope})
      pool_.release(list);
    return result;
  }

  const Geodesic_faces& faces_;
  Geodesic_window_pool pool_;
  std::unordered_map<Index, Known> known_; // by edge
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_SLIM_EDGES_H
