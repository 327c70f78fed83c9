// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_MOLLIFIED_LENGTHS_H
#define CGAL_CUT_LOCI_SURFACE_MOLLIFIED_LENGTHS_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

inline std::array<double, 3> edge_lengths(const Indexed_triangle_mesh& mesh, Index f)
{
  return {{edge_length(mesh, 3 * f), edge_length(mesh, 3 * f + 1), edge_length(mesh, 3 * f + 2)}};
}

/// the median of those that have a length: neither long spikes nor points that coincide matter
inline double usual_edge_length(const Indexed_triangle_mesh& mesh)
{
  std::vector<double> length(mesh.number_of_halfedges());
  double longest = 0.;
  for(Index h = 0; h < length.size(); ++h)
  {
    length[h] = edge_length(mesh, h);
    longest = (std::max)(longest, length[h]);
  }
  constexpr double least = 1e-12; // of the longest: rounding of coordinates
  length.erase(std::remove_if(length.begin(), length.end(), [longest](double l) { return !(l > least * longest); }),
               length.end());
  const auto middle = length.begin() + static_cast<std::ptrdiff_t>(length.size() / 2);
  std::nth_element(length.begin(), middle, length.end());
  return length.empty() ? 0. : *middle;
}

// Whether a face has a shape to compute with. Below the first bound, in proportion to its size, the rounding of coordinates
// decides it. Below the second, of its height, it can not be told from a line, as paths at 1e-9 of an edge from its end are
// taken for ones through that; faces of a spike, which is long, are as high as others.
inline bool has_area(const std::array<double, 3>& length, double twice_area, double usual)
{
  constexpr double least_relative_area = 1e-13, least_relative_height = 1e-9;
  const double longest = *std::max_element(length.begin(), length.end());
  return twice_area > least_relative_area * longest * longest && // also fails on NaN and infinity
         twice_area > least_relative_height * (std::min)(longest, usual) * longest &&
         twice_area < (std::numeric_limits<double>::max)();
}

inline bool has_area(const Indexed_triangle_mesh& mesh, Index f, double usual)
{
  return has_area(edge_lengths(mesh, f), apex(mesh, 3 * f)[1] * edge_length(mesh, 3 * f), usual);
}

/*!
 * gives faces that are flat, or nearly so, some area, so that they have angles.
 *
 * - Edges of these faces that are shorter than a millionth of another one there, or of a usual edge if that is less, get this
 *   length: paths at a distance of 1e-9 of an edge from its end are taken for ones through that, so that on shorter edges
 *   nothing could be told apart.
 * - The same is added to all lengths: the least that leaves these faces slack in their triangle inequality, in proportion to
 *   the same length, as in \cgalCite{cgal:sc-lnt-20}.
 *
 * No distance gets shorter by more than 1e-12 of it: the second step adds to squares of lengths those of a triangle, as the
 * square roots of edge lengths satisfy the triangle inequality. In a face whose longest edge is l, a path gains at most
 * l / 10^6 by the first and sqrt(2 l epsilon + epsilon^2) by the second step, which is about the same.
 */
class Mollification
{
public:
  explicit Mollification(const Indexed_triangle_mesh& mesh) : usual_(usual_edge_length(mesh))
  {
    lengthen_short_edges(mesh);
    add_slack();
  }

  std::vector<double> lengths; ///< of the halfedges
  double most_gained = 0.;     ///< by a path in a face

private:
  // far above the 1e-9 at which vertices are passed, and far below what matters
  static constexpr double shortest = 1e-6;
  // of a needle, whose height is then the root of twice that: 1.4e-6 of its length, as that of short edges
  static constexpr double slack = 1e-12;

  double size(const std::array<double, 3>& length) const { return (std::min)(longest(length), usual_); }
  static double longest(const std::array<double, 3>& length) { return *std::max_element(length.begin(), length.end()); }

  void lengthen_short_edges(const Indexed_triangle_mesh& mesh)
  {
    lengths.resize(mesh.number_of_halfedges());
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      lengths[h] = edge_length(mesh, h);
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
      if(const double least = shortest * size(edge_lengths(mesh, f)); !has_area(mesh, f, usual_))
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
          if(lengths[h] < least)
            lengthen(mesh, h, least);
    // faces all of whose edges are short: where one has become too long for the others, they become as long
    for(bool is_done = false; !is_done;)
    {
      is_done = true;
      for(Index f = 0; f < mesh.number_of_faces(); ++f)
      {
        const std::array<double, 3> length = of_face(f);
        if(!(longest(length) <= most_gained) || Triangle_shape::slack(length) >= 0.)
          continue;
        is_done = false;
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
          lengthen(mesh, h, longest(length));
      }
    }
  }

  void lengthen(const Indexed_triangle_mesh& mesh, Index h, double length)
  {
    lengths[h] = length;
    if(!mesh.is_border_edge(h))
      lengths[mesh.opposite[h]] = length;
    if(length > edge_length(mesh, h))
      most_gained = (std::max)(most_gained, length);
  }

  std::array<double, 3> of_face(Index f) const
  {
    const std::size_t h = 3 * std::size_t(f);
    return {{lengths[h], lengths[h + 1], lengths[h + 2]}};
  }

  void add_slack()
  {
    double epsilon = 0., longest_of_all = 0.;
    for(Index f = 0; f < lengths.size() / 3; ++f)
    {
      const std::array<double, 3> length = of_face(f);
      if(!has_area(length, Triangle_shape(length).twice_area, usual_))
        epsilon = (std::max)(epsilon, slack * size(length) - Triangle_shape::slack(length));
      longest_of_all = (std::max)(longest_of_all, longest(length));
    }
    for(double& length : lengths)
      length += epsilon;
    most_gained += std::sqrt(epsilon * (2. * longest_of_all + epsilon));
  }

  double usual_;
};

/// whether some faces have no area, and others have: if none has, or a length is not finite, nothing helps
inline bool needs_mollification(const Indexed_triangle_mesh& mesh)
{
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!std::isfinite(edge_length(mesh, h)))
      return false;
  const double usual = usual_edge_length(mesh);
  Index number_with_area = 0;
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
    number_with_area += has_area(mesh, f, usual);
  return 0 < number_with_area && number_with_area < mesh.number_of_faces();
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_MOLLIFIED_LENGTHS_H
