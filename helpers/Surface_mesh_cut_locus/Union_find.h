// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_UNION_FIND_H
#define CGAL_CUT_LOCI_HELPERS_UNION_FIND_H

#include <cstddef>
#include <numeric>
#include <vector>

// It shares no code with the library, so that tests may trust it.
namespace curve_measures {

class Union_find
{
public:
  explicit Union_find(std::size_t n) : parent_(n), parts_(n)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i)
  {
    while(parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool unite(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    parts_ -= a != b ? 1 : 0;
    return a != b;
  }
  std::size_t number_of_parts() const { return parts_; }

private:
  std::vector<std::size_t> parent_;
  std::size_t parts_;
};

} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_UNION_FIND_H
