// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H
#define CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

// Smooth surfaces whose cut loci are known, and their meshes: isotropic remeshing, projected onto the surface.
namespace analytic {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polylines = std::vector<std::vector<Point>>;

constexpr double pi = 3.14159265358979323846;

// The torus of revolution about the z axis: u turns about the axis, w about the tube, w = 0 is the outer equator.
struct Torus
{
  double R = 1., r = 0.4;

  Point point(double u, double w) const
  {
    return Point((R + r * std::cos(w)) * std::cos(u), (R + r * std::cos(w)) * std::sin(u), r * std::sin(w));
  }

  Point project(const Point& p) const
  {
    const double u = std::atan2(p.y(), p.x());
    const double w = std::atan2(p.z(), std::hypot(p.x(), p.y()) - R);
    return point(u, w);
  }

  Vector normal(const Point& p) const
  {
    const double u = std::atan2(p.y(), p.x());
    const Vector v = p - Point(R * std::cos(u), R * std::sin(u), 0.);
    return v / std::sqrt(v.squared_length());
  }

  // half the signed excess of the squared distance to the center line, its gradient, and its Hessian
  double value(const Vector& p) const
  {
    const double q = std::hypot(p.x(), p.y()) - R;
    return 0.5 * (q * q + p.z() * p.z() - r * r);
  }
  Vector gradient(const Vector& p) const
  {
    const double q = std::hypot(p.x(), p.y()), s = 1. - R / q;
    return Vector(s * p.x(), s * p.y(), p.z());
  }
  std::array<Vector, 3> hessian(const Vector& p) const
  {
    const double q = std::hypot(p.x(), p.y()), s = 1. - R / q, t = R / (q * q * q);
    return {{Vector(s + t * p.x() * p.x(), t * p.x() * p.y(), 0.), Vector(t * p.x() * p.y(), s + t * p.y() * p.y(), 0.),
             Vector(0., 0., 1.)}};
  }

  // a grid with edges of about `length`
  Mesh grid(double length) const
  {
    const int nu = static_cast<int>(std::ceil(2. * pi * (R + r) / length));
    const int nw = static_cast<int>(std::ceil(2. * pi * r / length));
    Mesh mesh;
    std::vector<Mesh::Vertex_index> v;
    for(int i = 0; i < nu; ++i)
      for(int j = 0; j < nw; ++j)
        v.push_back(mesh.add_vertex(point(2. * pi * i / nu, 2. * pi * j / nw)));
    const auto at = [&](int i, int j) { return v[(i % nu) * nw + j % nw]; };
    for(int i = 0; i < nu; ++i)
      for(int j = 0; j < nw; ++j)
      {
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    return mesh;
  }

  // The cut locus of a point of the outer equator: the opposite meridian, the inner equator, and the arc of the outer
  // equator beyond the first conjugate points [Gravesen, Markvorsen, Sinclair, Tanaka 2005].
  Polylines cut_locus_of_outer_equator(double u0, double step) const
  {
    const double conjugate = pi * std::sqrt(r / (R + r));
    Polylines result;
    result.push_back(curve(2. * pi * r, step, [&](double t) { return point(u0 + pi, 2. * pi * t); }));
    result.push_back(curve(2. * pi * (R - r), step, [&](double t) { return point(u0 + 2. * pi * t, pi); }));
    const double length = 2. * (pi - conjugate) * (R + r);
    result.push_back(
      curve(length, step, [&](double t) { return point(u0 + conjugate + t * 2. * (pi - conjugate), 0.); }));
    return result;
  }

  // The cut locus of a point of the inner equator: the opposite meridian and the outer equator.
  Polylines cut_locus_of_inner_equator(double u0, double step) const
  {
    Polylines result;
    result.push_back(curve(2. * pi * r, step, [&](double t) { return point(u0 + pi, 2. * pi * t); }));
    result.push_back(curve(2. * pi * (R + r), step, [&](double t) { return point(u0 + 2. * pi * t, 0.); }));
    return result;
  }

private:
  template <typename Parametrization>
  static std::vector<Point> curve(double length, double step, const Parametrization& at)
  {
    const int n = static_cast<int>(std::ceil(length / step));
    std::vector<Point> result;
    for(int i = 0; i <= n; ++i)
      result.push_back(at(double(i) / n));
    return result;
  }
};

// The ellipsoid with the given half axes.
struct Ellipsoid
{
  double a = 1., b = 0.8, c = 0.6;

  Point point(double u, double w) const
  {
    return Point(a * std::cos(w) * std::cos(u), b * std::cos(w) * std::sin(u), c * std::sin(w));
  }

  double value(const Vector& p) const
  {
    return 0.5 * (p.x() * p.x() / (a * a) + p.y() * p.y() / (b * b) + p.z() * p.z() / (c * c) - 1.);
  }
  Vector gradient(const Vector& p) const { return Vector(p.x() / (a * a), p.y() / (b * b), p.z() / (c * c)); }
  std::array<Vector, 3> hessian(const Vector&) const
  {
    return {{Vector(1. / (a * a), 0., 0.), Vector(0., 1. / (b * b), 0.), Vector(0., 0., 1. / (c * c))}};
  }

  Point project(const Point& p) const
  {
    Vector q = p - CGAL::ORIGIN;
    for(int i = 0; i < 20; ++i)
    {
      const Vector g = gradient(q);
      q = q - (value(q) / g.squared_length()) * g;
    }
    return CGAL::ORIGIN + q;
  }

  Vector normal(const Point& p) const
  {
    const Vector g = gradient(p - CGAL::ORIGIN);
    return g / std::sqrt(g.squared_length());
  }

  // the faces of a cube with edges of about `length`, on the ellipsoid
  Mesh grid(double length) const
  {
    const int n = static_cast<int>(std::ceil(0.5 * pi * (std::max)(a, (std::max)(b, c)) / length));
    Mesh mesh;
    std::map<std::array<int, 3>, Mesh::Vertex_index> vertex;
    const auto at = [&](const std::array<int, 3>& i)
    {
      const auto found = vertex.find(i);
      if(found != vertex.end())
        return found->second;
      std::array<double, 3> x;
      double norm = 0.;
      for(int k = 0; k < 3; ++k)
      {
        x[k] = std::tan(0.25 * pi * (2. * i[k] / n - 1.)); // even angles
        norm += x[k] * x[k];
      }
      norm = std::sqrt(norm);
      return vertex[i] = mesh.add_vertex(Point(a * x[0] / norm, b * x[1] / norm, c * x[2] / norm));
    };
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side <= n; side += n)
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            const auto corner = [&](int di, int dj)
            {
              std::array<int, 3> index;
              index[axis] = side;
              index[(axis + 1) % 3] = i + di;
              index[(axis + 2) % 3] = j + dj;
              return at(index);
            };
            if(side > 0)
            {
              mesh.add_face(corner(0, 0), corner(1, 0), corner(1, 1));
              mesh.add_face(corner(0, 0), corner(1, 1), corner(0, 1));
            }
            else
            {
              mesh.add_face(corner(0, 0), corner(1, 1), corner(1, 0));
              mesh.add_face(corner(0, 0), corner(0, 1), corner(1, 1));
            }
          }
    return mesh;
  }
};

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H
