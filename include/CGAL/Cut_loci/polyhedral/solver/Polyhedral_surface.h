// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_POLYHEDRAL_SURFACE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_POLYHEDRAL_SURFACE_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/strength/Default_branch_strength.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/extent.h>

#include <cstddef>
#include <exception>
#include <memory>

namespace CGAL::Cut_loci::internal {

// what depends on the mesh alone
struct Polyhedral_surface
{
  Polyhedral_surface(const Indexed_triangle_mesh& mesh, const Threads& threads, const Progress& progress)
    : extent(internal::extent(mesh))
  {
    // only the thread that asks for the work is to be told of it
    if(threads.are_there() && !progress.is_wanted())
      read_in_threads(mesh, threads);
    else
    {
      connectivity.reset(new Mesh_connectivity(mesh, progress.part(0., 0.3)));
      checked_mesh(mesh, *connectivity, progress.part(0.3, 0.4)); // has more to say than the faces
      faces = std::make_shared<const Geodesic_faces>(mesh, nullptr, progress.part(0.4, 0.8));
    }
    static_cast<Branch_strength&>(thresholds) =
      Default_branch_strength(mesh, *connectivity, *faces, extent, progress.part(0.8, 1.)).strength;
    progress(1.);
  }

  void read_in_threads(const Indexed_triangle_mesh& mesh, const Threads& threads)
  {
    std::exception_ptr error;
    const auto read = [&](std::size_t i)
    {
      if(i == 0)
        connectivity.reset(new Mesh_connectivity(mesh));
      else
        try
        {
          faces = std::make_shared<const Geodesic_faces>(mesh);
        }
        catch(...)
        {
          error = std::current_exception();
        }
    };
    threads.run(2, read);
    checked_mesh(mesh, *connectivity); // has more to say
    if(error)
      std::rethrow_exception(error);
  }

  std::unique_ptr<const Mesh_connectivity> connectivity;
  std::shared_ptr<const Geodesic_faces> faces;
  double extent;
  Exact_tree_thresholds thresholds; // the default
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_POLYHEDRAL_SURFACE_H
