// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_TRIANGLE_SYSTEM_H
#define CGAL_CUT_LOCI_FLATTENING_TRIANGLE_SYSTEM_H

#include <CGAL/Cut_loci/Index.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A symmetric positive definite system with `dimension` unknowns for each vertex, summed up from matrices of triangles,
// and its Cholesky factors. Vertices may be held: these have none.
//
// The order of elimination is found for vertices, not for unknowns, in a fraction of the time.
template <int dimension>
class Triangle_system
{
public:
  using Block = Eigen::Matrix<double, 3 * dimension, 3 * dimension>;

  Triangle_system(std::vector<std::array<Index, 3>> triangles, const std::vector<bool>& is_held)
    : triangles_(std::move(triangles)), blocks_(triangles_.size()), position_(is_held.size(), -1)
  {
    for(std::size_t v = 0; v < is_held.size(); ++v)
      if(!is_held[v])
        position_[v] = number_++;
    order_vertices();
  }

  // the first unknown of a vertex, or -1 if it is held
  int unknown(Index v) const { return position_[v] < 0 ? -1 : dimension * position_[v]; }
  int number_of_unknowns() const { return dimension * number_; }

  Block& block(std::size_t face) { return blocks_[face]; }

  // Entries of the diagonal are taken `1 + damping` times. Returns whether the matrix is positive definite.
  bool factor(double damping = 0.)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(triangles_.size() * Block::SizeAtCompileTime / 2);
    for(std::size_t f = 0; f < triangles_.size(); ++f)
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          add_entries(unknown(triangles_[f][i]), unknown(triangles_[f][j]),
                      blocks_[f].template block<dimension, dimension>(dimension * i, dimension * j), damping, entries);
    Matrix matrix(number_of_unknowns(), number_of_unknowns());
    matrix.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(matrix);
    return factors_.info() == Eigen::Success;
  }

  // One column for each right-hand side.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& x) const { return factors_.solve(x); }

private:
  using Matrix = Eigen::SparseMatrix<double>;

  void order_vertices()
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(const auto& t : triangles_)
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          if(position_[t[i]] >= 0 && position_[t[j]] >= 0)
            entries.emplace_back(position_[t[i]], position_[t[j]], 1.);
    Matrix neighbors(number_, number_);
    neighbors.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(neighbors, order);
    std::vector<int> place(number_);
    for(int k = 0; k < number_; ++k)
      place[order.indices()[k]] = k;
    for(int& position : position_)
      position = position < 0 ? -1 : place[position];
  }

  // those of the lower triangle
  template <typename Part>
  static void add_entries(int row, int column, const Part& part, double damping,
                          std::vector<Eigen::Triplet<double>>& entries)
  {
    if(column < 0 || row < column)
      return;
    for(int a = 0; a < dimension; ++a)
      for(int b = 0; b < dimension; ++b)
        if(row + a >= column + b)
          entries.emplace_back(row + a, column + b, (row + a == column + b ? 1. + damping : 1.) * part(a, b));
  }

  const std::vector<std::array<Index, 3>> triangles_;
  std::vector<Block> blocks_;
  std::vector<int> position_; // in the order of the elimination, or -1
  int number_ = 0;            // of vertices that are not held
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factors_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_TRIANGLE_SYSTEM_H
