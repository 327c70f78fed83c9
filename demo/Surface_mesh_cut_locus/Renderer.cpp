// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace picture {

namespace {

constexpr int samples_per_pixel_side = 3;
constexpr Color background = {1., 1., 1.};
constexpr Color surface_color = {0.80, 0.83, 0.87}, back_color = {0.84, 0.76, 0.64};
constexpr int number_of_bands = 32;
constexpr double band_contrast = 0.07;
constexpr double crease_cosine = 0.75; // beyond about 40 degrees an edge is shaded as sharp

constexpr double lowest = -(std::numeric_limits<double>::max)();

double cross_2(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct Bounds
{
  Vector low = {{-lowest, -lowest, -lowest}}, high = {{lowest, lowest, lowest}};

  void add(const Vector& p)
  {
    for(int i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }
};

Color blend(const Color& a, const Color& b, double t)
{
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

Color scaled(const Color& c, double s)
{
  return {(std::min)(1., s * c.red), (std::min)(1., s * c.green), (std::min)(1., s * c.blue)};
}

class Shader
{
public:
  Shader(const Scene& scene, const Frame& frame) : scene_(scene), frame_(frame)
  {
    normals_.assign(scene.points.size(), Vector{{0., 0., 0.}});
    for(const auto& t : scene.triangles)
    {
      const Vector n = area_normal(t);
      for(std::uint32_t v : t)
        normals_[v] = normals_[v] + n;
    }
    for(Vector& n : normals_)
      n = normalized(n);
    double largest = 0.;
    for(double value : scene.values)
      if(std::isfinite(value))
        largest = (std::max)(largest, value);
    if(largest > 0.)
      bands_per_unit_ = number_of_bands / largest;
  }

  Color operator()(std::uint32_t triangle, double x, double y) const
  {
    const auto& t = scene_.triangles[triangle];
    Point_2 p[3];
    for(int i = 0; i < 3; ++i)
      p[i] = {frame_.x(scene_.points[t[i]]), frame_.y(scene_.points[t[i]])};
    const Point_2 q = {x, y};
    const double area = cross_2(p[0], p[1], p[2]);
    const double weight[3] = {cross_2(q, p[1], p[2]) / area, cross_2(p[0], q, p[2]) / area,
                              cross_2(p[0], p[1], q) / area};

    const Vector flat = normalized(area_normal(t));
    Vector normal = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      normal = normal + weight[i] * (dot(normals_[t[i]], flat) > crease_cosine ? normals_[t[i]] : flat);
    normal = normalized(normal);
    const bool is_back = dot(flat, frame_.view.toward) < 0.; // of an open or inverted surface
    if(is_back)
      normal = -1. * normal;

    Color color = is_back ? back_color : scene_.colors.empty() ? surface_color : scene_.colors[triangle];
    if(bands_per_unit_ > 0.)
    {
      double value = 0.;
      for(int i = 0; i < 3; ++i)
        value += weight[i] * scene_.values[t[i]];
      if(!std::isfinite(value))
        color = scaled(color, 0.9);
      else if(static_cast<long>(std::floor(value * bands_per_unit_)) % 2 != 0)
        color = scaled(color, 1. - band_contrast);
    }
    return light(color, normal);
  }

private:
  Vector area_normal(const std::array<std::uint32_t, 3>& t) const
  {
    return cross(scene_.points[t[1]] - scene_.points[t[0]], scene_.points[t[2]] - scene_.points[t[0]]);
  }

  // A main light from the upper left, a weak one from the eye, and darker silhouettes, which show the shape.
  Color light(const Color& color, const Vector& normal) const
  {
    const View& view = frame_.view;
    static const Vector key = normalized({{-0.45, 0.65, 0.75}});
    const Vector n = {{dot(normal, view.right), dot(normal, view.up), dot(normal, view.toward)}};
    const double facing = (std::max)(0., n[2]);
    const double diffuse = (std::max)(0., dot(n, key));
    const Vector half = normalized(key + Vector{{0., 0., 1.}});
    const double gloss = 0.10 * std::pow((std::max)(0., dot(n, half)), 40.);
    const double rim = 0.62 + 0.38 * std::pow(facing, 0.45);
    const Color lit = scaled(color, (0.50 + 0.16 * facing + 0.50 * diffuse) * rim);
    return blend(lit, {1., 1., 1.}, gloss);
  }

  const Scene& scene_;
  const Frame& frame_;
  std::vector<Vector> normals_;
  double bands_per_unit_ = 0.;
};

// An image of samples, several for each pixel of the final one.
class Canvas
{
public:
  Canvas(int width, int height) : width_(width), height_(height), samples_(std::size_t(width) * height, background) {}

  Color& at(int column, int row) { return samples_[std::size_t(row) * width_ + column]; }

  void draw_segment(const Point_2& a, const Point_2& b, double width, const Color& color)
  {
    const double r = 0.5 * width;
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    fill((std::min)(a.x, b.x) - r, (std::min)(a.y, b.y) - r, (std::max)(a.x, b.x) + r, (std::max)(a.y, b.y) + r, color,
         [&](double x, double y)
         {
      double t = squared > 0. ? ((x - a.x) * dx + (y - a.y) * dy) / squared : 0.;
      t = (std::max)(0., (std::min)(1., t));
      const double ex = x - a.x - t * dx, ey = y - a.y - t * dy;
      return ex * ex + ey * ey <= r * r;
    });
  }

  Image reduced(int factor) const
  {
    Image image;
    image.width = width_ / factor;
    image.height = height_ / factor;
    image.pixels.reserve(3 * std::size_t(image.width) * image.height);
    for(int row = 0; row < image.height; ++row)
      for(int column = 0; column < image.width; ++column)
      {
        Color sum;
        for(int j = 0; j < factor; ++j)
          for(int i = 0; i < factor; ++i)
          {
            const Color& c = samples_[std::size_t(row * factor + j) * width_ + column * factor + i];
            sum = {sum.red + c.red, sum.green + c.green, sum.blue + c.blue};
          }
        for(double channel : {sum.red, sum.green, sum.blue})
          image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255. * channel / (factor * factor))));
      }
    return image;
  }

private:
  template <typename Predicate>
  void fill(double x0, double y0, double x1, double y1, const Color& color, const Predicate& is_inside)
  {
    const int column1 = (std::min)(width_ - 1, static_cast<int>(std::ceil(x1)));
    const int row1 = (std::min)(height_ - 1, static_cast<int>(std::ceil(y1)));
    for(int row = (std::max)(0, static_cast<int>(std::floor(y0))); row <= row1; ++row)
      for(int column = (std::max)(0, static_cast<int>(std::floor(x0))); column <= column1; ++column)
        if(is_inside(column + 0.5, row + 0.5))
          at(column, row) = color;
  }

  int width_, height_;
  std::vector<Color> samples_;
};

double distance(const Point_2& a, const Point_2& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

double arc_length(const std::vector<Point_2>& points)
{
  double sum = 0.;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += distance(points[i - 1], points[i]);
  return sum;
}

// Cuts a polyline where it gets hidden, by samples that are as close as those of the depth buffer.
void add_visible_parts(const Polyline& polyline, const Depth_buffer& buffer, int factor,
                       std::vector<Visible_polyline>& parts)
{
  if(polyline.points.size() < 2)
    return;
  const Frame& frame = buffer.frame();
  const auto project = [&](const Vector& p) { return Point_2{frame.x(p) / factor, frame.y(p) / factor}; };
  Visible_polyline part = {{}, polyline.color, polyline.width};
  const auto end_part = [&](bool is_cut)
  {
    // what flickers at a silhouette is not worth drawing
    if(part.points.size() > 1 && !(is_cut && arc_length(part.points) < 4.))
      parts.push_back(part);
    part.points.clear();
  };

  for(std::size_t i = 1; i < polyline.points.size(); ++i)
  {
    const Vector& a = polyline.points[i - 1];
    const Vector ab = polyline.points[i] - a;
    const double size = factor * distance(project(a), project(polyline.points[i]));
    const int n = 1 + static_cast<int>(size);
    for(int j = i == 1 ? 0 : 1; j <= n; ++j)
    {
      const Vector p = a + (double(j) / n) * ab;
      if(!buffer.is_visible(p))
      {
        if(!part.points.empty())
        {
          part.points.push_back(project(a + ((j - 0.5) / n) * ab));
          end_part(true);
        }
      }
      else if(part.points.empty() || j == n)
        part.points.push_back(project(p));
    }
  }
  end_part(false);
}

/// the part of a horizontal line that is in a triangle
std::pair<double, double> span(const std::array<Point_2, 3>& corners, double y)
{
  double left = (std::numeric_limits<double>::infinity)(), right = -left;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Point_2 &p = corners[i], &q = corners[(i + 1) % 3];
    if((p.y - y) * (q.y - y) > 0.)
      continue;
    const double x = p.y == q.y ? p.x : p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
    left = (std::min)({left, x, p.y == q.y ? q.x : x});
    right = (std::max)({right, x, p.y == q.y ? q.x : x});
  }
  return {left, right};
}

} // namespace

double length(const Vector& a)
{
  return std::sqrt(dot(a, a));
}

Vector normalized(const Vector& a)
{
  const double l = length(a);
  return l > 0. ? (1. / l) * a : a;
}

std::vector<Frame> make_frames(const Scene& scene, const std::vector<View>& views, int width)
{
  constexpr double margin = 0.05;
  std::vector<Frame> frames(views.size());
  double widest = 0., highest = 0.;
  for(std::size_t i = 0; i < views.size(); ++i)
  {
    const View& view = views[i];
    Bounds bounds;
    for(const auto& t : scene.triangles)
      for(std::uint32_t v : t)
      {
        const Vector& p = scene.points[v];
        bounds.add({{dot(p, view.right), dot(p, view.up), dot(p, view.toward)}});
      }
    const Vector middle = 0.5 * (bounds.low + bounds.high), size = bounds.high - bounds.low;
    widest = (std::max)(widest, size[0]);
    highest = (std::max)(highest, size[1]);
    frames[i].view = view;
    frames[i].center = middle[0] * view.right + middle[1] * view.up + middle[2] * view.toward;
  }
  const double largest = (std::max)(widest, highest);
  if(!(largest > 0.))
    return {};
  const double inner = (1. - 2. * margin) * width;
  for(Frame& frame : frames)
  {
    frame.scale = inner / largest;
    frame.width = static_cast<int>(frame.scale * widest + 2. * margin * width);
    frame.height = static_cast<int>(frame.scale * highest + 2. * margin * width);
  }
  return frames;
}

Frame enlarged(Frame frame, int factor)
{
  frame.scale *= factor;
  frame.width *= factor;
  frame.height *= factor;
  return frame;
}

Depth_buffer::Depth_buffer(const Scene& scene, const Frame& frame)
  : frame_(frame), depths_(std::size_t(frame.width) * frame.height, -(std::numeric_limits<float>::infinity)()),
    triangles_(depths_.size(), no_triangle)
{
  struct Projected
  {
    Point_2 point;
    double depth;
  };
  std::vector<Projected> projected;
  projected.reserve(scene.points.size());
  for(const Vector& p : scene.points)
    projected.push_back({{frame.x(p), frame.y(p)}, frame.depth(p)});
  // a fraction of the size of the scene, and no less than what half a pixel is on a slope of about 60 degrees
  tolerance_ = (std::max)(0.002 * frame.width, 1.) / frame.scale;

  for(std::uint32_t id = 0; id < scene.triangles.size(); ++id)
  {
    const auto& t = scene.triangles[id];
    const Projected &a = projected[t[0]], &b = projected[t[1]], &c = projected[t[2]];
    const double area = cross_2(a.point, b.point, c.point);
    if(area == 0.)
      continue;
    const auto range = [](double low, double high, int size)
    {
      return std::make_pair((std::max)(0, static_cast<int>(std::ceil(low - 0.5))),
                            (std::min)(size - 1, static_cast<int>(std::floor(high - 0.5))));
    };
    const std::array<Point_2, 3> corners = {{a.point, b.point, c.point}};
    const auto [lowest, highest] = std::minmax({a.point.y, b.point.y, c.point.y});
    const auto rows = range(lowest, highest, frame.height);
    for(int row = rows.first; row <= rows.second; ++row)
    {
      // a slim triangle covers few pixels of its bounding box
      const auto [left, right] = span(corners, row + 0.5);
      if(!(left <= right))
        continue;
      const auto columns = range(left - 1e-6 * frame.width, right + 1e-6 * frame.width, frame.width);
      for(int column = columns.first; column <= columns.second; ++column)
      {
        const Point_2 q = {column + 0.5, row + 0.5};
        const double wa = cross_2(q, b.point, c.point) / area, wb = cross_2(a.point, q, c.point) / area;
        const double wc = 1. - wa - wb;
        if(wa < -1e-9 || wb < -1e-9 || wc < -1e-9) // shared edges leave no gaps
          continue;
        const float depth = static_cast<float>(wa * a.depth + wb * b.depth + wc * c.depth);
        const std::size_t i = index(column, row);
        if(depth > depths_[i])
        {
          depths_[i] = depth;
          triangles_[i] = id;
        }
      }
    }
  }
}

bool Depth_buffer::is_visible(const Vector& p) const
{
  const int column = static_cast<int>(std::floor(frame_.x(p))), row = static_cast<int>(std::floor(frame_.y(p)));
  const double depth = frame_.depth(p);
  for(int r = row - 1; r <= row + 1; ++r)
    for(int c = column - 1; c <= column + 1; ++c)
      if(r < 0 || c < 0 || r >= frame_.height || c >= frame_.width || depth >= depths_[index(c, r)] - tolerance_)
        return true;
  return false;
}

std::size_t Depth_buffer::number_of_covered_pixels() const
{
  return triangles_.size() - std::count(triangles_.begin(), triangles_.end(), no_triangle);
}

Rendered_view render(const Scene& scene, const Frame& frame)
{
  const int factor = samples_per_pixel_side;
  const Frame fine = enlarged(frame, factor);
  const Depth_buffer buffer(scene, fine);
  const Shader shade(scene, fine);

  Rendered_view result;
  Canvas canvas(fine.width, fine.height);
  for(int row = 0; row < fine.height; ++row)
    for(int column = 0; column < fine.width; ++column)
    {
      const std::uint32_t triangle = buffer.triangle(column, row);
      if(triangle != Depth_buffer::no_triangle)
        canvas.at(column, row) = shade(triangle, column + 0.5, row + 0.5);
    }
  result.surface = canvas.reduced(factor);

  for(const Polyline& polyline : scene.polylines)
    add_visible_parts(polyline, buffer, factor, result.polylines);
  for(const Dot& d : scene.dots)
    if(buffer.is_visible(d.point))
      result.dots.push_back({{frame.x(d.point), frame.y(d.point)}, d.color, d.radius});
  return result;
}

Image flatten(const Rendered_view& rendered)
{
  const int factor = samples_per_pixel_side;
  const Image& surface = rendered.surface;
  Canvas canvas(surface.width * factor, surface.height * factor);
  for(int row = 0; row < surface.height * factor; ++row)
    for(int column = 0; column < surface.width * factor; ++column)
    {
      const std::uint8_t* p = &surface.pixels[3 * (std::size_t(row / factor) * surface.width + column / factor)];
      canvas.at(column, row) = {p[0] / 255., p[1] / 255., p[2] / 255.};
    }
  const auto scaled_point = [&](const Point_2& p) { return Point_2{factor * p.x, factor * p.y}; };
  for(const Visible_polyline& polyline : rendered.polylines)
    for(std::size_t i = 1; i < polyline.points.size(); ++i)
      canvas.draw_segment(scaled_point(polyline.points[i - 1]), scaled_point(polyline.points[i]),
                          factor * polyline.width, polyline.color);
  for(const Visible_dot& d : rendered.dots)
  {
    const Point_2 p = scaled_point(d.point);
    canvas.draw_segment(p, p, 2. * factor * (d.radius + dot_rim), {1., 1., 1.});
    canvas.draw_segment(p, p, 2. * factor * d.radius, d.color);
  }
  return canvas.reduced(factor);
}

} // namespace picture
