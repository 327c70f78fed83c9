// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_PYTHON_RESULT_H
#define SURFACE_MESH_CUT_LOCUS_PYTHON_RESULT_H

#include "../../demo/Surface_mesh_cut_locus/Mesh.h"

#include <CGAL/Cut_loci/statistics.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

// A cut locus with the mesh that it refers to.
struct Result
{
  std::shared_ptr<const Mesh> mesh;
  Cut_locus cut_locus;
  CGAL::Cut_loci::Cut_locus_statistics statistics;

  Result(std::shared_ptr<const Mesh> m, Cut_locus c)
    : mesh(std::move(m)), cut_locus(std::move(c)), statistics(CGAL::Cut_loci::compute_statistics(cut_locus))
  {
  }
};

// Adds the class, with its arrays, to the module.
void bind_result(pybind11::module_& m);

#endif // SURFACE_MESH_CUT_LOCUS_PYTHON_RESULT_H
