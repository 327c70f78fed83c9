// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_EDGE_LENGTHS_H
#define CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_EDGE_LENGTHS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/face_graph/reading/method_parameters.h>
#include <CGAL/Cut_loci/face_graph/reading/read_triangle_mesh.h>
#include <CGAL/Cut_loci/named_parameters.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL::Cut_loci::internal {

// The metric of a mesh from the named parameter `edge_length_map`.

template <typename NamedParameters>
constexpr bool has_edge_lengths()
{
  return is_given<NamedParameters, internal_np::edge_length_map_t>();
}

template <typename TriangleMesh>
void check_triangle_inequality(const TriangleMesh& tm, const Read_triangle_mesh<TriangleMesh>& read, Index f)
{
  const Indexed_triangle_mesh& mesh = read.mesh;
  const std::array<double, 3> length = edge_lengths(mesh, f);
  // a sum of lengths, each of them rounded some times
  constexpr double rounding = 1e-14;
  if(Triangle_shape::slack(length) >= -rounding * *std::max_element(length.begin(), length.end()))
    return;
  std::ostringstream text;
  text.precision(17);
  text << face_name(position_of_face(tm, read, f)) << " (vertices";
  for(Index v : mesh.triangles[f])
    text << ' ' << read.positions[v];
  text << ") has edges of the lengths " << length[0] << ", " << length[1] << " and " << length[2]
       << ": one is longer than both others together, so that there is no such triangle; the edge_length_map must give "
          "each face lengths that satisfy the triangle inequality";
  throw Invalid_input(Cause::INVALID_PARAMETER, text.str());
}

template <typename TriangleMesh>
void read_edge_lengths(const TriangleMesh&, Read_triangle_mesh<TriangleMesh>&, internal_np::Param_not_found)
{
}

template <typename TriangleMesh, typename EdgeLengthMap>
void read_edge_lengths(const TriangleMesh& tm, Read_triangle_mesh<TriangleMesh>& read, const EdgeLengthMap& map)
{
  Indexed_triangle_mesh& mesh = read.mesh;
  mesh.is_intrinsic = true;
  for(std::size_t h = 0; h < read.halfedges.size(); ++h)
  {
    const double length = CGAL::to_double(get(map, edge(read.halfedges[h], tm)));
    if(!std::isfinite(length) || length < 0.)
    {
      const Index i = static_cast<Index>(h);
      throw Invalid_input(Cause::INVALID_PARAMETER, "the edge_length_map holds a length that is " +
                                                      std::string(length < 0. ? "negative" : "not a finite number") +
                                                      " for the edge between " +
                                                      vertex_name(read.positions[mesh.source(i)]) + " and " +
                                                      vertex_name(read.positions[mesh.target(i)]));
    }
    mesh.lengths.push_back(length);
  }
  for(Index f = 0; f < mesh.number_of_faces(); ++f)
    check_triangle_inequality(tm, read, f);
}

inline void refuse_lengths(const std::string& who)
{
  throw Invalid_input(Cause::PARAMETER_OF_OTHER_METHOD,
                      who +
                        " needs the points of the mesh: edge_length_map is for the package's own exact solver and the "
                        "methods Cut_loci::Default_method and Cut_loci::Polyhedral_method; leave it away, or "
                        "geodesic_solver, vertex_distance_map and cut_locus_method");
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FACE_GRAPH_READING_READ_EDGE_LENGTHS_H
