// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_REPORT_STAGE_H
#define SURFACE_MESH_CUT_LOCUS_WEB_REPORT_STAGE_H

// The page's own stage, after those of `CGAL::Cut_loci::Stage`.
constexpr int cutting_stage = 7;

// Tells the page that a stage starts or ends.
void report_stage(int stage, bool starts);

// And which share of it is done.
void report_progress(int stage, double share);

#endif // SURFACE_MESH_CUT_LOCUS_WEB_REPORT_STAGE_H
