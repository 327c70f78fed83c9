// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_FACE_RIDGES_H
#define CGAL_CUT_LOCI_EXACT_TREE_FACE_RIDGES_H

#include <CGAL/Cut_loci/exact_tree/Image_bisector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * draws the cut locus in a face, given where it meets the boundary of the face.
 *
 * The cells of different labels all touch the boundary, since the shortest paths to their points come from there. So
 * the pieces between them form trees, whose leaves are points of the boundary: pieces start at all of these and, two
 * neighbors at a time, meet in a node and go on as one, until all have met. The next to meet are those whose node no
 * other path reaches earlier.
 */
class Face_ridges
{
public:
  /// is a point of the boundary at which the label changes, as one goes around the face counterclockwise.
  struct Change
  {
    Plane_point point;
    Image before, after;
    bool is_ray;    // both paths come along the same line: one of them bends, and this is the boundary of its shadow
    bool is_shadow; // they are one path, so that this is no cut locus
  };

  /// is a part of an edge of the face through which the straight paths from an image enter the face.
  struct Entry
  {
    Image image;
    Plane_point from, to; // counterclockwise
  };

  struct Ridge
  {
    Index nodes[2];
    Image images[2];
    bool is_shadow;
  };

  /// the nodes: first one for each change, then those inside
  std::vector<Plane_point> nodes;
  std::vector<Ridge> ridges;
  /// whether labels did not fit each other, so that the drawing is good to the size of the face only
  bool is_doubtful = false;

  /// @param are_one_path whether the paths from two images to a point of the face, on one line there, are the same
  /// @param tolerance up to which paths of different lengths are taken for equally long
  void draw(const std::array<Plane_point, 3>& corners, const std::vector<Change>& changes,
            const std::vector<Entry>& entries, double tolerance,
            const std::function<bool(const Image&, const Image&, const Plane_point&)>& are_one_path)
  {
    are_one_path_ = are_one_path;
    corners_ = corners;
    entries_ = &entries;
    tolerance_ = tolerance;
    start(changes);
    if(fronts_.size() > 2)
      for(std::size_t i = 0; i < fronts_.size(); ++i)
        find_meeting(i);
    while(fronts_.size() > 2 && join_next())
    {
    }
    const bool is_complete = fronts_.size() < 3;
    if(fronts_.size() == 2)
      connect(fronts_[0], fronts_[1]);
    is_doubtful = !is_complete || ridges_cross();
    if(!is_doubtful)
      return;
    // Labels that do not fit, or nodes that rounding has put on the wrong side: pieces that end each other, and a star
    // of the rest, are good to the size of the face and do not cross each other either.
    start(changes);
    while(fronts_.size() > 2 && join_ends())
    {
    }
    if(fronts_.size() == 2)
      connect(fronts_[0], fronts_[1]);
    else if(fronts_.size() > 2)
      join_all();
  }

private:
  static constexpr double least_angle = 1e-7; // below, directions are taken for the same
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  /// of a front with the next one
  struct Meeting
  {
    double excess = infinity; // by which a path to it is longer than the shortest one there
    Plane_point point = {0., 0.};
    bool is_end = false; // the two are one piece
  };

  struct Front
  {
    Index node; // where it is now
    Image before, after;
    bool is_ray, is_shadow;
    Meeting meeting;
  };

  static double cross(const Plane_point& a, const Plane_point& b, const Plane_point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  /// whether `p` is in the cone of an entry, up to rounding: what is beside it by a little is longer by the square of that
  static bool sees(const Entry& e, const Plane_point& p)
  {
    const Plane_point image{e.image.x, e.image.y};
    const double l = std::hypot(e.to.x - e.from.x, e.to.y - e.from.y) + std::hypot(p.x - image.x, p.y - image.y);
    return cross(image, e.from, p) <= 1e-9 * l * l && cross(image, e.to, p) >= -1e-9 * l * l;
  }

  /// by how much a straight path from an image to `p` is longer than the shortest one; infinite if there is none
  double excess(const Plane_point& p, const Image& a, const Image& b, const Image& c)
  {
    double least = infinity;
    bool sees_a = false, sees_b = false, sees_c = false;
    for(const Entry& e : *entries_)
      if(sees(e, p))
      {
        least = (std::min)(least, e.image.distance(p));
        sees_a = sees_a || is_same_path(e.image, a, p);
        sees_b = sees_b || is_same_path(e.image, b, p);
        sees_c = sees_c || is_same_path(e.image, c, p);
      }
    return sees_a && sees_b && sees_c ? (std::max)(b.distance(p) - least, 0.) : infinity;
  }

  static bool is_same_path(const Image& a, const Image& b, const Plane_point& p)
  {
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    const double cross = ax * by - ay * bx, aa = ax * ax + ay * ay, bb = bx * bx + by * by;
    // where the path bends, nothing is left of one of them
    if(aa == 0. || bb == 0.)
      return true;
    return ax * bx + ay * by > 0. && cross * cross <= least_angle * least_angle * aa * bb;
  }

  /// whether `p` is in the face, which rounding may deny; it is moved there then
  bool clamp(Plane_point& p) const
  {
    const double area = cross(corners_[0], corners_[1], corners_[2]);
    std::array<double, 3> c;
    double sum = 0.;
    for(std::size_t i = 0; i < 3; ++i)
    {
      c[i] = cross(p, corners_[(i + 1) % 3], corners_[(i + 2) % 3]) / area;
      if(!(c[i] >= -1e-6))
        return false;
      c[i] = (std::max)(c[i], 0.);
      sum += c[i];
    }
    p = {0., 0.};
    for(std::size_t i = 0; i < 3; ++i)
    {
      p.x += c[i] / sum * corners_[i].x;
      p.y += c[i] / sum * corners_[i].y;
    }
    return true;
  }

  /// the boundary of a shadow leads away from the image of what casts it
  static Plane_point light(const Front& f)
  {
    const Image& image = f.before.sigma < f.after.sigma ? f.before : f.after;
    return {image.x, image.y};
  }

  /// the vertex that casts the shadow, as an origin
  static Index bend(const Front& f) { return f.before.sigma < f.after.sigma ? f.after.origin : f.before.origin; }

  void find_meeting(std::size_t i)
  {
    Front& first = fronts_[i];
    const Front& second = fronts_[i + 1 < fronts_.size() ? i + 1 : 0];
    first.meeting = Meeting();
    std::array<Plane_point, 2> points;
    std::size_t n = 0;
    const Plane_point &p = nodes[first.node], &q = nodes[second.node];
    if(is_same_image(first.before, second.after))
    {
      first.meeting.is_end = true;
      points[0] = middle(first, second);
      n = 1;
    }
    else if(!first.is_ray && !second.is_ray)
      n = equidistant_points(first.before, first.after, second.after, points);
    else if(first.is_ray && second.is_ray && bend(first) == bend(second))
      return; // both sides of one shadow
    else if(first.is_ray && second.is_ray)
      n = intersection(p, light(first), q, light(second), points);
    else if(first.is_ray)
      n = equidistant_points(p, light(first), second.before, second.after, points);
    else
      n = equidistant_points(q, light(second), first.before, first.after, points);
    for(std::size_t k = 0; k < n; ++k)
    {
      Plane_point x = points[k];
      if(!clamp(x))
        continue;
      const double e = excess(x, first.before, first.after, second.after);
      if(e < first.meeting.excess)
      {
        first.meeting.excess = e;
        first.meeting.point = x;
      }
    }
  }

  /// a point of the piece between two fronts that end each other
  static Plane_point between(const Plane_point& p, const Plane_point& q, const Front& f)
  {
    const Plane_point m{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
    if(f.is_ray || f.before.sigma == f.after.sigma)
      return m;
    std::array<Plane_point, 2> points;
    const Plane_point beside{m.x - (q.y - p.y), m.y + (q.x - p.x)};
    const std::size_t n = equidistant_points(m, beside, f.before, f.after, points);
    Plane_point best = m;
    double least = 0.5 * std::hypot(q.x - p.x, q.y - p.y);
    for(std::size_t k = 0; k < n; ++k)
    {
      const double away = std::hypot(points[k].x - m.x, points[k].y - m.y);
      if(away < least)
      {
        least = away;
        best = points[k];
      }
    }
    return best;
  }
  Plane_point middle(const Front& a, const Front& b) const { return between(nodes[a.node], nodes[b.node], a); }

  static std::size_t intersection(const Plane_point& p, const Plane_point& a, const Plane_point& q,
                                  const Plane_point& b, std::array<Plane_point, 2>& points)
  {
    const double ux = a.x - p.x, uy = a.y - p.y, vx = b.x - q.x, vy = b.y - q.y;
    const double determinant = ux * vy - uy * vx;
    if(determinant == 0.)
      return 0;
    const double s = ((q.x - p.x) * vy - (q.y - p.y) * vx) / determinant;
    points[0] = {p.x + s * ux, p.y + s * uy};
    return 1;
  }

  /// lets two neighbors meet; returns whether any could
  bool join_next()
  {
    std::size_t best = 0;
    double least = infinity;
    for(std::size_t i = 0; i < fronts_.size(); ++i)
    {
      // of several that fit, the nearest
      const Meeting& m = fronts_[i].meeting;
      if(!(m.excess <= tolerance_))
        continue;
      const Plane_point &p = nodes[fronts_[i].node], &q = nodes[fronts_[i + 1 < fronts_.size() ? i + 1 : 0].node];
      const double way = std::hypot(m.point.x - p.x, m.point.y - p.y) + std::hypot(m.point.x - q.x, m.point.y - q.y);
      if(way < least)
      {
        least = way;
        best = i;
      }
    }
    if(least == infinity)
      return false;
    const std::size_t next = best + 1 < fronts_.size() ? best + 1 : 0;
    Front &first = fronts_[best], &second = fronts_[next];
    if(first.meeting.is_end)
    {
      connect(first, second);
      fronts_.erase(fronts_.begin() + static_cast<std::ptrdiff_t>((std::max)(best, next)));
      fronts_.erase(fronts_.begin() + static_cast<std::ptrdiff_t>((std::min)(best, next)));
      if(fronts_.size() > 2)
        find_meeting((best + fronts_.size() - (next == 0 ? 2 : 1)) % fronts_.size());
      return true;
    }
    const Index node = add_node(first.meeting.point);
    add_ridge(first, node);
    add_ridge(second, node);
    first.node = node;
    first.after = second.after;
    const Plane_point& p = nodes[node];
    first.is_ray = angle_at(p, first.before, first.after) < least_angle;
    first.is_shadow = first.is_ray && are_one_path_(first.before, first.after, p);
    fronts_.erase(fronts_.begin() + static_cast<std::ptrdiff_t>(next));
    const std::size_t i = next == 0 ? fronts_.size() - 1 : best;
    if(fronts_.size() > 2)
    {
      find_meeting(i);
      find_meeting((i + fronts_.size() - 1) % fronts_.size());
    }
    return true;
  }

  static double angle_at(const Plane_point& p, const Image& a, const Image& b)
  {
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    return std::atan2(std::fabs(ax * by - ay * bx), ax * bx + ay * by);
  }

  void start(const std::vector<Change>& changes)
  {
    nodes.clear();
    ridges.clear();
    fronts_.clear();
    for(const Change& c : changes)
    {
      fronts_.push_back({static_cast<Index>(nodes.size()), c.before, c.after, c.is_ray, c.is_shadow, Meeting()});
      nodes.push_back(c.point);
    }
  }

  /// connects the nearest two neighbors that end each other; returns whether there are any
  bool join_ends()
  {
    std::size_t best = fronts_.size();
    double least = infinity;
    for(std::size_t i = 0; i < fronts_.size(); ++i)
    {
      const Front &first = fronts_[i], &second = fronts_[i + 1 < fronts_.size() ? i + 1 : 0];
      const Plane_point &p = nodes[first.node], &q = nodes[second.node];
      const double length = std::hypot(p.x - q.x, p.y - q.y);
      if(length < least && is_same_image(first.before, second.after))
      {
        least = length;
        best = i;
      }
    }
    if(best == fronts_.size())
      return false;
    const std::size_t next = best + 1 < fronts_.size() ? best + 1 : 0;
    connect(fronts_[best], fronts_[next]);
    fronts_.erase(fronts_.begin() + static_cast<std::ptrdiff_t>((std::max)(best, next)));
    fronts_.erase(fronts_.begin() + static_cast<std::ptrdiff_t>((std::min)(best, next)));
    return true;
  }

  /// what fits nowhere meets in one point: several images at the same distance, up to the tolerance
  void join_all()
  {
    Plane_point point{0., 0.};
    for(const Front& f : fronts_)
    {
      point.x += nodes[f.node].x / static_cast<double>(fronts_.size());
      point.y += nodes[f.node].y / static_cast<double>(fronts_.size());
    }
    if(fronts_.size() == 3)
    {
      std::array<Plane_point, 2> candidates;
      const std::size_t n = equidistant_points(fronts_[0].before, fronts_[1].before, fronts_[2].before, candidates);
      for(std::size_t i = 0; i < n; ++i)
        if(is_among(candidates[i]))
          point = candidates[i];
    }
    const Index node = add_node(point);
    for(const Front& f : fronts_)
      add_ridge(f, node);
  }

  /// whether a point is in the triangle of the three fronts
  bool is_among(const Plane_point& p) const
  {
    const Plane_point &a = nodes[fronts_[0].node], &b = nodes[fronts_[1].node], &c = nodes[fronts_[2].node];
    return cross(a, b, p) > 0. && cross(b, c, p) > 0. && cross(c, a, p) > 0.;
  }

  /// whether two pieces that are on the cut locus cross each other
  bool ridges_cross() const
  {
    for(std::size_t i = 0; i < ridges.size(); ++i)
      for(std::size_t j = 0; j < i && !ridges[i].is_shadow; ++j)
        if(!ridges[j].is_shadow && cross_each_other(ridges[i], ridges[j]))
          return true;
    return false;
  }

  bool cross_each_other(const Ridge& r, const Ridge& s) const
  {
    if(r.nodes[0] == s.nodes[0] || r.nodes[0] == s.nodes[1] || r.nodes[1] == s.nodes[0] || r.nodes[1] == s.nodes[1])
      return false;
    const Plane_point &a = nodes[r.nodes[0]], &b = nodes[r.nodes[1]], &c = nodes[s.nodes[0]], &d = nodes[s.nodes[1]];
    return cross(a, b, c) * cross(a, b, d) < 0. && cross(c, d, a) * cross(c, d, b) < 0.;
  }

  Index add_node(const Plane_point& p)
  {
    nodes.push_back(p);
    return static_cast<Index>(nodes.size() - 1);
  }

  void add_ridge(const Front& f, Index node) { ridges.push_back({{f.node, node}, {f.before, f.after}, f.is_shadow}); }

  void connect(const Front& a, const Front& b)
  {
    ridges.push_back({{a.node, b.node}, {a.before, a.after}, a.is_shadow && b.is_shadow});
  }

  std::array<Plane_point, 3> corners_;
  const std::vector<Entry>* entries_ = nullptr;
  double tolerance_ = 0.;
  std::function<bool(const Image&, const Image&, const Plane_point&)> are_one_path_;
  std::vector<Front> fronts_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_FACE_RIDGES_H
