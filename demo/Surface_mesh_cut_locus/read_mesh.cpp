// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input_mesh.h"
#include "Ply_header.h"
#include "file_checks.h"
#include "scene_mesh.h"
#include "text_meshes.h"
#include "vtp_mesh.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>
#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <boost/interprocess/streams/bufferstream.hpp>

#include <algorithm>
#include <istream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

using boost::interprocess::ibufferstream;

// CGAL's readers make room for as many corners as a damaged file announces.
class Bounded_polygon : public std::vector<std::size_t>
{
public:
  void resize(std::size_t n)
  {
    if(n > maximum)
      throw std::length_error("a face has more corners than its file has bytes");
    std::vector<std::size_t>::resize(n);
  }

  static std::size_t maximum;
};

std::size_t Bounded_polygon::maximum = (std::numeric_limits<std::size_t>::max)();

// CGAL 5.5 leaves the colors that end a face in the stream, so the faces are read one by one.
bool read_binary_OFF(std::istream& is, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons,
                     bool has_colors)
{
  points.clear();
  polygons.clear();
  CGAL::File_scanner_OFF scanner(is);
  for(std::size_t i = 0; is && i < scanner.size_of_vertices(); ++i)
  {
    double x = 0., y = 0., z = 0., w = 1.;
    scanner.scan_vertex(x, y, z, w);
    points.emplace_back(x / w, y / w, z / w);
    scanner.skip_to_next_vertex(i);
  }
  for(std::size_t i = 0; is && i < scanner.size_of_facets(); ++i)
  {
    std::size_t n = 0;
    scanner.scan_facet(n, i);
    polygons.emplace_back();
    polygons.back().resize(n);
    for(std::size_t j = 0; is && j < n; ++j)
      scanner.scan_facet_vertex_index(polygons.back()[j], j + 1, i);
    if(is && has_colors)
      scanner.skip_to_next_facet(i);
  }
  return !is.fail() && (has_colors || is.peek() == std::istream::traits_type::eof());
}

// In the format, the number of its colors ends each face, if only 0. OpenMesh and PMP leave it away.
bool read_binary_OFF(std::istream& is, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons)
{
  CGAL::IO::set_binary_mode(is);
  const std::istream::pos_type begin = is.tellg();
  try
  {
    if(read_binary_OFF(is, points, polygons, true))
      return true;
  }
  catch(const std::length_error&) // another number has been taken for that of the corners
  {
  }
  is.clear();
  is.seekg(begin);
  return read_binary_OFF(is, points, polygons, false);
}

bool read_OFF(const std::string& text, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons)
{
  const Off_layout layout = off_layout(text);
  std::string changed;
  if(layout == Off_layout::BINARY_LITTLE_ENDIAN)
    changed = with_swapped_bytes(text);
  else if(layout == Off_layout::TEXT_WITH_ATTRIBUTES)
    changed = without_attributes(text);
  const std::string& known = changed.empty() ? text : changed;
  ibufferstream is(known.data(), known.size());
  return layout == Off_layout::BINARY || layout == Off_layout::BINARY_LITTLE_ENDIAN
           ? read_binary_OFF(is, points, polygons)
           : CGAL::IO::read_OFF(is, points, polygons, CGAL::parameters::verbose(false));
}

bool read_PLY(const Mesh_file& file, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons)
{
  ibufferstream is(file.text.data(), file.text.size());
  const Ply_header header(is, file.name);
  const auto has_some = [&](bool (Ply_element::*is_kind)() const)
  {
    return std::any_of(header.elements.begin(), header.elements.end(),
                       [&](const Ply_element& e) { return (e.*is_kind)() && e.count > 0; });
  };
  // CGAL's reader takes some clouds of points for damaged files
  if(has_some(&Ply_element::is_vertex) && !has_some(&Ply_element::is_face))
    throw std::runtime_error("'" + file.name + "': there are no faces in it");
  if(!header.is_known_to_cgal())
  {
    std::istringstream plain(plain_ply(is, header));
    return CGAL::IO::read_PLY(plain, points, polygons, CGAL::parameters::verbose(false));
  }
  is.clear();
  is.seekg(0);
  CGAL::IO::set_binary_mode(is);
  return CGAL::IO::read_PLY(is, points, polygons, CGAL::parameters::verbose(false));
}

bool read_STL(const std::string& text, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons)
{
  // Of what begins with blanks, or has a tab after the first word, CGAL reads a few bytes as numbers.
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const bool begins_otherwise =
    start != std::string::npos && text.compare(start, 5, "solid") == 0 && (start > 0 || text.compare(5, 1, "\t") == 0);
  const std::string usual = begins_otherwise ? "solid " + text.substr(start + 5) : std::string();
  const std::string& read = begins_otherwise ? usual : text;
  for(const auto mode : {CGAL::IO::BINARY, CGAL::IO::ASCII})
  {
    points.clear();
    polygons.clear();
    ibufferstream is(read.data(), read.size());
    CGAL::IO::set_mode(is, mode);
    if(CGAL::IO::read_STL(is, points, polygons, CGAL::parameters::verbose(false)))
      return true;
  }
  return false;
}

bool read_file(const Mesh_file& file, std::vector<Kernel::Point_3>& points, std::vector<Bounded_polygon>& polygons)
{
  if(file.extension == ".off")
    return read_OFF(file.text, points, polygons);
  if(file.extension == ".ply")
    return read_PLY(file, points, polygons);
  if(file.extension == ".stl")
    return read_STL(file.text, points, polygons);
  if(file.extension == ".obj")
  {
    std::istringstream plain(plain_obj(file.text));
    return CGAL::IO::read_OBJ(plain, points, polygons, CGAL::parameters::verbose(false));
  }
  ibufferstream is(file.text.data(), file.text.size());
  return CGAL::IO::read_GOCAD(is, points, polygons, CGAL::parameters::verbose(false));
}

bool read_plain_file(const Mesh_file& file, Polygon_soup& soup)
{
  if(file.extension == ".off")
    return read_plain_OFF(file.text, soup);
  return file.extension == ".obj" && read_plain_OBJ(file.text, soup);
}

Polygon_soup read_polygon_soup(const Mesh_file& file)
{
  Polygon_soup soup;
  if(read_plain_file(file, soup))
    return soup;
  soup = Polygon_soup();
  Bounded_polygon::maximum = file.text.size();
  std::vector<Bounded_polygon> polygons;
  bool is_read = false;
  try
  {
    is_read = read_file(file, soup.points, polygons);
  }
  catch(const std::length_error&) // as if it could not be read
  {
  }
  if(!is_read)
    refuse_file(file.name, "it is damaged, or not of the format " + file.extension.substr(1));
  soup.polygons.assign(std::make_move_iterator(polygons.begin()), std::make_move_iterator(polygons.end()));
  return soup;
}

} // namespace

Input_mesh read_mesh(const std::string& filename, Repair repair, const std::string& format, File_content* content)
{
  std::optional<Mesh_file> file = load_file(filename, format);
  const std::string name = file->name;
  Polygon_soup soup = is_scene_format(file->extension) ? read_scene(*file)
                      : file->extension == ".vtp"      ? read_VTP(*file)
                                                       : read_polygon_soup(*file);
  if(content != nullptr && file->extension == ".obj")
    content->obj = std::move(file->text);
  file.reset(); // its text is not needed any more
  Input_mesh result = make_mesh(soup, repair, name);
  if(content != nullptr)
    content->soup = std::move(soup);
  return result;
}
