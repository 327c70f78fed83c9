// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_MULTILEVEL_LAYOUT_H
#define CGAL_CUT_LOCI_FLATTENING_MULTILEVEL_LAYOUT_H

#include <CGAL/Cut_loci/flattening/Disk_shape.h>
#include <CGAL/Cut_loci/flattening/Injective_layout.h>
#include <CGAL/Cut_loci/flattening/Simplified_disks.h>
#include <CGAL/Cut_loci/flattening/Vertex_insertion.h>
#include <CGAL/Cut_loci/internal/Progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Cut_loci::internal {

// An injective layout of low energy. What takes many steps, since it moves far, is done on simplified disks, where steps cost
// little; the vertices of the disk itself come back into what is nearly their place.
class Multilevel_layout
{
public:
  Multilevel_layout(const Disk_shape& disk, unsigned int most_steps, const Progress& progress)
    : disk_(disk), most_steps_(most_steps), progress_(progress), plane_(disk.points.size(), Planar_point{{0., 0.}})
  {
    if(most_steps_ > 0 && lay_out_levels())
      return;
    Injective_layout layout(disk_);
    improve(layout, most_steps_, progress_);
    plane_ = layout.plane();
  }

  const Planar_points& plane() const { return plane_; }

private:
  // A simplified disk with points of its own.
  struct Part
  {
    Disk_shape disk;
    std::vector<Index> vertices; // of the whole one
  };

  Part part_of(const std::vector<Triangle_corners>& triangles) const
  {
    Part part;
    std::vector<Index> number(disk_.points.size(), null_index);
    part.disk.triangles = triangles;
    for(Triangle_corners& t : part.disk.triangles)
      for(Index& v : t)
      {
        if(number[v] == null_index)
        {
          number[v] = static_cast<Index>(part.vertices.size());
          part.vertices.push_back(v);
          part.disk.points.push_back(disk_.points[v]);
        }
        v = number[v];
      }
    find_rest_shapes(part.disk);
    for(const Index v : disk_.border)
      if(number[v] != null_index)
        part.disk.border.push_back(number[v]);
    const std::vector<Index>& border = part.disk.border;
    for(std::size_t k = 0; k < border.size(); ++k)
      part.disk.border_lengths.push_back((std::max)(
        part.disk.least_length, norm(part.disk.points[border[(k + 1) % border.size()]] - part.disk.points[border[k]])));
    return part;
  }

  // On all simplified disks together, as many as take the time of those on the disk itself.
  unsigned int most_steps_of(std::size_t number_of_faces, std::size_t number_of_levels) const
  {
    if(number_of_faces == disk_.triangles.size())
      return most_steps_;
    const double ratio = double(disk_.triangles.size()) / double(number_of_faces);
    return static_cast<unsigned int>((std::min)(double((std::numeric_limits<int>::max)()),
                                                double(most_steps_) * ratio / double(number_of_levels - 1)));
  }

  // Two slow steps end it, as one may be held up by the border.
  void improve(Injective_layout& layout, unsigned int most_steps, const Progress& progress) const
  {
    constexpr double least_progress = 1e-3;
    constexpr int least_slow_steps = 2;
    int slow_steps = 0;
    for(unsigned int k = 0; k < most_steps && slow_steps < least_slow_steps && std::isfinite(layout.energy()); ++k)
    {
      progress(static_cast<double>(k) / most_steps);
      const double before = layout.energy();
      if(!layout.improve())
        break;
      slow_steps = layout.energy() < (1. - least_progress) * before ? 0 : slow_steps + 1;
    }
  }

  // Returns whether numbers are fine enough for it.
  bool lay_out_levels()
  {
    const Simplified_disks simplified(disk_);
    const std::vector<Simplified_disks::Level>& levels = simplified.levels;
    Vertex_insertion insert(disk_, plane_);
    for(std::size_t k = levels.size(); k-- > 0;)
    {
      // the steps of each level may take the same time
      const double parts = static_cast<double>(levels.size()), first = (parts - 1. - static_cast<double>(k)) / parts;
      if(!lay_out(levels[k].triangles, k + 1 == levels.size(), most_steps_of(levels[k].triangles.size(), levels.size()),
                  progress_.part(first, first + 1. / parts)))
        return false;
      for(auto removed = levels[k].removed.rbegin(); removed != levels[k].removed.rend(); ++removed)
        if(!insert(*removed))
          return false;
      // Newton's method takes many steps for what is sharp and near, and these are those of the whole disk
      if(k > 0)
        insert.relax(levels[k - 1].triangles);
    }
    return true;
  }

  bool lay_out(const std::vector<Triangle_corners>& triangles, bool is_first, unsigned int most_steps,
               const Progress& progress)
  {
    const Part part = part_of(triangles);
    Planar_points plane;
    for(const Index v : part.vertices)
      plane.push_back(plane_[v]);
    Injective_layout layout = is_first ? Injective_layout(part.disk) : Injective_layout(part.disk, plane);
    if(!std::isfinite(layout.energy()))
      return false;
    improve(layout, most_steps, progress);
    for(std::size_t v = 0; v < part.vertices.size(); ++v)
      plane_[part.vertices[v]] = layout.plane()[v];
    return true;
  }

  const Disk_shape& disk_;
  const unsigned int most_steps_;
  const Progress progress_;
  Planar_points plane_;
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_MULTILEVEL_LAYOUT_H
