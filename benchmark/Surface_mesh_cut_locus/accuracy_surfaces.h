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
#include <vector>

namespace analytic {

// A surface that each ray from the origin meets once, from what `Derived` says of its equation.
template <typename Derived>
struct Star_shaped
{
  double value(const Vector& p) const { return self().value(p); }

  Point project(const Point& p) const
  {
    const Vector q = p - CGAL::ORIGIN;
    double low = 0., high = 1.;
    while(value(high * q) < 0.)
      high *= 2.;
    for(int i = 0; i < 60 && low < high; ++i)
    {
      const double middle = 0.5 * (low + high);
      (value(middle * q) < 0. ? low : high) = middle;
    }
    return CGAL::ORIGIN + high * q;
  }

  Vector normal(const Point& p) const
  {
    const Vector g = self().gradient(p - CGAL::ORIGIN);
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
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

// Where a sum of exponentials of e + s p - k |p - c|^2 is 1: with k = 0 a polyhedron with rounded edges, with s = 0 balls that
// melt into one another; the sum grows outward (sign 1) or inward (sign -1).
struct Sum_of_exponentials : Star_shaped<Sum_of_exponentials>
{
  struct Term
  {
    double e;
    Vector s;
    double k;
    Vector c;

    double operator()(const Vector& p) const { return std::exp(e + s * p - k * (p - c).squared_length()); }
    Vector slope(const Vector& p) const { return s - 2. * k * (p - c); }
  };

  double sign;
  std::vector<Term> terms;

  Sum_of_exponentials(double sign, const std::vector<Term>& terms) : sign(sign), terms(terms) {}

  double value(const Vector& p) const
  {
    double sum = -1.;
    for(const Term& t : terms)
      sum += t(p);
    return sign * sum;
  }

  Vector gradient(const Vector& p) const
  {
    Vector sum = CGAL::NULL_VECTOR;
    for(const Term& t : terms)
      sum = sum + sign * t(p) * t.slope(p);
    return sum;
  }

  std::array<Vector, 3> hessian(const Vector& p) const
  {
    std::array<Vector, 3> result = {{CGAL::NULL_VECTOR, CGAL::NULL_VECTOR, CGAL::NULL_VECTOR}};
    for(const Term& t : terms)
      for(int i = 0; i < 3; ++i)
      {
        const Vector e(i == 0, i == 1, i == 2);
        result[i] = result[i] + sign * t(p) * (t.slope(p)[i] * t.slope(p) - 2. * t.k * e);
      }
    return result;
  }

  // the planes n p = d as faces, with edges rounded by about `radius`
  static Sum_of_exponentials rounded(const std::vector<Vector>& normals, const std::vector<double>& d, double radius)
  {
    std::vector<Term> terms;
    for(std::size_t i = 0; i < normals.size(); ++i)
    {
      const Vector n = normals[i] / std::sqrt(normals[i].squared_length());
      terms.push_back({-d[i] / radius, n / radius, 0., CGAL::NULL_VECTOR});
    }
    return {1., terms};
  }

  // balls of about these radii
  static Sum_of_exponentials balls(const std::vector<Vector>& centers, const std::vector<double>& radii)
  {
    std::vector<Term> terms;
    for(std::size_t i = 0; i < centers.size(); ++i)
      terms.push_back({2., CGAL::NULL_VECTOR, 2. / (radii[i] * radii[i]), centers[i]});
    return {-1., terms};
  }
};

inline Sum_of_exponentials rounded_box()
{
  return Sum_of_exponentials::rounded(
    {Vector(1, 0, 0), Vector(-1, 0, 0), Vector(0, 1, 0), Vector(0, -1, 0), Vector(0, 0, 1), Vector(0, 0, -1)},
    {1., 1., 0.7, 0.7, 0.5, 0.5}, 0.12);
}

inline Sum_of_exponentials rounded_tetrahedron()
{
  return Sum_of_exponentials::rounded({Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1)},
                                      {0.4, 0.45, 0.5, 0.55}, 0.08);
}

// an elliptic cone with a rounded apex, on a base
inline Sum_of_exponentials cone_cap()
{
  std::vector<Vector> normals = {Vector(0., 0., -1.)};
  std::vector<double> d = {0.4};
  for(int i = 0; i < 24; ++i)
  {
    normals.emplace_back(std::cos(i * pi / 12.), 0.9 * std::sin(i * pi / 12.), 0.7);
    d.push_back(0.75);
  }
  return Sum_of_exponentials::rounded(normals, d, 0.1);
}

inline Sum_of_exponentials dumbbell_with_bump()
{
  return Sum_of_exponentials::balls(
    {Vector(-0.7, 0., 0.), Vector(0., 0., 0.), Vector(0.7, 0.05, 0.), Vector(0.8, 0.2, 0.4)}, {0.6, 0.45, 0.55, 0.25});
}

// a ball with four arms
inline Sum_of_exponentials ball_with_arms()
{
  std::vector<Vector> centers = {CGAL::NULL_VECTOR};
  std::vector<double> radii = {0.55};
  for(const Vector& arm : {Vector(1., 0.1, 0.2), Vector(-0.6, 0.9, 0.), Vector(-0.5, -0.8, 0.3), Vector(0.1, 0., -1.)})
    for(double r : {0.5, 0.75, 1.})
    {
      centers.push_back(r * arm);
      radii.push_back(0.3);
    }
  return Sum_of_exponentials::balls(centers, radii);
}

// r = 1 + epsilon Y, where Y is the spherical harmonic (x^3 - 3 x y^2) (8 z^2 - x^2 - y^2) of degree 5 and order 3
struct Bumpy_sphere : Star_shaped<Bumpy_sphere>
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
