// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_EXCLUDED_FACES_H
#define CGAL_CUT_LOCI_FACE_GRAPH_EXCLUDED_FACES_H

#include <CGAL/Cut_loci/face_graph/read_triangle_mesh.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/split_fans.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The named parameter `face_is_excluded_map`, or a map that excludes none.
template <typename TriangleMesh, typename NamedParameters>
auto excluded_faces(const NamedParameters& np)
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::face_is_excluded_map),
                                      Static_boolean_property_map<face_descriptor, false>());
}

// The vertices at which excluded regions touch: the faces left form several fans there, between which no path leads. Each but
// the first fan gets a vertex of its own, behind all others. Returns pairs of a vertex and one of its copies, sorted.
template <typename TriangleMesh, typename FaceIsExcludedMap>
std::vector<std::pair<Index, Index>> split_between_excluded(const TriangleMesh& tm, FaceIsExcludedMap is_excluded,
                                                            Read_triangle_mesh<TriangleMesh>& read)
{
  std::vector<std::pair<Index, Index>> copies;
  const auto range = CGAL::make_range(faces(tm));
  if(std::none_of(range.begin(), range.end(), [&](auto f) { return get(is_excluded, f); }))
    return copies; // what has several fans then is refused
  Mesh_of_fans fans = split_fans(read.mesh);
  for(Index copy = read.mesh.number_of_vertices(); copy < fans.vertices.size(); ++copy)
  {
    const Index v = fans.vertices[copy];
    copies.push_back({v, copy});
    read.vertices.push_back(read.vertices[v]);
    read.positions.push_back(read.positions[v]);
  }
  read.mesh = std::move(fans.mesh);
  std::sort(copies.begin(), copies.end());
  return copies;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_FACE_GRAPH_EXCLUDED_FACES_H
