// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_FLATTENING_DISK_SHAPE_H
#define CGAL_CUT_LOCI_FLATTENING_DISK_SHAPE_H

#include <CGAL/Cut_loci/Index.h>
#include <CGAL/Cut_loci/flattening/Symmetric_dirichlet.h>
#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/connected_components.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Cut_loci::internal {

// What is to be laid flat: a disk, with the shape that each face should have in the plane.
struct Disk_shape
{
  std::vector<std::array<double, 3>> points; // in space
  std::vector<Triangle_corners> triangles;
  std::vector<Planar_triangle> rest;          // counterclockwise, each with an area
  std::vector<std::array<double, 3>> lengths; // of the edges of `rest`, from corner i to the next
  std::vector<Index> border;                  // its vertices, counterclockwise
  std::vector<double> border_lengths;         // of the edges from them to the next
  double least_length = 0.;                   // of the longest edges of faces in the plane
  std::size_t faces_without_shape = 0;        // thinner than `least_height`
};

// The height of a face by its longest edge below which it is laid out with this one. A thinner face says little of where
// its corners should be, but as long as it is one, its stiffness, the inverse of this, leaves too few digits to the others.
constexpr double least_height = 1e-4;

inline Planar_triangle rest_shape(const std::array<double, 3>& length, double least_length, bool& has_shape)
{
  const int k = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
  const double base = (std::max)(length[k], least_length), left = length[(k + 2) % 3], right = length[(k + 1) % 3];
  // the apex is over the base, as that is the longest edge
  const double x = (std::min)(base, (std::max)(0., 0.5 * (base + (left - right) * ((left + right) / base))));
  const double height = std::sqrt((std::max)(0., (left - x) * (left + x)));
  has_shape = length[k] >= least_length && height >= least_height * base;
  Planar_triangle rest;
  rest[k] = {{0., 0.}};
  rest[(k + 1) % 3] = {{base, 0.}};
  rest[(k + 2) % 3] = {{x, (std::max)(height, least_height * base)}};
  return rest;
}

inline double distance(const Planar_point& p, const Planar_point& q)
{
  return std::hypot(q[0] - p[0], q[1] - p[1]);
}

// From the points and the triangles.
inline void find_rest_shapes(Disk_shape& disk)
{
  std::vector<std::array<double, 3>> lengths;
  double sum = 0.;
  for(const auto& t : disk.triangles)
  {
    lengths.emplace_back();
    for(int i = 0; i < 3; ++i)
      sum += lengths.back()[i] = norm(disk.points[t[(i + 1) % 3]] - disk.points[t[i]]);
  }
  disk.least_length = least_height * sum / (3. * static_cast<double>(lengths.size()));
  for(const auto& length : lengths)
  {
    bool has_shape = false;
    disk.rest.push_back(rest_shape(length, disk.least_length, has_shape));
    disk.faces_without_shape += !has_shape;
    const Planar_triangle& rest = disk.rest.back();
    disk.lengths.push_back({{distance(rest[0], rest[1]), distance(rest[1], rest[2]), distance(rest[2], rest[0])}});
  }
}

// of a mesh that is a disk
inline Disk_shape disk_shape(const Indexed_triangle_mesh& mesh)
{
  Disk_shape disk;
  disk.points = mesh.points;
  disk.triangles = mesh.triangles;
  find_rest_shapes(disk);
  const Indexed_curve border = border_loops(mesh).front();
  for(const Index h : border.halfedges)
  {
    disk.border.push_back(mesh.source(h));
    disk.border_lengths.push_back(disk.lengths[h / 3][h % 3]);
  }
  return disk;
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_FLATTENING_DISK_SHAPE_H
