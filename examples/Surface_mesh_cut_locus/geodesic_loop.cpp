// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The two shortest paths to the point of the cut locus that is nearest to the source, as a closed polyline.

#include <CGAL/Cut_loci/geodesic_loop.h>
#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/compute_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto cut_locus = CGAL::compute_cut_locus(mesh, *mesh.vertices().begin());
  const std::vector<Kernel::Point_3> loop = CGAL::Cut_loci::geodesic_loop(mesh, cut_locus);
  double length = 0.;
  for(std::size_t i = 0; i + 1 < loop.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(loop[i], loop[i + 1]));
  std::cout << "The geodesic loop has the length " << length << ", twice the injectivity radius "
            << CGAL::Cut_loci::injectivity_radius(cut_locus).distance << ".\n";

  std::ofstream out("geodesic_loop.polylines.txt");
  out.precision(17);
  out << loop.size();
  for(const Kernel::Point_3& p : loop)
    out << ' ' << p;
  out << '\n';
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
