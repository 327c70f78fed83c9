// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "gltf_file.h"
#include "obj_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <ostream>
#include <tuple>
#include <utility>
#include <vector>

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

using Normal = std::array<float, 3>;

// Of unit length; `otherwise` if it has no direction.
Normal unit(const Kernel::Vector_3& v, const Kernel::Vector_3& otherwise)
{
  const double length = std::sqrt(v.squared_length());
  if(length == 0.)
    return otherwise.squared_length() > 0. ? unit(otherwise, v) : Normal{{0.f, 0.f, 1.f}};
  return {{static_cast<float>(v.x() / length), static_cast<float>(v.y() / length), static_cast<float>(v.z() / length)}};
}

Kernel::Vector_3 normal_of(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Kernel::Point_3& p = mesh.point(mesh.source(h));
  return CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
}

// The vertices of the charts, once for each normal there.
struct Vertices
{
  std::vector<std::pair<const Chart*, Mesh::Vertex_index>> places;
  std::vector<Normal> normals;        // zero if there are none
  std::vector<std::uint32_t> corners; // three for each face
};

// `numbers` are those of the normals at the corners, if there are any.
Vertices vertices_of(const Atlas& atlas, const std::vector<std::size_t>& numbers,
                     const std::vector<Kernel::Vector_3>& normals)
{
  Vertices result;
  std::map<std::tuple<const Chart*, Mesh::Vertex_index, Normal>, std::uint32_t> known;
  for(const auto& chart : atlas.charts)
    for(const Mesh::Face_index f : chart->disk.faces())
      for(const Mesh::Vertex_index v : chart->disk.vertices_around_face(chart->disk.halfedge(f)))
      {
        const Normal normal =
          numbers.empty() ? Normal() : unit(normals[numbers[result.corners.size()]], normal_of(chart->disk, f));
        const auto size = static_cast<std::uint32_t>(result.places.size());
        const auto [at, is_new] = known.insert({{chart.get(), v, normal}, size});
        if(is_new)
        {
          result.places.emplace_back(chart.get(), v);
          result.normals.push_back(normal);
        }
        result.corners.push_back(at->second);
      }
  return result;
}

// Positions, texture coordinates, corners, and normals if there are any.
Json accessors_of(const Vertices& vertices, bool has_normals, Buffer& buffer)
{
  constexpr int floats = 5126, integers = 5125, of_vertices = 34962, of_faces = 34963;
  std::array<float, 3> low, high;
  low.fill((std::numeric_limits<float>::max)());
  high.fill(std::numeric_limits<float>::lowest());
  for(const auto& [chart, v] : vertices.places)
    for(int i = 0; i < 3; ++i)
    {
      const double x = chart->disk.point(v)[i];
      append(x, buffer.bytes);
      low[i] = (std::min)(low[i], static_cast<float>(x));
      high[i] = (std::max)(high[i], static_cast<float>(x));
    }
  buffer.end_part(of_vertices);
  for(const auto& [chart, v] : vertices.places)
  {
    append(chart->uv[v].x(), buffer.bytes);
    append(1. - chart->uv[v].y(), buffer.bytes); // images begin at their top
  }
  buffer.end_part(of_vertices);
  for(const std::uint32_t corner : vertices.corners)
    append(corner, buffer.bytes);
  buffer.end_part(of_faces);
  Json positions = accessor(0, floats, vertices.places.size(), "VEC3");
  positions["min"] = low;
  positions["max"] = high;
  Json result = list(positions);
  result.push_back(accessor(1, floats, vertices.places.size(), "VEC2"));
  result.push_back(accessor(2, integers, vertices.corners.size(), "SCALAR"));
  if(!has_normals)
    return result;
  for(const Normal& normal : vertices.normals)
    for(const float x : normal)
      append(double(x), buffer.bytes);
  buffer.end_part(of_vertices);
  result.push_back(accessor(3, floats, vertices.places.size(), "VEC3"));
  return result;
}

} // namespace

void write_glb(std::ostream& os, const Atlas& atlas, const Input_mesh& input, const File_content& content,
               const std::string& texture)
{
  const Corner_normals normals = atlas.splits_faces ? Corner_normals() : normals_of_file(content);
  Buffer buffer;
  Json file;
  file["asset"] = {{"version", "2.0"}, {"generator", "cut_locus"}};
  file["scene"] = 0;
  file["scenes"] = list({{"nodes", list(0)}});
  file["nodes"] = list({{"mesh", 0}});
  const std::vector<std::size_t> at_corners = normals_of_charts(atlas, input, content.soup, normals);
  file["accessors"] = accessors_of(vertices_of(atlas, at_corners, normals.normals), !at_corners.empty(), buffer);
  Json attributes = {{"POSITION", 0}, {"TEXCOORD_0", 1}};
  if(!at_corners.empty())
    attributes["NORMAL"] = 3;
  file["meshes"] = list({{"primitives", list({{"attributes", attributes}, {"indices", 2}, {"material", 0}})}});
  const Json color = {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.}};
  file["materials"] = list({{"name", "checker"}, {"pbrMetallicRoughness", color}});
  file["textures"] = list({{"source", 0}});
  file["images"] = list({{"bufferView", buffer.views.size()}, {"mimeType", "image/png"}});
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
