// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_SOURCE_FACES_H
#define CGAL_CUT_LOCI_WAYS_SOURCE_FACES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells which faces of the mesh belong to the cell of a source because they are at it, wherever the cut locus runs: for a
 * curve made of edges of the mesh.
 *
 * Those that touch one source alone belong to that. Of several sources, each gets one of the faces that it touches to
 * itself, if there are enough of them: a matching, by augmenting paths.
 *
 * Parts of the border may be sources, too. They come after the points.
 */
class Source_faces
{
public:
  Source_faces(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
               const std::vector<Indexed_source>& points, const Source_parts& parts = {})
    : owner_(mesh.number_of_faces(), null_index), source_at_vertex_(mesh.number_of_vertices(), null_index),
      number_of_points_(static_cast<Index>(points.size())), touched_(points.size())
  {
    for(Index i = 0; i < points.size(); ++i)
    {
      names_.push_back(i);
      find_touched(mesh, connectivity, points[i], i);
    }
    find_touched_by_parts(mesh, parts);
    face_.assign(touched_.size(), null_index);
    if(touched_.size() == 1)
    {
      for(Index f : touched_.front())
        owner_[f] = 0;
      return;
    }
    std::vector<Index> number(owner_.size(), 0);
    for(Index i = 0; i < touched_.size(); ++i)
      for(Index f : touched_[i])
        owner_[f] = ++number[f] == 1 ? i : null_index;
    match();
  }

  /// the source to which a face belongs, or null
  Index owner(Index f) const { return owner_[f]; }
  bool is_part(Index i) const { return i >= number_of_points_; }
  /// the number under which a source is known: a curve may have several parts
  Index name(Index i) const { return names_[i]; }

  /// whether the source at one end of a halfedge, or on it, has the faces on both sides
  bool is_inside(const Indexed_triangle_mesh& mesh, Index h) const
  {
    const Index o = mesh.opposite[h], owner = owner_[h / 3];
    if(owner == null_index || o == null_index || owner_[o / 3] != owner)
      return false;
    return (source_at_vertex_[mesh.source(h)] == owner) != (source_at_vertex_[mesh.target(h)] == owner) ||
           std::find(edges_.begin(), edges_.end(), h) != edges_.end() ||
           std::find(edges_.begin(), edges_.end(), o) != edges_.end();
  }

  std::size_t number_of_sources() const { return face_.size(); }
  /// the face that a source has to itself, or null; of a single source always null
  Index face(Index i) const { return face_[i]; }

private:
  void find_touched(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                    const Indexed_source& source, Index i)
  {
    std::vector<Index>& faces = touched_[i];
    if(source.vertex != null_index)
    {
      const Index v = source.vertex;
      source_at_vertex_[v] = i;
      for(Index k = connectivity.ring_begin[v]; k < connectivity.ring_begin[v + 1]; ++k)
        if(mesh.source(connectivity.ring_halfedge[k]) == v) // not the last one of a border vertex
          faces.push_back(connectivity.ring_halfedge[k] / 3);
      return;
    }
    faces.push_back(source.location.face);
    for(Index k = 0; k < 3; ++k)
      if(const Index h = 3 * source.location.face + k;
         source.location.coordinates[(k + 2) % 3] == 0. && mesh.opposite[h] != null_index)
      {
        faces.push_back(mesh.opposite[h] / 3);
        edges_.push_back(h);
      }
  }

  void find_touched_by_parts(const Indexed_triangle_mesh& mesh, const Source_parts& parts)
  {
    for(Index part = 0; part < parts.size(); ++part)
      names_.push_back(parts.source(part));
    touched_.resize(names_.size());
    for(Index h = 0; h < mesh.number_of_halfedges() && !parts.empty(); ++h)
    {
      const Index v = mesh.source(h);
      if(!parts.is_at_source(v))
        continue;
      const Index i = number_of_points_ + parts.part(v);
      source_at_vertex_[v] = i;
      if(touched_[i].empty() || touched_[i].back() != h / 3)
        touched_[i].push_back(h / 3);
    }
  }

  /// those with the fewest choices first, which is most of the work
  void match()
  {
    std::vector<Index> order(touched_.size());
    for(Index i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return touched_[a].size() < touched_[b].size(); });
    source_of_face_.assign(owner_.size(), null_index);
    tried_.assign(owner_.size(), null_index);
    for(Index i : order)
      find_face(i, i);
    for(Index f = 0; f < owner_.size(); ++f)
      if(source_of_face_[f] != null_index)
      {
        owner_[f] = source_of_face_[f];
        face_[source_of_face_[f]] = f;
      }
  }

  bool find_face(Index i, Index round)
  {
    for(Index f : touched_[i]) // one that nobody else wants, if there is any
      if(source_of_face_[f] == null_index && owner_[f] == i)
      {
        source_of_face_[f] = i;
        return true;
      }
    for(Index f : touched_[i])
      if(tried_[f] != round)
      {
        tried_[f] = round;
        if(source_of_face_[f] == null_index || find_face(source_of_face_[f], round))
        {
          source_of_face_[f] = i;
          return true;
        }
      }
    return false;
  }

  std::vector<Index> owner_; // by face
  std::vector<Index> source_at_vertex_;
  Index number_of_points_;
  std::vector<Index> names_;
  std::vector<std::vector<Index>> touched_; // the faces at each source
  std::vector<Index> edges_;                // with a source on them
  std::vector<Index> face_;
  std::vector<Index> source_of_face_, tried_; // by face
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_WAYS_SOURCE_FACES_H
