// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "atlas.h"
#include "gltf_file.h"
#include "obj_file.h"
#include "output_file.h"
#include "picture_files.h"

#include <filesystem>
#include <ostream>
#include <sstream>
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

bool is_glb(const std::string& filename)
{
  return std::filesystem::path(filename).extension() == ".glb";
}

std::string with_extension(const std::string& filename, const char* extension)
{
  return std::filesystem::path(filename).replace_extension(extension).string();
}

} // namespace

// The mesh last, as it refers to the others.
void write_atlas(const std::string& filename, const Atlas& atlas, const Input_mesh& input, const File_content& content)
{
  const auto write_texture = [](std::ostream& os)
  {
    picture::Rendered_view view;
    view.surface = checker();
    picture::write_png(os, {view});
  };
  if(is_glb(filename))
  {
    std::ostringstream texture;
    write_texture(texture);
    write_file(filename, [&](std::ostream& os) { write_glb(os, atlas, input, content, texture.str()); });
    return;
  }
  if(!content.obj.empty() && !atlas.splits_faces)
  {
    write_file(filename, [&](std::ostream& os) { write_kept_obj(os, atlas, input, content); });
    return;
  }
  const std::string texture = with_extension(filename, ".png"), material = with_extension(filename, ".mtl");
  const auto name = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  write_file(texture, write_texture);
  write_file(material, [&](std::ostream& os)
             { os << "newmtl checker\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << name(texture) << '\n'; });
  write_file(filename,
             [&](std::ostream& os)
             {
    os << "mtllib " << name(material) << "\nusemtl checker\n";
    write_plain_obj(os, atlas, input, content.soup);
  });
}
