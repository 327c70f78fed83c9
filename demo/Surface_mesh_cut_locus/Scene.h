// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_H

#include <array>
#include <cstdint>
#include <vector>

// What the renderer takes: plain arrays, so that any program can fill them.
namespace picture {

using Vector = std::array<double, 3>;

struct Color
{
  double red = 0., green = 0., blue = 0.; // sRGB, in [0, 1]
};

struct Polyline
{
  std::vector<Vector> points;
  Color color;
  double width = 4.; // in pixels
};

struct Dot
{
  Vector point;
  Color color;
  double radius = 8.; // in pixels
};

struct Scene
{
  std::vector<Vector> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> values; // empty, or a number for each point: the surface is shaded in bands of it
  std::vector<Color> colors;  // empty, or one for each triangle
  std::vector<Polyline> polylines;
  std::vector<Dot> dots;
};

// An orthonormal frame; `toward` points from the scene to the eye. The projection is parallel.
struct View
{
  Vector right, up, toward;
};

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
inline Vector cross(const Vector& a, const Vector& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
double length(const Vector& a);
Vector normalized(const Vector& a); // the null vector stays as it is

} // namespace picture

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_SCENE_H
