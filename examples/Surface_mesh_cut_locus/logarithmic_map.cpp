// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A decal: the surface around a point, with the logarithmic map as texture coordinates.

#include <CGAL/Surface_mesh_exact_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Geodesics = CGAL::Surface_mesh_exact_geodesics<Mesh>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  const double radius = argc > 2 ? std::stod(argv[2]) : 4.; // in the unit of the points
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // its center is in a face, and the x-axis along halfedge(face, mesh)
  const Mesh::Face_index face = *mesh.faces().begin();
  Geodesics geodesics(mesh);
  geodesics.set_directions(true);
  geodesics.set_maximum_distance(radius);
  geodesics.compute(Geodesics::Face_location(face, {{1. / 3., 1. / 3., 1. / 3.}}));

  std::ofstream obj("decal.obj");
  obj.precision(17);
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const std::array<double, 2> place = geodesics.logarithmic_map(v); // NaN further away
    const bool is_reached = !std::isnan(place[0]);
    obj << "v " << mesh.point(v) << "\nvt " << (is_reached ? 0.5 + 0.5 * place[0] / radius : 0.) << ' '
        << (is_reached ? 0.5 + 0.5 * place[1] / radius : 0.) << '\n';
  }
  std::size_t number_of_faces = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
    if(std::any_of(corners.begin(), corners.end(),
                   [&](Mesh::Vertex_index v) { return geodesics.distance(v) > radius; }))
      continue;
    obj << 'f';
    for(const Mesh::Vertex_index v : corners)
      obj << ' ' << v.idx() + 1 << '/' << v.idx() + 1;
    obj << '\n';
    ++number_of_faces;
  }
  std::cout << "decal.obj has " << number_of_faces << " faces within " << radius << " of the center of " << face
            << '\n';
  return number_of_faces > 0 && obj ? EXIT_SUCCESS : EXIT_FAILURE;
}
