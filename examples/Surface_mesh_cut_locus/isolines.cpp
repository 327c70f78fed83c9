// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Geodesics geodesics(mesh);
  geodesics.set_isolines(true);
  geodesics.compute(*mesh.vertices().begin());
  double farthest = 0.;
  for(const Mesh::Vertex_index v : mesh.vertices())
    farthest = (std::max)(farthest, geodesics.distance(v));

  std::vector<double> levels;
  for(int i = 1; i < 10; ++i)
    levels.push_back(0.1 * i * farthest);
  std::vector<Geodesics::Isoline> isolines;
  geodesics.isolines(levels, std::back_inserter(isolines), 1e-4 * farthest);

  // one polyline a line: the number of points, and their coordinates
  std::ofstream out("isolines.polylines.txt");
  for(const Geodesics::Isoline& line : isolines)
  {
    out << line.locations.size();
    for(const Geodesics::Face_location& location : line.locations)
      out << ' ' << CGAL::Polygon_mesh_processing::construct_point(location, mesh);
    out << '\n';
    std::cout << (line.is_closed ? "a closed" : "an open") << " isoline of " << line.locations.size()
              << " points at the distance " << line.level << '\n';
  }
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
