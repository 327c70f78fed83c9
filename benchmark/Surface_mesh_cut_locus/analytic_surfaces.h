// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H
#define CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <vector>

// Smooth surfaces whose cut loci are known, and their meshes: isotropic remeshing, projected onto the surface.
namespace analytic {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polylines = std::vector<std::vector<Point> >;

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
    result.push_back(curve(length, step, [&](double t)
                           { return point(u0 + conjugate + t * 2. * (pi - conjugate), 0.); }));
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

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_ANALYTIC_SURFACES_H
