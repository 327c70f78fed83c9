// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Compiled without the folder that adds the package's named parameters to CGAL's list.

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_cut_locus.h>

#include "../built_mesh.h"

#include <gtest/gtest.h>

#ifdef CGAL_CUT_LOCI_NAMED_PARAMETERS_IN_CGAL_LIST
#error "this test must not see the extended list"
#endif

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

TEST(Bare_headers, take_the_packages_named_parameters_in_front_of_those_of_cgal)
{
  namespace params = CGAL::parameters;
  using CGAL::Cut_loci::Laplacian_method;
  Built_mesh<Mesh> built(test_meshes::jittered_sphere(5, 0.2, 1));
  const auto vpm = get(CGAL::vertex_point, built.mesh);
  const auto is_constrained = built.mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
  const auto loose = CGAL::compute_cut_locus(
    built.mesh, built.vertices[4],
    mesh_edges
      .cut_locus_method(Laplacian_method().gradient_angle_threshold(0.1).minimum_branch_edges(0).filter_policy(
        CGAL::Cut_loci::Filter_policy::PRUNING))
      .vertex_point_map(vpm)
      .edge_is_constrained_map(is_constrained));
  const auto tight = CGAL::compute_cut_locus(
    built.mesh, built.vertices[4], mesh_edges.cut_locus_method(Laplacian_method().gradient_angle_threshold(3.14)));
  EXPECT_EQ(num_vertices(tight.graph()), 1u);
  EXPECT_GT(num_vertices(loose.graph()), 1u);
  std::size_t marked = 0;
  for(const Mesh::Edge_index e : built.mesh.edges())
    marked += is_constrained[e] ? 1 : 0;
  EXPECT_EQ(marked, num_edges(loose.graph()));
  EXPECT_EQ(fault_of(built, loose, 0, {}), "");
}
