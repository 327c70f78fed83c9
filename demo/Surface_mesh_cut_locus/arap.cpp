// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "arap.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <complex>

namespace {

using Complex = std::complex<double>;

// The corners of a face in its own plane, and the cotangent of the angle opposite to each edge.
struct Flat_face
{
  std::array<Complex, 3> corners;
  std::array<double, 3> cotangents; // of edge i, from corner i to the next
};

Flat_face flat(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c)
{
  const Eigen::Map<const Eigen::Vector3d> p(a.data()), q(b.data()), r(c.data());
  const Eigen::Vector3d u = q - p, v = r - p;
  const double length = u.norm(), x = u.dot(v) / length, height = u.cross(v).norm() / length;
  Flat_face result = {{{Complex(0., 0.), Complex(length, 0.), Complex(x, height)}}, {}};
  for(int i = 0; i < 3; ++i)
  {
    const Complex s = result.corners[i] - result.corners[(i + 2) % 3],
                  t = result.corners[(i + 1) % 3] - result.corners[(i + 2) % 3];
    const Complex product = std::conj(s) * t;
    result.cotangents[i] = product.real() / product.imag();
  }
  return result;
}

} // namespace

bool flatten_as_rigidly_as_possible(const Points_3& points, const Triangles& triangles, Points_2& plane,
                                    double tolerance)
{
  constexpr int max_iterations = 500;

  std::vector<Flat_face> rest;
  std::vector<Eigen::Triplet<double>> entries;
  rest.reserve(triangles.size());
  entries.reserve(12 * triangles.size() + 1);
  double area = 0., area_in_plane = 0.;
  const auto at = [&](std::size_t v) { return Complex(plane[v][0], plane[v][1]); };
  for(const auto& f : triangles)
  {
    rest.push_back(flat(points[f[0]], points[f[1]], points[f[2]]));
    area += std::abs((std::conj(rest.back().corners[1]) * rest.back().corners[2]).imag());
    area_in_plane += (std::conj(at(f[1]) - at(f[0])) * (at(f[2]) - at(f[0]))).imag();
    for(int i = 0; i < 3; ++i)
    {
      const int v = static_cast<int>(f[i]), w = static_cast<int>(f[(i + 1) % 3]);
      const double cotangent = rest.back().cotangents[i];
      if(!std::isfinite(cotangent))
        return false;
      entries.emplace_back(v, v, cotangent);
      entries.emplace_back(w, w, cotangent);
      entries.emplace_back(v, w, -cotangent);
      entries.emplace_back(w, v, -cotangent);
    }
  }
  entries.emplace_back(0, 0, 1.); // one vertex is held
  const int n = static_cast<int>(points.size());
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Eigen::Triplet<double>>().swap(entries);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if(solver.info() != Eigen::Success || !(std::abs(area_in_plane) > 0.))
    return false;

  // of the same area, and the same way around as the faces
  const double scale = std::sqrt(area / std::abs(area_in_plane));
  for(auto& p : plane)
    p = {{scale * p[0], area_in_plane < 0. ? -scale * p[1] : scale * p[1]}};

  Eigen::MatrixX2d right(n, 2);
  double last_energy = 0.;
  for(int iteration = 0; iteration < max_iterations; ++iteration)
  {
    right.setZero();
    right.row(0) << plane[0][0], plane[0][1];
    double energy = 0.;
    for(std::size_t k = 0; k < triangles.size(); ++k)
    {
      const Flat_face& face = rest[k];
      Complex sum(0., 0.);
      for(int i = 0; i < 3; ++i)
        sum += face.cotangents[i] * (at(triangles[k][(i + 1) % 3]) - at(triangles[k][i])) *
               std::conj(face.corners[(i + 1) % 3] - face.corners[i]);
      const Complex rotation = std::abs(sum) > 0. ? sum / std::abs(sum) : Complex(1., 0.);
      for(int i = 0; i < 3; ++i)
      {
        const std::size_t v = triangles[k][i], w = triangles[k][(i + 1) % 3];
        const Complex edge = rotation * (face.corners[(i + 1) % 3] - face.corners[i]);
        energy += face.cotangents[i] * std::norm(at(w) - at(v) - edge);
        const Complex part = face.cotangents[i] * edge;
        right(static_cast<int>(v), 0) -= part.real();
        right(static_cast<int>(v), 1) -= part.imag();
        right(static_cast<int>(w), 0) += part.real();
        right(static_cast<int>(w), 1) += part.imag();
      }
    }
    if(iteration > 0 && std::abs(last_energy - energy) <= tolerance * std::abs(energy))
      return true;
    last_energy = energy;
    const Eigen::MatrixX2d solution = solver.solve(right);
    if(!solution.allFinite())
      return false;
    for(int v = 0; v < n; ++v)
      plane[v] = {{solution(v, 0), solution(v, 1)}};
  }
  return true;
}
