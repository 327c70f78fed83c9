// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_COMPONENT_CHARTS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_COMPONENT_CHARTS_H

#include "Input_mesh.h"
#include "Options.h"
#include "charts.h"
#include "solvers.h"

#include <vector>

// The flattened charts of all components, each cut open by itself. Of the first one `solver` and the cut locus are there.
//
// Where no detail is asked for, a component with a chart that is stretched more than the options allow is cut along finer
// branches, down to all that there are. Throws `std::runtime_error` if a chart can not be flattened.
Charts charts_of_components(const std::vector<Options>& options, const Input_mesh& input,
                            const Cut_locus_solver& solver, const Cut_locus& cut_locus);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_COMPONENT_CHARTS_H
