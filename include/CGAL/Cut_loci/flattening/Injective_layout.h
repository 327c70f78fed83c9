// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_INJECTIVE_LAYOUT_H
#define CGAL_CUT_LOCI_FLATTENING_INJECTIVE_LAYOUT_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/flattening/Border_scaffold.h>
#include <CGAL/Cut_loci/flattening/Convex_layout.h>
#include <CGAL/Cut_loci/flattening/Disk_shape.h>
#include <CGAL/Cut_loci/flattening/Symmetric_dirichlet.h>
#include <CGAL/Cut_loci/flattening/Triangle_system.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A disk in the plane, at first in a circle. Newton steps lower its symmetric Dirichlet energy, and never so far that a
// face of it, or of the scaffold around it, loses its area: so it stays injective. Both barriers are infinite, and the
// scaffold is made anew in each step, at rest, so that it resists sudden moves but has no share in the result.
class Injective_layout
{
public:
  explicit Injective_layout(const Disk_shape& disk) : border_(disk.border)
  {
    for(std::size_t f = 0; f < disk.triangles.size(); ++f)
      energy_.add_face(disk.triangles[f], disk.rest[f]);
    start(disk);
  }

  // from a layout with no flipped faces, whose size does not matter
  Injective_layout(const Disk_shape& disk, const Planar_points& plane) : border_(disk.border)
  {
    for(std::size_t f = 0; f < disk.triangles.size(); ++f)
      energy_.add_face(disk.triangles[f], disk.rest[f]);
    plane_ = scaled(disk, plane);
    value_ = mean_energy(plane_);
  }

  const Planar_points& plane() const { return plane_; }

  // By the mean of the least, which is 1: infinite if there is no start, because numbers are too coarse for it.
  double energy() const { return value_; }

  // Returns whether the layout has changed.
  bool improve()
  {
    const std::size_t number_of_vertices = plane_.size(), number_of_faces = energy_.number_of_faces();
    add_scaffold();
    const bool is_better = descend(number_of_vertices);
    plane_.resize(number_of_vertices);
    energy_.remove_faces_from(number_of_faces);
    value_ = mean_energy(plane_);
    return is_better;
  }

private:
  // How much stiffer the scaffold gets after a step that it has stopped, and softer after one that it has not.
  static constexpr double adaption = 2.;

  double mean_energy(const Planar_points& plane) const { return energy_.energy(plane) / (4. * energy_.area()); }

  // with the area that the disk has in space
  Planar_points scaled(const Disk_shape& disk, Planar_points plane) const
  {
    double area = 0.;
    for(const auto& t : disk.triangles)
      area += 0.5 * twice_signed_area(plane[t[0]], plane[t[1]], plane[t[2]]);
    const double scale = std::sqrt(energy_.area() / area);
    for(Planar_point& p : plane)
      p = {{scale * p[0], scale * p[1]}};
    return plane;
  }

  // The better one of two convex layouts, or of a few more if numbers are too coarse for both.
  void start(const Disk_shape& disk)
  {
    constexpr int least_layouts = 2, most_layouts = 6;
    Convex_layout convex(disk);
    plane_ = convex.plane();
    for(int k = 0; k < least_layouts || (k < most_layouts && !std::isfinite(value_)); ++k)
    {
      if(k > 0)
        convex.stiffen();
      if(!convex.relax())
        break;
      const Planar_points plane = scaled(disk, convex.plane());
      const double value = mean_energy(plane);
      if(k > 0 && !(value < value_))
        continue;
      value_ = value;
      plane_ = plane;
    }
  }

  // Each of its triangles has the weight of its longest edge, squared, and not of its area: else thin ones, which stop a
  // step first, are the last to be seen by it. Together they weigh about as much as the forces of the disk.
  void add_scaffold()
  {
    const Border_scaffold scaffold(plane_, border_);
    plane_.insert(plane_.end(), scaffold.frame.begin(), scaffold.frame.end());
    double area = 0.;
    for(const Triangle_corners& t : scaffold.triangles)
      area += 0.5 * twice_signed_area(plane_[t[0]], plane_[t[1]], plane_[t[2]]);
    // towards the end, forces vanish, and rounding should not
    constexpr double least_force = 1e-2;
    const double weight = stiffness_ * (value_ - 1. + least_force) * energy_.area() / area;
    for(const Triangle_corners& t : scaffold.triangles)
    {
      const Planar_triangle rest = {{plane_[t[0]], plane_[t[1]], plane_[t[2]]}};
      const double twice_area = twice_signed_area(rest[0], rest[1], rest[2]);
      const double longest =
        (std::max)({distance(rest[0], rest[1]), distance(rest[1], rest[2]), distance(rest[2], rest[0])});
      energy_.add_face(t, rest, weight * 2. * longest * longest / twice_area);
    }
  }

  // A Newton step of the disk and its scaffold; vertices from `first_held` on are held.
  bool descend(std::size_t first_held)
  {
    std::vector<bool> is_held(plane_.size(), false);
    std::fill(is_held.begin() + first_held, is_held.end(), true);
    Triangle_system<2> system(energy_.corners(), is_held);

    Eigen::VectorXd force = Eigen::VectorXd::Zero(system.number_of_unknowns());
    Symmetric_dirichlet::Gradient gradient;
    for(std::size_t f = 0; f < energy_.number_of_faces(); ++f)
    {
      energy_.derivatives(f, plane_, gradient, system.block(f));
      for(int i = 0; i < 3; ++i)
        if(const int k = system.unknown(energy_.corners()[f][i]); k >= 0)
          force.segment<2>(k) -= gradient.segment<2>(2 * i);
    }
    // far above rounding, and far too little to slow it down
    constexpr double damping = 1e-9;
    if(!system.factor(damping))
      return false;
    const Eigen::VectorXd step = system.solve(force);
    if(!step.allFinite())
      return false;
    Planar_points direction(plane_.size(), Planar_point{{0., 0.}});
    for(std::size_t v = 0; v < first_held; ++v)
      direction[v] = {{step[system.unknown(Index(v))], step[system.unknown(Index(v)) + 1]}};
    return search(direction, force.dot(step));
  }

  // `slope`: by how much the energy falls in a step of 1, as it seems from the start.
  bool search(const Planar_points& direction, double slope)
  {
    // up to nine tenths of the way to the first face without area, as Smith and Schaefer take
    const double limit = 0.9 * energy_.largest_step(plane_, direction, (std::numeric_limits<double>::max)());
    constexpr double least_part_of_slope = 1e-4; // Armijo's condition, with the usual constant
    const double before = energy_.energy(plane_);
    double size = (std::min)(1., limit);
    Planar_points found = moved(direction, size);
    double after = energy_.energy(found);
    const bool is_whole = size == 1. && after <= before - least_part_of_slope * slope;
    for(int k = 0; k < max_halvings && !(after <= before - least_part_of_slope * size * slope); ++k)
    {
      size *= 0.5;
      found = moved(direction, size);
      after = energy_.energy(found);
    }
    if(!(after < before))
      return false;
    // where faces are compressed, the energy is like 1 / x^2, and Newton steps are half as long as they could be
    while(is_whole && 2. * size < limit)
    {
      const Planar_points farther = moved(direction, 2. * size);
      const double value = energy_.energy(farther);
      if(!(value < after))
        break;
      size *= 2.;
      after = value;
      found = farther;
    }
    if(size < 0.5)
      stiffness_ *= adaption;
    else if(size >= 1.)
      stiffness_ = (std::max)(stiffness_ / adaption, least_stiffness);
    plane_ = found;
    return true;
  }

  Planar_points moved(const Planar_points& direction, double size) const
  {
    Planar_points result(plane_.size());
    for(std::size_t v = 0; v < plane_.size(); ++v)
      result[v] = {{plane_[v][0] + size * direction[v][0], plane_[v][1] + size * direction[v][1]}};
    return result;
  }

  static constexpr int max_halvings = 40;         // then the step is rounding
  static constexpr double least_stiffness = 1e-3; // from there on no step feels it

  std::vector<Index> border_;
  Symmetric_dirichlet energy_;
  Planar_points plane_;
  double value_ = (std::numeric_limits<double>::infinity)();
  double stiffness_ = 0.3; // adapts itself
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_INJECTIVE_LAYOUT_H
