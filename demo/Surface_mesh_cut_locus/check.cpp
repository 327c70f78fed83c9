// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "check.h"

#include "completeness.h"
#include "detour.h"
#include "node_distances.h"

#include <iomanip>
#include <sstream>

Check check(const Mesh& mesh, const Cut_locus& cut_locus,
            const std::vector<std::vector<Mesh::Edge_index>>& source_curves)
{
  const curve_measures::Measures m = curve_measures::measure(mesh, cut_locus, source_curves);
  Check result;
  result.topology_fault = m.topology_fault;
  result.failed = m.measuring_failed;
  result.detour_mean = m.mean;
  result.detour_p99 = m.p99;
  result.detour_max = m.max;
  try
  {
    const curve_measures::Node_distance_errors errors =
      curve_measures::node_distance_errors(mesh, cut_locus, source_curves);
    result.node_distance_mean = errors.mean;
    result.node_distance_max = errors.max;
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    result.nodes_failed = error.what();
  }
  return result;
}

double share_near(const Mesh& mesh, const Cut_locus& curve, const Cut_locus& other)
{
  return curve_measures::completeness(curve, other, 2. * mean_edge_length(mesh));
}

std::string summary(const Check& check)
{
  std::ostringstream text;
  text << "check: topology " << (check.topology_fault.empty() ? "right" : "WRONG: " + check.topology_fault);
  if(!check.failed.empty())
    text << "; the detour can not be measured: " << check.failed;
  else
    text << std::fixed << std::setprecision(4) << "; detour mean " << check.detour_mean << ", 99 % " << check.detour_p99
         << ", max " << check.detour_max << " edge lengths";
  if(!check.nodes_failed.empty())
    text << "; distances of nodes can not be measured: " << check.nodes_failed;
  else
    text << std::scientific << std::setprecision(1) << "; distances of nodes off by mean " << check.node_distance_mean
         << ", max " << check.node_distance_max;
  if(!check.completeness)
    text << "; not checked: whether branches are missing (--check-completeness)";
  else
    text << std::fixed << std::setprecision(1) << "; " << 100. * check.completeness->found
         << " % of what is as wide as " << std::setprecision(4) << check.completeness->width
         << " of the diagonal in the polyhedron's cut locus is there, " << std::setprecision(1)
         << 100. * check.completeness->confirmed << " % of the curve is in that";
  return text.str();
}
