// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_SURFACE_FLAT_TRIANGLES_H
#define CGAL_CUT_LOCI_SURFACE_FLAT_TRIANGLES_H

#include <CGAL/Cut_loci/surface/Indexed_triangle_mesh.h>
#include <CGAL/Cut_loci/surface/vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Cut_loci::internal {

// Faces laid out in the plane: the halfedge `h` from the origin along the positive x-axis, its face above.

using Planar_vector = std::array<double, 2>;

inline Planar_vector operator+(const Planar_vector& a, const Planar_vector& b)
{
  return {{a[0] + b[0], a[1] + b[1]}};
}
inline Planar_vector operator-(const Planar_vector& a, const Planar_vector& b)
{
  return {{a[0] - b[0], a[1] - b[1]}};
}
inline Planar_vector operator*(double s, const Planar_vector& a)
{
  return {{s * a[0], s * a[1]}};
}
inline double dot(const Planar_vector& a, const Planar_vector& b)
{
  return a[0] * b[0] + a[1] * b[1];
}
inline double cross(const Planar_vector& a, const Planar_vector& b)
{
  return a[0] * b[1] - a[1] * b[0];
}
inline double norm(const Planar_vector& a)
{
  return std::sqrt(dot(a, a));
}

// A triangle of given edge lengths: its area, and at each corner the scalar product of the edges that start there.
// Edge `i` goes from corner `i` to the next one.
struct Triangle_shape
{
  double twice_area; // zero if the longest edge is as long as both others together, or longer
  std::array<double, 3> dots;

  explicit Triangle_shape(const std::array<double, 3>& length) : twice_area(doubled_area(length))
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double a = length[i], b = length[(i + 2) % 3], c = length[(i + 1) % 3];
      // (a^2 + b^2 - c^2) / 2, by a product where two squares nearly cancel
      dots[i] = 0.5 * (a > b ? (a - c) * (a + c) + b * b : (b - c) * (b + c) + a * a);
    }
  }

  // by how much the two shorter edges are longer than the longest one
  static double slack(std::array<double, 3> length)
  {
    std::sort(length.begin(), length.end());
    return length[0] - (length[2] - length[1]);
  }

private:
  // Heron's formula in the order in which nothing cancels but the lengths themselves, after Kahan.
  static double doubled_area(std::array<double, 3> length)
  {
    std::sort(length.begin(), length.end());
    const double a = length[2], b = length[1], c = length[0];
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0. ? 0.5 * std::sqrt(product) : 0.;
  }
};

inline double edge_length(const Indexed_triangle_mesh& mesh, Index h)
{
  if(!mesh.lengths.empty())
    return mesh.lengths[h];
  return norm(mesh.points[mesh.target(h)] - mesh.points[mesh.source(h)]);
}

inline double mean_edge_length(const Indexed_triangle_mesh& mesh)
{
  double sum = 0.;
  Index n = 0;
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if(!(mesh.opposite[h] < h)) // once per edge: null_index is larger than any halfedge
    {
      sum += edge_length(mesh, h);
      ++n;
    }
  return sum / (std::max)(n, Index(1));
}

// the vertex opposite to `h`
inline Planar_vector apex(const Indexed_triangle_mesh& mesh, Index h)
{
  if(!mesh.lengths.empty())
  {
    const std::array<double, 3> length = {
      {mesh.lengths[h], mesh.lengths[mesh.next(h)], mesh.lengths[mesh.previous(h)]}};
    const Triangle_shape shape(length);
    return {{shape.dots[0] / mesh.lengths[h], shape.twice_area / mesh.lengths[h]}};
  }
  const Vector& p = mesh.points[mesh.source(h)];
  const Vector a = mesh.points[mesh.target(h)] - p, b = mesh.points[mesh.source(mesh.previous(h))] - p;
  const double length = norm(a);
  return {{dot(a, b) / length, norm(cross(a, b)) / length}};
}

// the point of given barycentric coordinates in the face of `h`
inline Planar_vector flat_position(const Indexed_triangle_mesh& mesh, Index h, const std::array<double, 3>& coordinates)
{
  const Index i = h % 3;
  const double along = coordinates[(i + 1) % 3], up = coordinates[(i + 2) % 3];
  const Planar_vector top = apex(mesh, h);
  return {{along * edge_length(mesh, h) + up * top[0], up * top[1]}};
}

inline Vector position(const Indexed_triangle_mesh& mesh, const Indexed_location& location)
{
  const Indexed_triangle_mesh::Triangle& t = mesh.triangles[location.face];
  const std::array<double, 3>& c = location.coordinates;
  return c[0] * mesh.points[t[0]] + (c[1] * mesh.points[t[1]] + c[2] * mesh.points[t[2]]);
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_SURFACE_FLAT_TRIANGLES_H
