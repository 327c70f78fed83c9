// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_MESH_BESIDE_CURVES_H
#define CGAL_CUT_LOCI_EXACT_TREE_MESH_BESIDE_CURVES_H

#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/curve/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_faces.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/surface/surface_location.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * is a mesh cut open along curves that are sources, without anything else, and the border loops that these become: for a
 * curve made of edges of the mesh, which stays off them. Each loop is a source like a point, if it is shrunk to one, and
 * the faces around it are those of the fan of a point.
 *
 * Faces and halfedges keep their numbers, and so does one copy of each vertex.
 */
class Mesh_beside_curves
{
public:
  Mesh_beside_curves(const Indexed_triangle_mesh& whole, const std::vector<Indexed_source>& points,
                     const std::vector<Indexed_curve>& curves)
    : cut_(cut(whole, curves)), connectivity_(cut_.mesh), number_of_vertices_(whole.number_of_vertices()),
      source_of_loop_(connectivity_.number_of_border_loops, null_index)
  {
    std::vector<unsigned char> is_line(whole.number_of_halfedges(), 0);
    for(Index i = 0; i < curves.size(); ++i)
      for(Index h : curves[i].halfedges)
        for(Index side : {h, whole.opposite[h]})
          if(side != null_index)
          {
            is_line[side] = 1;
            source_of_loop_[connectivity_.border_loop[cut_.mesh.source(side)]] = static_cast<Index>(points.size()) + i;
          }
    for(Index h = 0; h < is_line.size(); ++h)
      if(cut_.mesh.is_border_edge(h) && !is_line[h] && is_source_loop(connectivity_.border_loop[cut_.mesh.source(h)]))
        throw Invalid_input(
          Cause::NO_FACE_AT_SOURCE,
          "source " + std::to_string(source_of_loop_[connectivity_.border_loop[cut_.mesh.source(h)]]) +
            " has a vertex on the border, of which it is no part: a curve of mesh edges, which would end "
            "beside it, is for curves that are off the border; " +
            remedy());
  }

  const Indexed_triangle_mesh& mesh() const { return cut_.mesh; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  /// of each border loop, or null
  const std::vector<Index>& source_of_loop() const { return source_of_loop_; }
  bool is_source_loop(Index loop) const { return source_of_loop_[loop] != null_index; }

  /// from the distances of the mesh that is not cut: further copies are on sources
  std::vector<double> distances(const std::vector<double>& of_whole) const
  {
    std::vector<double> result(of_whole.begin(), of_whole.begin() + number_of_vertices_);
    result.resize(cut_.mesh.number_of_vertices(), 0.);
    return result;
  }

  /// a curve becomes one of the mesh that is not cut
  void close(Indexed_cut_locus& curve) const
  {
    for(Indexed_cut_locus::Node& node : curve.nodes)
      if(node.vertex != null_index)
        node.vertex = cut_.vertices[node.vertex];
  }

  /// where a curve of mesh edges is not possible
  static const char* remedy() { return "ask for cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)"; }

private:
  static Cut_mesh cut(const Indexed_triangle_mesh& whole, const std::vector<Indexed_curve>& curves)
  {
    Seams seams(whole.number_of_halfedges(), 0);
    for(const Indexed_curve& curve : curves)
      for(Index h : curve.halfedges)
        add_seam(whole, h, seams);
    return cut_open(whole, seams);
  }

  Cut_mesh cut_;
  Mesh_connectivity connectivity_;
  Index number_of_vertices_; // of the mesh that is not cut
  std::vector<Index> source_of_loop_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_MESH_BESIDE_CURVES_H
