// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_NESTED_DISSECTION_H
#define CGAL_CUT_LOCI_FLATTENING_NESTED_DISSECTION_H

#include <CGAL/Cut_loci/Index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A tree of parts of a triangulation: the vertices of a part separate those of the parts below it from each other
// [George, 1973]. Parts come after those below them.
class Nested_dissection
{
public:
  struct Part
  {
    std::vector<Index> vertices;
    std::vector<int> below; // at most two
  };

  // `points` tell where to halve: as close to the shape of the triangulation as may be. Only `vertices` are dissected.
  Nested_dissection(const std::vector<std::array<Index, 3>>& triangles,
                    const std::vector<std::array<double, 3>>& points, std::vector<Index> vertices)
    : triangles_(triangles), points_(points), is_low_(points.size(), false)
  {
    find_faces();
    dissect(vertices, 0, vertices.size());
  }

  std::vector<Part> parts;

private:
  // with fewer vertices, the matrix of a part is as quickly taken for a dense one
  static constexpr std::size_t least_size = 8;

  void find_faces()
  {
    first_.assign(points_.size() + 1, 0);
    for(const auto& t : triangles_)
      for(const Index v : t)
        ++first_[v + 1];
    for(std::size_t v = 0; v < points_.size(); ++v)
      first_[v + 1] += first_[v];
    faces_.resize(3 * triangles_.size());
    std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
    for(std::size_t f = 0; f < triangles_.size(); ++f)
      for(const Index v : triangles_[f])
        faces_[at[v]++] = f;
  }

  bool has_low_neighbor(Index v) const
  {
    for(std::size_t k = first_[v]; k < first_[v + 1]; ++k)
      for(const Index w : triangles_[faces_[k]])
        if(is_low_[w])
          return true;
    return false;
  }

  std::size_t longest_axis(const std::vector<Index>& vertices, std::size_t first, std::size_t last) const
  {
    std::array<double, 3> low = points_[vertices[first]], high = low;
    for(std::size_t k = first; k < last; ++k)
      for(std::size_t i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], points_[vertices[k]][i]);
        high[i] = (std::max)(high[i], points_[vertices[k]][i]);
      }
    std::size_t axis = 0;
    for(std::size_t i = 1; i < 3; ++i)
      if(high[i] - low[i] > high[axis] - low[axis])
        axis = i;
    return axis;
  }

  // The last part that is made is the one that separates.
  int dissect(std::vector<Index>& vertices, std::size_t first, std::size_t last)
  {
    Part part;
    if(last - first <= least_size)
      part.vertices.assign(vertices.begin() + first, vertices.begin() + last);
    else
    {
      const std::size_t axis = longest_axis(vertices, first, last), middle = first + (last - first) / 2;
      std::nth_element(vertices.begin() + first, vertices.begin() + middle, vertices.begin() + last,
                       [&](Index v, Index w)
                       { return points_[v][axis] != points_[w][axis] ? points_[v][axis] < points_[w][axis] : v < w; });
      for(std::size_t k = first; k < middle; ++k)
        is_low_[vertices[k]] = true;
      const auto separated = std::partition(vertices.begin() + middle, vertices.begin() + last,
                                            [&](Index v) { return !has_low_neighbor(v); });
      for(std::size_t k = first; k < middle; ++k)
        is_low_[vertices[k]] = false;
      part.vertices.assign(separated, vertices.begin() + last);
      const std::size_t end = separated - vertices.begin();
      part.below.push_back(dissect(vertices, first, middle));
      if(end > middle)
        part.below.push_back(dissect(vertices, middle, end));
    }
    parts.push_back(std::move(part));
    return static_cast<int>(parts.size()) - 1;
  }

  const std::vector<std::array<Index, 3>>& triangles_;
  const std::vector<std::array<double, 3>>& points_;
  std::vector<bool> is_low_;
  std::vector<std::size_t> first_, faces_; // those at each vertex
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_FLATTENING_NESTED_DISSECTION_H
