// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTEN_DISK_H
#define CGAL_CUT_LOCI_FLATTEN_DISK_H

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/Layout_quality.h>
#include <CGAL/Cut_loci/face_graph/Visitor_handle.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/flattening/Disk_shape.h>
#include <CGAL/Cut_loci/flattening/Multilevel_layout.h>
#include <CGAL/Cut_loci/flattening/layout_overlap.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Cut_loci {

namespace internal {

inline void measure_distortion(const Disk_shape& disk, const Planar_points& plane, Layout_quality& quality)
{
  double area_in_space = 0., area_in_plane = 0.;
  for(std::size_t f = 0; f < disk.triangles.size(); ++f)
  {
    const Planar_triangle t = image_of(disk.triangles[f], plane);
    area_in_space += 0.5 * twice_signed_area(disk.rest[f][0], disk.rest[f][1], disk.rest[f][2]);
    area_in_plane += 0.5 * std::abs(twice_signed_area(t[0], t[1], t[2]));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(!(area_in_plane > 0.))
  {
    quality.area_distortion = quality.angle_distortion = quality.symmetric_dirichlet_energy = infinity;
    return;
  }
  const double scale = std::sqrt(area_in_space / area_in_plane);
  for(std::size_t f = 0; f < disk.triangles.size(); ++f)
  {
    const Planar_triangle &r = disk.rest[f], t = image_of(disk.triangles[f], plane);
    Eigen::Matrix2d rest, image;
    rest << r[1][0] - r[0][0], r[2][0] - r[0][0], r[1][1] - r[0][1], r[2][1] - r[0][1];
    image << t[1][0] - t[0][0], t[2][0] - t[0][0], t[1][1] - t[0][1], t[2][1] - t[0][1];
    const Eigen::Matrix2d jacobian = scale * image * rest.inverse();
    const double part = 0.5 * rest.determinant() / area_in_space, square = jacobian.squaredNorm(),
                 area = std::abs(jacobian.determinant());
    // not 0 / 0 if it has become a point
    quality.area_distortion += area > 0. ? part * 0.5 * (area + 1. / area) : infinity;
    quality.angle_distortion += area > 0. ? part * 0.5 * square / area : infinity; // s / t + t / s
    quality.symmetric_dirichlet_energy += area > 0. ? part * 0.25 * square * (1. + 1. / (area * area)) : infinity;
  }
  if(quality.flipped_faces > 0)
    quality.symmetric_dirichlet_energy = infinity;
}

inline Layout_quality layout_quality(const Disk_shape& disk, const Planar_points& plane)
{
  Layout_quality quality;
  quality.faces_without_shape = disk.faces_without_shape;
  for(const Triangle_corners& corners : disk.triangles)
    quality.flipped_faces += is_flipped(image_of(corners, plane));
  quality.is_injective = quality.flipped_faces == 0 && is_simple(disk.border, plane);
  if(!quality.is_injective)
  {
    quality.overlapping_faces = number_of_overlapping_faces(disk.triangles, plane);
    quality.overlap = overlapping_part(disk.triangles, plane);
  }
  measure_distortion(disk, plane, quality);
  return quality;
}

// Throws unless the mesh is connected and its border one loop around a disk.
inline Disk_shape shape_of_disk(const Indexed_triangle_mesh& mesh)
{
  if(std::all_of(mesh.points.begin(), mesh.points.end(), [&](const auto& p) { return p == mesh.points.front(); }))
    throw Invalid_input(Cause::FACE_WITHOUT_AREA, "all vertices of the surface are at the same point");
  if(!is_disk(mesh))
    throw Invalid_input(Cause::NO_DISK, "the surface is not a disk with one border loop: cut it open first, as "
                                        "CGAL::cut_along_cut_locus() does");
  return disk_shape(mesh);
}

template <typename TriangleMesh, typename NamedParameters>
Read_triangle_mesh<TriangleMesh> read_disk(const TriangleMesh& tm, const NamedParameters& np)
{
  auto read = read_triangle_mesh(tm, point_map(tm, np));
  normalize_lengths(read);
  return read;
}

} // namespace internal

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * tells how good a disk in the plane is.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam VertexUVMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
 *         key type and a 2D point as value type
 *
 * @param tm a triangle mesh that is a disk, as `cut_along_cut_locus()` returns it
 * @param uv_map tells where each vertex is in the plane
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throws Invalid_input if `tm` is not a disk of triangles, or a coordinate is not finite
 */
template <typename TriangleMesh, typename VertexUVMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Layout_quality layout_quality(const TriangleMesh& tm, VertexUVMap uv_map,
                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto read = internal::read_disk(tm, np);
  internal::Planar_points plane;
  plane.reserve(read.vertices.size());
  for(const auto v : read.vertices)
  {
    const auto& p = get(uv_map, v);
    plane.push_back({{to_double(p.x()), to_double(p.y())}});
    if(!std::isfinite(plane.back()[0]) || !std::isfinite(plane.back()[1]))
      throw Invalid_input(Cause::INVALID_COORDINATE, internal::vertex_name(read.positions[plane.size() - 1]) +
                                                       " has a coordinate in the plane that is not finite");
  }
  return internal::layout_quality(internal::shape_of_disk(read.mesh), plane);
}

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * lays a disk flat, injectively, and as isometrically as may be: no face is flipped, no two overlap.
 *
 * The disk is simplified as long as that halves its vertices: inside, and along the border where it is nearly straight, as
 * where a seam crosses one face after another. A convex layout \cgalCite{cgal:t-hdg-63} of the coarsest disk is the start,
 * and vertices come back level by level. On each level, Newton steps \cgalCite{cgal:sgk-aeide-19} lower the symmetric
 * Dirichlet energy \cgalCite{cgal:ss-bpfb-15}, and end before the first face loses its area. Nor does the border ever
 * cross itself: the plane around it is triangulated anew in each step, and none of these triangles is flipped either
 * \cgalCite{cgal:jsp-scaf-17}. Where the disk would overlap itself if it were laid flat more freely, it is distorted or
 * moved aside.
 *
 * The surface keeps its size, and its faces become counterclockwise. Faces thinner than a ten-thousandth of their longest
 * edge, or shorter than as much of the mean one, are laid out as if they were as thick as that, so that they may have no
 * area in space.
 *
 * A step takes O(n^1.5) time and O(n log n) space for n faces; the steps on all simplified disks together take as long as
 * those on the disk itself at most. Numbers are too coarse for the start if parts of the simplified disk shrink below their
 * resolution there; then it is returned as it is, and `Layout_quality::flipped_faces` says so. A closed tube, cut open at one
 * end and 80 times as long as its radius, is laid out injectively; its distortion is that of a tube that becomes a disk.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam VertexUVMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
 *         key type and a 2D point with coordinates of type `double` as value type
 *
 * @param tm a triangle mesh that is a disk, as `cut_along_cut_locus()` returns it
 * @param uv_map gets the place of each vertex in the plane
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of steps on the disk itself. Fewer are made if two of them lower the
 *                           energy by less than a thousandth each. With 0, the convex layout is returned, of the
 *                           disk as it is.}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{60}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is told how many of the steps are done, in `Stage::FLATTENING`. An exception
 *                           that it throws there cancels the computation.}
 *     \cgalParamType{a model of `CutLocusVisitor`}
 *     \cgalParamDefault{`Default_visitor()`}
 *     \cgalParamExtra{It is copied; pass `std::ref(visitor)` to keep its state.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return how good it is
 *
 * @throws Invalid_input if `tm` is not a disk of triangles, or a single point in space, or if a coordinate is not finite
 */
template <typename TriangleMesh, typename VertexUVMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Layout_quality flatten_disk(const TriangleMesh& tm, VertexUVMap uv_map,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Point_2 = typename boost::property_traits<VertexUVMap>::value_type;
  const internal::Visitor_handle visitor(choose_parameter(get_parameter(np, internal_np::visitor), Default_visitor()));
  const internal::Visitor_handle::Scope scope(visitor, Stage::FLATTENING);
  const auto read = internal::read_disk(tm, np);
  const internal::Disk_shape disk = internal::shape_of_disk(read.mesh);
  const unsigned int most_steps = choose_parameter(get_parameter(np, internal_np::number_of_iterations), 60u);
  const internal::Multilevel_layout layout(disk, most_steps, visitor.progress(Stage::FLATTENING));
  for(std::size_t v = 0; v < read.vertices.size(); ++v)
    put(uv_map, read.vertices[v], Point_2(read.unit * layout.plane()[v][0], read.unit * layout.plane()[v][1]));
  return internal::layout_quality(disk, layout.plane());
}

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_FLATTEN_DISK_H
