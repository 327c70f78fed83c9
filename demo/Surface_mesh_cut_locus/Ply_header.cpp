// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Ply_header.h"

#include "file_checks.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <istream>
#include <sstream>
#include <utility>

namespace {

struct Named_type
{
  const char* name;
  Ply_type type;
};

constexpr std::array<Named_type, 16> types = {{{"char", {Ply_type::SIGNED, 1}},
                                               {"int8", {Ply_type::SIGNED, 1}},
                                               {"uchar", {Ply_type::UNSIGNED, 1}},
                                               {"uint8", {Ply_type::UNSIGNED, 1}},
                                               {"short", {Ply_type::SIGNED, 2}},
                                               {"int16", {Ply_type::SIGNED, 2}},
                                               {"ushort", {Ply_type::UNSIGNED, 2}},
                                               {"uint16", {Ply_type::UNSIGNED, 2}},
                                               {"int", {Ply_type::SIGNED, 4}},
                                               {"int32", {Ply_type::SIGNED, 4}},
                                               {"uint", {Ply_type::UNSIGNED, 4}},
                                               {"uint32", {Ply_type::UNSIGNED, 4}},
                                               {"float", {Ply_type::FLOATING, 4}},
                                               {"float32", {Ply_type::FLOATING, 4}},
                                               {"double", {Ply_type::FLOATING, 8}},
                                               {"float64", {Ply_type::FLOATING, 8}}}};

Ply_type type_of(const std::string& name)
{
  const auto found = std::find_if(types.begin(), types.end(), [&](const Named_type& t) { return t.name == name; });
  return found == types.end() ? Ply_type() : found->type;
}

bool get_line(std::istream& is, std::string& line, char end)
{
  if(!std::getline(is, line, end))
    return false;
  if(!line.empty() && line.back() == '\r')
    line.pop_back();
  return true;
}

// whether the first line, which is short, ends so
bool has_old_line_end(std::istream& is)
{
  std::string line;
  while(is && line.size() < 80 && is.peek() != '\n' && is.peek() != '\r')
    line += static_cast<char>(is.get());
  const bool is_return = is.get() == '\r';
  const bool is_old = is_return && is.peek() != '\n';
  is.clear();
  is.seekg(0);
  return is_old;
}

Ply_property read_property(std::istream& words, const std::string& filename)
{
  Ply_property property;
  std::string type;
  words >> type;
  if(type == "list")
  {
    std::string length;
    words >> length >> type;
    property.length = type_of(length);
    if(property.length.size == 0 || property.length.kind == Ply_type::FLOATING)
      refuse_file(filename, "a list of its header has a length of the type '" + length + "'");
    property.length.kind = Ply_type::UNSIGNED; // as CGAL reads it
  }
  property.type = type_of(type);
  if(property.type.size == 0)
    refuse_file(filename, "its header has a property of the unknown type '" + type + "'");
  if(!(words >> property.name))
    refuse_file(filename, "a property of its header has no name");
  return property;
}

Ply_element read_element(std::istream& words, const std::string& filename)
{
  Ply_element element;
  std::string count;
  words >> element.name >> count;
  if(count.empty() || count.size() > 18 || count.find_first_not_of("0123456789") != std::string::npos)
    refuse_file(filename, "its header has an element without a number of items");
  element.count = std::stoull(count);
  return element;
}

Ply_format read_format(const std::string& line, const std::string& filename)
{
  constexpr std::array<std::pair<const char*, Ply_format>, 3> formats = {
    {{"ascii", Ply_format::ASCII},
     {"binary_little_endian", Ply_format::BINARY_LITTLE_ENDIAN},
     {"binary_big_endian", Ply_format::BINARY_BIG_ENDIAN}}};
  std::istringstream words(line);
  std::string word;
  words >> word >> word;
  for(const auto& [name, format] : formats)
    if(word == name)
      return format;
  refuse_file(filename, "the second line of a PLY file must name one of its three formats");
}

template <typename Number>
void write(std::ostream& os, Number number)
{
  std::array<unsigned char, sizeof(Number)> bytes;
  boost::endian::endian_store<Number, sizeof(Number), boost::endian::order::little>(bytes.data(), number);
  os.write(reinterpret_cast<const char*>(bytes.data()), sizeof(Number));
}

std::uint32_t as_index(double number)
{
  return number >= 0. && number < 4294967295. ? static_cast<std::uint32_t>(number) : 4294967295u;
}

bool is_coordinate(const Ply_element& element, const Ply_property& p)
{
  return element.is_vertex() && (p.name == "x" || p.name == "y" || p.name == "z");
}

bool is_corners(const Ply_element& element, const Ply_property& p)
{
  return element.is_face() && (p.name == "vertex_indices" || p.name == "vertex_index");
}

void copy_corners(std::istream& is, const Ply_header& header, std::size_t number, const Ply_type& type,
                  std::ostream& os)
{
  write(os, static_cast<std::uint32_t>(number));
  for(std::size_t k = 0; k < number && is; ++k)
    write(os, as_index(header.read(is, type)));
}

// without what is neither a coordinate nor a corner
void copy_item(std::istream& is, const Ply_header& header, const Ply_element& element, std::ostream& os)
{
  std::array<double, 3> point = {};
  for(const Ply_property& p : element.properties)
  {
    const auto number = p.is_list() ? static_cast<std::size_t>(header.read(is, p.length)) : std::size_t(1);
    if(is_corners(element, p))
      copy_corners(is, header, number, p.type, os);
    else if(is_coordinate(element, p) && !p.is_list())
      point[static_cast<std::size_t>(p.name.front() - 'x')] = header.read(is, p.type);
    else
      header.skip(is, number, p.type);
  }
  if(element.is_vertex())
    for(double coordinate : point)
      write(os, coordinate);
}

} // namespace

bool Ply_element::has(const std::string& property) const
{
  return std::any_of(properties.begin(), properties.end(), [&](const Ply_property& p) { return p.name == property; });
}

Ply_header::Ply_header(std::istream& is, const std::string& filename) : has_old_line_ends(has_old_line_end(is))
{
  const char end = has_old_line_ends ? '\r' : '\n';
  std::string line, word;
  get_line(is, line, end);
  if(!(std::istringstream(line) >> word) || word != "ply")
    refuse_file(filename, "it does not start with 'ply', as files of this format do");
  get_line(is, line, end);
  format = read_format(line, filename);
  while(get_line(is, line, end))
  {
    std::istringstream words(line);
    word.clear();
    words >> word;
    if(word == "end_header")
      return;
    if(word == "element")
      elements.push_back(read_element(words, filename));
    else if(word == "property")
    {
      if(elements.empty())
        refuse_file(filename, "its header has a property before the first element");
      elements.back().properties.push_back(read_property(words, filename));
    }
  }
  refuse_file(filename, "its header does not end");
}

bool Ply_header::is_known_to_cgal() const
{
  const auto is_unknown = [](const Ply_element& element, const Ply_property& p)
  {
    if(is_coordinate(element, p))
      return p.type.kind != Ply_type::FLOATING || p.is_list();
    if(is_corners(element, p))
      return p.type.kind == Ply_type::FLOATING || p.type.size != 4 || !p.is_list();
    return false;
  };
  return !has_old_line_ends && std::none_of(elements.begin(), elements.end(),
                                            [&](const Ply_element& e)
                                            {
    return std::any_of(e.properties.begin(), e.properties.end(),
                       [&](const Ply_property& p) { return is_unknown(e, p); });
  });
}

double Ply_header::read(std::istream& is, const Ply_type& type) const
{
  if(format == Ply_format::ASCII)
  {
    std::string word;
    is >> word;
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if(end != word.c_str() + word.size())
      is.setstate(std::ios_base::failbit);
    return number;
  }
  std::array<unsigned char, 8> bytes = {};
  is.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(type.size));
  if(format == Ply_format::BINARY_BIG_ENDIAN)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
  namespace endian = boost::endian;
  const unsigned char* b = bytes.data();
  if(type.kind == Ply_type::FLOATING)
    return type.size == 4 ? endian::endian_load<float, 4, endian::order::little>(b)
                          : endian::endian_load<double, 8, endian::order::little>(b);
  const std::uint32_t number = endian::load_little_u32(b);
  if(type.kind == Ply_type::UNSIGNED)
    return number;
  const unsigned shift = static_cast<unsigned>(32 - 8 * type.size); // of the sign to the first bit
  return static_cast<double>(static_cast<std::int32_t>(number << shift) / (std::int32_t(1) << shift));
}

void Ply_header::skip(std::istream& is, std::size_t number, const Ply_type& type) const
{
  if(format != Ply_format::ASCII)
    is.ignore(static_cast<std::streamsize>(number * type.size));
  else
    for(std::string word; number > 0 && is; --number)
      is >> word;
}

std::string plain_ply(std::istream& is, const Ply_header& header)
{
  std::ostringstream os;
  os << "ply\nformat binary_little_endian 1.0\n";
  for(const Ply_element& element : header.elements)
    if(element.is_vertex())
      os << "element vertex " << element.count << "\nproperty double x\nproperty double y\nproperty double z\n";
    else if(element.is_face())
      os << "element face " << element.count << "\nproperty list uint uint vertex_indices\n";
  os << "end_header\n";
  for(const Ply_element& element : header.elements)
    for(std::size_t i = 0; i < element.count && is; ++i)
      copy_item(is, header, element, os);
  return is ? os.str() : std::string(); // or it ends too early
}
