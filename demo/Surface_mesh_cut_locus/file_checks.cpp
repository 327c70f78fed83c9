// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "file_checks.h"

#include <CGAL/IO/OFF/File_header_OFF.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& filename, const std::string& cause)
{
  throw std::runtime_error("cannot read '" + filename + "': " + cause);
}

void check_kind(const std::string& filename)
{
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  if(status.type() == fs::file_type::not_found || status.type() == fs::file_type::none)
    refuse(filename, error ? error.message() : std::strerror(ENOENT));
  if(fs::is_directory(status))
    refuse(filename, "it is a directory");
  if(fs::is_fifo(status) || fs::is_socket(status))
    refuse(filename, "it is a pipe, which can not be read twice: write it to a file first");
  if(!fs::is_regular_file(status))
    refuse(filename, "it is a device, not a file");
  errno = 0;
  if(!std::ifstream(filename))
    refuse(filename, errno ? std::strerror(errno) : "it can not be opened");
}

void check_extension(const std::string& filename)
{
  const std::string extension = file_extension(filename);
  std::vector<std::string> known = {".off", ".obj", ".stl", ".ply", ".ts"};
#ifdef CGAL_USE_VTK
  known.push_back(".vtp");
#endif
  if(std::find(known.begin(), known.end(), extension) != known.end())
    return;
  std::string list;
  for(const std::string& e : known)
    list += " " + e;
  refuse(filename,
         "its extension must be one of" + list + ": other formats have to be converted first, as by MeshLab or meshio");
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
  refuse(filename, cause.str());
}

void check_off(const std::string& filename, std::size_t size)
{
  std::istringstream swapped;
  std::ifstream file(filename, std::ios_base::binary);
  std::istream* is = &file;
  if(off_layout(filename) == Off_layout::BINARY_LITTLE_ENDIAN)
  {
    swapped.str(with_swapped_bytes(file));
    is = &swapped;
  }
  CGAL::File_header_OFF header;
  *is >> header;
  if(is->fail())
    refuse(filename, "its header is damaged, or not of the format OFF");
  if(header.skel())
    refuse(filename, "the format SKEL has polylines, not faces");
  if(header.n_dimensional())
    refuse(filename, "the format nOFF has points of any dimension: write it as OFF, with three coordinates");
  // the shortest are "0 0 0\n" and "0\n"
  const double vertex = header.binary() ? 12. : 6., face = header.binary() ? 8. : 2.;
  check_count(filename, "vertices", static_cast<double>(header.size_of_vertices()), vertex, size);
  check_count(filename, "faces", static_cast<double>(header.size_of_facets()), face, size);
}

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

// Number of bytes of a type of PLY, and whether it is one of whole numbers without sign; 0 for an unknown one.
std::size_t ply_size(const std::string& type)
{
  for(const char* name : {"char", "int8", "uchar", "uint8"})
    if(type == name)
      return 1;
  for(const char* name : {"short", "int16", "ushort", "uint16"})
    if(type == name)
      return 2;
  for(const char* name : {"int", "int32", "uint", "uint32", "float", "float32"})
    if(type == name)
      return 4;
  for(const char* name : {"double", "float64"})
    if(type == name)
      return 8;
  return 0;
}

struct Ply_property
{
  std::string name;
  std::size_t size = 0;      // bytes of a value
  std::size_t list_size = 0; // bytes of the length of a list, 0 if it is none
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
};

Ply_property read_property(std::istream& words, const std::string& filename)
{
  Ply_property property;
  std::string type;
  words >> type;
  if(type == "list")
  {
    std::string length;
    words >> length >> type;
    property.list_size = ply_size(length);
    if(property.list_size == 0 || property.list_size > 4 || length.compare(0, 5, "float") == 0)
      refuse(filename, "a list of its header has a length of the type '" + length + "'");
  }
  property.size = ply_size(type);
  if(property.size == 0)
    refuse(filename, "its header has a property of the unknown type '" + type + "'");
  if(!(words >> property.name))
    refuse(filename, "a property of its header has no name");
  return property;
}

Ply_header read_ply_header(std::istream& is, const std::string& filename)
{
  Ply_header header;
  std::string line, word;
  std::getline(is, line);
  if(!(std::istringstream(line) >> word) || word != "ply")
    refuse(filename, "it does not start with 'ply', as files of this format do");
  std::getline(is, line);
  std::istringstream format(line);
  format >> word >> word;
  if(word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
    refuse(filename, "the second line of a PLY file must name one of its three formats");
  header.format = word == "ascii"                  ? Ply_format::ASCII
                  : word == "binary_little_endian" ? Ply_format::BINARY_LITTLE_ENDIAN
                                                   : Ply_format::BINARY_BIG_ENDIAN;
  while(std::getline(is, line))
  {
    std::istringstream words(line);
    word.clear();
    words >> word;
    if(word == "end_header")
      return header;
    if(word == "element")
    {
      header.elements.emplace_back();
      Ply_element& element = header.elements.back();
      std::string count;
      words >> element.name >> count;
      if(count.empty() || count.size() > 18 || count.find_first_not_of("0123456789") != std::string::npos)
        refuse(filename, "its header has an element without a number of items");
      element.count = std::stoull(count);
    }
    else if(word == "property")
    {
      if(header.elements.empty())
        refuse(filename, "its header has a property before the first element");
      header.elements.back().properties.push_back(read_property(words, filename));
    }
  }
  refuse(filename, "its header does not end");
}

// A number of at most four bytes; CGAL takes one with a sign for a huge one.
std::uint64_t read_length(std::istream& is, std::size_t size, Ply_format format)
{
  if(format == Ply_format::ASCII)
  {
    std::uint64_t length = 0;
    is >> length;
    return length;
  }
  std::array<unsigned char, 4> bytes = {};
  is.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if(format == Ply_format::BINARY_BIG_ENDIAN)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  return boost::endian::load_little_u32(bytes.data());
}

void skip(std::istream& is, std::uint64_t number, std::size_t size, Ply_format format)
{
  if(format != Ply_format::ASCII)
    is.ignore(static_cast<std::streamsize>(number * size));
  else
    for(std::string word; number > 0 && is; --number)
      is >> word;
}

// Walks through the lists whose length has four bytes: what a damaged one announces fills the memory.
void check_ply_lists(std::istream& is, const Ply_header& header, const std::string& filename, std::size_t size)
{
  std::size_t last = 0; // after the last element with such a list
  for(std::size_t i = 0; i < header.elements.size(); ++i)
    for(const Ply_property& p : header.elements[i].properties)
      if(p.list_size == 4)
        last = i + 1;
  for(std::size_t i = 0; i < last; ++i)
    for(std::size_t j = 0; j < header.elements[i].count; ++j)
      for(const Ply_property& p : header.elements[i].properties)
      {
        const std::uint64_t number = p.list_size == 0 ? 1 : read_length(is, p.list_size, header.format);
        if(number > size)
          refuse(filename, "it is damaged: item #" + std::to_string(j) + " of '" + header.elements[i].name +
                             "' has a list that is longer than the file");
        skip(is, number, p.size, header.format);
        if(!is)
          refuse(filename, "it is damaged: it ends before item #" + std::to_string(j) + " of '" +
                             header.elements[i].name + "' does");
      }
}

void check_ply(const std::string& filename, std::size_t size)
{
  std::ifstream is(filename, std::ios_base::binary);
  const Ply_header header = read_ply_header(is, filename);
  bool has_faces = false;
  for(const Ply_element& element : header.elements)
  {
    double bytes = 0.;
    for(const Ply_property& p : element.properties)
      bytes += header.format == Ply_format::ASCII ? 2. : static_cast<double>(p.list_size ? p.list_size : p.size);
    check_count(filename, "items of '" + element.name + "'", static_cast<double>(element.count), (std::max)(bytes, 1.),
                size);
    const auto has = [&](const char* name)
    {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const Ply_property& p) { return p.name == name; });
    };
    if((element.name == "vertex" || element.name == "vertices") && !(has("x") && has("y") && has("z")))
      refuse(filename, "its vertices have no coordinates x, y and z");
    if(element.name == "face" || element.name == "faces")
    {
      has_faces = has_faces || element.count > 0;
      if(!has("vertex_indices") && !has("vertex_index"))
        refuse(filename, "its faces have no list 'vertex_indices'");
    }
  }
  if(!has_faces)
    for(const Ply_element& element : header.elements)
      if(element.name.compare(0, 8, "tristrip") == 0)
        refuse(filename, "it has triangle strips instead of faces: write it with faces, as MeshLab does");
  check_ply_lists(is, header, filename, size);
}

} // namespace

std::string file_extension(const std::string& filename)
{
  std::string extension = fs::path(filename).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::size_t check_file(const std::string& filename)
{
  check_kind(filename);
  check_extension(filename);
  const std::size_t size = fs::file_size(filename);
  if(size == 0)
    refuse(filename, "it is empty");
  const std::string extension = file_extension(filename);
  if(extension == ".off")
    check_off(filename, size);
  else if(extension == ".ply")
    check_ply(filename, size);
  return size;
}

Off_layout off_layout(const std::string& filename)
{
  std::ifstream is(filename, std::ios_base::binary);
  CGAL::File_header_OFF header;
  is >> header;
  if(!header.binary())
    return header.has_colors() || header.has_normals() || header.has_textures() ? Off_layout::TEXT_WITH_ATTRIBUTES
                                                                                : Off_layout::TEXT;
  // the one that announces less vertices is right: the other one is huge
  const auto n = static_cast<std::uint32_t>(header.size_of_vertices());
  return n <= boost::endian::endian_reverse(n) ? Off_layout::BINARY : Off_layout::BINARY_LITTLE_ENDIAN;
}

namespace {

std::string read_all(std::istream& is)
{
  std::ostringstream text;
  text << is.rdbuf();
  return text.str();
}

// The position after comments, where the keyword of the format starts.
std::size_t keyword_position(const std::string& text)
{
  std::size_t i = text.find_first_not_of(" \t\r\n");
  while(i < text.size() && text[i] == '#')
    i = text.find_first_not_of(" \t\r\n", text.find('\n', i));
  return (std::min)(i, text.size());
}

} // namespace

std::string with_swapped_bytes(std::istream& is)
{
  std::string text = read_all(is);
  const std::size_t end_of_line = text.find('\n', keyword_position(text));
  for(std::size_t i = end_of_line; i < text.size() && text.size() - i > 4; i += 4)
    std::reverse(text.begin() + static_cast<std::ptrdiff_t>(i + 1), text.begin() + static_cast<std::ptrdiff_t>(i + 5));
  return text;
}

std::string without_attributes(std::istream& is)
{
  std::string text = read_all(is);
  const std::size_t start = keyword_position(text), keyword = text.find("OFF", start);
  if(keyword != std::string::npos)
    text.replace(start, keyword - start, text.find('4', start) < keyword ? "4" : "");
  return text;
}

std::string plain_obj(std::istream& is)
{
  std::string text = read_all(is);
  std::replace(text.begin(), text.end(), '\t', ' ');
  for(std::size_t i = text.find("\\\n"); i != std::string::npos; i = text.find("\\\n", i))
    text.replace(i, 2, "  ");
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
