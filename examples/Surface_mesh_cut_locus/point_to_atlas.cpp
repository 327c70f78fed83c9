// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// From a point in space to an atlas file: the point of the surface next to it is the source, the surface is cut open along
// straight seams, as far from the source as they can be, and flattened. With progress, and with an answer to bad input.

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/compute_cut_locus.h>
#include <CGAL/cut_along_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;
using CGAL::Cut_loci::Stage;

struct Progress : public CGAL::Cut_loci::Default_visitor
{
  void start_stage(Stage stage) const
  {
    switch(stage)
    {
    case Stage::PREPROCESSING:
      std::cerr << "reading the mesh\n";
      break;
    case Stage::DISTANCE:
      std::cerr << "distances\n";
      break;
    case Stage::FILTER:
      std::cerr << "branches\n";
      break;
    default:
      break;
    }
  }
};

// Texture coordinates may be outside of [0, 1]: whoever draws them scales them to the texture.
bool write_atlas(const std::string& filename, const Mesh& disk, const UV_map& uv)
{
  std::ofstream out(filename);
  out.precision(17);
  for(const Mesh::Vertex_index v : disk.vertices())
    out << "v " << disk.point(v) << "\nvt " << uv[v] << '\n';
  for(const Mesh::Face_index f : disk.faces())
  {
    out << 'f';
    for(const Mesh::Vertex_index v : disk.vertices_around_face(disk.halfedge(f)))
      out << ' ' << v.idx() + 1 << '/' << v.idx() + 1;
    out << '\n';
  }
  return bool(out.flush());
}

int main(int argc, char* argv[])
{
  if(argc != 1 && argc != 6)
  {
    std::cerr << "Usage: point_to_atlas [MESH X Y Z ATLAS.obj]" << std::endl;
    return EXIT_FAILURE;
  }
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off", atlas = argc > 1 ? argv[5] : "atlas.obj";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  if(!CGAL::is_triangle_mesh(mesh))
    PMP::triangulate_faces(mesh);

  Mesh disk;
  try
  {
    const Kernel::Point_3 query =
      argc > 1 ? Kernel::Point_3(std::stod(argv[2]), std::stod(argv[3]), std::stod(argv[4])) : Kernel::Point_3(0, 0, 1);
    const auto source = PMP::locate(query, mesh); // a face and barycentric coordinates
    const auto cut_locus = CGAL::compute_cut_locus(mesh, source, CGAL::parameters::visitor(Progress()));
    CGAL::cut_along_cut_locus(mesh, cut_locus, disk);
  }
  catch(const std::invalid_argument& error) // Cut_loci::Invalid_input is one: it names the cause and the element
  {
    std::cerr << filename << ": " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  const UV_map uv = disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  // mean value coordinates on a circle: nothing flips or overlaps, at the price of distortion
  const SMP::Error_code status = SMP::parameterize(disk, PMP::longest_border(disk).first, uv);
  if(status != SMP::OK)
  {
    std::cerr << "The disk is not flattened: " << SMP::get_error_message(status) << std::endl;
    return EXIT_FAILURE;
  }
  if(!write_atlas(atlas, disk, uv))
  {
    std::cerr << "Cannot write " << atlas << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << atlas << " has " << disk.number_of_faces() << " faces.\n";
  return EXIT_SUCCESS;
}
