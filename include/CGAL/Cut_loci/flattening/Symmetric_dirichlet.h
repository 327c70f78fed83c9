// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_SYMMETRIC_DIRICHLET_H
#define CGAL_CUT_LOCI_FLATTENING_SYMMETRIC_DIRICHLET_H

#include <CGAL/Cut_loci/Index.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

using Planar_point = std::array<double, 2>;
using Planar_points = std::vector<Planar_point>;
using Planar_triangle = std::array<Planar_point, 3>;
using Triangle_corners = std::array<Index, 3>;

inline double twice_signed_area(const Planar_point& p, const Planar_point& q, const Planar_point& r)
{
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// The symmetric Dirichlet energy of a map from triangles in the plane, their rest shapes, to others
// [Smith and Schaefer, 2015]: the integral of s^2 + t^2 + 1 / s^2 + 1 / t^2, for the singular values s and t of the
// Jacobian. It is least, four times the area, for isometries, and infinite if a face is flipped or has no area.
class Symmetric_dirichlet
{
public:
  using Gradient = Eigen::Matrix<double, 6, 1>; // by the coordinates of the three corners
  using Hessian = Eigen::Matrix<double, 6, 6>;

  void add_face(const Triangle_corners& corners, const Planar_triangle& rest, double weight = 1.)
  {
    const double twice_area = twice_signed_area(rest[0], rest[1], rest[2]);
    Face face;
    face.area = weight * 0.5 * twice_area;
    for(int i = 0; i < 3; ++i) // of the function that is one at corner i and zero at the others
    {
      const Planar_point &q = rest[(i + 1) % 3], &r = rest[(i + 2) % 3];
      face.gradients.col(i) << (q[1] - r[1]) / twice_area, (r[0] - q[0]) / twice_area;
    }
    faces_.push_back(face);
    corners_.push_back(corners);
    area_ += face.area;
  }

  void remove_faces_from(std::size_t first)
  {
    corners_.resize(first);
    faces_.erase(faces_.begin() + first, faces_.end());
    area_ = 0.;
    for(const Face& face : faces_)
      area_ += face.area;
  }

  std::size_t number_of_faces() const { return faces_.size(); }
  const std::vector<Triangle_corners>& corners() const { return corners_; }
  double area() const { return area_; }

  // Infinite unless all faces have a positive area in the plane.
  double energy(const Planar_points& plane) const
  {
    double sum = 0.;
    for(std::size_t f = 0; f < faces_.size(); ++f)
    {
      const Eigen::Matrix2d jacobian = jacobian_of(f, plane);
      const double determinant = jacobian.determinant();
      if(!(determinant > 0.))
        return std::numeric_limits<double>::infinity();
      sum += faces_[f].area * jacobian.squaredNorm() * (1. + 1. / (determinant * determinant));
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  // The part of a face, with the nearest Hessian that is positive semidefinite, from the closed forms of its
  // eigenvectors [Smith, de Goes, Kim, 2019]: both stretches, the rotation and the reflected shear.
  void derivatives(std::size_t f, const Planar_points& plane, Gradient& gradient, Hessian& hessian) const
  {
    const Face& face = faces_[f];
    const Singular_values svd(jacobian_of(f, plane));
    const double s = svd.large, t = svd.small;
    const double ds = 2. * (s - 1. / (s * s * s)), dt = 2. * (t - 1. / (t * t * t));
    // (ds - dt) / (s - t) without the cancellation
    const double shear = 2. * (1. + (s * s + s * t + t * t) / (s * s * s * t * t * t));
    const double twist = (std::max)(0., (ds + dt) / (s + t));

    Eigen::Matrix<double, 4, 4> modes; // columns: of the Jacobian, by columns
    const Eigen::Vector2d &a = svd.left[0], &b = svd.left[1], &c = svd.right[0], &d = svd.right[1];
    const auto set = [&](int k, const Eigen::Matrix2d& m) { modes.col(k) << m(0, 0), m(1, 0), m(0, 1), m(1, 1); };
    set(0, a * c.transpose());
    set(1, b * d.transpose());
    set(2, (b * c.transpose() - a * d.transpose()) * std::sqrt(0.5));
    set(3, (b * c.transpose() + a * d.transpose()) * std::sqrt(0.5));
    const double eigenvalues[4] = {2. + 6. / (s * s * s * s), 2. + 6. / (t * t * t * t), twist, shear};

    Eigen::Matrix<double, 6, 4> by_corners; // the modes as seen by the coordinates of the corners
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 4; ++k)
      {
        by_corners(2 * i, k) = modes(0, k) * face.gradients(0, i) + modes(2, k) * face.gradients(1, i);
        by_corners(2 * i + 1, k) = modes(1, k) * face.gradients(0, i) + modes(3, k) * face.gradients(1, i);
      }
    gradient = face.area * (ds * by_corners.col(0) + dt * by_corners.col(1));
    hessian.setZero();
    for(int k = 0; k < 4; ++k)
      hessian.noalias() += (face.area * eigenvalues[k]) * by_corners.col(k) * by_corners.col(k).transpose();
  }

  // The largest step along `direction`, up to `limit`, before the first face has no area.
  double largest_step(const Planar_points& plane, const Planar_points& direction, double limit) const
  {
    for(const Triangle_corners& corners : corners_)
    {
      const auto edge = [&](const Planar_points& of, int i) {
        return Planar_point{{of[corners[i]][0] - of[corners[0]][0], of[corners[i]][1] - of[corners[0]][1]}};
      };
      const auto cross = [](const Planar_point& p, const Planar_point& q) { return p[0] * q[1] - p[1] * q[0]; };
      const Planar_point p = edge(plane, 1), q = edge(plane, 2), u = edge(direction, 1), v = edge(direction, 2);
      // the area after a step x is a x^2 + 2 b x + c, with c > 0
      const double a = cross(u, v), b = 0.5 * (cross(p, v) + cross(u, q)), c = cross(p, q);
      const double discriminant = b * b - a * c;
      if(discriminant < 0.)
        continue;
      const double root = std::sqrt(discriminant);
      // the first positive root, by the one of the two forms that does not cancel
      const double x = b <= 0. ? c / (root - b) : a < 0. ? (b + root) / -a : -1.;
      if(x > 0. && x < limit)
        limit = x;
    }
    return limit;
  }

private:
  struct Face
  {
    double area;                           // of the rest shape, times its weight
    Eigen::Matrix<double, 2, 3> gradients; // columns: of the hat functions of the corners
  };

  struct Singular_values
  {
    // for a positive determinant
    explicit Singular_values(const Eigen::Matrix2d& m)
    {
      // a rotation and a reflection: m = R(p) e + S(q) h, where e and h are half the sum and the difference of the values
      const double x = 0.5 * (m(0, 0) + m(1, 1)), y = 0.5 * (m(1, 0) - m(0, 1));
      const double u = 0.5 * (m(0, 0) - m(1, 1)), v = 0.5 * (m(1, 0) + m(0, 1));
      const double sum = std::hypot(x, y), difference = std::hypot(u, v);
      const double rotation = std::atan2(y, x), reflection = difference > 0. ? std::atan2(v, u) : 0.;
      large = sum + difference;
      small = m.determinant() / large; // without the cancellation
      const double l = 0.5 * (reflection + rotation), r = 0.5 * (reflection - rotation);
      left = {{Eigen::Vector2d(std::cos(l), std::sin(l)), Eigen::Vector2d(-std::sin(l), std::cos(l))}};
      right = {{Eigen::Vector2d(std::cos(r), std::sin(r)), Eigen::Vector2d(-std::sin(r), std::cos(r))}};
    }

    double large, small;
    std::array<Eigen::Vector2d, 2> left, right; // columns of the factors
  };

  Eigen::Matrix2d jacobian_of(std::size_t f, const Planar_points& plane) const
  {
    const Planar_point &p = plane[corners_[f][0]], &q = plane[corners_[f][1]], &r = plane[corners_[f][2]];
    // by edges, not by points: the gradients of the hat functions add up to zero
    Eigen::Matrix2d edges;
    edges << q[0] - p[0], r[0] - p[0], q[1] - p[1], r[1] - p[1];
    return edges * faces_[f].gradients.rightCols<2>().transpose();
  }

  std::vector<Face> faces_;
  std::vector<Triangle_corners> corners_;
  double area_ = 0.;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_SYMMETRIC_DIRICHLET_H
