// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CHECKED_CURVES_H
#define CGAL_CUT_LOCI_CHECKED_CURVES_H

#include "curve_topology.h"
#include "detour.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// What must hold for every curve, however it was found.
namespace checked_curves {

using curve_measures::Measures;

// the detour of a curve, whose topology is right; `exact` are the distances, or is empty
template <typename TriangleMesh, typename CutLocus>
Measures measured(const TriangleMesh& mesh, const CutLocus& curve, std::vector<double>& exact,
                  const curve_measures::Edge_curves<TriangleMesh>& sources = {})
{
  const Measures result = curve_measures::measure(mesh, curve, exact, sources);
  EXPECT_EQ(result.topology_fault, "");
  EXPECT_EQ(result.measuring_failed, "");
  return result;
}

template <typename TriangleMesh, typename CutLocus>
Measures measured(const TriangleMesh& mesh, const CutLocus& curve,
                  const curve_measures::Edge_curves<TriangleMesh>& sources = {})
{
  std::vector<double> exact;
  return measured(mesh, curve, exact, sources);
}

// What it leaves is a disk.
inline void expect_disk(const CGAL::Cut_loci::Indexed_triangle_mesh& mesh,
                        const CGAL::Cut_loci::Indexed_cut_locus& curve)
{
  EXPECT_EQ(curve_measures::internal::Curve_topology(mesh, curve).fault(), "");
}

// The surface without its sources, of which some are curves, shrinks to it.
template <typename Built, typename CutLocus>
void expect_topology(const Built& built, const curve_measures::Edge_curves<typename Built::Mesh>& curves,
                     const CutLocus& result, const std::string& what)
{
  namespace lib = CGAL::Cut_loci::internal;
  const auto read = lib::read_triangle_mesh(built.mesh, get(CGAL::vertex_point, built.mesh));
  const lib::Curve_on_component on = lib::on_component(read.mesh, lib::curve_on_mesh(read, built.mesh, result));
  const curve_measures::internal::Source_set set = curve_measures::internal::source_set(built.mesh, read, on, curves);
  EXPECT_EQ(curve_measures::internal::topology_fault_beside_curves(on.component.mesh, on.curve.graph, set), "") << what;
}

} // namespace checked_curves

#endif // CGAL_CUT_LOCI_CHECKED_CURVES_H
