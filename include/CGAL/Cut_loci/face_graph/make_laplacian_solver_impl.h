// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H
#define CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H

#include <CGAL/Cut_loci/face_graph/make_solver.h>
#include <CGAL/Cut_loci/graph/Divided_mesh.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_divided_solver.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_set_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

CGAL_CUT_LOCI_INLINE std::unique_ptr<Laplacian_stages> make_laplacian_solver(const Indexed_triangle_mesh& mesh,
                                                                             Laplacian_operator type,
                                                                             const Threads& threads,
                                                                             const Progress& progress)
{
  constexpr double longest = 3.; // in the mean: halves of most others are still longer than most edges
  auto divided =
    std::make_shared<const Divided_mesh>(mesh, std::vector<Indexed_source>(), longest * mean_edge_length(mesh));
  if(divided->mesh().number_of_vertices() == mesh.number_of_vertices())
    return std::unique_ptr<Laplacian_stages>(new Laplacian_set_solver(mesh, type, threads, progress));
  return std::unique_ptr<Laplacian_stages>(
    new Laplacian_divided_solver(mesh, std::move(divided), type, threads, progress));
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_MAKE_LAPLACIAN_SOLVER_IMPL_H
