// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
#define CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/flat_triangles.h>
#include <CGAL/Cut_loci/surface/surface_location.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A face at a vertex that has been inserted: the vertex and, as its halfedge 1, a halfedge of the mesh as it was.
struct Face_at_inserted_vertex
{
  Index face, base;
};

// An edge that becomes the base of a face at an inserted vertex.
struct Base_of_inserted_vertex
{
  Index halfedge, source, target, opposite;
  std::array<double, 3> length; // of the edges of the face, if the mesh has lengths
};

inline Base_of_inserted_vertex base_of_inserted_vertex(const Indexed_triangle_mesh& mesh, Index h,
                                                       const Indexed_location& location)
{
  Base_of_inserted_vertex result = {h, mesh.source(h), mesh.target(h), mesh.opposite[h], {{0., 0., 0.}}};
  if(mesh.lengths.empty())
    return result;
  const double length = mesh.lengths[h];
  const Planar_vector p = flat_position(mesh, h, location.coordinates), to_target = p - Planar_vector{{length, 0.}};
  result.length = {{norm(p), length, norm(to_target)}};
  return result;
}

// The edges of the face that a location is in, or of the two faces at the edge that it lies on, but for that edge;
// `replaced` becomes these faces.
inline std::vector<Base_of_inserted_vertex> bases_of_inserted_vertex(const Indexed_triangle_mesh& mesh,
                                                                     const Indexed_location& location,
                                                                     std::vector<Index>& replaced)
{
  std::vector<Base_of_inserted_vertex> result;
  replaced.assign(1, location.face);
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = 3 * location.face + i, o = mesh.opposite[h];
    if(location.coordinates[(i + 2) % 3] > 0.)
      result.push_back(base_of_inserted_vertex(mesh, h, location));
    else if(o != null_index)
    {
      replaced.push_back(o / 3);
      const Indexed_location same = across(h, o, location);
      result.push_back(base_of_inserted_vertex(mesh, mesh.next(o), same));
      result.push_back(base_of_inserted_vertex(mesh, mesh.previous(o), same));
    }
  }
  return result;
}

// Glues the faces at an inserted vertex to each other and to what is around them.
inline void glue_at_inserted_vertex(Indexed_triangle_mesh& mesh, const std::vector<Base_of_inserted_vertex>& base,
                                    const std::vector<Face_at_inserted_vertex>& faces)
{
  const auto glue = [&](Index g, Index h)
  {
    mesh.opposite[g] = h;
    mesh.opposite[h] = g;
  };
  for(std::size_t k = 0; k < base.size(); ++k)
  {
    const Index h = 3 * faces[k].face;
    for(std::size_t l = 0; l < base.size(); ++l)
      if(l != k && base[l].source == base[k].target)
        glue(h + 2, 3 * faces[l].face);
    Index outside = base[k].opposite;
    if(outside == null_index)
      continue;
    const auto glued =
      std::find_if(base.begin(), base.end(), [&](const auto& other) { return other.halfedge == outside; });
    if(glued != base.end()) // a face may be its own neighbor
      outside = 3 * faces[static_cast<std::size_t>(glued - base.begin())].face + 1;
    glue(h + 1, outside);
  }
}

// Inserts a vertex, the last one, at `location`, which is inside a face or on an edge. The faces around it take the
// place of those that it lies on, and further ones come last.
inline std::vector<Face_at_inserted_vertex> insert_vertex_into(Indexed_triangle_mesh& mesh,
                                                               const Indexed_location& location)
{
  const Index v = mesh.number_of_vertices();
  mesh.points.push_back(position(mesh, location));

  std::vector<Index> replaced;
  const std::vector<Base_of_inserted_vertex> base = bases_of_inserted_vertex(mesh, location, replaced);
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
  glue_at_inserted_vertex(mesh, base, result);
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_INSERT_VERTEX_H
