// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_FIELDS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_FIELDS_H

#include "../../Mesh.h"

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <memory>
#include <vector>

// The Laplacian and the gradient of functions on a mesh, by the library's operators, to be shown.
class Fields
{
public:
  explicit Fields(const Mesh& mesh);
  ~Fields();

  // for each vertex of the mesh; of a function that is not finite they are zero
  std::vector<float> laplacian(const std::vector<double>& function) const; // times the mean edge length
  std::vector<float> gradient(const std::vector<double>& function) const;  // x, y, z

private:
  struct Operators;
  std::unique_ptr<Operators> operators_;
};

#endif // SURFACE_MESH_CUT_LOCUS_WEB_FIELDS_H
