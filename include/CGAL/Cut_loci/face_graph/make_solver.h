// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_MAKE_SOLVER_H
#define CGAL_CUT_LOCI_FACE_GRAPH_MAKE_SOLVER_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/internal/separate_compilation.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <memory>

namespace CGAL::Cut_loci::internal {

// The mesh must stay where it is.
std::unique_ptr<Laplacian_stages> make_laplacian_solver(const Indexed_triangle_mesh& mesh, Laplacian_operator type,
                                                        const Threads& threads, const Progress& progress);
std::unique_ptr<Exact_tree_method> make_exact_tree_solver(const Indexed_triangle_mesh& mesh, const Threads& threads,
                                                          const Progress& progress);

// Whoever uses a method that takes any distances includes its code.
template <typename Method>
struct Code_of
{
  static_assert(sizeof(Method) == 0, "include <CGAL/Cut_loci/Laplacian_method.h>: the method of these distances, or of "
                                     "cut_locus_method, is or can be Cut_loci::Laplacian_method");
};

} // namespace CGAL::Cut_loci::internal

#ifndef CGAL_CUT_LOCI_SEPARATE_COMPILATION
#include <CGAL/Cut_loci/face_graph/make_exact_tree_solver_impl.h>
#endif

#endif // CGAL_CUT_LOCI_FACE_GRAPH_MAKE_SOLVER_H
