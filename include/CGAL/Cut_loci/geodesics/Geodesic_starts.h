// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_STARTS_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_STARTS_H

#include <CGAL/Cut_loci/geodesics/Geodesic_queries.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_batches.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Cut_loci::internal {

/// is shown the windows while they are propagated.
class Geodesic_window_observer
{
public:
  virtual ~Geodesic_window_observer() = default;
  /// the windows up to the distance `d` have been shown, up to some that come late
  virtual void advance(double /* d */) {}
  /// gets the windows of the halfedge `h`, in order, when they cross its face. It may keep the list, which it then says by
  /// returning `true`, until it hands it back to `Exact_geodesic_propagation::release()`.
  virtual bool take(Index h, Geodesic_window_list& list) = 0;
  /// gets, to keep, windows that reach the border halfedge `h` from its face, in the frame of the opposite that it has not
  virtual void take_on_border(Index h, Geodesic_window_list* list) = 0;
};

/// starts paths: at sources, and at vertices at which they bend.
class Geodesic_starts : public Geodesic_results
{
protected:
  explicit Geodesic_starts(std::shared_ptr<const Geodesic_faces> faces)
    : Geodesic_results(std::move(faces)),
      batches_(faces_.number_of_halfedges(), faces_.number_of_vertices(), finest_order * faces_.mean_edge_length())
  {
  }

  /// a path of length `d` to the vertex `v` has been found
  void reach(Index v, double d, const Geodesic_arrival& arrival)
  {
    if(improve(v, d, arrival) && faces_.is_pseudo_source(v))
      batches_.push_vertex(d, v);
  }

  /// is straight up to rounding, past the end of a window or a vertex: it counts if no window covers the vertex it leads to,
  /// or only those of longer paths
  struct Path_beside
  {
    Index vertex;
    double distance;
    Geodesic_arrival arrival;
  };

  /// by more than it is longer than a straight one
  bool is_shorter(const Path_beside& path) const
  {
    return path.distance < (1. - geodesic_cover) * distance_[path.vertex];
  }

  void note(const Path_beside& path)
  {
    if(!is_shorter(path))
      return;
    if(is_reached(path.vertex))
      reach(path.vertex, path.distance, path.arrival);
    else
      beside_.push_back(path);
  }

  template <int columns>
  void start_at_vertex(std::size_t number)
  {
    const Index v = sources_[number].vertex;
    if(distance_[v] == 0.)
      return;
    distance_[v] = 0.;
    arrival_[v] = Geodesic_arrival();
    arrival_[v].halfedge = faces_.first_halfedge(v);
    arrival_[v].origin = static_cast<Index>(number);
    // On lines, only between their outer rays. The margin is for the rounding of these, as at a bend: it is that of a longer
    // way, from the image of the line. What is in the margin are paths as well, but not the shortest.
    constexpr double margin = 1e-6;
    const std::array<double, 2> fan =
      is_on_line(v) ? Geodesic_results::fan(v) : std::array<double, 2>{{-infinity, infinity}};
    const Index first = faces_.first_halfedge(v);
    double angle = 0.;
    Index h = first;
    do
    {
      Geodesic_arrival start;
      start.turn = has_turns() ? angle : 0.;
      start.origin = static_cast<Index>(number);
      const double width = faces_.angle(h), from = (std::max)(0., fan[0] - margin - angle),
                   to = (std::min)(width, fan[1] + margin - angle);
      if(from < to)
        emit<columns>(h, from, to, start);
      angle += width;
      h = faces_.next_around_source(h);
    } while(h != null_index && h != first);
  }

  /// as if windows from behind the border had come to its halfedge
  template <int columns>
  void start_at_line(std::size_t number)
  {
    const Index source = static_cast<Index>(number), h = line_halfedge(source);
    const Plane_point image = line_image(source);
    Geodesic_window w{0., faces_.length(h), image.x, image.y, -line_distance(), 0., double(number)};
    if(has_parallel_waves())
    {
      w.x = w.sigma = 0.;
      w.origin += Geodesic_window::parallel;
    }
    batches_.insert<columns>(h, w, faces_.length(h));
  }

  /// for sources on edges and in faces
  template <int columns>
  void start_in_face(std::size_t number)
  {
    const Source& source = sources_[number];
    const Index f = source.location.face;
    if(source.halfedge == null_index)
    {
      start_in_face<columns>(number, 3 * f, faces_.in_frame(3 * f, source.location.coordinates), 0., null_index);
      return;
    }
    const Index h = source.halfedge, o = faces_.opposite(h);
    const double t = source.location.coordinates[Mesh::next(h) % 3] * faces_.length(h);
    start_in_face<columns>(number, h, {t, 0.}, 0., h);
    if(o != null_index)
      start_in_face<columns>(number, o, {faces_.length(h) - t, 0.}, geodesic_pi, o);
  }

  /// starts across all halfedges but `skipped` of the face of `h`, in whose frame the source is given
  template <int columns>
  void start_in_face(std::size_t number, Index h, const Plane_point& p, double turn, Index skipped)
  {
    Geodesic_arrival arrival;
    arrival.x = p.x;
    arrival.y = p.y;
    arrival.turn = has_turns() ? turn : 0.;
    arrival.halfedge = h;
    arrival.origin = static_cast<Index>(number);
    const std::array<Plane_point, 3> corner = {{{0., 0.}, {faces_.length(h), 0.}, faces_.apex(h)}};
    double rotation = 0.;
    Index g = h;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Plane_point &from = corner[i], &to = corner[(i + 1) % 3];
      reach(faces_.source(g), std::hypot(from.x - p.x, from.y - p.y), arrival);
      const Index o = faces_.opposite(g);
      if(g != skipped && (o != null_index || observer_ != nullptr))
      {
        // the frame of the opposite halfedge starts at `to`
        const double length = faces_.length(g);
        const double ux = (from.x - to.x) / length, uy = (from.y - to.y) / length;
        const double dx = p.x - to.x, dy = p.y - to.y;
        const double depth = dy * ux - dx * uy;
        Geodesic_window w{0., length, dx * ux + dy * uy, (std::min)(depth, 0.), 0., 0., double(number)};
        if(has_turns())
          w.turn = turn + rotation - geodesic_pi;
        if(sources_.size() > 1 && o != null_index)
          batches_.mark_inner_source(o);
        send<columns>(g, w);
      }
      rotation += geodesic_pi - faces_.angle(Mesh::next(g));
      g = Mesh::next(g);
    }
  }

  /// sends the paths through the corner at the source of `h` with angles in `[from, to]` into the next face
  template <int columns>
  void emit(Index h, double from, double to, Geodesic_arrival start)
  {
    const Geodesic_face& face = faces_.face_of(h);
    const Index next = Mesh::next(h), v = faces_.source(h);
    const Geodesic_face::Corner& here = face.corner[h % 3];
    const Geodesic_face::Corner& right = face.corner[next % 3];
    const Geodesic_face::Corner& left = face.corner[Mesh::previous(h) % 3];
    start.halfedge = h;
    const bool starts_at_edge = from <= 0., ends_at_edge = to >= here.angle;
    if(starts_at_edge)
      reach(faces_.target(h), distance_[v] + here.length, start);
    if(ends_at_edge)
      reach(faces_.source(Mesh::previous(h)), distance_[v] + left.length, start);
    if(faces_.opposite(next) == null_index && observer_ == nullptr)
      return;
    Geodesic_window w;
    w.a = ends_at_edge ? 0. : right.length - here.length * std::sin(to) / std::sin(to + right.angle);
    w.b = starts_at_edge ? right.length : right.length - here.length * std::sin(from) / std::sin(from + right.angle);
    w.a = (std::max)(w.a, 0.);
    w.b = (std::min)(w.b, right.length);
    if(!(w.b - w.a > geodesic_narrow * right.length))
      return;
    w.x = left.length * left.cosine;
    w.y = -left.length * left.sine;
    w.sigma = start.sigma;
    w.turn = has_turns() ? start.turn - start.rate * right.angle : start.turn;
    w.origin = double(start.origin);
    w.rate = start.rate;
    w.error = start.error;
    send<columns>(next, w);
  }

  /// hands a window that leaves the face of `g` to the opposite of `g`, in whose frame it is given
  template <int columns>
  void send(Index g, const Geodesic_window& w)
  {
    const Index o = faces_.opposite(g);
    if(o != null_index)
    {
      batches_.insert<columns>(o, w, faces_.length(o));
      return;
    }
    Geodesic_window_list* list = batches_.allocate<columns>(1);
    list->append<columns>(w);
    observer_->take_on_border(g, list);
  }

  /// the same for a list of windows; `side` and `key` as for `Geodesic_batches::store()`
  template <int columns>
  void send(Index g, std::size_t side, Geodesic_window_list* list, double key)
  {
    if(faces_.opposite(g) != null_index)
      batches_.store<columns>(faces_.opposite(g), side, list, faces_.length(g), key);
    else if(list->empty())
      batches_.release(list);
    else
      observer_->take_on_border(g, list);
  }

  /// continues the shortest path to `v`, at which it may bend, into its shadow
  template <int columns>
  void bend(Index v)
  {
    const double sigma = distance_[v];
    if(sigma == 0. || sigma > maximum_distance_)
      return;
    const Geodesic_direction in = arrival_direction(v);
    Geodesic_arrival start = from_vertex(v);
    const bool is_turned = has_turns() && is_origin(v);
    if(columns > 5 && is_turned)
      bends_[v] = {direction_at_source(v), source_of(arrival_[v]), arrival_[v].origin,
                   direction_at_origin(arrival_[v], end_in_frame(arrival_[v], v))};
    // a shadow that is wider by the accuracy of the angle only adds a few paths that are not the shortest
    constexpr double margin = 1e-9;
    const bool is_border = faces_.is_border(v);
    const double first = geodesic_pi - margin;
    const double last = is_border ? infinity : faces_.total_angle(v) - geodesic_pi + margin;
    double angle = -in.angle;
    Index h = in.halfedge;
    do
    {
      const double width = faces_.angle(h);
      if(is_turned)
        start.turn = angle;
      note_along_edge(h, first - angle, angle - last, start);
      if(angle + width > first && angle < last)
        emit<columns>(h, first - angle, (std::min)(last - angle, width), start);
      angle += width;
      h = faces_.next_around_source(h);
    } while(h != null_index && h != in.halfedge && angle < last + root_of_cover);
    if(!is_border)
      return;
    angle = faces_.angle(in.halfedge) - in.angle;
    h = in.halfedge;
    while(h != null_index)
    {
      const double width = faces_.angle(h);
      angle -= width;
      if(is_turned)
        start.turn = angle;
      note_along_edge(h, first + angle, -infinity, start);
      if(angle < -first)
        emit<columns>(h, 0., (std::min)(-first - angle, width), start);
      h = faces_.previous_around_source(h);
    }
  }

private:
  /// A path that bends by less than this is as long as the straight one, which saves half its square, up to the accuracy of
  /// windows: so that beside a shadow, the window of the straight one may be lost.
  static constexpr double root_of_cover = 3e-5;

  /// notes the path to the end of an edge at `start` that is outside of the shadow by one of these angles
  void note_along_edge(Index h, double before, double behind, Geodesic_arrival start)
  {
    if(const double outside = (std::max)(before, behind); outside > 0. && outside < root_of_cover)
    {
      start.halfedge = h;
      note({faces_.target(h), distance_[faces_.source(h)] + faces_.length(h), start});
    }
  }

  // In the order of the distance, windows that take the same way wait for each other, in long lists, however short some of
  // the edges are.
  static constexpr double finest_order = 1. / 1024.;

protected:
  Geodesic_batches batches_;
  Geodesic_window_observer* observer_ = nullptr; // in the run in work
  double maximum_distance_ = infinity;
  std::vector<Path_beside> beside_; // to vertices that have not been reached
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_STARTS_H
