// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_MERGING_H
#define CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_MERGING_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

/*!
 * replaces runs of neighboring windows by one window each, whose distances are a little shorter.
 *
 * The new window has the distances of the old ones at the two ends of the run and never longer ones in between. How
 * much shorter its paths may be than true ones is its error. It is kept with the window, in `Geodesic_window::turn`
 * if there are no directions, and is at most `tolerance` times the least distance of the window.
 *
 * Proof that this bounds the error of all distances, but for rounding. Let d(p) be the true distance of a point p,
 * w(p) the distance of p from the image of a window w, and e(w) the error of w.
 *
 * 1. w(p) >= d(p) - e(w). A window that comes from another one, v, across a face has the same image and error. The
 *    segment from the image to p crosses the interval of v in a point q. So w(p) = v(q) + |qp| >= d(q) - e(v) + |qp|
 *    >= d(p) - e(v). Merging adds to the largest error of the run by how much its distances get shorter at most,
 *    which is what `check()` finds.
 * 2. The least w(p) of all windows is at most d(p). Let u(p) be the least distance that is found for a point p of an
 *    edge, from either side and by way of its ends. For a point q behind the edge the windows give u(p) + |pq|, for
 *    those p from which a window goes straight on to q. That the least of these is the least of all p, is what has to
 *    be shown: then u(q) <= u(p) + |pq|, and from edge to edge along a shortest path u is at most d. Where u is
 *    smooth, u(p) + |pq| is least only if the path goes straight on. Where one window ends and the next one begins, u
 *    is the lesser of two smooth functions. Such a kink is no minimum. Where a window ends at the ray through a
 *    vertex, the paths by way of the vertex have the same slope there, so that it is no minimum either, unless the
 *    path goes straight on. At a vertex a shortest path may bend if both of its sides have an angle of pi or more;
 *    such vertices have windows of their own. Trimming and filters leave out what has a path that is not longer
 *    beside it. They compare segments from images in the plane of the faces, which needs nothing of the images. And
 *    merging keeps all this: u gets smaller inside of the run and stays at its ends. So its slope into the run there
 *    does not grow, and a kink at the end is as sharp as before, or sharper.
 *
 * Hence d(p) - e(w) <= w(p) <= d(p) for the window w that is nearest to p. With e(w) <= tolerance * w(p), the sum
 * w(p) + e(w), which is returned, is at least d(p) and at most (1 + tolerance) * d(p).
 *
 * With directions, those at the ends of the run are kept too, and in between they grow linearly with the angle at the
 * image. As the true ones are monotone along the run, how wrong they are shows at the old ends of windows.
 */
template <int columns>
class Geodesic_merging
{
public:
  Geodesic_merging(Geodesic_window_list& list, double length, double tolerance, double angle)
    : list_(list), narrow_(geodesic_narrow * length), tolerance_(tolerance), angle_(angle)
  {
  }

  void operator()()
  {
    const double *a = list_.column(0), *b = list_.column(1), *origin = list_.column(columns > 6 ? 6 : 0);
    const auto is_run = [&](std::size_t i) {
      return a[i] - b[i - 1] <= narrow_ && (columns < 7 || origin[i] == origin[i - 1]) && has_room(i - 1) &&
             has_room(i);
    };
    const std::size_t end = list_.end;
    top_ = list_.begin;
    for(std::size_t first = list_.begin, last; first < end; first = last)
    {
      for(last = first + 1; last < end && is_run(last); ++last)
      {
      }
      merge(first, last);
    }
    list_.end = static_cast<std::uint32_t>(top_);
  }

private:
  /// Most windows have used up the error that is allowed, and can be part of no run until their paths are longer.
  bool has_room(std::size_t i) const
  {
    const double error = list_.column(columns < 9 ? 5 : 8)[i];
    return error < tolerance_ * (list_.column(4)[i] - list_.column(3)[i]);
  }

  /// replaces the windows of `[first, last)`, a run without gaps, by one or, in halves, by a few
  void merge(std::size_t first, std::size_t last)
  {
    Geodesic_window w;
    if(last - first == 1)
      list_.template set<columns>(top_++, list_.template get<columns>(first));
    else if(find(first, last, w))
      list_.template set<columns>(top_++, w);
    else
    {
      const std::size_t middle = first + (last - first) / 2;
      merge(first, middle);
      merge(middle, last);
    }
  }

  /// one window for all of `[first, last)`
  bool find(std::size_t first, std::size_t last, Geodesic_window& w) const
  {
    const Geodesic_window left = list_.template get<columns>(first), right = list_.template get<columns>(last - 1);
    const double at_left = left.distance(left.a), at_right = right.distance(right.b);
    const double width = right.b - left.a, rise = at_left - at_right;
    const double free = width * width - rise * rise;
    if(!(free > 0.))
      return false;
    // The distances at the ends put the image on a hyperbola. It may be no further away than where its rays through the
    // ends are the old ones, or some of its distances would be longer; and sigma is not negative.
    const double reach_left = at_left - left.sigma, reach_right = at_right - right.sigma;
    const double bend_left = width * (left.x - left.a) / reach_left - rise;
    const double bend_right = width * (right.b - right.x) / reach_right + rise;
    double reach = at_left; // from the image to the left end
    if(bend_left > 0.)
      reach = (std::min)(reach, 0.5 * free / bend_left);
    if(bend_right > 0.)
      reach = (std::min)(reach, 0.5 * free / bend_right + rise);
    const double least = 0.5 * (width + rise); // the image is on the halfedge
    // nearer images have shorter distances between the ends; a few steps are tried, of which the first one mostly does
    for(int i = 0; i < 4; ++i, reach = 0.5 * (reach + least))
    {
      w = left;
      w.b = right.b;
      w.sigma = at_left - reach;
      const double other = reach - rise;
      const double foot = (reach * reach - other * other + width * width) / (2. * width);
      const double square = reach * reach - foot * foot;
      if(!(square > 0.) || !(w.sigma >= 0.))
        return false;
      w.x = left.a + foot;
      w.y = -std::sqrt(square);
      const Fit fit = check(first, last, w);
      if(fit != too_long)
        return fit == good && (columns < 9 || fit_directions(first, last, w));
    }
    return false;
  }

  enum Fit { good, too_long, too_short };

  /// compares the distances of `w` with those of `[first, last)`, and finds its error
  Fit check(std::size_t first, std::size_t last, Geodesic_window& w) const
  {
    double error = 0., old_error = 0.;
    const double nearest = w.sigma - w.y; // no distance is shorter
    for(std::size_t i = first; i < last; ++i)
    {
      const Geodesic_window old = list_.template get<columns>(i);
      old_error = (std::max)(old_error, columns < 9 ? old.turn : old.error);
      const double slack = 1e-15 * (nearest + w.b); // for rounding
      // the difference has its extrema at the ends and where both paths are parallel
      const double extremum = (w.x * old.y - old.x * w.y) / (old.y - w.y);
      const double places[3] = {old.a, old.b, extremum};
      // nothing changes at the ends of the run
      const bool counts[3] = {i > first, i + 1 < last, extremum > old.a && extremum < old.b};
      for(int k = 0; k < 3; ++k)
        if(counts[k])
        {
          const double gain = old.distance(places[k]) - w.distance(places[k]);
          if(gain < -slack)
            return too_long;
          error = (std::max)(error, gain);
        }
    }
    (columns < 9 ? w.turn : w.error) = old_error + error;
    return old_error + error <= tolerance_ * nearest ? good : too_short;
  }

  static double angle_to(const Geodesic_window& w, double t) { return std::atan2(-w.y, t - w.x); }
  static double direction(const Geodesic_window& w, double t) { return w.turn + w.rate * angle_to(w, t); }

  /// gives `w` the directions of `[first, last)` at the ends; returns whether they are accurate enough in between
  bool fit_directions(std::size_t first, std::size_t last, Geodesic_window& w) const
  {
    const Geodesic_window left = list_.template get<columns>(first), right = list_.template get<columns>(last - 1);
    const double from = direction(left, left.a), to = direction(right, right.b);
    const double at_left = angle_to(w, w.a), spread = at_left - angle_to(w, w.b);
    w.rate = spread > 0. ? (from - to) / spread : 0.;
    w.turn = from - w.rate * at_left;
    for(std::size_t i = first; i < last; ++i)
    {
      const Geodesic_window old = list_.template get<columns>(i);
      const auto is_accurate = [&](double t) { return std::fabs(direction(w, t) - direction(old, t)) <= angle_; };
      if((i > first && !is_accurate(old.a)) || (i + 1 < last && !is_accurate(old.b)))
        return false;
    }
    return true;
  }

  Geodesic_window_list& list_;
  double narrow_, tolerance_, angle_;
  std::size_t top_ = 0;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_WINDOWS_GEODESIC_MERGING_H
