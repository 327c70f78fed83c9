// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_CURVE_FILTER_H
#define CGAL_CUT_LOCI_EXACT_TREE_CURVE_FILTER_H

#include <CGAL/Cut_loci/curve/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/curve/curve_correspondence.h>
#include <CGAL/Cut_loci/curve/kept_parts.h>
#include <CGAL/Cut_loci/curve/short_branches.h>
#include <CGAL/Cut_loci/exact_tree/Tree_curve.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// Takes from the curves, the one of mesh edges and the one through the faces, what is not asked for: short branches, and
// what is between two sources or inside of a cell.
class Curve_filter
{
public:
  Curve_filter(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
               const Exact_tree_thresholds& thresholds)
    : mesh_(mesh), connectivity_(connectivity), thresholds_(thresholds)
  {
  }

  void remove_short_branches(Indexed_cut_locus& edges) const
  {
    remove_edges(mesh_, connectivity_, edges, short_ones(edges));
  }

  // Both curves lose the same branches: those that are short as edges of the mesh.
  void remove_short_branches(Indexed_cut_locus& edges, Tree_curve& curve) const
  {
    const std::vector<unsigned char> is_removed = short_ones(edges);
    if(!curve.graph.edges.empty())
    {
      const std::vector<unsigned char> is_gone =
        corresponding_branches(mesh_, connectivity_, edges, is_removed, curve.graph);
      std::size_t size = 0;
      for(std::size_t i = 0; i < is_gone.size(); ++i)
        if(!is_gone[i])
          curve.face[size++] = curve.face[i];
      curve.face.resize(size);
      remove_edges(mesh_, connectivity_, curve.graph, is_gone);
    }
    remove_edges(mesh_, connectivity_, edges, is_removed);
    for(Index i = 0; i < edges.edges.size(); ++i)
      edges.edges[i].origin = i;
    set_origins(mesh_, connectivity_, edges, curve.face, curve.graph);
  }

  void remove_other_parts(Indexed_cut_locus& graph) const
  {
    internal::remove_other_parts(mesh_, connectivity_, thresholds_, graph);
  }

  // from both curves, of which the second one refers to the first
  void remove_other_parts(Indexed_cut_locus& edges, Indexed_cut_locus& curve) const
  {
    internal::remove_other_parts(mesh_, connectivity_, thresholds_, edges, curve);
  }

private:
  std::vector<unsigned char> short_ones(const Indexed_cut_locus& edges) const
  {
    return short_branches(mesh_, connectivity_, edges, thresholds_.minimum_edges, thresholds_.minimum_length);
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Exact_tree_thresholds& thresholds_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_CURVE_FILTER_H
