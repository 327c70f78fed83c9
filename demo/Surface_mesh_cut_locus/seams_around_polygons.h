// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SEAMS_AROUND_POLYGONS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SEAMS_AROUND_POLYGONS_H

#include <CGAL/Cut_loci/surface/cut_open.h>

#include <vector>

// Leads seams that cut a component to a disk around the polygons that were triangulated: each diagonal becomes a way
// around its polygon, which can be moved onto it, so that a disk is left as before. `is_diagonal` is for halfedges.
void lead_around_polygons(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh, const std::vector<bool>& is_diagonal,
                          CGAL::Cut_loci::Seams& seams);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SEAMS_AROUND_POLYGONS_H
