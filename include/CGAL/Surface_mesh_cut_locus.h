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
#include <CGAL/Cut_loci/internal/Component_solver.h>
#include <CGAL/Cut_loci/internal/Direction_solver.h>
#include <CGAL/Cut_loci/internal/Geodesic_solver_handle.h>
#include <CGAL/Cut_loci/internal/connected_components.h>
#include <CGAL/Cut_loci/internal/read_triangle_mesh.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_locus.h>
#include <CGAL/Exact_geodesic_solver.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes cut loci on a triangle mesh, at three levels of cost: the constructor does what depends on the mesh alone,
 * `set_source()` what depends on the source, and `cut_locus()` applies thresholds in time proportional to the size of
 * its result, so that it follows a slider.
 *
 * The method is that of Mancinelli, Livesu and Puppo \cgalCite{cgal:mlp-pccld-21}: a spanning tree is grown from the
 * vertex farthest from the source along the valleys of the Laplacian of the distance, thinned, completed by homology
 * generators, and its weak branches are removed.
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
  using Vertex_point_map = typename Default::Get<
    VertexPointMap, typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::type;
  using Point_3 = typename boost::property_traits<Vertex_point_map>::value_type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;

  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// a point of the mesh: a face, and barycentric coordinates in the order of the vertices from `source(halfedge(f,
  //tm), tm)`
  using Face_location = std::pair<face_descriptor, std::array<FT, 3> >;
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
   *   \cgalParamNBegin{geodesic_solver}
   *     \cgalParamDescription{the solver that computes the distances}
   *     \cgalParamType{a model of `GeodesicSolver`}
   *     \cgalParamDefault{`Exact_geodesic_solver()`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{laplacian_operator}
   *     \cgalParamDescription{the discretization of the Laplace-Beltrami operator}
   *     \cgalParamType{`Cut_loci::Laplacian_operator`}
   *     \cgalParamDefault{`Cut_loci::Laplacian_operator::QUADRATIC_FIT`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{cut_locus_method}
   *     \cgalParamDescription{how the cut locus is found}
   *     \cgalParamType{`Cut_loci::Method`}
   *     \cgalParamDefault{`default_method()`}
   *     \cgalParamExtra{`Cut_loci::Method::DIRECTION` needs exact distances: with those of the heat method, or of a
   *                     graph, use `Cut_loci::Method::LAPLACIAN`. `Cut_loci::Method::POLYHEDRAL` has neither thresholds
   *                     nor a curve of mesh edges. Without a `geodesic_solver` it uses the
   *                     package's own exact one, which also finds the directions.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor that is told when a stage starts and ends}
   *     \cgalParamType{a class with the functions of `Cut_loci::Default_visitor`}
   *     \cgalParamDefault{`Cut_loci::Default_visitor()`}
   *     \cgalParamExtra{It is copied; pass `std::ref(visitor)` to keep its state.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input if the mesh has no vertices or no faces, a face is not a triangle, or a
   *         coordinate is not finite
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Surface_mesh_cut_locus(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
    : tm_(tm),
      vpm_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                        get_const_property_map(vertex_point, tm))),
      laplacian_operator_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::laplacian_operator),
                                                       Cut_loci::Laplacian_operator::QUADRATIC_FIT)),
      method_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::cut_locus_method),
                                           default_method())),
      has_own_solver_(!std::is_same<typename internal_np::Lookup_named_param_def<
                        internal_np::geodesic_solver_t, CGAL_NP_CLASS, Exact_geodesic_solver>::type,
                        Exact_geodesic_solver>::value),
      solver_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_solver),
                                           Exact_geodesic_solver()))
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    set_visitor(choose_parameter(get_parameter(np, internal_np::visitor), Cut_loci::Default_visitor()));
    const Stage_scope scope(*this, Cut_loci::Stage::PREPROCESSING);
    read_ = std::make_shared<Read>(Cut_loci::internal::read_triangle_mesh(tm, vpm_));
    component_of_face_ = Cut_loci::internal::face_components(read_->mesh, number_of_components_);
  }

  Surface_mesh_cut_locus(const Surface_mesh_cut_locus&) = delete;
  Surface_mesh_cut_locus& operator=(const Surface_mesh_cut_locus&) = delete;

  /*!
   * computes the distances to vertex `v` and all that `cut_locus()` needs.
   *
   * @param v the source
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_distance_map}
   *     \cgalParamDescription{the geodesic distance of each vertex to the source, if it is known: then no solver runs}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with `vertex_descriptor` as key type and a number as
   *     value
   *                    type}
   *     \cgalParamExtra{Only the values in the component of the source are read.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{snapping_tolerance}
   *     \cgalParamDescription{a barycentric coordinate of the source up to this value is taken for zero}
   *     \cgalParamType{`FT`}
   *     \cgalParamDefault{1e-10: far above rounding errors, and 1e-10 edges are far below the accuracy of the method}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input if the source is null, isolated or not in the mesh, if a face of its component
   *         has no area, if a vertex of its component is not manifold, or if a distance is not a finite number
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  void set_source(vertex_descriptor v, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if(v == boost::graph_traits<TriangleMesh>::null_vertex())
      throw Cut_loci::Invalid_input("the source is the null vertex");
    // A descriptor of another mesh must not be used for a look-up: the search is linear, like all that a source costs.
    const auto found = std::find(read_->vertices.begin(), read_->vertices.end(), v);
    if(found == read_->vertices.end())
    {
      for(vertex_descriptor w : make_range(vertices(tm_)))
        if(w == v)
          throw Cut_loci::Invalid_input("the source is an isolated vertex: no face is incident to it");
      throw Cut_loci::Invalid_input("the source is not a vertex of the mesh");
    }
    const Cut_loci::Index index = static_cast<Cut_loci::Index>(found - read_->vertices.begin());
    const Cut_loci::Index h = outgoing_halfedge(index);
    Cut_loci::Indexed_source source;
    source.vertex = index;
    source.location.face = h / 3;
    source.location.coordinates[h % 3] = 1.;
    solve(source, np);
  }

  /*!
   * does the same for a source at any point of the mesh. Coordinates are normalized to sum up to one.
   *
   * @throws Cut_loci::Invalid_input also if the face is null or not in the mesh, or if the coordinates are not
   *         finite, are negative or sum up to zero
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  void set_source(const Face_location& location, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if(location.first == boost::graph_traits<TriangleMesh>::null_face())
      throw Cut_loci::Invalid_input("the face of the source is null");
    const double tolerance = to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::snapping_tolerance), FT(1e-10)));
    Cut_loci::Indexed_source source;
    source.location.face = 0;
    while(source.location.face < read_->mesh.number_of_faces() &&
          face(read_->halfedges[3 * std::size_t(source.location.face)], tm_) != location.first)
      ++source.location.face;
    if(source.location.face == read_->mesh.number_of_faces())
      throw Cut_loci::Invalid_input("the face of the source is not a face of the mesh");

    std::array<double, 3>& c = source.location.coordinates;
    double sum = 0.;
    for(int i = 0; i < 3; ++i)
    {
      c[i] = to_double(location.second[i]);
      if(!std::isfinite(c[i]))
        throw Cut_loci::Invalid_input("a barycentric coordinate of the source is not finite");
      if(c[i] < -tolerance)
        throw Cut_loci::Invalid_input("a barycentric coordinate of the source is negative: it is outside its face");
      if(c[i] <= tolerance)
        c[i] = 0.;
      sum += c[i];
    }
    if(!std::isfinite(sum))
      throw Cut_loci::Invalid_input("the sum of the barycentric coordinates of the source is not finite");
    if(!(sum > 0.))
      throw Cut_loci::Invalid_input("the barycentric coordinates of the source sum up to zero");
    for(int i = 0; i < 3; ++i)
    {
      c[i] /= sum;
      if(c[i] == 1.)
        source.vertex = read_->mesh.triangles[source.location.face][i];
    }
    solve(source, np);
  }

  /*!
   * returns the part of the cut locus that passes the thresholds, in time proportional to its size. `set_source()` must
   * have been called.
   *
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{gradient_angle_threshold}
   *     \cgalParamDescription{the angle at which shortest paths must meet, in radians in [0, pi]; a larger one
   *                           removes weaker branches}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`default_gradient_angle_threshold()`, unless the geodesic solver asks for another one}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{laplacian_threshold}
   *     \cgalParamDescription{the least value of minus the Laplacian of the distance, times the mean edge length}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{minus infinity}
   *     \cgalParamExtra{With both thresholds, a branch must pass both.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{filter_policy}
   *     \cgalParamDescription{whether weak branches are pruned from the leaves or the tree is grown from the root}
   *     \cgalParamType{`Cut_loci::Filter_policy`}
   *     \cgalParamDefault{`Cut_loci::Filter_policy::PRUNING`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{minimum_branch_edges}
   *     \cgalParamDescription{branches of fewer edges are removed; where branches meet, the longest continues}
   *     \cgalParamType{`std::size_t`}
   *     \cgalParamDefault{3, as in the paper}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{minimum_branch_length}
   *     \cgalParamDescription{branches that are shorter are removed; in units of the diagonal of the bounding box of
   *     the
   *                           source's component}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{strength_threshold}
   *     \cgalParamDescription{by how many times the jump of the shortest paths across a branch must exceed what a
   *     smooth
   *                           distance explains; values below 2 act as 2}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{found from the noise of the mesh: 3 on a smooth one}
   *     \cgalParamExtra{This and `cut_locus_curve` are for `Cut_loci::Method::DIRECTION`, and the parameters above
   *                     for `Cut_loci::Method::LAPLACIAN`.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{cut_locus_curve}
   *     \cgalParamDescription{whether the result is made of edges of the mesh or of segments through its faces}
   *     \cgalParamType{`Cut_loci::Curve`}
   *     \cgalParamDefault{`Cut_loci::Curve::MESH_EDGES`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{edge_is_constrained_map}
   *     \cgalParamDescription{a property map that is set to `true` for the edges of the mesh on the cut locus; the
   *     others
   *                           are left as they are}
   *     \cgalParamType{a class model of `WritablePropertyMap` with
   *     `boost::graph_traits<TriangleMesh>::%edge_descriptor`
   *                    as key type and `bool` as value type}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{number_of_iterations}
   *     \cgalParamDescription{the number of steps that move the curves from the edges of the mesh onto the cut locus,
   *                           through the faces}
   *     \cgalParamType{`unsigned int`}
   *     \cgalParamDefault{0: the curves consist of edges of the mesh}
   *     \cgalParamExtra{Each step leaves half of the way that the one before has left; 4 are enough. The edges of
   *                     the mesh that `edge_is_constrained_map` tells are those of the curves before.}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws Cut_loci::Invalid_input if there is no source, or if a threshold is not a number or out of its range
   */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Result cut_locus(const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    if(!source_result_)
      throw Cut_loci::Invalid_input("there is no source: set_source() comes before cut_locus()");

    const Stage_scope scope(*this, Cut_loci::Stage::FILTER);
    if(method_ != Cut_loci::Method::LAPLACIAN)
    {
      const double threshold = choose_parameter(get_parameter(np, internal_np::strength_threshold),
                                                component_->direction->default_threshold());
      if(std::isnan(threshold))
        throw Cut_loci::Invalid_input("the threshold for the strength is not a number");
      const Cut_loci::Indexed_cut_locus found = component_->direction->filter(
        threshold, choose_parameter(get_parameter(np, internal_np::cut_locus_curve), Cut_loci::Curve::MESH_EDGES));
      mark_edges(found, get_parameter(np, internal_np::edge_is_constrained));
      return make_result(found);
    }
    Cut_loci::Branch_thresholds thresholds;
    thresholds.gradient_angle = choose_parameter(get_parameter(np, internal_np::gradient_angle_threshold),
                                                 source_angle_threshold_);
    thresholds.laplacian = choose_parameter(get_parameter(np, internal_np::laplacian_threshold), thresholds.laplacian);
    thresholds.policy = choose_parameter(get_parameter(np, internal_np::filter_policy), thresholds.policy);
    const std::size_t minimum_edges = choose_parameter(get_parameter(np, internal_np::minimum_branch_edges),
                                                       default_minimum_branch_edges());
    thresholds.minimum_edges = static_cast<Cut_loci::Index>(
      (std::min)(minimum_edges, static_cast<std::size_t>(Cut_loci::null_index)));
    thresholds.minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_branch_length), 0.);
    if(!(thresholds.gradient_angle >= 0.))
      throw Cut_loci::Invalid_input("the threshold for the gradient angle must be a number that is not negative");
    if(std::isnan(thresholds.laplacian))
      throw Cut_loci::Invalid_input("the threshold for the Laplacian is not a number");
    if(!(thresholds.minimum_length >= 0.))
      throw Cut_loci::Invalid_input("the minimum length of a branch must be a number that is not negative");
    thresholds.minimum_length *= component_->diagonal;

    const Cut_loci::Indexed_cut_locus cut_locus = component_->solver->filter(thresholds);
    mark_edges(cut_locus, get_parameter(np, internal_np::edge_is_constrained));
    Cut_loci::Smoothing_parameters smoothing;
    smoothing.number_of_iterations = static_cast<Index>(
      choose_parameter(get_parameter(np, internal_np::number_of_iterations), std::size_t(0)));
    if(smoothing.number_of_iterations == 0)
      return make_result(cut_locus);
    return make_result(component_->solver->smoothed(cut_locus, smoothing));
  }

  /// the default of `cut_locus_method`
  static Cut_loci::Method default_method() { return Cut_loci::Method::LAPLACIAN; }
  /// the default of `gradient_angle_threshold`, in radians
  static double default_gradient_angle_threshold()
  {
    return Cut_loci::internal::Component_solver::default_gradient_angle_threshold();
  }
  /// the default of `gradient_angle_threshold` for the current source: the geodesic solver may ask for one of its own
  double gradient_angle_threshold() const { return source_angle_threshold_; }
  /// the default of `minimum_branch_edges`
  static std::size_t default_minimum_branch_edges() { return 3; }

private:
  using Index = Cut_loci::Index;
  using Read = Cut_loci::internal::Read_triangle_mesh<TriangleMesh>;
  using Solver_handle = Cut_loci::internal::Geodesic_solver_handle;

  // What is computed once for a component, when it gets its first source.
  struct Component
  {
    const Cut_loci::Indexed_triangle_mesh* mesh; // that of `read_` if there is just one component
    Cut_loci::internal::Mesh_component part;     // else
    std::unique_ptr<Cut_loci::internal::Component_solver> solver;     // the one of the two that the method needs
    std::unique_ptr<Cut_loci::internal::Direction_solver> direction;
    Solver_handle geodesic_solver;
    double diagonal = 0.;

    bool is_whole() const { return part.vertices.empty(); }
    Index vertex(Index local) const { return is_whole() ? local : part.vertices[local]; }
    Index face(Index local) const { return is_whole() ? local : part.faces[local]; }
  };

  struct Stage_scope
  {
    Stage_scope(const Surface_mesh_cut_locus& owner, Cut_loci::Stage s)
      : self(owner), stage(s)
    {
      self.visit_(s, true);
    }
    ~Stage_scope() { self.visit_(stage, false); }
    const Surface_mesh_cut_locus& self;
    Cut_loci::Stage stage;
  };

  template <typename T>
  static T& unwrapped(T& t) { return t; }
  template <typename T>
  static T& unwrapped(std::reference_wrapper<T>& t) { return t.get(); }

  template <typename Visitor>
  void set_visitor(Visitor visitor)
  {
    visit_ = [visitor](Cut_loci::Stage stage, bool starts) mutable
    {
      auto& v = unwrapped(visitor);
      if(starts)
        v.start_stage(stage);
      else
        v.end_stage(stage);
    };
  }

  Index outgoing_halfedge(Index v) const
  {
    const auto h = halfedge(read_->vertices[v], tm_);
    for(auto around : CGAL::halfedges_around_target(h, tm_))
    {
      const face_descriptor f = face(around, tm_);
      if(f == boost::graph_traits<TriangleMesh>::null_face())
        continue;
      const Index fi = get(read_->index_of_face, f);
      for(Index i = 0; i < 3; ++i)
        if(read_->mesh.triangles[fi][i] == v)
          return 3 * fi + i;
    }
    throw Cut_loci::Invalid_input("the source is an isolated vertex: no face is incident to it");
  }

  template <typename NamedParameters>
  void solve(Cut_loci::Indexed_source source, const NamedParameters& np)
  {
    source_result_.reset();
    constexpr bool runs_solver =
      parameters::is_default_parameter<NamedParameters, internal_np::vertex_distance_map_t>::value;
    source_angle_threshold_ = runs_solver && solver_.gradient_angle_threshold() > 0.
                              ? solver_.gradient_angle_threshold() : default_gradient_angle_threshold();
    Component& component = component_at(component_of_face_[source.location.face]);
    component_ = &component;
    to_component(component, source);
    source_ = source;

    if(component.direction)
      solve(component, *component.direction, source, np);
    else
      solve(component, *component.solver, source, np);
  }

  template <typename Solver, typename NamedParameters>
  void solve(Component& component, Solver& solver, const Cut_loci::Indexed_source& source, const NamedParameters& np)
  {
    {
      const Stage_scope scope(*this, Cut_loci::Stage::DISTANCE);
      set_distances(component, solver, source, parameters::get_parameter(np, internal_np::vertex_distance_map));
    }
    {
      const Stage_scope scope(*this, Cut_loci::Stage::STRENGTH);
      solver.compute_strengths();
    }
    {
      const Stage_scope scope(*this, Cut_loci::Stage::TREE);
      solver.grow_tree();
    }
    {
      const Stage_scope scope(*this, Cut_loci::Stage::HOMOLOGY);
      solver.close_cycles();
    }

    auto result = std::make_shared<Cut_loci::internal::Source_result>();
    result->root = component.vertex(solver.root());
    result->farthest = component.vertex(solver.farthest());
    result->genus = solver.genus();
    result->number_of_border_loops = solver.connectivity().number_of_border_loops;
    if(component.is_whole())
      result->distance = solver.distance();
    else
    {
      result->distance.assign(read_->vertices.size(), (std::numeric_limits<double>::infinity)());
      for(std::size_t i = 0; i < component.part.vertices.size(); ++i)
        result->distance[component.part.vertices[i]] = solver.distance()[i];
    }
    source_result_ = result;
  }

  template <typename Solver, typename VertexDistanceMap>
  void set_distances(Component& component, Solver& solver, const Cut_loci::Indexed_source& source,
                     const VertexDistanceMap& map)
  {
    std::vector<double> distance;
    compute_distances(component, source, distance, map);
    solver.set_distance(source, std::move(distance));
  }

  // The package's own solver also finds the directions.
  void set_distances(Component& component, Cut_loci::internal::Direction_solver& solver,
                     const Cut_loci::Indexed_source& source, internal_np::Param_not_found map)
  {
    if(has_own_solver_)
    {
      std::vector<double> distance;
      compute_distances(component, source, distance, map);
      solver.set_distance(source, std::move(distance));
      return;
    }
    solver.compute_distance(source);
    check_distances(component, solver.distance(), "the geodesic solver returned");
  }

  Component& component_at(Index id)
  {
    const auto found = components_.find(id);
    if(found != components_.end())
      return *found->second;

    const Stage_scope scope(*this, Cut_loci::Stage::PREPROCESSING);
    std::unique_ptr<Component> component(new Component);
    component->mesh = &read_->mesh;
    if(number_of_components_ > 1)
    {
      component->part = Cut_loci::internal::extract_component(read_->mesh, component_of_face_, id);
      component->mesh = &component->part.mesh;
    }
    using Solver = Cut_loci::internal::Component_solver;
    try
    {
      if(method_ != Cut_loci::Method::LAPLACIAN)
        component->direction.reset(new Cut_loci::internal::Direction_solver(
          *component->mesh, method_ == Cut_loci::Method::POLYHEDRAL));
      else
        component->solver.reset(new Solver(*component->mesh, laplacian_operator_));
    }
    catch(const Solver::Face_without_area& error)
    {
      const Index f = component->face(error.face);
      std::string name = Cut_loci::internal::face_name(f) + " (vertices";
      for(Index v : read_->mesh.triangles[f])
        name += " " + std::to_string(read_->positions[v]);
      throw Cut_loci::Invalid_input(name + ") has no area, or in this unit of length one that is not a normal number: "
                                    "it must be removed or repaired first "
                                    "(CGAL::Polygon_mesh_processing::remove_degenerate_faces() does)");
    }
    catch(const Solver::Non_manifold_vertex& error)
    {
      throw Cut_loci::Invalid_input(
        Cut_loci::internal::vertex_name(read_->positions[component->vertex(error.vertex)]) +
        " is not manifold: its faces form several fans "
        "(CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices() splits it)");
    }
    component->diagonal = diagonal(*component->mesh);
    return *components_.emplace(id, std::move(component)).first->second;
  }

  static double diagonal(const Cut_loci::Indexed_triangle_mesh& mesh)
  {
    std::array<double, 3> low = mesh.points.front(), high = low;
    for(const auto& p : mesh.points)
      for(int i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    using Cut_loci::internal::operator-;
    return Cut_loci::internal::norm(high - low);
  }

  static void to_component(const Component& component, Cut_loci::Indexed_source& source)
  {
    if(component.is_whole())
      return;
    const auto local = [](const std::vector<Index>& sorted, Index global)
    {
      return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), global) - sorted.begin());
    };
    source.location.face = local(component.part.faces, source.location.face);
    if(source.vertex != Cut_loci::null_index)
      source.vertex = local(component.part.vertices, source.vertex);
  }

  void compute_distances(Component& component, const Cut_loci::Indexed_source& source, std::vector<double>& distance,
                         internal_np::Param_not_found)
  {
    if(component.geodesic_solver.empty())
      component.geodesic_solver = solver_.bound_to(*component.mesh);
    component.geodesic_solver.compute_distances(source, distance);
    check_distances(component, distance, "the geodesic solver returned");
  }

  template <typename VertexDistanceMap>
  void compute_distances(Component& component, const Cut_loci::Indexed_source&, std::vector<double>& distance,
                         const VertexDistanceMap& map)
  {
    distance.resize(component.mesh->number_of_vertices());
    for(Index v = 0; v < distance.size(); ++v)
      distance[v] = to_double(get(internal_np::get_reference(map), read_->vertices[component.vertex(v)]));
    check_distances(component, distance, "the vertex distance map holds");
  }

  void check_distances(const Component& component, const std::vector<double>& distance, const std::string& who) const
  {
    if(distance.size() != component.mesh->number_of_vertices())
      throw Cut_loci::Invalid_input(who + " " + std::to_string(distance.size()) + " distances for " +
                                    std::to_string(component.mesh->number_of_vertices()) + " vertices");
    for(Index v = 0; v < distance.size(); ++v)
      if(!std::isfinite(distance[v]))
        throw Cut_loci::Invalid_input(who + " a distance that is not a finite number for " +
                                      Cut_loci::internal::vertex_name(read_->positions[component.vertex(v)]));
  }

  // the halfedge of `read_` that a halfedge of the component stands for
  Index global_halfedge(Index h) const { return 3 * component_->face(h / 3) + h % 3; }

  void mark_edges(const Cut_loci::Indexed_cut_locus&, internal_np::Param_not_found) const {}

  template <typename EdgeIsConstrainedMap>
  void mark_edges(const Cut_loci::Indexed_cut_locus& cut_locus, EdgeIsConstrainedMap map) const
  {
    for(const Cut_loci::Indexed_cut_locus::Edge& e : cut_locus.edges)
      if(e.halfedge != Cut_loci::null_index)
        put(map, edge(read_->halfedges[global_halfedge(e.halfedge)], tm_), true);
  }

  // `location` is in the component
  typename Result::Vertex make_vertex(const Cut_loci::Indexed_location& location, Index vertex, double distance) const
  {
    typename Result::Vertex result;
    result.location.first = face(read_->halfedges[3 * std::size_t(component_->face(location.face))], tm_);
    for(int i = 0; i < 3; ++i)
      result.location.second[i] = FT(location.coordinates[i]);
    result.distance = distance;
    if(vertex != Cut_loci::null_index)
    {
      result.mesh_vertex = read_->vertices[component_->vertex(vertex)];
      result.point = get(vpm_, result.mesh_vertex);
      return result;
    }
    result.mesh_vertex = boost::graph_traits<TriangleMesh>::null_vertex();
    using Cut_loci::internal::operator+;
    using Cut_loci::internal::operator*;
    const auto& triangle = component_->mesh->triangles[location.face];
    std::array<double, 3> p = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      p = p + location.coordinates[i] * component_->mesh->points[triangle[i]];
    result.point = Point_3(p[0], p[1], p[2]);
    return result;
  }

  Result make_result(const Cut_loci::Indexed_cut_locus& cut_locus) const
  {
    typename Result::Graph graph(cut_locus.nodes.size());
    for(std::size_t i = 0; i < cut_locus.nodes.size(); ++i)
      graph[i] = make_vertex(cut_locus.nodes[i].location, cut_locus.nodes[i].vertex, cut_locus.nodes[i].distance);
    for(const Cut_loci::Indexed_cut_locus::Edge& e : cut_locus.edges)
    {
      typename Result::Edge edge;
      edge.strength = e.strength;
      edge.origin = e.origin;
      if(e.halfedge != Cut_loci::null_index)
      {
        edge.mesh_halfedge = read_->halfedges[global_halfedge(e.halfedge)];
        edge.is_on_border = component_->mesh->is_border_edge(e.halfedge);
      }
      add_edge(e.source, e.target, edge, graph);
    }

    const std::shared_ptr<const Cut_loci::internal::Source_result> shared = source_result_;
    const std::shared_ptr<const Read> read = read_;
    const auto distance = [shared, read](vertex_descriptor v)
    {
      const Index i = get(read->index_of_vertex, v);
      return i == Cut_loci::null_index ? (std::numeric_limits<double>::infinity)() : shared->distance[i];
    };
    return Result(std::move(graph), make_vertex(source_.location, source_.vertex, 0.),
                  read_->vertices[shared->farthest], shared, distance);
  }

  const TriangleMesh& tm_;
  Vertex_point_map vpm_;
  Cut_loci::Laplacian_operator laplacian_operator_;
  Cut_loci::Method method_;
  bool has_own_solver_; // another one than the package's exact one
  Solver_handle solver_; // as given; each component has its own
  std::function<void(Cut_loci::Stage, bool)> visit_;

  std::shared_ptr<const Read> read_;
  std::vector<Index> component_of_face_;
  Index number_of_components_ = 0;
  std::map<Index, std::unique_ptr<Component> > components_;

  Component* component_ = nullptr;    // that of the source
  Cut_loci::Indexed_source source_;   // in its component
  double source_angle_threshold_ = default_gradient_angle_threshold();
  std::shared_ptr<const Cut_loci::internal::Source_result> source_result_;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUT_LOCUS_H
