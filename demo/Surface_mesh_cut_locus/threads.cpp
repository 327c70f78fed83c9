// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "threads.h"
#include "Options.h"

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

unsigned number_of_threads(std::size_t asked_for)
{
  return static_cast<unsigned>(asked_for == 0 ? std::size_t(tbb::this_task_arena::max_concurrency()) : asked_for);
}

struct Thread_limit::Control
{
  tbb::global_control control;
};

Thread_limit::Thread_limit(unsigned number)
  : control_(number > 1 ? new Control{tbb::global_control(tbb::global_control::max_allowed_parallelism, number)}
                        : nullptr)
{
}

#else

unsigned number_of_threads(std::size_t asked_for)
{
  if(asked_for > 1)
    throw Usage_error("--threads: this program has been built without TBB, and has one");
  return 1;
}

struct Thread_limit::Control
{
};

Thread_limit::Thread_limit(unsigned) {}

#endif

Thread_limit::~Thread_limit() = default;
