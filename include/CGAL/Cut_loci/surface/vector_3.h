// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_INTERNAL_VECTOR_3_H
#define CGAL_CUT_LOCI_INTERNAL_VECTOR_3_H

#include <array>
#include <cmath>

namespace CGAL::Cut_loci::internal {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b)
{
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
inline Vector operator-(const Vector& a, const Vector& b)
{
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline Vector operator*(double s, const Vector& a)
{
  return {{s * a[0], s * a[1], s * a[2]}};
}
inline double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Vector& a)
{
  return std::sqrt(dot(a, a));
}

inline Vector cross(const Vector& a, const Vector& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

} // namespace CGAL::Cut_loci::internal

#endif // CGAL_CUT_LOCI_INTERNAL_VECTOR_3_H
