// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOWS_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOWS_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is an interval of a halfedge with the straight paths that reach it, in the frame of the halfedge.
 *
 * All paths come from one point, the (pseudo-)source, whose unfolded image lies at `y <= 0`. Or they are parallel, and the
 * image, behind everything, is only the direction that they come from.
 */
struct Geodesic_window
{
  double a, b;  // the interval on the halfedge
  double x, y;  // the image of the source
  double sigma; // the distance of the image from the true source; where paths are parallel, that of the frame's origin
  double
    turn; // the rotation from this frame to the one of the (pseudo-)source, or the error if there are no directions
  double origin; // the number of the (pseudo-)source: that of a source, or the number of sources plus that of a vertex;
                 // where paths are parallel, `parallel` more
  // With an error and directions: a ray at the angle p in this frame leaves the origin in the direction turn + rate p.
  double rate = 1.;
  double error = 0.; // by how much distances may be too short

  static constexpr double parallel = 4294967296.; // which no number of an origin comes up to
  bool is_parallel() const { return origin >= parallel; }
  double distance(double t) const { return sigma + way(t); }
  double distance(double s, double t) const { return sigma + way(s, t); }
  /// of a point, without `sigma`
  double way(double t) const
  {
    return is_parallel() ? parallel_way(x, y, t, 0.) : std::sqrt((t - x) * (t - x) + y * y);
  }
  double way(double s, double t) const
  {
    return is_parallel() ? parallel_way(x, y, s, t) : std::sqrt((s - x) * (s - x) + (t - y) * (t - y));
  }

  /// from the origin of the frame, along parallel paths
  static double parallel_way(double x, double y, double s, double t)
  {
    return -(x * s + y * t) / std::sqrt(x * x + y * y);
  }
};

/*!
 * is a list of windows in one block of memory, one array per member of `Geodesic_window`.
 *
 * Only the first `columns` members are stored: 5 for distances alone, 6 with their errors, 7 with directions or with
 * several sources, and 9 with directions and errors.
 */
struct Geodesic_window_list
{
  std::uint32_t begin, end, capacity, size_class;

  std::uint32_t size() const { return end - begin; }
  bool empty() const { return begin == end; }

  double* column(std::size_t k) { return reinterpret_cast<double*>(this + 1) + k * capacity; }
  const double* column(std::size_t k) const { return reinterpret_cast<const double*>(this + 1) + k * capacity; }

  /// whether a window has parallel paths, which only those with an origin may have
  template <int columns>
  bool is_parallel(std::size_t i) const
  {
    return columns == 7 && column(6)[i] >= Geodesic_window::parallel;
  }

  /// of a point from the image of a window, in its frame
  template <int columns>
  double distance(std::size_t i, double s, double t) const
  {
    const double x = column(2)[i], y = column(3)[i], sigma = column(4)[i];
    return sigma + (is_parallel<columns>(i) ? Geodesic_window::parallel_way(x, y, s, t)
                                            : std::sqrt((s - x) * (s - x) + (t - y) * (t - y)));
  }

  template <int columns>
  Geodesic_window get(std::size_t i) const
  {
    const double* p = column(0) + i;
    Geodesic_window w{p[0], p[capacity], p[2 * capacity], p[3 * capacity], p[4 * capacity], 0., 0.};
    if(columns > 5)
      w.turn = p[5 * capacity];
    if(columns > 6)
      w.origin = p[6 * capacity];
    if(columns > 7)
    {
      w.rate = p[7 * capacity];
      w.error = p[8 * capacity];
    }
    return w;
  }

  template <int columns>
  void set(std::size_t i, const Geodesic_window& w)
  {
    double* p = column(0) + i;
    p[0] = w.a;
    p[capacity] = w.b;
    p[2 * capacity] = w.x;
    p[3 * capacity] = w.y;
    p[4 * capacity] = w.sigma;
    if(columns > 5)
      p[5 * capacity] = w.turn;
    if(columns > 6)
      p[6 * capacity] = w.origin;
    if(columns > 7)
    {
      p[7 * capacity] = w.rate;
      p[8 * capacity] = w.error;
    }
  }

  template <int columns>
  void append(const Geodesic_window& w)
  {
    set<columns>(end++, w);
  }

  template <int columns>
  void append(const Geodesic_window_list& other)
  {
    const double* from = other.column(0) + other.begin;
    double* to = column(0) + end;
    const std::size_t n = other.size();
    // two at a time, without a rest: there is room behind the last window
    for(std::size_t i = 0; i < n; i += 2)
      for(std::size_t k = 0; k < columns; ++k)
        std::memcpy(to + k * capacity + i, from + k * other.capacity + i, 2 * sizeof(double));
    end += other.size();
  }

  template <int columns>
  void move(std::size_t from, std::size_t to)
  {
    double* p = column(0);
    for(std::size_t k = 0; k < columns; ++k, p += capacity)
      p[to] = p[from];
  }
};

static_assert(sizeof(Geodesic_window_list) == 2 * sizeof(double), "the columns follow the header");

/// hands out window lists from large chunks, with one free list per size, so that memory is reused at once.
class Geodesic_window_pool
{
public:
  /// an empty list with room for `n` windows of `columns` members
  template <int columns>
  Geodesic_window_list* allocate(std::size_t n)
  {
    // Hardly any gap between the columns: a list takes as few cache lines as possible. The room for one or two more
    // lets loops go by pairs: branches at their end for a single one are hard to predict.
    const std::size_t capacity = n + 2 - (n & 1);
    std::size_t lines = (2 + columns * capacity + doubles_per_line - 1) / doubles_per_line;
    const std::uint32_t size_class = round_up(lines);
    if(size_class >= free_.size())
      free_.resize(size_class + 1);
    std::vector<Geodesic_window_list*>& free_lists = free_[size_class];
    void* place;
    if(!free_lists.empty())
    {
      place = free_lists.back();
      free_lists.pop_back();
    }
    else
      place = new_lines(lines);
    return new(place) Geodesic_window_list{0, 0, static_cast<std::uint32_t>(capacity), size_class};
  }

  void release(Geodesic_window_list* list) { free_[list->size_class].push_back(list); }

  /// takes back all lists
  void clear()
  {
    for(std::vector<Geodesic_window_list*>& free_lists : free_)
      free_lists.clear();
    current_ = 0;
    next_ = 0;
  }

private:
  struct alignas(64) Line
  {
    double values[8];
  };
  static constexpr std::size_t doubles_per_line = 8;

  struct Chunk
  {
    std::unique_ptr<Line[]> lines;
    std::size_t size;
  };

  /// rounds up to the next size there is, 16 to 32 of them per power of two, and returns its number
  static std::uint32_t round_up(std::size_t& lines)
  {
    std::uint32_t shift = 0;
    while(lines >> shift >= 32)
      ++shift;
    const std::size_t rounded = (lines + (std::size_t(1) << shift) - 1) >> shift;
    lines = rounded << shift;
    return static_cast<std::uint32_t>(16 * shift + rounded);
  }

  Line* new_lines(std::size_t n)
  {
    while(current_ < chunks_.size() && next_ + n > chunks_[current_].size)
    {
      ++current_;
      next_ = 0;
    }
    if(current_ == chunks_.size())
    {
      const std::size_t size = n > chunk_size ? n : chunk_size;
      // zeros, for the windows behind the last one that loops by pairs compute in vain
      chunks_.push_back(Chunk{std::unique_ptr<Line[]>(new Line[size]()), size});
    }
    Line* place = chunks_[current_].lines.get() + next_;
    next_ += n;
    return place;
  }

  static constexpr std::size_t chunk_size = std::size_t(1) << 12;

  std::vector<Chunk> chunks_;
  std::vector<std::vector<Geodesic_window_list*>> free_;
  std::size_t current_ = 0, next_ = 0; // the chunk in use, and its first line not in use
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_WINDOWS_H
