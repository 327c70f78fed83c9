// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_DIRECTION_SOLVER_H
#define CGAL_CUT_LOCI_INTERNAL_DIRECTION_SOLVER_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/branch_ends.h>
#include <CGAL/Cut_loci/curve_correspondence.h>
#include <CGAL/Cut_loci/cut_locus_method.h>
#include <CGAL/Cut_loci/direction_field.h>
#include <CGAL/Cut_loci/direction_jumps.h>
#include <CGAL/Cut_loci/direction_pruning.h>
#include <CGAL/Cut_loci/direction_transport.h>
#include <CGAL/Cut_loci/direction_tree.h>
#include <CGAL/Cut_loci/internal/Component_solver.h>
#include <CGAL/Cut_loci/internal/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/mesh_edge_snapping.h>
#include <CGAL/Cut_loci/short_branches.h>
#include <CGAL/Cut_loci/sub_edge_placement.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

struct Direction_thresholds
{
  double strength;
  Index minimum_edges = 0;    // branches of fewer edges of the mesh are removed
  double minimum_length = 0.; // branches that are shorter are removed
};

// The direction method on one connected component: the stages in their order, on dense indices.
class Direction_solver
{
public:
  // once per mesh
  explicit Direction_solver(const Indexed_triangle_mesh& mesh)
    : mesh_(mesh), connectivity_(mesh), geometry_(Component_solver::checked(mesh, connectivity_), connectivity_)
  {
  }

  // once per source, in four parts; the first is one of these two
  void compute_distance(const Indexed_source& source)
  {
    make_propagation();
    Exact_geodesic_options options;
    options.directions = true;
    propagation_->run({source.location}, options);
    source_ = source;
    distance_ = propagation_->distances();
    has_directions_ = true;
    find_farthest();
  }

  void set_distance(const Indexed_source& source, std::vector<double> distance)
  {
    source_ = source;
    distance_ = std::move(distance);
    has_directions_ = false;
    find_farthest();
  }

  void compute_strengths()
  {
    field_ = has_directions_ ? direction_field(mesh_, connectivity_, geometry_, source_, *propagation_)
                             : direction_field(mesh_, connectivity_, geometry_, source_, distance_);
    jumps_ = direction_jumps(mesh_, connectivity_, geometry_, field_);
  }

  void grow_tree() { graph_ = direction_graph(mesh_, connectivity_, jumps_, source_); }

  void close_cycles()
  {
    const Index farthest_face = connectivity_.ring_halfedge[connectivity_.ring_begin[farthest_]] / 3;
    branches_ = Direction_branches(mesh_, connectivity_, geometry_, jumps_, graph_, farthest_face);
    mesh_edges_ = Mesh_edge_branches(mesh_, connectivity_, geometry_, field_, branches_, farthest_);
  }

  // once per threshold
  Indexed_cut_locus filter(double threshold, Curve curve) const
  {
    Indexed_cut_locus edges;
    return filter({threshold}, curve, edges);
  }

  // `edges` becomes the curve of mesh edges for the same thresholds, whichever curve is asked for.
  Indexed_cut_locus filter(const Direction_thresholds& thresholds, Curve curve, Indexed_cut_locus& edges) const
  {
    const std::vector<Direction_branches::Edge> kept = branches_(thresholds.strength);
    Sub_edge_curve result = place_sub_edges(mesh_, connectivity_, geometry_, field_, kept);
    const Branch_ends ends(mesh_, connectivity_, geometry_, field_);
    const std::vector<std::vector<Index>> continuations = ends(kept, result);
    edges = mesh_edges_(mesh_, connectivity_, field_, thresholds.strength);
    for(const std::vector<Index>& c : continuations)
      continue_mesh_edges(connectivity_, field_, c, edges);
    if(curve == Curve::THROUGH_FACES)
      set_origins(mesh_, connectivity_, edges, result.face, result.graph);
    if(thresholds.minimum_edges > 1 || thresholds.minimum_length > 0.)
      remove_short_branches(thresholds, curve, edges, result);
    if(curve == Curve::MESH_EDGES)
      return edges;
    if(!result.graph.nodes.empty())
      return std::move(result.graph);
    Indexed_cut_locus point = edges; // the single one that is left
    point.edges.clear();
    point.nodes.resize(1);
    return point;
  }

  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Direction_geometry& geometry() const { return geometry_; }
  const Direction_field& field() const { return field_; }
  const Direction_branches& branches() const { return branches_; }
  const std::vector<double>& distance() const { return distance_; }
  Index farthest() const { return farthest_; }
  Index genus() const { return connectivity_.genus(mesh_); }
  // the vertex at the begin of the curve of mesh edges
  Index root() const { return mesh_edges_.root(); }
  double default_threshold() const { return geometry_.default_strength_threshold(distance_[farthest_]); }

private:
  // Both curves lose the same branches: those that are short as edges of the mesh.
  void remove_short_branches(const Direction_thresholds& thresholds, Curve curve, Indexed_cut_locus& edges,
                             Sub_edge_curve& through_faces) const
  {
    const std::vector<unsigned char> is_removed =
      short_branches(mesh_, connectivity_, edges, thresholds.minimum_edges, thresholds.minimum_length);
    if(curve == Curve::THROUGH_FACES && !through_faces.graph.edges.empty())
    {
      const std::vector<unsigned char> is_gone =
        corresponding_branches(mesh_, connectivity_, edges, is_removed, through_faces.graph);
      std::size_t size = 0;
      for(std::size_t i = 0; i < is_gone.size(); ++i)
        if(!is_gone[i])
          through_faces.face[size++] = through_faces.face[i];
      through_faces.face.resize(size);
      remove_edges(mesh_, connectivity_, through_faces.graph, is_gone);
      if(through_faces.graph.edges.empty())
        through_faces.graph.nodes.clear();
    }
    remove_edges(mesh_, connectivity_, edges, is_removed);
    for(Index i = 0; i < edges.edges.size(); ++i)
      edges.edges[i].origin = i;
    if(curve == Curve::THROUGH_FACES)
      set_origins(mesh_, connectivity_, edges, through_faces.face, through_faces.graph);
  }

  void make_propagation()
  {
    if(!propagation_)
      propagation_.reset(new Exact_geodesic_propagation(mesh_));
  }

  void find_farthest()
  {
    farthest_ = source_.vertex == 0 ? 1 : 0;
    for(Index v = farthest_ + 1; v < distance_.size(); ++v) // the source is not it even if all distances are equal
      if(v != source_.vertex && distance_[v] > distance_[farthest_])
        farthest_ = v;
  }

  const Indexed_triangle_mesh& mesh_;
  Mesh_connectivity connectivity_;
  Direction_geometry geometry_;
  std::unique_ptr<Exact_geodesic_propagation> propagation_;

  Indexed_source source_;
  std::vector<double> distance_;
  bool has_directions_ = false;
  Index farthest_ = null_index;
  Direction_field field_;
  Direction_jumps jumps_;
  Direction_graph graph_;
  Direction_branches branches_;
  Mesh_edge_branches mesh_edges_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_DIRECTION_SOLVER_H
