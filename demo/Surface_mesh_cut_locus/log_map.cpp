// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "log_map.h"

std::string cause_of_no_log_map(const Options& options)
{
  if(has_curves(options))
    return "the paths from a curve start at no single point";
  if(options.solver != "exact")
    return "it takes --solver exact";
  return options.maximum_relative_error.value_or(0.) > 0. ? "it takes distances without --max-relative-error" : "";
}

std::unique_ptr<Log_map> log_map(const Mesh& mesh, const Cut_locus& cut_locus)
{
  auto result = std::make_unique<Log_map>(mesh);
  result->set_directions(true);
  for(std::size_t i = 0; i < cut_locus.number_of_sources(); ++i)
    result->add_source(cut_locus.source(i).location);
  result->compute();
  return result;
}
