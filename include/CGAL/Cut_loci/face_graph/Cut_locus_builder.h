// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_CUT_LOCUS_BUILDER_H
#define CGAL_CUT_LOCI_FACE_GRAPH_CUT_LOCUS_BUILDER_H

#include <CGAL/Cut_loci/face_graph/Surface_component.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>
#include <CGAL/Cut_locus.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Makes the result, in descriptors of the user's mesh, from that of a component.
template <typename TriangleMesh, typename VertexPointMap>
class Cut_locus_builder
{
public:
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  using Result = Cut_locus<TriangleMesh, Point_3>;
  using Read = Read_triangle_mesh<TriangleMesh>;

  Cut_locus_builder(const TriangleMesh& tm, const VertexPointMap& vpm, const std::shared_ptr<const Read>& read,
                    const Surface_component& component)
    : tm_(tm), vpm_(vpm), read_(read), component_(component)
  {
  }

  Result operator()(const Indexed_cut_locus& cut_locus, const std::vector<Indexed_source>& sources,
                    const std::shared_ptr<const Source_result>& shared) const
  {
    typename Result::Graph graph(cut_locus.nodes.size());
    for(std::size_t i = 0; i < cut_locus.nodes.size(); ++i)
      graph[i] = make_vertex(cut_locus.nodes[i].location, cut_locus.nodes[i].vertex, cut_locus.nodes[i].distance);
    for(const Indexed_cut_locus::Edge& e : cut_locus.edges)
    {
      typename Result::Edge edge;
      edge.strength = e.strength;
      edge.width = read_->unit * e.width;
      edge.curvature = e.curvature;
      edge.sources = {{e.sources[0], e.sources[1]}};
      if(e.halfedge != null_index)
      {
        edge.mesh_halfedge = read_->halfedges[component_.halfedge(e.halfedge)];
        edge.is_on_border = component_.mesh->is_border_edge(e.halfedge);
      }
      add_edge(e.source, e.target, edge, graph);
    }

    const auto read = read_;
    const auto distance = [shared, read](typename Result::mesh_vertex_descriptor v)
    {
      const Index i = get(read->index_of_vertex, v);
      return i == null_index ? (std::numeric_limits<double>::infinity)() : read->unit * shared->distance[i];
    };
    typename Result::Nearest_source_function nearest_source;
    if(!shared->nearest_source.empty())
      nearest_source = [shared, read](typename Result::mesh_vertex_descriptor v) -> std::optional<std::size_t>
      {
        const Index i = get(read->index_of_vertex, v);
        if(i == null_index || shared->nearest_source[i] == null_index)
          return std::nullopt;
        return shared->nearest_source[i];
      };
    std::vector<typename Result::Vertex> source_points;
    source_points.reserve(sources.size());
    for(const Indexed_source& source : sources)
      source_points.push_back(make_vertex(source.location, source.vertex, 0.));
    return Result(std::move(graph), std::move(source_points), read_->vertices[shared->farthest], shared, distance,
                  nearest_source, cut_locus.number_of_narrow_corridors, cut_locus.is_one_of_several);
  }

private:
  typename Result::Vertex make_vertex(const Indexed_location& location, Index vertex, double distance) const
  {
    typename Result::Vertex result;
    result.location.first = face(read_->halfedges[3 * std::size_t(component_.face(location.face))], tm_);
    for(int i = 0; i < 3; ++i)
      result.location.second[i] = FT(location.coordinates[i]);
    result.distance = read_->unit * distance;
    if(vertex != null_index)
    {
      result.mesh_vertex = read_->vertices[component_.vertex(vertex)];
      result.point = get(vpm_, result.mesh_vertex);
      return result;
    }
    result.mesh_vertex = boost::graph_traits<TriangleMesh>::null_vertex();
    const auto& triangle = component_.mesh->triangles[location.face];
    std::array<double, 3> p = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      p = p + location.coordinates[i] * component_.mesh->points[triangle[i]];
    p = read_->unit_of_points * p;
    result.point = Point_3(p[0], p[1], p[2]);
    return result;
  }

  const TriangleMesh& tm_;
  const VertexPointMap& vpm_;
  const std::shared_ptr<const Read>& read_;
  const Surface_component& component_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_CUT_LOCUS_BUILDER_H
