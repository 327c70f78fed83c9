// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
#define CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A copy of `mesh` with one more vertex, the last one, at `location`, which is inside a face or on an edge.
inline Indexed_triangle_mesh insert_vertex(const Indexed_triangle_mesh& mesh, const Indexed_location& location)
{
  Indexed_triangle_mesh result = mesh;
  const Index v = mesh.number_of_vertices();
  const Index first = 3 * location.face;
  const Indexed_triangle_mesh::Triangle& t = mesh.triangles[location.face];
  const std::array<double, 3>& c = location.coordinates;
  result.points.push_back(c[0] * mesh.points[t[0]] + (c[1] * mesh.points[t[1]] + c[2] * mesh.points[t[2]]));

  // Around the new vertex, faces over the edges of the face, or of the two faces at the edge that it lies on.
  std::vector<Index> base;
  std::vector<Index> replaced(1, location.face);
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = first + i;
    if(c[(i + 2) % 3] > 0.)
    {
      base.push_back(h);
      continue;
    }
    const Index o = mesh.opposite[h];
    if(o == null_index)
      continue;
    replaced.push_back(o / 3);
    base.push_back(mesh.next(o));
    base.push_back(mesh.previous(o));
  }

  // Face k is (v, a, b) over the base edge a b: halfedge 1 is the base, 0 and 2 are spokes.
  std::vector<Index> faces = replaced;
  for(Index f = mesh.number_of_faces(); faces.size() < base.size(); ++f)
    faces.push_back(f);
  result.triangles.resize(mesh.number_of_faces() + base.size() - replaced.size());
  result.opposite.resize(3 * result.triangles.size());
  for(std::size_t k = 0; k < base.size(); ++k)
  {
    result.triangles[faces[k]] = {{v, mesh.source(base[k]), mesh.target(base[k])}};
    for(Index i = 0; i < 3; ++i)
      result.opposite[3 * faces[k] + i] = null_index;
  }
  for(std::size_t k = 0; k < base.size(); ++k)
  {
    const Index h = 3 * faces[k];
    for(std::size_t l = 0; l < base.size(); ++l)
      if(l != k && mesh.source(base[l]) == mesh.target(base[k]))
      {
        result.opposite[h + 2] = 3 * faces[l];
        result.opposite[3 * faces[l]] = h + 2;
      }
    Index outside = mesh.opposite[base[k]];
    if(outside == null_index)
      continue;
    const auto glued = std::find(base.begin(), base.end(), outside); // a face may be its own neighbor
    if(glued != base.end())
      outside = 3 * faces[glued - base.begin()] + 1;
    result.opposite[h + 1] = outside;
    result.opposite[outside] = h + 1;
  }
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
