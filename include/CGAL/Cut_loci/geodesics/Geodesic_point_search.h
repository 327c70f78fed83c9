// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_POINT_SEARCH_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_POINT_SEARCH_H

#include <CGAL/Cut_loci/geodesics/Geodesic_queries.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * finds the shortest path to any point after a run, which has kept no windows.
 *
 * It looks back from the point, straight through the faces: what is seen through a halfedge is a sector, which parts at
 * the vertices. The last straight piece of the path comes from a vertex at which it bends, whose distance is known, or from a
 * source. No path through a sector is shorter than the distances of the vertices beside it allow, as distances change by no
 * more than the way; sectors are taken in the order of that bound, until it is above the shortest path that is known. So few
 * sectors are looked at but those along the path.
 */
class Geodesic_point_search
{
public:
  explicit Geodesic_point_search(const Geodesic_results& geodesics,
                                 double maximum_distance = (std::numeric_limits<double>::infinity)())
    : geodesics_(geodesics), faces_(geodesics.faces()), maximum_distance_(maximum_distance)
  {
    for(std::size_t i = 0; i < geodesics_.number_of_sources(); ++i)
      if(geodesics_.source_vertex(i) == null_index && !geodesics_.is_line(static_cast<Index>(i)))
        sources_in_faces_.push_back(i);
  }

  /// the point with its distance and the last piece of its path; infinite if it is not reached
  Geodesic_query operator()(const Indexed_location& location)
  {
    sectors_.clear();
    best_ = Start();
    shortest_ = maximum_distance_;
    const Geodesic_results::Source at = geodesics_.classify(location);
    if(at.vertex != null_index)
      return geodesics_.at_vertex(at.vertex);
    look_around(at.location, at.halfedge);
    const Index o = at.halfedge == null_index ? null_index : faces_.opposite(at.halfedge);
    const Indexed_location behind = o == null_index ? at.location : across(at.halfedge, o, at.location);
    if(o != null_index)
      look_around(behind, o);
    while(!sectors_.empty() && sectors_.front().bound <= limit())
    {
      std::pop_heap(sectors_.begin(), sectors_.end(), is_later);
      const Sector sector = sectors_.back();
      sectors_.pop_back();
      look_through(sector);
    }
    if(best_.distance > maximum_distance_ || best_.first == null_index)
      return {at.location, infinity, Geodesic_arrival()};
    const Indexed_location& end = best_.first / 3 == at.location.face ? at.location : behind;
    return {end, shortest_, last_piece(faces_.in_frame(best_.first, end.coordinates))};
  }

private:
  using Mesh = Indexed_triangle_mesh;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  // of lengths: a path beside a vertex is not taken for one through it
  static constexpr double rounding = 1e-12;

  /// what the point sees through a part of a halfedge, in whose frame it is given
  struct Sector
  {
    Index halfedge, first; // the one through which the face of the point is left
    double a, b;
    Plane_point eye;
    double turn; // of the frame, from that of `first`
    double bound;
  };

  /// where a piece of a path may begin
  struct Start
  {
    double rank = infinity, distance = infinity;    // by which it is chosen, and of the point
    Index vertex = null_index, source = null_index; // either of them
    Plane_point way{0.,
                    0.}; // to it from the point, in the frame of `halfedge`, but turned by `turn` from that of `first`
    Index halfedge = null_index, first = null_index;
    double turn = 0.;
    bool is_in_same_face = false;
  };

  static bool is_later(const Sector& s, const Sector& t) { return s.bound > t.bound; }

  double limit() const { return (1. + rounding) * shortest_; }

  /// from a point in a face, or on an edge of it: that edge is not looked through
  void look_around(const Indexed_location& location, Index edge)
  {
    const Index h = 3 * location.face;
    const Plane_point eye = faces_.in_frame(h, location.coordinates);
    for(Index v : faces_.face(location.face).vertex)
      see_vertex(v, geodesics_.vertex_in_frame(h, v), {h, h, 0., 0., eye, 0., 0.}, true);
    for(std::size_t i : sources_in_faces_)
      if(Plane_point p; geodesics_.source_in_frame(i, h, p))
        see_source(static_cast<Index>(i), p, {h, h, 0., 0., eye, 0., 0.}, true);
    for(Index g = h; g < h + 3; ++g)
      if(const Plane_point p = faces_.in_frame(g, location.coordinates); g != edge || faces_.opposite(g) == null_index)
        go_on(g, {g, g, 0., faces_.length(g), {faces_.length(g) - p.x, -p.y}, geodesic_pi, 0.});
  }

  void look_through(const Sector& s)
  {
    const Index h = s.halfedge, left = Mesh::previous(h), right = Mesh::next(h);
    const Geodesic_face& face = faces_.face_of(h);
    const Geodesic_face::Corner &at_source = face.corner[h % 3], &at_target = face.corner[right % 3];
    const Plane_point apex = faces_.apex(h), &eye = s.eye;
    const double cover = geodesic_cover * faces_.length(h);
    for(std::size_t i : sources_in_faces_)
      if(Plane_point p; geodesics_.source_in_frame(i, h, p) && side_of_rays(s.a, s.b, eye.x, eye.y, p, cover) == covers)
        see_source(static_cast<Index>(i), p, s, false);
    const Geodesic_side side = side_of_rays(s.a, s.b, eye.x, eye.y, apex, cover);
    if(side == covers)
      see_vertex(face.vertex[left % 3], apex, s, false);
    if(side != passes_right)
    {
      const double length = faces_.length(left), c = at_source.cosine, sine = at_source.sine;
      const auto reach = [&](double t) { return reach_on(t * eye.y, (t - eye.x) * sine + eye.y * c, length); };
      go_on(left, {h,
                   s.first,
                   reach(s.a),
                   reach(s.b),
                   {eye.x * c + eye.y * sine, eye.y * c - eye.x * sine},
                   s.turn + at_source.angle,
                   0.});
    }
    if(side != passes_left)
    {
      const double base = faces_.length(h), length = faces_.length(right), c = at_target.cosine, sine = at_target.sine,
                   x = base - eye.x;
      const auto reach = [&](double t)
      { return length - reach_on((base - t) * eye.y, (eye.x - t) * sine + eye.y * c, length); };
      go_on(right, {h,
                    s.first,
                    reach(s.a),
                    reach(s.b),
                    {length - (x * c + eye.y * sine), eye.y * c - x * sine},
                    s.turn - at_target.angle,
                    0.});
    }
  }

  /// where a ray meets an edge, from its end on the halfedge: at most at its other end
  static double reach_on(double numerator, double denominator, double length)
  {
    return denominator < 0. ? (std::min)(numerator / denominator, length) : length;
  }

  /// leaves the face of `g` through a part of it, which is given in the frame of its opposite
  void go_on(Index g, Sector s)
  {
    const double length = faces_.length(g), cover = geodesic_cover * length;
    const Index o = faces_.opposite(g);
    if(o == null_index)
    {
      const Index line = geodesics_.line_at(g);
      if(line != null_index && s.a - cover <= s.eye.x && s.eye.x <= s.b + cover)
        see_line(line, s);
      return;
    }
    if(!(s.b - s.a > geodesic_narrow * length) || !(s.eye.y < 0.))
      return;
    s.halfedge = o;
    s.bound = bound(s, g, length);
    if(!(s.bound <= limit()) || s.bound == infinity)
      return;
    sectors_.push_back(s);
    std::push_heap(sectors_.begin(), sectors_.end(), is_later);
  }

  /// no distance of `v` is less
  double least_distance(Index v) const
  {
    return geodesics_.is_reached(v) ? geodesics_.distance(v) - geodesics_.distance_error(v) : maximum_distance_;
  }

  /// the least of a way to a point of the sector and of what its ends and the vertex behind it tell of its distance
  double bound(const Sector& s, Index g, double length) const
  {
    const double at_source = least_distance(faces_.source(s.halfedge)),
                 at_target = least_distance(faces_.target(s.halfedge));
    // up to where both ends tell the same, the way by the nearer one falls, and then grows
    const double equal = 0.5 * (at_source - at_target + length), t = (std::min)((std::max)(equal, s.a), s.b);
    const double by_ends = distance_on_axis(s.eye, t) + (std::max)(at_source - t, at_target - (length - t));
    if(g == s.first)
      return by_ends;
    // how much further the point is than the vertex is largest where it is behind that, and so least at the ends
    const Plane_point apex = faces_.apex(g), behind{length - apex.x, -apex.y};
    const auto further = [&](double u) { return distance_on_axis(s.eye, u) - distance_on_axis(behind, u); };
    return (std::max)(by_ends,
                      least_distance(faces_.source(Mesh::previous(g))) + (std::min)(further(s.a), further(s.b)));
  }

  void see_vertex(Index v, const Plane_point& p, const Sector& s, bool is_in_same_face)
  {
    const bool is_end = faces_.is_pseudo_source(v) || geodesics_.distance(v) == 0.;
    see(geodesics_.distance(v), is_end, v, null_index, {p.x - s.eye.x, p.y - s.eye.y}, s, is_in_same_face);
  }

  void see_source(Index i, const Plane_point& p, const Sector& s, bool is_in_same_face)
  {
    see(0., true, null_index, i, {p.x - s.eye.x, p.y - s.eye.y}, s, is_in_same_face);
  }

  void see_line(Index i, const Sector& s) { see(0., true, null_index, i, {0., -s.eye.y}, s, s.halfedge == s.first); }

  void see(double distance, bool is_end, Index v, Index source, const Plane_point& way, const Sector& s,
           bool is_in_same_face)
  {
    distance += std::hypot(way.x, way.y);
    const double rank = is_end ? distance : (1. + rounding) * distance;
    shortest_ = (std::min)(shortest_, distance);
    if(rank < best_.rank)
      best_ = {rank, distance, v, source, way, s.halfedge, s.first, s.turn, is_in_same_face};
  }

  /// of the best path, whose end is given in the frame of the halfedge through which it leaves the face
  Geodesic_arrival last_piece(const Plane_point& end) const
  {
    Geodesic_arrival result;
    const bool is_line = best_.vertex == null_index && geodesics_.is_line(best_.source);
    if(best_.vertex != null_index)
      result = geodesics_.from_vertex(best_.vertex);
    else
      result.origin = best_.source;
    Plane_point way = best_.way;
    if(is_line) // far behind it
      way.y += geodesics_.line_distance();
    const double c = std::cos(best_.turn), s = std::sin(best_.turn);
    result.x = end.x + c * way.x - s * way.y;
    result.y = end.y + s * way.x + c * way.y;
    result.halfedge = best_.first;
    result.crosses_halfedge = !best_.is_in_same_face || is_line;
    if(result.sigma == 0. && !is_line && geodesics_.has_turns())
      result.turn = direction() - std::atan2(end.y - result.y, end.x - result.x);
    return result;
  }

  /// in which the best path leaves the source at which it begins
  double direction() const
  {
    const Index v = best_.vertex;
    Index zero = v != null_index ? best_.halfedge : geodesics_.source_halfedge(best_.source);
    double turn = 0.;
    if(v != null_index)
    {
      while(faces_.source(zero) != v)
        zero = Mesh::next(zero);
      turn = faces_.angle_around_source(zero);
    }
    else if(zero / 3 != best_.halfedge / 3)
    {
      zero = faces_.opposite(zero);
      turn = geodesic_pi;
    }
    const Plane_point from = geodesics_.vertex_in_frame(best_.halfedge, faces_.source(zero)),
                      to = geodesics_.vertex_in_frame(best_.halfedge, faces_.target(zero));
    const double x = to.x - from.x, y = to.y - from.y;
    const double angle = std::atan2(best_.way.x * y - best_.way.y * x, -best_.way.x * x - best_.way.y * y);
    // along an edge, rounding may lead to its other side
    return turn + (angle < -0.5 * geodesic_pi && v == null_index ? angle + 2. * geodesic_pi : angle);
  }

  const Geodesic_results& geodesics_;
  const Geodesic_faces& faces_;
  double maximum_distance_;
  std::vector<std::size_t> sources_in_faces_;
  std::vector<Sector> sectors_; // a heap
  Start best_;
  double shortest_ = infinity; // of all paths that have been seen
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_POINT_SEARCH_H
