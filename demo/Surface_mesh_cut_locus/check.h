// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_CHECK_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_CHECK_H

#include "Mesh.h"

#include <optional>
#include <string>
#include <vector>

// What holds for a computed cut locus, found without knowing the true one; lengths in mean edge lengths.
struct Check
{
  std::string topology_fault; // or empty
  std::string failed;         // why there is no detour, or empty
  double detour_mean, detour_p99, detour_max;
};

// The sources that are curves, behind the points, are given by their edges.
Check check(const Mesh& mesh, const Cut_locus& cut_locus,
            const std::vector<std::vector<Mesh::Edge_index>>& source_curves);

// One line for people.
std::string summary(const Check& check);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_CHECK_H
