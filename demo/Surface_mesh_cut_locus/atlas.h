// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H

#include "Mesh.h"

#include <CGAL/Cut_loci/Layout_quality.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// A surface cut open along its cut locus and flattened.
struct Atlas
{
  std::string parameterization;
  std::vector<Kernel::Point_3> points;                     // the vertices of the mesh, then those that were added
  std::vector<std::array<double, 2>> texture_coordinates;  // in the unit square
  std::vector<std::array<std::size_t, 3>> faces;           // corners in `points`
  std::vector<std::array<std::size_t, 3>> texture_corners; // in `texture_coordinates`, for the first faces

  CGAL::Cut_loci::Layout_quality quality;
  double seam_distance = 0.; // of the seams to the source
};

// Throws `std::runtime_error` if the surface can not be flattened.
Atlas make_atlas(const Mesh& mesh, const Cut_locus& cut_locus, const std::string& parameterization);

// The same of several sources: their cells side by side, each cut open to a disk along the cut locus inside of it, and,
// where this leaves a ring around a source that is a curve, along edges.
Atlas make_atlas_of_cells(const Mesh& mesh, const Cut_locus& cut_locus, const std::string& parameterization);

// Scales the texture coordinates, mirrors them if they are reversed, and finds the distance of the seams.
void finish_atlas(const Cut_locus& cut_locus, bool is_reversed, Atlas& atlas);

// Writes the OBJ file, and a material and a texture beside it. Throws `std::runtime_error` if that fails.
void write_atlas(const std::string& filename, const Atlas& atlas);

// The distance of the source to the cut graph that is short: the shortest system of loops over edges from a vertex, the
// best of several vertices [Erickson, Whittlesey: Greedy optimal homotopy and homology generators, 2005]. Nothing if
// the surface is a sphere or has a border.
std::optional<double> distance_to_short_cut_graph(const Mesh& mesh, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_ATLAS_H
