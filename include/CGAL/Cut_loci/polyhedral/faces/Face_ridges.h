// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_RIDGES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_RIDGES_H

#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/faces/Ridge_fronts.h>
#include <CGAL/Cut_loci/polyhedral/faces/Segment_crossings.h>
#include <CGAL/Cut_loci/polyhedral/faces/draw_by_labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * draws the cut locus in a face, given where it meets the boundary of the face.
 *
 * The cells of different labels all touch the boundary, since the shortest paths to their points come from there. So
 * the pieces between them form trees, whose leaves are points of the boundary: pieces start at all of these and, two
 * neighbors at a time, meet in a node and go on as one, until all have met.
 *
 * Where the distance has no saddle in the face, it grows along a piece from one end to the other, and two of the three
 * pieces at a node come from below. Then neighbors meet in the order of the distance, as wavefronts do, and no other
 * cell has to be looked at. Else the next to meet are those whose node no other path reaches earlier.
 */
class Face_ridges : private Ridge_fronts
{
public:
  using Change = Face_change;
  using Ridge = Face_ridge;

  /// is a part of an edge of the face through which the straight paths from an image enter the face.
  struct Entry
  {
    Image image;
    Plane_point from, to; // counterclockwise
  };

  /// the nodes: first one for each change, then those inside
  std::vector<Plane_point> nodes;
  std::vector<Ridge> ridges;
  /// whether labels did not fit each other, so that the drawing is good to the size of the face only
  bool is_doubtful = false;

  /// @param tolerance up to which paths of different lengths are taken for equally long
  /// @param entries returns all of them; only called where they are needed
  /// @param are_one_path whether the paths from two images to a point of the face, on one line there or not, are the same
  template <typename Entries, typename Are_one_path>
  void draw(const std::array<Plane_point, 3>& corners, const std::vector<Change>& changes, double tolerance,
            const Entries& entries, const Are_one_path& are_one_path)
  {
    corners_ = corners;
    tolerance_ = tolerance;
    is_doubtful = false;
    entries_ = nullptr;
    start(changes);
    if(size_ <= 2 || !has_saddle())
    {
      if(join_all(are_one_path))
        return;
      start(changes);
    }
    entries_ = &entries();
    if(join_all(are_one_path))
      return;
    start(changes);
    is_doubtful = true;
    draw_by_labels(changes, nodes, ridges);
  }

  /// of a point, by all ways into the face; where the drawing is doubtful, the images beside the point do not tell it
  double distance_in_doubt(const Plane_point& p) const
  {
    double result = infinity;
    for(const Entry& e : *entries_)
      if(sees(e, p))
        result = (std::min)(result, e.image.distance(p));
    return result;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  /// whether `p` is in the cone of an entry, up to rounding: what is beside it by a little is longer by the square of that
  static bool sees(const Entry& e, const Plane_point& p)
  {
    const Plane_point image = e.image.place();
    const double rounding = 1e-9 * (squared_distance(e.from, e.to) + squared_distance(image, p));
    return cross(image, e.from, p) <= rounding && cross(image, e.to, p) >= -rounding;
  }

  /// by how much a straight path from an image to `p` is longer than the shortest one; infinite if there is none
  double excess(const Plane_point& p, const Image& a, const Image& b, const Image& c) const
  {
    double least = infinity;
    const double distance = b.distance(p), least_needed = distance - tolerance_;
    bool sees_a = false, sees_b = false, sees_c = false;
    for(const Entry& e : *entries_)
      if(sees(e, p))
      {
        least = (std::min)(least, e.image.distance(p));
        if(least < least_needed)
          return infinity;
        sees_a = sees_a || is_same_path(e.image, a, p);
        sees_b = sees_b || is_same_path(e.image, b, p);
        sees_c = sees_c || is_same_path(e.image, c, p);
      }
    return sees_a && sees_b && sees_c ? (std::max)(distance - least, 0.) : infinity;
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

  /// Adds the meeting of two neighbors, if they meet. Where paths bend at a vertex to which several lead, those that pass it
  /// on its two sides may have the same image, and the shadow between them no width: then the cut locus goes on along it.
  template <typename Are_one_path>
  void find_meeting(Index i, Index j, const Are_one_path& are_one_path)
  {
    const Front &first = fronts_[i], &second = fronts_[j];
    const Plane_point &p = nodes[first.node], &q = nodes[second.node];
    const bool have_same_image = is_same_image(first.before, second.after);
    Meeting meeting{infinity, i, j, q,
                    have_same_image && are_in_line(first, second) && are_one_path(first.before, second.after, q, true)};
    std::array<Plane_point, 2> points;
    std::size_t n = 0;
    if(meeting.is_end && entries_ == nullptr)
    {
      if(is_ahead(first, q) && (first.goes_up != second.goes_up || squared_distance(p, q) <= tolerance_ * tolerance_))
        meeting.key = (std::max)(first.level, second.level);
    }
    else if(meeting.is_end)
    {
      points[0] = between(p, q, first);
      n = is_ahead(first, q);
    }
    else if(have_same_image)
    {
      points[0] = q;
      n = squared_distance(p, q) <= tolerance_ * tolerance_;
    }
    else if((entries_ == nullptr && !may_meet(first, second)) || are_of_one_shadow(first, second))
      return;
    else if(!first.is_ray && !second.is_ray)
      n = equidistant_points(first.before, first.after, second.after, points);
    else if(first.is_ray && second.is_ray)
      n = intersection(p, light(first), q, light(second), points);
    else if(first.is_ray)
      n = equidistant_points(p, light(first), second.before, second.after, points);
    else
      n = equidistant_points(q, light(second), first.before, first.after, points);
    for(std::size_t k = 0; k < n; ++k)
    {
      if(!clamp(points[k]) || !are_alike(first, second, points[k]))
        continue;
      stay_at_node(first, second, points[k]);
      stay_at_node(second, first, points[k]);
      if(is_ahead(first, points[k]) && is_ahead(second, points[k]))
      {
        const double key =
          entries_ == nullptr ? level_of_meeting(first, second, points[k]) : way_to_meeting(first, second, points[k]);
        if(key < meeting.key)
        {
          meeting.key = key;
          meeting.point = points[k];
        }
      }
    }
    if(meeting.key == infinity)
      return;
    meetings_.push_back(meeting);
    std::push_heap(meetings_.begin(), meetings_.end());
  }

  /// whether two fronts between the same images are on one line if one of them is a ray, up to the accuracy of windows: where
  /// a surface is symmetric, families of paths that other ones part may have the same image, and leave the source in the same
  /// directions
  bool are_in_line(const Front& first, const Front& second) const
  {
    if(!first.is_ray && !second.is_ray)
      return true;
    const Plane_point l = light(first), &p = nodes[first.node], &q = nodes[second.node];
    return std::fabs(cross(l, p, q)) <= tolerance_ * (std::max)(distance(l, p), distance(l, q));
  }

  /// whether a point that has been moved into the face still has the same distance from the images of two fronts: of the
  /// points that have it, the one outside may be near
  bool are_alike(const Front& first, const Front& second, const Plane_point& p) const
  {
    const double d = first.after.distance(p);
    return std::fabs(first.before.distance(p) - d) <= tolerance_ &&
           std::fabs(second.after.distance(p) - d) <= tolerance_;
  }

  /// Where several pieces meet nearly in a point, a front may have been put beyond a ray, by as little as the paths on both
  /// sides of the ray are taken for equally long: then it meets the ray where it is.
  void stay_at_node(const Front& ray, const Front& front, Plane_point& x) const
  {
    const Plane_point& node = nodes[front.node];
    if(ray.is_ray && !is_ahead(front, x) &&
       std::fabs(ray.before.distance(node) - ray.after.distance(node)) <= tolerance_)
      x = node;
  }

  /// Without a saddle, one that goes down meets others only where these end it, except where rounding puts the meeting
  /// to its begin.
  bool may_meet(const Front& first, const Front& second) const
  {
    return (first.goes_up && second.goes_up) ||
           squared_distance(nodes[first.node], nodes[second.node]) <= tolerance_ * tolerance_;
  }

  /// the distance at a node that is ahead of both fronts
  double level_of_meeting(const Front& first, const Front& second, const Plane_point& x) const
  {
    const double level = first.after.distance(x);
    return level >= (std::max)(first.level, second.level) - tolerance_ ? level : infinity;
  }

  /// of several nodes that no path reaches earlier, the nearest is the next
  double way_to_meeting(const Front& first, const Front& second, const Plane_point& x) const
  {
    if(!(excess(x, first.before, first.after, second.after) <= tolerance_))
      return infinity;
    return distance(x, nodes[first.node]) + distance(x, nodes[second.node]);
  }

  /// lets neighbors meet until there are none; returns whether that was possible without pieces that cross each other
  template <typename Are_one_path>
  bool join_all(const Are_one_path& are_one_path)
  {
    meetings_.clear();
    find_all_meetings(are_one_path);
    while(size_ > 2)
    {
      if(meetings_.empty() && leave_shadows_away())
        find_all_meetings(are_one_path);
      if(meetings_.empty())
        break;
      std::pop_heap(meetings_.begin(), meetings_.end());
      const Meeting m = meetings_.back();
      meetings_.pop_back();
      if(!fronts_[m.first].is_alive || !fronts_[m.second].is_alive)
        continue;
      const Index previous = fronts_[m.first].previous, next = fronts_[m.second].next;
      if(m.is_end)
      {
        connect(m.first, m.second);
        if(size_ > 2)
          find_meeting(previous, next, are_one_path);
        continue;
      }
      const Index joined = join(m, are_one_path);
      if(size_ > 2)
      {
        find_meeting(previous, joined, are_one_path);
        find_meeting(joined, next, are_one_path);
      }
    }
    if(size_ == 2)
      connect(first_, fronts_[first_].next);
    return !has_cut_locus_left() && !do_ridges_cross();
  }

  /// those on the cut locus: where four meet, there are two nodes in one point, and rounding alone puts one of them across
  bool do_ridges_cross()
  {
    double longest = 0.;
    for(std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(longest, distance(corners_[i], corners_[(i + 1) % 3]));
    crossings_.clear();
    for(const Ridge& r : ridges)
      if(!r.is_shadow)
        crossings_.add(nodes[r.nodes[0]], nodes[r.nodes[1]]);
    return crossings_.has_any(1e-8 * longest);
  }

  template <typename Are_one_path>
  void find_all_meetings(const Are_one_path& are_one_path)
  {
    Index i = first_;
    for(Index k = 0; k < size_ && size_ > 2; ++k, i = fronts_[i].next)
      find_meeting(i, fronts_[i].next, are_one_path);
  }

  template <typename Are_one_path>
  Index join(const Meeting& m, const Are_one_path& are_one_path)
  {
    const Index node = add_node(m.point);
    add_ridge(fronts_[m.first], node);
    add_ridge(fronts_[m.second], node);
    Front front{node, fronts_[m.first].before, fronts_[m.second].after, false, false, true, 0., null_index, null_index,
                true};
    front.is_ray = is_on_one_line(m.point, front.before, front.after);
    front.is_shadow = are_one_path(front.before, front.after, m.point, front.is_ray);
    front.goes_up = front.is_ray || converge(front);
    front.level = front.after.distance(m.point);
    front.previous = fronts_[m.first].previous;
    front.next = fronts_[m.second].next;
    const Index i = static_cast<Index>(fronts_.size());
    fronts_[front.previous].next = fronts_[front.next].previous = i;
    fronts_[m.first].is_alive = fronts_[m.second].is_alive = false;
    fronts_.push_back(front);
    first_ = i;
    --size_;
    return i;
  }

  /// whether the paths of a front come closer as it goes on, so that it gets farther from both images
  bool converge(const Front& f) const { return advance(f, nodes[f.node]) > 0.; }

  /// whether a front may get to a point of its bisector, which it may have passed before it came into the face
  bool is_ahead(const Front& f, const Plane_point& x) const
  {
    if(f.is_ray)
      return true;
    const Plane_point before = f.before.place(), after = f.after.place();
    const double rounding =
      least_angle * distance(x, before) * distance(x, after) + tolerance_ * distance(before, after);
    return advance(f, x) >= advance(f, nodes[f.node]) - rounding;
  }

  /// the boundary of a shadow gets away from the light
  bool leaves_light(const Front& f, Index edge) const
  {
    if(edge == null_index)
      return true;
    const Plane_point &a = corners_[edge], &b = corners_[edge == 2 ? 0 : edge + 1], l = light(f), &p = nodes[f.node];
    return (b.x - a.x) * (p.y - l.y) - (b.y - a.y) * (p.x - l.x) > 0.;
  }

  void start(const std::vector<Change>& changes)
  {
    nodes.clear();
    ridges.clear();
    fronts_.clear();
    first_ = 0;
    size_ = static_cast<Index>(changes.size());
    for(Index i = 0; i < size_; ++i)
    {
      const Change& c = changes[i];
      nodes.push_back(c.point);
      Front front{i, c.before, c.after, c.is_ray, c.is_shadow, true, 0., null_index, null_index, true, c.strength};
      front.goes_up = c.is_ray ? leaves_light(front, c.edge) : converge(front);
      front.level = c.after.distance(c.point);
      front.previous = i > 0 ? i - 1 : size_ - 1;
      front.next = i + 1 < size_ ? i + 1 : 0;
      fronts_.push_back(front);
    }
  }

  /// whether paths from opposite sides may meet in the face, on a piece that starts on the boundary
  bool has_saddle() const
  {
    for(const Front& f : fronts_)
    {
      if(f.goes_up || f.is_ray)
        continue;
      const double dx = f.after.x - f.before.x, dy = f.after.y - f.before.y, l = std::sqrt(dx * dx + dy * dy);
      const double s = 0.5 * (l + f.after.sigma - f.before.sigma) / l;
      Plane_point p{f.before.x + s * dx, f.before.y + s * dy};
      if(s >= 0. && s <= 1. && clamp(p))
        return true;
    }
    return false;
  }

  Index add_node(const Plane_point& p)
  {
    nodes.push_back(p);
    return static_cast<Index>(nodes.size() - 1);
  }

  void add_ridge(const Front& f, Index node) { ridges.push_back({{f.node, node}, {f.before, f.after}, f.is_shadow}); }

  /// by a piece, and removes both
  void connect(Index i, Index j)
  {
    Front &a = fronts_[i], &b = fronts_[j];
    ridges.push_back({{a.node, b.node}, {a.before, a.after}, is_shadow_between(a, b)});
    fronts_[a.previous].next = b.next;
    fronts_[b.next].previous = a.previous;
    a.is_alive = b.is_alive = false;
    first_ = b.next;
    size_ -= 2;
  }

  std::array<Plane_point, 3> corners_;
  const std::vector<Entry>* entries_ = nullptr; // null as long as no meeting has to be compared with all paths
  double tolerance_ = 0.;
  std::vector<Meeting> meetings_; // a heap
  Segment_crossings crossings_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_FACE_RIDGES_H
