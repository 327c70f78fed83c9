// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Sets of sources at random, and what holds for their cut loci whatever the method.

#ifndef SEVERAL_SOURCES_CASES_H
#define SEVERAL_SOURCES_CASES_H

#include "surface_test.h"
#include "checked_curves.h"

#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>

namespace several_sources {

using namespace surface_test;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Source = Solver::Source;

inline std::string fault_through_faces(const Built& built, const Result& result)
{
  namespace lib = CGAL::Cut_loci::internal;
  const auto read = lib::read_triangle_mesh(built.mesh, get(CGAL::vertex_point, built.mesh));
  const lib::Curve_on_component on = lib::on_component(read.mesh, lib::curve_on_mesh(read, built.mesh, result));
  return curve_measures::internal::Curve_topology(on.component.mesh, on.curve.graph).fault(result.number_of_sources());
}

// the number of the disk that each face is in
inline std::vector<std::size_t> disks_of_faces(const Built& built, const Result& result)
{
  const auto& graph = result.graph();
  std::set<Mesh::Edge_index> is_cut;
  for(const auto e : CGAL::make_range(edges(graph)))
    is_cut.insert(built.mesh.edge(graph[e].mesh_halfedge));
  topology_checker::Union_find faces(built.mesh.number_of_faces());
  for(const Mesh::Edge_index e : built.mesh.edges())
    if(!built.mesh.is_border(e) && is_cut.count(e) == 0)
      faces.unite(built.mesh.face(built.mesh.halfedge(e, 0)), built.mesh.face(built.mesh.halfedge(e, 1)));
  std::vector<std::size_t> part;
  for(std::size_t f = 0; f < built.mesh.number_of_faces(); ++f)
    part.push_back(faces.find(f));
  return part;
}

// each source touches a disk of its own
inline std::string fault_of_cells(const Built& built, const Result& result)
{
  const std::vector<std::size_t> disk = disks_of_faces(built, result);
  std::map<std::size_t, std::set<std::size_t>> at_disk;
  for(std::size_t i = 0; i < result.number_of_sources(); ++i)
  {
    const Location& at = result.source(i).location;
    at_disk[disk[at.first]].insert(i);
    Mesh::Halfedge_index h = built.mesh.halfedge(at.first);
    for(std::size_t k = 0; k < 3; ++k, h = built.mesh.next(h))
    {
      if(at.second[k] == 1.)
        for(const Mesh::Face_index f : built.mesh.faces_around_target(built.mesh.opposite(h)))
          if(f != Mesh::null_face())
            at_disk[disk[f]].insert(i);
      if(at.second[(k + 2) % 3] == 0. && !built.mesh.is_border(built.mesh.opposite(h)))
        at_disk[disk[built.mesh.face(built.mesh.opposite(h))]].insert(i);
    }
  }
  return at_disk.size() == result.number_of_sources() ? "" : "some disks hold no source";
}

inline std::string fault_of_mesh_edges(const Built& built, const Result& result)
{
  const topology_checker::Surface surface(built.data.triangles, 0);
  const std::string fault = topology_checker::fault(surface, cut_of(built, result), result.number_of_sources());
  return fault.empty() ? fault_of_cells(built, result) : fault;
}

inline double diagonal(const Built& built)
{
  Point low = built.data.points[0], high = low;
  for(const Point& p : built.data.points)
    for(std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  return norm(high - low);
}

// The distances from each source alone, to the vertices and the nodes of a curve.
struct Distances
{
  std::vector<std::vector<double>> to_vertex, to_node;

  Distances(const Built& built, const std::vector<Source>& sources, const Result& result)
  {
    Geodesics exact(built.mesh);
    for(const auto v : CGAL::make_range(vertices(result.graph())))
      exact.add_query(result.graph()[v].location);
    for(const Source& s : sources)
    {
      exact.clear_sources();
      std::visit([&](const auto& point) { exact.add_source(point); }, s);
      exact.compute();
      to_vertex.emplace_back();
      for(const Mesh::Vertex_index v : built.vertices)
        to_vertex.back().push_back(exact.distance(v));
      to_node.emplace_back();
      for(std::size_t i = 0; i < num_vertices(result.graph()); ++i)
        to_node.back().push_back(exact.distance(Geodesics::Query{i}));
    }
  }

  static double least(const std::vector<std::vector<double>>& to, std::size_t i)
  {
    double result = to[0][i];
    for(const auto& d : to)
      result = (std::min)(result, d[i]);
    return result;
  }
};

// Distinct vertices, points of edges and points in faces.
inline std::vector<Source> random_sources(const Built& built, std::size_t k, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Source> result;
  std::set<std::size_t> taken;
  while(result.size() < k)
  {
    const std::size_t kind = engine() % 3, f = engine() % built.faces.size();
    const double a = 0.05 + 0.2 * (1. + random_unit(engine)), b = 0.05 + 0.2 * (1. + random_unit(engine));
    if(kind == 0)
    {
      const std::size_t v = engine() % built.vertices.size();
      if(taken.insert(v).second)
        result.push_back(built.vertices[v]);
    }
    else
      result.push_back(Location(built.faces[f], kind == 1 ? std::array<double, 3>{{1. - a - b, a, b}}
                                                          : std::array<double, 3>{{a, 0., 1. - a}}));
  }
  return result;
}

struct Named_sources
{
  std::string name;
  std::vector<Source> sources;
};

// in one face of a mesh, which is in the middle of its list
inline std::vector<Named_sources> close_sources(const Built& built)
{
  const auto& t = built.data.triangles[built.data.triangles.size() / 2];
  const Mesh::Face_index f = built.faces[built.data.triangles.size() / 2];
  const std::array<Mesh::Vertex_index, 3> v = {{built.vertices[t[0]], built.vertices[t[1]], built.vertices[t[2]]}};
  return {{"adjacent vertices", {v[0], v[1]}},
          {"the vertices of a face", {v[0], v[1], v[2]}},
          {"two points of a face", {Location(f, {{0.3, 0.3, 0.4}}), Location(f, {{0.2, 0.7, 0.1}})}},
          {"two points of an edge", {Location(f, {{0.3, 0.7, 0.}}), Location(f, {{0.6, 0.4, 0.}})}},
          {"a point of a face and its vertices", {Location(f, {{0.3, 0.3, 0.4}}), v[0], v[1], v[2]}},
          {"an edge and its ends", {v[0], v[1], v[2], Location(f, {{0.5, 0.5, 0.}}), Location(f, {{0., 0.5, 0.5}})}},
          {"one point enclosed by others in a face",
           {Location(f, {{1. / 3., 1. / 3., 1. / 3.}}), Location(f, {{0.4, 0.3, 0.3}}), Location(f, {{0.3, 0.4, 0.3}}),
            Location(f, {{0.3, 0.3, 0.4}})}},
          {"a vertex and a point right beside it", {v[0], Location(f, {{1. - 2e-6, 1e-6, 1e-6}})}}};
}

inline std::vector<Named_mesh> meshes()
{
  return {{"sphere", jittered_sphere(6, 0.2, 1)},
          {"convex", random_convex_polyhedron(60, 1)},
          {"cuboid", cuboid({{3., 1., 0.4}}, 2)},
          {"bumpy sphere", bumpy_sphere(7, 0.5, 3)},
          {"torus", torus(1., 0.4, 20, 10, 0.2, 4)},
          {"regular torus", torus(1., 0.4, 16, 8)},
          {"genus 2", perforated_plate(2, 1, 2, 5)},
          {"genus 3", perforated_plate(3, 1, 2, 6)},
          {"square", square(7, 0.2, 1)},
          {"cylinder", cylinder(1., 14, 5, 0.1, 4)},
          {"square with holes", square_with_holes(2, 2)},
          {"torus with holes", punctured(torus(1., 0.4, 30, 16, 0.1, 2), {{{1.4, 0., 0.}}, {{-1., 0., 0.4}}}, 0.25)}};
}

} // namespace several_sources

#endif // SEVERAL_SOURCES_CASES_H
