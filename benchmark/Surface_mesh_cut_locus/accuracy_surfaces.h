// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_ACCURACY_SURFACES_H
#define CGAL_CUT_LOCI_BENCHMARK_ACCURACY_SURFACES_H

#include "analytic_surfaces.h"

#include <array>
#include <cmath>

namespace analytic {

// r = 1 + epsilon Y, where Y is the spherical harmonic (x^3 - 3 x y^2) (8 z^2 - x^2 - y^2) of degree 5 and order 3
struct Bumpy_sphere
{
  double epsilon = 0.06;

  double radius(const Vector& p) const
  {
    const double r = std::sqrt(p.squared_length());
    return 1. + epsilon * harmonic(p / r);
  }

  double value(const Vector& p) const { return std::sqrt(p.squared_length()) - radius(p); }

  Vector gradient(const Vector& p) const
  {
    const double r = std::sqrt(p.squared_length()), s = harmonic(p), r5 = std::pow(r, -5.), r7 = r5 / (r * r);
    return p / r - epsilon * (r5 * harmonic_gradient(p) - 5. * s * r7 * p);
  }

  std::array<Vector, 3> hessian(const Vector& p) const
  {
    const double r = std::sqrt(p.squared_length()), s = harmonic(p), r5 = std::pow(r, -5.), r7 = r5 / (r * r),
                 r9 = r7 / (r * r);
    const Vector g = harmonic_gradient(p);
    const std::array<Vector, 3> h = harmonic_hessian(p);
    std::array<Vector, 3> result;
    for(int i = 0; i < 3; ++i)
    {
      const Vector e(i == 0, i == 1, i == 2);
      const Vector bump = r5 * h[i] - 5. * r7 * (g[i] * p + p[i] * g) + 35. * s * r9 * p[i] * p - 5. * s * r7 * e;
      result[i] = e / r - p[i] / (r * r * r) * p - epsilon * bump;
    }
    return result;
  }

  Point project(const Point& p) const
  {
    const Vector q = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + radius(q) / std::sqrt(q.squared_length()) * q;
  }

  Vector normal(const Point& p) const
  {
    const Vector g = gradient(p - CGAL::ORIGIN);
    return g / std::sqrt(g.squared_length());
  }

  Mesh grid(double length) const
  {
    Mesh mesh = Ellipsoid{1., 1., 1.}.grid(length);
    for(Mesh::Vertex_index v : mesh.vertices())
      mesh.point(v) = project(mesh.point(v));
    return mesh;
  }

private:
  static double first(const Vector& p) { return p.x() * (p.x() * p.x() - 3. * p.y() * p.y()); }
  static double second(const Vector& p) { return 8. * p.z() * p.z() - p.x() * p.x() - p.y() * p.y(); }
  static Vector first_gradient(const Vector& p)
  {
    return Vector(3. * (p.x() * p.x() - p.y() * p.y()), -6. * p.x() * p.y(), 0.);
  }
  static Vector second_gradient(const Vector& p) { return Vector(-2. * p.x(), -2. * p.y(), 16. * p.z()); }

  static double harmonic(const Vector& p) { return first(p) * second(p); }
  static Vector harmonic_gradient(const Vector& p)
  {
    return second(p) * first_gradient(p) + first(p) * second_gradient(p);
  }
  static std::array<Vector, 3> harmonic_hessian(const Vector& p)
  {
    const double a = first(p), b = second(p);
    const Vector ga = first_gradient(p), gb = second_gradient(p);
    std::array<Vector, 3> h = {{Vector(6. * p.x() * b - 2. * a, -6. * p.y() * b, 0.),
                                Vector(-6. * p.y() * b, -6. * p.x() * b - 2. * a, 0.), Vector(0., 0., 16. * a)}};
    for(int i = 0; i < 3; ++i)
      h[i] = h[i] + ga[i] * gb + gb[i] * ga;
    return h;
  }
};

// The point of an ellipsoid with a > b > c that lies `distance` along y beside an umbilic point, where both curvatures
// are equal and the cut locus is a single point.
inline Point near_umbilic(const Ellipsoid& e, double distance)
{
  const double x = e.a * std::sqrt((e.a * e.a - e.b * e.b) / (e.a * e.a - e.c * e.c));
  const double z = e.c * std::sqrt((e.b * e.b - e.c * e.c) / (e.a * e.a - e.c * e.c));
  return e.project(Point(x, distance, z));
}

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_ACCURACY_SURFACES_H
