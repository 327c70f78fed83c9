// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_CONCURRENCY_H
#define CGAL_CUT_LOCI_FACE_GRAPH_CONCURRENCY_H

#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/named_parameters.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL::Cut_loci::internal {

// whether the named parameter `concurrency_tag` asks for threads
template <typename NamedParameters>
constexpr bool is_parallel()
{
  using Tag =
    typename internal_np::Lookup_named_param_def<internal_np::concurrency_tag_t, NamedParameters, Sequential_tag>::type;
  constexpr bool result = std::is_convertible<Tag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!result,
                "CGAL::Parallel_tag needs TBB, and it is not linked: link the CMake target CGAL::TBB_support, or "
                "pass CGAL::Parallel_if_available_tag");
#endif
  return result;
}

// the threads that it asks for
template <typename NamedParameters>
Threads threads_of()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<NamedParameters>())
  {
    // what else waits may be another call for the same object, which the thread in work must not take up
    using tbb::this_task_arena::isolate;
    return Threads([](std::size_t number, const Threads::Task& task)
                   { isolate([&] { tbb::parallel_for(std::size_t(0), number, [&](std::size_t i) { task(i); }); }); },
                   [](const Threads::Job& first, const Threads::Job& second)
                   {
      isolate(
        [&]
        {
        tbb::task_group group;
        group.run(second);
        try
        {
          first();
        }
        catch(...)
        {
          group.wait();
          throw;
        }
        group.wait();
      });
    });
  }
#endif
  return Threads();
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_CONCURRENCY_H
