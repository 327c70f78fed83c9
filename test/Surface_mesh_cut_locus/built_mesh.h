// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BUILT_MESH_H
#define CGAL_CUT_LOCI_BUILT_MESH_H

#include "topology_checker.h"

#include <CGAL/Cut_loci/Laplacian_method.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// A model of FaceListGraph made from plain arrays, with the way back to them.
template <typename Mesh_>
struct Built_mesh
{
  using Mesh = Mesh_;
  using Traits = boost::graph_traits<Mesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Point =
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Index_map = typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<std::size_t>>::type;

  explicit Built_mesh(const test_meshes::Mesh_data& d) : data(d)
  {
    add(d);
    finish();
  }
  Built_mesh(const Built_mesh&) = delete;

  std::size_t index(vertex_descriptor v) const { return get(index_map, v); }

  // barycentric coordinates given for data.triangles[f], in the order in which the mesh has the corners of this face
  template <typename FT>
  std::pair<face_descriptor, std::array<FT, 3>> location(std::size_t f, const std::array<double, 3>& coordinates) const
  {
    std::pair<face_descriptor, std::array<FT, 3>> result;
    result.first = faces[f];
    halfedge_descriptor h = halfedge(faces[f], mesh);
    for(int i = 0; i < 3; ++i, h = next(h, mesh))
      for(int j = 0; j < 3; ++j)
        if(data.triangles[f][j] == index(source(h, mesh)))
          result.second[i] = FT(coordinates[j]);
    return result;
  }

  test_meshes::Mesh_data data;
  Mesh mesh;
  std::vector<vertex_descriptor> vertices;
  std::vector<face_descriptor> faces;
  Index_map index_map;

protected:
  Built_mesh() = default;

  void add(const test_meshes::Mesh_data& d)
  {
    auto vpm = get(CGAL::vertex_point, mesh);
    for(const test_meshes::Point& p : d.points)
    {
      vertices.push_back(add_vertex(mesh));
      put(vpm, vertices.back(), Point(p[0], p[1], p[2]));
    }
    for(const test_meshes::Triangle& t : d.triangles)
    {
      const std::array<vertex_descriptor, 3> corners = {{vertices[t[0]], vertices[t[1]], vertices[t[2]]}};
      faces.push_back(CGAL::Euler::add_face(corners, mesh));
    }
  }

  void finish()
  {
    index_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
    const auto vpm = get(CGAL::vertex_point, mesh);
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      put(index_map, vertices[i], i);
      const auto& p = get(vpm, vertices[i]); // CGAL's map for OpenMesh rounds to single precision
      data.points[i] = {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
    }
  }
};

// The same in a CGAL::Surface_mesh from which elements before and after have been removed, but not yet collected.
template <typename Surface_mesh>
struct Built_mesh_with_garbage : public Built_mesh<Surface_mesh>
{
  using Base = Built_mesh<Surface_mesh>;

  explicit Built_mesh_with_garbage(const test_meshes::Mesh_data& d)
  {
    this->data = d;
    const test_meshes::Mesh_data extra = test_meshes::icosahedron();
    this->add(extra);
    const auto first_vertices = this->vertices;
    const auto first_faces = this->faces;
    this->vertices.clear();
    this->faces.clear();
    this->add(d);
    const auto kept_vertices = this->vertices;
    const auto kept_faces = this->faces;
    this->vertices.clear();
    this->faces.clear();
    this->add(extra);
    remove(first_vertices, first_faces);
    remove(this->vertices, this->faces);
    this->vertices = kept_vertices;
    this->faces = kept_faces;
    this->finish();
  }

private:
  void remove(const std::vector<typename Base::vertex_descriptor>& old_vertices,
              const std::vector<typename Base::face_descriptor>& old_faces)
  {
    for(const auto f : old_faces)
    {
      std::vector<typename Base::halfedge_descriptor> around;
      for(const auto h : CGAL::halfedges_around_face(this->mesh.halfedge(f), this->mesh))
        around.push_back(h);
      for(const auto h : around)
      {
        this->mesh.set_face(h, Base::Traits::null_face());
        if(this->mesh.is_border(this->mesh.opposite(h)))
          this->mesh.remove_edge(this->mesh.edge(h));
      }
      this->mesh.remove_face(f);
    }
    for(const auto v : old_vertices)
      this->mesh.remove_vertex(v);
  }
};

// What tests ask for.
inline const auto mesh_edges = CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::MESH_EDGES);
inline const auto through_faces = CGAL::parameters::cut_locus_curve(CGAL::Cut_loci::Curve::THROUGH_FACES);

// The cut edges of a result of the library, by the positions of the vertices in the arrays. Throws if it has others.
template <typename Built, typename Result>
topology_checker::Cut cut_of(const Built& built, const Result& result)
{
  topology_checker::Cut cut;
  const auto& graph = result.graph();
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(graph[v].mesh_vertex == Built::Traits::null_vertex())
      throw std::logic_error("the curve runs through faces, and the test is one of edges of the mesh");
  cut.root = built.index(graph[result.root()].mesh_vertex);
  for(const auto e : CGAL::make_range(edges(graph)))
    cut.edges.insert(topology_checker::make_edge(built.index(graph[source(e, graph)].mesh_vertex),
                                                 built.index(graph[target(e, graph)].mesh_vertex)));
  return cut;
}

// All that must hold for a result, whatever the thresholds; `corners` of `face` are those around the source. Returns
// what does not, or an empty string.
template <typename Built, typename Result>
std::string fault_of(const Built& built, const Result& result, std::size_t face,
                     const std::vector<std::size_t>& corners,
                     CGAL::Cut_loci::Method method = CGAL::Cut_loci::Laplacian_method())
{
  const topology_checker::Surface surface(built.data.triangles, face);
  const topology_checker::Cut cut = cut_of(built, result);
  const auto& graph = result.graph();
  if(cut.edges.size() != num_edges(graph))
    return "an edge of the mesh is in the graph twice";
  std::set<std::size_t> on_it;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(!on_it.insert(built.index(graph[v].mesh_vertex)).second)
      return "a vertex of the mesh is in the graph twice";
  const std::string fault = topology_checker::fault(surface, cut);
  if(!fault.empty())
    return fault;
  const std::string at_source = topology_checker::fault_at_source(surface, cut, corners);
  if(!at_source.empty())
    return at_source;
  if(long(result.genus()) != surface.genus() || result.number_of_border_loops() != surface.number_of_loops)
    return "the genus or the number of border loops is wrong";
  if(surface.number_of_loops == 0 && std::holds_alternative<CGAL::Cut_loci::Laplacian_method>(method))
    for(std::size_t v : surface.vertices)
      if(result.distance(built.vertices[v]) > graph[result.root()].distance &&
         !(corners.size() == 1 && corners[0] == v)) // a distance map may be wrong there
        return "the root is not the farthest vertex";
  return std::string();
}

#endif // CGAL_CUT_LOCI_BUILT_MESH_H
