// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "gltf_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <utility>

namespace {

using Json = nlohmann::ordered_json;

// Numbers in little endian, whatever the machine.
void append(std::uint32_t number, std::string& bytes)
{
  for(int i = 0; i < 4; ++i)
    bytes += static_cast<char>(number >> 8 * i & 0xff);
}

void append(double number, std::string& bytes)
{
  const auto rounded = static_cast<float>(number);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &rounded, sizeof bits);
  append(bits, bytes);
}

// The buffer of a file, in parts that begin at multiples of four bytes.
struct Buffer
{
  std::string bytes;
  Json views = Json::array();

  // `target` is what the part is for: 34962 vertices, 34963 indices, 0 an image
  void end_part(int target)
  {
    Json view = {{"buffer", 0}, {"byteOffset", begin_}, {"byteLength", bytes.size() - begin_}};
    if(target != 0)
      view["target"] = target;
    views.push_back(view);
    bytes.resize((bytes.size() + 3) / 4 * 4);
    begin_ = bytes.size();
  }

private:
  std::size_t begin_ = 0;
};

Json accessor(int view, int component_type, std::size_t count, const char* type)
{
  return {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}};
}

Json list(Json item)
{
  Json result = Json::array();
  result.push_back(std::move(item));
  return result;
}

void write_chunk(std::ostream& os, const std::string& type, std::string content, char filling)
{
  content.resize((content.size() + 3) / 4 * 4, filling);
  std::string length;
  append(static_cast<std::uint32_t>(content.size()), length);
  os << length << type << content;
}

Json accessors_of(const Atlas& atlas, Buffer& buffer)
{
  constexpr int floats = 5126, integers = 5125, of_vertices = 34962, of_faces = 34963;
  std::array<float, 3> low, high;
  low.fill((std::numeric_limits<float>::max)());
  high.fill(std::numeric_limits<float>::lowest());
  std::size_t vertices = 0, faces = 0;
  for(const auto& chart : atlas.charts)
    for(const Mesh::Vertex_index v : chart->disk.vertices())
    {
      for(int i = 0; i < 3; ++i)
      {
        const double x = chart->disk.point(v)[i];
        append(x, buffer.bytes);
        low[i] = (std::min)(low[i], static_cast<float>(x));
        high[i] = (std::max)(high[i], static_cast<float>(x));
      }
      ++vertices;
    }
  buffer.end_part(of_vertices);
  for(const auto& chart : atlas.charts)
    for(const Mesh::Vertex_index v : chart->disk.vertices())
    {
      append(chart->uv[v].x(), buffer.bytes);
      append(1. - chart->uv[v].y(), buffer.bytes); // images begin at their top
    }
  buffer.end_part(of_vertices);
  std::uint32_t first = 0;
  for(const auto& chart : atlas.charts)
  {
    for(const Mesh::Face_index f : chart->disk.faces())
      for(const Mesh::Vertex_index v : chart->disk.vertices_around_face(chart->disk.halfedge(f)))
        append(first + static_cast<std::uint32_t>(v), buffer.bytes);
    first += static_cast<std::uint32_t>(chart->disk.number_of_vertices());
    faces += chart->disk.number_of_faces();
  }
  buffer.end_part(of_faces);
  Json positions = accessor(0, floats, vertices, "VEC3");
  positions["min"] = low;
  positions["max"] = high;
  Json result = list(positions);
  result.push_back(accessor(1, floats, vertices, "VEC2"));
  result.push_back(accessor(2, integers, 3 * faces, "SCALAR"));
  return result;
}

} // namespace

void write_glb(std::ostream& os, const Atlas& atlas, const std::string& texture)
{
  Buffer buffer;
  Json file;
  file["asset"] = {{"version", "2.0"}, {"generator", "cut_locus"}};
  file["scene"] = 0;
  file["scenes"] = list({{"nodes", list(0)}});
  file["nodes"] = list({{"mesh", 0}});
  const Json attributes = {{"POSITION", 0}, {"TEXCOORD_0", 1}};
  file["meshes"] = list({{"primitives", list({{"attributes", attributes}, {"indices", 2}, {"material", 0}})}});
  const Json color = {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.}};
  file["materials"] = list({{"name", "checker"}, {"pbrMetallicRoughness", color}});
  file["textures"] = list({{"source", 0}});
  file["images"] = list({{"bufferView", 3}, {"mimeType", "image/png"}});
  file["accessors"] = accessors_of(atlas, buffer);
  buffer.bytes += texture;
  buffer.end_part(0);
  file["bufferViews"] = buffer.views;
  file["buffers"] = list({{"byteLength", buffer.bytes.size()}});

  constexpr std::size_t header = 12, header_of_chunk = 8;
  std::string text = file.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string numbers;
  append(std::uint32_t(2), numbers);
  append(static_cast<std::uint32_t>(header + 2 * header_of_chunk + text.size() + buffer.bytes.size()), numbers);
  os << "glTF" << numbers;
  write_chunk(os, "JSON", text, ' ');
  write_chunk(os, std::string("BIN\0", 4), buffer.bytes, '\0');
}
