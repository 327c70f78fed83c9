// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_cut_locus.h>

// The compiler has to refuse this: a cut locus that ignored the excluded faces would be taken for one that does not.

int main()
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  const auto excluded = mesh.add_property_map<Mesh::Face_index, bool>("f:excluded", false).first;
  CGAL::compute_cut_locus(mesh, Mesh::Vertex_index(0), CGAL::parameters::face_is_excluded_map(excluded));
  return 0;
}
