// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCUS_H
#define CGAL_CUT_LOCUS_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {

namespace Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// in place of the number of a source, where no path leads from one
constexpr std::size_t no_source = static_cast<std::size_t>(-1);

/// \ingroup PkgSurfaceMeshCutLocusRef
/// a vertex of the graph of a `Cut_locus`
template <typename TriangleMesh, typename Point_3>
struct Cut_locus_vertex
{
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  /// face and barycentric coordinates, as in `Polygon_mesh_processing`
  std::pair<face_descriptor, std::array<FT, 3>> location;
  Point_3 point;                 ///< the point in space
  vertex_descriptor mesh_vertex; ///< the vertex of the mesh it is at, or `null_vertex()`
  double distance = 0.;          ///< the distance to the source, or to the nearest one
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// an edge of the graph of a `Cut_locus`
template <typename TriangleMesh>
struct Cut_locus_edge
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// a halfedge on the edge of the mesh it follows, or `null_halfedge()`
  halfedge_descriptor mesh_halfedge = boost::graph_traits<TriangleMesh>::null_halfedge();
  /// the largest on the branch from here to its tips, in the unit of the filter: radians for an angle of gradients, or
  /// for the gap, unless the method is `Cut_loci::Laplacian_method`. Within the cell of a curve it is the angle at which
  /// paths meet. Between two sources, where the paths part nowhere and no threshold applies, it is 2 pi
  double strength = 0.;
  /// the largest separation of the two shortest paths to a point of the edge, a length, up to a hundredth of it where it
  /// changes steadily along the branch; zero with `Cut_loci::Laplacian_method`. Between two sources it is the length of the
  /// way from one to the other through the edge
  double width = 0.;
  /// the curvature that the two shortest paths to a point of the edge enclose, on that side of them where it is less, in
  /// radians: the sum of the angles at which they part and meet there. By default an edge is there for its width, for this,
  /// or for what is behind it, see `Surface_mesh_cut_locus::minimum_branch_curvature()`. Zero with
  /// `Cut_loci::Laplacian_method`, and between two sources
  double curvature = 0.;
  /// the numbers of the sources nearest to the points on its two sides, the smaller one first: they differ on the Voronoi
  /// diagram of several sources, and are the same within the cell of one
  std::array<std::size_t, 2> sources = {{0, 0}};
  bool is_on_border = false; ///< whether it follows the border of the mesh
};

namespace internal {

// What a source yields and all results for it share.
struct Source_result
{
  std::vector<double> distance;      // for each dense index of the whole mesh; infinity where unreached
  std::vector<Index> nearest_source; // the same; null where unreached; empty if there is one source
  Index farthest = null_index;
  Index genus = 0;
  Index number_of_border_loops = 0;
  Index number_of_curves = 0; // the last of the sources
  double least_distance = 0.; // no nearer point has several shortest paths
};

template <typename TriangleMesh, typename VertexPointMap>
class Cut_locus_builder;

} // namespace internal
} // namespace Cut_loci

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * is the cut locus of a source point, or of a set of several, on a triangle mesh: a graph, and the distances to the
 * source, or to the nearest one. The class is an immutable value; it refers to the mesh by descriptors. All functions can
 * be called from several threads.
 *
 * On a closed surface of genus g the graph is connected, has 2g independent cycles, and its complement in the surface
 * is one open disk. On a surface with boundary the same holds for the union of the graph and the boundary, each
 * border loop being counted as a point.
 *
 * With k source points it is their geodesic Voronoi diagram together with the cut locus inside each cell: the complement
 * is k open disks, one for each source, and the graph has 2g - 1 + k independent cycles. If some of them are curves, the
 * surface without the sources shrinks to the graph, which has a component for each of its parts.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Point_3 the value type of the vertex point map
 */
template <typename TriangleMesh, typename Point_3>
class Cut_locus
{
public:
  using mesh_vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertex = Cut_loci::Cut_locus_vertex<TriangleMesh, Point_3>;
  using Edge = Cut_loci::Cut_locus_edge<TriangleMesh>;
  /// the type of the graph, a model of `VertexAndEdgeListGraph` and `IncidenceGraph` with the properties above
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Vertex, Edge>;
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Distance_function = std::function<double(mesh_vertex_descriptor)>;
  using Nearest_source_function = std::function<std::optional<std::size_t>(mesh_vertex_descriptor)>;

  /// the graph
  const Graph& graph() const { return graph_; }

  /// the vertex of the graph at which its tree of branches starts. With `Cut_loci::Laplacian_method` it is, on a closed
  /// surface, the one farthest from the source
  vertex_descriptor root() const { return 0; }

  /// the source, or the first of several
  const Vertex& source() const { return sources_.front(); }

  /// the number of sources
  std::size_t number_of_sources() const { return sources_.size(); }

  /// source number `i`, in the order in which they were given, points first; of a curve, one of its vertices
  const Vertex& source(std::size_t i) const { return sources_[i]; }

  /// whether source number `i` is a curve
  bool is_curve(std::size_t i) const { return i + result_->number_of_curves >= sources_.size(); }

  /// the vertex of the mesh that is farthest from the source, or from the nearest one
  mesh_vertex_descriptor farthest_vertex() const { return farthest_; }

  /// the vertex of the graph that is farthest from the source, or from the nearest one: on a closed surface no point is
  /// farther, but at branches that are left out. It is the null vertex if there is none
  vertex_descriptor farthest_node() const
  {
    vertex_descriptor result = boost::graph_traits<Graph>::null_vertex();
    for(auto v : boost::make_iterator_range(vertices(graph_)))
      if(result == boost::graph_traits<Graph>::null_vertex() || graph_[v].distance > graph_[result].distance)
        result = v;
    return result;
  }

  /// the geodesic distance of a mesh vertex to the source, or to the nearest one; infinity if no path leads there
  double distance(mesh_vertex_descriptor v) const { return distance_(v); }

  /// the number of the source nearest to a mesh vertex, if a path leads there; of several at the same distance any one
  std::optional<std::size_t> nearest_source(mesh_vertex_descriptor v) const
  {
    if(nearest_source_)
      return nearest_source_(v);
    return std::isfinite(distance_(v)) ? std::optional<std::size_t>(0) : std::nullopt;
  }

  /// the genus of the source's component
  std::size_t genus() const { return result_->genus; }

  /// the number of border loops of the source's component
  std::size_t number_of_border_loops() const { return result_->number_of_border_loops; }

  /// how many corridors between branches are narrower than a face, so that a curve of mesh edges closes them, and is open
  /// beside them instead: shortest paths through these cross the curve, and what is behind them is reached by a detour.
  /// It is 0 for a curve through the faces, and with `Cut_loci::Laplacian_method`, which does not know them
  std::size_t number_of_narrow_corridors() const { return number_of_narrow_corridors_; }

  /// the distance within which no point has several shortest paths, whatever the thresholds; see
  /// `Cut_loci::Injectivity_radius::lower_bound`
  double least_distance() const { return result_->least_distance; }

  /// whether other curves are as right: several shortest paths of the same length, up to rounding, lead to a vertex at
  /// which they bend, so that all points of a region behind it have several shortest paths. That takes a symmetric surface
  /// and source, or a regular grid. The curve runs on one side of the region, as on a surface that is a little less
  /// symmetric, in a way that depends on its shape alone. The injectivity radius and the length are those of this curve. For
  /// sources that a rotation takes to each other they are equal. It is not looked for with `Cut_loci::Laplacian_method`,
  /// `maximum_relative_error` or curves as sources
  bool is_one_of_several() const { return is_one_of_several_; }

private:
  template <typename Mesh, typename VertexPointMap>
  friend class Cut_loci::internal::Cut_locus_builder;

  Cut_locus(Graph graph, std::vector<Vertex> sources, mesh_vertex_descriptor farthest,
            std::shared_ptr<const Cut_loci::internal::Source_result> result, Distance_function distance,
            Nearest_source_function nearest_source, std::size_t number_of_narrow_corridors, bool is_one_of_several)
    : graph_(std::move(graph)), sources_(std::move(sources)), farthest_(farthest), result_(std::move(result)),
      distance_(std::move(distance)), nearest_source_(std::move(nearest_source)),
      number_of_narrow_corridors_(number_of_narrow_corridors), is_one_of_several_(is_one_of_several)
  {
  }

  Graph graph_;
  std::vector<Vertex> sources_;
  mesh_vertex_descriptor farthest_;
  std::shared_ptr<const Cut_loci::internal::Source_result> result_;
  Distance_function distance_;
  Nearest_source_function nearest_source_; // if there are several sources
  std::size_t number_of_narrow_corridors_;
  bool is_one_of_several_;
};

} // namespace CGAL

#endif // CGAL_CUT_LOCUS_H
