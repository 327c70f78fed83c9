// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_LABELS_HALFEDGE_TRAIL_H
#define CGAL_CUT_LOCI_POLYHEDRAL_LABELS_HALFEDGE_TRAIL_H

#include <CGAL/Cut_loci/Index.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <limits>
#include <mutex>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * leads from one run of windows to another one that follows it in a thread of its own: the halfedges at which the first one
 * has found something, and how far its front is.
 */
class Halfedge_trail
{
public:
  /// is thrown where the second run is not wanted any more
  struct Stopped
  {
  };

  /// @param step by which the front moves on before the second run is told
  explicit Halfedge_trail(double step) : step_(step) {}

  // -- the first run ---------------------------------------------------------------------------------------------------

  void add(Index h) { new_.push_back(h); }

  void advance(double front)
  {
    if(front < next_)
      return;
    next_ = front + step_;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      halfedges_.insert(halfedges_.end(), new_.begin(), new_.end());
      front_ = front;
    }
    has_advanced_.notify_one();
    new_.clear();
  }

  void end() { advance(infinity); }

  void stop()
  {
    is_stopped_ = true;
    end();
  }

  // -- the second run --------------------------------------------------------------------------------------------------

  /// waits until the first run is that far, and calls `function(h)` for the halfedges that are new
  template <typename Function>
  void follow_to(double front, const Function& function)
  {
    if(front < known_)
      return;
    std::unique_lock<std::mutex> lock(mutex_);
    has_advanced_.wait(lock, [&] { return front < front_; });
    known_ = front_;
    for(; number_ < halfedges_.size(); ++number_)
      function(halfedges_[number_]);
  }

  void throw_if_stopped() const
  {
    if(is_stopped_)
      throw Stopped();
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // of the first run
  double step_, next_ = 0.;
  std::vector<Index> new_;
  // of the second one
  double known_ = 0.;
  std::size_t number_ = 0;
  // of both
  std::mutex mutex_;
  std::condition_variable has_advanced_;
  double front_ = 0.;
  std::vector<Index> halfedges_;
  std::atomic<bool> is_stopped_{false};
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_LABELS_HALFEDGE_TRAIL_H
