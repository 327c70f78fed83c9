// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_CURVE_ON_MESH_H
#define CGAL_CUT_LOCI_FACE_GRAPH_CURVE_ON_MESH_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A cut locus in the dense indices of a mesh.
struct Curve_on_mesh
{
  Indexed_cut_locus graph;
  std::vector<Indexed_source> sources; // a curve has its first vertex
  bool is_of_mesh_edges = true;        // or else through the faces
};

[[noreturn]] inline void throw_foreign_cut_locus(const std::string& what)
{
  throw Invalid_input(Cause::INVALID_CUT_LOCUS, "the cut locus does not belong to the mesh: " + what);
}

// The indices of what a cut locus refers to. Descriptors of another mesh must not be used for a look-up: those of this one
// are looked up among them.
template <typename TriangleMesh, typename Point_3>
class Indices_of_cut_locus
{
public:
  using Vertex = typename Cut_locus<TriangleMesh, Point_3>::Vertex;
  using Edge = typename Cut_locus<TriangleMesh, Point_3>::Edge;

  Indices_of_cut_locus(const Read_triangle_mesh<TriangleMesh>& read, const TriangleMesh& tm,
                       const Cut_locus<TriangleMesh, Point_3>& cut_locus)
  {
    const auto& graph = cut_locus.graph();
    for(std::size_t i = 0; i < cut_locus.number_of_sources(); ++i)
      add(cut_locus.source(i));
    for(auto v : CGAL::make_range(vertices(graph)))
      add(graph[v]);
    for(auto e : CGAL::make_range(edges(graph)))
      if(graph[e].mesh_halfedge != Traits::null_halfedge())
        halfedge_[graph[e].mesh_halfedge] = null_index;
    for(Index v = 0; v < read.mesh.number_of_vertices(); ++v)
      set(vertex_, read.vertices[v], v);
    for(Index h = 0; h < read.mesh.number_of_halfedges(); ++h)
      set(halfedge_, read.halfedges[h], h);
    for(Index f = 0; f < read.mesh.number_of_faces(); ++f)
      set(face_, face(read.halfedges[3 * std::size_t(f)], tm), f);
  }

  Indexed_location location(const Vertex& v) const
  {
    Indexed_location result;
    result.face = face_.at(v.location.first);
    if(result.face == null_index)
      throw_foreign_cut_locus("a face that it runs through is not there");
    double sum = 0.;
    for(int i = 0; i < 3; ++i)
      sum += result.coordinates[i] = CGAL::to_double(v.location.second[i]);
    if(!(std::abs(sum - 1.) < snapping_tolerance))
      throw_foreign_cut_locus("barycentric coordinates do not sum up to one");
    return result;
  }

  Index vertex(const Vertex& v) const
  {
    if(v.mesh_vertex == Traits::null_vertex())
      return null_index;
    const Index result = vertex_.at(v.mesh_vertex);
    if(result == null_index)
      throw_foreign_cut_locus("a vertex that it runs through is not there");
    return result;
  }

  Index halfedge(const Edge& e) const
  {
    if(e.mesh_halfedge == Traits::null_halfedge())
      return null_index;
    const Index result = halfedge_.at(e.mesh_halfedge);
    if(result == null_index)
      throw_foreign_cut_locus("an edge that it follows is not there");
    return result;
  }

private:
  using Traits = boost::graph_traits<TriangleMesh>;

  void add(const Vertex& v)
  {
    face_[v.location.first] = null_index;
    if(v.mesh_vertex != Traits::null_vertex())
      vertex_[v.mesh_vertex] = null_index;
  }

  template <typename Descriptor>
  static void set(std::map<Descriptor, Index>& indices, const Descriptor& descriptor, Index i)
  {
    const auto found = indices.find(descriptor);
    if(found != indices.end())
      found->second = i;
  }

  std::map<typename Traits::vertex_descriptor, Index> vertex_;
  std::map<typename Traits::halfedge_descriptor, Index> halfedge_;
  std::map<typename Traits::face_descriptor, Index> face_;
};

template <typename TriangleMesh, typename Point_3>
Curve_on_mesh curve_on_mesh(const Read_triangle_mesh<TriangleMesh>& read, const TriangleMesh& tm,
                            const Cut_locus<TriangleMesh, Point_3>& cut_locus)
{
  const auto& graph = cut_locus.graph();
  if(num_vertices(graph) == 0)
    throw Invalid_input(Cause::INVALID_CUT_LOCUS, "the cut locus is empty");

  const Indices_of_cut_locus<TriangleMesh, Point_3> indices(read, tm, cut_locus);
  Curve_on_mesh result;
  for(std::size_t i = 0; i < cut_locus.number_of_sources(); ++i)
    result.sources.push_back({indices.location(cut_locus.source(i)), indices.vertex(cut_locus.source(i))});
  for(auto v : CGAL::make_range(vertices(graph)))
  {
    result.graph.nodes.push_back({indices.location(graph[v]), indices.vertex(graph[v]), graph[v].distance});
    result.is_of_mesh_edges = result.is_of_mesh_edges && result.graph.nodes.back().vertex != null_index;
  }
  for(auto e : CGAL::make_range(edges(graph)))
  {
    Indexed_cut_locus::Edge edge;
    edge.source = static_cast<Index>(source(e, graph));
    edge.target = static_cast<Index>(target(e, graph));
    edge.strength = static_cast<float>(graph[e].strength);
    const Index h = edge.halfedge = indices.halfedge(graph[e]);
    if(h == null_index)
      result.is_of_mesh_edges = false;
    else
    {
      const Index a = result.graph.nodes[edge.source].vertex, b = result.graph.nodes[edge.target].vertex;
      const Index c = read.mesh.source(h), d = read.mesh.target(h);
      if(!((a == c && b == d) || (a == d && b == c)))
        throw_foreign_cut_locus("an edge that it follows has other ends");
    }
    result.graph.edges.push_back(edge);
  }
  return result;
}

// The component of a mesh that a curve is in, with the curve in its indices, and all that a cut needs.
struct Curve_on_component
{
  Mesh_component component;
  Curve_on_mesh curve;
};

inline Curve_on_component on_component(const Indexed_triangle_mesh& mesh, Curve_on_mesh curve)
{
  Index number_of_components = 0;
  const std::vector<Index> label = face_components(mesh, number_of_components);
  Curve_on_component result;
  result.component = extract_component(mesh, label, label[curve.sources.front().location.face]);
  const Mesh_component& component = result.component;
  const auto renumber = [](Index& i, Index local)
  {
    if(i != null_index && (i = local) == null_index)
      throw_foreign_cut_locus("it is not in the component of its source");
  };
  for(Indexed_source& source : curve.sources)
  {
    renumber(source.location.face, component.local_face(source.location.face));
    renumber(source.vertex, component.local_vertex(source.vertex));
  }
  for(Indexed_cut_locus::Node& node : curve.graph.nodes)
  {
    renumber(node.location.face, component.local_face(node.location.face));
    renumber(node.vertex, component.local_vertex(node.vertex));
  }
  for(Indexed_cut_locus::Edge& e : curve.graph.edges)
    renumber(e.halfedge, component.local_halfedge(e.halfedge));
  result.curve = std::move(curve);
  return result;
}

inline void throw_unless_of_one_source(const Curve_on_mesh& curve)
{
  if(curve.sources.size() > 1)
    throw Invalid_input(Cause::INVALID_CUT_LOCUS,
                        "the cut locus is that of several sources: its complement is as many disks, and not one");
}

inline void throw_unless_of_mesh_edges(const Curve_on_mesh& curve)
{
  if(!curve.is_of_mesh_edges)
    throw Invalid_input(Cause::INVALID_CUT_LOCUS,
                        "the cut locus runs through faces: pass cut_locus_curve(Cut_loci::Curve::MESH_EDGES) to "
                        "compute_cut_locus(), or cut by CGAL::cut_along_cut_locus(), which splits faces");
}

inline Mesh_connectivity manifold_connectivity(const Indexed_triangle_mesh& mesh)
{
  Mesh_connectivity result(mesh);
  if(!result.first_non_manifold.empty())
    throw Invalid_input(Cause::NON_MANIFOLD,
                        "the faces around a vertex form more than one fan: the mesh is not manifold");
  return result;
}

// The seams along a curve of edges of the mesh.
inline Seams seams_of_mesh_edges(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                 const Curve_on_mesh& curve)
{
  Seams seams(mesh.number_of_halfedges(), 0);
  for(const Indexed_cut_locus::Edge& e : curve.graph.edges)
    add_seam(mesh, e.halfedge, seams);
  complete_seams(mesh, connectivity, curve.graph.nodes.front().vertex, curve.sources.front().vertex, seams);
  return seams;
}

inline Cut_mesh cut_open_to_disk(const Indexed_triangle_mesh& mesh, const Seams& seams)
{
  Cut_mesh result = cut_open(mesh, seams);
  if(!is_disk(result.mesh))
    throw_foreign_cut_locus("its complement is no disk");
  return result;
}

// A surface cut open along a curve: faces that it runs through are split.
struct Disk_of_curve
{
  Curve_on_component on;
  Refined_mesh refined; // of the component
  Cut_mesh cut;         // with the faces of that
};

inline Disk_of_curve cut_along(const Indexed_triangle_mesh& mesh, Curve_on_mesh curve, Index resolution)
{
  Disk_of_curve result{on_component(mesh, std::move(curve)), {}, {}};
  const Curve_on_component& on = result.on;
  Refined_mesh& refined = result.refined;
  throw_unless_of_one_source(on.curve);
  refined = refine_along_curve(on.component.mesh, manifold_connectivity(on.component.mesh), on.curve.graph, resolution);
  if(!on.curve.is_of_mesh_edges) // which are not rounded
    repair_seams(refined.mesh, refined.nodes.front(), refined.seams);
  complete_seams(refined.mesh, Mesh_connectivity(refined.mesh), refined.nodes.front(), on.curve.sources.front().vertex,
                 refined.seams);
  result.cut = cut_open_to_disk(refined.mesh, refined.seams);
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_CURVE_ON_MESH_H
