// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_REFINE_ALONG_CUT_LOCUS_H
#define CGAL_REFINE_ALONG_CUT_LOCUS_H

#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/face_graph/cells_of_faces.h>
#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/output_maps.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * splits the faces that a cut locus runs through, so that it consists of edges of the result: straight seams, where
 * edges of the mesh zigzag.
 *
 * The surface stays the same except for the rounding of points, and each face of the result is a part of one of `tm`. The
 * cut locus is rounded first: its barycentric coordinates become multiples of the snapping tolerance, so that it goes
 * through a vertex that it passes closely, and no face is degenerate: all have at least the square of the tolerance of
 * the area of the face that they are a part of.
 *
 * Time is O(n log k), for n faces and k vertices of the cut locus.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Point_3 the point type of the cut locus
 * @tparam OutputMesh a model of `MutableFaceGraph`
 *
 * @param tm the triangle mesh of which the cut locus was computed
 * @param cut_locus a cut locus on it: through the faces, as with `Cut_loci::Curve::THROUGH_FACES` or smoothed, or of
 *        edges of the mesh, of which no face is split
 * @param output the mesh to which the result is added, all components of it; it should be empty
 * @param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `cut_along_cut_locus()`,
 *        to which a vertex that is new comes from `null_vertex()`, and the one listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{snapping_tolerance}
 *     \cgalParamDescription{the barycentric coordinates of the curve are rounded to multiples of it}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1 / 256: less than the curve is off the true cut locus}
 *     \cgalParamExtra{It is from 2^-20 to 1/2, and its reciprocal is rounded to a whole number.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `output`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that is set to `true` for the edges of `output` on the cut locus, and to
 *                           `false` for all others}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<OutputMesh>::%edge_descriptor` as key type and `bool` as value type}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{a property map that gets, for each face of `output`, the number of the source in whose cell it is:
 *                           cells of geodesic Voronoi diagrams as patches. `Cut_loci::no_source` where no path leads.}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<OutputMesh>::%face_descriptor` as key type and `std::size_t` as value type}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throws Cut_loci::Invalid_input if a face of `tm` is not a triangle, or if the cut locus is not one of `tm`
 */
template <typename TriangleMesh, typename Point_3, typename OutputMesh,
          typename NamedParametersIn = parameters::Default_named_parameters,
          typename NamedParametersOut = parameters::Default_named_parameters>
void refine_along_cut_locus(const TriangleMesh& tm, const Cut_locus<TriangleMesh, Point_3>& cut_locus,
                            OutputMesh& output, const NamedParametersIn& np_in = parameters::default_values(),
                            const NamedParametersOut& np_out = parameters::default_values())
{
  using parameters::get_parameter;
  namespace internal = Cut_loci::internal;

  const Cut_loci::Index resolution = internal::read_resolution(np_in);
  const auto read = internal::read_triangle_mesh(tm, internal::point_map(tm, np_in));
  const internal::Curve_on_mesh curve = internal::curve_on_mesh(read, tm, cut_locus);
  const Cut_loci::Cut_mesh fans = Cut_loci::cut_open(read.mesh); // components may touch in a vertex
  const Cut_loci::Refined_mesh refined =
    Cut_loci::refine_along_curve(fans.mesh, Cut_loci::Mesh_connectivity(fans.mesh), curve.graph, resolution);

  std::vector<Cut_loci::Index> origin = fans.vertices;
  origin.resize(refined.mesh.number_of_vertices(), Cut_loci::null_index);
  const auto built = internal::output_mesh(tm, read, refined.mesh, origin, refined.faces, output, np_in, np_out);
  internal::output_seams(refined.mesh, refined.seams, built, output,
                         get_parameter(np_out, internal_np::edge_is_constrained));
  internal::output_cells([&] { return internal::cells_of_faces(read, fans.vertices, curve, refined, cut_locus); },
                         built, output, get_parameter(np_out, internal_np::face_patch));
}

} // namespace CGAL

#endif // CGAL_REFINE_ALONG_CUT_LOCUS_H
