// A foreign project: the program in the README, and the named parameters of the package and CGAL's chain in any order.
#define main program_of_readme
#include "readme.h"
#undef main

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/compute_cut_locus.h>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto cut_locus =
    CGAL::compute_cut_locus(mesh, *vertices(mesh).begin(),
                            CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, mesh)).minimum_branch_edges(1));
  return num_vertices(cut_locus.graph()) > 0 ? program_of_readme() : EXIT_FAILURE;
}
