// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_SMALL_SYSTEMS_H
#define CGAL_CUT_LOCI_INTERNAL_SMALL_SYSTEMS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Cut_loci::internal {

// Symmetric systems of five or six equations, for the fits of quadrics. Eigen's dense decompositions do the same, and take
// a user's compiler longer than all else that the paper's method includes.
template <std::size_t n>
using Small_vector = std::array<double, n>;
template <std::size_t n>
using Small_matrix = std::array<Small_vector<n>, n>;

template <std::size_t n>
double dot_product(const Small_vector<n>& a, const Small_vector<n>& b)
{
  double sum = 0.;
  for(std::size_t i = 0; i < n; ++i)
    sum += a[i] * b[i];
  return sum;
}

// sum += factor * v
template <std::size_t n>
void add_multiple(double factor, const Small_vector<n>& v, Small_vector<n>& sum)
{
  for(std::size_t i = 0; i < n; ++i)
    sum[i] += factor * v[i];
}

// sum += factor * v v^T
template <std::size_t n>
void add_square(double factor, const Small_vector<n>& v, Small_matrix<n>& sum)
{
  for(std::size_t i = 0; i < n; ++i)
    add_multiple(factor * v[i], v, sum[i]);
}

template <std::size_t n>
Small_vector<n> product(const Small_matrix<n>& a, const Small_vector<n>& x)
{
  Small_vector<n> result;
  for(std::size_t i = 0; i < n; ++i)
    result[i] = dot_product(a[i], x);
  return result;
}

// A = L L^T, of a symmetric, positive definite matrix
template <std::size_t n>
class Cholesky_factor
{
public:
  explicit Cholesky_factor(const Small_matrix<n>& a) : l_(a)
  {
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j <= i; ++j)
      {
        double sum = a[i][j];
        for(std::size_t k = 0; k < j; ++k)
          sum -= l_[i][k] * l_[j][k];
        if(i == j && !(sum > 0.))
        {
          least_ = 0.;
          return;
        }
        l_[i][j] = i == j ? std::sqrt(sum) : sum / l_[j][j];
        if(i == j)
          least_ = (std::min)(least_, l_[i][i]);
      }
  }

  // The least entry on the diagonal of L, 0 if there is no L. It is the distance of a column of a matrix M from the span
  // of those before it, if A = M^T M.
  double least_diagonal() const { return least_; }

  Small_vector<n> solve(Small_vector<n> b) const
  {
    for(std::size_t i = 0; i < n; ++i)
    {
      for(std::size_t k = 0; k < i; ++k)
        b[i] -= l_[i][k] * b[k];
      b[i] /= l_[i][i];
    }
    for(std::size_t i = n; i-- > 0;)
    {
      for(std::size_t k = i + 1; k < n; ++k)
        b[i] -= l_[k][i] * b[k];
      b[i] /= l_[i][i];
    }
    return b;
  }

private:
  Small_matrix<n> l_; // only below and on the diagonal
  double least_ = std::numeric_limits<double>::infinity();
};

// The pseudo-inverse of a symmetric matrix, by Jacobi's rotations: eigenvalues up to `threshold` times the largest one
// are taken for zero.
template <std::size_t n>
Small_matrix<n> pseudo_inverse(Small_matrix<n> a, double threshold)
{
  Small_matrix<n> axes = {}; // rows: the eigenvectors in the end
  for(std::size_t i = 0; i < n; ++i)
    axes[i][i] = 1.;
  const auto rotate = [&](std::size_t p, std::size_t q)
  {
    const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
    const double t = (theta < 0. ? -1. : 1.) / (std::abs(theta) + std::sqrt(theta * theta + 1.));
    const double c = 1. / std::sqrt(t * t + 1.), s = t * c;
    const auto turn = [c, s](double& x, double& y)
    {
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    };
    for(std::size_t k = 0; k < n; ++k)
      turn(a[k][p], a[k][q]);
    for(std::size_t k = 0; k < n; ++k)
      turn(a[p][k], a[q][k]);
    for(std::size_t k = 0; k < n; ++k)
      turn(axes[p][k], axes[q][k]);
    a[p][q] = a[q][p] = 0.;
  };
  constexpr int most_sweeps = 50; // they converge quadratically: five or six are usual
  for(int sweep = 0; sweep < most_sweeps; ++sweep)
  {
    bool is_diagonal = true;
    for(std::size_t p = 0; p < n; ++p)
      for(std::size_t q = p + 1; q < n; ++q)
        if(std::abs(a[p][q]) > std::numeric_limits<double>::epsilon() * std::sqrt(std::abs(a[p][p] * a[q][q])))
        {
          is_diagonal = false;
          rotate(p, q);
        }
    if(is_diagonal)
      break;
  }
  double largest = 0.;
  for(std::size_t i = 0; i < n; ++i)
    largest = (std::max)(largest, a[i][i]);
  Small_matrix<n> result = {};
  for(std::size_t i = 0; i < n; ++i)
    if(a[i][i] > threshold * largest)
      add_square(1. / a[i][i], axes[i], result);
  return result;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_SMALL_SYSTEMS_H
