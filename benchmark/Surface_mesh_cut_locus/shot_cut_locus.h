// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_BENCHMARK_SHOT_CUT_LOCUS_H
#define CGAL_CUT_LOCI_BENCHMARK_SHOT_CUT_LOCUS_H

#include "geodesic_shooting.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace analytic {

// the cut locus of a smooth surface, as polylines, and its ends
struct True_cut_locus
{
  Polylines curves;
  std::vector<Point> tips;
};

/*!
 * finds the cut locus of a point of any smooth surface by shooting geodesics, without a mesh.
 *
 * The cut distance c of a direction a is the least length at which another geodesic of the same length arrives at the
 * same point, or the conjugate distance if that is less. Pairs of geodesics that meet are first guessed from a fan of
 * sampled geodesics, solved for by Newton's method, and offered to the neighboring directions until nothing gets
 * shorter: a meeting at any length is an upper bound of c, so that no guess can do harm. Since c is continuous, the end
 * points in the order of the directions are a closed curve that runs along both sides of the cut locus. The tips are
 * the local minima of the conjugate distance that are not cut before.
 */
template <typename Surface>
class Shot_cut_locus
{
public:
  // `limit` must exceed all cut distances; curves are sampled with steps of at most `step`.
  Shot_cut_locus(const Surface& surface, const Point& source, double limit, double step)
    : shooting_(surface, source, reference(surface, source)), limit_(limit)
  {
    shoot_fan();
    std::vector<Ray> rays = guess();
    guess_beside_cusps(rays);
    share(rays);
    add_tips(rays);
    refine(rays, step);
    for(const Ray& ray : rays)
    {
      line_.push_back(ray.point);
      if(ray.is_tip)
        result_.tips.push_back(ray.point);
    }
    line_.push_back(line_.front());
    result_.curves.push_back(line_);
  }

  const True_cut_locus& operator()() const { return result_; }

  // the longest step between two points of the curve: a jump is a meeting that was not found
  double longest_step() const
  {
    double longest = 0.;
    for(std::size_t i = 1; i < line_.size(); ++i)
      longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(line_[i - 1], line_[i])));
    return longest;
  }

private:
  using Shooting = Geodesic_shooting<Surface>;
  using Arrival = typename Shooting::Arrival;
  using Cell = std::array<int, 3>;

  struct Ray
  {
    double direction = 0., other = 0.;
    double length = (std::numeric_limits<double>::infinity)();
    double conjugate = 0.;
    Point point;
    bool is_tip = false;

    bool is_cut() const { return length < (std::numeric_limits<double>::infinity)(); }
  };

  struct Sample
  {
    Arrival arrival;
    double length;
    int ray;
  };

  struct Hash
  {
    std::size_t operator()(const Cell& c) const
    {
      return std::size_t(c[0] * 73856093) ^ std::size_t(c[1] * 19349663) ^ std::size_t(c[2] * 83492791);
    }
  };

  static constexpr int number_of_rays = 720;
  static constexpr double fan_step = 0.02, cell_size = 0.03;
  static constexpr double least_gap = 5e-3; // Newton's method fails where the two geodesics are nearly one

  static Vector reference(const Surface& surface, const Point& source)
  {
    const Vector n = surface.gradient(source - CGAL::ORIGIN);
    const Vector x(1., 0., 0.), y(0., 1., 0.);
    return std::fabs(n.x()) < 0.7 * std::sqrt(n.squared_length()) ? x : y;
  }

  static double gap(double a, double b) { return std::fabs(std::remainder(a - b, 2. * pi)); }

  static Cell cell(const Vector& p, int dx = 0, int dy = 0, int dz = 0)
  {
    return {{int(std::floor(p.x() / cell_size)) + dx, int(std::floor(p.y() / cell_size)) + dy,
             int(std::floor(p.z() / cell_size)) + dz}};
  }

  void shoot_fan()
  {
    conjugate_.resize(number_of_rays);
    for(int i = 0; i < number_of_rays; ++i)
    {
      const double direction = 2. * pi * i / number_of_rays;
      conjugate_[i] = shooting_.conjugate_distance(direction, limit_).value_or(limit_);
      double length = fan_step;
      for(const Arrival& a : shooting_.samples(direction, fan_step, conjugate_[i]))
      {
        if(length > 5. * fan_step) // nothing is cut beside the source
        {
          cells_[cell(a.point)].push_back(static_cast<int>(fan_.size()));
          fan_.push_back({a, length, i});
        }
        length += fan_step;
      }
    }
  }

  // Where, seen from a sample of the fan, a front of the fan that passes nearby was there before.
  std::vector<Ray> guess()
  {
    std::vector<Ray> rays(number_of_rays);
    std::vector<std::set<int>> tried(number_of_rays);
    for(int i = 0; i < number_of_rays; ++i)
    {
      rays[i].direction = 2. * pi * i / number_of_rays;
      rays[i].conjugate = conjugate_[i];
    }
    for(const Sample& s : fan_)
    {
      Ray& ray = rays[s.ray];
      if(s.length > ray.length + 2. * fan_step)
        continue;
      std::map<int, std::pair<double, double>> best; // one for each tenth of a radian
      for(int d = 0; d < 27; ++d)
      {
        const auto found = cells_.find(cell(s.arrival.point, d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1));
        if(found == cells_.end())
          continue;
        for(int j : found->second)
        {
          const Sample& o = fan_[j];
          const double excess = o.length + (s.arrival.point - o.arrival.point) * o.arrival.tangent - s.length;
          const double direction = 2. * pi * o.ray / number_of_rays;
          if(excess > -1e-3 || gap(direction, ray.direction) < 0.05)
            continue;
          auto& entry = best.emplace(o.ray / 12, std::make_pair(0., 0.)).first->second;
          if(excess < entry.first)
            entry = {excess, direction};
        }
      }
      for(const auto& b : best)
        if(tried[s.ray].insert(b.first).second)
          offer(ray, b.second.second, s.length);
    }
    return rays;
  }

  // Geodesics to both sides of a cusp meet soon behind it.
  void guess_beside_cusps(std::vector<Ray>& rays) const
  {
    for(double cusp : shooting_.cusp_directions(limit_))
    {
      const double length = *shooting_.conjugate_distance(cusp, limit_);
      for(Ray& ray : rays)
        if(gap(ray.direction, cusp) < 0.1)
          offer(ray, 2. * cusp - ray.direction, length);
    }
  }

  // Replaces the end of the ray if it meets the geodesic near `other` sooner.
  bool offer(Ray& ray, double other, double length) const
  {
    for(int i = 0; i < 25; ++i)
    {
      const Arrival a = shooting_(ray.direction, length), b = shooting_(other, length);
      Eigen::Matrix<double, 3, 2> m;
      Eigen::Vector3d r;
      const Vector rate = a.tangent - b.tangent, sideways = -b.spread * b.side, apart = a.point - b.point;
      for(int k = 0; k < 3; ++k)
      {
        m(k, 0) = sideways[k];
        m(k, 1) = rate[k];
        r(k) = apart[k];
      }
      const Eigen::Vector2d step = m.colPivHouseholderQr().solve(-r);
      const double factor = (std::min)(1., 0.2 / (std::max)(step.cwiseAbs().maxCoeff(), 1e-300));
      other += factor * step[0];
      length += factor * step[1];
      if(!(length > 5. * fan_step) || length > limit_ || gap(other, ray.direction) < least_gap)
        return false;
      if(step.cwiseAbs().maxCoeff() > 1e-8)
        continue;
      if(r.norm() > 1e-6 || length > ray.conjugate + 1e-6 || !(length < ray.length - 1e-7))
        return false;
      ray.length = length;
      ray.other = other;
      ray.point = CGAL::ORIGIN + a.point;
      return true;
    }
    return false;
  }

  // Offers each meeting to the neighbors of both of its directions, until nothing gets shorter.
  void share(std::vector<Ray>& rays) const
  {
    std::vector<int> changed;
    for(int i = 0; i < number_of_rays; ++i)
      if(rays[i].is_cut())
        changed.push_back(i);
    while(!changed.empty())
    {
      std::set<int> next;
      for(int i : changed)
      {
        const Ray ray = rays[i];
        const int j = static_cast<int>(std::floor(ray.other / (2. * pi) * number_of_rays));
        const std::array<std::pair<int, double>, 4> offers = {
          {{i + 1, ray.other}, {i - 1, ray.other}, {j, ray.direction}, {j + 1, ray.direction}}};
        for(const auto& o : offers)
        {
          const int k = ((o.first % number_of_rays) + number_of_rays) % number_of_rays;
          // a neighbor that has the same partner gains nothing
          if(rays[k].is_cut() && gap(rays[k].other, o.second) < 0.03 && std::fabs(rays[k].length - ray.length) < 0.03)
            continue;
          if(offer(rays[k], o.second, ray.length))
            next.insert(k);
        }
      }
      changed.assign(next.begin(), next.end());
    }
    for(Ray& ray : rays)
      ray.direction = std::remainder(ray.direction, 2. * pi);
  }

  // A local minimum of the conjugate distance is a tip if no meeting is sooner.
  void add_tips(std::vector<Ray>& rays) const
  {
    std::vector<Ray> cut; // a ray that no other cuts is beside a tip
    for(const Ray& ray : rays)
      if(ray.is_cut())
        cut.push_back(ray);
    for(double direction : shooting_.cusp_directions(limit_))
    {
      Ray tip;
      tip.direction = std::remainder(direction, 2. * pi);
      tip.conjugate = *shooting_.conjugate_distance(direction, limit_);
      // The neighbors are cut sooner, by each other, if there is a tip between them; else by the same other one.
      const Ray *left = nullptr, *right = nullptr;
      for(const Ray& ray : cut)
      {
        const double d = std::remainder(ray.direction - tip.direction, 2. * pi);
        if(d >= 0. && (right == nullptr || d < std::remainder(right->direction - tip.direction, 2. * pi)))
          right = &ray;
        if(d < 0. && (left == nullptr || d > std::remainder(left->direction - tip.direction, 2. * pi)))
          left = &ray;
      }
      bool is_tip = true;
      for(const Ray* ray : {left, right})
        if(ray != nullptr)
          is_tip = is_tip && !offer(tip, ray->other, ray->length) &&
                   std::remainder(ray->direction - tip.direction, 2. * pi) *
                       std::remainder(ray->other - tip.direction, 2. * pi) <
                     0.;
      if(!is_tip)
        continue;
      tip.is_tip = true;
      tip.length = tip.conjugate;
      tip.other = tip.direction;
      tip.point = CGAL::ORIGIN + shooting_(direction, tip.conjugate).point;
      cut.push_back(tip);
    }
    rays = cut;
    std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.direction < b.direction; });
  }

  // Adds directions between those whose ends are more than `step` apart.
  void refine(std::vector<Ray>& rays, double step) const
  {
    std::vector<Ray> result;
    for(std::size_t i = 0; i < rays.size(); ++i)
    {
      Ray next = rays[(i + 1) % rays.size()];
      if(next.direction < rays[i].direction)
        next.direction += 2. * pi;
      result.push_back(rays[i]);
      refine(rays[i], next, step, 14, result);
    }
    rays = result;
  }

  void refine(const Ray& a, const Ray& b, double step, int depth, std::vector<Ray>& result) const
  {
    // Where the partner changes there is a junction: its corner must not be cut off.
    const double wanted = gap(a.other, b.other) > 0.1 && !a.is_tip && !b.is_tip ? 0.05 * step : step;
    if(depth == 0 || CGAL::squared_distance(a.point, b.point) <= wanted * wanted)
      return;
    Ray middle;
    middle.direction = 0.5 * (a.direction + b.direction);
    middle.conjugate = (std::max)(a.conjugate, b.conjugate); // nearly: it only has to keep later meetings out
    for(const Ray* ray : {&a, &b})
    {
      // the partner of a direction beside a tip is on the other side of it
      const double other = ray->is_tip ? 2. * ray->direction - middle.direction : ray->other;
      offer(middle, other, ray->length);
    }
    if(!middle.is_cut())
      return;
    refine(a, middle, step, depth - 1, result);
    result.push_back(middle);
    refine(middle, b, step, depth - 1, result);
  }

  Shooting shooting_;
  double limit_;
  std::vector<double> conjugate_;
  std::vector<Sample> fan_;
  std::unordered_map<Cell, std::vector<int>, Hash> cells_;
  std::vector<Point> line_;
  True_cut_locus result_;
};

} // namespace analytic

#endif // CGAL_CUT_LOCI_BENCHMARK_SHOT_CUT_LOCUS_H
