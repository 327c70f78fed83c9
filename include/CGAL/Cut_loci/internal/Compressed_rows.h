// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_COMPRESSED_ROWS_H
#define CGAL_CUT_LOCI_INTERNAL_COMPRESSED_ROWS_H

#include <CGAL/Cut_loci/Index.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Lists of all lengths in one array: row by row, and in each row in the order in which its entries came.
template <typename T>
class Compressed_rows
{
public:
  using Row = Iterator_range<typename std::vector<T>::const_iterator>;

  Compressed_rows() = default;

  // `enumerate(add)` calls `add(row, entry)` for all entries; it is called twice
  template <typename Enumerate>
  Compressed_rows(std::size_t number_of_rows, const Enumerate& enumerate) : begin_(number_of_rows + 1, 0)
  {
    enumerate([&](Index row, const T&) { ++begin_[row + std::size_t(1)]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    entries_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    enumerate([&](Index row, const T& entry) { entries_[next[row]++] = entry; });
  }

  Row operator[](Index row) const
  {
    return {entries_.begin() + begin_[row], entries_.begin() + begin_[row + std::size_t(1)]};
  }
  template <typename Less>
  void sort_each(const Less& less)
  {
    for(std::size_t row = 0; row + 1 < begin_.size(); ++row)
      std::sort(entries_.begin() + begin_[row], entries_.begin() + begin_[row + 1], less);
  }
  Index size(Index row) const { return begin_[row + std::size_t(1)] - begin_[row]; }

private:
  std::vector<Index> begin_;
  std::vector<T> entries_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_COMPRESSED_ROWS_H
