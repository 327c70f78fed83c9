// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CUT_LOCI_TEST_OCTAHEDRON_3MF_H
#define CUT_LOCI_TEST_OCTAHEDRON_3MF_H

#include <boost/crc.hpp>

#include <cstdint>
#include <string>

// An octahedron as slicers write parts: twice as large, at (10, 0, 5), by an object that has it as a component. The file is
// an archive, as ZIP without compression.
inline std::string octahedron_3mf()
{
  std::string archive, directory;
  std::uint32_t number_of_files = 0;
  const auto little = [](std::uint32_t value, int bytes)
  {
    std::string result;
    for(int i = 0; i < bytes; ++i)
      result += static_cast<char>(value >> (8 * i) & 255u);
    return result;
  };
  const auto add = [&](const std::string& name, const std::string& text)
  {
    boost::crc_32_type sum;
    sum.process_bytes(text.data(), text.size());
    const std::string size = little(static_cast<std::uint32_t>(text.size()), 4);
    const std::string head = little(20, 2) + std::string(8, '\0') + little(sum.checksum(), 4) + size + size +
                             little(static_cast<std::uint32_t>(name.size()), 2) + std::string(2, '\0');
    directory += "PK\1\2" + little(20, 2) + head + std::string(10, '\0') +
                 little(static_cast<std::uint32_t>(archive.size()), 4) + name;
    archive += "PK\3\4" + head + name + text;
    ++number_of_files;
  };
  add("_rels/.rels",
      "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" "
      "Target=\"/3D/3dmodel.model\" Id=\"rel0\"/></Relationships>");
  std::string model =
    "<?xml version=\"1.0\"?><model unit=\"millimeter\" "
    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources><object id=\"1\" type=\"model\">"
    "<mesh><vertices>";
  for(const char* p : {"x=\"1\" y=\"0\" z=\"0\"", "x=\"-1\" y=\"0\" z=\"0\"", "x=\"0\" y=\"1\" z=\"0\"",
                       "x=\"0\" y=\"-1\" z=\"0\"", "x=\"0\" y=\"0\" z=\"1\"", "x=\"0\" y=\"0\" z=\"-1\""})
    model += std::string("<vertex ") + p + "/>";
  model += "</vertices><triangles>";
  for(const std::string f : {"024", "214", "134", "304", "205", "125", "315", "035"})
    model += "<triangle v1=\"" + f.substr(0, 1) + "\" v2=\"" + f.substr(1, 1) + "\" v3=\"" + f.substr(2, 1) + "\"/>";
  add("3D/3dmodel.model",
      model + "</triangles></mesh></object><object id=\"2\" type=\"model\"><components><component objectid=\"1\" "
              "transform=\"2 0 0 0 2 0 0 0 2 10 0 0\"/></components></object></resources><build><item objectid=\"2\" "
              "transform=\"1 0 0 0 1 0 0 0 1 0 0 5\"/></build></model>");
  const std::string number = little(number_of_files, 2);
  return archive + directory + "PK\5\6" + std::string(4, '\0') + number + number +
         little(static_cast<std::uint32_t>(directory.size()), 4) +
         little(static_cast<std::uint32_t>(archive.size()), 4) + std::string(2, '\0');
}

#endif // CUT_LOCI_TEST_OCTAHEDRON_3MF_H
