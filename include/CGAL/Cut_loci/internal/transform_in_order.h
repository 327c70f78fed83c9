// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_TRANSFORM_IN_ORDER_H
#define CGAL_CUT_LOCI_INTERNAL_TRANSFORM_IN_ORDER_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
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

/*!
 * calls `consume(compute(i))` for each i below `size`, and `consume` in this order, never twice at once.
 *
 * In threads, some more values than there are threads exist at the same time, however slow one of them is.
 */
template <bool is_parallel, typename Compute, typename Consume>
void transform_in_order(std::size_t size, const Compute& compute, const Consume& consume)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel)
  {
    using Value = decltype(compute(std::size_t(0)));
    using Mode = tbb::filter_mode;
    // a second value for each thread, so that none waits for a slow one before it
    const std::size_t at_once = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    std::size_t next = 0;
    const auto count = [&](tbb::flow_control& control)
    {
      if(next == size)
        control.stop();
      return next == size ? next : next++;
    };
    tbb::parallel_pipeline(at_once, tbb::make_filter<void, std::size_t>(Mode::serial_in_order, count) &
                                      tbb::make_filter<std::size_t, Value>(Mode::parallel, compute) &
                                      tbb::make_filter<Value, void>(Mode::serial_in_order, consume));
    return;
  }
#endif
  for(std::size_t i = 0; i < size; ++i)
    consume(compute(i));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_TRANSFORM_IN_ORDER_H
