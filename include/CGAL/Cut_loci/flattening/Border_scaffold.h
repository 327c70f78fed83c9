// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_BORDER_SCAFFOLD_H
#define CGAL_CUT_LOCI_FLATTENING_BORDER_SCAFFOLD_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/flattening/Symmetric_dirichlet.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// The plane around a disk whose border does not cross itself, triangulated out to a square frame. As long as none of these
// triangles is flipped either, the border can not come to cross itself [Jiang, Schaefer, Panozzo, 2017].
class Border_scaffold
{
public:
  // The points of the frame get indices from `plane.size()` on.
  Border_scaffold(const Planar_points& plane, const std::vector<Index>& border)
  {
    make_frame(plane, border);
    Triangulation triangulation;
    std::vector<typename Triangulation::Vertex_handle> handles;
    for(std::size_t k = 0; k < frame.size(); ++k)
      insert(triangulation, frame[k], static_cast<Index>(plane.size() + k));
    for(const Index v : border)
      handles.push_back(insert(triangulation, plane[v], v));
    for(std::size_t k = 0; k < handles.size(); ++k)
      triangulation.insert_constraint(handles[k], handles[(k + 1) % handles.size()]);
    take_faces_outside(triangulation);
  }

  Planar_points frame;
  std::vector<Triangle_corners> triangles; // counterclockwise

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Face_base =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;

  static typename Triangulation::Vertex_handle insert(Triangulation& triangulation, const Planar_point& p, Index index)
  {
    const auto vertex = triangulation.insert(Kernel::Point_2(p[0], p[1]));
    vertex->info() = index;
    return vertex;
  }

  // Twice as large as the disk, so that there is room around it in each step.
  void make_frame(const Planar_points& plane, const std::vector<Index>& border)
  {
    constexpr int points_of_side = 4;
    Planar_point low = plane[border.front()], high = low;
    for(const Index v : border)
      for(std::size_t i = 0; i < 2; ++i)
      {
        low[i] = (std::min)(low[i], plane[v][i]);
        high[i] = (std::max)(high[i], plane[v][i]);
      }
    const double radius = (std::max)(high[0] - low[0], high[1] - low[1]);
    const Planar_point middle = {{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])}};
    for(int k = 0; k < points_of_side; ++k)
    {
      const double s = 2. * k / points_of_side - 1.;
      for(const Planar_point& p :
          {Planar_point{{s, -1.}}, Planar_point{{1., s}}, Planar_point{{-s, 1.}}, Planar_point{{-1., -s}}})
        frame.push_back({{middle[0] + radius * p[0], middle[1] + radius * p[1]}});
    }
  }

  void take_faces_outside(Triangulation& triangulation)
  {
    for(const auto face : triangulation.all_face_handles())
      face->info() = false;
    std::vector<typename Triangulation::Face_handle> found(1, triangulation.infinite_face());
    found.front()->info() = true;
    while(!found.empty())
    {
      const auto face = found.back();
      found.pop_back();
      if(!triangulation.is_infinite(face))
        triangles.push_back({{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}});
      for(int i = 0; i < 3; ++i)
      {
        const auto next = face->neighbor(i);
        if(next->info() || face->is_constrained(i))
          continue;
        next->info() = true;
        found.push_back(next);
      }
    }
  }
};

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_BORDER_SCAFFOLD_H
