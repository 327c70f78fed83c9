// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H
#define CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H

#include <CGAL/Cut_loci/face_graph/make_solver.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_set_solver.h>

#include <memory>

namespace CGAL::Cut_loci::internal {

CGAL_CUT_LOCI_INLINE std::unique_ptr<Laplacian_stages> make_laplacian_solver(const Indexed_triangle_mesh& mesh,
                                                                             Laplacian_operator type,
                                                                             const Threads& threads,
                                                                             const Progress& progress)
{
  return std::unique_ptr<Laplacian_stages>(new Laplacian_set_solver(mesh, type, threads, progress));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H
