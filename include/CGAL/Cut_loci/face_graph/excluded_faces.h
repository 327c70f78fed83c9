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
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The named parameter `face_is_excluded_map`, or a map that excludes none.
template <typename TriangleMesh, typename NamedParameters>
auto excluded_faces(const NamedParameters& np)
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::face_is_excluded_map),
                                      Static_boolean_property_map<face_descriptor, false>());
}

// Where the faces at a vertex form several fans, as where excluded regions touch, no path leads from one to the other. Each but
// the first fan gets a vertex of its own, behind all others. Returns pairs of a vertex and one of its copies, sorted.
template <typename TriangleMesh>
std::vector<std::pair<Index, Index>> give_fans_vertices(Read_triangle_mesh<TriangleMesh>& read)
{
  std::vector<std::pair<Index, Index>> copies;
  Cut_mesh fans = cut_open(read.mesh);
  for(Index copy = static_cast<Index>(read.vertices.size()); copy < fans.vertices.size(); ++copy)
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

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_EXCLUDED_FACES_H
