// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_GEODESICS_GEODESIC_RESULTS_H
#define CGAL_CUT_LOCI_EXACT_GEODESICS_GEODESIC_RESULTS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_windows.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/exact_geodesics/geodesic_window_trimming.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// is an edge on the border all of whose points are sources, and the number of the set of sources that it belongs to.
struct Geodesic_line
{
  Index halfedge, owner;
};

/// says what a run of `Exact_geodesic_propagation` computes.
struct Exact_geodesic_options
{
  double maximum_distance = (std::numeric_limits<double>::infinity)(); ///< nothing beyond it is reached
  bool directions = false;                                             ///< whether directions at the source are wanted
  double maximum_relative_error = 0.;                                  ///< by which distances may be wrong
  double merging_angle = 0.;  ///< with such an error: by which directions may change where windows are merged
  bool all_centroids = false; ///< whether face centroids are query locations
  std::vector<Indexed_location> queries; ///< further points whose distance is wanted
  std::vector<Geodesic_line> lines;      ///< sources that are edges; with directions, and without an error
  std::vector<Index> owners;             ///< of the sources that are points, see `Geodesic_line`; empty: its own number
  Progress progress; ///< is told, every few milliseconds, the share of the vertices that are reached
};

/// is the end of a shortest path: its last straight piece, in the frame of a halfedge of the face in which it ends.
struct Geodesic_arrival
{
  double x = 0., y = 0.;         // the image of the (pseudo-)source
  double sigma = 0., turn = 0.;  // as in `Geodesic_window`
  Index halfedge = null_index;   // of the frame
  Index origin = null_index;     // as in `Geodesic_window`
  bool crosses_halfedge = false; // else the image lies in the face itself
  double rate = 1., error = 0.;  // as in `Geodesic_window`
};

/// is the direction of a shortest path at its end: an angle from a halfedge that leaves the end, counterclockwise.
struct Geodesic_arrival_direction
{
  Index halfedge;
  double angle;
};

/*!
 * holds the sources of a run of `Exact_geodesic_propagation` and what it finds: the distance and the last straight
 * piece of the shortest path of each vertex and each query location.
 *
 * The public functions are const and hold after a run.
 */
class Geodesic_results
{
public:
  /// a vertex as a location
  Indexed_location vertex_location(Index v) const
  {
    if(v >= faces_.number_of_vertices() || faces_.first_halfedge(v) == null_index)
      throw Invalid_input(Cause::INVALID_SOURCE, "vertex #" + std::to_string(v) + " is on no face");
    const Index h = faces_.first_halfedge(v);
    Indexed_location location;
    location.face = h / 3;
    location.coordinates[h % 3] = 1.;
    return location;
  }

  /// \throws Invalid_input if `location` is none on the mesh
  void check(const Indexed_location& location) const
  {
    if(location.face >= faces_.number_of_faces())
      throw Invalid_input(Cause::INVALID_SOURCE,
                          "a location is in face " + std::to_string(location.face) + ", which does not exist");
    double sum = 0.;
    bool is_inside = true;
    for(double c : location.coordinates)
    {
      is_inside = is_inside && c >= -1e-9; // what point location by projection may get wrong
      sum += c;
    }
    if(!is_inside || !(std::fabs(sum - 1.) <= 1e-9))
      throw Invalid_input(Cause::INVALID_SOURCE, "the coordinates of a location in face " +
                                                   std::to_string(location.face) + " are not barycentric");
  }

  const Geodesic_faces& faces() const { return faces_; }

  /// the distance of each vertex, infinite if not reached
  const std::vector<double>& distances() const { return distance_; }
  double distance(Index v) const { return distance_[v]; }
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

  /// the direction at its source in which the shortest path to `v` starts
  ///
  /// It is an angle in the unrolled tangent plane of the source, counterclockwise from `source_halfedge()`, in
  /// `[0, source_angle())`, up to and including `source_angle()` if the source is on the border.
  /// \pre directions have been asked for, `v` is reached and no source
  double direction_at_source(Index v) const { return direction_at_source(arrival_[v], end_in_frame(arrival_[v], v)); }

  /// the direction at `v` in which the shortest path to it leads back
  /// \pre `v` is reached and no source
  Geodesic_arrival_direction arrival_direction(Index v) const
  {
    const Geodesic_arrival& arrival = arrival_[v];
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
    // a path along an edge may turn out on the other side of it by a rounding error
    const double corner = faces_.angle(h);
    if(angle < 0.5 * (corner - 2. * geodesic_pi) || angle > corner)
      return {h, corner};
    return {h, (std::max)(angle, 0.)};
  }

  /// the same as an angle in the unrolled tangent plane of `v`, counterclockwise from its first halfedge
  double arrival_angle(Index v) const
  {
    const Geodesic_arrival_direction direction = arrival_direction(v);
    return faces_.angle_around_source(direction.halfedge) + direction.angle;
  }

  /// the owner of the source nearest to `v`
  Index nearest_source(Index v) const { return is_reached(v) ? owner(source_of(arrival_[v])) : null_index; }

  std::size_t number_of_sources() const { return sources_.size(); }
  /// the total angle at source number `i`: two pi in faces
  double source_angle(std::size_t i = 0) const { return sources_[i].total_angle; }

  bool is_source_on_border(std::size_t i = 0) const
  {
    const Source& source = sources_[i];
    return source.vertex != null_index ? faces_.is_border(source.vertex) : source.total_angle < 1.5 * geodesic_pi;
  }

  /// the halfedge along which directions at source number `i` are zero
  Index source_halfedge(std::size_t i = 0) const
  {
    const Source& source = sources_[i];
    if(source.vertex != null_index)
      return faces_.first_halfedge(source.vertex);
    return source.halfedge != null_index ? source.halfedge : 3 * source.location.face;
  }

  /// the number of query locations: those of the options, then one per face if centroids have been asked for
  std::size_t number_of_queries() const { return queries_.size(); }
  const Indexed_location& query(std::size_t i) const { return queries_[i].location; }
  double query_distance(std::size_t i) const { return queries_[i].distance; }
  Index query_nearest_source(std::size_t i) const
  {
    return queries_[i].distance < infinity ? owner(source_of(queries_[i].arrival)) : null_index;
  }
  double query_direction_at_source(std::size_t i) const
  {
    const Query& query = queries_[i];
    return direction_at_source(query.arrival, faces_.in_frame(query.arrival.halfedge, query.location.coordinates));
  }

  /// the number of a vertex as an origin, and back; the sources come first
  Index origin_of_vertex(Index v) const { return static_cast<Index>(sources_.size()) + v; }
  Index vertex_of_origin(Index origin) const { return origin - static_cast<Index>(sources_.size()); }
  bool is_source(Index origin) const { return origin < sources_.size(); }

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

  // -- sources that are edges ------------------------------------------------------------------------------------------
  //
  // The waves of an edge are parallel. They are those of an image far behind it, at the same distance D from both of its
  // ends, and `sigma` is -D: so distances are zero at the ends of an edge of the length l, and in between down to
  // -l^2 / (8 D), as sqrt(D^2 - l^2 / 4) says. A path of the image starts somewhere on the edge, and is too short by no more.

  /// the number of the set of sources that a source belongs to
  Index owner(Index source) const { return sources_[source].owner; }
  bool has_lines() const { return !line_at_.empty(); }
  bool is_line(Index origin) const { return is_source(origin) && sources_[origin].line != null_index; }
  Index line_halfedge(Index source) const { return sources_[source].line; }
  /// the number of the source that is the border halfedge `h`, or null
  Index line_at(Index h) const { return line_at_.empty() ? null_index : line_at_[h]; }
  /// whether a source that is an edge ends at a vertex
  bool is_on_line(Index v) const
  {
    return has_lines() && faces_.is_border(v) && distance_[v] == 0. &&
           (first_line(v) != null_index || last_line(v) != null_index);
  }
  /// the sources that are the border edges at a vertex, or null: before its first face, and behind its last one
  Index first_line(Index v) const { return line_at(faces_.first_halfedge(v)); }
  Index last_line(Index v) const { return line_at(Mesh::previous(last_halfedge(v))); }

  /// of the images of lines from the ends of their edges, in units of the longest edge. A distance is too short by up to
  /// 1/65536 of that edge then, and known to 1e-12 of it: both are far below what else is known.
  static constexpr double line_reach = 8192.;
  double line_distance() const { return line_distance_; }
  /// half of the angle between the outer rays of a source: zero for a point
  double half_opening(Index source) const
  {
    const Index h = sources_[source].line;
    return h == null_index ? 0. : std::asin(0.5 * faces_.length(h) / line_distance_);
  }
  /// the image of a line, in the frame of its halfedge
  Plane_point line_image(Index source) const
  {
    const double half = 0.5 * faces_.length(sources_[source].line);
    return {half, -std::sqrt((line_distance_ - half) * (line_distance_ + half))};
  }
  /// what is to be added to the distance from the image of an origin
  double sigma_of_origin(Index origin) const
  {
    if(!is_source(origin))
      return distance_[vertex_of_origin(origin)];
    return is_line(origin) ? -line_distance_ : 0.;
  }

  /// Of a vertex on lines, the directions from the first halfedge between the outer rays of the lines: in between, paths
  /// start at the vertex. If the second one is smaller, the lines see all points first.
  std::array<double, 2> fan(Index v) const
  {
    constexpr double right = 0.5 * geodesic_pi;
    const Index first = first_line(v), last = last_line(v);
    return {{first != null_index ? right + half_opening(first) : -infinity,
             last != null_index ? faces_.total_angle(v) - right - half_opening(last) : infinity}};
  }

  /// whether two sources of one set, both of them edges or one of them a vertex, have an end in common
  bool are_neighbors(Index a, Index b) const
  {
    if(!is_source(a) || !is_source(b) || owner(a) != owner(b) || (!is_line(a) && !is_line(b)))
      return false;
    const std::array<Index, 2> at_a = ends(a), at_b = ends(b);
    return at_a[0] == at_b[0] || at_a[0] == at_b[1] || at_a[1] == at_b[0] || at_a[1] == at_b[1];
  }

  /// whether paths that meet at this angle come from neighbors whose outer rays, in truth, are one: the boundary between
  /// them is on no cut locus. Outer rays of lines one behind the other meet at up to half of what is allowed; the rest is
  /// for corners that are no larger than that.
  bool is_seam(Index a, Index b, double meeting_angle) const
  {
    return has_lines() && meeting_angle <= 2. / line_reach && are_neighbors(a, b);
  }

  /// the last straight pieces, for tracing paths
  const Geodesic_arrival& arrival(Index v) const { return arrival_[v]; }
  const Geodesic_arrival& query_arrival(std::size_t i) const { return queries_[i].arrival; }
  const Indexed_location& source_location(std::size_t i) const { return sources_[i].location; }
  Index source_vertex(std::size_t i) const { return sources_[i].vertex; }
  /// a halfedge of the edge it is on, if it is on one
  Index source_edge(std::size_t i) const { return sources_[i].halfedge; }

  /// a vertex of the face of `h` in the frame of `h`
  Plane_point vertex_in_frame(Index h, Index v) const
  {
    if(faces_.source(h) == v)
      return {0., 0.};
    if(faces_.target(h) == v)
      return {faces_.length(h), 0.};
    return faces_.apex(h);
  }
  Plane_point end_in_frame(const Geodesic_arrival& arrival, Index v) const
  {
    return vertex_in_frame(arrival.halfedge, v);
  }

  /// source number `i` in the frame of `h`, if it lies in the face of `h`
  bool source_in_frame(std::size_t i, Index h, Plane_point& p) const
  {
    const Source& source = sources_[i];
    const Index f = h / 3;
    if(source.vertex != null_index)
    {
      for(Index v : faces_.face(f).vertex)
        if(v == source.vertex)
        {
          p = vertex_in_frame(h, v);
          return true;
        }
      return false;
    }
    if(source.line != null_index)
      return false;
    if(source.location.face == f)
    {
      p = faces_.in_frame(h, source.location.coordinates);
      return true;
    }
    if(source.halfedge == null_index)
      return false;
    const Index o = faces_.opposite(source.halfedge);
    if(o == null_index || o / 3 != f)
      return false;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    coordinates[o % 3] = source.location.coordinates[Mesh::next(source.halfedge) % 3];
    coordinates[Mesh::next(o) % 3] = source.location.coordinates[source.halfedge % 3];
    p = faces_.in_frame(h, coordinates);
    return true;
  }

protected:
  using Mesh = Indexed_triangle_mesh;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  struct Source
  {
    Indexed_location location;
    Index vertex;   // if it is at one
    Index halfedge; // if it is on an edge
    double total_angle;
    Index owner = null_index;
    Index line = null_index; // the halfedge, if it is an edge
  };

  struct Query
  {
    Indexed_location location;
    double distance;
    Geodesic_arrival arrival;
  };

  struct Bend
  {
    double direction;           // at the source, of the path to the vertex
    Index source = null_index;  // its number, if paths have gone on from the vertex
    Index origin = null_index;  // of the last piece of that path, and
    double direction_at_origin; // in which that piece leaves it
  };

  explicit Geodesic_results(std::shared_ptr<const Geodesic_faces> faces)
    : shared_faces_(std::move(faces)), faces_(*shared_faces_)
  {
  }

  /// \throws Invalid_input if a location is none on the mesh
  void prepare(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options)
  {
    if(!(options.maximum_relative_error >= 0.))
      throw Invalid_input(Cause::INVALID_PARAMETER, "the maximum relative error must not be negative");
    is_approximate_ = options.maximum_relative_error > 0.;
    sources_.clear();
    for(const Indexed_location& location : sources)
      sources_.push_back(classify(location));
    for(std::size_t i = 0; i < sources_.size(); ++i)
      sources_[i].owner = options.owners.empty() ? static_cast<Index>(i) : options.owners[i];
    prepare_lines(options.lines);
    merging_angle_ = options.merging_angle;
    has_directions_ = options.directions || (sources_.size() > 1 && !is_approximate_);
    distance_.assign(faces_.number_of_vertices(), infinity);
    arrival_.resize(faces_.number_of_vertices());
    bends_.clear();
    if(has_directions_)
      bends_.resize(faces_.number_of_vertices());
    prepare_queries(options);
  }

  /// a path of length `d` to the vertex `v` has been found; returns whether it is the shortest so far
  bool improve(Index v, double d, const Geodesic_arrival& arrival)
  {
    if(distance_[v] == 0.) // at the end of a line, rounding may be below it
      return false;
    // a smaller gain is rounding, and may be one forever
    if(!(d < distance_[v] * (1. - 1e-14)) && !(distance_[v] == infinity))
      return false;
    distance_[v] = d;
    arrival_[v] = arrival;
    return true;
  }

  /// forgets what is further away than `maximum_distance`
  void cut_off(double maximum_distance)
  {
    for(double& d : distance_)
      d = d <= maximum_distance ? d : infinity;
    for(Query& query : queries_)
      query.distance = query.distance <= maximum_distance ? query.distance : infinity;
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
    result.origin = static_cast<Index>(w.origin);
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
    for(Query& query : queries_)
      if(query.distance < infinity)
        query.distance += query.arrival.turn;
  }

  /// whether there are query locations
  bool has_queries() const { return !queries_.empty(); }

  /// considers the paths to the query locations of the face that windows of `h` lead to
  template <int columns>
  void answer_queries(Index h, const Geodesic_window_list& list)
  {
    const double tolerance = geodesic_cover * faces_.length(h);
    const double *a = list.column(0), *b = list.column(1), *x = list.column(2), *y = list.column(3);
    for(Index q = query_first_[h / 3]; q < query_first_[h / 3 + std::size_t(1)]; ++q)
    {
      Query& query = queries_[query_index_[q]];
      const Plane_point p = faces_.in_frame(h, query.location.coordinates);
      for(std::size_t i = list.begin; i < list.end; ++i)
      {
        if(side_of_rays(a[i], b[i], x[i], y[i], p, tolerance) != covers)
          continue;
        const double d = list.column(4)[i] + std::sqrt((p.x - x[i]) * (p.x - x[i]) + (p.y - y[i]) * (p.y - y[i]));
        if(d < query.distance)
        {
          const Geodesic_window w = list.get<columns>(i);
          query.distance = d;
          query.arrival = end_of(w, h);
        }
      }
    }
  }

  /// considers the paths to query locations that come from a vertex of the face, or a source in it
  void finish_queries()
  {
    for(Query& query : queries_)
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

  /// whether `turn` is what it says, and not the error
  bool has_turns() const { return !is_approximate_ || has_directions_; }

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
  Source classify(Indexed_location location) const
  {
    check(location);
    // a point nearer than this to an edge is on it: no coordinate of a mesh is known any better
    constexpr double snap = 1e-13;
    double sum = 0.;
    for(double& c : location.coordinates)
    {
      c = c < snap ? 0. : c;
      sum += c;
    }
    std::size_t zeros = 0;
    for(double& c : location.coordinates)
    {
      c /= sum;
      zeros += c == 0.;
    }
    Source source{location, null_index, null_index, 2. * geodesic_pi};
    const Index h = 3 * location.face;
    for(Index i = 0; i < 3; ++i)
      if(zeros == 2 && location.coordinates[i] != 0.)
      {
        source.vertex = faces_.face(location.face).vertex[i];
        source.total_angle = faces_.total_angle(source.vertex);
      }
      else if(zeros == 1 && location.coordinates[i] == 0.)
      {
        source.halfedge = Mesh::next(h + i);
        if(faces_.opposite(source.halfedge) == null_index)
          source.total_angle = geodesic_pi;
      }
    return source;
  }

  void prepare_lines(const std::vector<Geodesic_line>& lines)
  {
    line_at_.clear();
    if(lines.empty())
      return;
    line_at_.assign(faces_.number_of_halfedges(), null_index);
    double longest = 0.;
    for(const Geodesic_line& line : lines)
    {
      longest = (std::max)(longest, faces_.length(line.halfedge));
      line_at_[line.halfedge] = static_cast<Index>(sources_.size());
      Source source{{}, null_index, null_index, geodesic_pi, line.owner, line.halfedge};
      source.location.face = line.halfedge / 3;
      source.location.coordinates[line.halfedge % 3] = 0.5;
      source.location.coordinates[Mesh::next(line.halfedge) % 3] = 0.5;
      sources_.push_back(source);
    }
    line_distance_ = line_reach * longest;
  }

  /// that leaves `v`, a vertex of the border: the last one counterclockwise
  Index last_halfedge(Index v) const
  {
    Index h = faces_.first_halfedge(v);
    while(faces_.next_around_source(h) != null_index)
      h = faces_.next_around_source(h);
    return h;
  }

  /// the vertices of a source that is an edge or a vertex
  std::array<Index, 2> ends(Index source) const
  {
    const Index h = sources_[source].line, v = sources_[source].vertex;
    return h != null_index ? std::array<Index, 2>{{faces_.source(h), faces_.target(h)}} : std::array<Index, 2>{{v, v}};
  }

  void prepare_queries(const Exact_geodesic_options& options)
  {
    queries_.clear();
    query_first_.clear();
    query_index_.clear();
    for(const Indexed_location& location : options.queries)
    {
      check(location);
      queries_.push_back({location, infinity, Geodesic_arrival()});
    }
    if(options.all_centroids)
      for(Index f = 0; f < faces_.number_of_faces(); ++f)
      {
        Indexed_location location;
        location.face = f;
        location.coordinates = {{1. / 3., 1. / 3., 1. / 3.}};
        queries_.push_back({location, infinity, Geodesic_arrival()});
      }
    if(queries_.empty())
      return;
    query_first_.assign(faces_.number_of_faces() + std::size_t(1), 0);
    for(const Query& query : queries_)
      ++query_first_[query.location.face + std::size_t(1)];
    for(std::size_t f = 0; f < faces_.number_of_faces(); ++f)
      query_first_[f + 1] += query_first_[f];
    query_index_.resize(queries_.size());
    std::vector<Index> next(query_first_.begin(), query_first_.end() - 1);
    for(std::size_t i = 0; i < queries_.size(); ++i)
      query_index_[next[queries_[i].location.face]++] = static_cast<Index>(i);
  }

  void finish_queries(std::size_t number, Index h, const Plane_point& source, double turn)
  {
    for(Index q = query_first_[h / 3]; q < query_first_[h / 3 + std::size_t(1)]; ++q)
    {
      Query& query = queries_[query_index_[q]];
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
    }
  }

  std::shared_ptr<const Geodesic_faces> shared_faces_; // with others for the same mesh

protected:
  const Geodesic_faces& faces_;
  std::vector<Source> sources_;
  std::vector<double> distance_;
  std::vector<Geodesic_arrival> arrival_;
  std::vector<Bend> bends_; // of each vertex, with directions or several sources
  bool has_directions_ = false;
  std::vector<Index> line_at_; // by halfedge; empty without lines
  double line_distance_ = 0.;

private:
  std::vector<Query> queries_;
  std::vector<Index> query_first_, query_index_; // the queries of each face
  bool is_approximate_ = false;
  double merging_angle_ = 0.;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_GEODESICS_GEODESIC_RESULTS_H
