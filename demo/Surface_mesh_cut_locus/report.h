// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_H

#include "Input_mesh.h"
#include "Options.h"
#include "Progress.h"
#include "atlas.h"
#include "check.h"

#include <optional>
#include <string>

// Writes figures of a cut locus, made of edges or not, and times as JSON; vertices have the numbers of the file, and
// `options` have all defaults filled in. Throws `std::runtime_error` if the report can not be written.
void write_report(const Options& options, CGAL::Cut_loci::Curve curve, const Input_mesh& input,
                  const Cut_locus& cut_locus, const std::optional<Atlas>& atlas, const std::optional<Check>& check,
                  const Progress& progress);

// One line for people; `options` have all defaults filled in.
std::string summary(const Options& options, CGAL::Cut_loci::Curve curve, const Mesh& mesh, const Cut_locus& cut_locus);
std::string summary(const Atlas& atlas, const Input_mesh& input);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_REPORT_H
