// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_REFINE_ALONG_POLYLINES_H
#define CGAL_REFINE_ALONG_POLYLINES_H

#include <CGAL/Cut_loci/face_graph/output_maps.h>
#include <CGAL/Cut_loci/face_graph/reading/read_polylines.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * splits the faces that polylines run through, so that they consist of edges of the result, and can be sources: the
 * `source_curves` of `Surface_mesh_cut_locus::set_sources()`.
 *
 * The surface stays the same except for the rounding of points, and each face of the result is a part of one of `tm`. The
 * points of the polylines are rounded first: their barycentric coordinates become multiples of the snapping tolerance, so
 * that a polyline goes through a vertex that it passes closely, and no face is degenerate. A straight line so gets corners
 * of about the tolerance; with `Cut_loci::Default_method` the branches that start there are left out.
 *
 * Polylines may cross and touch each other, and end where they start. Time is O(n log k), for n faces and k points of
 * polylines.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam PolylineRange a model of `ConstRange` of models of `ConstRange` with a pair of a
 *         `boost::graph_traits<TriangleMesh>::%face_descriptor` and a `std::array` of three barycentric coordinates as
 *         value type, as in `Polygon_mesh_processing`
 * @tparam OutputMesh a model of `MutableFaceGraph`
 *
 * @param tm the triangle mesh
 * @param polylines the points of each polyline. Two that follow each other must have a face in common, so that there is
 *        one on each edge that the polyline crosses.
 * @param output the mesh to which the result is added, all components of it; it should be empty
 * @param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
 *        `refine_along_cut_locus()` of this name
 * @param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
 *        `refine_along_cut_locus()` of this name
 *
 * @return the edges of `output` that the polylines consist of. Those that are connected are one range, as sources have no
 *         point in common; they are in the order of the first polyline of each.
 *
 * @throws Cut_loci::Invalid_input if a face of `tm` is not a triangle, if a point is none of the mesh, if two points that
 *         follow each other have no face in common, or if a polyline is only a point, also after rounding
 */
template <typename TriangleMesh, typename PolylineRange, typename OutputMesh,
          typename NamedParametersIn = parameters::Default_named_parameters,
          typename NamedParametersOut = parameters::Default_named_parameters>
std::vector<std::vector<typename boost::graph_traits<OutputMesh>::edge_descriptor>>
refine_along_polylines(const TriangleMesh& tm, const PolylineRange& polylines, OutputMesh& output,
                       const NamedParametersIn& np_in = parameters::default_values(),
                       const NamedParametersOut& np_out = parameters::default_values())
{
  using parameters::get_parameter;
  namespace internal = Cut_loci::internal;
  using Cut_loci::Index;

  const Index resolution = internal::read_resolution(np_in);
  const auto read = internal::read_triangle_mesh(tm, internal::point_map(tm, np_in));
  const internal::Indexed_polylines indexed = internal::read_polylines(tm, read, polylines);
  const Cut_loci::Cut_mesh fans = Cut_loci::cut_open(read.mesh); // components may touch in a vertex
  const Cut_loci::Mesh_connectivity connectivity(fans.mesh);
  internal::check_segments(fans.mesh, connectivity, indexed);
  const Cut_loci::Refined_mesh refined =
    Cut_loci::refine_along_curve(fans.mesh, connectivity, indexed.graph, resolution);
  const std::vector<std::vector<Index>> seams = internal::connected_seams(refined, indexed);

  std::vector<Index> origin = fans.vertices;
  origin.resize(refined.mesh.number_of_vertices(), Cut_loci::null_index);
  const auto built = internal::output_mesh(tm, read, refined.mesh, origin, refined.faces, output, np_in, np_out);
  internal::output_seams(refined.mesh, refined.seams, built, output,
                         get_parameter(np_out, internal_np::edge_is_constrained));
  std::vector<std::vector<typename boost::graph_traits<OutputMesh>::edge_descriptor>> result;
  for(const std::vector<Index>& part : seams)
  {
    result.emplace_back();
    for(Index h : part)
      result.back().push_back(edge(built.halfedges[h], output));
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_REFINE_ALONG_POLYLINES_H
