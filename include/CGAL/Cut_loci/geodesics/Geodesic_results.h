// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESICS_GEODESIC_RESULTS_H
#define CGAL_CUT_LOCI_GEODESICS_GEODESIC_RESULTS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_queries.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_sources.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/geodesics/windows/Geodesic_windows.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/geodesics/windows/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * holds the sources of a run of `Exact_geodesic_propagation` and what it finds: the distance and the last straight
 * piece of the shortest path of each vertex and each query location.
 *
 * The public functions are const and hold after a run.
 */
class Geodesic_results : public Geodesic_sources
{
public:
  /// the distance of each vertex, infinite if not reached
  const std::vector<double>& distances() const { return has_images_of_lines() ? true_distance_ : distance_; }
  double true_distance(Index v) const { return distances()[v]; }
  /// the same by the images of lines, which is what windows and labels have
  double distance(Index v) const { return distance_[v]; }
  /// the length of a path of the length `d` by its image, which leaves its origin in some direction
  double true_length(Index origin, double d, double direction) const
  {
    if(!has_images_of_lines())
      return d;
    if(is_source(origin))
      return is_line(origin) ? distance_to_line(origin, d, direction) : d;
    const Index v = vertex_of_origin(origin);
    return d + (true_distance_[v] - distance_[v]);
  }
  /// by how much the distance of `v` may be too long, if an error is allowed; it is never too short. With directions it is
  /// the other way round: a distance is the one to the image from which the direction comes.
  double distance_error(Index v) const
  {
    if(!is_approximate_ || !is_reached(v))
      return 0.;
    return has_directions_ ? arrival_[v].error : arrival_[v].turn;
  }
  /// whether an error has been allowed; there are no paths then, and directions if they have been asked for
  bool is_approximate() const { return is_approximate_; }
  /// whether the `turn` of a window is what it says, and not the error
  bool has_turns() const { return !is_approximate_ || has_directions_; }
  /// below this angle, what parts has not been told apart: zero but for distances with an error
  double merging_angle() const { return is_approximate_ ? merging_angle_ : 0.; }
  /// whether paths that bend at `v` have that as their origin; else they keep the origin and the direction of the path to it
  bool is_origin(Index v) const
  {
    if(!is_approximate_)
      return true;
    const double straight = faces_.is_border(v) ? geodesic_pi : 2. * geodesic_pi;
    return has_directions_ && faces_.total_angle(v) - straight > merging_angle_;
  }
  bool is_reached(Index v) const { return distance_[v] < infinity; }
  /// whether several shortest paths lead to `v`, which come from different directions: where that is so up to rounding, it
  /// is symmetry that makes them equally long. Only with windows that are shown, and exact.
  bool has_several_paths(Index v) const { return !has_several_paths_.empty() && has_several_paths_[v] != 0; }
  bool has_several_paths() const
  {
    return std::find(has_several_paths_.begin(), has_several_paths_.end(), 1) != has_several_paths_.end();
  }
  /// and paths bend at `v`, so that all points behind it have several shortest paths as well
  bool has_several_paths_to_bends() const
  {
    for(Index v = 0; v < has_several_paths_.size(); ++v)
      if(has_several_paths_[v] && faces_.is_pseudo_source(v))
        return true;
    return false;
  }

  /// the direction at its source in which the shortest path to `v` starts
  ///
  /// It is an angle in the unrolled tangent plane of the source, counterclockwise from `source_halfedge()`, in
  /// `[0, source_angle())`, up to and including `source_angle()` if the source is on the border.
  /// \pre directions have been asked for, `v` is reached and no source
  double direction_at_source(Index v) const { return direction_at_source(arrival_[v], end_in_frame(arrival_[v], v)); }

  /// the direction at `v` in which the shortest path to it leads back
  /// \pre `v` is reached and no source
  Geodesic_direction arrival_direction(Index v) const { return arrival_direction(v, arrival_[v]); }
  Geodesic_direction arrival_direction(Index v, const Geodesic_arrival& arrival) const
  {
    Index h = arrival.halfedge;
    while(faces_.source(h) != v)
      h = Indexed_triangle_mesh::next(h);
    const Plane_point end = end_in_frame(arrival, v);
    Plane_point along;
    if(h == arrival.halfedge)
      along = {1., 0.};
    else
    {
      const Geodesic_face& face = faces_.face_of(h);
      const Index i = arrival.halfedge % 3;
      if(h == Indexed_triangle_mesh::next(arrival.halfedge))
      {
        const Geodesic_face::Corner& corner = face.corner[h % 3];
        along = {-corner.cosine, corner.sine};
      }
      else
        along = {-face.corner[i].cosine, -face.corner[i].sine};
    }
    const double dx = arrival.x - end.x, dy = arrival.y - end.y;
    const double angle = std::atan2(along.x * dy - along.y * dx, along.x * dx + along.y * dy);
    // a path along an edge, or past a vertex, may turn out beside the face by a rounding error
    constexpr double full_turn = 2. * geodesic_pi;
    return faces_.direction(h, angle < 0.5 * (faces_.angle(h) - full_turn) ? angle + full_turn : angle);
  }

  /// the same as an angle in the unrolled tangent plane of `v`, counterclockwise from its first halfedge
  double arrival_angle(Index v) const { return arrival_angle(v, arrival_[v]); }
  double arrival_angle(Index v, const Geodesic_arrival& arrival) const
  {
    const Geodesic_direction direction = arrival_direction(v, arrival);
    return faces_.angle_around_source(direction.halfedge) + direction.angle;
  }

  /// the owner of the source nearest to `v`
  Index nearest_source(Index v) const { return is_reached(v) ? owner(source_of(arrival_[v])) : null_index; }

  /// the number of query locations
  std::size_t number_of_queries() const { return queries_.size(); }
  /// what is known of one
  Geodesic_query answer(std::size_t i) const
  {
    Geodesic_query result = queries_[i];
    if(has_lines() && result.distance < infinity)
    {
      const Plane_point end = faces_.in_frame(result.arrival.halfedge, result.location.coordinates);
      result.distance =
        (std::max)(true_length(result.arrival, end, result.distance), 0.); // on a line, rounding may be below it
    }
    return result;
  }
  double query_distance(std::size_t i) const { return answer(i).distance; }
  /// a vertex in a face from which the path comes
  Geodesic_query at_vertex(Index v) const
  {
    Index h = is_reached(v) ? arrival_[v].halfedge : faces_.first_halfedge(v);
    while(faces_.source(h) != v)
      h = Mesh::next(h);
    return {location_on(h), distance_[v], arrival_[v]};
  }
  Index nearest_source(const Geodesic_query& query) const
  {
    return query.distance < infinity ? owner(source_of(query.arrival)) : null_index;
  }
  double direction_at_source(const Geodesic_query& query) const
  {
    return direction_at_source(query.arrival, faces_.in_frame(query.arrival.halfedge, query.location.coordinates));
  }

  /// the direction in which a path with the last piece `arrival` to the point `end` leaves the (pseudo-)source of that
  /// piece: at a source as `direction_at_source()`, but not reduced; at a pseudo-source the angle from the direction
  /// that leads back, counterclockwise
  static double direction_at_origin(const Geodesic_arrival& arrival, const Plane_point& end)
  {
    return arrival.turn + arrival.rate * std::atan2(end.y - arrival.y, end.x - arrival.x);
  }

  /// what paths that go on from the vertex `v` begin with, but for the frame; at an origin, without the direction
  Geodesic_arrival from_vertex(Index v) const
  {
    Geodesic_arrival result;
    result.sigma = distance_[v];
    result.error = arrival_[v].error;
    result.origin = arrival_[v].origin;
    if(distance_[v] == 0.)
      return result;
    if(is_origin(v))
      result.origin = origin_of_vertex(v);
    else if(has_directions_)
    {
      result.turn = direction_at_origin(arrival_[v], end_in_frame(arrival_[v], v));
      result.rate = 0.;
    }
    else
      result.turn = arrival_[v].turn;
    return result;
  }

  /// replaces a vertex by the origin of the last piece of the path to it; returns the direction in which that piece leaves
  /// it
  double step_back(Index& origin) const
  {
    const Index v = vertex_of_origin(origin);
    if(!bends_.empty() && bends_[v].source != null_index)
    {
      origin = bends_[v].origin;
      return bends_[v].direction_at_origin;
    }
    origin = arrival_[v].origin;
    return direction_at_origin(arrival_[v], end_in_frame(arrival_[v], v));
  }

  /// the number of the source from which a path comes
  Index source_of(const Geodesic_arrival& arrival) const
  {
    if(sources_.size() == 1 || is_source(arrival.origin))
      return sources_.size() == 1 ? 0 : arrival.origin;
    const Index v = vertex_of_origin(arrival.origin);
    return bends_[v].source != null_index ? bends_[v].source : source_of(arrival_[v]);
  }

  /// the owner of the source of the paths that come from an origin
  Index source_of_origin(Index origin) const
  {
    if(sources_.size() == 1 || is_source(origin))
      return sources_.size() == 1 ? 0 : owner(origin);
    return owner(source_of(arrival_[vertex_of_origin(origin)]));
  }

  /// whether a source that is an edge ends at a vertex
  bool is_on_line(Index v) const
  {
    return has_lines() && faces_.is_border(v) && distance_[v] == 0. &&
           (first_line(v) != null_index || last_line(v) != null_index);
  }

  /// what is to be added to the distance from the image of an origin
  double sigma_of_origin(Index origin) const
  {
    if(!is_source(origin))
      return distance_[vertex_of_origin(origin)];
    return is_line(origin) ? -line_distance() : 0.;
  }

  /// How far beyond its rays a window of a halfedge sees: rounding leaves gaps between windows, and so do seams of lines, from
  /// which `sigma` is negative. A path that passes a vertex on the wrong side by this much is too short by about its square.
  double seen_beyond(double length, double sigma) const
  {
    return length * (sigma < 0. ? (std::max)(geodesic_cover, 0.5 * seam_angle()) : geodesic_cover);
  }

  /// the last straight pieces, for tracing paths
  const Geodesic_arrival& arrival(Index v) const { return arrival_[v]; }
  Plane_point end_in_frame(const Geodesic_arrival& arrival, Index v) const
  {
    return vertex_in_frame(arrival.halfedge, v);
  }

protected:
  struct Bend
  {
    double direction;           // at the source, of the path to the vertex
    Index source = null_index;  // its number, if paths have gone on from the vertex
    Index origin = null_index;  // of the last piece of that path, and
    double direction_at_origin; // in which that piece leaves it
  };

  using Geodesic_sources::Geodesic_sources;

  /// \throws Invalid_input if a location is none on the mesh
  void prepare(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options)
  {
    if(!(options.maximum_relative_error >= 0.))
      throw Invalid_input(Cause::INVALID_PARAMETER, "the maximum relative error must not be negative");
    is_approximate_ = options.maximum_relative_error > 0.;
    prepare_sources(sources, options);
    merging_angle_ = options.merging_angle;
    has_directions_ = options.directions || (sources_.size() > 1 && !is_approximate_);
    distance_.assign(faces_.number_of_vertices(), infinity);
    arrival_.resize(faces_.number_of_vertices());
    has_several_paths_.clear();
    bends_.clear();
    if(has_directions_)
      bends_.resize(faces_.number_of_vertices());
    for(const Indexed_location& location : options.queries)
      check(location);
    queries_.prepare(options.queries, faces_.number_of_faces());
  }

  /// up to which lengths of paths are equal: far above rounding, and far below what happens by chance
  static constexpr double equal_lengths = 1e-10;

  void count_paths() { has_several_paths_.assign(distance_.size(), 0); }
  bool counts_paths() const { return !has_several_paths_.empty(); }

  /// a path of length `d` to the vertex `v` has been found; returns whether it is the shortest so far
  bool improve(Index v, double d, const Geodesic_arrival& arrival)
  {
    if(distance_[v] == 0.) // at the end of a line, rounding may be below it
      return false;
    if(counts_paths() && distance_[v] < infinity && d < (1. + equal_lengths) * distance_[v])
      has_several_paths_[v] =
        d > (1. - equal_lengths) * distance_[v] && (has_several_paths_[v] != 0 || are_apart(v, arrival_[v], arrival));
    // a smaller gain is rounding, and may be one forever
    if(!(d < distance_[v] * (1. - 1e-14)) && !(distance_[v] == infinity))
      return false;
    distance_[v] = d;
    arrival_[v] = arrival;
    return true;
  }

  /// finds the distances that those by images stand for, from the lines on
  void find_true_distances()
  {
    if(!has_images_of_lines())
      return;
    true_distance_ = distance_;
    std::vector<Index> order;
    for(Index v = 0; v < distance_.size(); ++v)
      if(is_reached(v) && distance_[v] != 0.)
        order.push_back(v);
    std::sort(order.begin(), order.end(), [this](Index a, Index b) { return distance_[a] < distance_[b]; });
    for(Index v : order)
      true_distance_[v] = true_length(arrival_[v], end_in_frame(arrival_[v], v), distance_[v]);
  }

  double true_length(const Geodesic_arrival& arrival, const Plane_point& end, double d) const
  {
    return true_length(arrival.origin, d, direction_at_origin(arrival, end));
  }

  /// forgets what is further away than `maximum_distance`
  void cut_off(double maximum_distance)
  {
    for(std::size_t i = 0; i < number_of_queries(); ++i)
      if(query_distance(i) > maximum_distance)
        queries_.all()[i].distance = infinity;
    for(Index v = 0; v < distance_.size(); ++v)
      if(true_distance(v) > maximum_distance)
        distance_[v] = infinity;
    for(double& d : true_distance_) // if they count
      d = d <= maximum_distance ? d : infinity;
  }

  /// the last piece of a path of a window that crosses `h`
  static Geodesic_arrival end_of(const Geodesic_window& w, Index h)
  {
    Geodesic_arrival result;
    result.x = w.x;
    result.y = w.y;
    result.sigma = w.sigma;
    result.turn = w.turn;
    result.halfedge = h;
    result.origin = static_cast<Index>(w.is_parallel() ? w.origin - Geodesic_window::parallel : w.origin);
    result.crosses_halfedge = true;
    result.rate = w.rate;
    result.error = w.error;
    return result;
  }

  /// turns distances that may be too short into ones that may be too long
  void add_errors()
  {
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
      distance_[v] += distance_error(v);
    for(Geodesic_query& query : queries_.all())
      if(query.distance < infinity)
        query.distance += query.arrival.turn;
  }

  /// whether there are query locations
  bool has_queries() const { return !queries_.empty(); }

  /// considers the paths to the query locations of the face that windows of `h` lead to
  ///
  /// A location in a wider gap than windows see beyond their rays is reached around the end of one: no path is shorter than
  /// it is. What bends there comes after all that is straight, up to the accuracy of windows.
  template <int columns>
  void answer_queries(Index h, const Geodesic_window_list& list)
  {
    const double length = faces_.length(h);
    const double *a = list.column(0), *b = list.column(1), *x = list.column(2), *y = list.column(3);
    const auto answer = [&](Geodesic_query& query)
    {
      const Plane_point p = faces_.in_frame(h, query.location.coordinates);
      for(std::size_t i = list.begin; i < list.end; ++i)
      {
        const double accuracy = seen_beyond(length, list.column(4)[i]);
        const Geodesic_side side = side_of_rays(a[i], b[i], x[i], y[i], p, accuracy);
        if(side != covers && (list.column(4)[i] < 0. || list.is_parallel<columns>(i)))
          continue; // waves of lines do not bend
        const double d =
          side == covers
            ? list.distance<columns>(i, p.x, p.y)
            : list.column(4)[i] + length_through({x[i], y[i]}, side == passes_left ? b[i] : a[i], p) + accuracy;
        if(d < query.distance)
        {
          const Geodesic_window w = list.get<columns>(i);
          query.distance = d;
          query.arrival = end_of(w, h);
        }
      }
    };
    queries_.for_each_in(h / 3, answer);
  }

  /// considers the paths to query locations that come from a vertex of the face, or a source in it
  void finish_queries()
  {
    for(Geodesic_query& query : queries_.all())
    {
      const Index f = query.location.face;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index v = faces_.source(h);
        const Plane_point p = faces_.in_frame(h, query.location.coordinates);
        const double d = distance_[v] + std::sqrt(p.x * p.x + p.y * p.y);
        if(!(d < query.distance))
          continue;
        query.distance = d;
        query.arrival = from_vertex(v);
        query.arrival.halfedge = h;
        if(distance_[v] == 0. && has_turns())
          query.arrival.turn = faces_.angle_around_source(h);
      }
    }
    for(std::size_t i = 0; i < sources_.size() && !queries_.empty(); ++i)
    {
      const Source& source = sources_[i];
      if(source.vertex != null_index || source.line != null_index)
        continue;
      if(source.halfedge == null_index)
      {
        const Index h = 3 * source.location.face;
        finish_queries(i, h, faces_.in_frame(h, source.location.coordinates), 0.);
        continue;
      }
      const Index h = source.halfedge, o = faces_.opposite(h);
      const double t = source.location.coordinates[Mesh::next(h) % 3] * faces_.length(h);
      finish_queries(i, h, {t, 0.}, 0.);
      if(o != null_index)
        finish_queries(i, o, {faces_.length(h) - t, 0.}, has_turns() ? geodesic_pi : 0.);
    }
  }

  /// the direction at its source in which the path with the last piece `arrival` to the point `end` starts
  double direction_at_source(const Geodesic_arrival& arrival, const Plane_point& end) const
  {
    if(!is_source(arrival.origin))
    {
      const Index v = vertex_of_origin(arrival.origin);
      return bends_[v].source != null_index ? bends_[v].direction : direction_at_source(v);
    }
    const Source& source = sources_[arrival.origin];
    const double angle = direction_at_origin(arrival, end);
    // rounding may lead out of the range; at a source on the border that is no full turn
    if(is_source_on_border(arrival.origin))
      return (std::min)((std::max)(angle, 0.), source.total_angle);
    if(angle < 0.)
      return angle + source.total_angle;
    return angle >= source.total_angle ? angle - source.total_angle : angle;
  }

private:
  bool has_images_of_lines() const { return has_lines() && !has_parallel_waves(); }

  /// whether two paths come to `v` from different directions
  bool are_apart(Index v, const Geodesic_arrival& first, const Geodesic_arrival& second) const
  {
    constexpr double least = 0.01; // a path that bends by less is longer by a share of the square of that
    if(first.halfedge == second.halfedge && first.x == second.x && first.y == second.y)
      return false; // one path that has been found again, as most are
    const double angle = std::fabs(arrival_angle(v, first) - arrival_angle(v, second));
    return angle > least && (faces_.is_border(v) || angle < faces_.total_angle(v) - least);
  }

  void finish_queries(std::size_t number, Index h, const Plane_point& source, double turn)
  {
    const auto finish = [&](Geodesic_query& query)
    {
      const Plane_point p = faces_.in_frame(h, query.location.coordinates);
      const double d = std::hypot(p.x - source.x, p.y - source.y);
      if(d < query.distance)
      {
        query.distance = d;
        query.arrival = Geodesic_arrival();
        query.arrival.x = source.x;
        query.arrival.y = source.y;
        query.arrival.turn = turn;
        query.arrival.halfedge = h;
        query.arrival.origin = static_cast<Index>(number);
      }
    };
    queries_.for_each_in(h / 3, finish);
  }

protected:
  std::vector<double> distance_;
  std::vector<double> true_distance_; // if there are lines
  std::vector<Geodesic_arrival> arrival_;
  std::vector<Bend> bends_; // of each vertex, with directions or several sources
  bool has_directions_ = false;

private:
  std::vector<unsigned char> has_several_paths_; // by vertex, or empty
  Geodesic_queries queries_;
  bool is_approximate_ = false;
  double merging_angle_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GEODESICS_GEODESIC_RESULTS_H
