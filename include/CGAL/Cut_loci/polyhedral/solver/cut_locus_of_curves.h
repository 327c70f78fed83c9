// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CUT_LOCUS_OF_CURVES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CUT_LOCUS_OF_CURVES_H

#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/Mesh_beside_curves.h>
#include <CGAL/Cut_loci/graph/lone_nodes.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/curves/Mesh_edge_curve.h>
#include <CGAL/Cut_loci/polyhedral/curves/Tree_curve.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_curves.h>
#include <CGAL/Cut_loci/polyhedral/sources/Mesh_with_sources.h>
#include <CGAL/Cut_loci/polyhedral/sources/distances_from_curves.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/polyhedral/tree/Exact_tree.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The cut locus of sources that are curves, on the mesh without them.

/// made of edges of the mesh
///
/// @param divided the mesh with a vertex at each point, and
/// @param tree the one on that, cut open along the curves, of which
/// @param kept are the edges that the curve stands for
inline Indexed_cut_locus
mesh_edges_between_curves(const Indexed_triangle_mesh& mesh, const std::vector<Indexed_source>& points,
                          const std::vector<Indexed_curve>& curves, const std::vector<double>& distance_on_mesh,
                          const Mesh_with_sources& divided, Exact_tree& tree,
                          const std::vector<Tree_branches::Edge>& kept, const Exact_tree_thresholds& thresholds)
{
  const Mesh_beside_curves beside(mesh, static_cast<Index>(points.size()), curves);
  const std::string remedy = "ask for cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)";
  beside.check_gaps(remedy);
  const Source_roots roots(beside.mesh(), beside.connectivity(), points, beside.parts());
  roots.check_faces(remedy);
  const std::vector<double> distance = beside.distances(distance_on_mesh);
  const auto cut_open = [&](const Seams& seams) { return distances_cut_open(mesh, points, curves, seams, 0.); };
  Indexed_cut_locus result = std::move(
    Mesh_edge_curve(beside.mesh(), beside.connectivity(), &divided, tree, kept, roots, distance, cut_open, null_index)
      .graph);
  remove_short_branches(beside.mesh(), beside.connectivity(), {}, thresholds.minimum_edges, thresholds.minimum_length,
                        result);
  if(result.edges.empty())
    result.nodes.clear();
  std::vector<Index> face;
  for(const Indexed_cut_locus::Edge& e : result.edges)
    face.push_back(e.halfedge / 3);
  if(add_lone_nodes(
       beside.mesh(), beside.connectivity(), distance, face, [&](Index h) { return beside.parts().is_on_source(h); },
       result))
    set_distances_from_curves(mesh, points, curves, result);
  remove_other_parts(beside.mesh(), beside.connectivity(), thresholds.part, result);
  beside.close(result);
  return result;
}

/// through the faces
///
/// @param lone the vertex that is left if nothing else is
inline Indexed_cut_locus curve_between_curves(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                                              const std::vector<Indexed_source>& points,
                                              const std::vector<Indexed_curve>& curves,
                                              const Mesh_with_sources& divided, const Mesh_with_curves& with_curves,
                                              Exact_tree& tree, const std::vector<Tree_branches::Edge>& kept,
                                              const Exact_tree_thresholds& thresholds, Index lone)
{
  Tree_curve result(tree.mesh(), tree.connectivity(), tree.geodesics(), tree, kept, lone);
  if(result.graph.edges.empty())
    result.graph.nodes.clear();
  add_lone_nodes(
    tree.mesh(), tree.connectivity(), tree.geodesics().distances(), result.face,
    [&](Index h) { return tree.geodesics().line_at(h) != null_index; }, result.graph);
  with_curves.close(result.graph);
  divided.remove_sources(result.graph, result.face);
  remove_other_parts(mesh, connectivity, thresholds.part, result.graph);
  set_distances_from_curves(mesh, points, curves, result.graph);
  return std::move(result.graph);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CUT_LOCUS_OF_CURVES_H
