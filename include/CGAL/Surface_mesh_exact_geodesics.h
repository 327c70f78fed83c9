// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_SURFACE_MESH_EXACT_GEODESICS_H
#define CGAL_SURFACE_MESH_EXACT_GEODESICS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/Mesh_of_fans.h>
#include <CGAL/Cut_loci/face_graph/reading/read_curves.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_fronts.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_point_search.h>
#include <CGAL/Cut_loci/geodesics/Geodesic_queries.h>
#include <CGAL/Cut_loci/geodesics/Isoline_tracing.h>
#include <CGAL/Cut_loci/geodesics/Straight_walk.h>
#include <CGAL/Cut_loci/geodesics/geodesic_path_tracing.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * computes exact geodesic distances, directions, and shortest paths on a triangle mesh.
 *
 * "Exact" is meant as in \ref PkgSurfaceMeshShortestPath "Triangulated Surface Mesh Shortest Paths": the algorithm
 * finds the shortest path on the polyhedral surface, not an approximation of it, up to the rounding of `double`, in
 * which all numbers are computed. The surface may have any genus and any number of borders and components.
 *
 * The mesh is read by the constructor; it must not change, and must stay alive, as long as the object is used. Sources
 * are vertices, face locations, or curves along edges, such as the border. `compute()` then finds the distances to all
 * vertices and to the query locations; those of other points are found when they are asked for. All other functions with
 * results are `const` and can be called from several threads at once. An object is meant to be used for many sources: it
 * keeps the geometry of the mesh and all its memory.
 *
 * The algorithm propagates the windows of Mitchell, Mount and Papadimitriou \cgalCite{mmp-dgp-87} across the faces,
 * with the rule "one angle, one split" of Chen and Han \cgalCite{ch-spp-90}, the filter of Xin and Wang
 * \cgalCite{Xin2009Improvingchenandhan}, and, as Xu et al. \cgalCite{xu-fwp-15} and Qin et al. \cgalCite{qin-vtp-16}, in batches: all
 * windows of a halfedge cross its face at once.
 *
 * In the worst case, time grows like \cgalBigO{n^2} and more with the number of faces. On the meshes of smooth surfaces
 * that were measured, the number of windows grows like \cgalBigO{n^{1.5}}; for time and memory see the tables in
 * Section \ref Surface_mesh_cut_locus_performance.
 *
 * Where distances need not be exact, `set_maximum_relative_error()` bounds their error and makes the growth nearly linear.
 *
 * Faces must have an area: a face whose height is less than about `1e-13` of its longest edge cannot be unfolded in
 * `double`, and is refused: the constructor throws `Cut_loci::Invalid_input` with a message that names it. Where the faces at
 * a vertex form several fans, no path leads from one to the other; the vertex has the distance of the nearest.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 *
 * \sa `CGAL::exact_geodesic_distances()`
 * \sa `CGAL::Surface_mesh_shortest_path`
 */
template <typename TriangleMesh>
class Surface_mesh_exact_geodesics
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  /// \name Types
  /// @{

  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// the number type of all results
  using FT = double;

  /// a point on the mesh: a face `f` and barycentric coordinates with respect to `source(halfedge(f, tm), tm)` and the
  /// two vertices that follow counterclockwise, as in `Polygon_mesh_processing`
  using Face_location = std::pair<face_descriptor, std::array<FT, 3>>;

  /// a direction at a vertex: a halfedge that leaves it, and the angle from that halfedge, counterclockwise within
  /// its face
  using Direction = std::pair<halfedge_descriptor, FT>;

  /// a point that has been named before the run, see `add_query()`
  struct Query
  {
    std::size_t number;
  };

  /// what is asked for: a vertex, a point that has been named before the run, or any other point of the surface
  ///
  /// For the last ones, functions look for the shortest path by the distances of the vertices: see Section
  /// \ref Surface_mesh_cut_locus_points for the time. For thousands of points, queries are faster. Where a location is no point
  /// of the surface, or there is no such query, `Cut_loci::Invalid_input` is thrown.
  using Place = std::variant<vertex_descriptor, Face_location, Query>;

  /// a point in the plane, by two coordinates
  using Plane_coordinates = std::array<FT, 2>;

  /// @}

  /*!
   * reads the mesh.
   *
   * @param tm a triangle mesh
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value
   *                    type}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
   *     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t` must be
   *                     available in `TriangleMesh`.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_length_map}
   *     \cgalParamDescription{the lengths of the edges, which are the metric then: an intrinsic triangulation, or a metric
   *                           without an embedding. The points are for output only.}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a number as value type}
   *     \cgalParamDefault{the distances between the points}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_is_excluded_map}
   *     \cgalParamDescription{the faces that no path may cross. What is left is the surface: the rim of an excluded region
   *                           becomes border, and two regions that touch at a vertex leave no way between them.}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `bool` as value type}
   *     \cgalParamDefault{no face is excluded}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Cut_loci::Invalid_input if `tm` has no faces, all are excluded, a face is no triangle, a coordinate is not finite,
   *         or lengths are those of no triangle
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Surface_mesh_exact_geodesics(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
    : mesh_(tm, np), geodesics_(mesh_.read().mesh, &mesh_.read().positions)
  {
    mesh_.forget_mesh();
  }

  Surface_mesh_exact_geodesics(const Surface_mesh_exact_geodesics&) = delete;
  Surface_mesh_exact_geodesics& operator=(const Surface_mesh_exact_geodesics&) = delete;

  /// \name Sources
  /// With several sources, the distance is the one to the nearest. They are numbered in the order in which they are added,
  /// curves behind the points.
  /// @{

  /// adds a vertex
  /// \throws Cut_loci::Invalid_input if `v` is null, on no face, on excluded faces alone, or if its faces form several fans
  void add_source(vertex_descriptor v) { sources_.push_back(geodesics_.vertex_location(mesh_.source(v))); }

  /// adds a point in a face, on an edge, or at a vertex
  /// \throws Cut_loci::Invalid_input if the face is null or excluded, or the coordinates are not barycentric
  void add_source(const Face_location& location) { sources_.push_back(to_indexed(location)); }

  /// adds a connected curve along edges of the mesh, all of whose points are sources
  ///
  /// No shortest path crosses it, so that paths come from its two sides. There are no directions at a curve, nor is an
  /// error allowed: `compute()` throws then. Curves through the faces become edges by `refine_along_polylines()`. It takes
  /// linear time.
  /// @tparam EdgeRange a model of `ConstRange` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as value type
  /// \throws Cut_loci::Invalid_input if there are no edges, they are not connected, or one is on no face
  template <typename EdgeRange>
  void add_source_curve(const EdgeRange& edges)
  {
    curves_.push_back(
      Cut_loci::internal::read_curve(mesh_.tm(), mesh_.read(), geodesics_.faces().mesh(), edges, curves_.size()));
  }

  /// adds each loop of the border as a curve, in the order of their first vertices
  /// \throws Cut_loci::Invalid_input if there is no border
  void add_source_border()
  {
    for(Cut_loci::Indexed_curve& loop : Cut_loci::internal::border_curves(geodesics_.faces().mesh()))
      curves_.push_back(std::move(loop));
  }

  /// removes all sources
  void clear_sources()
  {
    sources_.clear();
    curves_.clear();
  }

  /// the number of sources
  std::size_t number_of_sources() const { return sources_.size() + curves_.size(); }

  /// @}

  /// \name Options
  /// They hold for all following calls of `compute()`.
  /// @{

  /// stops the propagation at this distance; what is further away is not reached. Infinite by default.
  /// \throws Cut_loci::Invalid_input if `distance` is negative or not a number
  void set_maximum_distance(FT distance)
  {
    if(!(distance >= 0.))
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER, "the maximum distance must not be negative");
    options_.maximum_distance = distance / mesh_.unit();
  }

  /// allows distances to be too long, by this times their length; zero by default.
  ///
  /// Neighboring windows are then merged, so that a halfedge seldom has more than a few of them, and time and memory
  /// grow about linearly with the number of faces. No distance is shorter than the exact one, nor longer than
  /// `1 + error` times it, both up to rounding; `distance_error()` says how accurate each is. There are no directions
  /// and no paths: functions that need them throw. More than a tenth is taken for a tenth, as it would save nothing.
  /// \throws Cut_loci::Invalid_input if `error` is negative or not a number
  void set_maximum_relative_error(FT error)
  {
    if(!(error >= 0.))
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "the maximum relative error must not be negative");
    options_.maximum_relative_error = (std::min)(error, FT(0.1));
  }

  /// asks for the directions at the source, at the price of some 10 % more time. Off by default.
  void set_directions(bool wanted) { options_.directions = wanted; }

  /// asks for isolines: all windows are kept, 48 bytes for each. Off by default.
  void set_isolines(bool wanted) { options_.windows = wanted ? &windows_ : nullptr; }

  /// adds a point to which the distance is wanted
  Query add_query(const Face_location& location)
  {
    options_.queries.push_back(to_indexed(location));
    return {options_.queries.size() - 1};
  }

  /// removes all points added by `add_query()`
  void clear_queries() { options_.queries.clear(); }

  /// @}

  /// computes everything that has been asked for
  /// \throws Cut_loci::Invalid_input if there is no source, or if two of these exclude each other: an error goes with
  ///         neither directions, isolines nor sources that are curves, and curves not with directions
  void compute()
  {
    const bool is_exact = options_.maximum_relative_error == 0.;
    is_computed_ = false;
    if(!is_exact && (options_.directions || options_.windows != nullptr))
      throw Cut_loci::Invalid_input(
        Cut_loci::Cause::PARAMETER_OF_OTHER_METHOD,
        "directions and isolines need exact distances: the maximum relative error must be zero");
    if(!curves_.empty() && (options_.directions || !is_exact))
      throw Cut_loci::Invalid_input(
        Cut_loci::Cause::PARAMETER_OF_OTHER_METHOD,
        "sources that are curves have no directions, and need exact distances: leave out the "
        "curves, or both the directions and the maximum relative error");
    number_of_points_ = sources_.size();
    has_directions_ = options_.directions;
    has_isolines_ = options_.windows != nullptr;
    windows_.clear();
    with_curves_.reset();
    maximum_distance_ = options_.maximum_distance * mesh_.unit();
    if(curves_.empty())
      geodesics_.run(sources_, options_);
    else
      compute_from_curves();
    is_computed_ = true;
  }

  /// the same with `source`, a vertex or a face location, as the only source
  template <typename Source>
  void compute(const Source& source)
  {
    clear_sources();
    add_source(source);
    compute();
  }

  /// \name Distances
  /// They are infinite for what has not been reached. Before the first call of `compute()` these functions, and all that
  /// follow, throw `Cut_loci::Invalid_input`, and so does what has been asked for after the last one.
  /// @{

  /// the distance to the nearest source
  FT distance(const Place& place) const { return mesh_.unit() * at(place).distance; }

  /// how much longer than the exact distance `distance(v)` may be; zero if no error has been allowed
  FT distance_error(vertex_descriptor v) const
  {
    const Cut_loci::Index i = index(v);
    return i == Cut_loci::null_index ? 0. : mesh_.unit() * computed().distance_error(i);
  }

  /// writes the distances of all vertices
  /// @tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key type and a value type
  ///         to which `double` can be converted
  template <typename VertexDistanceMap>
  void distances(VertexDistanceMap vdm) const
  {
    for(vertex_descriptor v : CGAL::make_range(vertices(mesh_.tm())))
      put(vdm, v, distance(v));
  }

  /// @}

  /// \name Sources and Directions
  /// @{

  /// the number of the nearest source, in the order in which sources were added
  /// \pre the place is reached
  std::size_t nearest_source(const Place& place) const { return computed().nearest_source(at(place)); }

  /// the direction at its source in which the shortest path starts
  ///
  /// It is an angle in the tangent plane of the source, unrolled without scaling: counterclockwise, in
  /// `[0, source_angle())`, up to and including `source_angle()` for a source on the border. Zero is
  /// `source_halfedge()`.
  /// \pre directions have been asked for, the place is reached and not a source
  FT direction_at_source(const Place& place) const { return with_directions().direction_at_source(at(place)); }

  /// the sum of the angles around source number `i`; \f$2\pi\f$ in faces
  /// \throws Cut_loci::Invalid_input if there is no such source, or it is a curve
  FT source_angle(std::size_t i = 0) const { return computed().source_angle(point_source(i)); }

  /// the halfedge along which the direction at source number `i` is zero
  ///
  /// For a vertex on the border, it is the first of its fan, which has the border on its right; for another vertex, the
  /// first one that leaves it in the order of `faces(tm)`; on an edge, the halfedge of the edge in the face of the
  /// location; and in a face `f`, `halfedge(f, tm)`.
  /// \throws Cut_loci::Invalid_input if there is no such source, or it is a curve
  halfedge_descriptor source_halfedge(std::size_t i = 0) const
  {
    return mesh_.read().halfedges[computed().source_halfedge(point_source(i))];
  }

  /// the direction at `v` in which the shortest path to it leads back to its source
  /// \pre `v` is reached and not a source
  Direction arrival_direction(vertex_descriptor v) const
  {
    require_exact();
    const Cut_loci::internal::Geodesic_direction direction = computed().arrival_direction(index(v));
    return Direction(mesh_.read().halfedges[direction.halfedge], direction.angle);
  }

  /// @}

  /// \name Logarithmic and Exponential Map
  /// The logarithmic map takes a point into the tangent plane of its nearest source, to where the shortest path would end
  /// if it went straight on in the direction in which it starts. It is exact on the polyhedron, as distances and
  /// directions are.
  ///
  /// The origin is the source, the x-axis runs along `source_halfedge()`, and y is to its left. Around a source that is
  /// not on the border, angles are those of `direction_at_source()`, scaled to add up to \f$2\pi\f$; on the border they
  /// are not scaled. A source has the coordinates zero. What is not reached has an infinite distance, and an angle and
  /// Cartesian coordinates that are NaN. Its functions throw `Cut_loci::Invalid_input` if
  /// directions have not been asked for.
  ///
  /// If paths bend at a vertex, what is behind it is on one ray. Else the map is injective for one source, but for one on
  /// the border with a `source_angle()` of more than \f$2\pi\f$, which only polar coordinates tell apart.
  /// @{

  /// the Cartesian coordinates, in the unit of the points
  Plane_coordinates logarithmic_map(const Place& place) const
  {
    const Plane_coordinates polar = polar_coordinates(place);
    return {{polar[0] * std::cos(polar[1]), polar[0] * std::sin(polar[1])}};
  }

  /// the distance, and the angle from the x-axis, in radians: from 0 to \f$2\pi\f$, or on the border to `source_angle()`
  Plane_coordinates polar_coordinates(const Place& place) const
  {
    const Cut_loci::internal::Exact_geodesic_propagation& geodesics = with_directions();
    const Cut_loci::internal::Geodesic_query query = at(place);
    const FT d = mesh_.unit() * query.distance;
    if(d > 0. && d < infinity())
      return {{d, geodesics.direction_at_source(query) * geodesics.angle_scale(geodesics.nearest_source(query))}};
    return {{d, d == 0. ? 0. : (std::numeric_limits<FT>::quiet_NaN)()}};
  }

  /// the point at which a straight walk from source number `i` ends, whose direction and length are those of `place` in
  /// the tangent plane of the source
  ///
  /// It is the inverse of the logarithmic map where shortest paths do not bend, and goes on behind the cut locus. The
  /// walk ends at the border, also if it would start behind it, and at sources that are curves. If it meets a vertex, it
  /// goes on as if it had passed on one side. It takes time linear in the number of faces that it crosses. Directions need
  /// not have been asked for.
  /// \throws Cut_loci::Invalid_input if there is no such source, it is a curve, or `place` is not finite, or farther than a
  ///         thousand times the length of all edges together
  Face_location exponential_map(const Plane_coordinates& place, std::size_t i = 0) const
  {
    const FT length = std::hypot(place[0], place[1]), angle = std::atan2(place[1], place[0]);
    point_source(i);
    if(!std::isfinite(length))
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "a place in the tangent plane is not finite: what is not reached has none");
    const Cut_loci::internal::Geodesic_faces& faces = geodesics_.faces();
    if(length / mesh_.unit() > longest_walk * faces.mean_edge_length() * double(faces.number_of_halfedges()))
      throw Cut_loci::Invalid_input(
        Cut_loci::Cause::INVALID_PARAMETER,
        "a place in the tangent plane is farther than a straight walk is followed: a thousand "
        "times the length of all edges");
    return mesh_.face_location(Cut_loci::internal::end_of_straight_walk(
      computed(), static_cast<Cut_loci::Index>(i), angle < 0. ? angle + 2. * Cut_loci::internal::geodesic_pi : angle,
      length / mesh_.unit()));
  }

  /// @}

  /// \name Shortest Paths
  /// A path is a sequence of face locations: its end, the points where it crosses edges or meets vertices, and its
  /// source. No two consecutive ones are the same point. There are none if the end is not reached. All functions throw
  /// `Cut_loci::Invalid_input` if the last call of `compute()` has been allowed an error.
  /// @{

  /// writes the shortest path to the source
  /// @tparam OutputIterator a model of `OutputIterator` that holds `Face_location`
  template <typename OutputIterator>
  OutputIterator shortest_path(const Place& place, OutputIterator out) const
  {
    require_exact();
    return write(Cut_loci::internal::Geodesic_path_tracing(computed()).path_from_query(at(place)), out);
  }

  /// @}

  /// \name Isolines
  /// @{

  /// a curve of points at the same distance
  struct Isoline
  {
    FT level;                             ///< the distance
    std::vector<Face_location> locations; ///< of a polyline; what is nearer to the sources is on its left
    bool is_closed;                       ///< whether it ends where it begins; else it leads from border to border
  };

  /*!
   * writes the isolines of some distances.
   *
   * In each face, an isoline consists of arcs of circles, around the images of the sources and of the vertices at which
   * paths bend; from curves, of segments as well. The vertices of the polylines have the distance of their level exactly,
   * up to rounding, and between them they are chords. The isolines of a level bound what is nearer: each is closed, or
   * leads from border to border, and two meet nowhere but at a vertex that has the level up to rounding. Where the level
   * is exactly that of a vertex, the vertex is not nearer.
   *
   * For each level, time is linear in the number of faces, and at worst cubic in the number of windows of a face that the
   * isoline crosses.
   *
   * @tparam LevelRange a model of `ConstRange` of numbers
   * @tparam OutputIterator a model of `OutputIterator` that holds `Isoline`
   *
   * @param levels the distances, in the unit of the points
   * @param out where the isolines are written, level by level
   * @param maximum_deviation how far chords may be from their arcs, in the unit of the points; by default a thousandth of
   *        the mean edge length: in pictures that show the edges, no corner is seen
   *
   * \pre isolines have been asked for
   * \throws Cut_loci::Invalid_input if they have not, if a level is not positive and finite, or above the maximum distance,
   *         or if the deviation is not positive
   */
  template <typename LevelRange, typename OutputIterator>
  OutputIterator isolines(const LevelRange& levels, OutputIterator out,
                          std::optional<FT> maximum_deviation = std::nullopt) const
  {
    const Cut_loci::internal::Exact_geodesic_propagation& geodesics = computed();
    const FT deviation =
      maximum_deviation.value_or(default_deviation * geodesics.faces().mean_edge_length() * mesh_.unit());
    require_isolines(deviation);
    for(const auto& level : levels)
      require_level(FT(level));
    Cut_loci::internal::Isoline_tracing tracing(geodesics, windows_);
    for(const auto& level : levels)
      for(const Cut_loci::internal::Indexed_isoline& line : tracing(FT(level) / mesh_.unit(), deviation / mesh_.unit()))
      {
        Isoline isoline{FT(level), {}, line.is_closed};
        write(line.locations, std::back_inserter(isoline.locations));
        *out++ = std::move(isoline);
      }
    return out;
  }

  /// @}

  /// the number of windows that the last call of `compute()` has taken across a face
  std::size_t number_of_windows() const { return computed().number_of_windows(); }

private:
  static constexpr FT infinity() { return (std::numeric_limits<FT>::infinity)(); }

  const Cut_loci::internal::Exact_geodesic_propagation& computed() const
  {
    if(!is_computed_)
      throw Cut_loci::Invalid_input(Cut_loci::Cause::NO_SOURCE, "nothing has been computed: compute() comes before");
    return with_curves_ ? *with_curves_ : geodesics_;
  }

  // on a mesh of its own, which is cut open along the curves
  void compute_from_curves()
  {
    Cut_loci::internal::Run_from_curves run =
      Cut_loci::internal::run_from_curves(geodesics_.faces().mesh(), sources_, curves_, options_);
    with_curves_ = std::move(run.geodesics);
    with_curves_->run(run.sources, run.options);
  }

  // the number of a source that is a point
  std::size_t point_source(std::size_t i) const
  {
    computed();
    if(i < number_of_points_)
      return i;
    throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_SOURCE, "there is no source " + std::to_string(i) +
                                                                     " that is a point: the last call of "
                                                                     "compute() had " +
                                                                     std::to_string(number_of_points_) +
                                                                     " of them, and curves have no tangent plane");
  }

  Cut_loci::internal::Geodesic_query at(const Place& place) const
  {
    return std::visit([this](const auto& p) { return this->at(p); }, place);
  }

  Cut_loci::internal::Geodesic_query at(vertex_descriptor v) const
  {
    const Cut_loci::Index i = index(v);
    return i == Cut_loci::null_index ? Cut_loci::internal::Geodesic_query{{}, infinity(), {}} : computed().at_vertex(i);
  }

  Cut_loci::internal::Geodesic_query at(const Query& query) const
  {
    if(query.number >= computed().number_of_queries())
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "query location " + std::to_string(query.number) +
                                      " has not been computed: add_query() comes before compute()");
    return computed().answer(query.number);
  }

  Cut_loci::internal::Geodesic_query at(const Face_location& location) const
  {
    Cut_loci::internal::Geodesic_point_search search(computed(), maximum_distance_ / mesh_.unit());
    return search(to_indexed(location));
  }

  void require_exact() const
  {
    if(computed().is_approximate())
      throw Cut_loci::Invalid_input(Cut_loci::Cause::PARAMETER_OF_OTHER_METHOD,
                                    "directions and paths need exact distances: "
                                    "the maximum relative error must be zero");
  }

  const Cut_loci::internal::Exact_geodesic_propagation& with_directions() const
  {
    require_exact();
    if(!has_directions_)
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "directions have not been computed: set_directions() comes before compute()");
    return computed();
  }

  void require_isolines(FT deviation) const
  {
    if(!has_isolines_)
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "isolines have not been asked for: set_isolines() comes before compute()");
    if(!(deviation > 0.))
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER, "the maximum deviation must be positive");
  }

  void require_level(FT level) const
  {
    if(!(level > 0. && level < infinity() && level <= maximum_distance_))
      throw Cut_loci::Invalid_input(Cut_loci::Cause::INVALID_PARAMETER,
                                    "there is no isoline of the level " + std::to_string(level) +
                                      ": levels are positive and finite, and no larger than the maximum distance");
  }

  static constexpr double default_deviation = 1e-3; // in mean edge lengths
  static constexpr double longest_walk = 1000.;     // in all edges: what is longer would not end in any time

  // the number of `v`; where its faces form several fans, of the copy that is nearest to the sources
  Cut_loci::Index index(vertex_descriptor v) const
  {
    return mesh_.index(v, [this](Cut_loci::Index i) { return computed().distance(i); });
  }

  Cut_loci::Indexed_location to_indexed(const Face_location& location) const
  {
    const Cut_loci::Indexed_location result = mesh_.location(location);
    geodesics_.check(result);
    return result;
  }

  template <typename OutputIterator>
  OutputIterator write(const std::vector<Cut_loci::Indexed_location>& path, OutputIterator out) const
  {
    for(const Cut_loci::Indexed_location& location : path)
      *out++ = mesh_.face_location(location);
    return out;
  }

  Cut_loci::internal::Mesh_of_fans<TriangleMesh> mesh_;
  Cut_loci::internal::Exact_geodesic_propagation geodesics_;
  std::unique_ptr<Cut_loci::internal::Exact_geodesic_propagation> with_curves_; // in place of it, if there are curves
  Cut_loci::internal::Exact_geodesic_options options_;
  std::vector<Cut_loci::Indexed_location> sources_;
  std::vector<Cut_loci::Indexed_curve> curves_;
  std::vector<Cut_loci::internal::Crossing_window> windows_; // if isolines have been asked for
  FT maximum_distance_ = 0.;                                 // of the last call of `compute()`
  std::size_t number_of_points_ = 0;                         // that were sources in the last call of `compute()`
  bool is_computed_ = false, has_directions_ = false,
       has_isolines_ = false; // by the last call of `compute()`
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_EXACT_GEODESICS_H
