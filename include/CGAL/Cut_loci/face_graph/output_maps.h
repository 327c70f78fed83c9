// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_OUTPUT_MAPS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_OUTPUT_MAPS_H

#include <CGAL/Cut_loci/face_graph/build_face_graph.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/graph/curve_refinement.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// of curves along which faces are split
template <typename NamedParameters>
Index read_resolution(const NamedParameters& np)
{
  return resolution_of(parameters::choose_parameter(parameters::get_parameter(np, internal_np::snapping_tolerance),
                                                    default_snapping_of_curves));
}

// What tells the elements of the input for those of the output: an output iterator of pairs, a property map of the
// output's elements, or, if neither is given, nothing.
template <typename Map>
auto output_pairs(internal_np::Param_not_found, Map map)
{
  return [map](const auto& input, const auto& output)
  {
    if constexpr(!std::is_same<Map, internal_np::Param_not_found>::value)
      put(map, output, input);
    else
      CGAL_USE(map), CGAL_USE(input), CGAL_USE(output);
    };
}

template <typename OutputIterator, typename Map>
auto output_pairs(OutputIterator out, Map)
{
  return [out](const auto& input, const auto& output) mutable { *out++ = std::make_pair(input, output); };
}

template <typename PointMap, typename Vertex, typename Point>
void put_point(PointMap& map, const Vertex& v, const Point& p)
{
  using Target = typename boost::property_traits<PointMap>::value_type;
  if constexpr(std::is_convertible<Point, Target>::value)
    put(map, v, p);
  else
    put(map, v, Target(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
}

// Adds `mesh` to `output`, with points and maps. `vertices` and `faces` tell the dense indices of the input that its
// elements come from; a vertex that is new has `null_index`.
template <typename TriangleMesh, typename OutputMesh, typename NamedParametersIn, typename NamedParametersOut>
Built_face_graph<OutputMesh> output_mesh(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read,
                                         const Indexed_triangle_mesh& mesh, const std::vector<Index>& vertices,
                                         const std::vector<Index>& faces, OutputMesh& output,
                                         const NamedParametersIn& np_in, const NamedParametersOut& np_out)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto input_vpm = point_map(tm, np_in);
  auto output_vpm =
    choose_parameter(get_parameter(np_out, internal_np::vertex_point), get_property_map(vertex_point, output));
  using Output_point = typename boost::property_traits<decltype(output_vpm)>::value_type;

  Built_face_graph<OutputMesh> built = build_face_graph(mesh, output);
  auto vertex_pairs = output_pairs(get_parameter(np_in, internal_np::vertex_to_vertex_output_iterator),
                                   get_parameter(np_in, internal_np::vertex_to_vertex_map));
  auto face_pairs = output_pairs(get_parameter(np_in, internal_np::face_to_face_output_iterator),
                                 get_parameter(np_in, internal_np::face_to_face_map));
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
  {
    auto origin = boost::graph_traits<TriangleMesh>::null_vertex();
    if(vertices[v] == null_index)
      put(output_vpm, built.vertices[v], Output_point(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]));
    else
    {
      origin = read.vertices[vertices[v]];
      put_point(output_vpm, built.vertices[v], get(input_vpm, origin));
    }
    vertex_pairs(origin, built.vertices[v]);
  }
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
    face_pairs(face(read.halfedges[3 * std::size_t(faces[f])], tm), face(built.halfedges[3 * std::size_t(f)], output));
  return built;
}

template <typename OutputMesh>
void output_seams(const Indexed_triangle_mesh&, const Seams&, const Built_face_graph<OutputMesh>&, const OutputMesh&,
                  internal_np::Param_not_found)
{
}

template <typename OutputMesh, typename EdgeMap>
void output_seams(const Indexed_triangle_mesh& mesh, const Seams& seams, const Built_face_graph<OutputMesh>& built,
                  const OutputMesh& output, EdgeMap map)
{
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    put(map, edge(built.halfedges[h], output), bool(seams[h]));
}

template <typename Cells, typename OutputMesh>
void output_cells(const Cells&, const Built_face_graph<OutputMesh>&, const OutputMesh&, internal_np::Param_not_found)
{
}

// `cells` finds them, for each face
template <typename Cells, typename OutputMesh, typename FaceMap>
void output_cells(const Cells& cells, const Built_face_graph<OutputMesh>& built, const OutputMesh& output, FaceMap map)
{
  const std::vector<std::size_t> cell = cells();
  for(std::size_t f = 0; f < cell.size(); ++f)
    put(map, face(built.halfedges[3 * f], output), cell[f]);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_OUTPUT_MAPS_H
