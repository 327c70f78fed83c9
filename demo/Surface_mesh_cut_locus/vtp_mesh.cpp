// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "vtp_mesh.h"

#include <boost/interprocess/streams/bufferstream.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstdlib>

namespace {

using boost::property_tree::ptree;

// The numbers of an array that is a child of `part`; of a nameless one if there is no name.
std::vector<double> read_array(const ptree& part, const std::string& name, const std::string& filename)
{
  for(const auto& [tag, array] : part)
  {
    if(tag != "DataArray" || (!name.empty() && array.get("<xmlattr>.Name", "") != name))
      continue;
    if(array.get("<xmlattr>.format", "ascii") != "ascii")
      refuse_file(filename, "its arrays are not of the format 'ascii': write it as text");
    std::vector<double> result;
    const char* at = array.data().c_str();
    for(char* end = nullptr;; at = end)
    {
      const double x = std::strtod(at, &end);
      if(end == at)
        break;
      result.push_back(x);
    }
    if(std::string(at).find_first_not_of(" \t\r\n") != std::string::npos)
      refuse_file(filename, "it is damaged: an array has something else than numbers");
    return result;
  }
  return {};
}

void add_piece(const ptree& piece, const std::string& filename, Polygon_soup& soup)
{
  const ptree none;
  const std::size_t first = soup.points.size();
  const std::vector<double> points = read_array(piece.get_child("Points", none), "", filename);
  const ptree& polygons = piece.get_child("Polys", none);
  const std::vector<double> corners = read_array(polygons, "connectivity", filename);
  if(points.size() % 3 != 0)
    refuse_file(filename, "it is damaged: its points have no three coordinates each");
  if(piece.get("<xmlattr>.NumberOfStrips", "0") != "0")
    refuse_file(filename, "it has triangle strips: write it with polygons");
  for(std::size_t i = 0; i < points.size(); i += 3)
    soup.points.emplace_back(points[i], points[i + 1], points[i + 2]);
  double begin = 0.;
  for(const double end : read_array(polygons, "offsets", filename))
  {
    if(!(end >= begin && end <= static_cast<double>(corners.size())))
      refuse_file(filename, "it is damaged: its offsets do not fit its polygons");
    soup.polygons.emplace_back();
    for(auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      if(!(corners[i] >= 0. && corners[i] < static_cast<double>(points.size() / 3)))
        refuse_file(filename, "it is damaged: a polygon has a vertex that does not exist");
      soup.polygons.back().push_back(first + static_cast<std::size_t>(corners[i]));
    }
    begin = end;
  }
}

// The parser calls itself for each level.
void check_depth(const Mesh_file& file)
{
  constexpr std::ptrdiff_t enough = 1000;
  std::ptrdiff_t depth = 0;
  for(std::size_t i = 0; i + 1 < file.text.size(); ++i)
    if(file.text[i] == '<')
    {
      depth += file.text[i + 1] == '/' ? -1 : file.text[i + 1] == '?' || file.text[i + 1] == '!' ? 0 : 1;
      if(depth > enough)
        refuse_file(file.name, "it is damaged: too many elements are open");
    }
    else if(file.text[i] == '/' && file.text[i + 1] == '>')
      --depth;
}

} // namespace

Polygon_soup read_VTP(const Mesh_file& file)
{
  check_depth(file);
  ptree tree;
  try
  {
    boost::interprocess::ibufferstream is(file.text.data(), file.text.size());
    boost::property_tree::read_xml(is, tree);
  }
  catch(const boost::property_tree::xml_parser_error& error)
  {
    refuse_file(file.name, "it is damaged: " + error.message() + " in line " + std::to_string(error.line()));
  }
  const ptree none;
  if(tree.get("VTKFile.<xmlattr>.type", "") != "PolyData")
    refuse_file(file.name, "it has no data of the type PolyData");
  Polygon_soup soup;
  for(const auto& [tag, piece] : tree.get_child("VTKFile.PolyData", none))
    if(tag == "Piece")
      add_piece(piece, file.name, soup);
  return soup;
}
