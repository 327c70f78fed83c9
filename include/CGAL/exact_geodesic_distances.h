// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_EXACT_GEODESIC_DISTANCES_H
#define CGAL_EXACT_GEODESIC_DISTANCES_H

#include <CGAL/Cut_loci/face_graph/reading/read_source.h>
#include <CGAL/Surface_mesh_exact_geodesics.h>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the exact geodesic distance of each vertex of a triangle mesh to a source, or to the nearest one of several
 * sources, curves and the border among them.
 *
 * Vertices that cannot be reached get an infinite distance. For directions, shortest paths,
 * points in faces, or a maximum distance, see `CGAL::Surface_mesh_exact_geodesics`, which also says how long it takes;
 * whoever needs the distances from many points, one after the other, should use it, too.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Source `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or a pair of a face `f` and barycentric coordinates
 *         with respect to `source(halfedge(f, tm), tm)` and the two vertices that follow counterclockwise; or a model of
 *         `ConstRange` of either
 * @tparam VertexDistanceMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type to which `double` can
 *         be converted
 *
 * @param tm a triangle mesh
 * @param source the source, or the range of sources, which may be empty if there are curves
 * @param vdm the output: the distance of each vertex
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the constructor of
 *        `Surface_mesh_exact_geodesics`, and the ones listed below
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
 * \throws Cut_loci::Invalid_input if the mesh or a source cannot be used
 */
template <typename TriangleMesh, typename Source, typename VertexDistanceMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
void exact_geodesic_distances(const TriangleMesh& tm, const Source& source, VertexDistanceMap vdm,
                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::get_parameter;
  Surface_mesh_exact_geodesics<TriangleMesh> geodesics(tm, np);
  if constexpr(Cut_loci::internal::Is_range<Source>::value)
    for(const auto& s : source)
      geodesics.add_source(s);
  else
    geodesics.add_source(source);
  if constexpr(Cut_loci::internal::is_given<CGAL_NP_CLASS, internal_np::source_curves_t>())
    for(const auto& curve : get_parameter(np, internal_np::source_curves))
      geodesics.add_source_curve(curve);
  if(parameters::choose_parameter(get_parameter(np, internal_np::source_border), false))
    geodesics.add_source_border();
  geodesics.compute();
  geodesics.distances(vdm);
}

} // namespace CGAL

#endif // CGAL_EXACT_GEODESIC_DISTANCES_H
