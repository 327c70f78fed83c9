// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "built_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh_types =
  ::testing::Types<Built_mesh<CGAL::Polyhedron_3<Epick>>,
                   Built_mesh<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>>>;

#include "cut_locus_cases.h"
