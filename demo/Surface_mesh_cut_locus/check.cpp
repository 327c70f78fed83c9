// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "check.h"

#include "detour.h"

#include <iomanip>
#include <sstream>

Check check(const Mesh& mesh, const Cut_locus& cut_locus,
            const std::vector<std::vector<Mesh::Edge_index>>& source_curves)
{
  const curve_measures::Measures m = curve_measures::measure(mesh, cut_locus, source_curves);
  return {m.topology_fault, m.measuring_failed, m.mean, m.p99, m.max};
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
  return text.str();
}
