// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Progress.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace {

constexpr int bar_length = 30;

bool shows_a_terminal()
{
#if defined(__unix__) || defined(__APPLE__)
  return isatty(STDERR_FILENO) != 0;
#else
  return false;
#endif
}

} // namespace

Progress::Progress(bool is_quiet) : is_quiet_(is_quiet), is_terminal_(shows_a_terminal()) {}

Progress::~Progress()
{
  if(!stage_.empty())
    end();
}

void Progress::start(const std::string& stage)
{
  if(!is_quiet_)
  {
    std::fprintf(stderr, "%-10s ", stage.c_str());
    std::fflush(stderr);
  }
  stage_ = stage;
  start_ = shown_ = Clock::now();
}

void Progress::progress(CGAL::Cut_loci::Stage, double share)
{
  constexpr std::chrono::milliseconds pause(100);
  const Clock::time_point now = Clock::now();
  if(is_quiet_ || !is_terminal_ || now - shown_ < pause)
    return;
  shown_ = now;
  const int done = static_cast<int>(share * bar_length);
  std::fprintf(stderr, "\r%-10s [%s%s] %3d %%", stage_.c_str(), std::string(done, '#').c_str(),
               std::string(bar_length - done, ' ').c_str(), static_cast<int>(100. * share));
  std::fflush(stderr);
}

void Progress::end()
{
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if(!is_quiet_ && shown_ != start_) // over the bar
    std::fprintf(stderr, "\r%-10s %*s\r%-10s ", stage_.c_str(), bar_length + 8, "", stage_.c_str());
  if(!is_quiet_) // a stage that failed gets no time, but its line ends before that of the error starts
  {
    if(std::uncaught_exceptions() == 0)
      std::fprintf(stderr, "%9.3f s\n", seconds);
    else
      std::fprintf(stderr, "   failed\n");
  }
  const auto found = std::find_if(seconds_.begin(), seconds_.end(), [&](const auto& s) { return s.first == stage_; });
  if(found == seconds_.end())
    seconds_.emplace_back(stage_, seconds);
  else
    found->second += seconds;
  stage_.clear();
}

void Progress::start_stage(CGAL::Cut_loci::Stage stage)
{
  using CGAL::Cut_loci::Stage;
  switch(stage)
  {
  case Stage::PREPROCESSING:
    return start("preprocess");
  case Stage::DISTANCE:
    return start("distance");
  case Stage::STRENGTH:
    return start("strengths");
  case Stage::TREE:
    return start("tree");
  case Stage::HOMOLOGY:
    return start("homology");
  case Stage::FILTER:
    return start("filter");
  case Stage::FLATTENING:
    return start("flatten");
  }
  start("other");
}
