// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H

#include "Mesh.h"

#include <CGAL/Cut_loci/Layout_quality.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

using UV = std::array<double, 2>;

// A part of a surface, cut open to a disk, and its place in the plane. It is not copied: `uv` refers to the mesh.
struct Chart
{
  using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

  Chart();
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  Mesh disk;
  UV_map uv;                                   // is zero at first
  std::vector<CGAL::Cut_loci::Index> vertices; // of the surface, or `null_index` for those that are new
  std::vector<CGAL::Cut_loci::Index> faces;    // of the surface, of which they are parts
  UV size = {{0., 0.}};                        // the disk is between zero and it when it is placed
  double area = 0.;                            // on the surface
  std::optional<double> finer_width;           // of branches, if it is cut along finer ones than the cut locus has
  std::size_t seams_in_polygons = 0;           // diagonals that no way around a polygon takes the place of
};

using Charts = std::vector<std::unique_ptr<Chart>>;

// For each edge of a mesh whether it is none of the file, and no seam if that can be; empty if there are none.
using Diagonals = std::vector<bool>;

// The component of a source that is a point, cut open along its cut locus: along edges, around polygons, or straight
// through the faces, as it runs.
std::unique_ptr<Chart> chart_of_source(const Mesh& mesh, const Cut_locus& cut_locus, const Diagonals& is_diagonal = {});

// The cells of several sources, each cut open to disks along the cut locus inside of it, and, where this leaves a ring
// around a source that is a curve, along edges. Those that a source reaches.
Charts charts_of_cells(const Mesh& mesh, const Cut_locus& cut_locus, const Diagonals& is_diagonal = {});

// The chart of a mesh that has been cut open, whose vertices and faces are these of the surface.
std::unique_ptr<Chart> make_chart(const Mesh& mesh, const CGAL::Cut_loci::Indexed_triangle_mesh& cut,
                                  std::vector<CGAL::Cut_loci::Index> vertices,
                                  std::vector<CGAL::Cut_loci::Index> faces);

// Into the first quadrant, counterclockwise, with the area that it has on the surface, so that the box around it is
// small, and stands upright.
void place(Chart& chart);

// Adds what holds of a chart with this part of the area to what holds of all.
void add_part(const CGAL::Cut_loci::Layout_quality& quality, double part, CGAL::Cut_loci::Layout_quality& sum);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H
