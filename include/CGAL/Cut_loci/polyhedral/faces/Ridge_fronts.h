// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGE_FRONTS_H
#define CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGE_FRONTS_H

#include <CGAL/Cut_loci/polyhedral/faces/Image_bisector.h>
#include <CGAL/Cut_loci/polyhedral/labels/face_plane.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * holds the ends of the pieces that are drawn in a face, in a ring as they are around what is left of the face.
 */
class Ridge_fronts
{
protected:
  static constexpr double least_angle = 1e-7; // below, directions are taken for the same

  struct Front
  {
    Index node; // where it is now
    Image before, after;
    bool is_ray, is_shadow;
    bool goes_up;         // whether the distance grows on its way
    double level;         // the distance at the node
    Index previous, next; // its neighbors
    bool is_alive;
    double strength = 0.;
  };

  /// of a front with the next one
  struct Meeting
  {
    double key; // those of the least come first
    Index first, second;
    Plane_point point;
    bool is_end; // the two are one piece

    bool operator<(const Meeting& other) const { return key > other.key; }
  };

  // -- in the plane -----------------------------------------------------------------------------------------------------

  static bool is_on_one_line(const Plane_point& p, const Image& a, const Image& b)
  {
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    const double cross = ax * by - ay * bx, dot = ax * bx + ay * by;
    return dot >= 0. && std::fabs(cross) <= least_angle * dot;
  }

  /// the boundary of a shadow leads away from the image of what casts it
  static Plane_point light(const Front& f)
  {
    const Image& image = f.before.sigma < f.after.sigma ? f.before : f.after;
    return {image.x, image.y};
  }

  /// the vertex that casts the shadow, as an origin
  static Index bend(const Front& f) { return f.before.sigma < f.after.sigma ? f.after.origin : f.before.origin; }

  /// whether two fronts are both sides of one shadow
  static bool are_of_one_shadow(const Front& first, const Front& second)
  {
    return first.is_ray && second.is_ray && bend(first) == bend(second);
  }

  /// what grows along the bisector of the two images, in the direction of the front: the way from the line through
  /// these, positive behind it, times their distance
  static double advance(const Front& f, const Plane_point& p)
  {
    return (p.x - f.before.x) * (p.y - f.after.y) - (p.y - f.before.y) * (p.x - f.after.x);
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
    double least = 0.5 * distance(p, q);
    for(std::size_t k = 0; k < n; ++k)
    {
      const double away = distance(points[k], m);
      if(away < least)
      {
        least = away;
        best = points[k];
      }
    }
    return best;
  }

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

  /// Where one path goes on from a vertex at which the other one bends, the boundary of the shadow is straight, and a
  /// shadow up to its end: other pieces meet it there at a point that is known up to the square root of rounding only.
  static bool is_shadow_between(const Front& a, const Front& b)
  {
    return a.before.origin != a.after.origin ? a.is_shadow || b.is_shadow : a.is_shadow && b.is_shadow;
  }

  // -- the ring ---------------------------------------------------------------------------------------------------------

  /*
   * Where a shadow is narrower than the accuracy of the windows it has no window, and its boundaries have only one end:
   * where nothing meets any more, neighboring ones that lead back to the label from which they come are left away, as they
   * may be between two others that meet. Returns whether there were any.
   */
  bool leave_shadows_away()
  {
    std::vector<Index> kept; // of the ring, in order
    Index run = 0;           // where the shadows begin that are the last of them
    bool is_found = false;
    Index i = first_after_cut_locus();
    for(Index k = size_; k > 0; --k, i = fronts_[i].next)
    {
      kept.push_back(i);
      if(!fronts_[i].is_shadow)
        run = static_cast<Index>(kept.size());
      Index begin = static_cast<Index>(kept.size());
      while(begin > run && !is_same_image(fronts_[kept[begin - 1]].before, fronts_[i].after))
        --begin;
      if(begin == run)
        continue;
      is_found = true;
      for(; kept.size() >= begin; kept.pop_back())
        fronts_[kept.back()].is_alive = false;
    }
    if(!is_found)
      return false;
    size_ = static_cast<Index>(kept.size());
    first_ = kept.empty() ? 0 : kept[0];
    for(Index k = 0; k < size_; ++k)
    {
      fronts_[kept[k]].next = kept[k + 1 < size_ ? k + 1 : 0];
      fronts_[kept[k + 1 < size_ ? k + 1 : 0]].previous = kept[k];
    }
    return true;
  }

  /// one of the ring, behind one that is on the cut locus if there is any
  Index first_after_cut_locus() const
  {
    Index i = first_;
    for(Index k = 0; k < size_ && fronts_[i].is_shadow; ++k)
      i = fronts_[i].next;
    return fronts_[i].next;
  }

  /// The boundary of a shadow that is narrower than the accuracy of the windows may have only one end.
  bool has_cut_locus_left() const
  {
    Index i = first_;
    for(Index k = 0; k < size_; ++k, i = fronts_[i].next)
      if(!fronts_[i].is_shadow)
        return true;
    return false;
  }

  std::vector<Front> fronts_;  // those that are alive are linked to a ring
  Index first_ = 0, size_ = 0; // one of the ring, and the number of them
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_FACES_RIDGE_FRONTS_H
