// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_HELPERS_UNION_FIND_H
#define CGAL_CUT_LOCI_HELPERS_UNION_FIND_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace curve_measures {
namespace internal {

class Union_find
{
public:
  explicit Union_find(std::size_t n) : parent_(n), parts_(n)
  {
    std::iota(parent_.begin(), parent_.end(), CGAL::Cut_loci::Index(0));
  }
  CGAL::Cut_loci::Index find(CGAL::Cut_loci::Index i)
  {
    while(parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool unite(CGAL::Cut_loci::Index a, CGAL::Cut_loci::Index b)
  {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    parts_ -= a != b ? 1 : 0;
    return a != b;
  }
  std::size_t number_of_parts() const { return parts_; }

private:
  std::vector<CGAL::Cut_loci::Index> parent_;
  std::size_t parts_;
};

} // namespace internal
} // namespace curve_measures

#endif // CGAL_CUT_LOCI_HELPERS_UNION_FIND_H
