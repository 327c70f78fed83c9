// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_EXCLUSIVE_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_EXCLUSIVE_H

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

// Runs one function at a time, without the GIL. Those of other threads wait.
class Exclusive
{
public:
  template <typename Function>
  auto run(const Function& function)
  {
    if(owner_ == std::this_thread::get_id()) // waiting for itself would never end
      throw std::runtime_error("an object can not be used by the progress function that it calls");
    const pybind11::gil_scoped_release no_gil; // first: who has the lock may wait for the GIL
    const std::lock_guard<std::mutex> lock(mutex_);
    const Ownership ownership(owner_);
    return function();
  }

private:
  class Ownership
  {
  public:
    explicit Ownership(std::atomic<std::thread::id>& owner) : owner_(owner) { owner_ = std::this_thread::get_id(); }
    ~Ownership() { owner_ = std::thread::id(); }
    Ownership(const Ownership&) = delete;
    Ownership& operator=(const Ownership&) = delete;

  private:
    std::atomic<std::thread::id>& owner_;
  };

  std::mutex mutex_;
  std::atomic<std::thread::id> owner_{std::thread::id()};
};

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_EXCLUSIVE_H
