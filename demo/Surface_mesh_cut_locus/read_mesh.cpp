// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Input_mesh.h"
#include "Ply_header.h"
#include "file_checks.h"
#include "text_meshes.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <fstream>
#include <istream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

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

bool read_file(const std::string& filename, std::vector<Kernel::Point_3>& points,
               std::vector<Bounded_polygon>& polygons)
{
  std::ifstream is(filename, std::ios_base::binary);
  if(file_extension(filename) == ".obj")
  {
    std::istringstream plain(plain_obj(is));
    return CGAL::IO::read_OBJ(plain, points, polygons, CGAL::parameters::verbose(false));
  }
  if(file_extension(filename) == ".ply")
  {
    const Ply_header header(is, filename);
    if(!header.is_known_to_cgal())
    {
      std::istringstream plain(plain_ply(is, header));
      return CGAL::IO::read_PLY(plain, points, polygons, CGAL::parameters::verbose(false));
    }
  }
  if(file_extension(filename) != ".off")
    return CGAL::IO::read_polygon_soup(filename, points, polygons, CGAL::parameters::verbose(false));
  switch(off_layout(filename))
  {
  case Off_layout::BINARY:
    return read_binary_OFF(is, points, polygons);
  case Off_layout::BINARY_LITTLE_ENDIAN: {
    std::istringstream swapped(with_swapped_bytes(is));
    return read_binary_OFF(swapped, points, polygons);
  }
  case Off_layout::TEXT_WITH_ATTRIBUTES: {
    std::istringstream plain(without_attributes(is));
    return CGAL::IO::read_OFF(plain, points, polygons, CGAL::parameters::verbose(false));
  }
  default:
    return CGAL::IO::read_OFF(is, points, polygons, CGAL::parameters::verbose(false));
  }
}

bool read_plain_file(const std::string& filename, std::size_t size, Polygon_soup& soup)
{
  const std::string extension = file_extension(filename);
  if(extension != ".off" && extension != ".obj")
    return false;
  std::string text(size, '\0');
  if(!std::ifstream(filename, std::ios_base::binary).read(text.data(), static_cast<std::streamsize>(size)))
    return false;
  return extension == ".off" ? read_plain_OFF(text, soup) : read_plain_OBJ(text, soup);
}

} // namespace

Polygon_soup read_polygon_soup(const std::string& filename)
{
  const std::size_t size = check_file(filename);
  Polygon_soup soup;
  if(read_plain_file(filename, size, soup))
    return soup;
  soup = Polygon_soup();
  Bounded_polygon::maximum = size;
  std::vector<Bounded_polygon> polygons;
  bool is_read = false;
  try
  {
    is_read = read_file(filename, soup.points, polygons);
  }
  catch(const std::length_error&) // as if it could not be read
  {
  }
  if(!is_read)
    throw std::runtime_error("cannot read '" + filename + "': it is damaged, or not of the format of its extension");
  soup.polygons.assign(std::make_move_iterator(polygons.begin()), std::make_move_iterator(polygons.end()));
  return soup;
}

Input_mesh read_mesh(const std::string& filename, Repair repair)
{
  return make_mesh(read_polygon_soup(filename), repair, filename);
}
