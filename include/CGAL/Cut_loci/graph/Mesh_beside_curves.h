// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_GRAPH_MESH_BESIDE_CURVES_H
#define CGAL_CUT_LOCI_GRAPH_MESH_BESIDE_CURVES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_parts.h>
#include <CGAL/Cut_loci/surface/cut_open.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a mesh cut open along curves that are sources, without anything else, and the parts of its border that these become:
 * for a curve made of edges of the mesh, which stays off them.
 *
 * Faces and halfedges keep their numbers, and so does one copy of each vertex.
 */
class Mesh_beside_curves
{
public:
  /// @param first the number of the first curve among the sources
  Mesh_beside_curves(const Indexed_triangle_mesh& whole, Index first, const std::vector<Indexed_curve>& curves)
    : cut_(cut(whole, curves)), connectivity_(cut_.mesh)
  {
    std::vector<Index> source(whole.number_of_halfedges(), null_index);
    for(Index i = 0; i < curves.size(); ++i)
      for(Index h : curves[i].halfedges)
        for(Index side : {h, whole.opposite[h]})
          if(side != null_index)
            source[side] = first + i;
    parts_ = Source_parts(cut_.mesh, std::move(source));
  }

  const Indexed_triangle_mesh& mesh() const { return cut_.mesh; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  /// the sources
  const Source_parts& parts() const { return parts_; }
  /// the vertex that one of this mesh is a copy of
  Index vertex(Index v) const { return cut_.vertices[v]; }

  /// from the distances of the mesh that is not cut; those on sources are 0, whatever a solver says
  std::vector<double> distances(const std::vector<double>& of_whole) const
  {
    std::vector<double> result = of_whole;
    result.resize(cut_.mesh.number_of_vertices()); // copies of vertices are on sources
    for(Index v = 0; v < result.size(); ++v)
      if(parts_.is_at_source(v))
        result[v] = 0.;
    return result;
  }

  /// throws where the rest of the border has no vertex at which a curve could end that has to
  void check_gaps(const std::string& remedy) const
  {
    const Indexed_triangle_mesh& mesh = cut_.mesh;
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(mesh.is_border_edge(h) && !parts_.is_on_source(h) && parts_.is_at_source(mesh.source(h)) &&
         parts_.is_at_source(mesh.target(h)))
        throw_gap(std::minmax({source_at(mesh.source(h)), source_at(mesh.target(h))}), remedy);
  }

  /// a curve becomes one of the mesh that is not cut
  void close(Indexed_cut_locus& curve) const
  {
    for(Indexed_cut_locus::Node& node : curve.nodes)
      if(node.vertex != null_index)
        node.vertex = cut_.vertices[node.vertex];
  }

protected:
  Cut_mesh cut_;

private:
  Index source_at(Index v) const { return parts_.source(parts_.part(v)); }

  [[noreturn]] static void throw_gap(const std::pair<Index, Index>& sources, const std::string& remedy)
  {
    const std::string first = std::to_string(sources.first), second = std::to_string(sources.second);
    throw Invalid_input(
      Cause::NO_FACE_AT_SOURCE,
      "on the border, " + (first == second ? "two ends of source " + first : "sources " + first + " and " + second) +
        " are one edge apart, which no curve of mesh edges crosses: refine the mesh there; or " + remedy);
  }

  static Cut_mesh cut(const Indexed_triangle_mesh& whole, const std::vector<Indexed_curve>& curves)
  {
    Seams seams(whole.number_of_halfedges(), 0);
    for(const Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        add_seam(whole, h, seams);
    return cut_open(whole, seams);
  }

  Mesh_connectivity connectivity_;
  Source_parts parts_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_GRAPH_MESH_BESIDE_CURVES_H
