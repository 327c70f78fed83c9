// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INVALID_INPUT_H
#define CGAL_CUT_LOCI_INVALID_INPUT_H

#include <stdexcept>
#include <string>

namespace CGAL::Cut_loci {

/// \ingroup PkgSurfaceMeshCutLocusRef
/// what is wrong with an input, for programs: `Invalid_input` says it in words, too
enum class Cause {
  OTHER,                     ///< none of these: for solvers of the user
  EMPTY_MESH,                ///< the mesh has no vertices, or no faces
  NO_TRIANGLE,               ///< a face has not three sides, or not three vertices
  INVALID_COORDINATE,        ///< a coordinate of a point is not finite
  FACE_WITHOUT_AREA,         ///< a face has no area, up to rounding
  NON_MANIFOLD,              ///< the faces at a vertex or an edge form no surface
  NO_SOURCE,                 ///< no source is given
  INVALID_SOURCE,            ///< a source is null, isolated or not in the mesh
  SAME_SOURCES,              ///< two sources are at the same point, or have one in common
  SOURCES_APART,             ///< sources are in different components of the mesh
  NO_FACE_AT_SOURCE,         ///< a curve of mesh edges can not separate a source from the others
  INVALID_DISTANCE,          ///< distances that are given can not be used
  INVALID_PARAMETER,         ///< a parameter is out of its range, or contradicts another one
  PARAMETER_OF_OTHER_METHOD, ///< a parameter, or several sources, have no meaning for the method
  INVALID_CUT_LOCUS,         ///< a cut locus is not one of the mesh, or not of the kind that is needed
  NOT_CONVEX,                ///< a polyhedron is not convex, or not closed, where it has to be
  NO_DISK,                   ///< a surface is not a disk with one border loop
  TOO_INACCURATE             ///< the exact solver, or what cuts a surface open, meets faces that are too thin for it
};

/*!
 * \ingroup PkgSurfaceMeshCutLocusRef
 *
 * is thrown where the mesh, the source or a parameter cannot be used. Its message names the cause and, where there is
 * one, the element, by its position in the ranges `vertices(mesh)` and `faces(mesh)`. It is thrown in release builds,
 * too.
 */
class Invalid_input : public std::invalid_argument
{
public:
  Invalid_input(Cause cause, const std::string& message) : std::invalid_argument(message), cause_(cause) {}

  /// what is wrong
  Cause cause() const { return cause_; }

private:
  Cause cause_;
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_INVALID_INPUT_H
