// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_SPLIT_FANS_H
#define CGAL_CUT_LOCI_SURFACE_SPLIT_FANS_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A mesh in which each vertex has one fan of faces: those that had several are there several times.
struct Mesh_of_fans
{
  Indexed_triangle_mesh mesh;
  std::vector<Index> vertices; // for each vertex the one that it was; the first ones are as they were
};

inline Mesh_of_fans split_fans(Indexed_triangle_mesh whole)
{
  Mesh_of_fans result{std::move(whole), {}};
  Indexed_triangle_mesh& mesh = result.mesh;
  result.vertices.resize(mesh.number_of_vertices());
  std::iota(result.vertices.begin(), result.vertices.end(), Index(0));
  std::vector<unsigned char> has_fan(mesh.number_of_vertices(), 0), is_done(mesh.number_of_halfedges(), 0);
  for(Index start = 0; start < mesh.number_of_halfedges(); ++start)
  {
    if(is_done[start])
      continue;
    const Index v = mesh.source(start);
    Index copy = v;
    if(has_fan[v])
    {
      copy = mesh.number_of_vertices();
      mesh.points.push_back(Indexed_triangle_mesh::Point(mesh.points[v]));
      result.vertices.push_back(v);
    }
    has_fan[v] = 1;
    const auto take = [&](Index h)
    {
      is_done[h] = 1;
      mesh.triangles[h / 3][h % 3] = copy;
    };
    Index h = start;
    for(; h != null_index && !is_done[h]; h = mesh.opposite[mesh.previous(h)])
      take(h);
    if(h != null_index)
      continue;
    // and clockwise, to the other border
    for(h = mesh.opposite[start]; h != null_index && !is_done[mesh.next(h)]; h = mesh.opposite[mesh.next(h)])
      take(mesh.next(h));
  }
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_SPLIT_FANS_H
