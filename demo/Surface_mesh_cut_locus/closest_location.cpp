// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Mesh.h"

#include <CGAL/Polygon_mesh_processing/locate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace {

using Coordinates = std::array<double, 3>;

// Whether they are numbers; then they are inside.
bool take_inside(Coordinates& coordinates)
{
  double sum = 0.;
  for(double& c : coordinates)
    sum += c = (std::max)(c, 0.);
  for(double& c : coordinates)
    c /= sum;
  return std::isfinite(sum) && sum > 0.;
}

// where a line from `a` to `b` is closest to a point: 0 at `a`, 1 at `b`
double closest_share(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& p)
{
  const Kernel::Vector_3 along = b - a;
  const double length = along.squared_length();
  return length > 0. ? (std::min)((std::max)(along * (p - a) / length, 0.), 1.) : 0.;
}

} // namespace

// In a face that is flat, barycentric coordinates by areas are no numbers: there it is the closest point of the sides.
Location closest_location(const Mesh& mesh, const Kernel::Point_3& p)
{
  const Location found = CGAL::Polygon_mesh_processing::locate(p, mesh);
  const Mesh::Halfedge_index h = mesh.halfedge(found.first); // coordinates start with its source
  const std::array<Kernel::Point_3, 3> corners = {
    {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))}};

  Location result = found;
  double least = (std::numeric_limits<double>::infinity)();
  const auto take_closer = [&](const Coordinates& c)
  {
    const Kernel::Vector_3 from_first = c[1] * (corners[1] - corners[0]) + c[2] * (corners[2] - corners[0]);
    const double distance = (p - corners[0] - from_first).squared_length();
    if(!(distance < least))
      return;
    least = distance;
    result.second = c;
  };
  if(Coordinates inside = found.second; take_inside(inside))
    take_closer(inside);
  for(std::size_t i = 0; i < 3; ++i)
  {
    Coordinates c = {{0., 0., 0.}};
    c[(i + 1) % 3] = closest_share(corners[i], corners[(i + 1) % 3], p);
    c[i] = 1. - c[(i + 1) % 3];
    take_closer(c);
  }
  return result;
}
