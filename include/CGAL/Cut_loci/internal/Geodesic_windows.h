// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_GEODESIC_WINDOWS_H
#define CGAL_CUT_LOCI_INTERNAL_GEODESIC_WINDOWS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * is an interval of a halfedge with the straight paths that reach it, in the frame of the halfedge.
 *
 * All paths come from one point, the (pseudo-)source, whose unfolded image lies at `y <= 0`.
 */
struct Geodesic_window
{
  double a, b;    // the interval on the halfedge
  double x, y;    // the image of the source
  double sigma;   // the distance of the image from the true source
  double turn;    // sigma == 0: the rotation from this frame to the one of the source; else the direction at the source
  double nearest; // the number of the true source

  double distance(double t) const { return sigma + std::sqrt((t - x) * (t - x) + y * y); }
};

/*!
 * is a list of windows in one block of memory, one array per member of `Geodesic_window`.
 *
 * Only the first `columns` members are stored: 5 without directions, 6 with them, 7 with several sources.
 */
struct Geodesic_window_list
{
  std::uint32_t begin, end, capacity, size_class;

  std::uint32_t size() const { return end - begin; }
  bool empty() const { return begin == end; }

  double* column(std::size_t k) { return reinterpret_cast<double*>(this + 1) + k * capacity; }
  const double* column(std::size_t k) const { return reinterpret_cast<const double*>(this + 1) + k * capacity; }

  template <int columns>
  Geodesic_window get(std::size_t i) const
  {
    const double* p = column(0) + i;
    Geodesic_window w{p[0], p[capacity], p[2 * capacity], p[3 * capacity], p[4 * capacity], 0., 0.};
    if(columns > 5)
      w.turn = p[5 * capacity];
    if(columns > 6)
      w.nearest = p[6 * capacity];
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
      p[6 * capacity] = w.nearest;
  }

  template <int columns>
  void append(const Geodesic_window& w) { set<columns>(end++, w); }

  template <int columns>
  void append(const Geodesic_window_list& other)
  {
    for(std::size_t k = 0; k < columns; ++k) {
      const double* from = other.column(k) + other.begin;
      double* to = column(k) + end;
      for(std::size_t i = 0, n = other.size(); i < n; ++i)
        to[i] = from[i];
    }
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

/// hands out window lists from large chunks, with one free list per power of two, so that memory is reused at once.
class Geodesic_window_pool
{
public:
  /// an empty list with room for `n` windows of `columns` members
  Geodesic_window_list* allocate(std::size_t n)
  {
    const std::uint32_t size_class = class_of_size(n);
    if(size_class >= m_free.size())
      m_free.resize(size_class + 1);
    std::vector<Geodesic_window_list*>& free_lists = m_free[size_class];
    Geodesic_window_list* list;
    if(!free_lists.empty()) {
      list = free_lists.back();
      free_lists.pop_back();
    } else {
      // room for the largest number of columns: a pool serves runs with and without directions
      list = new_list(size_class, 2 + 7 * (std::size_t(1) << size_class));
    }
    list->begin = list->end = 0;
    return list;
  }

  void release(Geodesic_window_list* list) { m_free[list->size_class].push_back(list); }

  /// takes back all lists
  void clear()
  {
    for(std::vector<Geodesic_window_list*>& free_lists : m_free)
      free_lists.clear();
    m_chunks.clear();
    m_next = m_left = 0;
  }

private:
  /// the least power of two, from four on, that is not less than `n`
  static std::uint32_t class_of_size(std::size_t n)
  {
    if(n <= 4)
      return 2;
#if defined(__GNUC__)
    return static_cast<std::uint32_t>(8 * sizeof(unsigned long long)) -
           static_cast<std::uint32_t>(__builtin_clzll(static_cast<unsigned long long>(n - 1)));
#else
    std::uint32_t size_class = 3;
    while((std::size_t(1) << size_class) < n)
      ++size_class;
    return size_class;
#endif
  }

  Geodesic_window_list* new_list(std::uint32_t size_class, std::size_t doubles)
  {
    if(doubles > m_left) {
      const std::size_t chunk = doubles > chunk_size ? doubles : chunk_size;
      m_chunks.emplace_back(new double[chunk]);
      m_next = 0;
      m_left = chunk;
    }
    double* place = m_chunks.back().get() + m_next;
    m_next += doubles;
    m_left -= doubles;
    return new(place) Geodesic_window_list{0, 0, std::uint32_t(1) << size_class, size_class};
  }

  static constexpr std::size_t chunk_size = std::size_t(1) << 15;

  std::vector<std::unique_ptr<double[]>> m_chunks;
  std::vector<std::vector<Geodesic_window_list*>> m_free;
  std::size_t m_next = 0, m_left = 0;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_GEODESIC_WINDOWS_H
