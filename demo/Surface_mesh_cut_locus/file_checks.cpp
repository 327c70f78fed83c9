// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "file_checks.h"

#include "Ply_header.h"

#include <CGAL/IO/OFF/File_header_OFF.h>

#include <boost/endian/conversion.hpp>
#include <boost/interprocess/streams/bufferstream.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

namespace fs = std::filesystem;
using boost::interprocess::ibufferstream;

constexpr char own_formats[] = " .off .obj .stl .ply .ts .vtp", scene_formats[] = " .gltf .glb .fbx .dae .3ds .3mf";

bool has_word(const std::string& words, const std::string& word)
{
  return !word.empty() && (words + " ").find(" " + word + " ") != std::string::npos;
}

void check_kind(const std::string& filename)
{
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  if(status.type() == fs::file_type::not_found || status.type() == fs::file_type::none)
    refuse_file(filename, error ? error.message() : std::strerror(ENOENT));
  if(fs::is_directory(status))
    refuse_file(filename, "it is a directory");
  if(fs::is_fifo(status) || fs::is_socket(status))
    refuse_file(filename, "it is a pipe, which may never end: give the mesh on standard input, and - as its name");
  if(!fs::is_regular_file(status))
    refuse_file(filename, "it is a device, not a file");
  errno = 0;
  if(!std::ifstream(filename))
    refuse_file(filename, errno ? std::strerror(errno) : "it can not be opened");
}

// in lower case, with the dot
std::string file_extension(const std::string& filename)
{
  std::string extension = fs::path(filename).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

void check_extension(const std::string& filename, const std::string& extension)
{
  if(!has_word(input_formats(), extension))
    refuse_file(filename,
                "its extension must be one of" + input_formats() +
                  ", unless there is an --input-format: other formats have to be converted first, as by MeshLab or "
                  "meshio");
}

// The position after comments, where the keyword of the format starts.
std::size_t keyword_position(const std::string& text)
{
  std::size_t i = text.find_first_not_of(" \t\r\n");
  while(i < text.size() && text[i] == '#')
    i = text.find_first_not_of(" \t\r\n", text.find('\n', i));
  return (std::min)(i, text.size());
}

bool is_binary_stl(const std::string& text)
{
  constexpr std::size_t header = 84, bytes_of_facet = 50;
  return text.size() >= header &&
         text.size() - header ==
           bytes_of_facet * boost::endian::load_little_u32(reinterpret_cast<const unsigned char*>(text.data()) + 80);
}

// How files of the format start: the extension, or nothing.
std::string extension_by_content(const std::string& text)
{
  const std::size_t start = keyword_position(text);
  const std::string word = text.substr(start, text.find_first_of(" \t\r\n", start) - start);
  const auto is_one_of = [&](const std::vector<std::string>& words)
  { return std::find(words.begin(), words.end(), word) != words.end(); };
  if(is_binary_stl(text) || word == "solid")
    return ".stl";
  if(word == "ply")
    return ".ply";
  if(text.compare(0, 4, "glTF") == 0)
    return ".glb";
  if(text.compare(0, 18, "Kaydara FBX Binary") == 0)
    return ".fbx";
  if(text.compare(0, 4, "PK\3\4") == 0) // an archive, as ZIP
    return ".3mf";
  if(word == "<COLLADA" || (word == "<?xml" && text.substr(0, 1000).find("<COLLADA") != std::string::npos))
    return ".dae";
  if(word == "<?xml" || word == "<VTKFile")
    return ".vtp";
  if(word == "GOCAD")
    return ".ts";
  if(word.size() >= 3 && word.size() <= 8 && word.compare(word.size() - 3, 3, "OFF") == 0)
    return ".off";
  return is_one_of({"v", "vn", "vt", "o", "g", "s", "f", "mtllib", "usemtl"}) ? ".obj" : "";
}

// Both may be damaged, so nothing is multiplied that could overflow.
void check_count(const std::string& filename, const std::string& what, double count, double bytes_of_each,
                 std::size_t size)
{
  if(!(count * bytes_of_each > static_cast<double>(size)))
    return;
  std::ostringstream cause;
  cause.precision(20);
  cause << "it is damaged: its header announces " << count << " " << what << ", more than its " << size
        << " bytes can hold";
  refuse_file(filename, cause.str());
}

void check_off(const Mesh_file& file)
{
  const std::string& filename = file.name;
  const std::size_t size = file.text.size();
  std::string swapped;
  if(off_layout(file.text) == Off_layout::BINARY_LITTLE_ENDIAN)
    swapped = with_swapped_bytes(file.text);
  const std::string& text = swapped.empty() ? file.text : swapped;
  ibufferstream is(text.data(), text.size());
  CGAL::File_header_OFF header;
  is >> header;
  if(is.fail())
    refuse_file(filename, "its header is damaged, or not of the format OFF");
  if(header.skel())
    refuse_file(filename, "the format SKEL has polylines, not faces");
  if(header.n_dimensional())
    refuse_file(filename, "the format nOFF has points of any dimension: write it as OFF, with three coordinates");
  // the shortest are "0 0 0\n" and "0\n"
  const double vertex = header.binary() ? 12. : 6., face = header.binary() ? 8. : 2.;
  check_count(filename, "vertices", static_cast<double>(header.size_of_vertices()), vertex, size);
  check_count(filename, "faces", static_cast<double>(header.size_of_facets()), face, size);
}

// Walks through the lists whose length has four bytes: what a damaged one announces fills the memory.
void check_ply_lists(std::istream& is, const Ply_header& header, const std::string& filename, std::size_t size)
{
  std::size_t last = 0; // after the last element with such a list
  for(std::size_t i = 0; i < header.elements.size(); ++i)
    for(const Ply_property& p : header.elements[i].properties)
      if(p.length.size == 4)
        last = i + 1;
  for(std::size_t i = 0; i < last; ++i)
    for(std::size_t j = 0; j < header.elements[i].count; ++j)
      for(const Ply_property& p : header.elements[i].properties)
      {
        const double number = p.is_list() ? header.read(is, p.length) : 1.;
        if(!(number >= 0. && number <= static_cast<double>(size)))
          refuse_file(filename, "it is damaged: item #" + std::to_string(j) + " of '" + header.elements[i].name +
                                  "' has a list that is longer than the file");
        header.skip(is, static_cast<std::size_t>(number), p.type);
        if(!is)
          refuse_file(filename, "it is damaged: it ends before item #" + std::to_string(j) + " of '" +
                                  header.elements[i].name + "' does");
      }
}

void check_ply(const Mesh_file& file)
{
  const std::string& filename = file.name;
  const std::size_t size = file.text.size();
  ibufferstream is(file.text.data(), size);
  const Ply_header header(is, filename);
  bool has_faces = false;
  for(const Ply_element& element : header.elements)
  {
    double bytes = 0.;
    for(const Ply_property& p : element.properties)
      bytes += header.format == Ply_format::ASCII ? 2. : static_cast<double>(p.is_list() ? p.length.size : p.type.size);
    check_count(filename, "items of '" + element.name + "'", static_cast<double>(element.count), (std::max)(bytes, 1.),
                size);
    if(element.is_vertex() && !(element.has("x") && element.has("y") && element.has("z")))
      refuse_file(filename, "its vertices have no coordinates x, y and z");
    if(element.is_face())
    {
      has_faces = has_faces || element.count > 0;
      if(!element.has("vertex_indices") && !element.has("vertex_index"))
        refuse_file(filename, "its faces have no list 'vertex_indices'");
    }
  }
  if(!has_faces)
    for(const Ply_element& element : header.elements)
      if(element.name.compare(0, 8, "tristrip") == 0)
        refuse_file(filename, "it has triangle strips instead of faces: write it with faces, as MeshLab does");
  check_ply_lists(is, header, filename, size);
}

} // namespace

void refuse_file(const std::string& filename, const std::string& cause)
{
  throw std::runtime_error("cannot read '" + filename + "': " + cause);
}

std::string input_formats()
{
  return std::string(own_formats) + scene_formats;
}

bool is_scene_format(const std::string& extension)
{
  return has_word(scene_formats, extension);
}

Mesh_file load_file(const std::string& filename, const std::string& format)
{
  const bool is_standard_input = filename == standard_stream;
  Mesh_file file{is_standard_input ? "standard input" : filename, format.empty() ? "" : "." + format, ""};
  if(is_standard_input)
    file.text.assign(std::istreambuf_iterator<char>(std::cin), {});
  else
  {
    check_kind(filename);
    if(format.empty())
      check_extension(filename, file.extension = file_extension(filename));
    file.text.resize(fs::file_size(filename));
    if(!std::ifstream(filename, std::ios_base::binary)
          .read(file.text.data(), static_cast<std::streamsize>(file.text.size())))
      refuse_file(filename, "it cannot be read to its end");
  }
  if(file.text.empty())
    refuse_file(file.name, "it is empty");
  if(file.extension.empty() && (file.extension = extension_by_content(file.text)).empty())
    refuse_file(file.name, "it does not start as files of a known format do: say --input-format");
  if(file.extension == ".off")
    check_off(file);
  else if(file.extension == ".ply")
    check_ply(file);
  return file;
}

Off_layout off_layout(const std::string& text)
{
  ibufferstream is(text.data(), text.size());
  CGAL::File_header_OFF header;
  is >> header;
  if(!header.binary())
    return header.has_colors() || header.has_normals() || header.has_textures() ? Off_layout::TEXT_WITH_ATTRIBUTES
                                                                                : Off_layout::TEXT;
  // the one that announces less vertices is right: the other one is huge
  const auto n = static_cast<std::uint32_t>(header.size_of_vertices());
  return n <= boost::endian::endian_reverse(n) ? Off_layout::BINARY : Off_layout::BINARY_LITTLE_ENDIAN;
}

std::string with_swapped_bytes(std::string text)
{
  const std::size_t end_of_line = text.find('\n', keyword_position(text));
  for(std::size_t i = end_of_line; i < text.size() && text.size() - i > 4; i += 4)
    std::reverse(text.begin() + static_cast<std::ptrdiff_t>(i + 1), text.begin() + static_cast<std::ptrdiff_t>(i + 5));
  return text;
}

std::string without_attributes(std::string text)
{
  const std::size_t start = keyword_position(text), keyword = text.find("OFF", start);
  if(keyword != std::string::npos)
    text.replace(start, keyword - start, text.find('4', start) < keyword ? "4" : "");
  return text;
}

std::string plain_obj(std::string text)
{
  std::replace(text.begin(), text.end(), '\t', ' ');
  for(const std::string end : {"\\\n", "\\\r\n"}) // the line goes on
    for(std::size_t i = text.find(end); i != std::string::npos; i = text.find(end, i))
      text.replace(i, end.size(), end.size(), ' ');
  std::string plain;
  plain.reserve(text.size());
  for(std::size_t start = 0, end = 0; start < text.size(); start = end)
  {
    end = (std::min)(text.find('\n', start), text.size() - 1) + 1;
    const std::size_t word = text.find_first_not_of(' ', start);
    if(word < end - 1 && (text[word] == 'v' || text[word] == 'f') && text[word + 1] == ' ')
      plain.append(text, word, end - word);
  }
  return plain;
}
