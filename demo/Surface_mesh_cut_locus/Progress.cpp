// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Progress.h"

#include <algorithm>
#include <cstdio>
#include <exception>

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
  start_ = Clock::now();
}

void Progress::end()
{
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
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
  }
  start("other");
}
