// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_GENERATED_TEXTS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_GENERATED_TEXTS_H

#include <string>

// From the descriptions of the options: a page for man, and completion for bash.
std::string man_page();
std::string bash_completion();

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_GENERATED_TEXTS_H
