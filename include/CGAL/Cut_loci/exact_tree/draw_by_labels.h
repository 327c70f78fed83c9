// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_DRAW_BY_LABELS_H
#define CGAL_CUT_LOCI_EXACT_TREE_DRAW_BY_LABELS_H

#include <CGAL/Cut_loci/exact_tree/Image_bisector.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// is a point of the boundary of a face at which the label changes, as one goes around the face counterclockwise.
struct Face_change
{
  Plane_point point;
  Index edge; // of the face, or null at a corner, where the piece starts
  Image before, after;
  bool is_ray;    // both paths come along the same line: one of them bends, and this is the boundary of its shadow
  bool is_shadow; // they are one path, so that this is no cut locus
  double strength = 0.; // where images do not fit exactly: a star is put on the line between the two strongest
};

/// is a piece between two images in a face.
struct Face_ridge
{
  Index nodes[2];
  Image images[2];
  bool is_shadow;
};

/*!
 * draws the cut locus in a face where its images do not fit each other, so that nothing can be computed from them: the
 * labels alone tell what belongs together.
 *
 * A piece between two cells starts where one gives way to the other on the boundary, and ends where it is the other way
 * around, the nearest of all such places. It leaves two parts of the boundary, in which the same holds again; where three
 * cells or more meet, no two changes fit, and a star joins them. All is straight: since a face is convex, and the places
 * are in order around it, no two pieces cross each other.
 */
class Drawing_by_labels
{
public:
  Drawing_by_labels(const std::vector<Face_change>& changes, std::vector<Plane_point>& nodes,
                    std::vector<Face_ridge>& ridges)
    : changes_(changes), nodes_(nodes), ridges_(ridges)
  {
  }

  void operator()()
  {
    std::vector<Part> parts(1);
    for(Index i = 0; i < changes_.size(); ++i)
      parts.front().push_back(i);
    while(!parts.empty())
    {
      const Part part = std::move(parts.back());
      parts.pop_back();
      std::array<std::size_t, 2> ends;
      if(part.size() < 2)
        continue;
      if(!find_nearest(part, ends))
      {
        draw_star(part);
        continue;
      }
      add_piece(part[ends[0]], part[ends[1]]);
      Part inside(part.begin() + offset(ends[0]) + 1, part.begin() + offset(ends[1]));
      Part outside(part.begin(), part.begin() + offset(ends[0]));
      outside.insert(outside.end(), part.begin() + offset(ends[1]) + 1, part.end());
      parts.push_back(std::move(inside));
      parts.push_back(std::move(outside));
    }
  }

private:
  using Part = std::vector<Index>; // changes, in order

  static std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  static double squared_distance(const Plane_point& a, const Plane_point& b)
  {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  }

  /// of the changes that undo each other, the nearest two; returns whether there are any
  bool find_nearest(const Part& part, std::array<std::size_t, 2>& ends) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < part.size(); ++i)
      for(std::size_t k = i + 1; k < part.size(); ++k)
      {
        const Face_change &a = changes_[part[i]], &b = changes_[part[k]];
        const double length = squared_distance(a.point, b.point);
        // between neighbors there is one cell
        const bool is_next = k == i + 1, is_previous = i == 0 && k + 1 == part.size();
        if(length < least && (is_next || is_same_image(a.after, b.before)) &&
           (is_previous || is_same_image(a.before, b.after)))
        {
          least = length;
          ends = {{i, k}};
        }
      }
    return least < std::numeric_limits<double>::infinity();
  }

  void add_piece(Index a, Index b)
  {
    const Face_change &first = changes_[a], &second = changes_[b];
    ridges_.push_back({{a, b}, {first.before, first.after}, first.is_shadow && second.is_shadow});
  }

  void draw_star(const Part& part)
  {
    Plane_point point{0., 0.};
    for(Index i : part)
    {
      point.x += changes_[i].point.x / static_cast<double>(part.size());
      point.y += changes_[i].point.y / static_cast<double>(part.size());
    }
    if(part.size() != 3 || !find_node_of_three(part, point))
      move_to_strongest(part, point);
    nodes_.push_back(point);
    const Index node = static_cast<Index>(nodes_.size() - 1);
    for(Index i : part)
      ridges_.push_back({{i, node}, {changes_[i].before, changes_[i].after}, changes_[i].is_shadow});
  }

  /// the point at the same distance from three images, if it is between the three changes
  bool find_node_of_three(const Part& part, Plane_point& point) const
  {
    const Face_change &a = changes_[part[0]], &b = changes_[part[1]], &c = changes_[part[2]];
    std::array<Plane_point, 2> candidates;
    const std::size_t n = equidistant_points(a.before, b.before, c.before, candidates);
    bool is_found = false;
    for(std::size_t i = 0; i < n; ++i)
      if(is_among(candidates[i], a.point, b.point, c.point))
      {
        point = candidates[i];
        is_found = true;
      }
    return is_found;
  }

  void move_to_strongest(const Part& part, Plane_point& point) const
  {
    std::array<Index, 2> best = {{null_index, null_index}};
    for(Index i : part)
      if(best[0] == null_index || changes_[i].strength > changes_[best[0]].strength)
        best = {{i, best[0]}};
      else if(best[1] == null_index || changes_[i].strength > changes_[best[1]].strength)
        best[1] = i;
    if(!(changes_[best[1]].strength > 0.))
      return;
    const Plane_point &p = changes_[best[0]].point, &q = changes_[best[1]].point;
    const double l = squared_distance(p, q);
    const double s = l > 0. ? ((point.x - p.x) * (q.x - p.x) + (point.y - p.y) * (q.y - p.y)) / l : 0.;
    const double t = (std::min)((std::max)(s, 0.), 1.);
    point = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

  static double cross(const Plane_point& a, const Plane_point& b, const Plane_point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  /// whether a point is in a triangle
  static bool is_among(const Plane_point& p, const Plane_point& a, const Plane_point& b, const Plane_point& c)
  {
    return cross(a, b, p) > 0. && cross(b, c, p) > 0. && cross(c, a, p) > 0.;
  }

  const std::vector<Face_change>& changes_;
  std::vector<Plane_point>& nodes_;
  std::vector<Face_ridge>& ridges_;
};

/// adds what is in a face to its nodes, one for each change at first, and to its pieces
inline void draw_by_labels(const std::vector<Face_change>& changes, std::vector<Plane_point>& nodes,
                           std::vector<Face_ridge>& ridges)
{
  Drawing_by_labels(changes, nodes, ridges)();
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_DRAW_BY_LABELS_H
