// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H

#include "Mesh.h"
#include "cells.h"

#include <CGAL/Cut_loci/Layout_quality.h>

#include <array>
#include <memory>
#include <vector>

using UV = std::array<double, 2>;

// A cell, or a connected part of one, cut open to a disk, and its place in the plane. It is not copied: `uv` refers to the
// mesh.
struct Chart
{
  using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

  Chart();
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  Mesh disk;
  UV_map uv;                                   // is zero at first
  std::vector<CGAL::Cut_loci::Index> vertices; // of the mesh of the cells
  std::vector<CGAL::Cut_loci::Index> faces;    // of the mesh of the cells, with the same first corners
  UV size = {{0., 0.}};                        // the disk is between zero and it when it is placed
  double area = 0.;                            // on the surface
};

// Those that a source reaches. What is left of the seams in a part is opened, or completed, until it is a disk.
std::vector<std::unique_ptr<Chart>> charts_of(const Cells& cells);

// Into the first quadrant, counterclockwise, with the area that it has on the surface.
void place(Chart& chart);

// Side by side in rows, the highest ones first, so that the square around the whole is small: the lower left corners.
std::vector<UV> corners_of(const std::vector<std::unique_ptr<Chart>>& charts);

// Adds what holds of a chart with this part of the area to what holds of all.
void add_part(const CGAL::Cut_loci::Layout_quality& quality, double part, CGAL::Cut_loci::Layout_quality& sum);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_CHARTS_H
