// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_BENCHMARK_MEASURING_H
#define SURFACE_MESH_CUT_LOCUS_BENCHMARK_MEASURING_H

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <string>
#include <vector>

// Time and memory of a process.
namespace measuring {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The processor time of all threads, in seconds: what other programs take does not count.
inline double cpu_time()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

inline double median(std::vector<double> values)
{
  if(values.empty())
    return 0.;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// The largest resident size, in bytes (Linux).
inline double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(word == "VmHWM:")
    {
      double kilobytes = 0.;
      status >> kilobytes;
      return 1024. * kilobytes;
    }
  return 0.;
}

// Lets it count from here, with what is free given back; returns what is left.
inline double reset_peak_memory()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return peak_memory();
}

inline double peak_megabytes()
{
  return peak_memory() / (1024. * 1024.);
}

} // namespace measuring

#endif // SURFACE_MESH_CUT_LOCUS_BENCHMARK_MEASURING_H
