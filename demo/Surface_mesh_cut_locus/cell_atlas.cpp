// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

// The cells of several sources, each cut open to a disk and flattened, side by side.

#include "atlas.h"
#include "cells.h"
#include "charts.h"
#include "flatten.h"

#include <CGAL/Cut_loci/flatten_disk.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace {

using CGAL::Cut_loci::Index;
using CGAL::Cut_loci::Layout_quality;
using Charts = std::vector<std::unique_ptr<Chart>>;

// Of all charts, as they are in the atlas, one after the other; they do not touch each other.
Layout_quality quality_of_charts(Charts& charts, const Atlas& atlas)
{
  Layout_quality result;
  result.is_injective = true;
  double area = 0.;
  for(const auto& chart : charts)
    area += chart->area;
  std::size_t first = 0;
  for(const auto& chart : charts)
  {
    for(const Mesh::Vertex_index v : chart->disk.vertices())
    {
      const UV& p = atlas.texture_coordinates[first + std::size_t(v)];
      chart->uv[v] = Kernel::Point_2(p[0], p[1]);
    }
    first += chart->disk.number_of_vertices();
    add_part(CGAL::Cut_loci::layout_quality(chart->disk, chart->uv), chart->area / area, result);
  }
  return result;
}

} // namespace

Atlas make_atlas_of_cells(const Mesh& mesh, const Cut_locus& cut_locus, const std::string& parameterization)
{
  if(parameterization == "logmap")
    throw std::runtime_error(
      "the logarithmic map is that of one point: give one source, or another --parameterization");
  const Cells cells = make_cells(mesh, cut_locus);
  Charts charts = charts_of(cells);
  for(const auto& chart : charts)
  {
    flatten(chart->disk, chart->uv, parameterization);
    place(*chart);
  }
  const std::vector<UV> corners = corners_of(charts);

  Atlas atlas;
  atlas.parameterization = parameterization;
  for(const auto& p : cells.mesh.points)
    atlas.points.emplace_back(p[0], p[1], p[2]);
  const auto face = [&](Index f)
  {
    const auto& t = cells.mesh.triangles[f];
    return std::array<std::size_t, 3>{{t[0], t[1], t[2]}};
  };
  for(std::size_t i = 0; i < charts.size(); ++i)
  {
    const Chart& chart = *charts[i];
    const std::size_t first = atlas.texture_coordinates.size();
    for(const Mesh::Vertex_index v : chart.disk.vertices())
      atlas.texture_coordinates.push_back({{corners[i][0] + chart.uv[v].x(), corners[i][1] + chart.uv[v].y()}});
    for(const Mesh::Face_index f : chart.disk.faces())
    {
      const Mesh::Halfedge_index h = chart.disk.halfedge(f);
      atlas.faces.push_back(face(chart.faces[f]));
      atlas.texture_corners.push_back(
        {{first + chart.disk.source(h), first + chart.disk.target(h), first + chart.disk.target(chart.disk.next(h))}});
    }
  }
  for(Index f = 0; f < cells.mesh.number_of_faces(); ++f) // other components
    if(cells.source[f] == CGAL::Cut_loci::no_source)
      atlas.faces.push_back(face(f));
  finish_atlas(cut_locus, false, atlas);
  atlas.quality = quality_of_charts(charts, atlas);
  return atlas;
}
