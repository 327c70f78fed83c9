// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_COPY_POOL_H
#define CGAL_CUT_LOCI_INTERNAL_COPY_POOL_H

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Copies of an object, each of them lent to one thread at a time; there are no more than are needed at once.
template <typename T>
class Copy_pool
{
public:
  explicit Copy_pool(const T& original) : original_(original) {}

  std::unique_ptr<T> take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(free_.empty())
      return std::unique_ptr<T>(new T(original_));
    std::unique_ptr<T> result = std::move(free_.back());
    free_.pop_back();
    return result;
  }

  void give_back(std::unique_ptr<T> copy)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    free_.push_back(std::move(copy));
  }

private:
  const T& original_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_COPY_POOL_H
