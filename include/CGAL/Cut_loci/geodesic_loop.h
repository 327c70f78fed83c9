// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GEODESIC_LOOP_H
#define CGAL_CUT_LOCI_GEODESIC_LOOP_H

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/location_in_part.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_locus.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci {

namespace internal {

// The number of the node at which the injectivity radius is reached. Between the ends of an edge, it is a new one.
template <typename TriangleMesh, typename Point_3>
Index nearest_node(const Indexed_triangle_mesh& mesh, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                   Indexed_cut_locus& curve)
{
  const auto nearest = injectivity_radius(cut_locus);
  const auto& graph = cut_locus.graph();
  if(!nearest.edge)
    return static_cast<Index>(nearest.vertex);
  const auto all = edges(graph);
  Indexed_cut_locus::Edge& edge =
    curve.edges[std::distance(all.first, std::find(all.first, all.second, *nearest.edge))];
  const Point_3 &p = graph[source(*nearest.edge, graph)].point, &q = graph[target(*nearest.edge, graph)].point;
  const double share =
    std::sqrt(CGAL::to_double((nearest.point - p) * (nearest.point - p)) / CGAL::to_double((q - p) * (q - p)));
  const Indexed_location &a = curve.nodes[edge.source].location, &b = curve.nodes[edge.target].location;
  const Mesh_connectivity connectivity(mesh);
  Indexed_location between;
  const auto put_in = [&](Index face)
  {
    const Indexed_location from = in_face(mesh, a, face), to = in_face(mesh, b, face);
    between.face = face;
    for(std::size_t i = 0; i < 3; ++i)
      between.coordinates[i] = (1. - share) * from.coordinates[i] + share * to.coordinates[i];
  };
  if(edge.halfedge != null_index) // one of several edges that may join two vertices
    put_in(edge.halfedge / 3);
  else
    for_each_common_face(mesh, connectivity, a, b, put_in);
  if(between.face == null_index)
    return static_cast<Index>(nearest.vertex);
  const Index result = static_cast<Index>(curve.nodes.size());
  curve.nodes.push_back({between, null_index, nearest.distance});
  Indexed_cut_locus::Edge rest = edge;
  edge.target = rest.source = result;
  curve.edges.push_back(rest);
  return result;
}

template <typename Point_3, typename Mesh, typename Location>
Point_3 point_at(const Mesh& mesh, const Location& location)
{
  const auto h = halfedge(location.first, mesh);
  const std::array<typename Mesh::Vertex_index, 3> corners = {
    {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)}};
  std::array<double, 3> x = {{0., 0., 0.}};
  for(std::size_t k = 0; k < 3; ++k)
    for(int i = 0; i < 3; ++i)
      x[std::size_t(i)] += location.second[k] * mesh.point(corners[k])[i];
  return Point_3(x[0], x[1], x[2]);
}

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * finds the two shortest paths to the point of a cut locus that is nearest to the source: a polyline from the source to that
 * point, and back on the other side. It is twice as long as the injectivity radius.
 *
 * Where the radius is reached inside a branch, the two paths meet without an angle there: on a closed surface this is the
 * shortest geodesic loop at the source. At the end of a branch, they are one path. On the cut locus, three and more may be
 * equally short, of which two are taken.
 *
 * The surface is cut open along the cut locus, whose barycentric coordinates are rounded to multiples of 2^-20, so that each
 * side of the point has its own path. Time is that of `cut_along_cut_locus()` and `Surface_mesh_exact_geodesics::compute()`.
 *
 * @param tm the triangle mesh of which the cut locus was computed, with points
 * @param cut_locus the cut locus of one point, as exact as that of `Cut_loci::Curve::THROUGH_FACES`
 *
 * @return the points of the loop, from the source to the source
 *
 * @throws Invalid_input if the cut locus is not one of `tm`, is empty, or has several sources
 */
template <typename TriangleMesh, typename Point_3>
std::vector<Point_3> geodesic_loop(const TriangleMesh& tm, const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  using Point = typename Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  const auto read = internal::read_triangle_mesh(tm, get_const_property_map(CGAL::vertex_point, tm));
  internal::Curve_on_mesh curve = internal::curve_on_mesh(read, tm, cut_locus);
  const Index node = internal::nearest_node(read.mesh, cut_locus, curve.graph);
  const internal::Disk_of_curve disk = internal::cut_along(read.mesh, std::move(curve), internal::finest_resolution);
  Mesh mesh;
  const auto built = internal::build_face_graph(disk.cut.mesh, mesh);
  for(Index v = 0; v < disk.cut.mesh.number_of_vertices(); ++v)
  {
    const auto& p = disk.cut.mesh.points[v];
    mesh.point(built.vertices[v]) = Point(p[0], p[1], p[2]);
  }
  const Indexed_location source = internal::location_in_part(
    disk.on.component.mesh, disk.refined.mesh, disk.refined.faces, disk.on.curve.sources.front().location);
  using Geodesics = Surface_mesh_exact_geodesics<Mesh>;
  Geodesics geodesics(mesh);
  geodesics.compute(
    typename Geodesics::Face_location(face(built.halfedges[3 * std::size_t(source.face)], mesh), source.coordinates));
  std::vector<std::vector<Point_3>> paths;
  for(Index v = 0; v < disk.cut.vertices.size() && paths.size() < 2; ++v)
    if(disk.cut.vertices[v] == disk.refined.nodes[node])
    {
      std::vector<typename Geodesics::Face_location> path;
      geodesics.shortest_path(built.vertices[v], std::back_inserter(path));
      paths.emplace_back();
      for(const auto& at : path)
        paths.back().push_back(internal::point_at<Point_3>(mesh, at));
    }
  std::vector<Point_3> result(paths.front().rbegin(), paths.front().rend());
  result.insert(result.end(), paths.back().begin() + 1, paths.back().end());
  return result;
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_GEODESIC_LOOP_H
