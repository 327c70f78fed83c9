// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "built_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

using Epick_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Cartesian_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Mesh_types =
  ::testing::Types<Built_mesh<Epick_mesh>, Built_mesh<Cartesian_mesh>, Built_mesh_with_garbage<Epick_mesh>>;

#include "cut_locus_cases.h"
