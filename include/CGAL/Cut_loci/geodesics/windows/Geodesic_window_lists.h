// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_LISTS_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_LISTS_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>

#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * holds the windows of an edge that many batches have brought, around a spike or in a fan of slim faces.
 *
 * It has several lists, from long to short, and joins them in pairs of like size, so that no window is looked at more than
 * some ten times. Whoever owns the lists says how two become one, by a functor that takes and returns pointers.
 */
class Geodesic_window_lists
{
public:
  template <typename Join>
  void add(Geodesic_window_list* list, const Join& join)
  {
    while(!lists_.empty() && lists_.back()->size() <= 2 * list->size())
    {
      list = join(lists_.back(), list);
      lists_.pop_back();
    }
    lists_.push_back(list);
  }

  /// hands over all of them as one, or null
  template <typename Join>
  Geodesic_window_list* release(const Join& join)
  {
    Geodesic_window_list* result = nullptr;
    for(; !lists_.empty(); lists_.pop_back())
      result = result == nullptr ? lists_.back() : join(lists_.back(), result);
    return result;
  }

  const std::vector<Geodesic_window_list*>& lists() const { return lists_; }

private:
  std::vector<Geodesic_window_list*> lists_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOW_LISTS_H
