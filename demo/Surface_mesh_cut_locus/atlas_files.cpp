// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"
#include "output_file.h"
#include "picture_files.h"

#include <filesystem>
#include <ostream>
#include <string>

namespace {

constexpr int squares = 32, pixels_of_square = 32;

// Squares whose color changes across the texture, so that it shows which part of it is where.
picture::Image checker()
{
  picture::Image result;
  result.width = result.height = squares * pixels_of_square;
  result.pixels.reserve(3 * std::size_t(result.width) * result.height);
  for(int row = 0; row < result.height; ++row)
    for(int column = 0; column < result.width; ++column)
    {
      const double u = double(column) / result.width, v = double(row) / result.height;
      const bool is_light = (row / pixels_of_square + column / pixels_of_square) % 2 == 0;
      const double shade = is_light ? 245. : 150.;
      for(const double part : {0.75 + 0.25 * u, 0.85, 0.75 + 0.25 * v})
        result.pixels.push_back(static_cast<std::uint8_t>(shade * part));
    }
  return result;
}

void write_mesh(std::ostream& os, const Atlas& atlas, const std::string& material)
{
  os << "mtllib " << material << "\nusemtl checker\n";
  for(const Kernel::Point_3& p : atlas.points)
    os << "v " << p << '\n';
  for(const auto& t : atlas.texture_coordinates)
    os << "vt " << t[0] << ' ' << t[1] << '\n';
  for(std::size_t f = 0; f < atlas.faces.size(); ++f)
  {
    os << 'f';
    for(int i = 0; i < 3; ++i)
    {
      os << ' ' << atlas.faces[f][i] + 1;
      if(f < atlas.texture_corners.size())
        os << '/' << atlas.texture_corners[f][i] + 1;
    }
    os << '\n';
  }
}

} // namespace

// The mesh last, as it refers to the others.
void write_atlas(const std::string& filename, const Atlas& atlas)
{
  const std::filesystem::path path(filename);
  const std::string base = path.stem().string(), material = base + ".mtl", texture = base + ".png";
  picture::Rendered_view view;
  view.surface = checker();
  write_file((path.parent_path() / texture).string(), [&](std::ostream& os) { picture::write_png(os, {view}); });
  write_file((path.parent_path() / material).string(), [&](std::ostream& os)
             { os << "newmtl checker\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << texture << '\n'; });
  write_file(filename, [&](std::ostream& os) { write_mesh(os, atlas, material); });
}
