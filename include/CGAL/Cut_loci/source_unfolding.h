// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SOURCE_UNFOLDING_H
#define CGAL_CUT_LOCI_SOURCE_UNFOLDING_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/Surface_component.h>
#include <CGAL/Cut_loci/face_graph/reading/read_source.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/polyhedral/curves/Unfolded_polygon.h>
#include <CGAL/Cut_loci/polyhedral/solver/Exact_tree_solver.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Surface_without_flat_faces.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <sstream>
#include <vector>

namespace CGAL::Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * is the source unfolding of a polyhedron: a polygon, and how its edges are glued to get the polyhedron back.
 *
 * The source is at the origin. A point of the polygon is at the distance, and in the direction, in which the shortest
 * path to it leaves the source, seen from outside of the surface. The direction of the x-axis is arbitrary.
 */
template <typename TriangleMesh, typename Point_3>
struct Source_unfolding
{
  using Kernel = typename Kernel_traits<Point_3>::Kernel;
  using Point_2 = typename Kernel::Point_2;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Vertex = Cut_locus_vertex<TriangleMesh, Point_3>;

  static constexpr std::size_t no_edge = (std::numeric_limits<std::size_t>::max)();

  /// a corner of the polygon, and the edge from there to the next corner
  struct Corner
  {
    Point_2 point;
    std::size_t vertex;   ///< of the cut surface, in `vertices`: the point of the surface it is a copy of
    std::size_t glued_to; ///< the edge, given by the corner it starts at, that its edge is glued to, in opposite
                          ///< direction; `no_edge` on the border of the surface
  };

  /// a part of an edge of the mesh, as it lies in the polygon
  struct Fold_line
  {
    Point_2 source, target;
    halfedge_descriptor halfedge; ///< of the edge, in the same direction
    double angle;                 ///< between the normals of its faces: zero if these are coplanar; negative if concave
  };

  /// the points of the surface that the corners are copies of: the vertices of the cut locus, and those of the border
  std::vector<Vertex> vertices;
  std::vector<Corner> corners;       ///< counterclockwise
  std::vector<Fold_line> fold_lines; ///< all edges of the mesh inside of the polygon, in parts, each place once
  Vertex source;                     ///< for which the cut locus has been computed: the one asked for, unless
  /// it had to be moved a little; see `source_unfolding()`
  bool is_source_moved = false;
};

namespace internal {

// Without vertices at which shortest paths bend, what is left without the cut locus is flat.
template <typename VertexName>
void throw_if_paths_bend(const Geodesic_faces& faces, const VertexName& name)
{
  for(Index v = 0; v < faces.number_of_vertices(); ++v)
  {
    if(!faces.is_pseudo_source(v))
      continue;
    const bool is_border = faces.is_border(v);
    std::ostringstream text;
    text.precision(10);
    text << name(v) << " has a total angle of " << faces.total_angle(v) * (180. / geodesic_pi) << " degrees, more than "
         << (is_border ? 180 : 360) << (is_border ? ", on the border" : "")
         << ": shortest paths bend there, and what the cut locus leaves of the surface is not flat. Source unfoldings "
            "are for convex surfaces (CGAL::convex_hull_3() makes one); to flatten others see "
            "CGAL::cut_along_cut_locus()";
    throw Invalid_input(Cause::NOT_CONVEX, text.str());
  }
}

// The angle by which the surface turns at an edge.
inline double fold_angle(const Indexed_triangle_mesh& mesh, Index h)
{
  const Index o = mesh.opposite[h];
  const auto normal = [&](Index f)
  {
    const auto& t = mesh.triangles[f];
    return cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
  };
  const Vector m = normal(h / 3), n = normal(o / 3), along = mesh.points[mesh.target(h)] - mesh.points[mesh.source(h)];
  return std::atan2(dot(cross(m, n), along) / norm(along), dot(m, n));
}

// A source that is placed symmetrically may have branches too close to each other to be told apart. Then it is moved, by
// more each time: the polygon of a perturbed surface would not be exact.
inline Unfolded_polygon unfolded_polygon(const Indexed_triangle_mesh& mesh, Exact_tree_solver& solver,
                                         const Indexed_source& wanted)
{
  constexpr std::array<double, 3> part = {{0.4723, 0.1919, 0.3358}};
  for(double shift = 0.;; shift = shift == 0. ? 4e-6 : 4. * shift)
  {
    Indexed_source source = wanted;
    for(std::size_t i = 0; i < 3; ++i)
      source.location.coordinates[i] += shift * (part[i] - source.location.coordinates[i]);
    try
    {
      solver.compute_distance(source);
      solver.compute_strengths();
      solver.tree().join();
      if(!solver.tree().is_sure())
        throw Unfolding_failure();
      if(shift > 0. && wanted.vertex != null_index)
        solver.tree().remove_branch_to(wanted.vertex);
      return Unfolded_polygon(mesh, solver.connectivity(), solver.geodesics(), solver.tree(), wanted);
    }
    catch(const Unfolding_failure&)
    {
      if(shift > 2e-4)
        throw;
    }
  }
}

/*
 * The surface that is unfolded, with its source: a component, without its faces that have no area. Other lengths for these
 * would change the polygon, and fold it over itself.
 */
class Surface_to_unfold
{
public:
  Surface_to_unfold(const Surface_component& component, const Indexed_source& source)
    : component_(component), source_(source)
  {
    if(!component.mollified)
      return;
    const Mesh_connectivity connectivity(*component.mesh);
    if(!connectivity.first_non_manifold.empty())
      throw Non_manifold_vertex{connectivity.first_non_manifold.front()};
    without_.reset(new Surface_without_flat_faces(*component.mesh, source.location));
    source_.location = without_->location();
    if(source.vertex != null_index)
      source_.vertex = without_->vertex_without(source.vertex);
    else
      source_.vertex = vertex_of(without_->mesh(), source_.location);
    if(source_.vertex != null_index)
      source_.location = location_of_vertex(Mesh_connectivity(without_->mesh()), source_.vertex);
    measured_ = without_->mesh();
    if(needs_mollification(measured_)) // some could not be left out
      measured_.lengths = Mollification(measured_).lengths;
  }

  const Indexed_triangle_mesh& mesh() const { return without_ ? measured_ : *component_.mesh; }
  const Indexed_source& source() const { return source_; }
  // the numbers of the component
  Index vertex(Index v) const { return without_ ? without_->vertex_with(v) : v; }
  Index halfedge(Index h) const { return without_ ? without_->halfedge_with(h) : h; }
  Indexed_location location(const Indexed_location& at) const { return without_ ? without_->location_with(at) : at; }

private:
  const Surface_component& component_;
  Indexed_source source_;
  std::unique_ptr<const Surface_without_flat_faces> without_; // if there are any
  Indexed_triangle_mesh measured_;
};

template <typename TriangleMesh, typename VertexPointMap>
class Source_unfolding_builder
{
public:
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  using Result = Source_unfolding<TriangleMesh, Point_3>;
  using Point_2 = typename Result::Point_2;
  using Read = Read_triangle_mesh<TriangleMesh>;

  Source_unfolding_builder(const TriangleMesh& tm, const VertexPointMap& vpm, const Read& read,
                           const Surface_component& component, const Surface_to_unfold& surface)
    : tm_(tm), vpm_(vpm), read_(read), component_(component), surface_(surface)
  {
  }

  Result operator()(const Unfolded_polygon& polygon, const Indexed_source& wanted) const
  {
    Result result;
    for(const Indexed_cut_locus::Node& n : polygon.nodes)
      result.vertices.push_back(vertex(n));
    for(std::size_t i = 0; i < polygon.corners.size(); ++i)
      result.corners.push_back({point(polygon.corners[i].point), polygon.corners[i].node,
                                polygon.glued[i] != null_index ? std::size_t(polygon.glued[i]) : Result::no_edge});
    for(const Unfolded_polygon::Fold& f : polygon.folds)
      if(const Index h = surface_.halfedge(f.halfedge); h != null_index)
        result.fold_lines.push_back({point(f.ends[0]), point(f.ends[1]), read_.halfedges[component_.halfedge(h)],
                                     fold_angle(surface_.mesh(), f.halfedge)});
    result.is_source_moved = polygon.is_source_moved;
    result.source = vertex({polygon.source, null_index, 0.});
    if(!polygon.is_source_moved && wanted.vertex != null_index)
      set_vertex(result.source, wanted.vertex);
    return result;
  }

private:
  static Point_2 point(const Plane_point& p) { return Point_2(FT(p.x), FT(p.y)); }

  typename Result::Vertex vertex(const Indexed_cut_locus::Node& n) const
  {
    typename Result::Vertex result;
    const Indexed_location at = surface_.location(n.location);
    result.location.first = face(read_.halfedges[3 * std::size_t(component_.face(at.face))], tm_);
    for(std::size_t i = 0; i < 3; ++i)
      result.location.second[i] = FT(at.coordinates[i]);
    const Vector p = position(*component_.mesh, at);
    result.distance = n.distance;
    result.mesh_vertex = boost::graph_traits<TriangleMesh>::null_vertex();
    result.point = Point_3(FT(p[0]), FT(p[1]), FT(p[2]));
    if(n.vertex != null_index)
      set_vertex(result, surface_.vertex(n.vertex));
    return result;
  }

  // of the component
  void set_vertex(typename Result::Vertex& result, Index v) const
  {
    result.mesh_vertex = read_.vertices[component_.vertex(v)];
    result.point = get(vpm_, result.mesh_vertex);
  }

  const TriangleMesh& tm_;
  const VertexPointMap& vpm_;
  const Read& read_;
  const Surface_component& component_;
  const Surface_to_unfold& surface_;
};

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the source unfolding of a polyhedron: the polygon that it becomes when it is cut along the cut locus of the
 * source, and laid flat around the source.
 *
 * The shortest path from the source to a point becomes a straight segment, of the same length and in the same direction,
 * so that the polygon is star-shaped. On a convex polyhedron it never overlaps itself: the cut locus has the ends of two
 * or more such segments on it, and the rest of it is their bisectors \cgalCite{cgal:ss-spps-86}, \cgalCite{m-sppd-85}.
 * (The <em>star unfolding</em>, cut along the shortest paths to the vertices, is another one.) The corners are the points
 * where edges of the mesh, or other branches, meet a branch of the cut locus, and the ends of branches, which are the
 * vertices of the polyhedron. Glued edges are equally long, the area is that of the surface, and lengths within a face are
 * those in space, up to 1e-9 of the size of the polygon; the copies of a corner have the same distance up to 1e-8 of it.
 *
 * If the source is a vertex of a total angle less than 2 pi, the polygon is not flat around it either. It is then cut from
 * the source to the nearest end of a branch, and starts with the corner at the source, which has this angle.
 *
 * A source that is placed so that shortest paths run along edges of the mesh, or many branches all but meet, may be
 * moved: by 4e-6 of its face, and by more, up to 3e-4, only where that is not enough. Then
 * `Source_unfolding::is_source_moved` is `true`. The polygon is exact all the same, that of the source where it is then:
 * symmetries hold up to the way by which it has moved, and where more than three branches should meet there are edges of
 * such lengths. A source that is a vertex remains the corner at the origin.
 *
 * The surface must be one on which shortest paths do not bend: no vertex has a total angle of more than 2 pi, or of more
 * than pi on the border. These are convex polyhedra, open ones with a convex border, and what is isometric to such, as
 * cylinders and flat pieces of paper. With a border, that is a part of the boundary of the polygon; it may overlap itself
 * then. Vertices whose angle is less than 2 pi by less than 1e-7 are taken for flat.
 *
 * Faces without area are no part of the surface, and the polygon is what it is without them. Their edges lie on others, and
 * a fold line is given as a part of one of those.
 *
 * Time and space are those of the exact solver and the method `Cut_loci::Polyhedral_method`, and O(k log k) for a result
 * of k corners and fold lines; k is O(n^2) for n faces, and on most meshes O(n).
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Source `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or a pair of a face and barycentric coordinates
 *         as in `Polygon_mesh_processing`
 *
 * @param tm a triangle mesh; only the component of the source is unfolded
 * @param source the source
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{snapping_tolerance}
 *     \cgalParamDescription{a barycentric coordinate of the source up to this value is taken for zero}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1e-10}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return a `Source_unfolding`
 *
 * @throws Invalid_input if a vertex has more than the angle above, with a message that names it; if the cut locus is not
 *         found accurately enough to cut along it wherever the source is moved, as may happen with thousands of faces, or
 *         with thin ones, as hulls of scans have them: nothing that does not fit together is returned; and as
 *         `Surface_mesh_cut_locus` does if the mesh or the source cannot be used
 */
template <typename TriangleMesh, typename Source, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto source_unfolding(const TriangleMesh& tm, const Source& source,
                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, CGAL_NP_CLASS>::const_type;

  const Vertex_point_map vpm = internal::point_map(tm, np);
  const auto read = internal::read_triangle_mesh(tm, vpm);
  const Indexed_source in_mesh =
    internal::read_source(tm, read, source,
                          internal::checked_snapping_tolerance(
                            to_double(choose_parameter(get_parameter(np, internal_np::snapping_tolerance), 1e-10))));

  Index number_of_components = 0;
  const std::vector<Index> labels = internal::face_components(read.mesh, number_of_components);
  internal::Surface_component component(read.mesh, labels, labels[in_mesh.location.face], number_of_components);
  const Indexed_source in_component = component.local(in_mesh);
  std::unique_ptr<const internal::Surface_to_unfold> surface;
  std::unique_ptr<internal::Exact_tree_solver> solver;
  component.name_faults(read.mesh, read.positions,
                        [&]
                        {
    surface.reset(new internal::Surface_to_unfold(component, in_component));
    solver.reset(new internal::Exact_tree_solver(surface->mesh()));
  });
  internal::throw_if_paths_bend(solver->faces(),
                                [&](Index v) {
    return internal::vertex_name(read.positions[component.vertex(surface->vertex(v))]);
  });

  const internal::Unfolded_polygon polygon = internal::unfolded_polygon(surface->mesh(), *solver, surface->source());
  return internal::Source_unfolding_builder<TriangleMesh, Vertex_point_map>(tm, vpm, read, component,
                                                                            *surface)(polygon, in_component);
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_SOURCE_UNFOLDING_H
