// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_DRAW_BY_LABELS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_DRAW_BY_LABELS_H

#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Cut_loci::internal {

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
    start();
    while(!pairs_.empty())
    {
      const Pair pair = pairs_.top();
      pairs_.pop();
      if(part_[pair.first] == part_[pair.second] && part_[pair.first] != null_index)
        join(pair.first, pair.second);
    }
    std::vector<Part> parts(number_of_parts_);
    for(Index i = 0; i < changes_.size(); ++i)
      if(part_[i] != null_index)
        parts[part_[i]].push_back(i);
    for(const Part& part : parts)
      if(part.size() > 1)
        draw_star(part);
  }

private:
  using Part = std::vector<Index>; // changes, in order

  // of changes that undo each other, in their order
  struct Pair
  {
    double squared_length;
    Index first, second;

    bool operator<(const Pair& other) const // the nearest is the top one
    {
      return std::tie(other.squared_length, other.first, other.second) < std::tie(squared_length, first, second);
    }
  };

  /// all changes in one part
  void start()
  {
    const Index n = static_cast<Index>(changes_.size());
    part_.assign(n, 0);
    number_of_parts_ = 1;
    next_.resize(n);
    for(Index i = 0; i < n; ++i)
      next_[i] = i + 1 < n ? i + 1 : 0;
    for(Index i = 0; i < n; ++i)
      for(Index k = i + 1; k < n; ++k)
        add_pair(i, k);
  }

  /// Between neighbors there is one cell.
  void add_pair(Index i, Index k)
  {
    const Face_change &a = changes_[i], &b = changes_[k];
    if((next_[i] == k || is_same_image(a.after, b.before)) && (next_[k] == i || is_same_image(a.before, b.after)))
      pairs_.push({squared_distance(a.point, b.point), i, k});
  }

  /// by a piece, which leaves two parts; in each, the changes at its two ends are neighbors now
  void join(Index a, Index b)
  {
    add_piece(a, b);
    close(next_[a], b, number_of_parts_++);
    close(next_[b], a, part_[a]);
    part_[a] = part_[b] = null_index;
  }

  /// makes a part of its own of what is from `first` on, before `end`
  void close(Index first, Index end, Index part)
  {
    if(first == end)
      return;
    Index last = first;
    for(Index i = first; i != end; i = next_[i])
    {
      part_[i] = part;
      last = i;
    }
    next_[last] = first;
    if(first != last)
      add_pair((std::min)(first, last), (std::max)(first, last));
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

  /// whether a point is in a triangle
  static bool is_among(const Plane_point& p, const Plane_point& a, const Plane_point& b, const Plane_point& c)
  {
    return cross(a, b, p) > 0. && cross(b, c, p) > 0. && cross(c, a, p) > 0.;
  }

  const std::vector<Face_change>& changes_;
  std::vector<Plane_point>& nodes_;
  std::vector<Face_ridge>& ridges_;
  std::vector<Index> part_, next_; // of each change; null if a piece ends there
  Index number_of_parts_ = 0;
  std::priority_queue<Pair> pairs_;
};

/// adds what is in a face to its nodes, one for each change at first, and to its pieces
inline void draw_by_labels(const std::vector<Face_change>& changes, std::vector<Plane_point>& nodes,
                           std::vector<Face_ridge>& ridges)
{
  Drawing_by_labels(changes, nodes, ridges)();
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_DRAW_BY_LABELS_H
