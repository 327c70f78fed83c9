// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_METHOD_H
#define CGAL_CUT_LOCI_LAPLACIAN_METHOD_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/face_graph/make_solver.h>

#ifndef CGAL_CUT_LOCI_SEPARATE_COMPILATION
#include <CGAL/Cut_loci/face_graph/make_laplacian_solver_impl.h>
#endif

namespace CGAL::Cut_loci::internal {

template <>
struct Code_of<Laplacian_method>
{
  static constexpr auto make_solver = &make_laplacian_solver;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_LAPLACIAN_METHOD_H
