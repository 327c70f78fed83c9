// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_CONVEX_LAYOUT_H
#define CGAL_CUT_LOCI_FLATTENING_CONVEX_LAYOUT_H

#include <CGAL/Cut_loci/flattening/Disk_shape.h>
#include <CGAL/Cut_loci/flattening/Triangle_system.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Cut_loci::internal {

// A disk in a circle with the edges for springs. Whatever their positive weights, no face is flipped [Tutte 1963,
// Floater 1997]. They start equal; then each gets stiffer by how much its edge is too long, so that faces far from the
// border, which shrink exponentially, get back most of their area, and the optimization is spared the way.
class Convex_layout
{
public:
  explicit Convex_layout(const Disk_shape& disk)
    : disk_(disk), plane_(disk.points.size(), Planar_point{{0., 0.}}), is_held_(disk.points.size(), false),
      stiffness_(disk.triangles.size(), {{1., 1., 1.}})
  {
    place_border();
    system_.reset(new Triangle_system<1>(disk.triangles, is_held_));
  }

  const Planar_points& plane() const { return plane_; }

  // Returns whether the system was solved.
  bool relax()
  {
    if(system_->number_of_unknowns() == 0)
      return true;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(system_->number_of_unknowns(), 2);
    for(std::size_t f = 0; f < disk_.triangles.size(); ++f)
      add_springs(f, right);
    if(!system_->factor())
      return false;
    const Eigen::MatrixXd solution = system_->solve(right);
    if(!solution.allFinite())
      return false;
    for(std::size_t v = 0; v < plane_.size(); ++v)
      if(!is_held_[v])
        plane_[v] = {{solution(system_->unknown(Index(v)), 0), solution(system_->unknown(Index(v)), 1)}};
    return true;
  }

  // both halves of a spring change alike
  void stiffen()
  {
    for(std::size_t f = 0; f < disk_.triangles.size(); ++f)
      for(int i = 0; i < 3; ++i)
        stiffness_[f][i] *=
          distance(plane_[disk_.triangles[f][i]], plane_[disk_.triangles[f][(i + 1) % 3]]) / disk_.lengths[f][i];
  }

private:
  // at the arc length of the border
  void place_border()
  {
    std::vector<double> at(1, 0.);
    for(std::size_t k = 0; k < disk_.border.size(); ++k)
      at.push_back(at.back() + disk_.border_lengths[k]);
    for(std::size_t k = 0; k < disk_.border.size(); ++k)
    {
      const double angle = 2. * CGAL_PI * at[k] / at.back();
      plane_[disk_.border[k]] = {{std::cos(angle), std::sin(angle)}};
      is_held_[disk_.border[k]] = true;
    }
  }

  void add_springs(std::size_t f, Eigen::MatrixX2d& right)
  {
    Eigen::Matrix3d& values = system_->block(f);
    values.setZero();
    const Triangle_corners& t = disk_.triangles[f];
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      values(i, i) += stiffness_[f][i];
      values(j, j) += stiffness_[f][i];
      values(i, j) -= stiffness_[f][i];
      values(j, i) -= stiffness_[f][i];
    }
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(!is_held_[t[i]] && is_held_[t[j]])
          for(int k = 0; k < 2; ++k)
            right(system_->unknown(t[i]), k) -= values(i, j) * plane_[t[j]][k];
  }

  const Disk_shape& disk_;
  Planar_points plane_;
  std::vector<bool> is_held_;
  std::vector<std::array<double, 3>> stiffness_; // of the edges of each face
  std::unique_ptr<Triangle_system<1>> system_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_CONVEX_LAYOUT_H
