// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_MESH_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_MESH_H

#include <CGAL/Cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <utility>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Cut_locus = CGAL::Cut_locus<Mesh, Kernel::Point_3>;

// The point of the mesh that is closest to `p`.
Location closest_location(const Mesh& mesh, const Kernel::Point_3& p);

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for(Mesh::Edge_index e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_MESH_H
