// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Draws what the method of the paper goes through, for the manual: draw_stages STAGE MESH FILE.png SOURCE VIEW, where STAGE
// is laplacian, tree, disk or closed-form, SOURCE is a point, to which the nearest vertex is taken, VIEW the direction to
// the eye, and both are three numbers with commas. With closed-form the mesh is the torus that generate_mesh writes, and
// the source on one of its equators.

#include "analytic_surfaces.h"
#include "mesh_files.h"
#include "picture_files.h"
#include "test_meshes.h"
#include "views.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/extract_polylines.h>
#include <CGAL/Cut_loci/injectivity_radius.h>
#include <CGAL/Cut_loci/laplacian/Laplacian_solver.h>
#include <CGAL/Exact_geodesic_solver.h>
#include <CGAL/compute_cut_locus.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Cut_loci;
using namespace CGAL::Cut_loci::internal;
using picture::Color;
using picture::Vector;

constexpr Color red = {0.80, 0.05, 0.16}, blue = {0.08, 0.33, 0.80}, light_blue = {0.45, 0.70, 1.},
                green = {0.1, 0.6, 0.2}, pale = {0.86, 0.88, 0.91}, orange = {1., 0.78, 0.45};

Vector read_vector(const std::string& text)
{
  Vector v;
  if(std::sscanf(text.c_str(), "%lf,%lf,%lf", &v[0], &v[1], &v[2]) != 3)
    throw std::runtime_error(text + " is not three numbers with commas between them");
  return v;
}

Color between(const Color& a, const Color& b, double t)
{
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

// with the strengths of the vertices, from exact distances
std::unique_ptr<Laplacian_solver> with_strengths(const Indexed_triangle_mesh& mesh, Index source_vertex)
{
  auto solver = std::make_unique<Laplacian_solver>(mesh, Laplacian_operator::QUADRATIC_FIT);
  Indexed_source source;
  source.vertex = source_vertex;
  source.location = location_of_vertex(solver->connectivity(), source_vertex);
  CGAL::Exact_geodesic_solver exact;
  exact.set_mesh(mesh);
  std::vector<double> distance;
  exact.compute_distances(source, distance);
  solver->set_distance({source}, distance);
  solver->compute_strengths();
  return solver;
}

auto by_method_of_paper(const analytic::Mesh& mesh, Index source)
{
  return CGAL::compute_cut_locus(mesh, analytic::Mesh::Vertex_index(source),
                                 CGAL::parameters::cut_locus_method(Laplacian_method()));
}

class Drawing
{
public:
  Drawing(const std::string& mesh_file, const Vector& near)
    : data_(test_meshes::read_mesh(mesh_file)), mesh_(test_meshes::indexed(data_)),
      surface_(test_meshes::read_surface_mesh<analytic::Mesh>(mesh_file))
  {
    scene.points = data_.points;
    for(const auto& t : mesh_.triangles)
      scene.triangles.push_back({{t[0], t[1], t[2]}});
    const auto is_nearer = [&](const Vector& p, const Vector& q)
    { return picture::length(p - near) < picture::length(q - near); };
    source_ =
      static_cast<Index>(std::min_element(data_.points.begin(), data_.points.end(), is_nearer) - data_.points.begin());
    scene.dots.push_back({data_.points[source_], blue, 9.});
  }

  // Where it is low, as along the valleys that the tree grows along, faces are dark.
  void laplacian()
  {
    const auto solver = with_strengths(mesh_, source_);
    for(const auto& t : mesh_.triangles)
    {
      double sum = 0.;
      for(Index v : t)
        sum -= (std::min)(0.f, solver->laplacian()[v]) / 3.;
      scene.colors.push_back(between(pale, blue, (std::min)(1., std::sqrt(sum))));
    }
  }

  // The spanning tree, and the edges that homology demands beside it.
  void tree()
  {
    const auto solver = with_strengths(mesh_, source_);
    const Mesh_connectivity& connectivity = solver->connectivity();
    Way_forest forest(mesh_, connectivity, solver->roots(), solver->distance());
    forest.grow({});
    const std::vector<unsigned char> crossed = forest.ways([](Index) { return true; }).is_crossed;
    const Spanning_tree tree =
      region_growing_tree(connectivity, solver->laplacian(), solver->farthest(), solver->roots().elements(), crossed);
    for(Index v : tree.order)
      if(v != tree.root)
        add_line({data_.points[v], data_.points[tree.parent[v]]}, red, 2.);
    for(Index h : homology_generators(mesh_, connectivity, tree, solver->distance(), solver->roots(), crossed))
      add_line({data_.points[mesh_.source(h)], data_.points[mesh_.target(h)]}, green, 6.);
  }

  // The largest one around the source in which shortest paths are unique.
  void disk()
  {
    const auto cut_locus = by_method_of_paper(surface_, source_);
    const auto radius = injectivity_radius(cut_locus);
    for(const auto& t : mesh_.triangles)
    {
      double sum = 0.;
      for(Index v : t)
        sum += cut_locus.distance(analytic::Mesh::Vertex_index(v)) / 3.;
      scene.colors.push_back(sum < radius.distance ? orange : pale);
    }
    add_curves(extract_polylines(cut_locus), red, 4.);
    scene.dots.push_back({{{radius.point.x(), radius.point.y(), radius.point.z()}}, red, 7.});
  }

  // The cut locus of a point of an equator of a torus over the one that is known.
  void closed_form()
  {
    const analytic::Torus torus;
    const Vector& p = data_.points[source_];
    const double u = std::atan2(p[1], p[0]);
    add_curves(std::hypot(p[0], p[1]) > torus.R ? torus.cut_locus_of_outer_equator(u, 0.01)
                                                : torus.cut_locus_of_inner_equator(u, 0.01),
               light_blue, 11.);
    add_curves(extract_polylines(by_method_of_paper(surface_, source_)), red, 4.);
  }

  picture::Scene scene;

private:
  void add_line(const std::vector<Vector>& points, const Color& color, double width)
  {
    scene.polylines.push_back({points, color, width});
  }

  template <typename Curves>
  void add_curves(const Curves& curves, const Color& color, double width)
  {
    for(const auto& curve : curves)
    {
      std::vector<Vector> points;
      for(const auto& p : curve)
        points.push_back({{p.x(), p.y(), p.z()}});
      add_line(points, color, width);
    }
  }

  test_meshes::Mesh_data data_;
  Indexed_triangle_mesh mesh_;
  analytic::Mesh surface_; // the same
  Index source_;
};

void draw(const std::vector<std::string>& arguments)
{
  if(arguments.size() != 5)
    throw std::runtime_error("usage: draw_stages STAGE MESH FILE.png SOURCE VIEW");
  const std::map<std::string, void (Drawing::*)()> stages = {{"laplacian", &Drawing::laplacian},
                                                             {"tree", &Drawing::tree},
                                                             {"disk", &Drawing::disk},
                                                             {"closed-form", &Drawing::closed_form}};
  const auto stage = stages.find(arguments[0]);
  if(stage == stages.end())
    throw std::runtime_error("there is no stage " + arguments[0]);
  Drawing drawing(arguments[1], read_vector(arguments[3]));
  (drawing.*stage->second)();
  const picture::View view = picture::look_from(read_vector(arguments[4]), picture::guess_up(drawing.scene));
  std::vector<picture::Rendered_view> rendered;
  for(const picture::Frame& frame : picture::make_frames(drawing.scene, {view}, 900))
    rendered.push_back(picture::render(drawing.scene, frame));
  std::ofstream out(arguments[2], std::ios::binary);
  picture::write_png(out, rendered);
  if(!out.flush())
    throw std::runtime_error("cannot write " + arguments[2]);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    draw({argv + 1, argv + argc});
  }
  catch(const std::exception& error)
  {
    std::cerr << "draw_stages: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
