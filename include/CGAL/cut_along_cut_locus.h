// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_ALONG_CUT_LOCUS_H
#define CGAL_CUT_ALONG_CUT_LOCUS_H

#include <CGAL/Cut_loci/face_graph/curve_on_mesh.h>
#include <CGAL/Cut_loci/face_graph/output_maps.h>
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
 * cuts a surface open along a cut locus, to one topological disk with one border loop. A vertex of the mesh becomes
 * as many vertices of the result as there are fans of faces between the seams at it. Faces that the curve runs through are
 * split as by `refine_along_cut_locus()`, so that seams are straight; along edges of the mesh, none is.
 *
 * Parts of a curve that touch after rounding, and so enclose faces, are opened. Where a part has come off the border or
 * off the rest, the shortest ways over edges are cut, too.
 *
 * The result has the component of the source alone: the others have no cut locus. Edges of the cut locus on the border
 * of `tm` are not cut. If the component has no border and the cut locus has fewer than two edges, as on a sphere where
 * it may be a single point, then edges next to it are cut until there are two: a shorter cut would split no vertex.
 * Time is O(n log k), for n faces and k vertices of the cut locus.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Point_3 the point type of the cut locus
 * @tparam OutputMesh a model of `MutableFaceGraph`
 *
 * @param tm the triangle mesh of which the cut locus was computed
 * @param cut_locus a cut locus on it, of one source
 * @param output the mesh to which the disk is added; it should be empty
 * @param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_to_vertex_map}
 *     \cgalParamDescription{tells for each vertex of `output` the vertex of `tm` that it is a copy of, or `null_vertex()`
 *                           if it is new. As a vertex of `tm` may have several copies, the keys are the vertices of
 *                           `output`.}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as value type}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_to_face_map}
 *     \cgalParamDescription{tells for each face of `output` the face of `tm` that it is, or is a part of. If it is one,
 *                           their halfedges start at the same vertex.}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor` as
 *                    key type and `boost::graph_traits<TriangleMesh>::%face_descriptor` as value type}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_to_vertex_output_iterator}
 *     \cgalParamDescription{an output iterator for pairs of a vertex of `tm` and one of `output`}
 *     \cgalParamExtra{If it is given, `vertex_to_vertex_map` is not used.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_to_face_output_iterator}
 *     \cgalParamDescription{an output iterator for pairs of a face of `tm` and one of `output`}
 *     \cgalParamExtra{If it is given, `face_to_face_map` is not used.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{snapping_tolerance}
 *     \cgalParamDescription{as of `refine_along_cut_locus()`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1 / 256}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `output`}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throws Cut_loci::Invalid_input if a face of `tm` is not a triangle, or if the cut locus is not one of `tm`, or that of
 *         several sources
 */
template <typename TriangleMesh, typename Point_3, typename OutputMesh,
          typename NamedParametersIn = parameters::Default_named_parameters,
          typename NamedParametersOut = parameters::Default_named_parameters>
void cut_along_cut_locus(const TriangleMesh& tm, const Cut_locus<TriangleMesh, Point_3>& cut_locus, OutputMesh& output,
                         const NamedParametersIn& np_in = parameters::default_values(),
                         const NamedParametersOut& np_out = parameters::default_values())
{
  namespace internal = Cut_loci::internal;
  using Cut_loci::Index;

  const Index resolution = internal::read_resolution(np_in);
  const auto read = internal::read_triangle_mesh(tm, internal::point_map(tm, np_in));
  const internal::Disk_of_curve disk =
    internal::cut_along(read.mesh, internal::curve_on_mesh(read, tm, cut_locus), resolution);
  const internal::Mesh_component& component = disk.on.component;

  std::vector<Index> vertices, faces;
  for(Index v : disk.cut.vertices)
    vertices.push_back(v < component.vertices.size() ? component.vertices[v] : Cut_loci::null_index);
  for(Index f : disk.refined.faces)
    faces.push_back(component.faces[f]);
  internal::output_mesh(tm, read, disk.cut.mesh, vertices, faces, output, np_in, np_out);
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * marks the edges and vertices at which `CGAL::Seam_mesh` makes a disk of a surface, without a copy of it. The edges
 * are those along which `cut_along_cut_locus()` cuts; see there.
 *
 * `Seam_mesh` shows the faces of all components: it is a disk if `tm` has only one.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Point_3 the point type of the cut locus
 * @tparam SeamEdgeMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as
 *         key type and `bool` as value type
 * @tparam SeamVertexMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 *         as key type and `bool` as value type
 *
 * @param tm the triangle mesh of which the cut locus was computed
 * @param cut_locus a cut locus of edges of the mesh, as with `Cut_loci::Curve::MESH_EDGES`
 * @param seam_edges is set to `true` for the seams, and to `false` for all other edges
 * @param seam_vertices is set to `true` for the ends of seams, and to `false` for all other vertices
 *
 * @return a halfedge of `tm` on a seam, or, if the surface is a disk without any, on its border. Its counterpart on the
 *         border of the `Seam_mesh` is what the functions of `Surface_mesh_parameterization` ask for.
 *
 * @throws Cut_loci::Invalid_input as `cut_along_cut_locus()`, and if the curve runs through faces
 */
template <typename TriangleMesh, typename Point_3, typename SeamEdgeMap, typename SeamVertexMap>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
mark_cut_locus_seams(const TriangleMesh& tm, const Cut_locus<TriangleMesh, Point_3>& cut_locus, SeamEdgeMap seam_edges,
                     SeamVertexMap seam_vertices)
{
  namespace internal = Cut_loci::internal;
  using Cut_loci::Index;
  const auto read = internal::read_triangle_mesh(tm, get_const_property_map(vertex_point, tm));
  const internal::Curve_on_component on =
    internal::on_component(read.mesh, internal::curve_on_mesh(read, tm, cut_locus));
  internal::throw_unless_of_one_source(on.curve);
  internal::throw_unless_of_mesh_edges(on.curve);
  const Cut_loci::Indexed_triangle_mesh& mesh = on.component.mesh;
  const Cut_loci::Seams seams = internal::seams_of_mesh_edges(mesh, internal::manifold_connectivity(mesh), on.curve);
  internal::cut_open_to_disk(mesh, seams);

  for(auto e : make_range(edges(tm)))
    put(seam_edges, e, false);
  for(auto v : make_range(vertices(tm)))
    put(seam_vertices, v, false);
  auto result = boost::graph_traits<TriangleMesh>::null_halfedge();
  bool has_seam = false;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    if(!seams[h] && (has_seam || !mesh.is_border_edge(h)))
      continue;
    const auto halfedge = read.halfedges[3 * std::size_t(on.component.faces[h / 3]) + h % 3];
    result = halfedge;
    if(!seams[h])
      continue;
    has_seam = true;
    put(seam_edges, edge(halfedge, tm), true);
    put(seam_vertices, source(halfedge, tm), true);
    put(seam_vertices, target(halfedge, tm), true);
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_CUT_ALONG_CUT_LOCUS_H
