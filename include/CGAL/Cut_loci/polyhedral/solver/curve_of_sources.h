// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CURVE_OF_SOURCES_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CURVE_OF_SOURCES_H

#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_options.h>
#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/graph/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/graph/Mesh_beside_curves.h>
#include <CGAL/Cut_loci/graph/lone_nodes.h>
#include <CGAL/Cut_loci/graph/short_branches.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/distances_from_curves.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/curves/Mesh_edge_curve.h>
#include <CGAL/Cut_loci/polyhedral/curves/Tree_curve.h>
#include <CGAL/Cut_loci/polyhedral/solver/Sources_tree.h>
#include <CGAL/Cut_loci/polyhedral/strength/Tree_branches.h>
#include <CGAL/Cut_loci/surface/cut_open.h>
#include <CGAL/Cut_loci/ways/Source_roots.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The curve of the mesh that the edges of a tree which are kept stand for.

/// made of edges of the mesh
inline Indexed_cut_locus mesh_edges_of_sources(Sources_tree& of, const std::vector<Tree_branches::Edge>& kept,
                                               const Exact_tree_thresholds& thresholds, const Progress& progress)
{
  const Mesh_beside_curves beside(of.mesh(), static_cast<Index>(of.points().size()), of.curves());
  const std::string remedy = "ask for cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)";
  beside.check_gaps(remedy);
  const Source_roots roots(beside.mesh(), beside.connectivity(), of.points(), beside.parts());
  roots.check_faces(remedy);
  const std::vector<double> distance = beside.distances(of.distance());
  const auto cut_open = [&](const Seams& seams)
  { return distances_cut_open(of.mesh(), of.points(), of.curves(), seams, of.maximum_relative_error()); };
  const bool has_curves = !of.curves().empty();
  Indexed_cut_locus result =
    std::move(Mesh_edge_curve(beside.mesh(), beside.connectivity(), of.prepared().divided(), of.tree(), kept, roots,
                              distance, cut_open, has_curves ? null_index : of.lone_vertex(), progress)
                .graph);
  remove_short_branches(beside.mesh(), beside.connectivity(), {}, thresholds.minimum_edges, thresholds.minimum_length,
                        result);
  if(has_curves)
  {
    if(result.edges.empty())
      result.nodes.clear();
    std::vector<Index> face;
    for(const Indexed_cut_locus::Edge& e : result.edges)
      face.push_back(e.halfedge / 3);
    if(add_lone_nodes(
         beside.mesh(), beside.connectivity(), distance, face, [&](Index h) { return beside.parts().is_on_source(h); },
         result))
      set_distances_from_curves(of.mesh(), of.points(), of.curves(), result);
  }
  remove_other_parts(beside.mesh(), beside.connectivity(), thresholds.part, result);
  beside.close(result);
  return result;
}

/// Pieces that the topology alone has added have no paths to tell them, and those of a perturbed surface are of other
/// lengths.
inline void correct_distances(const Sources_tree& of, const std::vector<Tree_branches::Edge>& kept,
                              Indexed_cut_locus& curve)
{
  if(!of.curves().empty())
  {
    set_distances_from_curves(of.mesh(), of.points(), of.curves(), curve);
    return;
  }
  std::vector<Index> faces;
  for(Index e : of.tree().unknown(kept))
    faces.push_back(of.tree().graph().edges[e].face);
  std::sort(faces.begin(), faces.end());
  if(!of.is_perturbed() && (faces.empty() || of.maximum_relative_error() > 0.))
    return;
  const bool are_all = of.is_perturbed() || of.prepared().is_other(); // else faces have their own numbers
  std::vector<Index> nodes;
  Exact_geodesic_options options;
  for(Index i = 0; i < curve.nodes.size(); ++i)
    if(are_all || std::binary_search(faces.begin(), faces.end(), curve.nodes[i].location.face))
    {
      nodes.push_back(i);
      options.queries.push_back(curve.nodes[i].location);
    }
  Exact_geodesic_propagation exact(of.surface().faces);
  exact.run(locations_of(of.points()), options);
  for(std::size_t i = 0; i < nodes.size(); ++i)
    curve.nodes[nodes[i]].distance = exact.query_distance(i);
}

inline Indexed_cut_locus curve_through_faces(Sources_tree& of, const std::vector<Tree_branches::Edge>& kept,
                                             const Exact_tree_thresholds& thresholds, const Progress& progress)
{
  const Mesh_connectivity& connectivity = *of.surface().connectivity;
  Tree_curve drawn(of.tree(), kept, of.lone_vertex(), progress);
  if(!of.curves().empty())
  {
    const Exact_geodesic_propagation& geodesics = of.prepared().geodesics();
    if(drawn.graph.edges.empty())
      drawn.graph.nodes.clear();
    add_lone_nodes(
      of.prepared().mesh(), of.prepared().connectivity(), geodesics.distances(), drawn.face,
      [&](Index h) { return geodesics.line_at(h) != null_index; }, drawn.graph);
  }
  of.prepared().to_mesh(drawn.graph, drawn.face);
  correct_distances(of, kept, drawn.graph);
  remove_short_branches(of.mesh(), connectivity, drawn.face, thresholds.minimum_edges, thresholds.minimum_length,
                        drawn.graph);
  remove_other_parts(of.mesh(), connectivity, thresholds.part, drawn.graph);
  return std::move(drawn.graph);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOLVER_CURVE_OF_SOURCES_H
