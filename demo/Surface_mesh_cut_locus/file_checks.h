// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H

#include <string>

// The name of a mesh that is read from standard input, and of an output that is written to standard output.
constexpr char standard_stream[] = "-";

// A file as it is, and what format it is taken for.
struct Mesh_file
{
  std::string name, extension, text;
};

std::string input_formats();                        // " .off .obj ...": those with readers here, and scenes
bool is_scene_format(const std::string& extension); // which another library reads

// Reads a file, or standard input, and looks at it before CGAL's readers do: they believe the numbers in its header. The
// format is that of the extension, or of the first words, unless one is given. Throws `std::runtime_error` with the cause.
Mesh_file load_file(const std::string& filename, const std::string& format);

// throws `std::runtime_error` with the cause
[[noreturn]] void refuse_file(const std::string& filename, const std::string& cause);

enum class Off_layout {
  TEXT,
  TEXT_WITH_ATTRIBUTES, // colors, normals or textures of the vertices
  BINARY,               // big endian, as it should be
  BINARY_LITTLE_ENDIAN
};

Off_layout off_layout(const std::string& text);

// The same file in the other byte order: all that follows its first line are words of four bytes.
std::string with_swapped_bytes(std::string text);

// The same file without the letters for attributes: CGAL reads a line for each vertex, and beyond its end if it has
// fewer numbers than these letters announce.
std::string without_attributes(std::string text);

// The vertices and faces of an OBJ file, one a line, with blanks between words: CGAL refuses keywords that it does not
// know, as those of lines, and knows neither tabs nor lines that go on in the next one.
std::string plain_obj(std::string text);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_FILE_CHECKS_H
