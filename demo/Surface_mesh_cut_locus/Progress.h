// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_PROGRESS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_PROGRESS_H

#include <CGAL/Cut_loci/Default_visitor.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

// Takes the time of the stages, those of the library as its visitor, and shows them on the standard error stream.
class Progress
{
public:
  explicit Progress(bool is_quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void start(const std::string& stage);
  void end();

  void start_stage(CGAL::Cut_loci::Stage stage);
  void end_stage(CGAL::Cut_loci::Stage) { end(); }
  // Shows the share of the stage that is done, if somebody looks and it takes long.
  void progress(CGAL::Cut_loci::Stage stage, double share);

  // In the order in which they came first.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

  template <typename Function>
  auto run(const std::string& stage, const Function& function)
  {
    struct Scope
    {
      Progress& progress;
      ~Scope() { progress.end(); }
    };
    start(stage);
    const Scope scope = {*this};
    return function();
  }

private:
  using Clock = std::chrono::steady_clock;

  bool is_quiet_, is_terminal_;
  std::string stage_; // empty between stages
  Clock::time_point start_, shown_;
  std::vector<std::pair<std::string, double>> seconds_;
};

// The visitor that passes what a solver does to a progress, if there is one.
class Progress_visitor
{
public:
  explicit Progress_visitor(Progress* progress) : progress_(progress) {}

  void start_stage(CGAL::Cut_loci::Stage stage)
  {
    if(progress_ != nullptr)
      progress_->start_stage(stage);
  }
  void end_stage(CGAL::Cut_loci::Stage stage)
  {
    if(progress_ != nullptr)
      progress_->end_stage(stage);
  }
  void progress(CGAL::Cut_loci::Stage stage, double share)
  {
    if(progress_ != nullptr)
      progress_->progress(stage, share);
  }

private:
  Progress* progress_;
};

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_PROGRESS_H
