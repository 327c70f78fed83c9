// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_COMPONENT_SOLVER_H
#define CGAL_CUT_LOCI_INTERNAL_COMPONENT_SOLVER_H

#include <CGAL/Cut_loci/Branch_filter.h>
#include <CGAL/Cut_loci/Differential_operators.h>
#include <CGAL/Cut_loci/Indexed_cut_locus.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Invalid_input.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/Tangent_directions.h>
#include <CGAL/Cut_loci/descent_forest.h>
#include <CGAL/Cut_loci/gradient_angles.h>
#include <CGAL/Cut_loci/homology.h>
#include <CGAL/Cut_loci/internal/Geodesic_results.h>
#include <CGAL/Cut_loci/internal/vector_3.h>
#include <CGAL/Cut_loci/region_growing_tree.h>
#include <CGAL/Cut_loci/smoothing.h>
#include <CGAL/Cut_loci/thinning.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

// The pipeline of the paper on one connected component: the stages in their order, on dense indices.
class Component_solver
{
public:
  // once per mesh
  Component_solver(const Indexed_triangle_mesh& mesh, Laplacian_operator type)
    : mesh_(mesh), connectivity_(mesh), tangent_(checked(mesh, connectivity_), connectivity_),
      operators_(mesh, connectivity_, type), genus_(connectivity_.genus(mesh))
  {
    tangent_.align(mesh, connectivity_, operators_.frames);
  }

  // once per source, in three parts
  //
  // `geodesics` is what the exact solver found: null, or there until the tree has grown.
  void set_distance(const Indexed_source& source, std::vector<double> distance,
                    const Geodesic_results* geodesics = nullptr)
  {
    source_ = source;
    geodesics_ = geodesics;
    distance_ = std::move(distance);
    farthest_ = source.vertex == 0 ? 1 : 0;
    for(Index v = farthest_ + 1; v < distance_.size(); ++v) // the source is not it even if all distances are equal
      if(v != source.vertex && distance_[v] > distance_[farthest_])
        farthest_ = v;
  }

  void compute_strengths()
  {
    const Eigen::Map<const Eigen::VectorXd> d(distance_.data(), static_cast<Eigen::Index>(distance_.size()));
    Eigen::VectorXd gradient = operators_.gradient * d;
    for(Index v : vertices_that_see_the_source())
      gradient[2 * v] = gradient[2 * v + 1] = 0.;
    angle_ = gradient_angles(connectivity_, tangent_, gradient);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(angle_[v] * distance_[v] < longest_edge(v))
        angle_[v] = 0.f;
    const Eigen::VectorXd laplacian = operators_.laplacian * d;
    laplacian_.resize(distance_.size());
    const double h = connectivity_.mean_edge_length; // makes the Laplacian free of the unit of length
    for(std::size_t v = 0; v < distance_.size(); ++v)
      laplacian_[v] = static_cast<float>(h * laplacian[static_cast<Eigen::Index>(v)]);
    if(source_.vertex != null_index)
    {
      // never on the cut locus, however the operators see this singularity
      angle_[source_.vertex] = -1.f;
      laplacian_[source_.vertex] = (std::numeric_limits<float>::max)();
    }
  }

  void grow_tree()
  {
    crossed_ = edges_crossed_by_descents(mesh_, connectivity_, distance_, source_, geodesics_);
    spanning_tree_ =
      region_growing_tree(connectivity_, laplacian_, choose_root(), Source_element(connectivity_, source_), crossed_);
    tree_ = spanning_tree_;
    thin(tree_, connectivity_, laplacian_, 2);
  }

  // What the homology demands is found once per source, whatever the thresholds.
  void close_cycles()
  {
    const std::vector<Index> generators =
      homology_generators(mesh_, connectivity_, spanning_tree_, distance_, source_, crossed_);
    filter_ = Branch_filter(mesh_, connectivity_, tree_, spanning_tree_, generators, angle_, laplacian_);
  }

  // In radians. Around the end of a branch, gradients are focused before they cross: a few edges beyond the end they
  // still meet at half a radian. On tori of 7 K to 113 K faces thresholds from 0.5 to 1 put the ends within 2.5
  // edges.
  static double default_gradient_angle_threshold() { return 0.7; }

  // once per threshold
  Indexed_cut_locus filter(const Branch_thresholds& thresholds) const
  {
    return mesh_edge_graph(connectivity_, distance_, filter_(mesh_, thresholds));
  }

  Indexed_cut_locus smoothed(const Indexed_cut_locus& cut_locus, const Smoothing_parameters& parameters) const
  {
    return smoothed_cut_locus(mesh_, connectivity_, distance_, cut_locus, parameters);
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  const Mesh_connectivity& connectivity() const { return connectivity_; }
  const Differential_operators& operators() const { return operators_; }
  const std::vector<double>& distance() const { return distance_; }
  const std::vector<float>& gradient_angle() const { return angle_; }
  const std::vector<float>& laplacian() const { return laplacian_; }
  Index genus() const { return genus_; }
  Index root() const { return tree_.root; }
  Index farthest() const { return farthest_; }

  // Faces without area have no tangent plane. Coordinates of the size of a face resolve 2^-53 of it: at 100 times that,
  // the direction of its normal is noise.
  static const Indexed_triangle_mesh& checked(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity)
  {
    if(!connectivity.first_non_manifold.empty())
      throw Non_manifold_vertex{connectivity.first_non_manifold.front()};
    for(Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Vector &p = mesh.points[mesh.triangles[f][0]], &q = mesh.points[mesh.triangles[f][1]],
                   &r = mesh.points[mesh.triangles[f][2]];
      const Vector a = q - p, b = r - p, c = r - q;
      const double longest = (std::max)({dot(a, a), dot(b, b), dot(c, c)});
      const double twice_area = norm(cross(a, b));
      if(!(twice_area > 1e-14 * longest) || !std::isfinite(twice_area))
        throw Face_without_area{f};
    }
    return mesh;
  }

private:
  // Around the source the distance is that to a point: the gradient turns by l / d along an edge of length l at the
  // distance d, and its estimate has errors of that order. A smaller angle is no evidence of anything else.
  double longest_edge(Index v) const
  {
    double result = 0.;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + 1]; ++k)
      result = (std::max)(result, norm(mesh_.points[connectivity_.ring_vertex[k]] - mesh_.points[v]));
    return result;
  }

  // The vertices to whose neighborhood quadrics are fitted across the source, where the distance has a tip: no gradient
  // comes of that. They are its neighbors, and those on the other side of the edges between neighbors.
  std::vector<Index> vertices_that_see_the_source() const
  {
    std::vector<Index> result;
    const auto add_across = [&](Index h)
    {
      result.push_back(mesh_.source(h));
      result.push_back(mesh_.target(h));
      if(!mesh_.is_border_edge(h))
        result.push_back(mesh_.source(mesh_.previous(mesh_.opposite[h])));
    };
    if(source_.vertex == null_index)
      for(Index i = 0; i < 3; ++i)
        add_across(3 * source_.location.face + i);
    else
      for(Index k = connectivity_.ring_begin[source_.vertex]; k < connectivity_.ring_begin[source_.vertex + 1]; ++k)
        if(mesh_.source(connectivity_.ring_halfedge[k]) == source_.vertex)
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
      if(!connectivity_.is_border(v) && v != source_.vertex && (best == null_index || laplacian_[v] < laplacian_[best]))
        best = v;
    return best != null_index ? best : farthest_;
  }

public:
  // thrown with the component's index, for the caller to name the element of the input
  struct Face_without_area
  {
    Index face;
  };
  struct Non_manifold_vertex
  {
    Index vertex;
  };

private:
  const Indexed_triangle_mesh& mesh_;
  Mesh_connectivity connectivity_;
  Tangent_directions tangent_;
  Differential_operators operators_;
  Index genus_;

  Indexed_source source_;
  std::vector<double> distance_;
  const Geodesic_results* geodesics_ = nullptr;
  Index farthest_ = null_index;
  std::vector<float> angle_, laplacian_;
  std::vector<unsigned char> crossed_; // edges, by descents of the distance
  Spanning_tree spanning_tree_;
  Spanning_tree tree_; // the same, thinned
  Branch_filter filter_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_INTERNAL_COMPONENT_SOLVER_H
