// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_FILE_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_FILE_H

#include <functional>
#include <iosfwd>
#include <string>

// Whatever happens, there is the old file or all of the new one: what `write` writes takes the place of the file once it is
// complete. Devices, and standard output, are written at once. The stream writes numbers with all their digits. Throws
// `std::runtime_error` if the file can not be written.
void write_file(const std::string& filename, const std::function<void(std::ostream&)>& write);

// Of an output: names of files do not start with -, and what follows is the extension, "-.json".
inline bool is_standard_output(const std::string& filename)
{
  return filename.compare(0, 1, "-") == 0;
}

// why the file can not be written, or nothing if it can
std::string cause_not_writable(const std::string& filename);

bool is_device(const std::string& filename);

[[noreturn]] void throw_not_written(const std::string& filename);

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_OUTPUT_FILE_H
