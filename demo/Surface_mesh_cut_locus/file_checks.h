// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H

#include <cstddef>
#include <iosfwd>
#include <string>

// Looks at a file before CGAL's readers do: they believe the numbers in its header, and wait for pipes. Returns its size
// in bytes, or throws `std::runtime_error` with the cause.
std::size_t check_file(const std::string& filename);

// throws `std::runtime_error` with the cause
[[noreturn]] void refuse_file(const std::string& filename, const std::string& cause);

// in lower case, with the dot
std::string file_extension(const std::string& filename);

enum class Off_layout {
  TEXT,
  TEXT_WITH_ATTRIBUTES, // colors, normals or textures of the vertices
  BINARY,               // big endian, as it should be
  BINARY_LITTLE_ENDIAN
};

Off_layout off_layout(const std::string& filename);

// The same file in the other byte order: all that follows its first line are words of four bytes.
std::string with_swapped_bytes(std::istream& is);

// The same file without the letters for attributes: CGAL reads a line for each vertex, and beyond its end if it has
// fewer numbers than these letters announce.
std::string without_attributes(std::istream& is);

// The vertices and faces of an OBJ file, one a line, with blanks between words: CGAL refuses keywords that it does not
// know, as those of lines, and knows neither tabs nor lines that go on in the next one.
std::string plain_obj(std::istream& is);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H
