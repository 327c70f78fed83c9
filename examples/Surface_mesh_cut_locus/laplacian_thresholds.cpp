// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The thresholds of Cut_loci::Laplacian_method, which follow a slider: an angle, a value of the Laplacian, and the policy.

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/statistics.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace params = CGAL::parameters;
using CGAL::Cut_loci::Laplacian_method;

template <typename Cut_locus>
void describe(const std::string& what, const Cut_locus& cut_locus)
{
  const auto statistics = CGAL::Cut_loci::compute_statistics(cut_locus);
  std::cout << what << ": " << statistics.leaves << " tips, " << statistics.cycles << " cycles, length "
            << statistics.length << '\n';
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, params::cut_locus_method(Laplacian_method()));
  solver.set_source(*mesh.vertices().begin());
  for(const double angle : {0.1, 0.4, Laplacian_method().gradient_angle_threshold(), 1.5}) // radians
    describe("shortest paths meet at " + std::to_string(angle) + " or more",
             solver.cut_locus(params::cut_locus_method(Laplacian_method().gradient_angle_threshold(angle))));
  describe("the Laplacian is at most -0.5, for edges of the length 1",
           solver.cut_locus(
             params::cut_locus_method(Laplacian_method().gradient_angle_threshold(0.).laplacian_threshold(0.5))));
  describe("as far from the farthest vertex as it is strong",
           solver.cut_locus(
             params::cut_locus_method(Laplacian_method().filter_policy(CGAL::Cut_loci::Filter_policy::GROWING))));
  describe("branches of ten edges and more",
           solver.cut_locus(params::cut_locus_method(Laplacian_method().minimum_branch_edges(10))));
  describe("edges of the mesh", solver.cut_locus(params::cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES)));
  return EXIT_SUCCESS;
}
