// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_EXACT_TREE_DEFAULT_BRANCH_STRENGTH_H
#define CGAL_CUT_LOCI_EXACT_TREE_DEFAULT_BRANCH_STRENGTH_H

#include <CGAL/Cut_loci/exact_geodesics/Geodesic_faces.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Cut_loci {
namespace internal {

/*!
 * tells how strong a branch of the cut locus of a polyhedron has to be, to be one of the surface that the polyhedron
 * stands for.
 *
 * Every vertex of positive curvature has a branch. By Gauss-Bonnet, the two shortest paths to a point of a branch
 * enclose a curvature: that of the shape, of single vertices, or of noise.
 *
 * - A mesh resolves nothing that is narrower than about three edges: two paths that are never farther apart may enclose
 *   a single vertex.
 * - Noise bends the two by random angles. As the noise of the angle sums of neighbors cancels, these come from the
 *   boundary of what they enclose: with a standard deviation &sigma; on the length h of an edge, two paths of the
 *   length L get apart by s = h &sigma; (L/h)<sup>3/2</sup> / &radic;3, as a sum of random bends does. If that is more
 *   than h, paths refocus on the way and the shortest of many is taken; then distances between shortest paths in a
 *   random medium grow by the power 2/3 of the length \cgalCite{cgal:kpz-dsgi-86}, from h on at the length where s = h:
 *   that is h (s/h)<sup>4/9</sup>.
 *
 * What the mesh and noise explain are independent and add as squares do: the width is h &radic;(9 + t<sup>2</sup>), where
 * t is twice (s/h)<sup>4/9</sup>, and L the diagonal of the bounding box. A polyhedron of which more than half of the
 * curvature is in a few sharp vertices stands for itself: there branches count at any width, if the paths part at as much
 * as one of these bends them, or if there is no other curvature, if they enclose that much.
 */
class Default_branch_strength
{
public:
  /// the angle of a sharp vertex: a smooth surface with such vertices has a dozen edges around it
  static constexpr double sharp = 0.5;

  double width = 0.;           ///< a length
  double gap = 0.;             ///< an angle
  bool counts_meeting = false; ///< see `Branch_strength`

  /// @param diagonal of the bounding box
  Default_branch_strength(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                          const Geodesic_faces& faces, double diagonal, const Progress& progress = {})
    : mesh_(mesh), connectivity_(connectivity), faces_(faces)
  {
    const double share = sharp_share(progress.part(0., 0.2));
    if(share >= 0.5)
    {
      gap = sharp;
      counts_meeting = share > 0.999; // the rest comes from coordinates of a few digits
      return;
    }
    const double h = connectivity_.mean_edge_length;
    const double apart = noise(progress.part(0.2, 1.)) * std::pow(diagonal / h, 1.5) / std::sqrt(3.);
    width = h * std::hypot(3., 2. * std::pow(apart, 4. / 9.));
  }

private:
  /*
   * The standard deviation of the part of the angle sums around vertices that is noise, from what a vertex tells of its
   * neighbors: their mean follows that of a wave of three edges, which is about the shortest that a mesh resolves, by
   * J0(2 pi / 3) = .17, and if vertices are displaced independently on a regular mesh, it is -5/21 of the vertex' own.
   * Medians and cut values are for vertices of features.
   */
  double noise(const Progress& progress) const
  {
    const Progress reading = progress.part(0., 0.7);
    std::vector<double> own, around, deviations;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
    {
      reading(v, mesh_.number_of_vertices());
      double mean;
      if(connectivity_.is_border(v) || !mean_around(v, mean))
        continue;
      own.push_back(deficit(v));
      around.push_back(mean);
      deviations.push_back(std::fabs(deficit(v) - mean));
    }
    if(own.empty())
      return 0.;
    constexpr double of_median = 1.4826; // of the sizes of normally distributed numbers: their standard deviation
    std::vector<double> sizes(own.size());
    std::transform(own.begin(), own.end(), sizes.begin(), [](double d) { return std::fabs(d); });
    progress(0.7);
    const double most = 3. * of_median * median(sizes);
    progress(0.75);
    const auto cut = [&](double d) { return (std::max)(-most, (std::min)(d, most)); };
    double square = 0., product = 0.;
    for(std::size_t i = 0; i < own.size(); ++i)
    {
      square += cut(own[i]) * cut(own[i]);
      product += cut(own[i]) * cut(around[i]);
    }
    constexpr double of_shape = 0.17, of_noise = -5. / 21.;
    progress(0.9);
    const double share = square > 0. ? (of_shape - product / square) / (of_shape - of_noise) : 0.;
    progress(0.95);
    return std::sqrt((std::max)(0., (std::min)(share, 1.))) * of_median * median(deviations);
  }

  static double median(std::vector<double>& values)
  {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  bool mean_around(Index v, double& mean) const
  {
    double sum = 0.;
    Index number = 0;
    for(Index k = connectivity_.ring_begin[v]; k < connectivity_.ring_begin[v + std::size_t(1)]; ++k)
    {
      const Index w = mesh_.target(connectivity_.ring_halfedge[k]);
      if(connectivity_.is_border(w))
        continue;
      sum += deficit(w);
      ++number;
    }
    mean = sum / (std::max)(number, Index(1));
    return number > 0;
  }

  /// the part of the curvature that is in sharp vertices
  double sharp_share(const Progress& progress) const
  {
    double in_sharp = 0., all = 0.;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
    {
      progress(v, mesh_.number_of_vertices());
      if(connectivity_.is_border(v))
        continue;
      const double curvature = std::fabs(deficit(v));
      all += curvature;
      in_sharp += curvature >= sharp ? curvature : 0.;
    }
    return all > 0. ? in_sharp / all : 1.;
  }

  double deficit(Index v) const { return 2. * geodesic_pi - faces_.total_angle(v); }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Geodesic_faces& faces_;
};

} // namespace internal
} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_EXACT_TREE_DEFAULT_BRANCH_STRENGTH_H
