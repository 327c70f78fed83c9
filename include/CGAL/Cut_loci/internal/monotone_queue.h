// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_MONOTONE_QUEUE_H
#define CGAL_CUT_LOCI_INTERNAL_MONOTONE_QUEUE_H

#include <CGAL/Cut_loci/Index.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A radix heap: a priority queue for keys that are not negative, each at least the last one taken. The bits of such
// numbers are ordered as they are. Bucket `i` holds the keys whose highest bit that differs from the last one taken is
// the `i - 1`st; an item only ever moves to lower buckets. Faster than a heap, and, unlike buckets of a fixed width,
// as fast when the lengths of the arcs differ by orders of magnitude.
class Monotone_queue
{
public:
  struct Item
  {
    float key;
    Index vertex;
  };

  bool empty() const { return size_ == 0; }

  void clear()
  {
    for(std::vector<Item>& b : buckets_)
      b.clear();
    last_ = 0;
    size_ = 0;
  }

  void push(float key, Index vertex)
  {
    buckets_[bucket(bits(key))].push_back({key, vertex});
    ++size_;
  }

  Item pop()
  {
    if(buckets_[0].empty())
      refill();
    const Item result = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    return result;
  }

private:
  static std::size_t highest_bit(std::uint32_t x)
  {
#if defined(__GNUC__)
    return 31 - static_cast<std::size_t>(__builtin_clz(x));
#else
    std::size_t result = 0;
    while(x >>= 1)
      ++result;
    return result;
#endif
  }

  static std::uint32_t bits(float key)
  {
    std::uint32_t result;
    std::memcpy(&result, &key, sizeof(result));
    return result;
  }

  std::size_t bucket(std::uint32_t b) const
  {
    const std::uint32_t difference = b ^ last_;
    return difference == 0 ? 0 : 1 + highest_bit(difference);
  }

  void refill()
  {
    std::size_t i = 1;
    while(buckets_[i].empty())
      ++i;
    last_ = bits(std::min_element(buckets_[i].begin(), buckets_[i].end(),
                                  [](const Item& a, const Item& b) {
      return a.key < b.key;
                 })->key);
    for(const Item& item : buckets_[i])
      buckets_[bucket(bits(item.key))].push_back(item);
    buckets_[i].clear();
  }

  std::array<std::vector<Item>, 33> buckets_;
  std::uint32_t last_ = 0;
  std::size_t size_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_MONOTONE_QUEUE_H
