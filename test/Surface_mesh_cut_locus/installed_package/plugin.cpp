// What a program loads while it runs: the compiled library becomes a part of a shared one.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/compute_cut_locus.h>

#include <cstddef>

extern "C" std::size_t number_of_edges()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  return num_edges(CGAL::compute_cut_locus(mesh, *vertices(mesh).begin()).graph());
}
