// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cut locus of one vertex after another, in threads if TBB is linked: which of them has the largest injectivity
// radius? Of each cut locus only that is kept.

#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/compute_cut_loci.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Cut_locus = CGAL::Surface_mesh_cut_locus<Mesh>::Result;

int main(int argc, char* argv[])
try
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  const std::size_t step = argc > 2 ? std::stoul(argv[2]) : 10;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh) || step == 0)
  {
    std::cerr << "Usage: largest_injectivity_radius MESH [EVERY_NTH_VERTEX]" << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<Mesh::Vertex_index> sources;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(v.idx() % step == 0)
      sources.push_back(v);

  std::vector<double> radius;
  const auto keep_radius = [&](const Cut_locus& cut_locus)
  { radius.push_back(CGAL::Cut_loci::injectivity_radius(cut_locus).distance); };
  CGAL::compute_cut_loci(mesh, sources, boost::make_function_output_iterator(keep_radius),
                         CGAL::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()));

  const auto best = std::max_element(radius.begin(), radius.end());
  std::cout << "Of " << sources.size() << " vertices, " << sources[static_cast<std::size_t>(best - radius.begin())]
            << " has the largest injectivity radius: " << *best << "\n";
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
