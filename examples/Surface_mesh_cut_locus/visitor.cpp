// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// A visitor: it takes the time of the stages, and cancels if the whole takes too long.

#include <CGAL/Cut_loci/Default_visitor.h>
#include <CGAL/Surface_mesh_cut_locus.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CGAL::Cut_loci::Stage;

struct Canceled : public std::runtime_error
{
  Canceled() : std::runtime_error("it takes too long") {}
};

class Stopwatch : public CGAL::Cut_loci::Default_visitor
{
public:
  std::map<Stage, double> seconds;

  explicit Stopwatch(double most) : most_(most) { timer_.start(); }

  void start_stage(Stage)
  {
    start_ = timer_.time();
    if(start_ > most_)
      throw Canceled(); // the solver can be used again
  }

  void end_stage(Stage stage) { seconds[stage] += timer_.time() - start_; }

private:
  double most_, start_ = 0.;
  CGAL::Real_timer timer_;
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/double_torus.off";
  const double most = argc > 2 ? std::stod(argv[2]) : 60.;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_empty(mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Stopwatch stopwatch(most);
  try
  {
    CGAL::Surface_mesh_cut_locus<Mesh> solver(mesh, CGAL::parameters::visitor(std::ref(stopwatch)));
    solver.set_source(*mesh.vertices().begin());
    const auto cut_locus = solver.cut_locus();
    std::cout << num_edges(cut_locus.graph()) << " edges\n";
  }
  catch(const Canceled& error)
  {
    std::cout << error.what() << '\n';
  }
  std::cout << "distances: " << stopwatch.seconds[Stage::DISTANCE]
            << " s, thresholds: " << stopwatch.seconds[Stage::FILTER] << " s\n";
  return EXIT_SUCCESS;
}
