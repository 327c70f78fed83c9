// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_CELLS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_CELLS_H

#include "Mesh.h"

#include <CGAL/Cut_loci/face_graph/cells_of_faces.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <cstddef>
#include <string>
#include <vector>

// The surface with its faces split along the cut locus of several sources, so that each is in one cell.
struct Cells
{
  CGAL::Cut_loci::Indexed_triangle_mesh mesh;
  std::vector<CGAL::Cut_loci::Index> vertices; // of the surface, or `null_index` for those that are new
  std::vector<CGAL::Cut_loci::Index> faces;    // of the surface, of which they are parts
  CGAL::Cut_loci::Seams seams;                 // the edges on the cut locus
  std::vector<double> distance;                // of each vertex to the nearest source
  std::vector<std::size_t> source;             // of each face, or `no_source`
};

// The cut locus has what is between two sources, and may have what is inside the cells.
Cells make_cells(const Mesh& mesh, const Cut_locus& cut_locus);

// As a mesh, PLY, VTP or OBJ by the extension. Throws `std::runtime_error` if the file can not be written.
void write_cells(const std::string& filename, const Cells& cells);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_CELLS_H
