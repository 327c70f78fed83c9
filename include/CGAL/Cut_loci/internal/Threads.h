// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_THREADS_H
#define CGAL_CUT_LOCI_INTERNAL_THREADS_H

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL::Cut_loci::internal {

/*!
 * runs independent tasks: one after another, or in threads, if whoever knows a library for that passes a function that does
 * so. Here no such library is known. What the tasks are does not depend on the threads, and their results are put together
 * in order, so that they are the same to the last bit.
 */
class Threads
{
public:
  using Task = std::function<void(std::size_t)>;
  using Run = std::function<void(std::size_t, const Task&)>;
  using Job = std::function<void()>;
  using Run_both = std::function<void(const Job&, const Job&)>;

  Threads() = default;
  Threads(Run run, Run_both run_both) : run_(std::move(run)), run_both_(std::move(run_both)) {}

  bool are_there() const { return run_ != nullptr; }
  // how many tasks are worth to be given to `run()` at once, where their results take memory
  std::size_t number_at_once() const { return are_there() ? 16 : 1; }

  // calls `task(i)` for all i below `number`
  void run(std::size_t number, const Task& task) const
  {
    if(are_there())
      return run_(number, task);
    for(std::size_t i = 0; i < number; ++i)
      task(i);
  }

  // Calls `first()` in this thread and `second()`, which must not throw, in another one at the same time, or, if none is
  // free, afterwards. So `second()` may wait for `first()`.
  void run_both(const Job& first, const Job& second) const
  {
    if(are_there())
      return run_both_(first, second);
    first();
    second();
  }

private:
  Run run_;
  Run_both run_both_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_THREADS_H
