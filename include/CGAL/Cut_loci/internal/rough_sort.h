// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_ROUGH_SORT_H
#define CGAL_CUT_LOCI_INTERNAL_ROUGH_SORT_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/internal/Progress.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The indices of `keys`, which are not negative, by increasing key, where keys that differ by less than a quarter may
// count as equal; those by increasing index, as memory is. One pass: the first bits of such floating point numbers, the
// exponent and two more, are in the order of their values.
inline std::vector<Index> roughly_sorted(const std::vector<float>& keys, const Progress& progress = {})
{
  const std::size_t n = keys.size();
  std::vector<std::uint16_t> digit(n);
  std::array<Index, 2049> first = {};
  const Progress counting = progress.part(0., 0.4), writing = progress.part(0.4, 1.);
  for(std::size_t i = 0; i < n; ++i)
  {
    counting(i, n);
    const float key = keys[i] + 0.f; // -0 has the sign bit set
    std::uint32_t bits;
    std::memcpy(&bits, &key, sizeof(key));
    digit[i] = static_cast<std::uint16_t>(bits >> 21);
    ++first[digit[i] + 1];
  }
  for(std::size_t d = 1; d < first.size(); ++d)
    first[d] += first[d - 1];
  std::vector<Index> result(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    writing(i, n);
    result[first[digit[i]]++] = static_cast<Index>(i);
  }
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_ROUGH_SORT_H
