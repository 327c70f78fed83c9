// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SURFACE_FILES_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SURFACE_FILES_H

#include "Input_mesh.h"
#include "Options.h"

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

// A number for each vertex or face.
struct Surface_array
{
  std::string name;
  bool is_whole;
  std::function<double(CGAL::Cut_loci::Index)> value;
  std::function<double(CGAL::Cut_loci::Index)> second = nullptr; // of pairs
};

// Readers of PLY and VTP take finite numbers only: where no path leads from a source, it has the number -1, too.
double finite_distance(double distance);

void write_vtp(std::ostream& os, const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
               const std::vector<Surface_array>& of_vertices, const std::vector<Surface_array>& of_faces);

// The surface as it is, with the distance, the number of the nearest source, that in the file of each vertex, and the
// logarithmic map, if there is one. Throws `std::runtime_error` if the file can not be written.
void write_surface(const Options& options, const Input_mesh& input, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SURFACE_FILES_H
