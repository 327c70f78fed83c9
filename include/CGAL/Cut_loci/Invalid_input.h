// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INVALID_INPUT_H
#define CGAL_CUT_LOCI_INVALID_INPUT_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Cut_loci {

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
  explicit Invalid_input(const std::string& cause) : std::invalid_argument(cause) {}
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INVALID_INPUT_H
