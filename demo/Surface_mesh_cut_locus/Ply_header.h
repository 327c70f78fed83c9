// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_PLY_HEADER_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_PLY_HEADER_H

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

struct Ply_type
{
  enum Kind { SIGNED, UNSIGNED, FLOATING } kind = FLOATING;
  std::size_t size = 0; // bytes of a value, 0 if there is none
};

struct Ply_property
{
  std::string name;
  Ply_type type;
  Ply_type length; // of a list, else without size

  bool is_list() const { return length.size > 0; }
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  bool has(const std::string& property) const;
  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
};

// What a PLY file announces. `is` is left where the items start. It throws `std::runtime_error` with the cause if it is
// not one; `filename` is for that.
struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  bool has_old_line_ends = false; // '\r' alone, as on the Mac before 2001, and in files of Rhinoceros
  std::vector<Ply_element> elements;

  Ply_header(std::istream& is, const std::string& filename);

  // CGAL's reader knows coordinates that are floating point numbers, and lists of numbers of four bytes in faces, and
  // crashes, or fails, with other ones.
  bool is_known_to_cgal() const;

  // an item's next number
  double read(std::istream& is, const Ply_type& type) const;
  void skip(std::istream& is, std::size_t number, const Ply_type& type) const;
};

// the same vertices and faces in a PLY file that CGAL reads
std::string plain_ply(std::istream& is, const Ply_header& header);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_PLY_HEADER_H
