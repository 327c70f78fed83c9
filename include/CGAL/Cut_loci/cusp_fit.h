// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_CUSP_FIT_H
#define CGAL_CUT_LOCI_CUSP_FIT_H

#include <CGAL/Cut_loci/Direction_geometry.h>
#include <CGAL/Cut_loci/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/Mesh_connectivity.h>
#include <CGAL/Cut_loci/direction_field.h>
#include <CGAL/Cut_loci/internal/vector_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Cut_loci {

/*!
 * \ingroup PkgSurfaceMeshCutLocusStages
 *
 * finds the end of a branch of the cut locus. This is a conjugate point at which the paths, `x = x(alpha, d)` with the
 * direction `alpha` at the source, the distance `d`, and `x` across the branch, have a cusp: the first and the second
 * derivative by `alpha` are zero.
 *
 * With `alpha` of order 1, `d` is of order 2 and `x` of order 3. All terms up to order 5 are fitted to the vertices
 * around the end of the branch as it has been found: on both sides of it and ahead. Unlike the angle between the paths,
 * which falls with the square root of the way to the end, this function is smooth there. Found by order, not by trial:
 * the terms of order 3 alone leave an error of the order of the radius, and those of order 4 are no help by symmetry.
 */
class Cusp_fit
{
public:
  struct Cusp
  {
    double across = 0.;   ///< of the start, to the left of the path
    double distance = 0.; ///< to the source
    double residual = 0.; ///< of the fit, in mean edge lengths
  };

  Cusp_fit(const Indexed_triangle_mesh& mesh, const Mesh_connectivity& connectivity, const Direction_geometry& geometry,
           const Direction_field& field)
    : mesh_(mesh), connectivity_(connectivity), geometry_(geometry), field_(field)
  {
  }

  /*!
   * @param vertex one near the end
   * @param start a point near the end, at distance `distance` from the source, with paths of about `direction` there
   * @param left the unit vector across the path
   *
   * Nothing, if the fit is not that of a cusp within its data.
   */
  std::optional<Cusp> operator()(Index vertex, const internal::Vector& start, double distance, double direction,
                                 const internal::Vector& left) const
  {
    using internal::operator-;
    // 4 mean edges hold 50 vertices for the 12 unknowns, and a larger radius adds more to the error than it averages.
    constexpr double radius = 4.;
    const double h = geometry_.mean_edge_length;
    std::vector<Index> vertices(1, vertex);
    std::vector<std::array<double, 3>> samples; // across, distance, direction
    for(std::size_t i = 0; i < vertices.size() && vertices.size() < 1000; ++i)
    {
      const Index v = vertices[i];
      if(v == field_.source.vertex || connectivity_.is_border(v))
        return std::nullopt;
      const Direction_field::Vertex& f = field_.vertices[v];
      samples.push_back({{internal::dot(mesh_.points[v] - start, left) / h, (f.distance - distance) / (radius * h),
                          field_.turn(direction, f.direction)}});
      for(Index entry = connectivity_.ring_begin[v]; entry < connectivity_.ring_begin[v + 1]; ++entry)
      {
        const Index w = connectivity_.ring_vertex[entry];
        if(internal::norm(mesh_.points[w] - start) < radius * h &&
           std::find(vertices.begin(), vertices.end(), w) == vertices.end())
          vertices.push_back(w);
      }
    }
    return fit(samples, radius, distance);
  }

private:
  static constexpr int number_of_terms = 12;
  using Row = Eigen::Matrix<double, 1, number_of_terms>;

  // the powers of alpha and d in each term
  static int power(int term, int variable)
  {
    static constexpr int powers[number_of_terms][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {3, 0},
                                                       {4, 0}, {2, 1}, {0, 2}, {5, 0}, {3, 1}, {1, 2}};
    return powers[term][variable];
  }

  // the derivative of all terms, `a` times by alpha and `b` times by d
  static Row derivative(int a, int b, double alpha, double d)
  {
    // by multiplication: std::pow() would take most of the time of a fit
    double alphas[6] = {1.}, ds[3] = {1.};
    for(int i = 1; i < 6; ++i)
      alphas[i] = alphas[i - 1] * alpha;
    for(int i = 1; i < 3; ++i)
      ds[i] = ds[i - 1] * d;
    Row result;
    for(int k = 0; k < number_of_terms; ++k)
    {
      const int p = power(k, 0), q = power(k, 1);
      double value = 1.;
      for(int i = 0; i < a; ++i)
        value *= p - i;
      for(int i = 0; i < b; ++i)
        value *= q - i;
      result[k] = p < a || q < b ? 0. : value * alphas[p - a] * ds[q - b];
    }
    return result;
  }

  std::optional<Cusp> fit(const std::vector<std::array<double, 3>>& samples, double radius, double distance) const
  {
    const Eigen::Index n = static_cast<Eigen::Index>(samples.size());
    if(n < 2 * number_of_terms)
      return std::nullopt;
    Eigen::Matrix<double, Eigen::Dynamic, number_of_terms> m(n, number_of_terms);
    Eigen::VectorXd x(n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      m.row(i) = derivative(0, 0, samples[i][2], samples[i][1]);
      x[i] = samples[i][0];
    }
    const Eigen::Matrix<double, number_of_terms, 1> c = m.colPivHouseholderQr().solve(x);
    const double residual = (m * c - x).norm() / std::sqrt(double(n));
    // Fits to cusps of smooth surfaces have residuals below 0.07; the rest is for noise.
    if(!(residual < 0.15))
      return std::nullopt;

    double alpha = 0., d = 0.;
    bool has_converged = false;
    for(int i = 0; i < 30 && !has_converged; ++i)
    {
      const double f = derivative(1, 0, alpha, d) * c, g = derivative(2, 0, alpha, d) * c;
      const double f_d = derivative(1, 1, alpha, d) * c, g_a = derivative(3, 0, alpha, d) * c,
                   g_d = derivative(2, 1, alpha, d) * c;
      const double determinant = g * g_d - f_d * g_a;
      if(!(std::fabs(determinant) > 1e-12))
        return std::nullopt;
      const double step_a = (f_d * g - f * g_d) / determinant, step_d = (f * g_a - g * g) / determinant;
      alpha += step_a;
      d += step_d;
      has_converged = std::fabs(step_a) + std::fabs(step_d) < 1e-9;
      if(!(std::fabs(alpha) < 3.) || !(std::fabs(d) < 3.))
        return std::nullopt;
    }
    // A cut locus begins where the paths converge before the cusp, and those aside do so later. Beyond the data, the
    // fit says nothing.
    const double across = derivative(0, 0, alpha, d) * c;
    if(!has_converged || !(derivative(1, 1, alpha, d) * c < 0.) || !(derivative(3, 0, alpha, d) * c > 0.) ||
       !(std::fabs(d) <= 0.75) || !(std::fabs(across) <= 0.5 * radius))
      return std::nullopt;
    const double h = geometry_.mean_edge_length;
    return Cusp{across * h, distance + d * radius * h, residual};
  }

  const Indexed_triangle_mesh& mesh_;
  const Mesh_connectivity& connectivity_;
  const Direction_geometry& geometry_;
  const Direction_field& field_;
};

} // namespace Cut_loci
} // namespace CGAL

#endif // CGAL_CUT_LOCI_CUSP_FIT_H
