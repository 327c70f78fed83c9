// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_RENDERER_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_RENDERER_H

#include "Scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace picture {

// The place of a view on the screen: pixel coordinates have their origin at the top left.
struct Frame
{
  View view;
  Vector center;     // the point of the scene in the middle
  double scale = 1.; // pixels per unit of length
  int width = 0, height = 0;

  double x(const Vector& p) const { return 0.5 * width + scale * dot(p - center, view.right); }
  double y(const Vector& p) const { return 0.5 * height - scale * dot(p - center, view.up); }
  double depth(const Vector& p) const { return dot(p - center, view.toward); } // larger is nearer
};

// The frames of several views at one scale, side by side, in which the whole scene is seen.
std::vector<Frame> make_frames(const Scene& scene, const std::vector<View>& views, int width);

Frame enlarged(Frame frame, int factor);

// Which triangle is seen at each pixel, and how near it is.
class Depth_buffer
{
public:
  static constexpr std::uint32_t no_triangle = 0xffffffffu;

  Depth_buffer(const Scene& scene, const Frame& frame);

  const Frame& frame() const { return frame_; }
  std::uint32_t triangle(int column, int row) const { return triangles_[index(column, row)]; }
  // Whether a point on the surface is in front of all else, up to a pixel.
  bool is_visible(const Vector& p) const;
  std::size_t number_of_covered_pixels() const;

private:
  std::size_t index(int column, int row) const { return std::size_t(row) * frame_.width + column; }

  Frame frame_;
  double tolerance_;
  std::vector<float> depths_;
  std::vector<std::uint32_t> triangles_;
};

struct Image
{
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels; // red, green, blue
};

struct Point_2
{
  double x, y;
};

// A part of a polyline that nothing hides, in pixels.
struct Visible_polyline
{
  std::vector<Point_2> points;
  Color color;
  double width;
};

struct Visible_dot
{
  Point_2 point;
  Color color;
  double radius;
};

// The width of the white rim of dots, in pixels.
constexpr double dot_rim = 2.;

// What is seen in a frame; the image holds the surface alone.
struct Rendered_view
{
  Image surface;
  std::vector<Visible_polyline> polylines;
  std::vector<Visible_dot> dots;
};

Rendered_view render(const Scene& scene, const Frame& frame);

// The surface with polylines and dots drawn over it.
Image flatten(const Rendered_view& rendered);

} // namespace picture

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_RENDERER_H
