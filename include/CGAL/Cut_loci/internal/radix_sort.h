// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_RADIX_SORT_H
#define CGAL_CUT_LOCI_INTERNAL_RADIX_SORT_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The indices of `keys`, which are not negative, by increasing key; equal keys by increasing index. Three passes over
// 11 bits each: the bits of such floating point numbers are in the order of their values.
inline std::vector<Index> radix_sorted(const std::vector<float>& keys)
{
  struct Item
  {
    std::uint32_t bits;
    Index index;
  };
  const std::size_t n = keys.size();
  std::vector<Item> items(n), other(n);
  std::array<std::array<std::uint32_t, 2048>, 3> first = {};
  for(std::size_t i = 0; i < n; ++i)
  {
    const float key = keys[i] + 0.f; // -0 has the sign bit set
    std::memcpy(&items[i].bits, &key, sizeof(key));
    items[i].index = static_cast<Index>(i);
    for(unsigned pass = 0; pass < 3; ++pass)
      ++first[pass][(items[i].bits >> (11 * pass)) & 2047];
  }
  for(unsigned pass = 0; pass < 3; ++pass)
  {
    std::uint32_t sum = 0;
    for(std::uint32_t& f : first[pass])
    {
      const std::uint32_t count = f;
      f = sum;
      sum += count;
    }
    for(const Item& item : items)
      other[first[pass][(item.bits >> (11 * pass)) & 2047]++] = item;
    items.swap(other);
  }
  std::vector<Index> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = items[i].index;
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_RADIX_SORT_H
