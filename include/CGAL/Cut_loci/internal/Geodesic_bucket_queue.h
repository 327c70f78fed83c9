// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_GEODESIC_BUCKET_QUEUE_H
#define CGAL_CUT_LOCI_INTERNAL_GEODESIC_BUCKET_QUEUE_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * is a priority queue that orders its items by their keys up to the width of a bucket, first in first out within one.
 *
 * Keys below the bucket in work go into that bucket.
 */
class Geodesic_bucket_queue
{
public:
  explicit Geodesic_bucket_queue(double width) : m_inverse_width(1. / width) {}

  void clear()
  {
    for(std::size_t i = m_current; i < m_buckets.size(); ++i)
      recycle(i);
    m_buckets.clear();
    m_current = m_position = 0;
  }

  void push(double key, Index item)
  {
    std::size_t i = static_cast<std::size_t>(key * m_inverse_width);
    if(i < m_current)
      i = m_current;
    if(i >= m_buckets.size())
      m_buckets.resize(i + 1);
    std::vector<Index>& bucket = m_buckets[i];
    if(bucket.capacity() == 0 && !m_spare.empty()) {
      bucket.swap(m_spare.back());
      m_spare.pop_back();
    }
    bucket.push_back(item);
  }

  /// moves to the next item; returns `false` if there is none
  bool pop(Index& item)
  {
    while(m_current < m_buckets.size()) {
      if(m_position < m_buckets[m_current].size()) {
        item = m_buckets[m_current][m_position++];
        return true;
      }
      recycle(m_current);
      ++m_current;
      m_position = 0;
    }
    return false;
  }

  /// the item that is `ahead` places behind the one popped last, if the bucket holds it, else null
  Index peek(std::size_t ahead) const
  {
    const std::vector<Index>& bucket = m_buckets[m_current];
    const std::size_t i = m_position + ahead - 1;
    return i < bucket.size() ? bucket[i] : null_index;
  }

private:
  void recycle(std::size_t i)
  {
    if(m_buckets[i].capacity() == 0)
      return;
    m_buckets[i].clear();
    m_spare.emplace_back();
    m_spare.back().swap(m_buckets[i]);
  }

  std::vector<std::vector<Index>> m_buckets, m_spare;
  std::size_t m_current = 0, m_position = 0;
  double m_inverse_width;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_GEODESIC_BUCKET_QUEUE_H
