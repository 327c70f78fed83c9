// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_WAYS_SOURCE_ROOTS_H
#define CGAL_CUT_LOCI_WAYS_SOURCE_ROOTS_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Cut_loci {

namespace internal {

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
      find_touched(mesh, connectivity, points[i], i);
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
    touched_.resize(number_of_points_ + parts.size());
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
  std::vector<std::vector<Index>> touched_; // the faces at each source
  std::vector<Index> edges_;                // with a source on them
  std::vector<Index> face_;
  std::vector<Index> source_of_face_, tried_; // by face
};

} // namespace internal

/*
 * is the vertex or the inner edge that the source is on, or neither if it is inside a face. It is never on the cut
 * locus: a vertex becomes a leaf of the tree, or a part of a border loop that nothing joins there, and an edge is
 * left out.
 */
struct Source_element
{
  Index vertex = null_index;
  Index edge = null_index;

  Source_element() = default;
  Source_element(const Mesh_connectivity& connectivity, const Indexed_source& source) : vertex(source.vertex)
  {
    for(Index i = 0; i < 3; ++i)
      if(vertex == null_index && source.location.coordinates[(i + 2) % 3] == 0.)
        edge = connectivity.edge_of_halfedge[3 * source.location.face + i];
  }
};

/*
 * holds the faces at each of several sources, which are the roots of the disks that the cut locus leaves: those around a
 * vertex, the two of an edge, the one that a source is inside of, or those along a part of the border. What several
 * sources touch is divided between them, see `internal::Source_faces`.
 *
 * Points are numbered first, then the parts of the border.
 */
class Source_roots
{
public:
  Source_roots() = default;
  /// @param names the numbers under which the points are known, if there are other sources elsewhere
  Source_roots(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
               const std::vector<Indexed_source>& points, const Source_parts& parts = {},
               const std::vector<Index>& names = {})
    : points_(points), parts_(parts), names_(names)
  {
    for(Index i = static_cast<Index>(names.size()); i < points.size(); ++i)
      names_.push_back(i);
    for(Index part = 0; part < parts.size(); ++part)
      names_.push_back(parts.source(part));
    const internal::Source_faces faces(mesh, connectivity, points, parts);
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
      owner_.push_back(faces.owner(f));
    for(Index i = 0; i < number_of_sources(); ++i)
      face_.push_back(number_of_sources() > 1 ? faces.face(i) : any_face(i));
    for(Index i = 0; i < points.size(); ++i)
      if(points[i].vertex != null_index)
        join_around_vertex(mesh, connectivity, i);
      else
        join_across_edge(mesh, connectivity, i);
    // The faces around a loop form a ring, and a forest that takes these edges leaves one of them.
    for(Index h = 0; h < mesh.number_of_halfedges() && !parts.empty(); ++h)
      if(!mesh.is_border_edge(h) && h < mesh.opposite[h] && owner_[h / 3] != null_index &&
         faces.is_part(owner_[h / 3]) && faces.is_inside(mesh, h))
        crossings_.push_back(h);
  }

  std::size_t number_of_sources() const { return points_.size() + parts_.size(); }
  const std::vector<Indexed_source>& points() const { return points_; }
  const Source_parts& parts() const { return parts_; }
  /// the number under which source `i` is known: several parts may be those of one curve
  Index name(Index i) const { return names_[i]; }
  /// the source to which a face belongs, or `null_index`
  Index owner(Index f) const { return owner_[f]; }
  const std::vector<Index>& owners() const { return owner_; }
  /// a face that source `i` has to itself
  Index face(Index i) const { return face_[i]; }
  /// throws if a source has none
  void check_faces(const std::string& remedy) const
  {
    const auto i = std::find(face_.begin(), face_.end(), null_index);
    if(i != face_.end())
      throw Invalid_input(Cause::NO_FACE_AT_SOURCE,
                          "source " + std::to_string(name(static_cast<Index>(i - face_.begin()))) +
                            " has no face to itself, as other sources lie on the same ones: no curve of mesh edges "
                            "separates them; " +
                            remedy);
  }
  /// across these halfedges, the faces of each source hang together: as a tree, so that around a vertex one is left
  const std::vector<Index>& crossings() const { return crossings_; }
  /// for each point, what of it is never on the cut locus, as it has all faces there
  const std::vector<Source_element>& elements() const { return elements_; }

private:
  Index any_face(Index i) const
  {
    return i < points_.size() ? points_[i].location.face : parts_.halfedge(i - static_cast<Index>(points_.size())) / 3;
  }

  void join_around_vertex(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index i)
  {
    const Index v = points_[i].vertex, begin = connectivity.ring_begin[v], end = connectivity.ring_begin[v + 1];
    bool has_all = true;
    const auto is_own = [&](Index h) { return owner_[h / 3] == i; };
    for(Index k = begin; k < end; ++k)
      if(const Index h = connectivity.ring_halfedge[k]; mesh.source(h) == v) // not the last edge at a border
        has_all = has_all && is_own(h);
    // The tree takes a source by the first edge in its ring, if all faces are its own: no path crosses that one.
    for(Index k = begin + (has_all ? 1 : 0); k < end; ++k)
      if(const Index h = connectivity.ring_halfedge[k];
         mesh.source(h) == v && !mesh.is_border_edge(h) && is_own(h) && is_own(mesh.opposite[h]))
        crossings_.push_back(h);
    elements_.emplace_back();
    if(has_all)
      elements_.back().vertex = v;
  }

  void join_across_edge(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, Index i)
  {
    elements_.push_back(Source_element(connectivity, points_[i]));
    Index& edge = elements_.back().edge;
    if(edge == null_index)
      return;
    const Index h = connectivity.halfedge_of_edge[edge];
    if(mesh.is_border_edge(h))
      return;
    const Index inside = h / 3 == points_[i].location.face ? h : mesh.opposite[h], o = mesh.opposite[inside];
    if(owner_[inside / 3] == i && owner_[o / 3] == i)
      crossings_.push_back(o);
    else
      edge = null_index;
  }

  std::vector<Indexed_source> points_;
  Source_parts parts_;
  std::vector<Index> names_; // of all sources
  std::vector<Index> owner_; // of each face
  std::vector<Index> face_, crossings_;
  std::vector<Source_element> elements_;
};

namespace internal {

// The edges that are not on the cut locus, but along the border: those that are crossed, and those at the sources.
inline std::vector<unsigned char> closed_edges(const Mesh_connectivity& connectivity,
                                               const std::vector<unsigned char>& crossed,
                                               const std::vector<Source_element>& sources)
{
  std::vector<unsigned char> result = crossed;
  result.resize(connectivity.number_of_edges(), 0);
  for(const Source_element& source : sources)
  {
    if(source.edge != null_index)
      result[source.edge] = 1;
    if(source.vertex != null_index)
      for(Index entry = connectivity.ring_begin[source.vertex]; entry < connectivity.ring_begin[source.vertex + 1];
          ++entry)
        result[connectivity.ring_edge(entry)] = 1;
  }
  return result;
}

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_WAYS_SOURCE_ROOTS_H
