// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_LAPLACIAN_METHOD_LAPLACIAN_SOLVER_H
#define CGAL_CUT_LOCI_LAPLACIAN_METHOD_LAPLACIAN_SOLVER_H

#include <CGAL/Cut_loci/curve/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/curve/kept_parts.h>
#include <CGAL/Cut_loci/exact_geodesics/Geodesic_results.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/internal/Threads.h>
#include <CGAL/Cut_loci/laplacian_method/Branch_filter.h>
#include <CGAL/Cut_loci/laplacian_method/Differential_operators.h>
#include <CGAL/Cut_loci/laplacian_method/Source_roots.h>
#include <CGAL/Cut_loci/laplacian_method/Tangent_directions.h>
#include <CGAL/Cut_loci/laplacian_method/descent_forest.h>
#include <CGAL/Cut_loci/laplacian_method/gradient_angles.h>
#include <CGAL/Cut_loci/laplacian_method/homology.h>
#include <CGAL/Cut_loci/laplacian_method/region_growing_tree.h>
#include <CGAL/Cut_loci/laplacian_method/smoothing.h>
#include <CGAL/Cut_loci/laplacian_method/thinning.h>
#include <CGAL/Cut_loci/method/Method_solver.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/Source_faces.h>
#include <CGAL/Cut_loci/surface/checked_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The pipeline of the paper on one connected component: the stages in their order, on dense indices.
class Laplacian_solver : public Laplacian_method
{
public:
  // once per mesh
  Laplacian_solver(const Indexed_triangle_mesh& mesh, Laplacian_operator type, const Threads& threads = {},
                   const Progress& progress = {})
    : Laplacian_solver(mesh, std::make_shared<const Surface>(mesh, type, threads, progress))
  {
  }

  std::unique_ptr<Laplacian_method> for_other_sources() const override
  {
    return std::unique_ptr<Laplacian_method>(new Laplacian_solver(mesh_, surface_));
  }

  void report_to(const Progress& progress) override { progress_ = progress; }

  // once per source, in three parts
  //
  // `geodesics` is what the exact solver found: null, or there until the tree has grown.
  void set_distance(const std::vector<Indexed_source>& sources, std::vector<double> distance,
                    const Geodesic_results* geodesics = nullptr) override
  {
    roots_ = Source_roots(mesh_, connectivity_, sources);
    if(roots_.first_without_face() != null_index)
      Source_faces::throw_source_without_face(
        roots_.first_without_face(),
        "ask for cut_locus_method(Cut_loci::Method::DIRECTION) and cut_locus_curve(Cut_loci::Curve::THROUGH_FACES)");
    geodesics_ = geodesics;
    distance_ = std::move(distance);
    is_source_.assign(distance_.size(), 0);
    for(const Indexed_source& source : sources)
      if(source.vertex != null_index)
        is_source_[source.vertex] = 1;
    find_farthest();
  }

  void compute_strengths() override
  {
    const Eigen::Map<const Eigen::VectorXd> d(distance_.data(), static_cast<Eigen::Index>(distance_.size()));
    Eigen::VectorXd gradient = operators_.gradient * d;
    for(Index v : vertices_that_see_a_source())
      gradient[2 * v] = gradient[2 * v + 1] = 0.;
    angle_ = gradient_angles(connectivity_, tangent_, gradient, progress_.part(0.3, 0.8));
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(angle_[v] * distance_[v] < longest_edge(v))
        angle_[v] = 0.f;
    progress_(0.8);
    const Eigen::VectorXd laplacian = operators_.laplacian * d;
    laplacian_.resize(distance_.size());
    const double h = connectivity_.mean_edge_length; // makes the Laplacian free of the unit of length
    for(std::size_t v = 0; v < distance_.size(); ++v)
      laplacian_[v] = static_cast<float>(h * laplacian[static_cast<Eigen::Index>(v)]);
    for(const Indexed_source& source : roots_.sources())
      if(source.vertex != null_index)
      {
        // not on the cut locus, however the operators see this singularity
        angle_[source.vertex] = -1.f;
        laplacian_[source.vertex] = (std::numeric_limits<float>::max)();
      }
  }

  void grow_tree() override
  {
    crossed_ = edges_crossed_by_descents(mesh_, connectivity_, distance_, roots_, geodesics_, progress_.part(0., 0.5),
                                         &nearest_source_);
    for(Index v = 0; v < nearest_source_.size() && geodesics_ != nullptr; ++v)
      nearest_source_[v] = geodesics_->nearest_source(v);
    spanning_tree_ = region_growing_tree(connectivity_, laplacian_, choose_root(), roots_.elements(), crossed_,
                                         progress_.part(0.5, 0.75));
    tree_ = spanning_tree_;
    thin(tree_, connectivity_, laplacian_, 2, progress_.part(0.75, 1.));
  }

  // What the homology demands is found once per source, whatever the thresholds.
  void close_cycles() override
  {
    const std::vector<Index> generators = homology_generators(mesh_, connectivity_, spanning_tree_, distance_, roots_,
                                                              crossed_, progress_.part(0., 0.7), &source_of_face_);
    filter_ = Branch_filter(mesh_, connectivity_, tree_, spanning_tree_, generators, angle_, laplacian_,
                            progress_.part(0.7, 1.));
  }

  // once per threshold
  Indexed_cut_locus filter(const Branch_thresholds& thresholds) const override
  {
    Indexed_cut_locus result = mesh_edge_graph(connectivity_, distance_, filter_(mesh_, thresholds));
    if(roots_.number_of_sources() > 1)
      name_sources(result);
    return result;
  }

  Indexed_cut_locus smoothed(const Indexed_cut_locus& cut_locus, const Smoothing_parameters& parameters) const override
  {
    return smoothed_cut_locus(mesh_, connectivity_, distance_, cut_locus, parameters, progress_, roots_.owners());
  }

  void remove_other_parts(const Kept_parts& parts, Indexed_cut_locus& edges, Indexed_cut_locus& curve) const override
  {
    internal::remove_other_parts(mesh_, connectivity_, parts, edges, curve);
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Differential_operators& operators() const { return operators_; }
  const std::vector<double>& distance() const override { return distance_; }
  const std::vector<float>& gradient_angle() const { return angle_; }
  const std::vector<float>& laplacian() const { return laplacian_; }
  Index number_of_border_loops() const override { return connectivity_.number_of_border_loops; }
  Index genus() const override { return surface_->genus; }
  Index root() const override { return tree_.root; }
  Index farthest() const override { return farthest_; }
  std::vector<Index> nearest_sources() const override { return nearest_source_; }

private:
  // A source is not it even if all distances are equal, unless all vertices are sources.
  void find_farthest()
  {
    farthest_ = null_index;
    for(Index v = 0; v < distance_.size(); ++v)
      if(!is_source_[v] && (farthest_ == null_index || distance_[v] > distance_[farthest_]))
        farthest_ = v;
    if(farthest_ == null_index)
      farthest_ = first_that_may_be_root();
  }

  // A vertex that does not have all faces around it as a source. There is one: each source has faces.
  Index first_that_may_be_root() const
  {
    std::vector<unsigned char> is_enclosed(distance_.size(), 0);
    for(const Source_element& element : roots_.elements())
      if(element.vertex != null_index)
        is_enclosed[element.vertex] = 1;
    return static_cast<Index>(std::find(is_enclosed.begin(), is_enclosed.end(), 0) - is_enclosed.begin());
  }

  // Edges between the disks of two sources are no branch, and have no strength of one.
  void name_sources(Indexed_cut_locus& graph) const
  {
    for(Indexed_cut_locus::Edge& e : graph.edges)
    {
      const Index o = mesh_.opposite[e.halfedge], a = source_of_face_[e.halfedge / 3];
      const Index b = o != null_index ? source_of_face_[o / 3] : a;
      e.sources = {{(std::min)(a, b), (std::max)(a, b)}};
      if(a != b)
        e.strength = gap_between_sources;
    }
  }

  // Around the source the distance is that to a point: the gradient turns by l / d along an edge of length l at the
  // distance d, and its estimate has errors of that order. A smaller angle is no evidence of anything else.
  double longest_edge(Index v) const
  {
    double result = 0.;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      result = (std::max)(result, norm(mesh_.points[connectivity_.ring_vertex[k]] - mesh_.points[v]));
    return result;
  }

  // The vertices to whose neighborhood quadrics are fitted across a source, where the distance has a tip: no gradient
  // comes of that. They are its neighbors, and those on the other side of the edges between neighbors.
  std::vector<Index> vertices_that_see_a_source() const
  {
    std::vector<Index> result;
    const auto add_across = [&](Index h)
    {
      result.push_back(mesh_.source(h));
      result.push_back(mesh_.target(h));
      if(!mesh_.is_border_edge(h))
        result.push_back(mesh_.source(mesh_.previous(mesh_.opposite[h])));
    };
    for(const Indexed_source& source : roots_.sources())
      if(source.vertex == null_index)
        for(Index i = 0; i < 3; ++i)
          add_across(3 * source.location.face + i);
      else
        for(Index k = connectivity_.ring_begin[source.vertex]; k < connectivity_.ring_begin[source.vertex + 1]; ++k)
          if(mesh_.source(connectivity_.ring_halfedge[k]) == source.vertex)
            add_across(Indexed_triangle_mesh::next(connectivity_.ring_halfedge[k]));
    return result;
  }

  // The farthest vertex is on the cut locus of a closed surface. A border vertex may be farthest without being on it:
  // then the lowest Laplacian is the best guess.
  Index choose_root() const
  {
    if(!connectivity_.is_border(farthest_))
      return farthest_;
    Index best = null_index;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(!connectivity_.is_border(v) && !is_source_[v] && (best == null_index || laplacian_[v] < laplacian_[best]))
        best = v;
    return best != null_index ? best : farthest_;
  }

  // what depends on the mesh alone
  struct Surface
  {
    Surface(const Indexed_triangle_mesh& mesh, Laplacian_operator type, const Threads& threads,
            const Progress& progress)
      : connectivity(mesh, progress.part(0., 0.1)),
        tangent(checked_mesh(mesh, connectivity), connectivity, progress.part(0.1, 0.3)),
        operators(mesh, connectivity, type, threads, progress.part(0.3, 0.9)), genus(connectivity.genus(mesh))
    {
      tangent.align(mesh, connectivity, operators.frames, progress.part(0.9, 1.));
    }

    Mesh_connectivity connectivity;
    Tangent_directions tangent;
    Differential_operators operators;
    Index genus;
  };

  Laplacian_solver(const Indexed_triangle_mesh& mesh, std::shared_ptr<const Surface> surface)
    : mesh_(mesh), surface_(std::move(surface)), connectivity_(surface_->connectivity), tangent_(surface_->tangent),
      operators_(surface_->operators)
  {
  }

  const Indexed_triangle_mesh& mesh_;
  std::shared_ptr<const Surface> surface_;
  const Mesh_connectivity& connectivity_; // these are of it
  const Tangent_directions& tangent_;
  const Differential_operators& operators_;

  Source_roots roots_;
  std::vector<unsigned char> is_source_; // vertices
  std::vector<double> distance_;
  const Geodesic_results* geodesics_ = nullptr;
  Index farthest_ = null_index;
  std::vector<float> angle_, laplacian_;
  std::vector<unsigned char> crossed_; // edges, by descents of the distance
  Spanning_tree spanning_tree_;
  Spanning_tree tree_; // the same, thinned
  Branch_filter filter_;
  std::vector<Index> source_of_face_; // in whose disk it is
  std::vector<Index> nearest_source_; // of each vertex, if there are several
  Progress progress_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_LAPLACIAN_METHOD_LAPLACIAN_SOLVER_H
