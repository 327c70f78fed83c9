// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H
#define CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// how the cut locus is found
enum class Method {
  LAPLACIAN, ///< where the Laplacian of the distance is low and gradients turn: takes any distance, also smoothed ones.
             ///< Branches are chosen by `gradient_angle_threshold`, `laplacian_threshold` and `filter_policy`
  DIRECTION, ///< where shortest paths meet that leave the source in different directions, with any mesh, also with a
             ///< border: the cut locus of the polyhedron without the branches that come from the mesh or from noise. It
             ///< needs the package's own exact distances. Branches are chosen by `minimum_branch_width` and
             ///< `minimum_branch_gap`
  POLYHEDRAL ///< the same with all branches: the cut locus of the polyhedron itself, of which every vertex of positive
             ///< curvature is a part. It is exact up to rounding, but where shortest paths are equally long by symmetry
             ///< and bend, as in machine parts: there pieces can be off by up to a face
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the name of a method, as in `cut_locus_method(Cut_loci::Method::LAPLACIAN)`
inline const char* name_of(Method method)
{
  switch(method)
  {
  case Method::LAPLACIAN:
    return "Cut_loci::Method::LAPLACIAN";
  case Method::DIRECTION:
    return "Cut_loci::Method::DIRECTION";
  default:
    return "Cut_loci::Method::POLYHEDRAL";
  }
}

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the curve that represents the cut locus
enum class Curve {
  MESH_EDGES,   ///< edges of the mesh
  THROUGH_FACES ///< segments in the faces, between points that shortest paths reach from both sides
};

/// \ingroup PkgSurfaceMeshCutLocusRef
/// the part of the cut locus of several sources that is kept
enum class Kept_part {
  ALL,     ///< the geodesic Voronoi diagram, together with the cut locus inside each cell
  VORONOI, ///< the edges between two sources: without the rest, the graph need not be connected, nor a cell a disk. Of one
           ///< source, one vertex is left
  MEDIAL ///< what is inside the cells
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_CUT_LOCUS_METHOD_H
