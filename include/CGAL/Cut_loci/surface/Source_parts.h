// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_SOURCE_PARTS_H
#define CGAL_CUT_LOCI_SURFACE_SOURCE_PARTS_H

#include <CGAL/Cut_loci/internal/Union_find.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <utility>
#include <vector>

namespace CGAL::Cut_loci {

// holds the parts of the border of a mesh that are sources: loops of edges, or arcs. Each is a source like a point, if it
// is shrunk to one. A curve may have several of them, as a mesh that is cut open along it has one on each side.
class Source_parts
{
public:
  Source_parts() = default;

  /// @param source_of_halfedge the number of the source that a halfedge on the border is on, or `null_index`
  Source_parts(const Indexed_triangle_mesh& mesh, std::vector<Index> source_of_halfedge)
    : source_of_halfedge_(std::move(source_of_halfedge)), part_(mesh.number_of_vertices(), null_index)
  {
    internal::Union_find joined(mesh.number_of_vertices());
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_on_source(h))
        joined.unite(mesh.source(h), mesh.target(h));
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_on_source(h) && part_[joined.find(mesh.source(h))] == null_index)
      {
        part_[joined.find(mesh.source(h))] = size();
        halfedge_.push_back(h);
      }
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_on_source(h))
        for(Index v : {mesh.source(h), mesh.target(h)})
          part_[v] = part_[joined.find(v)];
  }

  Index size() const { return static_cast<Index>(halfedge_.size()); }
  bool empty() const { return halfedge_.empty(); }
  /// the part that a vertex is on, or `null_index`
  Index part(Index v) const { return empty() ? null_index : part_[v]; }
  bool is_at_source(Index v) const { return part(v) != null_index; }
  /// the source that a halfedge on the border is on, or `null_index`
  Index source_of_halfedge(Index h) const { return source_of_halfedge_.empty() ? null_index : source_of_halfedge_[h]; }
  bool is_on_source(Index h) const { return source_of_halfedge(h) != null_index; }
  /// the number of the source that a part belongs to
  Index source(Index part) const { return source_of_halfedge_[halfedge_[part]]; }
  /// a halfedge of a part
  Index halfedge(Index part) const { return halfedge_[part]; }

  /// as one curve
  Indexed_curve all() const
  {
    Indexed_curve result;
    for(Index h = 0; h < source_of_halfedge_.size(); ++h)
      if(is_on_source(h))
        result.halfedges.push_back(h);
    return result;
  }

  /// which border loops have a vertex on no source
  std::vector<unsigned char> loops_with_rest(const Mesh_connectivity& connectivity) const
  {
    std::vector<unsigned char> result(connectivity.number_of_border_loops, 0);
    for(Index v = 0; v < connectivity.border_loop.size(); ++v)
      if(connectivity.is_border(v) && !is_at_source(v))
        result[connectivity.border_loop[v]] = 1;
    return result;
  }

private:
  std::vector<Index> source_of_halfedge_;
  std::vector<Index> part_;     // of each vertex
  std::vector<Index> halfedge_; // of each part
};

} // namespace CGAL::Cut_loci

#endif // CGAL_CUT_LOCI_SURFACE_SOURCE_PARTS_H
