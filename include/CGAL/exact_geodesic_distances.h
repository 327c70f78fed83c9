// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_EXACT_GEODESIC_DISTANCES_H
#define CGAL_EXACT_GEODESIC_DISTANCES_H

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the exact geodesic distance of each vertex to the nearest one of several sources, curves and the border among
 * them.
 *
 * @tparam SourceRange a range of vertices or of face locations; it may be empty if there are curves
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{source_curves}
 *     \cgalParamDescription{sources that are connected curves: for each one the edges of the mesh that it is made of}
 *     \cgalParamType{a model of `ConstRange` of models of `ConstRange` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as value type}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{source_border}
 *     \cgalParamDescription{whether each border loop is a source}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * For everything else, see the overload for one vertex.
 */
template <typename TriangleMesh, typename SourceRange, typename VertexDistanceMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
void
#else
typename std::enable_if<boost::has_range_const_iterator<SourceRange>::value>::type
#endif
exact_geodesic_distances(const TriangleMesh& tm, const SourceRange& sources, VertexDistanceMap vdm,
                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::get_parameter;
  Surface_mesh_exact_geodesics<TriangleMesh> geodesics(tm, np);
  for(const auto& source : sources)
    geodesics.add_source(source);
  if constexpr(Cut_loci::internal::is_given<CGAL_NP_CLASS, internal_np::source_curves_t>())
    for(const auto& curve : get_parameter(np, internal_np::source_curves))
      geodesics.add_source_curve(curve);
  if(parameters::choose_parameter(get_parameter(np, internal_np::source_border), false))
    geodesics.add_source_border();
  geodesics.compute();
  geodesics.distances(vdm);
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the exact geodesic distances from `source` to all vertices of a triangle mesh.
 *
 * Vertices that cannot be reached get an infinite distance. For directions, shortest paths,
 * points in faces, or a maximum distance, see `CGAL::Surface_mesh_exact_geodesics`, which also says how long it takes;
 * whoever needs the distances from many points, one after the other, should use it, too.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam VertexDistanceMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type to which `double` can
 *         be converted
 *
 * @param tm a triangle mesh
 * @param source a vertex of `tm`
 * @param vdm the output: the distance of each vertex
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *        `Surface_mesh_exact_geodesics`
 *
 * \throws Cut_loci::Invalid_input if the mesh or the source cannot be used
 */
template <typename TriangleMesh, typename VertexDistanceMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
void exact_geodesic_distances(const TriangleMesh& tm,
                              typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                              VertexDistanceMap vdm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  exact_geodesic_distances(tm, std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 1>{{source}},
                           vdm, np);
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the exact geodesic distances from a point in a face, on an edge or at a vertex to all vertices.
 *
 * The coordinates are barycentric with respect to `source(halfedge(f, tm), tm)` and the two vertices that follow
 * counterclockwise, where `f` is the face of the location. For everything else, see the overload for vertices.
 */
template <typename TriangleMesh, typename VertexDistanceMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
void exact_geodesic_distances(
  const TriangleMesh& tm,
  const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>& source,
  VertexDistanceMap vdm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  exact_geodesic_distances(tm, std::array<typename std::decay<decltype(source)>::type, 1>{{source}}, vdm, np);
}

} // namespace CGAL

#endif // CGAL_EXACT_GEODESIC_DISTANCES_H
