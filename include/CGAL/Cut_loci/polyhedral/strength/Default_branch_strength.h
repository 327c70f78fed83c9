// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DEFAULT_BRANCH_STRENGTH_H
#define CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DEFAULT_BRANCH_STRENGTH_H

#include <CGAL/Cut_loci/geodesics/windows/Geodesic_faces.h>
#include <CGAL/Cut_loci/internal/Progress.h>
#include <CGAL/Cut_loci/method/method_thresholds.h>
#include <CGAL/Cut_loci/polyhedral/strength/Curve_turns.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/Mesh_connectivity.h>
#include <CGAL/Cut_loci/surface/extent.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * tells how strong a branch of the cut locus of a polyhedron has to be, to be one of the surface that the polyhedron
 * stands for: its paths get farther apart than the mesh and noise explain, see `Path_noise`, or enclose more curvature and
 * are not next to each other. A path that is led aside by the width w on its way of the length L is longer by w^2 / (2 L): a
 * branch that is no higher is none. The user manual derives it.
 *
 * Flat vertices tell nothing of the surface: h is the mean length of edges if there were none.
 */
class Default_branch_strength
{
public:
  Branch_strength strength;

  /// @param extent see `internal::extent()`
  /// @param turns of sources that are curves
  Default_branch_strength(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity,
                          const Geodesic_faces& faces, double extent, const Progress& progress = {},
                          Curve_turns turns = {})
    : mesh_(mesh), connectivity_(connectivity), turns_(std::move(turns))
  {
    read_deficits(faces, progress.part(0., 0.1));
    length_ = spread(mesh, extent) / edge_;
    const double any_turn = geodesic_pi / std::sqrt(12.);
    const double sigma = (std::min)(any_turn, noise(infinity, progress.part(0.1, 1.)));
    strength.noise = {sigma, edge_, length_};
    strength.width = strength.noise.widest();
    strength.narrow = Branch_strength::narrow_share * strength.width;
    strength.spur = strength.width * strength.width / (2. * length_ * edge_);
    strength.enclosed = strength.noise.enclosed(infinity);
    if(!turns_.chains.empty())
      add_turns();
    let_corners_count(ramp(2. * geodesic_pi - bends(sigma) - bends_of_turns(infinity), 0., 0.5 * geodesic_pi));
    if(!turns_.chains.empty())
      strength.spur =
        (std::max)(strength.spur, (std::min)(spur_of_turns_, 9. / 8. * smooth_ * smooth_ * length_ * edge_));
  }

private:
  void read_deficits(const Geodesic_faces& faces, const Progress& progress)
  {
    const Index n = mesh_.number_of_vertices();
    deficit_.assign(n, 0.);
    double sum = 0., inner = 0., bent = 0.;
    for(Index v = 0; v < n; ++v)
    {
      progress(v, n);
      if(connectivity_.is_border(v))
        continue;
      deficit_[v] = 2. * geodesic_pi - faces.total_angle(v);
      sum += std::fabs(deficit_[v]);
      ++inner;
    }
    flat_ = (std::max)(rounding, 0.01 * sum / (std::max)(1., inner));
    for(double d : deficit_)
      bent += is_bent(d) ? 1. : 0.;
    is_flat_ = bent == 0.;
    edge_ = connectivity_.mean_edge_length * (bent > 0. ? std::sqrt(inner / bent) : 1.);
  }

  bool is_bent(double deficit) const { return std::fabs(deficit) > flat_; }

  /*
   * What holds for a surface and its vertices does so for curves and theirs: a branch is resolved by three edges, and turns
   * have noise. In a curve that bends as little as a circle of the radius L, a smaller circle touches noise of the size a at
   * two places that are up to sqrt(8 a L) apart. A surface that is flat resolves all. Curves are moved by up to 1e-4 of
   * their edges: what is as low is no branch. Nor is what three edges that turn by t make: (3 t)^2 L / 8 at most.
   */
  void add_turns()
  {
    const double line = turns_.mean_edge_length(), whole = length_ * edge_;
    turns_.drop_straight();
    const double edge = turns_.number() > 0. ? turns_.mean_edge_length() : line;
    const double a = turns_.noise(infinity) * edge / std::sqrt(6.);
    const double width = std::hypot(3. * edge, (std::min)(std::sqrt(8. * a * whole), 0.25 * whole));
    if(is_flat_)
      strength.width = strength.spur = 0.;
    strength.width = (std::max)(strength.width, width);
    strength.narrow = Branch_strength::narrow_share * strength.width;
    strength.enclosed += bends_of_turns(infinity);
    strength.spur = (std::max)(strength.spur, 1.2e-4 * line);
    spur_of_turns_ = width * width / (2. * whole);
  }

  /// the angle between the directions at two places of a curve that is noise: two standard deviations
  double bends_of_turns(double most) const { return 2. * std::sqrt(2. / 3.) * turns_.noise(most); }

  /// the angle by which noise turns a closed way of twice the length of the surface
  double bends(double sigma) const { return strength.noise.bends(infinity, sigma); }

  /*
   * Where some vertices have many times the deficit of all others, the polyhedron stands for itself: the others are flat,
   * or smooth, or noise, and what encloses as much as one of these, but for a tenth, is strong at any width. Rounded
   * numbers and noise change ratios, so that there is a ramp and no limit.
   *
   * `share` is less than 1 where there are so many of them that the sum of their bends may be a full turn: then they are
   * noise themselves, as the corners of voxels are. Of curves, turns count as deficits do, for a share.
   */
  void let_corners_count(double share)
  {
    std::vector<double> sizes;
    double next = 0.;
    const auto add = [&](double d, bool bends)
    {
      if(std::fabs(d) >= 0.8 * sharp)
        sizes.push_back(std::fabs(d));
      else if(bends)
        next = (std::max)(next, std::fabs(d));
    };
    for(double d : deficit_)
      add(d, is_bent(d));
    for(const std::vector<double>& chain : turns_.chains)
      for(double t : chain)
        add(of_turn * t, true);
    std::sort(sizes.begin(), sizes.end(), std::greater<double>());
    sizes.push_back(next);
    const Branch_strength of_all = strength;
    double most = 0.;
    smooth_ = sizes.front();
    for(std::size_t i = 0; i + 1 < sizes.size(); ++i)
    {
      const double part =
        share * ramp(sizes[i], 0.8 * sharp, sharp) * ramp(sizes[i], 3. * sizes[i + 1], 11. * sizes[i + 1]);
      if(part == 0.)
        continue;
      const double enough =
        (std::min)(of_all.enclosed,
                   (std::max)(0.9 * sizes[i], bends(noise(sizes[i + 1])) + bends_of_turns(sizes[i + 1] / of_turn)));
      strength.enclosed = (std::min)(strength.enclosed, of_all.enclosed + part * (enough - of_all.enclosed));
      strength.narrow = (std::min)(strength.narrow, (1. - part) * of_all.narrow);
      most = (std::max)(most, part);
      smooth_ = (std::max)(sizes[i + 1], (1. - most) * sizes.front()); // those before it are no smaller
    }
  }

  /// 0 up to `from`, 1 from `to` on
  static double ramp(double x, double from, double to)
  {
    return x >= to ? 1. : (std::max)(0., (x - from) / (to - from));
  }

  /*
   * The standard deviation of the part of the angle sums around vertices that is noise, from what a vertex tells of its
   * neighbors: their mean follows that of a wave of three edges, which is about the shortest that a mesh resolves, by
   * J0(2 pi / 3) = .17, and if vertices are displaced independently on a regular mesh, it is -5/21 of the vertex' own. Where
   * vertices are so sharp that features are no longer than edges, as on coarse meshes, neighbors of the shape have nothing
   * in common. Medians and cut values are for vertices of features. Deficits above `most` are left out.
   */
  double noise(double most, const Progress& progress = {}) const
  {
    std::vector<double> own, around, deviations, sizes;
    read_neighbors(most, own, around, progress.part(0., 0.7));
    if(own.empty())
      return 0.;
    for(std::size_t i = 0; i < own.size(); ++i)
    {
      deviations.push_back(std::fabs(own[i] - around[i]));
      sizes.push_back(std::fabs(own[i]));
    }
    progress(0.7);
    const double largest = 3. * of_median * Curve_turns::median(sizes);
    progress(0.75);
    const auto cut = [&](double d) { return (std::max)(-largest, (std::min)(d, largest)); };
    double square = 0., product = 0.;
    for(std::size_t i = 0; i < own.size(); ++i)
    {
      square += cut(own[i]) * cut(own[i]);
      product += cut(own[i]) * cut(around[i]);
    }
    const double deviation = of_median * Curve_turns::median(deviations);
    progress(0.9);
    constexpr double of_noise = -5. / 21.;
    const double of_shape = 0.17 * (std::max)(0., 1. - deviation / sharp);
    const double share = square > 0. ? (of_shape - product / square) / (of_shape - of_noise) : 0.;
    return std::sqrt((std::max)(0., (std::min)(share, 1.))) * deviation;
  }

  /// the deficits of bent vertices, and the means of those of their neighbors
  void read_neighbors(double most, std::vector<double>& own, std::vector<double>& around,
                      const Progress& progress) const
  {
    const Index n = mesh_.number_of_vertices();
    const std::vector<Index> stands_for = nearest_bent(most);
    std::vector<double> sum(n, 0.), number(n, 0.);
    for(Index h : connectivity_.halfedge_of_edge)
    {
      const Index a = stands_for[mesh_.source(h)], b = stands_for[mesh_.target(h)];
      if(a == b || a == null_index || b == null_index)
        continue;
      sum[a] += deficit_[b];
      sum[b] += deficit_[a];
      ++number[a];
      ++number[b];
    }
    for(Index v = 0; v < n; ++v)
    {
      progress(v, n);
      if(number[v] == 0.)
        continue;
      own.push_back(deficit_[v]);
      around.push_back(sum[v] / number[v]);
    }
  }

  /// of each vertex: so that neighbors are the same, however flat parts are divided
  std::vector<Index> nearest_bent(double most) const
  {
    const Index n = mesh_.number_of_vertices();
    std::vector<Index> result(n, null_index), reached;
    reached.reserve(n);
    for(Index v = 0; v < n; ++v)
      if(is_bent(deficit_[v]) && std::fabs(deficit_[v]) <= most)
      {
        result[v] = v;
        reached.push_back(v);
      }
    for(std::size_t i = 0; i < reached.size() && reached.size() < n; ++i)
      for(Index k = connectivity_.ring_begin[reached[i]]; k < connectivity_.ring_begin[reached[i] + std::size_t(1)];
          ++k)
      {
        const Index w = connectivity_.ring_vertex[k];
        if(result[w] != null_index || connectivity_.is_border(w))
          continue;
        result[w] = result[reached[i]];
        reached.push_back(w);
      }
    return result;
  }

  static constexpr double sharp = Path_noise::sharp;
  // A curve of a dozen edges around is as smooth: a twelfth of a full turn counts as the deficit at which corners begin to.
  static constexpr double of_turn = 0.8 * sharp / (geodesic_pi / 6.);
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  static constexpr double of_median = Curve_turns::of_median;
  static constexpr double rounding = 1e-9; // of an angle, at most

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  std::vector<double> deficit_;             // of each vertex, from a full angle; 0 on the border
  double flat_ = 0.;                        // what is no larger
  bool is_flat_ = false;                    // whether all are
  double edge_ = 0.;                        // the mean length of edges if flat vertices were none
  double length_ = 0.;                      // of the surface, in these
  Curve_turns turns_;                       // at vertices of curves that are not straight there
  double smooth_ = 0., spur_of_turns_ = 0.; // the largest deficit or turn that is no corner; what is low beside curves
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_STRENGTH_DEFAULT_BRANCH_STRENGTH_H
