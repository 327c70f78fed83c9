// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "picture_files.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <ostream>
#include <stdexcept>

namespace picture {

namespace {

Image side_by_side(const std::vector<Image>& images)
{
  Image result;
  for(const Image& image : images)
  {
    result.width += image.width;
    result.height = (std::max)(result.height, image.height);
  }
  result.pixels.assign(3 * std::size_t(result.width) * result.height, 255);
  int left = 0;
  for(const Image& image : images)
  {
    for(int row = 0; row < image.height; ++row)
      std::copy_n(image.pixels.begin() + 3 * std::size_t(row) * image.width, 3 * std::size_t(image.width),
                  result.pixels.begin() + 3 * (std::size_t(row) * result.width + left));
    left += image.width;
  }
  return result;
}

std::vector<std::uint8_t> encode_png(const Image& image)
{
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  if(!png_image_write_to_memory(&png, nullptr, &size, 0, image.pixels.data(), 0, nullptr))
    throw std::runtime_error(std::string("the picture can not be encoded: ") + png.message);
  std::vector<std::uint8_t> bytes(size);
  if(!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw std::runtime_error(std::string("the picture can not be encoded: ") + png.message);
  bytes.resize(size);
  return bytes;
}

void write_base64(std::ostream& os, const std::vector<std::uint8_t>& bytes)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string line;
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t n = (std::min)(std::size_t(3), bytes.size() - i);
    std::uint32_t group = 0;
    for(std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (j < n ? bytes[i + j] : 0u);
    for(std::size_t j = 0; j < 4; ++j)
      line += j <= n ? digits[group >> (18 - 6 * j) & 63u] : '=';
    if(line.size() >= 76 || i + 3 >= bytes.size())
    {
      os << line << '\n';
      line.clear();
    }
  }
}

std::string hexadecimal(const Color& c)
{
  char text[8];
  const auto byte = [](double channel) { return static_cast<unsigned>(std::lround(255. * channel)) & 255u; };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(c.red), byte(c.green), byte(c.blue));
  return text;
}

} // namespace

void write_png(std::ostream& os, const std::vector<Rendered_view>& views)
{
  std::vector<Image> images;
  for(const Rendered_view& view : views)
    images.push_back(flatten(view));
  const std::vector<std::uint8_t> bytes = encode_png(side_by_side(images));
  os.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write_svg(std::ostream& os, const std::vector<Rendered_view>& views)
{
  std::vector<Image> images;
  for(const Rendered_view& view : views)
    images.push_back(view.surface);
  const Image surface = side_by_side(images);

  os << std::fixed << std::setprecision(2);
  os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
     << "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\""
     << surface.width << "\" height=\"" << surface.height << "\" viewBox=\"0 0 " << surface.width << ' '
     << surface.height << "\">\n"
     << "<image width=\"" << surface.width << "\" height=\"" << surface.height
     << "\" xlink:href=\"data:image/png;base64,\n";
  write_base64(os, encode_png(surface));
  os << "\"/>\n";
  int left = 0;
  for(const Rendered_view& view : views)
  {
    os << "<g transform=\"translate(" << left << ",0)\">\n"
       << "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for(const Visible_polyline& polyline : view.polylines)
    {
      os << "<path stroke=\"" << hexadecimal(polyline.color) << "\" stroke-width=\"" << polyline.width << "\" d=\"M";
      for(std::size_t i = 0; i < polyline.points.size(); ++i)
        os << (i == 0 ? "" : i % 8 == 0 ? "\n" : " ") << polyline.points[i].x << ',' << polyline.points[i].y;
      os << "\"/>\n";
    }
    os << "</g>\n";
    for(const Visible_dot& dot : view.dots)
      os << "<circle cx=\"" << dot.point.x << "\" cy=\"" << dot.point.y << "\" r=\"" << dot.radius + 0.5 * dot_rim
         << "\" fill=\"" << hexadecimal(dot.color) << "\" stroke=\"#ffffff\" stroke-width=\"" << dot_rim << "\"/>\n";
    os << "</g>\n";
    left += view.surface.width;
  }
  os << "</svg>\n";
}

} // namespace picture
