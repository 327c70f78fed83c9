// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PERTURBED_SURFACE_H
#define CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PERTURBED_SURFACE_H

#include <CGAL/Cut_loci/geodesics/Exact_geodesic_propagation.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/mollified_lengths.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Cut_loci::internal {

/*!
 * is a surface with other lengths, by a little, so that no two paths are equally long by symmetry: what rounding has left
 * open is decided.
 *
 * The lengths are those of a discrete conformal map, l_ij exp(s (u_i + u_j)) \cgalCite{cgal:ssp-cetm-08}, under which angles
 * change by the cotangent Laplacian of u, to first order. With (L + |K|) u = |K| r the curvature K_i of a vertex changes by
 * s |K_i| (r_i - u_i): what is flat stays flat, however slim its faces are, and no vertex turns from convex to concave. A
 * straight border stays straight, where K_i is the angle by which it turns.
 *
 * What is wanted, r, depends on nothing but the surface as the source sees it: the distance of a vertex, and the
 * directions of the path to it. So sources that a rotation takes to each other have the same cut locus but for it.
 */
class Perturbed_surface
{
public:
  /// \pre `geodesics` has run on `mesh`, with directions
  /// @param number another one gives other lengths
  Perturbed_surface(const Indexed_triangle_mesh& mesh, const Geodesic_results& geodesics, int number)
    : mesh_(mesh), faces_(geodesics.faces())
  {
    const Eigen::VectorXd u = factors(wanted(geodesics, number));
    // By this share of distances the curve moves: far less than the accuracy of any mesh. Ties are broken by about as much,
    // which is forty times what counts as rounding of angles: by chance, hardly any of them stays below that.
    const double share = 4e-6 * std::pow(1.5, number - 1);
    mesh_.lengths.resize(mesh.number_of_halfedges());
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      mesh_.lengths[h] = faces_.length(h) * std::exp(share * (u[mesh.source(h)] + u[mesh.target(h)]));
    if(needs_mollification(mesh_))
      mesh_.lengths = Mollification(mesh_).lengths;
    change_ = 2. * share * u.lpNorm<Eigen::Infinity>();
    geodesics_.reset(new Exact_geodesic_propagation(mesh_));
  }

  const Indexed_triangle_mesh& mesh() const { return mesh_; }
  Exact_geodesic_propagation& geodesics() const { return *geodesics_; }
  /// the share by which lengths differ from those of the surface, at most
  double change() const { return change_; }

private:
  static constexpr double full_turn = 2. * geodesic_pi;

  double curvature(Index v) const { return (faces_.is_border(v) ? geodesic_pi : full_turn) - faces_.total_angle(v); }

  /// of each vertex, between -1 and 1
  Eigen::VectorXd wanted(const Geodesic_results& geodesics, int number) const
  {
    const std::vector<double> zero = directions_of_sources(geodesics);
    const double mean = mean_distance(geodesics);
    Eigen::VectorXd result(faces_.number_of_vertices());
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
    {
      // planes of symmetry are at angles that are parts of pi, of which no whole number is a multiple
      double phase = number + geodesics.distance(v) / mean;
      Index origin = geodesics.origin_of_vertex(v);
      for(double factor = 1.; geodesics.distance(v) > 0. && !geodesics.is_source(origin); factor += 1.)
      {
        const double direction = geodesics.step_back(origin);
        const bool is_first = geodesics.is_source(origin);
        phase += factor * (is_first ? direction * geodesics.angle_scale(origin) - zero[origin] : direction) +
                 (is_first ? origin : 0.);
      }
      result[v] = std::cos(phase);
    }
    return result;
  }

  static double mean_distance(const Geodesic_results& geodesics)
  {
    double sum = 0.;
    for(double d : geodesics.distances())
      sum += d;
    return sum / static_cast<double>(geodesics.distances().size());
  }

  /// from which directions are counted, of each source: that of the first moment that is not zero of the curvature of the
  /// vertices as the source sees it, one of k if that is the k-th. Left out are vertices to which several shortest paths
  /// lead, and those behind them.
  std::vector<double> directions_of_sources(const Geodesic_results& geodesics) const
  {
    constexpr std::size_t number_of_moments = 8;
    using Moments = std::array<std::complex<double>, number_of_moments>;
    std::vector<Moments> moments(geodesics.number_of_sources(), Moments{});
    std::vector<double> size(geodesics.number_of_sources(), 0.), result(geodesics.number_of_sources(), 0.);
    const double mean = mean_distance(geodesics);
    std::vector<Index> order(faces_.number_of_vertices());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return geodesics.distance(a) < geodesics.distance(b); });
    std::vector<unsigned char> is_unclear(faces_.number_of_vertices(), 0);
    for(Index v : order)
    {
      if(!(geodesics.distance(v) > 0.))
        continue;
      const Geodesic_arrival& arrival = geodesics.arrival(v);
      is_unclear[v] = geodesics.has_several_paths(v) ||
                      (!geodesics.is_source(arrival.origin) && is_unclear[geodesics.vertex_of_origin(arrival.origin)]);
      const Index i = geodesics.source_of(arrival);
      if(is_unclear[v])
        continue;
      const double weight = curvature(v) * mean / (geodesics.distance(v) + mean);
      const double angle = geodesics.direction_at_source(v) * geodesics.angle_scale(i);
      for(std::size_t k = 0; k < number_of_moments; ++k)
        moments[i][k] += std::polar(1., static_cast<double>(k + 1) * angle) * weight;
      size[i] += std::fabs(weight);
    }
    for(std::size_t i = 0; i < result.size(); ++i)
      for(std::size_t k = number_of_moments; k-- > 0;)
        if(std::abs(moments[i][k]) > 1e-6 * size[i])
          result[i] = std::arg(moments[i][k]) / static_cast<double>(k + 1);
    return result;
  }

  /// u, given r
  Eigen::VectorXd factors(const Eigen::VectorXd& wanted) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(wanted.size());
    for(Index v = 0; v < faces_.number_of_vertices(); ++v)
    {
      // what all of a flat surface is multiplied by does not matter
      const double weight = std::fabs(curvature(v)) + 1e-12;
      entries.emplace_back(v, v, weight);
      right[v] = weight * wanted[v];
    }
    for(Index h = 0; h < faces_.number_of_halfedges(); ++h)
    {
      const Index previous = Indexed_triangle_mesh::previous(h), a = faces_.source(h), b = faces_.target(h);
      const Geodesic_face::Corner& corner = faces_.face_of(h).corner[previous % 3];
      const double cotangent = corner.cosine / corner.sine;
      for(Index v : {a, b})
        entries.emplace_back(v, v, cotangent);
      entries.emplace_back(a, b, -cotangent);
      entries.emplace_back(b, a, -cotangent);
    }
    Eigen::SparseMatrix<double> matrix(wanted.size(), wanted.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  }

  Indexed_triangle_mesh mesh_;
  const Geodesic_faces& faces_; // of the surface as it is
  std::unique_ptr<Exact_geodesic_propagation> geodesics_;
  double change_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_POLYHEDRAL_SOURCES_PERTURBED_SURFACE_H
