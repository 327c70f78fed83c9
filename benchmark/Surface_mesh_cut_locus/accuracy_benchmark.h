// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H
#define CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H

#include "analytic_surfaces.h"
#include "curve_distance.h"
#include "remeshed_surface.h"

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <boost/program_options.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

// What the benchmarks of accuracy have in common.
namespace analytic {

template <typename Cut_locus>
Polylines segments_of(const Cut_locus& cut_locus)
{
  Polylines result;
  const auto& g = cut_locus.graph();
  for(auto e : CGAL::make_range(edges(g)))
    result.push_back({g[source(e, g)].point, g[target(e, g)].point});
  if(result.empty())
    result.push_back({g[cut_locus.root()].point});
  return result;
}

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

// Reads the command line. If the program has nothing to do, because of an error or for `--help`, it ends here.
inline void read_options(int argc, char** argv, const boost::program_options::options_description& options)
{
  namespace po = boost::program_options;
  po::variables_map values;
  try
  {
    po::store(po::parse_command_line(argc, argv, options), values);
    po::notify(values);
  }
  catch(const po::error& error)
  {
    std::cerr << error.what() << "\n";
    std::exit(EXIT_FAILURE);
  }
  if(values.count("help"))
  {
    std::cout << options;
    std::exit(EXIT_SUCCESS);
  }
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_ACCURACY_BENCHMARK_H
