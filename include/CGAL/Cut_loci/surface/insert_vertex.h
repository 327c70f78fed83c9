// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
#define CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// A face at a vertex that has been inserted: the vertex and, as its halfedge 1, a halfedge of the mesh as it was.
struct Face_at_inserted_vertex
{
  Index face, base;
};

// Inserts a vertex, the last one, at `location`, which is inside a face or on an edge. The faces around it take the
// place of those that it lies on, and further ones come last.
inline std::vector<Face_at_inserted_vertex> insert_vertex_into(Indexed_triangle_mesh& mesh,
                                                               const Indexed_location& location)
{
  const Index v = mesh.number_of_vertices();
  const Index first = 3 * location.face;
  const Indexed_triangle_mesh::Triangle& t = mesh.triangles[location.face];
  const std::array<double, 3>& c = location.coordinates;
  mesh.points.push_back(c[0] * mesh.points[t[0]] + (c[1] * mesh.points[t[1]] + c[2] * mesh.points[t[2]]));

  // Around the new vertex, faces over the edges of the face, or of the two faces at the edge that it lies on.
  struct Base
  {
    Index halfedge, source, target, opposite;
    std::array<double, 3> length; // of the edges of the face, if the mesh has lengths
  };
  std::vector<Base> base;
  const auto add_base = [&](Index h, const std::array<double, 3>& coordinates)
  {
    base.push_back({h, mesh.source(h), mesh.target(h), mesh.opposite[h], {{0., 0., 0.}}});
    if(mesh.lengths.empty())
      return;
    const double length = mesh.lengths[h];
    const Planar_vector p = flat_position(mesh, h, coordinates), to_target = p - Planar_vector{{length, 0.}};
    base.back().length = {{norm(p), length, norm(to_target)}};
  };
  std::vector<Index> replaced(1, location.face);
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = first + i;
    if(c[(i + 2) % 3] > 0.)
    {
      add_base(h, c);
      continue;
    }
    const Index o = mesh.opposite[h];
    if(o == null_index)
      continue;
    replaced.push_back(o / 3);
    std::array<double, 3> across = {{0., 0., 0.}};
    across[o % 3] = c[(i + 1) % 3];
    across[(o % 3 + 1) % 3] = c[i];
    add_base(mesh.next(o), across);
    add_base(mesh.previous(o), across);
  }

  std::vector<Face_at_inserted_vertex> result;
  Index number_of_faces = mesh.number_of_faces();
  for(std::size_t k = 0; k < base.size(); ++k)
    result.push_back({k < replaced.size() ? replaced[k] : number_of_faces++, base[k].halfedge});
  mesh.triangles.resize(number_of_faces);
  mesh.opposite.resize(3 * mesh.triangles.size());
  if(!mesh.lengths.empty())
    mesh.lengths.resize(mesh.opposite.size());
  for(std::size_t k = 0; k < base.size(); ++k)
  {
    mesh.triangles[result[k].face] = {{v, base[k].source, base[k].target}};
    for(Index i = 0; i < 3; ++i)
    {
      mesh.opposite[3 * result[k].face + i] = null_index;
      if(!mesh.lengths.empty())
        mesh.lengths[3 * std::size_t(result[k].face) + i] = base[k].length[i];
    }
  }
  for(std::size_t k = 0; k < base.size(); ++k)
  {
    const Index h = 3 * result[k].face;
    for(std::size_t l = 0; l < base.size(); ++l)
      if(l != k && base[l].source == base[k].target)
      {
        mesh.opposite[h + 2] = 3 * result[l].face;
        mesh.opposite[3 * result[l].face] = h + 2;
      }
    Index outside = base[k].opposite;
    if(outside == null_index)
      continue;
    const auto glued = std::find_if(base.begin(), base.end(), [&](const Base& b) { return b.halfedge == outside; });
    if(glued != base.end()) // a face may be its own neighbor
      outside = 3 * result[static_cast<std::size_t>(glued - base.begin())].face + 1;
    mesh.opposite[h + 1] = outside;
    mesh.opposite[outside] = h + 1;
  }
  return result;
}

// A copy of `mesh` with one more vertex, the last one, at `location`, which is inside a face or on an edge.
inline Indexed_triangle_mesh insert_vertex(const Indexed_triangle_mesh& mesh, const Indexed_location& location)
{
  Indexed_triangle_mesh result = mesh;
  insert_vertex_into(result, location);
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
