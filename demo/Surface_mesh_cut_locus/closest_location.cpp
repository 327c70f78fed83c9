// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "Mesh.h"

#include <CGAL/Polygon_mesh_processing/locate.h>

Location closest_location(const Mesh& mesh, const Kernel::Point_3& p)
{
  return CGAL::Polygon_mesh_processing::locate(p, mesh);
}
