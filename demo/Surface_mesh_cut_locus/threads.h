// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_THREADS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_THREADS_H

#include <cstddef>
#include <memory>

// As many as are asked for; 0: as many as the machine has. Throws `Usage_error` where there is just one.
unsigned number_of_threads(std::size_t asked_for);

// Lets no more threads run as long as it is there. One needs no limit: for it, TBB is not called.
class Thread_limit
{
public:
  explicit Thread_limit(unsigned number);
  ~Thread_limit();
  Thread_limit(const Thread_limit&) = delete;
  Thread_limit& operator=(const Thread_limit&) = delete;

private:
  struct Control;
  std::unique_ptr<Control> control_;
};

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_THREADS_H
