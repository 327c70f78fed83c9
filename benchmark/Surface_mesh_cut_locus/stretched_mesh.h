// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_STRETCHED_MESH_H
#define CGAL_CUT_LOCI_BENCHMARK_STRETCHED_MESH_H

#include "remeshed_surface.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Meshes of analytic surfaces with some given points as vertices, and changes of them that leave these points alone.
namespace analytic {

inline Mesh::Vertex_index nearest_vertex(const Mesh& mesh, const Point& p)
{
  Mesh::Vertex_index nearest = *mesh.vertices().begin();
  for(Mesh::Vertex_index v : mesh.vertices())
    if(CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(nearest), p))
      nearest = v;
  return nearest;
}

inline Mesh::Vertex_index vertex_at(const Mesh& mesh, const Point& p)
{
  const Mesh::Vertex_index v = nearest_vertex(mesh, p);
  if(CGAL::squared_distance(mesh.point(v), p) > 1e-20)
    throw std::runtime_error("the mesh has no vertex at the source");
  return v;
}

inline void scale_x(Mesh& mesh, double factor)
{
  for(Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
}

// the cosine of the angle between the normal of a triangle and that of the surface
template <typename Surface>
double alignment(const Surface& surface, const Mesh& mesh, const std::array<Mesh::Vertex_index, 3>& v)
{
  const Vector n = CGAL::normal(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
  Vector mean = CGAL::NULL_VECTOR;
  for(Mesh::Vertex_index w : v)
    mean = mean + surface.normal(mesh.point(w));
  return n * mean / std::sqrt(n.squared_length() * mean.squared_length());
}

template <typename Surface>
double alignment(const Surface& surface, const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return alignment(surface, mesh, {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
}

// Flips an edge of each triangle that is far from the surface, if its two triangles are nearer to it then.
template <typename Surface>
void unfold(const Surface& surface, Mesh& mesh)
{
  for(Mesh::Face_index f : mesh.faces())
  {
    Mesh::Halfedge_index best = mesh.null_halfedge();
    double gain = 0.;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    {
      const Mesh::Vertex_index a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h)),
                               d = mesh.target(mesh.next(mesh.opposite(h)));
      if(CGAL::halfedge(c, d, mesh).second)
        continue;
      const double before = (std::min)(alignment(surface, mesh, {{a, b, c}}), alignment(surface, mesh, {{b, a, d}}));
      const double after = (std::min)(alignment(surface, mesh, {{a, d, c}}), alignment(surface, mesh, {{d, b, c}}));
      if(before < 0.5 && after - before > gain)
      {
        gain = after - before;
        best = h;
      }
    }
    if(best != mesh.null_halfedge())
      CGAL::Euler::flip_edge(best, mesh);
  }
}

template <typename Surface>
void check_orientation(const Surface& surface, const Mesh& mesh)
{
  for(Mesh::Face_index f : mesh.faces())
    if(alignment(surface, mesh, f) <= 0.)
      throw std::runtime_error("a triangle is folded");
}

// A mesh of about `faces` triangles that are `aspect` times as long along x as they are wide: points are squeezed by
// this factor, remeshed isotropically, and stretched again.
template <typename Surface>
Mesh stretched_mesh(const Surface& surface, double aspect, std::size_t faces, const std::vector<Point>& fixed)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto length_for = [&](const Mesh& squeezed)
  { return std::sqrt(4. / std::sqrt(3.) * PMP::area(squeezed) / static_cast<double>(faces)); };
  Mesh mesh = surface.grid(0.1);
  scale_x(mesh, 1. / aspect);
  const double length = length_for(mesh);

  mesh = surface.grid(1.3 * length);
  auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first;
  for(const Point& p : fixed)
    is_fixed[snap_vertex(mesh, p)] = true;
  for(int i = 0; i < 3; ++i)
  {
    scale_x(mesh, 1. / aspect);
    PMP::isotropic_remeshing(
      CGAL::faces(mesh), length, mesh,
      CGAL::parameters::number_of_iterations(i == 0 ? 4 : 2).vertex_is_constrained_map(is_fixed));
    scale_x(mesh, aspect);
    project(surface, mesh);
  }
  mesh.collect_garbage();
  mesh.remove_property_map(is_fixed);
  for(const Point& p : fixed)
    mesh.point(nearest_vertex(mesh, p)) = p; // without the rounding of the projection
  for(int i = 0; i < 3; ++i)
    unfold(surface, mesh);
  check_orientation(surface, mesh);
  return mesh;
}

inline std::string number_in_name(double x)
{
  std::ostringstream out;
  out << x;
  return out.str();
}

// the same from the folder `cache` if it was made before
template <typename Surface>
Mesh stretched_mesh(const Surface& surface, const std::string& name, double aspect, std::size_t faces,
                    const std::vector<Point>& fixed, const std::string& cache)
{
  const std::string file =
    cache.empty() ? "" : cache + "/" + name + "_" + number_in_name(aspect) + "_" + std::to_string(faces) + ".off";
  Mesh mesh;
  if(!file.empty() && std::ifstream(file).good() && CGAL::IO::read_OFF(file, mesh))
    return mesh;
  mesh = stretched_mesh(surface, aspect, faces, fixed);
  if(!file.empty() && !CGAL::IO::write_OFF(file, mesh, CGAL::parameters::stream_precision(17)))
    throw std::runtime_error("cannot write " + file);
  return mesh;
}

inline bool is_among(const Point& p, const std::vector<Point>& points)
{
  return std::any_of(points.begin(), points.end(),
                     [&](const Point& q) { return CGAL::squared_distance(p, q) < 1e-20; });
}

// Moves the vertices along the surface, by up to a quarter of an edge in each coordinate, where no triangle gets folded.
template <typename Surface>
void jitter(const Surface& surface, Mesh& mesh, const std::vector<Point>& fixed)
{
  const double h = mean_edge_length(mesh);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random(-0.25 * h, 0.25 * h);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    const Vector move(random(generator), random(generator), random(generator));
    if(is_among(p, fixed))
      continue;
    mesh.point(v) = surface.project(p + move);
    for(Mesh::Face_index f : CGAL::faces_around_target(mesh.halfedge(v), mesh))
      if(alignment(surface, mesh, f) < 0.5)
      {
        mesh.point(v) = p;
        break;
      }
  }
}

// Moves the vertices along the normals, by a normal deviate of `amplitude` edges.
template <typename Surface>
void add_noise(const Surface& surface, Mesh& mesh, double amplitude, const std::vector<Point>& fixed)
{
  const double h = mean_edge_length(mesh);
  std::mt19937 generator(2);
  std::normal_distribution<double> random(0., amplitude * h);
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const double move = random(generator);
    if(!is_among(mesh.point(v), fixed))
      mesh.point(v) = mesh.point(v) + move * surface.normal(mesh.point(v));
  }
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_STRETCHED_MESH_H
