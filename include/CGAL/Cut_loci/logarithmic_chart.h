// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LOGARITHMIC_CHART_H
#define CGAL_CUT_LOCI_LOGARITHMIC_CHART_H

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

namespace CGAL::Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * lays a surface that has been cut open along the cut locus of a point into the plane by the logarithmic map: each vertex
 * has its exact geodesic distance from the source, and the direction in which the shortest path leaves it.
 *
 * A vertex on a seam has several copies, each with the path that comes from its side: distances are those within `disk`, and no
 * shortest path crosses the cut locus. Where branches have been left out, faces across them are torn apart, and may be flipped;
 * `layout_quality()` tells. With all branches of a convex polyhedron, from a source in a face, the chart is its source unfolding,
 * which is isometric; at a vertex, directions are scaled to a full turn. The x-axis is
 * `Surface_mesh_exact_geodesics::source_halfedge()` of `disk`.
 *
 * Behind a vertex of negative curvature, there are points to which all shortest paths bend there, and leave the source in one
 * direction: faces among these lie on a ray, without area.
 *
 * Time is that of `Surface_mesh_exact_geodesics::compute()`.
 *
 * @tparam Disk a model of `FaceListGraph`
 * @tparam Source a vertex descriptor of `Disk`, or a pair of a face descriptor and barycentric coordinates
 * @tparam VertexUVMap a model of `WritablePropertyMap` with `boost::graph_traits<Disk>::%vertex_descriptor` as key type and a
 *         point of the plane as value type
 *
 * @param disk the surface as `cut_along_cut_locus()` gives it
 * @param source the source, on it
 * @param uv gets where each vertex is, in the unit of the points
 *
 * @throws Invalid_input as `Surface_mesh_exact_geodesics`
 */
template <typename Disk, typename Source, typename VertexUVMap>
void logarithmic_chart(const Disk& disk, const Source& source, VertexUVMap uv)
{
  using Point_2 = typename boost::property_traits<VertexUVMap>::value_type;
  Surface_mesh_exact_geodesics<Disk> geodesics(disk);
  geodesics.set_directions(true);
  geodesics.compute(source);
  for(auto v : CGAL::make_range(vertices(disk)))
  {
    const auto place = geodesics.logarithmic_map(v);
    put(uv, v, Point_2(place[0], place[1]));
  }
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_LOGARITHMIC_CHART_H
