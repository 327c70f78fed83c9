// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_COMPUTE_CUT_LOCUS_H
#define CGAL_COMPUTE_CUT_LOCUS_H

#include <CGAL/Surface_mesh_cut_locus.h>

#include <type_traits>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * computes the cut locus of a point, or of a set of points and curves, on a triangle mesh: the closure of the set of
 * points that have more than one shortest path to the source, or to the set. For several points this is their geodesic
 * Voronoi diagram together with the cut locus inside each cell, see `Surface_mesh_cut_locus::set_sources()`.
 *
 * The function constructs a `Surface_mesh_cut_locus`, sets the source or sources, and returns the cut locus. With one
 * source after another on a mesh, or with several thresholds for a source, use the class: it does the work that they
 * share only once.
 *
 * Unless `cut_locus_method` is given, the method depends on the distances. It is `Cut_loci::Default_method` with the
 * default solver, and `Cut_loci::Laplacian_method` with others and with a `vertex_distance_map`. All methods take one or
 * several points, curves, and the border.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Source `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or a pair of a face and barycentric
 * coordinates as
 *         in `Polygon_mesh_processing`; or a model of `ConstRange` of either, or of
 *         `Surface_mesh_cut_locus::Source` for both in one set
 *
 * @param tm a triangle mesh
 * @param source the source, or the range of sources
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters", which are explained where the class takes
 *        them
 *        - the mesh and the method, see \link Surface_mesh_cut_locus::Surface_mesh_cut_locus() the constructor\endlink:
 *          `vertex_point_map`, `edge_length_map`, `geodesic_solver`, `cut_locus_method`, which has the thresholds,
 *          `concurrency_tag`, `visitor`
 *        - the sources, see `Surface_mesh_cut_locus::set_source()` and `Surface_mesh_cut_locus::set_sources()`:
 *          `vertex_distance_map`, `maximum_relative_error`, `snapping_tolerance`, `source_curves`, `source_border`
 *        - the result, see `Surface_mesh_cut_locus::cut_locus()`: `cut_locus_curve`, `kept_part`,
 *          `edge_is_constrained_map`
 *
 * @return the graph of the cut locus, and the distances to the source, or to the nearest one
 *
 * @throws Cut_loci::Invalid_input where the mesh, the source or a parameter cannot be used, with a message that
 *         names the cause
 */
template <typename TriangleMesh, typename Source, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto compute_cut_locus(const TriangleMesh& tm, const Source& source,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, CGAL_NP_CLASS>::const_type;
  Surface_mesh_cut_locus<TriangleMesh, Vertex_point_map> solver(tm, np);
  if constexpr(Cut_loci::internal::Is_range<Source>::value)
    solver.set_sources(source, np);
  else
  {
    using Solver = decltype(solver);
    static_assert(
      std::is_convertible<Source, typename Solver::Source>::value,
      "the source must be a vertex_descriptor, a pair of a face_descriptor and three barycentric coordinates, "
      "or a range of these; Polygon_mesh_processing::locate() finds such a pair for a point in space");
    solver.set_source(source, np);
  }
  return solver.cut_locus(np);
}

} // namespace CGAL

#endif // CGAL_COMPUTE_CUT_LOCUS_H
