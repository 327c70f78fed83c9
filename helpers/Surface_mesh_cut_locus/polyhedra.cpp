// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace test_meshes {

Mesh_data voxel_surface(const std::set<Voxel>& voxels, int n, Diagonals diagonals)
{
  Mesh_data m;
  std::map<Voxel, std::size_t> index;
  const auto vertex = [&](const Voxel& p)
  {
    const auto inserted = index.emplace(p, m.points.size());
    if(inserted.second)
      m.points.push_back({{double(p[0]) / n, double(p[1]) / n, double(p[2]) / n}});
    return inserted.first->second;
  };
  for(const Voxel& voxel : voxels)
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
      {
        Voxel neighbor = voxel;
        neighbor[axis] += side == 0 ? -1 : 1;
        if(voxels.count(neighbor))
          continue;
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            const auto corner = [&](int di, int dj)
            {
              Voxel p;
              p[axis] = n * (voxel[axis] + side);
              p[(axis + 1) % 3] = n * voxel[(axis + 1) % 3] + i + di;
              p[(axis + 2) % 3] = n * voxel[(axis + 2) % 3] + j + dj;
              return vertex(p);
            };
            std::array<std::size_t, 4> q = {{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}};
            if(side == 0)
              std::swap(q[1], q[3]);
            if(diagonals == Diagonals::ALTERNATING && (i + j) % 2 == 0)
              std::rotate(q.begin(), q.begin() + 1, q.end());
            add_square(m, q);
          }
      }
  return m;
}

Mesh_data box(int x, int y, int z, int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < x; ++i)
    for(int j = 0; j < y; ++j)
      for(int k = 0; k < z; ++k)
        voxels.insert({{i, j, k}});
  return voxel_surface(voxels, n);
}

Mesh_data cube(int n, Diagonals diagonals)
{
  return voxel_surface({{{0, 0, 0}}}, n, diagonals);
}

Mesh_data cuboid(const Point& size, int n, Diagonals diagonals)
{
  return scaled(cube(n, diagonals), size);
}

Mesh_data l_shape(int n)
{
  return voxel_surface({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, n);
}

Mesh_data cross_shape(int n)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 5; ++i)
  {
    voxels.insert({{i, 2, 0}});
    voxels.insert({{2, i, 0}});
  }
  return voxel_surface(voxels, n);
}

Mesh_data plate_with_holes(int holes_x, int holes_y, int n, Diagonals diagonals)
{
  std::set<Voxel> voxels;
  for(int i = 0; i < 2 * holes_x + 1; ++i)
    for(int j = 0; j < 2 * holes_y + 1; ++j)
      if(i % 2 == 0 || j % 2 == 0)
        voxels.insert({{i, j, 0}});
  return voxel_surface(voxels, n, diagonals);
}

Mesh_data perforated_plate(int holes_x, int holes_y, int n, unsigned seed)
{
  return jittered(smoothed(plate_with_holes(holes_x, holes_y, n), 3), 0.1, seed, [](const Point& p) { return p; });
}

Mesh_data rounded_plate(int holes_x, int holes_y, int n)
{
  return smoothed(plate_with_holes(holes_x, holes_y, n), n * n / 2);
}

Mesh_data square_with_holes(int k, int n)
{
  const int cells = 2 * k + 1;
  Mesh_data m;
  for(int i = 0; i <= cells * n; ++i)
    for(int j = 0; j <= cells * n; ++j)
      m.points.push_back({{double(i) / n, double(j) / n, 0.}});
  const auto vertex = [&](int i, int j) { return std::size_t(i * (cells * n + 1) + j); };
  for(int i = 0; i < cells * n; ++i)
    for(int j = 0; j < cells * n; ++j)
    {
      if((i / n) % 2 == 1 && (j / n) % 2 == 1)
        continue;
      std::array<std::size_t, 4> q = {{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}};
      if((i + j) % 2 == 0)
        std::rotate(q.begin(), q.begin() + 1, q.end());
      add_square(m, q);
    }
  return without_isolated_vertices(m);
}

Mesh_data closed_cylinder(std::size_t n, double height, Flat_face caps)
{
  Mesh_data m;
  for(double z : {0., height})
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2. * pi * static_cast<double>(i) / static_cast<double>(n);
      m.points.push_back({{std::cos(angle), std::sin(angle), z}});
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    m.triangles.push_back({{i, j, n + j}});
    m.triangles.push_back({{i, n + j, n + i}});
  }
  for(bool is_above : {false, true})
  {
    const std::size_t first = is_above ? n : 0, center = m.points.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) // counterclockwise from above
    {
      m.triangles.push_back(is_above ? Triangle{{a, b, c}} : Triangle{{a, c, b}});
    };
    if(caps == Flat_face::STAR)
      m.points.push_back({{0., 0., is_above ? height : 0.}});
    for(std::size_t i = 0; i < n && caps == Flat_face::STAR; ++i)
      add(center, first + i, first + (i + 1) % n);
    for(std::size_t i = 1; i + 1 < n && caps == Flat_face::FAN; ++i)
      add(first, first + i, first + i + 1);
    for(std::size_t low = 0, high = n - 1; high - low > 1 && caps == Flat_face::ZIGZAG;)
    {
      const bool is_low_next = low + high == n - 1;
      add(first + low, first + (is_low_next ? low + 1 : high - 1), first + high);
      low += is_low_next ? 1 : 0;
      high -= is_low_next ? 0 : 1;
    }
  }
  return m;
}

} // namespace test_meshes
