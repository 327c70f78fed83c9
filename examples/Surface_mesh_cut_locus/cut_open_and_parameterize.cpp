// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Cuts a surface open along the cut locus of a point, where nobody who looks at the point sees the seams, and flattens
// it: once as a mesh of its own, and once with CGAL::Seam_mesh, without a copy.

#include <CGAL/compute_cut_locus.h>
#include <CGAL/cut_along_cut_locus.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  // seams are edges of the mesh: the default curve runs through the faces
  const auto cut_locus = CGAL::compute_cut_locus(mesh, *mesh.vertices().begin(),
                                                 CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES));

  Mesh disk;
  const auto origin = disk.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("v:origin").first;
  CGAL::cut_along_cut_locus(mesh, cut_locus, disk, CGAL::parameters::vertex_to_vertex_map(origin));
  std::cout << "The disk has " << disk.number_of_vertices() << " vertices, the surface " << mesh.number_of_vertices()
            << ".\n";

  const auto uv = disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(disk).first;
  if(SMP::parameterize(disk, border, uv) != SMP::OK)
    return EXIT_FAILURE;
  std::ofstream out("parameterized.off");
  SMP::IO::output_uvmap_to_off(disk, border, uv, out);

  const Edge_map seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const Vertex_map seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  const Mesh::Halfedge_index seam = CGAL::mark_cut_locus_seams(mesh, cut_locus, seam_edges, seam_vertices);
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  std::cout << "So has the mesh with seams: " << num_vertices(seam_mesh) << ".\n";

  // a vertex of a seam has several places in the plane: one for each corner, that is, for each halfedge to it
  using Seam_halfedge = boost::graph_traits<Seam_mesh>::halfedge_descriptor;
  const auto corner_uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const Seam_halfedge on_border = opposite(Seam_halfedge(seam), seam_mesh);
  if(SMP::parameterize(seam_mesh, on_border, corner_uv) != SMP::OK)
    return EXIT_FAILURE;
  std::ofstream seam_out("parameterized_with_seams.off");
  SMP::IO::output_uvmap_to_off(seam_mesh, on_border, corner_uv, seam_out);
  return EXIT_SUCCESS;
}
