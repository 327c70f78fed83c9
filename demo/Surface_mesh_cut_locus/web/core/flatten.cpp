// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "flatten.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace {

constexpr int most_iterations = 100;
constexpr double least_progress = 1e-3; // of the energy, in one iteration: what comes after it is not seen

// Weights below zero, of obtuse angles, would make the energy unbounded where triangles flip.
constexpr double least_weight = 1e-2;

// A triangle laid out flat, and the cotangent of the angle opposite of each edge. Edge i goes from corner i to i + 1.
struct Flat_triangle
{
  std::array<double, 2> edge[3];
  double weight[3];

  Flat_triangle(const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<double, 3>& r)
  {
    double uu = 0., uv = 0., vv = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const double u = q[k] - p[k], v = r[k] - p[k];
      uu += u * u;
      uv += u * v;
      vv += v * v;
    }
    const double length = std::sqrt(uu), x = uv / length, y = std::sqrt((std::max)(0., vv - x * x));
    const double corner[3][2] = {{0., 0.}, {length, 0.}, {x, y}};
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 2; ++k)
        edge[i][k] = corner[(i + 1) % 3][k] - corner[i][k];
    for(int i = 0; i < 3; ++i)
    {
      const auto &a = edge[(i + 1) % 3], &b = edge[(i + 2) % 3];
      weight[i] = (std::max)(-(a[0] * b[0] + a[1] * b[1]) / (length * y), least_weight);
    }
  }
};

} // namespace

bool flatten_as_rigidly_as_possible(const Points_3& points, const Triangles& triangles, Points_2& plane)
{
  const int n = static_cast<int>(points.size());
  std::vector<Flat_triangle> flat;
  std::vector<Eigen::Triplet<double>> entries;
  flat.reserve(triangles.size());
  entries.reserve(12 * triangles.size() + 1);
  for(const auto& t : triangles)
  {
    flat.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
    for(int i = 0; i < 3; ++i)
    {
      const int v = t[i], w = t[(i + 1) % 3];
      const double weight = flat.back().weight[i];
      if(!std::isfinite(weight))
        return false;
      entries.emplace_back(v, v, weight);
      entries.emplace_back(w, w, weight);
      entries.emplace_back(v, w, -weight);
      entries.emplace_back(w, v, -weight);
    }
  }
  entries.emplace_back(0, 0, 1.); // the right hand sides sum up to zero: this puts vertex 0 at the origin, no more
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Eigen::Triplet<double>>().swap(entries);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if(solver.info() != Eigen::Success)
    return false;

  Eigen::MatrixX2d right(n, 2);
  double last_energy = -1.;
  for(int iteration = 0; iteration < most_iterations; ++iteration)
  {
    right.setZero();
    double energy = 0.;
    for(std::size_t f = 0; f < triangles.size(); ++f)
    {
      const Flat_triangle& triangle = flat[f];
      // the rotation (c, s) that turns the triangle best to its image
      double c = 0., s = 0.;
      for(int i = 0; i < 3; ++i)
      {
        const auto &p = plane[triangles[f][i]], &q = plane[triangles[f][(i + 1) % 3]];
        const double x = q[0] - p[0], y = q[1] - p[1];
        const auto& e = triangle.edge[i];
        c += triangle.weight[i] * (e[0] * x + e[1] * y);
        s += triangle.weight[i] * (e[0] * y - e[1] * x);
      }
      const double norm = std::hypot(c, s);
      c = norm > 0. ? c / norm : 1.;
      s = norm > 0. ? s / norm : 0.;
      for(int i = 0; i < 3; ++i)
      {
        const std::uint32_t v = triangles[f][i], w = triangles[f][(i + 1) % 3];
        const auto& e = triangle.edge[i];
        const double x = c * e[0] - s * e[1], y = s * e[0] + c * e[1], weight = triangle.weight[i];
        const double dx = plane[w][0] - plane[v][0] - x, dy = plane[w][1] - plane[v][1] - y;
        energy += weight * (dx * dx + dy * dy);
        right(v, 0) -= weight * x;
        right(v, 1) -= weight * y;
        right(w, 0) += weight * x;
        right(w, 1) += weight * y;
      }
    }
    if(last_energy >= 0. && last_energy - energy < least_progress * last_energy)
      return true;
    last_energy = energy;
    const Eigen::MatrixX2d solution = solver.solve(right);
    for(int v = 0; v < n; ++v)
    {
      if(!std::isfinite(solution(v, 0)) || !std::isfinite(solution(v, 1)))
        return false;
      plane[v] = {{solution(v, 0), solution(v, 1)}};
    }
  }
  return true;
}
