// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// OBJ files with texture coordinates.

#include "obj_file.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <ostream>
#include <sstream>
#include <string_view>

namespace {

using Corners = std::vector<std::vector<std::size_t>>;

void write_texture_coordinates(std::ostream& os, const Atlas& atlas)
{
  for(const auto& chart : atlas.charts)
    for(const Mesh::Vertex_index v : chart->disk.vertices())
      os << "vt " << chart->uv[v].x() << ' ' << chart->uv[v].y() << '\n';
}

void write_polygons(std::ostream& os, const std::vector<Kernel::Point_3>& points, const Corners& polygons,
                    const Corners& texture, const Atlas& atlas)
{
  for(const Kernel::Point_3& p : points)
    os << "v " << p << '\n';
  write_texture_coordinates(os, atlas);
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    os << 'f';
    for(std::size_t i = 0; i < polygons[f].size(); ++i)
    {
      os << ' ' << polygons[f][i] + 1;
      if(texture[f][i] != no_corner)
        os << '/' << texture[f][i] + 1;
    }
    os << '\n';
  }
}

// `v/vt/vn` with another `vt`, or none
void write_corner(std::ostream& os, const std::string& corner, std::size_t texture)
{
  const std::size_t first = (std::min)(corner.find('/'), corner.size()), last = corner.rfind('/');
  const std::string normal =
    last != std::string::npos && last > first && last + 1 < corner.size() ? corner.substr(last) : "";
  os << ' ' << corner.substr(0, first);
  if(texture != no_corner)
    os << '/' << texture + 1 << normal;
  else if(!normal.empty())
    os << '/' << normal;
}

// The first word of a line.
std::string_view keyword(std::string_view line)
{
  const std::size_t first = (std::min)(line.find_first_not_of(" \t"), line.size());
  line.remove_prefix(first);
  return line.substr(0, (std::min)(line.find_first_of(" \t\r\n\\"), line.size()));
}

// With what follows it, where the line goes on.
std::string_view next_line(std::string_view& text)
{
  const auto goes_on = [&](std::size_t end)
  {
    const std::size_t last = end > 0 && text[end - 1] == '\r' ? end - 1 : end;
    return end < text.size() && last > 0 && text[last - 1] == '\\';
  };
  std::size_t end = (std::min)(text.find('\n'), text.size());
  while(goes_on(end))
    end = (std::min)(text.find('\n', end + 1), text.size());
  const std::string_view line = text.substr(0, (std::min)(end + 1, text.size()));
  text.remove_prefix(line.size());
  return line;
}

} // namespace

Corner_normals normals_of_file(const File_content& content)
{
  Corner_normals result{content.soup.normals, {}};
  if(content.obj.empty())
    result.numbers = content.soup.polygons;
  std::string_view text = content.obj;
  while(!text.empty())
  {
    const std::string_view line = next_line(text), word = keyword(line);
    if(word != "vn" && word != "f")
      continue;
    std::string words(line);
    std::replace(words.begin(), words.end(), '\\', ' ');
    std::istringstream rest(words);
    std::string item;
    rest >> item;
    if(double x, y, z; word == "vn" && rest >> x >> y >> z)
      result.normals.emplace_back(x, y, z);
    if(word == "f")
      result.numbers.emplace_back();
    while(word == "f" && rest >> item)
    {
      const std::size_t slash = item.rfind('/');
      const bool has_normal = slash != std::string::npos && slash > item.find('/');
      const long number = has_normal ? std::strtol(item.c_str() + slash + 1, nullptr, 10) : 0;
      result.numbers.back().push_back(std::size_t(number < 0 ? long(result.normals.size()) + number : number - 1));
    }
  }
  const auto is_there = [&](std::size_t i) { return i < result.normals.size(); };
  for(const auto& corners : result.numbers)
    if(!std::all_of(corners.begin(), corners.end(), is_there))
      return {};
  return result;
}

void write_plain_obj(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const Polygon_soup& soup)
{
  if(!atlas.splits_faces)
    return write_polygons(os, soup.points, soup.polygons, texture_of_polygons(atlas, input, soup), atlas);
  const auto all_points = input.mesh.points();
  std::vector<Kernel::Point_3> points(all_points.begin(), all_points.end());
  std::map<Kernel::Point_3, std::size_t> added; // the copies of a new vertex have the same coordinates
  Corners faces, texture;
  std::size_t first = 0;
  for(const auto& chart : atlas.charts)
  {
    const Mesh& disk = chart->disk;
    for(const Mesh::Face_index f : disk.faces())
    {
      faces.emplace_back();
      texture.emplace_back();
      for(const Mesh::Vertex_index v : CGAL::vertices_around_face(disk.prev(disk.halfedge(f)), disk))
      {
        std::size_t number = chart->vertices[v];
        if(chart->vertices[v] == CGAL::Cut_loci::null_index)
        {
          const auto inserted = added.insert({disk.point(v), points.size()});
          if(inserted.second)
            points.push_back(disk.point(v));
          number = inserted.first->second;
        }
        faces.back().push_back(number);
        texture.back().push_back(first + std::size_t(v));
      }
    }
    first += disk.number_of_vertices();
  }
  write_polygons(os, points, faces, texture, atlas);
}

void write_kept_obj(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const File_content& content)
{
  const Corners texture = texture_of_polygons(atlas, input, content.soup);
  std::size_t face = 0;
  std::string_view text = content.obj;
  while(!text.empty())
  {
    const std::string_view line = next_line(text), word = keyword(line);
    if(word == "vt")
      continue;
    if(word != "f" && word != "l")
    {
      os << line;
      continue;
    }
    if(word == "f" && face == 0)
      write_texture_coordinates(os, atlas);
    const Corners::value_type none, &corners = word == "f" ? texture.at(face++) : none;
    std::string words(line);
    std::replace(words.begin(), words.end(), '\\', ' ');
    std::istringstream rest(words);
    std::string corner;
    rest >> corner;
    os << word;
    for(std::size_t i = 0; rest >> corner; ++i)
      write_corner(os, corner, i < corners.size() ? corners[i] : no_corner);
    os << (line.size() > 1 && line[line.size() - 2] == '\r' ? "\r\n" : "\n");
  }
}
