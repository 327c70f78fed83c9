// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BUCKET_QUEUE_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BUCKET_QUEUE_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a priority queue that orders its items by their keys up to the width of a bucket, first in first out within one.
 *
 * Keys below the bucket in work go into that bucket. Where keys would need too many buckets, these become wider.
 */
class Geodesic_bucket_queue
{
public:
  /// @param width of the buckets at first
  explicit Geodesic_bucket_queue(double width) : first_inverse_width_(1. / width), inverse_width_(1. / width) {}

  void clear()
  {
    for(std::size_t i = current_; i < buckets_.size(); ++i)
      recycle(i);
    buckets_.clear();
    current_ = position_ = 0;
    inverse_width_ = first_inverse_width_;
  }

  void push(double key, Index item)
  {
    while(key * inverse_width_ >= most_buckets)
      join_pairs();
    std::size_t i = static_cast<std::size_t>(key * inverse_width_);
    if(i < current_)
      i = current_;
    if(i >= buckets_.size())
      buckets_.resize(i + 1);
    std::vector<Index>& bucket = buckets_[i];
    if(bucket.capacity() == 0 && !spare_.empty())
    {
      bucket.swap(spare_.back());
      spare_.pop_back();
    }
    bucket.push_back(item);
  }

  /// moves to the next item; returns `false` if there is none
  bool pop(Index& item)
  {
    while(current_ < buckets_.size())
    {
      if(position_ < buckets_[current_].size())
      {
        item = buckets_[current_][position_++];
        return true;
      }
      recycle(current_);
      ++current_;
      position_ = 0;
    }
    return false;
  }

  /// no item has a smaller key, but for those that came too late
  double key() const { return static_cast<double>(current_) / inverse_width_; }

  /// the item that is `ahead` places behind the one popped last, if the bucket holds it, else null
  Index peek(std::size_t ahead) const
  {
    const std::vector<Index>& bucket = buckets_[current_];
    const std::size_t i = position_ + ahead - 1;
    return i < bucket.size() ? bucket[i] : null_index;
  }

private:
  static constexpr double most_buckets = 1 << 16;

  /// of buckets, which are twice as wide then
  void join_pairs()
  {
    inverse_width_ *= 0.5;
    std::vector<std::vector<Index>> joined((buckets_.size() + 1) / 2);
    for(std::size_t i = current_; i < buckets_.size(); ++i)
    {
      const auto begin = buckets_[i].begin() + static_cast<std::ptrdiff_t>(i == current_ ? position_ : 0);
      joined[i / 2].insert(joined[i / 2].end(), begin, buckets_[i].end());
    }
    buckets_.swap(joined);
    current_ /= 2;
    position_ = 0;
  }

  void recycle(std::size_t i)
  {
    if(buckets_[i].capacity() == 0)
      return;
    buckets_[i].clear();
    spare_.emplace_back();
    spare_.back().swap(buckets_[i]);
  }

  std::vector<std::vector<Index>> buckets_, spare_;
  std::size_t current_ = 0, position_ = 0;
  double first_inverse_width_, inverse_width_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_BUCKET_QUEUE_H
