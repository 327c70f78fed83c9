// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A mesh of OpenMesh, through CGAL's adaptor.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/compute_cut_locus.h>
#include <CGAL/Cut_loci/IO/write_cut_locus.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh, filename))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto cut_locus = CGAL::compute_cut_locus(mesh, *vertices(mesh).begin());
  std::cout << "a cut locus of " << num_edges(cut_locus.graph()) << " edges on a surface of genus " << cut_locus.genus()
            << '\n';
  return CGAL::IO::write_cut_locus("cut_locus.obj", cut_locus) ? EXIT_SUCCESS : EXIT_FAILURE;
}
