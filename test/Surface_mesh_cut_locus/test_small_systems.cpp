// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// Systems of a few equations: the residual of regular ones, and Penrose's conditions for singular ones.

#include <CGAL/Cut_loci/internal/small_systems.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace test_small_systems {
namespace {

using namespace CGAL::Cut_loci::internal;

// the sum of the squares of `rank` random vectors
Small_matrix<5> random_matrix(int rank, unsigned seed)
{
  std::mt19937 random(seed);
  Small_matrix<5> result = {};
  for(int i = 0; i < rank; ++i)
  {
    Small_vector<5> v;
    for(double& x : v)
      x = 2. * random() / 4294967295. - 1.;
    add_square(1., v, result);
  }
  return result;
}

Small_matrix<5> product(const Small_matrix<5>& a, const Small_matrix<5>& b)
{
  Small_matrix<5> result = {};
  for(std::size_t i = 0; i < 5; ++i)
    for(std::size_t k = 0; k < 5; ++k)
      add_multiple(a[i][k], b[k], result[i]);
  return result;
}

double difference(const Small_matrix<5>& a, const Small_matrix<5>& b)
{
  double result = 0.;
  for(std::size_t i = 0; i < 5; ++i)
    for(std::size_t j = 0; j < 5; ++j)
      result = (std::max)(result, std::abs(a[i][j] - b[i][j]));
  return result;
}

TEST(Small_systems, cholesky_solves_regular_ones)
{
  for(unsigned seed = 1; seed <= 50; ++seed)
  {
    const Small_matrix<5> a = random_matrix(12, seed);
    const Cholesky_factor<5> factor(a);
    ASSERT_GT(factor.least_diagonal(), 1e-3);
    const Small_vector<5> b = {{1., -2., 3., -4., 5.}};
    const Small_vector<5> r = CGAL::Cut_loci::internal::product(a, factor.solve(b));
    for(std::size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(r[i], b[i], 1e-10);
  }
}

TEST(Small_systems, cholesky_tells_singular_ones)
{
  for(int rank = 0; rank < 5; ++rank)
    EXPECT_LT(Cholesky_factor<5>(random_matrix(rank, 7)).least_diagonal(), 1e-6) << rank;
}

TEST(Small_systems, pseudo_inverse_satisfies_penroses_conditions_at_any_rank)
{
  for(int rank = 0; rank <= 8; ++rank)
    for(unsigned seed = 1; seed <= 20; ++seed)
    {
      const Small_matrix<5> a = random_matrix(rank, seed), p = pseudo_inverse(a, 1e-8);
      const Small_matrix<5> ap = product(a, p), pa = product(p, a);
      double size = 1.;
      for(const Small_vector<5>& row : p)
        for(double x : row)
          size = (std::max)(size, std::abs(x));
      EXPECT_LT(difference(product(ap, a), a), 1e-13 * size) << rank << ", " << seed;
      EXPECT_LT(difference(product(pa, p), p), 1e-13 * size * size) << rank << ", " << seed;
      EXPECT_LT(difference(ap, pa), 1e-13 * size) << rank << ", " << seed; // symmetric, as a and p are
    }
}

} // namespace
} // namespace test_small_systems
