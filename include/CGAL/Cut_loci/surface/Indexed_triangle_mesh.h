// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_INDEXED_TRIANGLE_MESH_H
#define CGAL_CUT_LOCI_SURFACE_INDEXED_TRIANGLE_MESH_H

#include <CGAL/Cut_loci/Index.h>

#include <array>
#include <vector>

namespace CGAL::Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * is an oriented triangle mesh in dense arrays, the form in which all stages of the package take a surface.
 *
 * The connectivity of a model of `FaceListGraph` is read into it once. Halfedge `3 * f + i` of face `f` goes from
 * `triangles[f][i]` to `triangles[f][(i + 1) % 3]`. Every vertex belongs to a face, every edge to one or
 * two faces, and the faces around a vertex form one fan.
 *
 * Its metric is that of the points, unless there are `lengths`.
 */
struct Indexed_triangle_mesh
{
  using Point = std::array<double, 3>;
  using Triangle = std::array<Index, 3>;

  std::vector<Point> points;       ///< the coordinates of each vertex
  std::vector<Triangle> triangles; ///< the vertices of each face, counterclockwise
  std::vector<Index> opposite;     ///< for each halfedge the one on the other side of its edge, or `null_index`
  std::vector<double> lengths;     ///< of each halfedge, in place of those between the points; or empty
  bool is_intrinsic = false;       ///< whether the points say nothing of the shape, only the lengths

  Index number_of_vertices() const { return static_cast<Index>(points.size()); }
  Index number_of_faces() const { return static_cast<Index>(triangles.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(3 * triangles.size()); }

  /// the face on whose side the halfedge `h` lies
  static Index face(Index h) { return h / 3; }
  /// the halfedge that follows `h` in its face
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  /// the halfedge that precedes `h` in its face
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  Index source(Index h) const { return triangles[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  bool is_border_edge(Index h) const { return opposite[h] == null_index; }
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * is a point on an `Indexed_triangle_mesh`: barycentric coordinates with respect to the vertices of a face, in the
 * order of `Indexed_triangle_mesh::triangles`.
 */
struct Indexed_location
{
  Index face = null_index;
  std::array<double, 3> coordinates = {{0., 0., 0.}};
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * is the source of the distance: a point of the mesh, and the vertex it is at, if any.
 */
struct Indexed_source
{
  Indexed_location location;
  Index vertex = null_index;
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusSolvers
 *
 * is a source that is a connected curve: the edges of the mesh it is made of, each by one of its halfedges.
 */
struct Indexed_curve
{
  std::vector<Index> halfedges;
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_SURFACE_INDEXED_TRIANGLE_MESH_H
