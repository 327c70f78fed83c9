// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_GEODESIC_SHOOTING_H
#define CGAL_CUT_LOCI_BENCHMARK_GEODESIC_SHOOTING_H

#include "analytic_surfaces.h"

#include <Eigen/Dense>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace analytic {

// Shoots geodesics from a point of a surface that is given by an equation, with their Jacobi fields.
template <typename Surface>
class Geodesic_shooting
{
public:
  struct Arrival
  {
    Vector point, tangent, side; // the side is to the left of the geodesic
    double spread;               // the Jacobi field J, with J(0) = 0 and J'(0) = 1
  };

  // Directions are angles from `x_axis`, projected to the tangent plane, counterclockwise around the outer normal.
  Geodesic_shooting(const Surface& surface, const Point& source, const Vector& x_axis)
    : surface_(surface), source_(source - CGAL::ORIGIN)
  {
    normal_ = unit(surface_.gradient(source_));
    e1_ = unit(x_axis - (x_axis * normal_) * normal_);
    e2_ = CGAL::cross_product(normal_, e1_);
  }

  double direction(const Vector& v) const { return std::atan2(v * e2_, v * e1_); }

  Arrival operator()(double direction, double length) const
  {
    State s = start(direction);
    if(length > 0.)
    {
      using Stepper = boost::numeric::odeint::runge_kutta_dopri5<State>;
      boost::numeric::odeint::integrate_adaptive(
        boost::numeric::odeint::make_controlled<Stepper>(1e-11, 1e-11),
        [this](const State& x, State& dx, double) { derive(x, dx); }, s, 0., length, 0.05 * length);
    }
    return arrival(s);
  }

  // how far the first conjugate point in a direction is, if it is within `limit`
  std::optional<double> conjugate_distance(double direction, double limit) const
  {
    const int n = 400;
    boost::numeric::odeint::runge_kutta4<State> stepper;
    const auto system = [this](const State& x, State& dx, double) { derive(x, dx); };
    State s = start(direction);
    const double step = limit / n;
    for(int i = 0; i < n; ++i)
    {
      const State previous = s;
      stepper.do_step(system, s, 0., step);
      if(s[6] > 0.)
        continue;
      double low = 0., high = step;
      for(int k = 0; k < 50; ++k)
      {
        const double middle = 0.5 * (low + high);
        State m = previous;
        stepper.do_step(system, m, 0., middle);
        (m[6] > 0. ? low : high) = middle;
      }
      return i * step + low;
    }
    return std::nullopt;
  }

  // the arrivals at the multiples of `step` up to `limit`
  std::vector<Arrival> samples(double direction, double step, double limit) const
  {
    boost::numeric::odeint::runge_kutta4<State> stepper;
    const auto system = [this](const State& x, State& dx, double) { derive(x, dx); };
    std::vector<Arrival> result;
    State s = start(direction);
    for(int i = 1; i * step <= limit; ++i)
    {
      stepper.do_step(system, s, 0., step);
      result.push_back(arrival(s));
    }
    return result;
  }

  // The ends of the cut locus are first conjugate points where the conjugate distance has a local minimum, if a
  // shortest path leads there.
  std::vector<double> cusp_directions(double limit) const
  {
    const int n = 720;
    std::vector<double> c(n);
    for(int i = 0; i < n; ++i)
      c[i] = conjugate_distance(2. * pi * i / n, limit).value_or(10. * limit);
    std::vector<double> result;
    for(int i = 0; i < n; ++i)
    {
      const double left = c[(i + n - 1) % n], right = c[(i + 1) % n];
      if(!(c[i] <= left && c[i] < right && (std::max)(left, right) < limit))
        continue;
      const double offset = 0.5 * (left - right) / (left - 2. * c[i] + right);
      result.push_back(2. * pi * (i + offset) / n);
    }
    return result;
  }

  struct Cut_point
  {
    Vector point;
    double angle; // between the two directions at the source
  };

  // The point near `p` that geodesics in two directions reach at the same length, by the method of Gauss and Newton
  // from the given start; nothing if it does not converge, or to one geodesic.
  std::optional<Cut_point> cut_point(const Point& p, double direction_1, double direction_2, double length) const
  {
    const Vector target = p - CGAL::ORIGIN;
    for(int i = 0; i < 30; ++i)
    {
      const Arrival a = (*this)(direction_1, length), b = (*this)(direction_2, length);
      // The curve leaves along the bisector: in this direction the point is held beside `p`.
      Vector along = a.tangent + b.tangent;
      if(along.squared_length() < 1e-4)
        along = CGAL::cross_product(a.tangent - b.tangent, surface_.gradient(a.point));
      along = unit(along);
      const Vector gap = a.point - b.point, middle = 0.5 * (a.point + b.point) - target;
      Eigen::Matrix<double, 4, 3> m;
      Eigen::Matrix<double, 4, 1> r;
      const Vector d1 = a.spread * a.side, d2 = -b.spread * b.side, dl = a.tangent - b.tangent;
      for(int k = 0; k < 3; ++k)
      {
        m(k, 0) = d1[k];
        m(k, 1) = d2[k];
        m(k, 2) = dl[k];
        r(k) = gap[k];
      }
      m(3, 0) = 0.5 * d1 * along;
      m(3, 1) = -0.5 * d2 * along;
      m(3, 2) = 0.5 * (a.tangent + b.tangent) * along;
      r(3) = middle * along;
      const Eigen::Vector3d step = m.colPivHouseholderQr().solve(-r);
      const double factor = (std::min)(1., 0.2 / (std::max)(step.cwiseAbs().maxCoeff(), 1e-300));
      direction_1 += factor * step[0];
      direction_2 += factor * step[1];
      length += factor * step[2];
      if(step.cwiseAbs().maxCoeff() > 1e-9)
        continue;
      const double angle = std::fabs(std::remainder(direction_1 - direction_2, 2. * pi));
      if(!(angle > 1e-4) || !(length > 0.))
        return std::nullopt;
      return Cut_point{(*this)(direction_1, length).point, angle};
    }
    return std::nullopt;
  }

private:
  using State = std::array<double, 8>; // point, tangent, J, J'

  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

  State start(double direction) const
  {
    const Vector t = std::cos(direction) * e1_ + std::sin(direction) * e2_;
    return {{source_.x(), source_.y(), source_.z(), t.x(), t.y(), t.z(), 0., 1.}};
  }

  Arrival arrival(const State& s) const
  {
    const Vector p(s[0], s[1], s[2]), t = unit(Vector(s[3], s[4], s[5]));
    return {p, t, CGAL::cross_product(unit(surface_.gradient(p)), t), s[6]};
  }

  void derive(const State& s, State& ds) const
  {
    const Vector p(s[0], s[1], s[2]), t(s[3], s[4], s[5]);
    const Vector g = surface_.gradient(p);
    const std::array<Vector, 3> h = surface_.hessian(p);
    const double g2 = g.squared_length();
    const Vector acceleration = -(t * Vector(h[0] * t, h[1] * t, h[2] * t) / g2) * g;
    // the Gaussian curvature, by the adjugate of the Hessian
    const Vector c0 = CGAL::cross_product(h[1], h[2]), c1 = CGAL::cross_product(h[2], h[0]),
                 c2 = CGAL::cross_product(h[0], h[1]);
    const double k = g * Vector(c0 * g, c1 * g, c2 * g) / (g2 * g2);
    ds = {{t.x(), t.y(), t.z(), acceleration.x(), acceleration.y(), acceleration.z(), s[7], -k * s[6]}};
  }

  Surface surface_;
  Vector source_, normal_, e1_, e2_;
};

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_GEODESIC_SHOOTING_H
