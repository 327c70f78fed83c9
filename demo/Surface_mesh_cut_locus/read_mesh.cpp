// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace {

using Points = std::vector<Kernel::Point_3>;
using Polygons = std::vector<std::vector<std::size_t>>;

void check_file(const std::string& filename)
{
  if(std::filesystem::is_directory(filename))
    throw std::runtime_error("cannot read '" + filename + "': it is a directory");
  errno = 0;
  if(!std::ifstream(filename))
    throw std::runtime_error("cannot read '" + filename + "'" +
                             (errno ? std::string(": ") + std::strerror(errno) : ""));
  std::string extension = std::filesystem::path(filename).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  std::vector<std::string> known = {".off", ".obj", ".stl", ".ply", ".ts"};
#ifdef CGAL_USE_VTK
  known.push_back(".vtp");
#endif
  if(std::find(known.begin(), known.end(), extension) != known.end())
    return;
  std::string list;
  for(const std::string& e : known)
    list += " " + e;
  throw std::runtime_error("cannot read '" + filename + "': its extension must be one of" + list);
}

void check_polygons(const std::string& filename, const Points& points, const Polygons& polygons)
{
  const std::string where = "'" + filename + "': ";
  if(points.empty())
    throw std::runtime_error(where + "there are no vertices in it");
  if(polygons.empty())
    throw std::runtime_error(where + "there are no faces in it");
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const std::string face = where + "face #" + std::to_string(i);
    for(std::size_t v : polygons[i])
      if(v >= points.size())
        throw std::runtime_error(face + " refers to a vertex that does not exist");
    if(polygons[i].size() != 3)
      throw std::runtime_error(face + " has " + std::to_string(polygons[i].size()) + " sides; all must be triangles");
    const std::vector<std::size_t>& t = polygons[i];
    if(t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw std::runtime_error(face + " has a vertex twice");
  }
  if(!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons))
    throw std::runtime_error(where + "an edge belongs to more than two faces, or to two of opposite orientation");
}

} // namespace

// A polygon soup keeps the order of the vertices, isolated ones included, and allows to tell what is wrong.
Mesh read_mesh(const std::string& filename)
{
  check_file(filename);
  Points points;
  Polygons polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons, CGAL::parameters::verbose(false)))
    throw std::runtime_error("cannot read '" + filename + "': it is damaged, or not of the format of its extension");
  check_polygons(filename, points, polygons);

  Mesh mesh;
  mesh.reserve(points.size(), 3 * polygons.size(), polygons.size());
  for(const Kernel::Point_3& p : points)
    mesh.add_vertex(p);
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const auto vertex = [&](int j) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(polygons[i][j])); };
    if(mesh.add_face(vertex(0), vertex(1), vertex(2)) == Mesh::null_face())
      throw std::runtime_error("'" + filename + "': face #" + std::to_string(i) +
                               " meets others at a vertex that is not manifold");
  }
  return mesh;
}
