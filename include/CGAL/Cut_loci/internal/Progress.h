// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_PROGRESS_H
#define CGAL_CUT_LOCI_INTERNAL_PROGRESS_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL::Cut_loci::internal {

// Tells whoever wants to know which share of the work is done. What the receiver throws leaves the work.
class Progress
{
public:
  Progress() = default;
  explicit Progress(std::function<void(double)> receiver) : receiver_(std::move(receiver)) {}

  bool is_wanted() const { return receiver_ != nullptr; }

  void operator()(double share) const
  {
    if(is_wanted())
      receiver_(first_ + share * (last_ - first_));
  }

  // the same at step `i` of a loop of `n`, every few thousand times: a few milliseconds of any loop there is
  void operator()(std::size_t i, std::size_t n) const
  {
    if(i % 4096 == 0)
      (*this)(static_cast<double>(i) / static_cast<double>(n));
  }

  // that of a part of the work
  Progress part(double first, double last) const
  {
    Progress result(*this);
    result.first_ = first_ + first * (last_ - first_);
    result.last_ = first_ + last * (last_ - first_);
    return result;
  }

  // for a loop whose steps are of different sizes: called with the work that is done, it tells of that whenever it has
  // grown by some thousands
  class Counter
  {
  public:
    Counter(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}

    void operator()(std::size_t done)
    {
      if(done < next_)
        return;
      progress_(static_cast<double>(done) / static_cast<double>((std::max)(total_, std::size_t(1))));
      next_ = done + 4096;
    }

  private:
    const Progress& progress_;
    std::size_t total_, next_ = 0;
  };

private:
  std::function<void(double)> receiver_;
  double first_ = 0., last_ = 1.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_PROGRESS_H
