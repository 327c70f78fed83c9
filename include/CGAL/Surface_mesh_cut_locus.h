// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_SURFACE_MESH_CUT_LOCUS_H
#define CGAL_SURFACE_MESH_CUT_LOCUS_H

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/face_graph/Cut_locus_builder.h>
#include <CGAL/Cut_loci/face_graph/Surface_component.h>
#include <CGAL/Cut_loci/face_graph/Visitor_handle.h>
#include <CGAL/Cut_loci/face_graph/concurrency.h>
#include <CGAL/Cut_loci/face_graph/reading/method_parameters.h>
#include <CGAL/Cut_loci/face_graph/reading/read_curves.h>
#include <CGAL/Cut_loci/face_graph/reading/read_edge_lengths.h>
#include <CGAL/Cut_loci/face_graph/reading/read_source.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/Geodesic_solver_handle.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_locus.h>
#include <CGAL/Exact_geodesic_solver.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes cut loci on a triangle mesh, at three levels of cost: the constructor does what depends on the mesh alone,
 * `set_source()` what depends on the source, and `cut_locus()` applies thresholds in time proportional to the size of
 * its result, so that it follows a slider.
 *
 * With the default solver, the cut locus of the polyhedron is computed from the windows of exact geodesics. Branches that
 * are there only because of the mesh and its noise are left out (`Cut_loci::Default_method`). No shortest path crosses
 * what is left. Otherwise the method is that of Mancinelli, Livesu and Puppo
 * \cgalCite{cgal:mlp-pccld-21} (`Cut_loci::Laplacian_method`), which takes any distances: a spanning tree is grown
 * from the vertex farthest from the source along the valleys of the Laplacian of the distance, thinned, completed by
 * homology generators, and its weak branches are removed. The parameter `cut_locus_method` chooses one of them.
 *
 * Each edge-connected component is a surface of its own: the cut locus lies in the source's, and the distance is
 * infinite on all others. Isolated vertices are ignored.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam VertexPointMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a 3D point as value type. %Default:
 *         `boost::property_map<TriangleMesh,
 *         vertex_point_t>::%const_type`
 */
template <typename TriangleMesh, typename VertexPointMap = Default>
class Surface_mesh_cut_locus
{
public:
  using Vertex_point_map =
    typename Default::Get<VertexPointMap, typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::type;
  using Point_3 = typename boost::property_traits<Vertex_point_map>::value_type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;

  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// a point of the mesh: a face, and barycentric coordinates in the order of the vertices from
  /// `source(halfedge(f, tm), tm)`
  using Face_location = std::pair<face_descriptor, std::array<FT, 3>>;
  /// a source: a vertex, or any point
  using Source = std::variant<vertex_descriptor, Face_location>;
  using Result = Cut_locus<TriangleMesh, Point_3>;

  /*!
   * reads the mesh, which must not change as long as the object is used. The operators of a component are built with
   * its first source.
   *
   * @param tm a triangle mesh
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
   *     \cgalParamType{`Vertex_point_map`}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_length_map}
   *     \cgalParamDescription{the lengths of the edges, which are the metric then: an intrinsic triangulation, or a metric
   *                           without an embedding. The points are for output only.}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a number as value type}
   *     \cgalParamDefault{the distances between the points}
   *     \cgalParamExtra{not for `Cut_loci::Laplacian_method` and other solvers, which need points. What is in units of
   *                     the diagonal of the bounding box is then in units of the square root of the area, and the width of
   *                     a branch is found from the angles at which paths part and meet, see Section
   *                     \ref Surface_mesh_cut_locus_lengths.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{geodesic_solver}
   *     \cgalParamDescription{the solver that computes the distances}
   *     \cgalParamType{a model of `GeodesicSolver`}
   *     \cgalParamDefault{`Exact_geodesic_solver()`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{cut_locus_method}
   *     \cgalParamDescription{how the cut locus is found, with the options of the method}
   *     \cgalParamType{`Cut_loci::Default_method`, `Cut_loci::Polyhedral_method`, `Cut_loci::Laplacian_method`, or
   *                    `Cut_loci::Method`}
   *     \cgalParamDefault{what the distances of a source allow: `Cut_loci::Default_method` with `Exact_geodesic_solver`, and
   *                       `Cut_loci::Laplacian_method` with all others and with a `vertex_distance_map`}
   *     \cgalParamExtra{The first two need the paths of the package's own exact solver, and not distances alone. For the
   *                     others, `CGAL/Cut_loci/Laplacian_method.h` has to be included.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{concurrency_tag}
   *     \cgalParamDescription{whether several threads are used, by TBB, for what depends on the mesh, for strengths and widths
   *                           and, where the default has one source, for distances and where the cut locus crosses edges.
   *                           That takes the memory of distances twice. Other distances take one thread. The results are
   *                           the same.}
   *     \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
   *     \cgalParamDefault{`Sequential_tag`}
   *     \cgalParamExtra{Copies of the object use one thread each.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor that is told when a stage starts and ends, and how far it is}
   *     \cgalParamType{a model of `CutLocusVisitor`}
   *     \cgalParamDefault{`Cut_loci::Default_visitor()`}
   *     \cgalParamExtra{It is copied; pass `std::ref(visitor)` to keep its state.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input if the mesh has no vertices or no faces, a face is not a triangle, a coordinate is
   *         not finite, or lengths are no lengths of triangles
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Surface_mesh_cut_locus(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
    : tm_(tm), vpm_(Cut_loci::internal::point_map(tm, np)),
      has_own_solver_(Cut_loci::internal::has_own_solver<CGAL_NP_CLASS>()),
      solver_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_solver),
                                           Exact_geodesic_solver()))
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Cut_loci::internal::refuse_parameters_of_distances<CGAL_NP_CLASS>();
    if constexpr(Cut_loci::internal::is_given<CGAL_NP_CLASS, internal_np::cut_locus_method_t>())
      fixed_method_ = get_parameter(np, internal_np::cut_locus_method);
    method_ = method_for(np);
    admit_laplacian<CGAL_NP_CLASS>();
    constexpr bool has_lengths = Cut_loci::internal::has_edge_lengths<CGAL_NP_CLASS>();
    if(has_lengths && has_own_solver_)
      Cut_loci::internal::refuse_lengths("the geodesic_solver");
    refuse_lengths(has_lengths, method_);
    visitor_ = Cut_loci::internal::Visitor_handle(
      choose_parameter(get_parameter(np, internal_np::visitor), Cut_loci::Default_visitor()));
    threads_ = Cut_loci::internal::threads_of<CGAL_NP_CLASS>();
    const Stage_scope scope(visitor_, Cut_loci::Stage::PREPROCESSING);
    const auto read = std::make_shared<Read>(Cut_loci::internal::read_triangle_mesh(
      tm, vpm_, !has_lengths, visitor_.progress(Cut_loci::Stage::PREPROCESSING).part(0., 0.8)));
    Cut_loci::internal::read_edge_lengths(tm, *read, get_parameter(np, internal_np::edge_length_map));
    Cut_loci::internal::normalize_lengths(*read);
    read_ = read;
    component_of_face_ = std::make_shared<const std::vector<Index>>(Cut_loci::internal::face_components(
      read_->mesh, number_of_components_, visitor_.progress(Cut_loci::Stage::PREPROCESSING).part(0.8, 1.)));
  }

  /*!
   * makes a copy for other sources: it has the parameters of `other`, and no source. What has been computed for the mesh
   * alone, by `prepare()` or with the first source, is shared by all copies, and nothing else: so each thread may set
   * sources of a copy of its own, while nobody changes the mesh. Copies are made before the threads start, or while no
   * other one uses `other`. Whatever `concurrency_tag` says, a copy uses one thread.
   *
   * A geodesic solver and a visitor are copied, too; one that is held by `std::ref()` is then used by several threads.
   */
  Surface_mesh_cut_locus(const Surface_mesh_cut_locus& other)
    : tm_(other.tm_), vpm_(other.vpm_), make_laplacian_(other.make_laplacian_), fixed_method_(other.fixed_method_),
      method_(other.method_), has_own_solver_(other.has_own_solver_), solver_(other.solver_), visitor_(other.visitor_),
      read_(other.read_), component_of_face_(other.component_of_face_),
      number_of_components_(other.number_of_components_)
  {
    for(const auto& component : other.components_)
      components_[component.first].reset(new Component(*component.second));
  }
  Surface_mesh_cut_locus& operator=(const Surface_mesh_cut_locus&) = delete;

  /*!
   * does what depends on the mesh alone for the components of these sources, which else is done with the first source of
   * each. Copies that are made afterwards share it. The source that is set, if there is one, stays.
   *
   * @tparam SourceRange a model of `ConstRange` as for `set_sources()`; here the sources may be in different components
   *
   * @param sources the sources that will be set one after another, by this object or its copies
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those that `set_source()` will be
   *        given
   *
   * @throws Cut_loci::Invalid_input where `set_source()` throws it for what is wrong with a source, its component or the
   *         parameters
   */
  template <typename SourceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void prepare(const SourceRange& sources, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    const Cut_loci::Method method = method_for(np);
    admit_laplacian<CGAL_NP_CLASS>();
    for(const auto& source : Cut_loci::internal::read_sources(tm_, *read_, sources, snapping_tolerance(np), true))
      component_at((*component_of_face_)[source.location.face], method);
  }

  /*!
   * computes the distances to a source and all that `cut_locus()` needs.
   *
   * @param source a vertex; or the face in which the source lies, or one of those at its edge or vertex, and its barycentric
   *        coordinates there, which are normalized to sum up to one
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_distance_map}
   *     \cgalParamDescription{the geodesic distance of each vertex to the source, if it is known: then no solver runs}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with `vertex_descriptor` as key type and a number as
   *                    value type}
   *     \cgalParamExtra{Only the values in the component of the source are read. Unless the constructor was given a
   *                     `cut_locus_method`, this source is treated by `Cut_loci::Laplacian_method`.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{maximum_relative_error}
   *     \cgalParamDescription{by how much distances may be longer than the exact ones, as a share of their length, from 0
   *                           to 0.1. Time and memory then grow nearly linearly with the number of faces.}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0}
   *     \cgalParamExtra{for `Exact_geodesic_solver`, and not for `Cut_loci::Polyhedral_method`. On smooth meshes of
   *                     100 000 to a million faces, 1e-5 moves the curve by less than a hundredth of an edge in the mean,
   *                     see Section \ref Surface_mesh_cut_locus_error.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{snapping_tolerance}
   *     \cgalParamDescription{a barycentric coordinate of the source up to this value is taken for zero, once they sum up
   *                           to one}
   *     \cgalParamType{`FT`}
   *     \cgalParamDefault{1e-10: far above rounding errors, and 1e-10 edges are far below the accuracy of the method}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * Faces without area are taken: see Section \ref Surface_mesh_cut_locus_robustness.
   *
   * @throws Cut_loci::Invalid_input if the source is null, isolated or not in the mesh, or has coordinates that are not
   *         finite, are negative or sum up to zero, if no face of its component has an area, if a vertex of its component is
   *         not manifold, if a distance is not a finite number, if a `vertex_distance_map` has the same one everywhere, or if
   *         there is a `maximum_relative_error` or `snapping_tolerance` that is out of its range, or an error that is not zero
   *         where the distances are not those of `Exact_geodesic_solver` or the method is `Cut_loci::Polyhedral_method`
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  void set_source(const Source& source, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    solve({Cut_loci::internal::read_source(tm_, *read_, source, snapping_tolerance(np))}, np);
  }

  /*!
   * does the same for a set of source points. Their cut locus is the closure of the set of points with several shortest
   * paths to it: the geodesic Voronoi diagram of the sources, together with the cut locus inside each cell. Its
   * complement is one open disk for each source, and on a closed surface of genus g the graph has 2g - 1 + k independent
   * cycles for k sources. What is between two sources is no branch, and no threshold removes it. `distance()` of the
   * result is that to the nearest source.
   *
   * In a curve of mesh edges, each source has its disk if there is a face for each of them at which it lies. If not, such
   * a curve is refused. A source at a vertex all of whose faces are at other sources too may lie on the curve.
   *
   * A set of one source is treated as by `set_source()`.
   *
   * `Cut_loci::Laplacian_method` takes any distances. If the solver takes one source only, there is a run for each of them. A
   * `vertex_distance_map` has the distances to the nearest source. Each source must have a face to itself. The cell of a
   * vertex is that of the source which the solver says is nearest, or from which a shortest way through faces comes.
   *
   * Curves along edges of the mesh, and the border, may be sources, too. They are numbered behind the points. The surface
   * without the sources shrinks to the cut locus: its parts are disks around points and open curves, and rings around
   * loops.
   *
   * Edges of the mesh stay off the curves. Where all ways lead along them, as between two curves that are one face or one edge
   * of the border apart, `cut_locus()` throws. `Cut_loci::Laplacian_method`, which starts with edges of the mesh, throws
   * there with either kind of curve. With other solvers than `Exact_geodesic_solver`, its distances are those to the
   * vertices of the curves.
   *
   * @tparam SourceRange a model of `ConstRange` with `vertex_descriptor`, `Face_location` or, for both kinds in one set,
   *         `Source` as value type
   *
   * @param sources the sources that are points, which must be different points of the same component of the mesh; with curves,
   *        there may be none
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `set_source()`, of which a
   *        `vertex_distance_map` has the distances to the nearest source and `snapping_tolerance` is also how much the
   *        coordinates of one point may differ, and the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{source_curves}
   *     \cgalParamDescription{sources that are curves: for each one the edges of the mesh that it is made of}
   *     \cgalParamType{a model of `ConstRange` of models of `ConstRange` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as value type}
   *     \cgalParamDefault{none}
   *     \cgalParamExtra{Each of them must be connected, and no two sources may have a vertex in common. The cut locus is
   *                     moved by up to about 1e-5 of their longest edge, the distances are those at its place. Polylines
   *                     through the faces become such edges by `refine_along_polylines()`.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{source_border}
   *     \cgalParamDescription{whether each border loop is a source, behind all others}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input where `set_source()` throws it for one of the sources, and if there is none, if two
   *         are at the same point, closer to each other than 1e-5 of an edge, or in different components, or if the method is
   *         `Cut_loci::Laplacian_method` and one of several has no face to itself; for curves, also if one has no edges or
   *         is not connected, if there is a `maximum_relative_error`, or if the mesh has no border that could be a source
   */
  template <typename SourceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void set_sources(const SourceRange& sources, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    const double tolerance = snapping_tolerance(np);
    const std::vector<Cut_loci::Indexed_curve> curves = read_curves(np);
    const auto read = Cut_loci::internal::read_sources(tm_, *read_, sources, tolerance, curves.empty());
    Cut_loci::internal::check_sources(read_->mesh, read, *component_of_face_, tolerance);
    if(!curves.empty())
      Cut_loci::internal::check_curves(read_->mesh, read, curves, *component_of_face_);
    solve(read, np, curves);
  }

  /*!
   * returns the part of the cut locus that passes the thresholds, in time proportional to its size. `set_source()` or
   * `set_sources()` must have been called.
   *
   * The result depends on the mesh, the sources and these parameters alone, and not on earlier calls. Several threads may
   * call it at once; one waits for the other, so copies of the object are faster.
   *
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{cut_locus_method}
   *     \cgalParamDescription{the method that is in force, with other options: thresholds, mostly}
   *     \cgalParamType{`Cut_loci::Default_method`, `Cut_loci::Polyhedral_method`, `Cut_loci::Laplacian_method`, or
   *                    `Cut_loci::Method`}
   *     \cgalParamDefault{the method that is in force, with the options that the constructor was given}
   *     \cgalParamExtra{A smaller `minimum_branch_width` than at the constructor takes a computation for the source once
   *                     more, which is kept for those of about its size.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{cut_locus_curve}
   *     \cgalParamDescription{whether the result is made of edges of the mesh or of segments through its faces}
   *     \cgalParamType{`Cut_loci::Curve`}
   *     \cgalParamDefault{`Cut_loci::Curve::THROUGH_FACES`}
   *     \cgalParamExtra{All of the result is about this curve; the other one is not computed. What needs edges of the mesh,
   *                     such as `cut_along_cut_locus()`, refuses a curve through the faces.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{kept_part}
   *     \cgalParamDescription{which part of the cut locus of several sources is kept}
   *     \cgalParamType{`Cut_loci::Kept_part`}
   *     \cgalParamDefault{`Cut_loci::Kept_part::ALL`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_is_constrained_map}
   *     \cgalParamDescription{a property map that is set to `true` for the edges of the mesh on the cut locus; the
   *                           others are left as they are}
   *     \cgalParamType{a class model of `WritablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
   *     \cgalParamExtra{for `Cut_loci::Curve::MESH_EDGES` only, which has to be passed}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input if there is no source, if a threshold is not a number or out of its range, if
   *         another method than the one in force is given, or if `cut_locus_curve` asks for edges of the mesh that leave no
   *         way between the sources
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Result cut_locus(const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    using namespace Cut_loci::internal;
    if(!source_result_)
      throw Cut_loci::Invalid_input(Cut_loci::Cause::NO_SOURCE,
                                    "there is no source: set_source() comes before cut_locus()");
    refuse_parameters_of_distances<CGAL_NP_CLASS>();
    const Cut_loci::Method options = read_options(np, method_);
    const Cut_loci::Curve curve = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::cut_locus_curve), Cut_loci::Curve::THROUGH_FACES);
    const Cut_loci::Kept_part part =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::kept_part), Cut_loci::Kept_part::ALL);
    refuse_map_of_other_curve(np, curve);

    std::unique_lock<std::mutex> lock(component_->in_use); // what has been measured once is kept
    const Stage_scope scope(visitor_, Cut_loci::Stage::FILTER);
    report(*component_, Cut_loci::Stage::FILTER); // what has been left out may be computed
    Cut_loci::Indexed_cut_locus found;
    if(const auto* laplacian = std::get_if<Cut_loci::Laplacian_method>(&options))
      found = component_->laplacian->filter(read_branch_thresholds(*laplacian, component_->diagonal),
                                            read_smoothing(*laplacian, curve), part);
    else
    {
      Exact_tree_thresholds thresholds = component_->thresholds(options);
      thresholds.part = part;
      if(!curves_.empty())
        refuse_short_branches(thresholds, curve);
      found = component_->exact_tree->filter(thresholds, curve);
    }
    lock.unlock();
    mark_edges(found, parameters::get_parameter(np, internal_np::edge_is_constrained));
    return Builder(tm_, vpm_, read_, *component_)(found, points_of_sources(), source_result_);
  }

  /// the method that is in force: for the current source, or, if there is none, for one without a
  /// `vertex_distance_map`
  const Cut_loci::Method& method() const { return method_; }
  /// the default of `minimum_branch_width` for the current source, if it has one: for paths as long as the surface. On noisy
  /// meshes shorter ones need less by default, while a number that is given is for all.
  double minimum_branch_width() const
  {
    if(!has_exact_tree())
      return 0.;
    const double width = component_->default_thresholds(method_).width / component_->diagonal;
    return component_->mesh->is_intrinsic ? width : (std::min)(width, 1.); // no branch is as wide, and none is wider
  }
  /// the curvature, in radians, that two shortest paths as long as the surface have to enclose for a branch of a quarter of the
  /// default width to be shown by default with `Cut_loci::Default_method`, or of no width at the corners of a polyhedron;
  /// else 0
  double minimum_branch_curvature() const
  {
    return has_exact_tree() && !is_polyhedral() ? component_->default_thresholds(method_).enclosed : 0.;
  }

private:
  using Index = Cut_loci::Index;
  using Read = Cut_loci::internal::Read_triangle_mesh<TriangleMesh>;
  using Solver_handle = Cut_loci::internal::Geodesic_solver_handle;
  using Builder = Cut_loci::internal::Cut_locus_builder<TriangleMesh, Vertex_point_map>;
  using Component = Cut_loci::internal::Surface_component;
  using Stage_scope = Cut_loci::internal::Visitor_handle::Scope;

  // the method for a source that is set with these parameters
  template <typename NamedParameters>
  Cut_loci::Method method_for(const NamedParameters&) const
  {
    if(fixed_method_)
      return *fixed_method_;
    return Cut_loci::internal::is_given<NamedParameters, internal_np::vertex_distance_map_t>()
             ? Cut_loci::Method(Cut_loci::Laplacian_method())
             : solver_.cut_locus_method();
  }

  template <typename NamedParameters>
  void admit_laplacian()
  {
    using Method =
      std::conditional_t<Cut_loci::internal::may_be_laplacian<NamedParameters>(), Cut_loci::Laplacian_method, void>;
    if constexpr(!std::is_void<Method>::value)
      make_laplacian_ = Cut_loci::internal::Code_of<Method>::make_solver;
  }

  template <typename NamedParameters>
  static double snapping_tolerance(const NamedParameters& np)
  {
    return Cut_loci::internal::checked_snapping_tolerance(to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::snapping_tolerance), FT(1e-10))));
  }

  // a curve has its first vertex
  std::vector<Cut_loci::Indexed_source> points_of_sources() const
  {
    std::vector<Cut_loci::Indexed_source> result = points_;
    for(const Cut_loci::Indexed_curve& curve : curves_)
    {
      const Index h = curve.halfedges.front();
      result.push_back({Cut_loci::internal::location_on(h), component_->mesh->source(h)});
    }
    return result;
  }

  bool has_exact_tree() const { return source_result_ && !Cut_loci::internal::is_laplacian(method_); }
  bool is_polyhedral() const { return std::holds_alternative<Cut_loci::Polyhedral_method>(method_); }

  // those of the two parameters
  template <typename NamedParameters>
  std::vector<Cut_loci::Indexed_curve> read_curves(const NamedParameters& np) const
  {
    using parameters::get_parameter;
    auto curves = Cut_loci::internal::read_curves(tm_, *read_, get_parameter(np, internal_np::source_curves));
    if(parameters::choose_parameter(get_parameter(np, internal_np::source_border), false))
      for(Cut_loci::Indexed_curve& loop : Cut_loci::internal::border_curves(read_->mesh))
        curves.push_back(std::move(loop));
    return curves;
  }

  template <typename NamedParameters>
  void solve(const std::vector<Cut_loci::Indexed_source>& points, const NamedParameters& np,
             const std::vector<Cut_loci::Indexed_curve>& curves = {})
  {
    const Cut_loci::Method method = method_for(np);
    admit_laplacian<NamedParameters>();
    Cut_loci::internal::refuse_parameters_of_distances<NamedParameters>();
    const double error = Cut_loci::internal::read_maximum_relative_error(np);
    refuse_lengths(read_->mesh.is_intrinsic, method);
    if(!curves.empty())
      Cut_loci::internal::refuse_error_of_curves(error);
    source_result_.reset();
    method_ = method;
    constexpr bool runs_solver = !Cut_loci::internal::is_given<NamedParameters, internal_np::vertex_distance_map_t>();
    Component& component = component_at(
      (*component_of_face_)[points.empty() ? curves.front().halfedges.front() / 3 : points.front().location.face],
      method);
    component_ = &component;
    points_.clear();
    for(const Cut_loci::Indexed_source& source : points)
      points_.push_back(component.local(source));
    curves_.clear();
    for(const Cut_loci::Indexed_curve& curve : curves)
      curves_.push_back(component.local(curve));
    if(error > 0. && !runs_solver)
      Cut_loci::internal::refuse_error();
    maximum_relative_error_ = error;
    if(!Cut_loci::internal::is_laplacian(method_))
    {
      component.exact_tree->set_maximum_relative_error(error);
      component.exact_tree->set_curves(curves_);
      component.exact_tree->expect(component.thresholds(method_));
    }
    {
      const Stage_scope scope(visitor_, Cut_loci::Stage::DISTANCE);
      report(component, Cut_loci::Stage::DISTANCE);
      set_distances(component, parameters::get_parameter(np, internal_np::vertex_distance_map));
    }
    finish(component, *component.solver(method_));
  }

  // lets the visitor know how far the stage is that follows
  void report(Component& component, Cut_loci::Stage stage) const
  {
    component.solver(method_)->report_to(visitor_.progress(stage));
  }

  static void refuse_lengths(bool has_lengths, const Cut_loci::Method& method)
  {
    if(has_lengths && Cut_loci::internal::is_laplacian(method))
      Cut_loci::internal::refuse_lengths("the method " + std::string(Cut_loci::name_of(method)));
  }

  // The solver is of any method: where its type says which, compilers take in the code of the only class that it can be.
  void finish(Component& component, Cut_loci::internal::Method_solver& solver)
  {
    const auto run = [&](Cut_loci::Stage stage, const auto& function)
    {
      const Stage_scope scope(visitor_, stage);
      report(component, stage);
      function();
    };
    run(Cut_loci::Stage::STRENGTH, [&] { solver.compute_strengths(); });
    run(Cut_loci::Stage::TREE, [&] { solver.grow_tree(); });
    run(Cut_loci::Stage::HOMOLOGY, [&] { solver.close_cycles(); });

    auto result = std::make_shared<Cut_loci::internal::Source_result>();
    result->farthest = component.vertex(solver.farthest());
    result->genus = solver.genus();
    result->number_of_border_loops = solver.number_of_border_loops();
    result->number_of_curves = static_cast<Index>(curves_.size());
    result->least_distance = read_->unit * solver.least_distance();
    const std::size_t n = read_->vertices.size();
    result->distance = component.in_whole(solver.distance(), n, (std::numeric_limits<double>::infinity)());
    result->nearest_source = component.in_whole(solver.nearest_sources(), n, Cut_loci::null_index);
    source_result_ = result;
  }

  // The package's own solver also finds the directions.
  template <typename VertexDistanceMap>
  void set_distances(Component& component, const VertexDistanceMap& map)
  {
    constexpr bool is_map = !std::is_same<VertexDistanceMap, internal_np::Param_not_found>::value;
    if(!Cut_loci::internal::is_laplacian(method_))
    {
      if(is_map || has_own_solver_)
        Cut_loci::internal::refuse_distances(method_);
      component.exact_tree->compute_distance(points_, curves_);
      Cut_loci::internal::check_distances(component.exact_tree->distance(), component, read_->positions,
                                          "the geodesic solver returned", component.mesh->number_of_vertices());
      return;
    }
    std::vector<double> distance;
    std::vector<Index> nearest;
    compute_distances(component, distance, nearest, map);
    component.laplacian->set_distance(points_, curves_, std::move(distance), std::move(nearest),
                                      !is_map && solver_.is_approximate());
  }

  Component& component_at(Index id, const Cut_loci::Method& method)
  {
    std::unique_ptr<Component>& component = components_[id];
    if(component && component->solver(method) != nullptr)
      return *component;
    const Stage_scope scope(visitor_, Cut_loci::Stage::PREPROCESSING);
    if(!component)
      component.reset(new Component(read_->mesh, *component_of_face_, id, number_of_components_));
    visitor_.progress(Cut_loci::Stage::PREPROCESSING)(0.);
    component->make_solver(method, make_laplacian_, threads_, read_->mesh, read_->positions,
                           visitor_.progress(Cut_loci::Stage::PREPROCESSING));
    return *component;
  }

  void compute_distances(Component& component, std::vector<double>& distance, std::vector<Index>& nearest,
                         internal_np::Param_not_found)
  {
    Solver_handle& solver = component.geodesic_solver;
    const Cut_loci::internal::Progress progress = visitor_.progress(Cut_loci::Stage::DISTANCE);
    const Cut_loci::internal::Divided_mesh* divided = component.laplacian->divided();
    const Cut_loci::Indexed_triangle_mesh& mesh = divided != nullptr ? divided->mesh() : component.measured();
    if(solver.empty())
      solver = solver_.bound_to(mesh, progress);
    if(!solver.set_maximum_relative_error(maximum_relative_error_) && maximum_relative_error_ > 0.)
      Cut_loci::internal::refuse_error();
    solver.report_to(progress);
    solver.compute_distances(divided != nullptr ? divided->divided(points_) : points_,
                             divided != nullptr ? divided->divided(curves_) : curves_, distance, nearest);
    Cut_loci::internal::check_distances(distance, component, read_->positions, "the geodesic solver returned",
                                        mesh.number_of_vertices());
    Cut_loci::internal::check_range(distance, component, read_->positions, "the geodesic solver returned",
                                    "take another solver, or a mesh with better faces");
  }

  template <typename VertexDistanceMap>
  void compute_distances(Component& component, std::vector<double>& distance, std::vector<Index>&,
                         const VertexDistanceMap& map)
  {
    distance.resize(component.mesh->number_of_vertices());
    for(Index v = 0; v < distance.size(); ++v)
      distance[v] = to_double(get(internal_np::get_reference(map), read_->vertices[component.vertex(v)])) / read_->unit;
    Cut_loci::internal::check_distances(distance, component, read_->positions, "the vertex distance map holds",
                                        component.mesh->number_of_vertices());
    Cut_loci::internal::check_range(distance, component, read_->positions, "the vertex distance map holds",
                                    "it must hold the geodesic distances to the source, in the unit of the points");
    Cut_loci::internal::check_is_not_constant(distance, *component.mesh, points_, curves_);
  }

  void mark_edges(const Cut_loci::Indexed_cut_locus&, internal_np::Param_not_found) const {}

  template <typename EdgeIsConstrainedMap>
  void mark_edges(const Cut_loci::Indexed_cut_locus& cut_locus, EdgeIsConstrainedMap map) const
  {
    for(const Cut_loci::Indexed_cut_locus::Edge& e : cut_locus.edges)
      if(e.halfedge != Cut_loci::null_index)
        put(map, edge(read_->halfedges[component_->halfedge(e.halfedge)], tm_), true);
  }

  const TriangleMesh& tm_;
  Vertex_point_map vpm_;
  decltype(&Cut_loci::internal::make_laplacian_solver) make_laplacian_ = nullptr; // unless that method can be in force
  std::optional<Cut_loci::Method> fixed_method_;                                  // by the named parameter
  Cut_loci::Method method_;                                                       // in force
  bool has_own_solver_;  // another one than the package's exact one
  Solver_handle solver_; // as given; each component has its own
  Cut_loci::internal::Visitor_handle visitor_;
  Cut_loci::internal::Threads threads_; // not of copies

  std::shared_ptr<const Read> read_;
  std::shared_ptr<const std::vector<Index>> component_of_face_;
  Index number_of_components_ = 0;
  std::map<Index, std::unique_ptr<Component>> components_;

  Component* component_ = nullptr;               // that of the sources
  std::vector<Cut_loci::Indexed_source> points_; // in their component, and
  std::vector<Cut_loci::Indexed_curve> curves_;
  double maximum_relative_error_ = 0.; // of their distances
  std::shared_ptr<const Cut_loci::internal::Source_result> source_result_;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUT_LOCUS_H
