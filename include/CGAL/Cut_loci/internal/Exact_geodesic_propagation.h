// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_EXACT_GEODESIC_PROPAGATION_H
#define CGAL_CUT_LOCI_INTERNAL_EXACT_GEODESIC_PROPAGATION_H

#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/internal/Geodesic_bucket_queue.h>
#include <CGAL/Cut_loci/internal/Geodesic_faces.h>
#include <CGAL/Cut_loci/internal/Geodesic_windows.h>
#include <CGAL/Cut_loci/internal/geodesic_window_kernels.h>
#include <CGAL/Cut_loci/internal/geodesic_window_trimming.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/// says what a run of `Exact_geodesic_propagation` computes.
struct Exact_geodesic_options
{
  double maximum_distance = (std::numeric_limits<double>::infinity)(); ///< nothing beyond it is reached
  bool directions = false;                                             ///< whether directions at the source are wanted
  bool all_centroids = false;                                          ///< whether face centroids are query locations
  std::vector<Indexed_location> queries;                               ///< further points whose distance is wanted
};

/// is the end of a shortest path: its last straight piece, in the frame of a halfedge of the face in which it ends.
struct Geodesic_arrival
{
  double x = 0., y = 0.;           // the image of the (pseudo-)source
  double sigma = 0., turn = 0.;    // as in `Geodesic_window`
  Index halfedge = null_index;     // of the frame
  Index source = null_index;       // the number of the true source, if there are several
  bool crosses_halfedge = false;   // else the image lies in the face itself
};

/// is the direction of a shortest path at its end: an angle from a halfedge that leaves the end, counterclockwise.
struct Geodesic_arrival_direction
{
  Index halfedge;
  double angle;
};

/*!
 * computes exact geodesic distances on a triangle mesh by propagating windows.
 *
 * Windows \cgalCite{mmp-dgp-87} cross the faces in batches, one per halfedge, in the order of the distance
 * \cgalCite{xu-fwp-15}. In the face entered, only the window with the shortest path to the apex goes on to both other
 * edges \cgalCite{ch-spp-90}; the ends of a batch lose the windows to which a path through a vertex of the face is
 * preferable \cgalCite{xw-ich-09}. Neighbouring windows are trimmed as described in `geodesic_window_trimming.h`.
 * Batches are forgotten once they have been propagated.
 *
 * The mesh geometry is read by the constructor. All memory is reused from one run to the next. Queries after a run
 * are const.
 */
class Exact_geodesic_propagation
{
public:
  /// \throws Invalid_input see `Geodesic_faces`
  ///
  /// `positions` are the numbers by which messages name the vertices, if not by their index.
  explicit Exact_geodesic_propagation(const Indexed_triangle_mesh& mesh, const std::vector<Index>* positions = nullptr)
    : m_faces(mesh, positions)
    , m_queue(0.5 * m_faces.mean_edge_length())
    , m_lists(3 * std::size_t(m_faces.number_of_halfedges()), nullptr)
  {}

  /// \throws Invalid_input if there is no source, or a location is none on the mesh
  void run(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options = {})
  {
    if(sources.empty())
      throw Invalid_input("no source");
    prepare(sources, options);
    m_columns = sources.size() > 1 ? 7 : options.directions ? 6 : 5;
    m_clean = false;
    if(m_columns == 5)
      propagate<5>();
    else if(m_columns == 6)
      propagate<6>();
    else
      propagate<7>();
    m_clean = true;
  }

  /// with a vertex as the only source
  void run(Index source, const Exact_geodesic_options& options = {})
  {
    run({vertex_location(source)}, options);
  }

  /// a vertex as a location
  Indexed_location vertex_location(Index v) const
  {
    if(v >= m_faces.number_of_vertices() || m_faces.first_halfedge(v) == null_index)
      throw Invalid_input("vertex #" + std::to_string(v) + " is on no face");
    const Index h = m_faces.first_halfedge(v);
    Indexed_location location;
    location.face = h / 3;
    location.coordinates[h % 3] = 1.;
    return location;
  }

  /// \throws Invalid_input if `location` is none on the mesh
  void check(const Indexed_location& location) const
  {
    if(location.face >= m_faces.number_of_faces())
      throw Invalid_input("a location is in face " + std::to_string(location.face) +
                                  ", which does not exist");
    double sum = 0.;
    bool is_inside = true;
    for(double c : location.coordinates) {
      is_inside = is_inside && c >= -1e-9; // what point location by projection may get wrong
      sum += c;
    }
    if(!is_inside || !(std::fabs(sum - 1.) <= 1e-9))
      throw Invalid_input("the coordinates of a location in face " +
                                  std::to_string(location.face) + " are not barycentric");
  }

  const Geodesic_faces& faces() const { return m_faces; }

  /// the distance of each vertex, infinite if not reached
  const std::vector<double>& distances() const { return m_distance; }
  double distance(Index v) const { return m_distance[v]; }
  bool is_reached(Index v) const { return m_distance[v] < infinity; }

  /// the direction at its source in which the shortest path to `v` starts
  ///
  /// It is an angle in the unrolled tangent plane of the source, counterclockwise from `source_halfedge()`, in
  /// `[0, source_angle())`, up to and including `source_angle()` if the source is on the border.
  /// \pre directions have been asked for, `v` is reached and no source
  double direction_at_source(Index v) const { return direction_at_source(m_arrival[v], end_in_frame(m_arrival[v], v)); }

  /// the direction at `v` in which the shortest path to it leads back
  /// \pre `v` is reached and no source
  Geodesic_arrival_direction arrival_direction(Index v) const
  {
    const Geodesic_arrival& arrival = m_arrival[v];
    Index h = arrival.halfedge;
    while(m_faces.source(h) != v)
      h = Indexed_triangle_mesh::next(h);
    const Plane_point end = end_in_frame(arrival, v);
    Plane_point along;
    if(h == arrival.halfedge)
      along = {1., 0.};
    else {
      const Geodesic_face& face = m_faces.face_of(h);
      const Index i = arrival.halfedge % 3;
      if(h == Indexed_triangle_mesh::next(arrival.halfedge)) {
        const Geodesic_face::Corner& corner = face.corner[h % 3];
        along = {-corner.cosine, corner.sine};
      } else
        along = {-face.corner[i].cosine, -face.corner[i].sine};
    }
    const double dx = arrival.x - end.x, dy = arrival.y - end.y;
    const double angle = std::atan2(along.x * dy - along.y * dx, along.x * dx + along.y * dy);
    // a path along an edge may turn out on the other side of it by a rounding error
    const double corner = m_faces.angle(h);
    if(angle < 0.5 * (corner - 2. * geodesic_pi) || angle > corner)
      return {h, corner};
    return {h, (std::max)(angle, 0.)};
  }

  /// the same as an angle in the unrolled tangent plane of `v`, counterclockwise from its first halfedge
  double arrival_angle(Index v) const
  {
    const Geodesic_arrival_direction direction = arrival_direction(v);
    return m_faces.angle_around_source(direction.halfedge) + direction.angle;
  }

  /// the number of the source nearest to `v`
  Index nearest_source(Index v) const { return is_reached(v) ? m_arrival[v].source : null_index; }

  std::size_t number_of_sources() const { return m_sources.size(); }
  /// the total angle at source number `i`: two pi in faces
  double source_angle(std::size_t i = 0) const { return m_sources[i].total_angle; }

  /// the halfedge along which directions at source number `i` are zero
  Index source_halfedge(std::size_t i = 0) const
  {
    const Source& source = m_sources[i];
    if(source.vertex != null_index)
      return m_faces.first_halfedge(source.vertex);
    return source.halfedge != null_index ? source.halfedge : 3 * source.location.face;
  }

  /// the number of query locations: those of the options, then one per face if centroids have been asked for
  std::size_t number_of_queries() const { return m_queries.size(); }
  const Indexed_location& query(std::size_t i) const { return m_queries[i].location; }
  double query_distance(std::size_t i) const { return m_queries[i].distance; }
  Index query_nearest_source(std::size_t i) const
  {
    return m_queries[i].distance < infinity ? m_queries[i].arrival.source : null_index;
  }
  double query_direction_at_source(std::size_t i) const
  {
    const Query& query = m_queries[i];
    return direction_at_source(query.arrival, m_faces.in_frame(query.arrival.halfedge, query.location.coordinates));
  }

  /// the last straight pieces, for tracing paths
  const Geodesic_arrival& arrival(Index v) const { return m_arrival[v]; }
  const Geodesic_arrival& query_arrival(std::size_t i) const { return m_queries[i].arrival; }
  const Indexed_location& source_location(std::size_t i) const { return m_sources[i].location; }
  Index source_vertex(std::size_t i) const { return m_sources[i].vertex; }

  /// a vertex of the face of `h` in the frame of `h`
  Plane_point vertex_in_frame(Index h, Index v) const
  {
    if(m_faces.source(h) == v)
      return {0., 0.};
    if(m_faces.target(h) == v)
      return {m_faces.length(h), 0.};
    return m_faces.apex(h);
  }
  Plane_point end_in_frame(const Geodesic_arrival& arrival, Index v) const
  {
    return vertex_in_frame(arrival.halfedge, v);
  }

  /// source number `i` in the frame of `h`, if it lies in the face of `h`
  bool source_in_frame(std::size_t i, Index h, Plane_point& p) const
  {
    const Source& source = m_sources[i];
    const Index f = h / 3;
    if(source.vertex != null_index) {
      for(Index v : m_faces.face(f).vertex)
        if(v == source.vertex) {
          p = vertex_in_frame(h, v);
          return true;
        }
      return false;
    }
    if(source.location.face == f) {
      p = m_faces.in_frame(h, source.location.coordinates);
      return true;
    }
    if(source.halfedge == null_index)
      return false;
    const Index o = m_faces.opposite(source.halfedge);
    if(o == null_index || o / 3 != f)
      return false;
    std::array<double, 3> coordinates = {{0., 0., 0.}};
    coordinates[o % 3] = source.location.coordinates[Mesh::next(source.halfedge) % 3];
    coordinates[Mesh::next(o) % 3] = source.location.coordinates[source.halfedge % 3];
    p = m_faces.in_frame(h, coordinates);
    return true;
  }

  /// the number of windows that have been propagated across a face in the last run
  std::size_t number_of_windows() const { return m_number_of_windows; }

private:
  using Mesh = Indexed_triangle_mesh;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  struct Source
  {
    Indexed_location location;
    Index vertex;   // if it is at one
    Index halfedge; // if it is on an edge
    double total_angle;
  };

  struct Query
  {
    Indexed_location location;
    double distance;
    Geodesic_arrival arrival;
  };

  // -- preparation ---------------------------------------------------------------------------------------------------

  void prepare(const std::vector<Indexed_location>& sources, const Exact_geodesic_options& options)
  {
    if(!m_clean) {
      // an exception has ended the last run
      std::fill(m_lists.begin(), m_lists.end(), nullptr);
      m_pool.clear();
    }
    m_queue.clear();
    m_sources.clear();
    for(const Indexed_location& location : sources)
      m_sources.push_back(classify(location));
    m_maximum_distance = options.maximum_distance;
    m_distance.assign(m_faces.number_of_vertices(), infinity);
    m_arrival.resize(m_faces.number_of_vertices());
    m_is_queued.assign(m_faces.number_of_vertices(), 0);
    m_number_of_windows = 0;
    prepare_queries(options);
    m_has_inner_source.clear();
  }

  Source classify(Indexed_location location) const
  {
    check(location);
    // a point nearer than this to an edge is on it: no coordinate of a mesh is known any better
    constexpr double snap = 1e-13;
    double sum = 0.;
    for(double& c : location.coordinates) {
      c = c < snap ? 0. : c;
      sum += c;
    }
    std::size_t zeros = 0;
    for(double& c : location.coordinates) {
      c /= sum;
      zeros += c == 0.;
    }
    Source source{location, null_index, null_index, 2. * geodesic_pi};
    const Index h = 3 * location.face;
    for(Index i = 0; i < 3; ++i)
      if(zeros == 2 && location.coordinates[i] != 0.) {
        source.vertex = m_faces.face(location.face).vertex[i];
        source.total_angle = m_faces.total_angle(source.vertex);
      } else if(zeros == 1 && location.coordinates[i] == 0.) {
        source.halfedge = Mesh::next(h + i);
        if(m_faces.opposite(source.halfedge) == null_index)
          source.total_angle = geodesic_pi;
      }
    return source;
  }

  void prepare_queries(const Exact_geodesic_options& options)
  {
    m_queries.clear();
    m_query_first.clear();
    m_query_index.clear();
    for(const Indexed_location& location : options.queries) {
      check(location);
      m_queries.push_back({location, infinity, Geodesic_arrival()});
    }
    if(options.all_centroids)
      for(Index f = 0; f < m_faces.number_of_faces(); ++f) {
        Indexed_location location;
        location.face = f;
        location.coordinates = {{1. / 3., 1. / 3., 1. / 3.}};
        m_queries.push_back({location, infinity, Geodesic_arrival()});
      }
    if(m_queries.empty())
      return;
    m_query_first.assign(m_faces.number_of_faces() + std::size_t(1), 0);
    for(const Query& query : m_queries)
      ++m_query_first[query.location.face + std::size_t(1)];
    for(std::size_t f = 0; f < m_faces.number_of_faces(); ++f)
      m_query_first[f + 1] += m_query_first[f];
    m_query_index.resize(m_queries.size());
    std::vector<Index> next(m_query_first.begin(), m_query_first.end() - 1);
    for(std::size_t i = 0; i < m_queries.size(); ++i)
      m_query_index[next[m_queries[i].location.face]++] = static_cast<Index>(i);
  }

  // -- sources -------------------------------------------------------------------------------------------------------

  template <int columns>
  void propagate()
  {
    for(std::size_t i = 0; i < m_sources.size(); ++i)
      if(m_sources[i].vertex != null_index)
        start_at_vertex<columns>(i);
      else
        start_in_face<columns>(i);
    Index item;
    while(m_queue.pop(item)) {
      prefetch(m_queue.peek(6), m_queue.peek(3));
      if(item < m_faces.number_of_halfedges())
        cross_face<columns>(item);
      else {
        m_is_queued[item - m_faces.number_of_halfedges()] = 0;
        bend<columns>(item - m_faces.number_of_halfedges());
      }
    }
    finish_queries();
    if(m_maximum_distance < infinity) {
      for(double& d : m_distance)
        d = d <= m_maximum_distance ? d : infinity;
      for(Query& query : m_queries)
        query.distance = query.distance <= m_maximum_distance ? query.distance : infinity;
    }
  }

  template <int columns>
  void start_at_vertex(std::size_t number)
  {
    const Index v = m_sources[number].vertex;
    if(m_distance[v] == 0.)
      return;
    m_distance[v] = 0.;
    m_arrival[v] = Geodesic_arrival();
    m_arrival[v].halfedge = m_faces.first_halfedge(v);
    m_arrival[v].source = static_cast<Index>(number);
    const Index first = m_faces.first_halfedge(v);
    double angle = 0.;
    Index h = first;
    do {
      emit<columns>(h, 0., m_faces.angle(h), 0., angle, static_cast<Index>(number));
      angle += m_faces.angle(h);
      h = m_faces.next_around_source(h);
    } while(h != null_index && h != first);
  }

  /// for sources on edges and in faces
  template <int columns>
  void start_in_face(std::size_t number)
  {
    const Source& source = m_sources[number];
    const Index f = source.location.face;
    if(source.halfedge == null_index) {
      start_in_face<columns>(number, 3 * f, m_faces.in_frame(3 * f, source.location.coordinates), 0., null_index);
      return;
    }
    const Index h = source.halfedge, o = m_faces.opposite(h);
    const double t = source.location.coordinates[Mesh::next(h) % 3] * m_faces.length(h);
    start_in_face<columns>(number, h, {t, 0.}, 0., h);
    if(o != null_index)
      start_in_face<columns>(number, o, {m_faces.length(h) - t, 0.}, geodesic_pi, o);
  }

  /// starts across all halfedges but `skipped` of the face of `h`, in whose frame the source is given
  template <int columns>
  void start_in_face(std::size_t number, Index h, const Plane_point& p, double turn, Index skipped)
  {
    Geodesic_arrival arrival;
    arrival.x = p.x;
    arrival.y = p.y;
    arrival.turn = turn;
    arrival.halfedge = h;
    arrival.source = static_cast<Index>(number);
    const std::array<Plane_point, 3> corner = {{{0., 0.}, {m_faces.length(h), 0.}, m_faces.apex(h)}};
    double rotation = 0.;
    Index g = h;
    for(std::size_t i = 0; i < 3; ++i) {
      const Plane_point &from = corner[i], &to = corner[(i + 1) % 3];
      reach(m_faces.source(g), std::hypot(from.x - p.x, from.y - p.y), arrival);
      const Index o = m_faces.opposite(g);
      if(g != skipped && o != null_index) {
        // the frame of the opposite halfedge starts at `to`
        const double length = m_faces.length(g);
        const double ux = (from.x - to.x) / length, uy = (from.y - to.y) / length;
        const double dx = p.x - to.x, dy = p.y - to.y;
        const double depth = dy * ux - dx * uy;
        Geodesic_window w{0., length, dx * ux + dy * uy, (std::min)(depth, 0.), 0., turn + rotation - geodesic_pi,
                          double(number)};
        if(m_sources.size() > 1)
          mark_inner_source(o);
        insert<columns>(o, w);
      }
      rotation += geodesic_pi - m_faces.angle(Mesh::next(g));
      g = Mesh::next(g);
    }
  }

  /// sends the paths through the corner at the source of `h` with angles in `[from, to]` into the next face
  template <int columns>
  void emit(Index h, double from, double to, double sigma, double turn, Index source)
  {
    const Geodesic_face& face = m_faces.face_of(h);
    const Index next = Mesh::next(h), v = m_faces.source(h);
    const Geodesic_face::Corner& here = face.corner[h % 3];
    const Geodesic_face::Corner& right = face.corner[next % 3];
    const Geodesic_face::Corner& left = face.corner[Mesh::previous(h) % 3];
    Geodesic_arrival arrival;
    arrival.sigma = sigma;
    arrival.turn = turn;
    arrival.halfedge = h;
    arrival.source = source;
    const bool starts_at_edge = from <= 0., ends_at_edge = to >= here.angle;
    if(starts_at_edge)
      reach(m_faces.target(h), m_distance[v] + here.length, arrival);
    if(ends_at_edge)
      reach(m_faces.source(Mesh::previous(h)), m_distance[v] + left.length, arrival);
    const Index o = m_faces.opposite(next);
    if(o == null_index)
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
    w.sigma = sigma;
    w.turn = sigma > 0. ? turn : turn - right.angle;
    w.nearest = source == null_index ? 0. : double(source);
    insert<columns>(o, w);
  }

  /// continues the shortest path to `v`, at which it may bend, into its shadow
  template <int columns>
  void bend(Index v)
  {
    const double sigma = m_distance[v];
    if(sigma == 0. || sigma > m_maximum_distance)
      return;
    const Geodesic_arrival_direction in = arrival_direction(v);
    const Index source = m_arrival[v].source;
    const double turn = columns > 5 ? direction_at_source(v) : 0.;
    // a shadow that is wider by the accuracy of the angle only adds a few paths that are not the shortest
    constexpr double margin = 1e-9;
    const bool is_border = m_faces.is_border(v);
    const double first = geodesic_pi - margin;
    const double last = is_border ? infinity : m_faces.total_angle(v) - geodesic_pi + margin;
    double angle = -in.angle;
    Index h = in.halfedge;
    do {
      const double width = m_faces.angle(h);
      if(angle + width > first && angle < last)
        emit<columns>(h, first - angle, (std::min)(last - angle, width), sigma, turn, source);
      angle += width;
      h = m_faces.next_around_source(h);
    } while(h != null_index && angle < last);
    if(!is_border)
      return;
    angle = m_faces.angle(in.halfedge) - in.angle;
    h = in.halfedge;
    while(h != null_index) {
      const double width = m_faces.angle(h);
      angle -= width;
      if(angle < -first)
        emit<columns>(h, 0., (std::min)(-first - angle, width), sigma, turn, source);
      h = m_faces.previous_around_source(h);
    }
  }

  // -- propagation ---------------------------------------------------------------------------------------------------

  void prefetch(Index far, Index near) const
  {
#if defined(__GNUC__)
    if(far < m_faces.number_of_halfedges()) {
      __builtin_prefetch(&m_lists[3 * std::size_t(far)]);
      const char* face = reinterpret_cast<const char*>(&m_faces.face_of(far));
      __builtin_prefetch(face);
      __builtin_prefetch(face + 64);
    }
    if(near < m_faces.number_of_halfedges()) {
      const std::size_t first = 3 * std::size_t(near);
      for(std::size_t k = first; k < first + 3; ++k)
        if(m_lists[k] != nullptr)
          for(std::size_t i = 0; i < 5; ++i)
            __builtin_prefetch(m_lists[k]->column(i));
      const Geodesic_face& face = m_faces.face_of(near);
      __builtin_prefetch(&m_distance[face.vertex[0]]);
      __builtin_prefetch(&m_distance[face.vertex[1]]);
      __builtin_prefetch(&m_distance[face.vertex[2]]);
    }
#else
    (void)far;
    (void)near;
#endif
  }

  /// takes the windows of `h` across the face of `h`
  template <int columns>
  void cross_face(Index h)
  {
    Geodesic_window_list* list = collect<columns>(h);
    if(list->empty()) {
      m_pool.release(list);
      return;
    }
    m_number_of_windows += list->size();
    const Geodesic_face& face = m_faces.face_of(h);
    const Index i = h % 3, j = Mesh::next(h) % 3, k = Mesh::previous(h) % 3;
    const Geodesic_face::Corner &corner_a = face.corner[i], &corner_b = face.corner[j];
    const double length = corner_a.length, length_left = face.corner[k].length, length_right = corner_b.length;
    const Plane_point apex{length_left * corner_a.cosine, length_left * corner_a.sine};

    if(!m_queries.empty())
      answer_queries<columns>(h, *list);

    // the first windows pass the apex on its left, the last ones on its right; those in between need a closer look
    const std::size_t begin = list->begin, end = list->end;
    const double tolerance = geodesic_cover * length;
    const double *a = list->column(0), *b = list->column(1), *x = list->column(2), *y = list->column(3);
    std::size_t first = begin, last = end;
    while(first < last && side_of_rays(a[first], b[first], x[first], y[first], apex, tolerance) == passes_left)
      ++first;
    while(first < last &&
          side_of_rays(a[last - 1], b[last - 1], x[last - 1], y[last - 1], apex, tolerance) == passes_right)
      --last;
    if(last - first > m_sides.size())
      m_sides.resize(2 * (last - first));
    std::size_t winner = end, first_right = last, behind_left = first;
    double shortest = infinity;
    for(std::size_t w = first; w < last; ++w) {
      const Geodesic_side side = side_of_rays(a[w], b[w], x[w], y[w], apex, tolerance);
      m_sides[w - first] = static_cast<unsigned char>(side);
      if(side == covers) {
        const double dx = apex.x - x[w], dy = apex.y - y[w];
        const double d = list->column(4)[w] + std::sqrt(dx * dx + dy * dy);
        if(d < shortest) {
          shortest = d;
          winner = w;
        }
      } else if(side == passes_left)
        behind_left = w + 1;
      else if(first_right == last)
        first_right = w;
    }
    const Index vertex_a = face.vertex[i], vertex_b = face.vertex[j], vertex_c = face.vertex[k];
    if(winner != end && shortest < m_distance[vertex_c]) {
      const Geodesic_window w = list->get<columns>(winner);
      Geodesic_arrival arrival{w.x, w.y, w.sigma, w.turn, h, static_cast<Index>(w.nearest), true};
      reach(vertex_c, shortest, arrival);
    }
    const double distance_a = m_distance[vertex_a], distance_b = m_distance[vertex_b];
    const double distance_c =
        (std::min)(m_distance[vertex_c], (std::min)(distance_a + length_left, distance_b + length_right));

    // the windows that cover the apex go to their side of the winner only
    const bool is_sorted = first == last || (behind_left <= winner && winner < first_right);
    std::size_t number_left, number_right;
    if(first == last) {
      number_left = first - begin;
      number_right = end - last;
    } else if(is_sorted) {
      number_left = winner + 1 - begin;
      number_right = end - winner;
    } else {
      number_left = first - begin;
      number_right = end - last;
      for(std::size_t w = first; w < last; ++w) {
        number_left += goes_left(w, first, winner);
        number_right += goes_right(w, first, winner);
      }
    }
    if(face.opposite[k] != null_index && number_left > 0) {
      Geodesic_window_list* out = m_pool.allocate(number_left);
      const Geodesic_step step{length, length_left, corner_a.cosine, corner_a.sine, corner_a.angle};
      if(is_sorted)
        step_left<columns>(*list, begin, number_left, *out, step);
      else {
        step_left<columns>(*list, begin, first - begin, *out, step);
        for(std::size_t w = first; w < last; ++w)
          if(goes_left(w, first, winner))
            step_left<columns>(*list, w, 1, *out, step);
      }
      restore_order<columns>(*out, length_left);
      const Plane_point b_in_frame{length * corner_a.cosine, -length * corner_a.sine};
      filter_begin(*out, distance_a);
      filter_end(*out, distance_c, length_left, distance_b, b_in_frame);
      store<columns>(face.opposite[k], 0, out, length_left, (std::min)(distance_a, distance_c));
    }
    if(face.opposite[j] != null_index && number_right > 0) {
      Geodesic_window_list* out = m_pool.allocate(number_right);
      const Geodesic_step step{length, length_right, corner_b.cosine, corner_b.sine, -corner_b.angle};
      if(is_sorted)
        step_right<columns>(*list, end - number_right, number_right, *out, step);
      else {
        for(std::size_t w = first; w < last; ++w)
          if(goes_right(w, first, winner))
            step_right<columns>(*list, w, 1, *out, step);
        step_right<columns>(*list, last, end - last, *out, step);
      }
      restore_order<columns>(*out, length_right);
      const Plane_point a_in_frame{length_right - length * corner_b.cosine, -length * corner_b.sine};
      filter_begin(*out, distance_c, distance_a, a_in_frame);
      filter_end(*out, distance_b, length_right);
      store<columns>(face.opposite[j], 2, out, length_right, (std::min)(distance_b, distance_c));
    }
    m_pool.release(list);
  }

  /// the windows of `h` from all three sides, in one list in order
  template <int columns>
  Geodesic_window_list* collect(Index h)
  {
    Geodesic_window_list** lists = &m_lists[3 * std::size_t(h)];
    std::size_t size = 0, number = 0, present = 0;
    for(std::size_t k = 0; k < 3; ++k)
      if(lists[k] != nullptr) {
        size += lists[k]->size();
        ++number;
        present = k;
      }
    Geodesic_window_list* all = lists[present];
    if(number > 1) {
      const double length = m_faces.length(h);
      const bool apart = !m_has_inner_source.empty() && m_has_inner_source[h] && lists[1] != nullptr;
      all = m_pool.allocate(size);
      for(std::size_t k = 0; k < 3; ++k)
        if(lists[k] != nullptr && !(apart && k == 1)) {
          const std::size_t junction = all->end;
          all->append<columns>(*lists[k]);
          m_pool.release(lists[k]);
          if(junction > 0)
            Geodesic_trimming<columns>(*all, length, false)(junction, true);
        }
      if(apart) {
        // the windows of a source inside of the face are not in order with those that enter it
        Geodesic_window_list* envelope = m_pool.allocate(4 * size);
        Geodesic_envelope<columns>()(*lists[1], *all, *envelope, length);
        m_pool.release(lists[1]);
        m_pool.release(all);
        all = envelope;
      }
    }
    lists[0] = lists[1] = lists[2] = nullptr;
    return all;
  }

  bool goes_left(std::size_t w, std::size_t first, std::size_t winner) const
  {
    const unsigned char side = m_sides[w - first];
    return side == passes_left || (side == covers && w <= winner);
  }

  bool goes_right(std::size_t w, std::size_t first, std::size_t winner) const
  {
    const unsigned char side = m_sides[w - first];
    return side == passes_right || (side == covers && w >= winner);
  }

  // Windows at the ends of a list are removed if a path through a vertex is shorter: one along the halfedge from its
  // source or target, or one from the vertex `v` behind the halfedge, past which all windows go on the same side.

  /// whether a path of length `d` to the point `t` is shorter than the one from the image of the window
  static bool is_shorter(double d, const Geodesic_window_list& list, std::size_t i, double t)
  {
    const double dx = t - list.column(2)[i], y = list.column(3)[i], rest = d - list.column(4)[i];
    return rest < 0. || rest * rest < dx * dx + y * y;
  }

  static double distance(const Plane_point& v, double t)
  {
    return std::sqrt((v.x - t) * (v.x - t) + v.y * v.y);
  }

  static void filter_begin(Geodesic_window_list& list, double distance_source)
  {
    for(; !list.empty(); ++list.begin) {
      const double t = list.column(1)[list.begin];
      if(!is_shorter(distance_source + t, list, list.begin, t))
        return;
    }
  }

  static void filter_begin(Geodesic_window_list& list, double distance_source, double distance_v, const Plane_point& v)
  {
    for(; !list.empty(); ++list.begin) {
      const double t = list.column(1)[list.begin];
      if(!is_shorter((std::min)(distance_source + t, distance_v + distance(v, t)), list, list.begin, t))
        return;
    }
  }

  static void filter_end(Geodesic_window_list& list, double distance_target, double length)
  {
    for(; !list.empty(); --list.end) {
      const double t = list.column(0)[list.end - 1];
      if(!is_shorter(distance_target + length - t, list, list.end - 1, t))
        return;
    }
  }

  static void filter_end(Geodesic_window_list& list, double distance_target, double length, double distance_v,
                         const Plane_point& v)
  {
    for(; !list.empty(); --list.end) {
      const double t = list.column(0)[list.end - 1];
      if(!is_shorter((std::min)(distance_target + length - t, distance_v + distance(v, t)), list, list.end - 1, t))
        return;
    }
  }

  /// removes what is further away than asked for
  template <int columns>
  void filter_distance(Geodesic_window_list& list) const
  {
    std::uint32_t to = list.begin;
    for(std::uint32_t i = list.begin; i < list.end; ++i) {
      const Geodesic_window w = list.get<columns>(i);
      if(w.distance((std::min)((std::max)(w.x, w.a), w.b)) <= m_maximum_distance)
        list.move<columns>(i, to++);
    }
    list.end = to;
  }

  template <int columns>
  void insert(Index h, const Geodesic_window& w)
  {
    Geodesic_window_list* list = m_pool.allocate(1);
    list->append<columns>(w);
    store<columns>(h, 1, list, m_faces.length(h), (std::min)(w.distance(w.a), w.distance(w.b)));
  }

  /// hands a list, which came from the given side, to the halfedge it has reached
  template <int columns>
  void store(Index h, std::size_t side, Geodesic_window_list* list, double length, double key)
  {
    if(m_maximum_distance < infinity)
      filter_distance<columns>(*list);
    if(list->empty()) {
      m_pool.release(list);
      return;
    }
    Geodesic_window_list** lists = &m_lists[3 * std::size_t(h)];
    if(lists[0] == nullptr && lists[1] == nullptr && lists[2] == nullptr) {
      if(key == infinity) {
        const Geodesic_window w = list->get<columns>(list->begin);
        key = w.distance(w.a);
      }
      m_queue.push(key, h);
    }
    if(lists[side] == nullptr)
      lists[side] = list;
    else {
      // a second batch from the same side
      Geodesic_window_list* envelope = m_pool.allocate(4 * std::size_t(list->size() + lists[side]->size()));
      Geodesic_envelope<columns>()(*lists[side], *list, *envelope, length);
      m_pool.release(list);
      m_pool.release(lists[side]);
      lists[side] = envelope;
    }
  }

  /// a path of length `d` to the vertex `v` has been found
  void reach(Index v, double d, const Geodesic_arrival& arrival)
  {
    // a smaller gain is rounding, and may be one forever
    if(!(d < m_distance[v] * (1. - 1e-14)) && !(m_distance[v] == infinity))
      return;
    m_distance[v] = d;
    m_arrival[v] = arrival;
    if(m_faces.is_pseudo_source(v) && !m_is_queued[v]) {
      m_is_queued[v] = 1;
      m_queue.push(d, m_faces.number_of_halfedges() + v);
    }
  }

  void mark_inner_source(Index h)
  {
    if(m_has_inner_source.empty())
      m_has_inner_source.assign(m_faces.number_of_halfedges(), 0);
    m_has_inner_source[h] = 1;
  }

  // -- queries -------------------------------------------------------------------------------------------------------

  template <int columns>
  void answer_queries(Index h, const Geodesic_window_list& list)
  {
    const double tolerance = geodesic_cover * m_faces.length(h);
    const double *a = list.column(0), *b = list.column(1), *x = list.column(2), *y = list.column(3);
    for(Index q = m_query_first[h / 3]; q < m_query_first[h / 3 + std::size_t(1)]; ++q) {
      Query& query = m_queries[m_query_index[q]];
      const Plane_point p = m_faces.in_frame(h, query.location.coordinates);
      for(std::size_t i = list.begin; i < list.end; ++i) {
        if(side_of_rays(a[i], b[i], x[i], y[i], p, tolerance) != covers)
          continue;
        const double d = list.column(4)[i] + std::sqrt((p.x - x[i]) * (p.x - x[i]) + (p.y - y[i]) * (p.y - y[i]));
        if(d < query.distance) {
          const Geodesic_window w = list.get<columns>(i);
          query.distance = d;
          query.arrival = Geodesic_arrival{w.x, w.y, w.sigma, w.turn, h, static_cast<Index>(w.nearest), true};
        }
      }
    }
  }

  /// considers the paths to query locations that come from a vertex of the face, or a source in it
  void finish_queries()
  {
    for(Query& query : m_queries) {
      const Index f = query.location.face;
      for(Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index v = m_faces.source(h);
        const Plane_point p = m_faces.in_frame(h, query.location.coordinates);
        const double d = m_distance[v] + std::sqrt(p.x * p.x + p.y * p.y);
        if(!(d < query.distance))
          continue;
        query.distance = d;
        query.arrival = Geodesic_arrival();
        query.arrival.halfedge = h;
        query.arrival.source = m_arrival[v].source;
        query.arrival.sigma = m_distance[v];
        if(m_distance[v] == 0.)
          query.arrival.turn = m_faces.angle_around_source(h);
        else if(m_columns > 5)
          query.arrival.turn = direction_at_source(v);
      }
    }
    for(std::size_t i = 0; i < m_sources.size() && !m_queries.empty(); ++i) {
      const Source& source = m_sources[i];
      if(source.vertex != null_index)
        continue;
      if(source.halfedge == null_index) {
        const Index h = 3 * source.location.face;
        finish_queries(i, h, m_faces.in_frame(h, source.location.coordinates), 0.);
        continue;
      }
      const Index h = source.halfedge, o = m_faces.opposite(h);
      const double t = source.location.coordinates[Mesh::next(h) % 3] * m_faces.length(h);
      finish_queries(i, h, {t, 0.}, 0.);
      if(o != null_index)
        finish_queries(i, o, {m_faces.length(h) - t, 0.}, geodesic_pi);
    }
  }

  void finish_queries(std::size_t number, Index h, const Plane_point& source, double turn)
  {
    for(Index q = m_query_first[h / 3]; q < m_query_first[h / 3 + std::size_t(1)]; ++q) {
      Query& query = m_queries[m_query_index[q]];
      const Plane_point p = m_faces.in_frame(h, query.location.coordinates);
      const double d = std::hypot(p.x - source.x, p.y - source.y);
      if(d < query.distance) {
        query.distance = d;
        query.arrival = Geodesic_arrival{source.x, source.y, 0., turn, h, static_cast<Index>(number), false};
      }
    }
  }

  // -- directions ----------------------------------------------------------------------------------------------------

  double direction_at_source(const Geodesic_arrival& arrival, const Plane_point& end) const
  {
    if(arrival.sigma > 0.)
      return arrival.turn;
    const Source& source = m_sources[arrival.source];
    const double angle = arrival.turn + std::atan2(end.y - arrival.y, end.x - arrival.x);
    // rounding may lead out of the range; at a source on the border that is no full turn
    const bool is_border = source.vertex != null_index ? m_faces.is_border(source.vertex)
                                                       : source.total_angle < 1.5 * geodesic_pi;
    if(is_border)
      return (std::min)((std::max)(angle, 0.), source.total_angle);
    if(angle < 0.)
      return angle + source.total_angle;
    return angle >= source.total_angle ? angle - source.total_angle : angle;
  }

  Geodesic_faces m_faces;
  Geodesic_bucket_queue m_queue;
  Geodesic_window_pool m_pool;
  std::vector<Geodesic_window_list*> m_lists; // of each halfedge: from the left, from the vertex behind, from the right
  std::vector<unsigned char> m_sides, m_is_queued, m_has_inner_source;
  std::vector<double> m_distance;
  std::vector<Geodesic_arrival> m_arrival;
  std::vector<Source> m_sources;
  std::vector<Query> m_queries;
  std::vector<Index> m_query_first, m_query_index; // the queries of each face
  double m_maximum_distance = infinity;
  std::size_t m_number_of_windows = 0;
  int m_columns = 5;
  bool m_clean = true;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_EXACT_GEODESIC_PROPAGATION_H
