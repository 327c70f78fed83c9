// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_VERTEX_INSERTION_H
#define CGAL_CUT_LOCI_FLATTENING_VERTEX_INSERTION_H

#include <CGAL/Cut_loci/flattening/Disk_shape.h>
#include <CGAL/Cut_loci/flattening/Simplified_disks.h>
#include <CGAL/Cut_loci/flattening/Symmetric_dirichlet.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// Puts a vertex that a simplified disk does not have back into the plane, with no face flipped. There is such a place: next
// to the vertex that had taken it over, all of its link is seen.
class Vertex_insertion
{
public:
  Vertex_insertion(const Disk_shape& disk, Planar_points& plane) : disk_(disk), plane_(plane) {}

  // Returns whether numbers are fine enough for it.
  bool operator()(const Simplified_disks::Removed_vertex& removed)
  {
    local_.assign(1, Planar_point{{0., 0.}});
    for(const Index v : removed.link)
      local_.push_back(plane_[v]);
    find_kernel();
    if(kernel_.size() < 3)
      return false;
    for(const Planar_point& p : kernel_)
      for(std::size_t i = 0; i < 2; ++i)
        local_[0][i] += p[i] / static_cast<double>(kernel_.size());
    const std::size_t n = removed.link.size();
    Symmetric_dirichlet energy;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Index next = static_cast<Index>((i + 1) % n);
      const Triangle_corners face = {{0, static_cast<Index>(i + 1), next + 1}};
      if(removed.is_on_border && next == 0) // outside; it has next to no weight, and keeps the vertex inside
        energy.add_face(face, {{local_[0], local_[n], local_[1]}}, least_weight);
      else
        energy.add_face(face, rest_of(removed.vertex, removed.link[i], removed.link[next]));
    }
    return improve(removed.vertex, energy);
  }

  // Moves each vertex inside of the disk, one after the other, to where it has less energy.
  void relax(const std::vector<Triangle_corners>& triangles)
  {
    std::vector<std::vector<std::size_t>> faces(plane_.size());
    for(std::size_t f = 0; f < triangles.size(); ++f)
      for(const Index v : triangles[f])
        faces[v].push_back(f);
    for(const Index v : disk_.border)
      faces[v].clear();
    for(std::size_t v = 0; v < faces.size(); ++v)
    {
      if(faces[v].empty())
        continue;
      local_.assign(1, plane_[v]);
      Symmetric_dirichlet energy;
      for(const std::size_t f : faces[v])
      {
        const Triangle_corners& t = triangles[f];
        const std::size_t i = std::find(t.begin(), t.end(), static_cast<Index>(v)) - t.begin();
        const Index n = static_cast<Index>(local_.size()), next = t[(i + 1) % 3], last = t[(i + 2) % 3];
        energy.add_face({{0, n, n + 1}}, rest_of(t[i], next, last));
        local_.push_back(plane_[next]);
        local_.push_back(plane_[last]);
      }
      improve(static_cast<Index>(v), energy);
    }
  }

private:
  static constexpr double least_weight = 1e-3;

  // The points from which all edges of the link are seen: the link, cut off along the line of each of its edges.
  void find_kernel()
  {
    kernel_.assign(local_.begin() + 1, local_.end());
    const std::size_t n = local_.size() - 1;
    for(std::size_t i = 0; i < n && !kernel_.empty(); ++i)
    {
      const Planar_point &p = local_[1 + i], &q = local_[1 + (i + 1) % n];
      cut_.clear();
      for(std::size_t k = 0; k < kernel_.size(); ++k)
      {
        const Planar_point &a = kernel_[k], &b = kernel_[(k + 1) % kernel_.size()];
        const double at_a = twice_signed_area(p, q, a), at_b = twice_signed_area(p, q, b);
        if(at_a >= 0.)
          cut_.push_back(a);
        if((at_a > 0. && at_b < 0.) || (at_a < 0. && at_b > 0.))
        {
          const double t = at_a / (at_a - at_b);
          cut_.push_back({{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}});
        }
      }
      kernel_.swap(cut_);
    }
  }

  Planar_triangle rest_of(Index u, Index v, Index w) const
  {
    const auto length = [&](Index a, Index b) { return norm(disk_.points[b] - disk_.points[a]); };
    const std::array<double, 3> lengths = {{length(u, v), length(v, w), length(w, u)}};
    bool has_shape = false;
    return rest_shape(lengths, disk_.least_length, has_shape);
  }

  // Returns whether no face is flipped.
  bool improve(Index vertex, const Symmetric_dirichlet& energy)
  {
    double value = energy.energy(local_);
    if(!std::isfinite(value))
      return false;
    while(improve(energy, value))
      ;
    plane_[vertex] = local_[0];
    return true;
  }

  // A Newton step of the vertex alone. Returns whether another one is worth it: all vertices together do the rest.
  bool improve(const Symmetric_dirichlet& energy, double& value)
  {
    constexpr double least_progress = 0.1;
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    Symmetric_dirichlet::Gradient gradient;
    Symmetric_dirichlet::Hessian block;
    for(std::size_t f = 0; f < energy.number_of_faces(); ++f)
    {
      energy.derivatives(f, local_, gradient, block);
      force -= gradient.head<2>();
      hessian += block.topLeftCorner<2, 2>();
    }
    const Eigen::Vector2d step = hessian.llt().solve(force);
    if(!step.allFinite())
      return false;
    const Planar_point before = local_[0];
    for(double size = 1.; size > 1e-3; size *= 0.5)
    {
      local_[0] = {{before[0] + size * step[0], before[1] + size * step[1]}};
      const double after = energy.energy(local_);
      if(after < value)
      {
        const bool goes_on = after < (1. - least_progress) * value;
        value = after;
        return goes_on;
      }
    }
    local_[0] = before;
    return false;
  }

  const Disk_shape& disk_;
  Planar_points& plane_;
  Planar_points local_; // the vertex, then those around it
  Planar_points kernel_, cut_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_VERTEX_INSERTION_H
