// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef SURFACE_MESH_CUT_LOCUS_WEB_PATHS_H
#define SURFACE_MESH_CUT_LOCUS_WEB_PATHS_H

#include "../../Mesh.h"

#include <memory>
#include <vector>

// The shortest paths from points to the nearest of some sources.
class Paths
{
public:
  explicit Paths(const Mesh& mesh);
  ~Paths();

  struct Path
  {
    double length;
    std::vector<Kernel::Point_3> points; // from the end to the source
  };

  // Those to a point, of which there are several on the cut locus. On the curve that is drawn, which is off it by a
  // little, lengths differ by a little as well: paths are taken for equal if they are so within the reach of `radius`.
  // The shortest one comes first. None if no path leads to the point.
  std::vector<Path> find(const std::vector<Location>& sources, const Location& end, double radius);

private:
  struct Geodesics;
  const Mesh& mesh_;
  std::unique_ptr<Geodesics> geodesics_;
};

#endif // SURFACE_MESH_CUT_LOCUS_WEB_PATHS_H
