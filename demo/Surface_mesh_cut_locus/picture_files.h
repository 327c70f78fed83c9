// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_DEMO_PICTURE_FILES_H
#define SURFACE_MESH_CUT_LOCUS_DEMO_PICTURE_FILES_H

#include "Renderer.h"

#include <iosfwd>
#include <vector>

namespace picture {

// Both draw the views side by side, and throw `std::runtime_error` if the file can not be written.
void write_png(std::ostream& os, const std::vector<Rendered_view>& views);
// The surface is an embedded image, all that is drawn on it vector graphics.
void write_svg(std::ostream& os, const std::vector<Rendered_view>& views);

} // namespace picture

#endif // SURFACE_MESH_CUT_LOCUS_DEMO_PICTURE_FILES_H
