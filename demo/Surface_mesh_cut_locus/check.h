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

// Of what is wide in the cut locus of the polyhedron, and of the curve: the shares of length that are near each other.
struct Completeness
{
  double width;     // in units of the diagonal: what is as wide is asked for
  double found;     // of that, near the curve
  double confirmed; // of the curve, near the cut locus of the polyhedron
};

// What holds for a computed cut locus, found without knowing the true one; lengths in mean edge lengths.
struct Check
{
  std::string topology_fault; // or empty
  std::string failed;         // why there is no detour, or empty
  double detour_mean = 0., detour_p99 = 0., detour_max = 0.;
  std::string nodes_failed; // why there is no error of distances, or empty
  double node_distance_mean = 0., node_distance_max = 0.;
  std::optional<Completeness> completeness;
};

// The sources that are curves, behind the points, are given by their edges.
Check check(const Mesh& mesh, const Cut_locus& cut_locus,
            const std::vector<std::vector<Mesh::Edge_index>>& source_curves);

// The share of the length of a curve that is within two edge lengths of another one.
double share_near(const Mesh& mesh, const Cut_locus& curve, const Cut_locus& other);

// One line for people.
std::string summary(const Check& check);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_CHECK_H
