// A foreign project: the program in the README, the named parameters of the package and CGAL's chain in any order, and
// plugins that use the package are loaded.
#define main program_of_readme
#include "readme.h"
#undef main

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/compute_cut_locus.h>

#include <dlfcn.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

bool runs(const char* plugin)
{
  void* const library = dlopen(plugin, RTLD_NOW);
  void* const function = library != nullptr ? dlsym(library, "number_of_edges") : nullptr;
  if(function == nullptr)
    std::cerr << dlerror() << std::endl;
  return function != nullptr && reinterpret_cast<std::size_t (*)()>(function)() > 0;
}

int main()
{
  if(!runs(PLUGIN))
    return EXIT_FAILURE;
#ifdef PLUGIN_BY_PKGCONFIG
  if(!runs(PLUGIN_BY_PKGCONFIG))
    return EXIT_FAILURE;
#endif
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  const auto cut_locus =
    CGAL::compute_cut_locus(mesh, *vertices(mesh).begin(),
                            CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, mesh))
                              .cut_locus_method(CGAL::Cut_loci::Default_method().minimum_branch_edges(1)));
  return num_vertices(cut_locus.graph()) > 0 ? program_of_readme() : EXIT_FAILURE;
}
