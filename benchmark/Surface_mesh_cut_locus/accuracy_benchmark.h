// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H
#define CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H

#include "analytic_surfaces.h"
#include "command_line.h"
#include "curve_distance.h"
#include "remeshed_surface.h"

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <fstream>
#include <string>

// What the benchmarks of accuracy have in common.
namespace analytic {

// The mesh of the surface with edges of about `length`, from the folder `cache` if it was made before.
template <typename Surface>
Mesh cached_mesh(const Surface& surface, const std::string& name, double length, const std::string& cache)
{
  const std::string file = cache.empty() ? "" : cache + "/" + name + "_" + std::to_string(length) + ".off";
  Mesh mesh;
  if(!file.empty() && std::ifstream(file).good() && CGAL::IO::read_OFF(file, mesh))
    return mesh;
  mesh = remeshed(surface, length);
  if(!file.empty())
    CGAL::IO::write_OFF(file, mesh, CGAL::parameters::stream_precision(17));
  return mesh;
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H
