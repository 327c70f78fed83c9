// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_LOGARITHMIC_LAYOUT_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_LOGARITHMIC_LAYOUT_H

#include "charts.h"

// Lays the chart of a source, cut open through the faces, flat by the distances from the source, and the directions there.
void lay_out_by_logarithmic_map(const Mesh& mesh, const Cut_locus& cut_locus, Chart& chart);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_LOGARITHMIC_LAYOUT_H
