// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Adds the named parameters of Surface_mesh_cut_locus to CGAL's own list, so that they chain with CGAL's in any order.
// This folder comes before CGAL's in the include path of the CMake target; it is never installed over CGAL's file.

#if defined(__GNUC__)
#pragma GCC system_header
#endif

#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#ifndef CGAL_CUT_LOCI_NAMED_PARAMETERS_IN_CGAL_LIST
#define CGAL_CUT_LOCI_NAMED_PARAMETERS_IN_CGAL_LIST
#endif
#include <CGAL/Cut_loci/internal/named_parameters_list.h>
